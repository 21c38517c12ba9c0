"""Call a learner's answer inside the sandbox and send its results; the only tflab module in that process.

    prepare(givens)                                        task("E3.2") returns the pack's inputs; check is silent
    probe_answer("7f3a", lambda: answer, "null")           one message {"id": "7f3a", "v": [the answer as plain JSON]}
    probe_answer("7f3b", lambda: f, "[[args], [args]]")    the same for f's result for copies of each case's arguments

Whoever owns this process can change every line of it.  That is why no expected
value ever comes here: forging a message, a learner can say only what they could
have answered.
"""

from __future__ import annotations

import json
from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

__all__ = ["PROBE_TYPE", "prepare", "probe_answer"]

PROBE_TYPE = "application/vnd.tflab.probe+json"


def prepare(givens_json: str) -> None:
    """Let `task(...)` return what this learner is given, and let `call`, `check`, `hint` and `solution` do nothing."""
    from tflab import workbook
    from tflab.workbook.answers.values import from_plain

    givens = json.loads(givens_json)

    def task(task_id: str) -> SimpleNamespace:
        given = givens.get(task_id) or {}
        return SimpleNamespace(**{name: from_plain(value) for name, value in given.items()})

    workbook.task = task
    workbook.call = workbook.check = workbook.hint = workbook.solution = _nothing


def probe_answer(identity: str, answer: Callable[[], Any], args_json: str) -> None:
    """Send one outcome for each case, as plain JSON; what a function raises is an outcome, too."""
    from tflab.workbook.answers.values import outcome_of

    cases = json.loads(args_json)
    if cases is None:
        outcomes = [outcome_of(answer, ())]
    else:
        outcomes = [outcome_of(lambda *given: answer()(*given), args) for args in cases]
    _send(identity, outcomes)


def _send(identity: str, plain: Any) -> None:
    from IPython.display import display

    display({PROBE_TYPE: {"id": identity, "v": plain}}, raw=True)


def _nothing(*_: object, **__: object) -> None:
    """Do nothing: whether an answer is right is not decided here."""
