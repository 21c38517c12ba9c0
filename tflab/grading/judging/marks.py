"""What are the outcomes worth?  Points for each probe, the mistake that the answer is, and what went wrong.

    outcomes of the cases   [440.2, 3.1, ...]     against   expected   -->   5 of 6 probes, 2.5 of 3 points
                                                  against   each twin  -->   "swapped"

What is right is decided where a learner's own `check` decides it, on plain JSON,
in a process that the learner's code has never been in; here it becomes points and
words.  Read `job.py` next.
"""

from __future__ import annotations

import builtins
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from tflab.workbook.answers.forms import Form
from tflab.workbook.answers.sealed import is_sealed, seal
from tflab.workbook.answers.values import is_raised
from tflab.workbook.tasks.case import Case, TaskCases
from tflab.workbook.tasks.mistake import WITHOUT_THE_ANSWER, Mistake
from tflab.workbook.tasks.verdict import Verdict, judge_outcomes

from ..submissions.remarks import Remark

__all__ = ["MISSING", "TaskMark", "judged", "safe_error_name"]

MISSING = {"object": "nothing"}  # an outcome that never came, or that nobody can read; it is of no form
KNOWN_ERRORS = {name for name, value in vars(builtins).items() if isinstance(value, type)} | {
    "LookupException", "ConnectivityException", "ExtrapolationException", "InvalidArgumentException",
    "TimeoutException", "TransformException", "TypeException", "LinAlgError", "RCLError",
}  # fmt: skip
UNREADABLE = (ValueError, TypeError, KeyError, IndexError, AttributeError, OverflowError, RecursionError)
DIGITS = 3  # of points


@dataclass(frozen=True)
class TaskMark:
    """What one task got.

    Attributes:
        status: "right", "partly", "wrong", "unanswered" or "trouble".
        passed: probes that are right, of `of`.
        twin: the name of the mistake that the answer is, or "".
    """

    task: str
    status: str
    passed: int
    of: int
    points: float
    most: float
    twin: str = ""
    remarks: tuple[Remark, ...] = ()

    def plain(self) -> dict[str, Any]:
        """Return the mark as JSON has it."""
        row = {"status": self.status, "passed": self.passed, "of": self.of, "points": self.points, "most": self.most}
        return row | {"twin": self.twin, "remarks": [remark.plain() for remark in self.remarks]}


def judged(
    task_id: str, task: Mapping[str, Any], outcomes: Mapping[int, Any], trouble: Sequence[Remark] = ()
) -> TaskMark:
    """Return the mark of a task.

    Args:
        task: with its "form", "points", "twins" and "cases".
        outcomes: by case; a function's first case comes once more under the number of cases.
        trouble: what the run had to say about this task.
    """
    held = TaskCases.of_a_learner(dict(task))
    form, cases = held.form, held.variants[0].cases
    got = [_readable(form, outcomes.get(number, MISSING)) for number in range(len(cases))]
    once_more = outcomes.get(len(cases))
    remarks = list(trouble)
    if held.is_function and once_more is not None and _is_unsteady(form, cases[0], got[0], once_more):
        got[0] = MISSING
        remarks.append(Remark(Mistake.UNSTEADY.value, task_id))
    found = _judge(held, got)
    points = round(held.points * found.passed / found.of, DIGITS) if found.of else 0.0
    if found.mistake is Mistake.UNANSWERED and not trouble:
        status = "unanswered"
    elif found.mistake is None:
        status, remarks = "right", []
    else:
        status = "partly" if found.passed else "trouble" if trouble else "wrong"
    if not remarks and status != "right" and not found.twin:
        remarks += _what_went_wrong(task_id, held, got, found)
    return TaskMark(task_id, status, found.passed, found.of, points, float(held.points), found.twin, tuple(remarks))


def safe_error_name(name: Any) -> str | Remark:
    """Return an exception's name if it is one that Python or tf2 has: a name of one's own could carry anything."""
    if name == "_IncompleteInputError":  # what Python 3.13 calls a SyntaxError at the end of the text
        return "SyntaxError"
    return name if isinstance(name, str) and name in KNOWN_ERRORS else Remark("own error")


def _judge(task: TaskCases, got: list[Any]) -> Verdict:
    """Judge as a learner's copy does, whose values are sealed: what `check` accepts at the edge of its tolerance."""
    (variant,) = task.variants
    found = judge_outcomes(task, variant, got)
    if found.mistake is None or task.is_function or any(is_sealed(case.expected) for case in variant.cases):
        return found
    sealed = tuple(case._replace(expected=seal(task.form, case.expected, "grading")) for case in variant.cases)
    rounded = judge_outcomes(task, variant._replace(cases=sealed), got)
    return rounded if rounded.passed > found.passed else found


def _readable(form: Form, answer: Any) -> Any:
    """Return an outcome, or MISSING where it is no JSON of ours: a forged message may hold anything."""
    try:
        form.probes(answer)
    except UNREADABLE:
        return MISSING
    kind = next(iter(answer), None) if isinstance(answer, dict) else ""
    if not isinstance(kind, str) or (kind == "raises" and not isinstance(answer["raises"], str)):
        return MISSING
    return answer


def _is_unsteady(form: Form, case: Case, first: Any, once_more: Any) -> bool:
    """Return whether a function was right at first, and is not when it is asked the same again."""
    if not all(form.judge(first, case.expected)):
        return False
    return not all(form.judge(_readable(form, once_more), case.expected))


def _what_went_wrong(task_id: str, task: TaskCases, got: list[Any], found: Verdict) -> list[Remark]:
    """Return what can be said without repeating anything that the learner's code made."""
    if all(answer is MISSING for answer in got):
        return [Remark("no result", task_id)]
    if found.mistake is Mistake.RAISES and not task.is_function:  # the cell itself stopped
        return [Remark("raised", task_id, error=safe_error_name(found.detail["error"]))]
    wanted = task.form.wanted()
    names = {name: ", ".join(held) if isinstance(held, list) else held for name, held in found.detail.items()}
    names |= {
        "wanted": wanted.en,
        "wanted_ko": wanted.ko,
        "error": safe_error_name(found.detail.get("error")),
        "of_cases": f"{sum(map(is_raised, got))}/{len(got)}",
    }
    said = WITHOUT_THE_ANSWER[found.mistake]
    asked = {name: held for name, held in names.items() if f"{{{name}}}" in said.en + said.ko}
    return [Remark(found.mistake.value, task_id, **asked)]
