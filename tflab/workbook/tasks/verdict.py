"""What became of an answer?  Coarse to fine: answered at all, type, shape, frame, unit, value; and which mistake.

    what came out of each case  +  what was expected, and what each twin gives  -->  Verdict

    Verdict(passed=0, of=6, mistake=Mistake.SLIP, twin="swapped")       "that is the inverse"
    Verdict(passed=0, of=6, mistake=Mistake.UNIT, detail={"unit": "mm"})
    Verdict(passed=6, of=6)

Only JSON is compared, so this serves a learner's `check` and the grader alike.
Read `mistake.py` next.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

from ..answers import forms, sealed
from ..answers.form import inside, member, numbers_of
from ..answers.forms import Angle, Choice, Form, Message, Number, Parts, Vector
from ..answers.values import Plain, is_raised, is_unanswered
from . import evidence
from .case import Case, TaskCases, Variant
from .mistake import Mistake

__all__ = ["Verdict", "judge_outcomes", "kind_of"]

# What one unit is in others: an answer that fits after dividing by the factor is in that unit.
OTHER_UNITS = {
    "m": {"mm": 1e3, "cm": 1e2},
    "mm": {"m": 1e-3, "cm": 0.1},
    "rad": {"degrees": math.degrees(1.0)},
    "s": {"ns": 1e9, "ms": 1e3},
    "ms": {"s": 1e-3, "ns": 1e6},
    "ns": {"s": 1e-9, "ms": 1e-6},
    "m/s": {"mm/s": 1e3},
}

# A function that stops with one of these has some bug or other: nobody can say that it is this mistake.
ANY_BUG = {"AttributeError", "IndexError", "KeyError", "NameError", "NotImplementedError", "TypeError", "ValueError"}


@dataclass(frozen=True)
class Verdict:
    """What became of an answer.

    Attributes:
        passed: probes that earn credit; of a function's, those that show something (see evidence.py).
        of: how many there are.
        mistake: what is wrong with it; None if all of it is right.
        twin: the mistake's name, if it is one of the task's.
        case: the first case that failed, from 0.
        right: for each probe, in the order of the cases, whether it earns credit.
        detail: what a reply fills in.
    """

    passed: int
    of: int
    mistake: Mistake | None = None
    twin: str = ""
    case: int = 0
    right: tuple[bool, ...] = ()
    detail: dict[str, Any] = field(default_factory=dict)


def judge_outcomes(task: TaskCases, variant: Variant, outcomes: Sequence[Plain]) -> Verdict:
    """Return what became of an answer.

    Args:
        task: one task of the cases (see case.py).
        variant: the learner's.
        outcomes: for each case what came out, as `to_plain` writes it; of a value task, the one value.
    """
    form, cases = task.form, variant.cases
    rights = [sealed.judge(form, outcome, case.expected) for case, outcome in zip(cases, outcomes, strict=True)]
    counted = evidence.credited(form, cases, outcomes, rights) if task.is_function else rights
    right = tuple(one for row in counted for one in row)
    passed, of = sum(right), len(right)
    if passed == of:
        return Verdict(passed, of, right=right)
    case = next(number for number, row in enumerate(rights) if not all(row))
    try:
        mistake, twin, detail = _mistake(task, cases, outcomes, rights, case)
    except Exception:  # JSON that `to_plain` never wrote: wrong, and there is nothing to say of it
        mistake, twin, detail = Mistake.VALUE, "", {}
    return Verdict(passed, of, mistake, twin, case, right, detail)


def kind_of(plain: Plain) -> str:
    """Return what a value is, as Python would name it: "tuple of 2", "Transform", "str"."""
    if isinstance(plain, dict):
        kind, body = next(iter(plain.items()), ("dict", None))
        if kind == "message" and isinstance(body, list) and body:
            return str(body[0]).rpartition("/")[2]
        if kind == "object":
            return str(body)
        if kind == "raises":
            return f"{body} (raised)"
        if kind == "float":
            return f"float {body}"
        if kind == "tuple":
            return f"tuple of {len(body)}"
        if kind == "array":
            return f"array, shape {_shape(body)}"
        return kind
    if isinstance(plain, list):
        return f"list of {len(plain)}"
    return "None" if plain is None else type(plain).__name__


def _mistake(
    task: TaskCases,
    cases: Sequence[Case],
    outcomes: Sequence[Plain],
    rights: Sequence[list[bool]],
    case: int,
) -> tuple[Mistake, str, dict[str, Any]]:
    """Return what is wrong, the twin's name and the details, coarse to fine."""
    form, outcome, expected = task.form, outcomes[case], cases[case].expected
    if all(map(is_unanswered, outcomes)):
        return Mistake.UNANSWERED, "", {}
    twin = _twin(task, cases, outcomes, rights)
    if twin:
        return Mistake.SLIP, twin, _slipped_parts(task, rights[case])
    if (ending := _ending(task, outcomes, outcome, expected)) is not None:
        return ending[0], "", ending[1]
    coarse = _coarse(form, outcome)
    if coarse is not None:
        return coarse[0], "", {"got": kind_of(outcome), **coarse[1]}
    unit = _other_unit(form, [(out, here.expected) for out, here in zip(outcomes, cases, strict=True)])
    if unit is not None:
        return Mistake.UNIT, "", unit
    if task.is_function and (habit := evidence.habit(form, cases, outcomes)):
        return Mistake(habit), "", {}
    if isinstance(form, Parts | Message):
        return Mistake.PARTS, "", {"wrong": _wrong_names(form, rights[case])}
    return Mistake.VALUE, "", {}


