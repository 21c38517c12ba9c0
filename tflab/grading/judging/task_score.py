"""Turn the outcomes of a task into points, the name of the mistake, and what went wrong.

    outcomes of the cases   [440.2, 3.1, ...]     against   expected   -->   5 of 6 probes, 2.5 of 3 points
                                                  against   mistakes   -->   "swapped"

What is right is decided where a learner's own `check` decides it, on plain JSON,
in a process that the learner's code has never been in; here it becomes points and
words.
"""

from __future__ import annotations

import builtins
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from tflab.text import Text
from tflab.workbook.answers.forms import Form
from tflab.workbook.answers.values import is_raised
from tflab.workbook.diagnosis.failure import WITHOUT_THE_ANSWER, Failure
from tflab.workbook.diagnosis.verdict import Verdict, judge_outcomes
from tflab.workbook.inventory.replies import chosen
from tflab.workbook.tasks.case_types import Feedback, TaskCases
from tflab.workbook.tasks.catalog import pair_search
from tflab.workbook.tasks.credit import beyond_guessing, beyond_the_usual

from ..submissions.remarks import Remark
from .draw import asks_of

__all__ = ["MISSING", "TaskScore", "by_case", "limit_size", "members", "most_members", "safe_error_name", "score_task"]

MISSING = {"object": "nothing"}  # an outcome that never came, or that nobody can read; it is of no form
TOO_LARGE = {"object": "something very large"}
MOST_MEMBERS, MORE_THAN_WANTED = 2_000, 10  # of an answer: more is not what was asked for, and takes long to judge
OF_TF2 = {
    "LookupException", "ConnectivityException", "ExtrapolationException", "InvalidArgumentException",
    "TimeoutException", "TransformException",
}  # fmt: skip
KNOWN_ERRORS = {
    *(name for name, value in vars(builtins).items() if isinstance(value, type)),
    *OF_TF2, "TypeException", "LinAlgError", "RCLError",
}  # fmt: skip
UNREADABLE = (ValueError, TypeError, KeyError, IndexError, AttributeError, OverflowError, RecursionError)
DIGITS = 3  # of points


@dataclass(frozen=True)
class TaskScore:
    """What one task got.

    Attributes:
        status: "right", "partly", "wrong", "unanswered" or "trouble".
        passed: probes that are right, of `of`.
        mistakes: the mistakes that the answer comes of, by name, and what is said of each.
        said: all of it together.
        answers: where taking part counts, the option of each part if all have one.
    """

    task: str
    status: str
    passed: int
    of: int
    points: float
    most: float
    mistakes: dict[str, Feedback] = field(default_factory=dict)
    said: Text | None = None
    remarks: tuple[Remark, ...] = ()
    answers: Mapping[str, str] = field(default_factory=dict)

    def plain(self) -> dict[str, Any]:
        """Return the score as JSON has it."""
        row = {"status": self.status, "passed": self.passed, "of": self.of, "points": self.points, "most": self.most}
        row |= {"answers": dict(self.answers)} if self.answers else {}
        return row | {
            "mistakes": {name: words.plain() for name, words in self.mistakes.items()},
            "said": self.said.plain() if self.said else None,
            "remarks": [remark.plain() for remark in self.remarks],
        }


def score_task(
    task_id: str, task: Mapping[str, Any], outcomes: Mapping[int, Any], trouble: Sequence[Remark] = ()
) -> TaskScore:
    """Return the score of a task.

    Args:
        task: with its "form", "points", "feedback" and "cases", and the order in which these were asked.
        outcomes: by their places in the order of asking.
        trouble: what the run had to say about this task.
    """
    held = TaskCases.of_a_learner(dict(task))._replace(pairs=pair_search(task_id))
    got, is_steady = by_case(held, asks_of(task), outcomes)
    remarks = [*trouble, *([] if is_steady else [Remark(Failure.UNSTEADY.value, task_id)])]
    found = judge_outcomes(held, held.variants[0], got)
    points = round(held.points * _share(held, task, found), DIGITS)
    if found.failure is Failure.UNANSWERED and not trouble:
        status = "unanswered"
    elif found.failure is None:
        status, remarks = "right", []
    else:
        status = "partly" if found.passed else "trouble" if trouble else "wrong"
    if not remarks and status != "right" and not found.mistakes:
        remarks += _what_went_wrong(task_id, held, got, found)
    answers = chosen(held.form, got[0]) if held.counts else {}
    return TaskScore(
        task_id, status, found.passed, found.of, points, float(held.points), found.mistakes, found.said, tuple(remarks),
        answers,
    )  # fmt: skip


