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

from tflab.workbook.answers.forms import Form, form_from_plain
from tflab.workbook.answers.sealed import is_sealed, seal
from tflab.workbook.answers.values import is_raised
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
    form, cases = form_from_plain(task["form"]), task["cases"]
    got = [_readable(form, outcomes.get(number, MISSING)) for number in range(len(cases))]
    once_more = outcomes.get(len(cases))
    remarks = list(trouble)
    if task["is_function"] and once_more is not None and _is_unsteady(form, cases[0], got[0], once_more):
        got[0] = MISSING
        remarks.append(Remark("unstable", task_id))
    found = _judge(form, task, got)
    points = round(task["points"] * found.passed / found.of, DIGITS) if found.of else 0.0
    if found.kind == "unanswered" and not trouble:
        status = "unanswered"
    elif found.kind == "passed":
        status, remarks = "right", []
    else:
        status = "partly" if found.passed else "trouble" if trouble else "wrong"
    if not remarks and status != "right" and not found.twin:
        remarks += _what_went_wrong(task_id, task, form, got, found)
    return TaskMark(task_id, status, found.passed, found.of, points, float(task["points"]), found.twin, tuple(remarks))


def safe_error_name(name: Any) -> str | Remark:
    """Return an exception's name if it is one that Python or tf2 has: a name of one's own could carry anything."""
    if name == "_IncompleteInputError":  # what Python 3.13 calls a SyntaxError at the end of the text
        return "SyntaxError"
    return name if isinstance(name, str) and name in KNOWN_ERRORS else Remark("own error")


def _judge(form: Form, task: Mapping[str, Any], got: list[Any]) -> Verdict:
    """Judge as a learner's copy does, whose values are sealed: what `check` accepts at the rim is accepted here."""
    found = judge_outcomes(dict(task), {"cases": task["cases"]}, got)
    if found.kind == "passed" or task["is_function"] or any(is_sealed(case["expected"]) for case in task["cases"]):
        return found
    sealed = [case | {"expected": seal(form, case["expected"], "grading")} for case in task["cases"]]
    rounded = judge_outcomes(dict(task), {"cases": sealed}, got)
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


def _is_unsteady(form: Form, case: Mapping[str, Any], first: Any, once_more: Any) -> bool:
    """Return whether a function was right at first, and is not when it is asked the same again."""
    if not all(form.judge(first, case["expected"])):
        return False
    return not all(form.judge(_readable(form, once_more), case["expected"]))


def _what_went_wrong(task_id: str, task: Mapping[str, Any], form: Form, got: list[Any], found: Verdict) -> list[Remark]:
    """Return what can be said without repeating anything that the learner's code made."""
    wanted = {"wanted": form.wanted().en, "wanted_ko": form.wanted().ko}
    if found.kind == "unanswered":
        return [Remark("unanswered", task_id)]
    if all(answer is MISSING for answer in got):
        return [Remark("no result", task_id)]
    if found.kind == "raised":
        errors = [answer for answer in got if is_raised(answer)]
        name = safe_error_name(found.detail.get("error"))
        return [
            Remark(
                "raises" if task["is_function"] else "raised", task_id, error=name, of_cases=f"{len(errors)}/{len(got)}"
            )
        ]
    if found.kind in ("type", "shape", "option"):
        return [Remark("unfit", task_id, **wanted)]
    if found.kind == "unit":
        return [Remark("unit", task_id, unit=found.detail["unit"], wanted=found.detail["wanted_unit"])]
    if found.kind == "frame":
        return [Remark("frame", task_id, wanted=found.detail["wanted_frame"])]
    if found.kind == "parts":
        return [Remark("parts", task_id, parts=", ".join(found.detail["wrong"]))]
    if found.kind in ("constant", "echo"):
        return [Remark(found.kind, task_id)]
    if found.kind == "missing":
        return [Remark("missing parts", task_id, parts=", ".join(found.detail["parts"]))]
    return []