def _ending(
    task: TaskCases, outcomes: Sequence[Plain], outcome: Plain, expected: Plain
) -> tuple[Mistake, dict[str, Any]] | None:
    """Return what is wrong with how a call ended: it raised, or gave nothing, or did not refuse; None if nothing."""
    if is_raised(outcome):
        meant = is_raised(expected) and outcome["raises"] not in ANY_BUG - {"ValueError"}
        detail = {"error": outcome["raises"], "text": outcome.get("text", "")}
        return Mistake.OTHER_EXCEPTION if meant else Mistake.RAISES, detail
    if task.is_function and outcome is None:
        always = all(other is None for other in outcomes)
        return Mistake.NOTHING_RETURNED if always else Mistake.SOMETIMES_NOTHING, {}
    return (Mistake.NO_REFUSAL, {}) if is_raised(expected) else None


def _slipped_parts(task: TaskCases, rights: list[bool]) -> dict[str, Any]:
    """Return which of several answers a mistake was made in, where it was not made in all of them."""
    if task.is_function or not isinstance(task.form, Parts) or not any(rights):
        return {}
    return {"wrong": _wrong_names(task.form, rights)}


def _wrong_names(form: Parts | Message, rights: list[bool]) -> list[str]:
    names = list(form.parts) if isinstance(form, Parts) else list(form.fields)
    return [name for name, good in zip(names, rights, strict=False) if not good]


def _coarse(form: Form, outcome: Plain) -> tuple[Mistake, dict[str, Any]] | None:
    """Return what is wrong with the answer before its value is looked at, or None."""
    if isinstance(form, Parts):
        return _coarse_of_parts(form, outcome)
    if isinstance(form, forms.Sequence) and isinstance(inside(outcome), list):
        return next(filter(None, (_coarse(form.of, one) for one in inside(outcome))), None)
    if form.read(outcome) is not None:
        return None
    return _unread(form, outcome)


def _unread(form: Form, outcome: Plain) -> tuple[Mistake, dict[str, Any]]:
    """Return why an answer is not of its form."""
    if isinstance(form, Choice) and isinstance(outcome, str):
        return Mistake.OPTION, {"answer": outcome}
    frame = member(outcome, "header", "frame_id")
    if isinstance(form, Vector) and form.frame and frame is not None and frame != form.frame:
        return Mistake.FRAME, {"frame": frame, "wanted_frame": form.frame}
    if outcome == {"object": "function"}:
        return Mistake.A_FUNCTION, {}
    body = inside(outcome)
    if isinstance(body, list | dict) and not isinstance(form, Number | Angle | Choice) and _holds_numbers(body):
        return Mistake.SHAPE, {}
    return Mistake.TYPE, {}