def _share(held: TaskCases, task: Mapping[str, Any], found: Verdict) -> float:
    """Return which share of the points is earned, beyond what guessing gives."""
    if not found.passed:
        return 0.0
    if held.is_function:
        cases = held.variants[0].cases
        return beyond_guessing(held.form, cases, found.passed, task.get("known") or [False] * len(cases))
    usual = () if held.counts else task.get("usual", ())
    return sum(beyond_the_usual(found.right, usual, found.follows)) / found.of


def safe_error_name(name: Any) -> str | Remark:
    """Return an exception's name if it is one that Python or tf2 has: a name of one's own could carry anything."""
    if name == "_IncompleteInputError":  # what Python 3.13 calls a SyntaxError at the end of the text
        return "SyntaxError"
    return name if isinstance(name, str) and name in KNOWN_ERRORS else Remark("own error")


def by_case(task: TaskCases, asks: Sequence[int], outcomes: Mapping[int, Any]) -> tuple[list[Any], bool]:
    """Return an outcome for each case, and whether what was asked again was answered as before.

    A case whose answers differ, one right and one wrong, has none.
    """
    cases = task.variants[0].cases
    most = most_members([case.expected for case in cases])
    heard: list[list[Any]] = [[] for _ in cases]
    for place, case in enumerate(asks):
        if place in outcomes:
            heard[case].append(_readable(task.form, outcomes[place], most))
    got = [answers[0] if answers else MISSING for answers in heard]
    unsteady = [
        number
        for number, (case, answers) in enumerate(zip(cases, heard, strict=True))
        if len(answers) > 1 and len({tuple(task.form.judge(answer, case.expected)) for answer in answers}) > 1
    ]
    for number in unsteady:
        got[number] = MISSING
    return got, not unsteady


def _readable(form: Form, answer: Any, most: int) -> Any:
    """Return an outcome, or MISSING where it is no JSON of ours: a forged message may hold anything, of any size."""
    answer = limit_size(answer, most)
    try:
        form.probes(answer)
    except UNREADABLE:
        return MISSING
    kind = next(iter(answer), None) if isinstance(answer, dict) else ""
    if not isinstance(kind, str) or (kind == "raises" and not isinstance(answer["raises"], str)):
        return MISSING
    return answer


def most_members(expected: Iterable[Any]) -> int:
    """Return of how many values an answer may be made, by those that are expected."""
    return MOST_MEMBERS + MORE_THAN_WANTED * max(members(value, MOST_MEMBERS) for value in expected)


def limit_size(answer: Any, most: int) -> Any:
    """Return an answer, or what says that it is too large to be looked at."""
    return TOO_LARGE if members(answer, most) >= most else answer


def members(plain: Any, most: int) -> int:
    """Return how many values a JSON value is made of, and how many times 100 letters; it stops counting at `most`."""
    count, todo = 0, [plain]
    while todo and count < most:
        value = todo.pop()
        count += 1 + (len(value) // 100 if isinstance(value, str) else 0)
        if isinstance(value, dict):
            count += sum(len(str(key)) // 100 for key in value) + len(value)
            todo.extend(value.values())
        elif isinstance(value, list):
            count += len(value)
            todo.extend(value[:most])
    return count


def _what_went_wrong(task_id: str, task: TaskCases, got: list[Any], found: Verdict) -> list[Remark]:
    """Return what can be said without repeating anything that the learner's code made."""
    if all(answer is MISSING for answer in got):
        return [Remark("no result", task_id)]
    if found.failure is Failure.RAISES and not task.is_function:  # the cell itself stopped
        return [Remark("raised", task_id, error=safe_error_name(found.detail["error"]))]
    wanted = task.form.wanted()
    names = {name: ", ".join(held) if isinstance(held, list) else held for name, held in found.detail.items()}
    tip = found.detail.get("tip", Text("", ""))
    names |= {
        "tip": f" {tip.en}" if tip.en else "",
        "tip_ko": f" {tip.ko}" if tip.ko else "",
        "wanted": wanted.en,
        "wanted_ko": wanted.ko,
        "error": _error_named(found.detail.get("error"), task, got),
        "of_cases": f"{sum(map(is_raised, got))}/{len(got)}",
    }
    said = WITHOUT_THE_ANSWER[found.failure]
    asked = {name: held for name, held in names.items() if f"{{{name}}}" in said.en + said.ko}
    return [Remark(found.failure.value, task_id, **asked)]


def _error_named(name: Any, task: TaskCases, got: Sequence[Any]) -> str | Remark:
    """Return an exception's name; of a function's that raises now and then, only if it is tf2's.

    Which of a hundred exceptions it chooses, seeing a hidden input, would tell of that (a covert channel).
    """
    is_always = all(is_raised(answer) and answer["raises"] == name for answer in got)
    return safe_error_name(name) if not task.is_function or is_always or name in OF_TF2 else Remark("some error")