def _coarse_of_parts(form: Parts, outcome: Plain) -> tuple[Mistake, dict[str, Any]] | None:
    answers = inside(outcome)
    if not (isinstance(outcome, dict) and "dict" in outcome and isinstance(answers, dict)):
        return Mistake.TYPE, {}
    missing = [name for name in form.parts if name not in answers or is_unanswered(answers[name])]
    if missing:
        return Mistake.MISSING_PARTS, {"parts": missing}
    for name, part in form.parts.items():
        fault = _coarse(part, answers[name])
        if fault is not None:
            return fault[0], {**fault[1], "part": name, "got": kind_of(answers[name])}
    return None


def _twin(task: TaskCases, cases: Sequence[Case], outcomes: Sequence[Plain], rights: Sequence[list[bool]]) -> str:
    """Return the twin that was wrong in the same way wherever the answer is wrong, or "".

    A function has to be the twin in every case; a dict of parts only in those
    parts that are wrong, for one may slip in one of four sentences.
    """
    form = task.form
    best, most = "", 0
    for name in task.twins:
        rows = [_judge_twin(form, outcome, case.twins[name]) for case, outcome in zip(cases, outcomes, strict=True)]
        wrong_alike = all(_is_wrong_alike(row, right) for row, right in zip(rows, rights, strict=True))
        alike = sum(map(sum, rows))
        whole = alike == sum(map(len, rows))
        if wrong_alike and (whole or isinstance(form, Parts)) and alike > most:
            best, most = name, alike
    return best


def _is_wrong_alike(row: list[bool], right: list[bool]) -> bool:
    """Return whether the twin explains all that is wrong in one case; where one of the two raises, as a whole."""
    if len(row) != len(right):
        return all(row) or all(right)
    return all(twin for twin, good in zip(row, right, strict=True) if not good)


def _judge_twin(form: Form, outcome: Plain, twin: Plain) -> list[bool]:
    if isinstance(outcome, dict) and outcome.get("raises") in ANY_BUG:
        return [False]
    try:
        return sealed.judge(form, outcome, twin)
    except ValueError:  # a twin need not be of the form at all
        return [outcome == twin]


def _other_unit(form: Form, pairs: Sequence[tuple[Plain, Plain]]) -> dict[str, Any] | None:
    """Return the unit in which every answer would be right, or None; of parts, the first that is right so."""
    if isinstance(form, Parts):
        return _other_unit_of_part(form, pairs)
    for unit, factor in OTHER_UNITS.get(_unit(form), {}).items():
        if all(_fits_in_unit(form, outcome, expected, factor) for outcome, expected in pairs):
            return {"unit": unit, "wanted_unit": _unit(form)}
    return None


def _other_unit_of_part(form: Parts, pairs: Sequence[tuple[Plain, Plain]]) -> dict[str, Any] | None:
    for number, (name, part) in enumerate(form.parts.items()):
        inner = [(inside(outcome).get(name), sealed.part_of(expected, number, name)) for outcome, expected in pairs]
        if all(all(sealed.judge(part, answer, expected)) for answer, expected in inner):
            continue
        found = _other_unit(part, inner)
        if found is not None:
            return {**found, "part": name}
    return None


def _fits_in_unit(form: Form, outcome: Plain, expected: Plain, factor: float) -> bool:
    if is_raised(expected):
        return False
    size = form.size if isinstance(form, Vector) else None
    row = numbers_of(outcome, size)
    if row is None:
        return False
    scaled = [number / factor for number in row]
    return all(sealed.judge(form, scaled if size else scaled[0], expected))


def _unit(form: Form) -> str:
    if isinstance(form, Angle):
        return "rad"
    return form.unit if isinstance(form, Number | Vector) else ""


def _holds_numbers(body: Plain) -> bool:
    members = body.values() if isinstance(body, dict) else body
    flat = [inner for one in members for inner in (one if isinstance(one, list) else [one])]
    return bool(flat) and all(isinstance(one, int | float) and not isinstance(one, bool) for one in flat)


def _shape(rows: Plain) -> tuple[int, ...]:
    shape: list[int] = []
    while isinstance(rows, list):
        shape.append(len(rows))
        rows = rows[0] if rows else None
    return tuple(shape)
