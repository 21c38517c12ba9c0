"""Judge an answer from coarse to fine: answered at all, type, shape, frame, unit, value; and which mistake.

    what came out of each case  +  what was expected, and what each mistake gives  -->  Verdict

    Verdict(passed=0, of=6, failure=Failure.KNOWN, mistakes={"swapped": ...})    "that is the inverse"
    Verdict(passed=0, of=6, failure=Failure.UNIT, detail={"unit": "mm"})
    Verdict(passed=6, of=6)

Only JSON is compared, so this serves a learner's `check` and the grader alike.
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

from ...text import Text, Texts
from ..answers import forms
from ..answers.form import inside, is_number, member
from ..answers.forms import Angle, Choice, Command, Form, Message, Number, Parts, Tree, Urdf, Vector
from ..answers.members import members_of
from ..answers.values import Plain, is_raised, is_unanswered
from ..tasks import credit
from ..tasks.case_types import Case, Feedback, TaskCases, Variant
from .explain import explain
from .explanation import Explanation
from .failure import Failure
from .matching import ANY_BUG
from .options import word_never_returned
from .python_errors import python_error_hint
from .question import Question
from .wrong_types import (
    describe_type,
    invalid_parts,
    near_an_option,
    option_of_another,
    raised_option,
    single_part_given,
)

__all__ = ["Verdict", "judge_outcomes", "kind_of"]

TEXTS = Texts(__file__)

A_FUNCTION = ({"object": "function"}, {"object": "method"})


@dataclass(frozen=True)
class Verdict:
    """What became of an answer.

    Attributes:
        passed: probes that earn credit; of a function's, those that show something (see credit.py).
        of: how many there are.
        failure: how it failed; None if all of it is right.
        mistakes: those that it comes of, the first in the work first, and what is said of each.
        case: the smallest case that failed, by the length of its arguments, first those with an answer; from 0.
        right: for each probe, in the order of the cases, whether it earns credit.
        follows: of a value's, whether it is counted as right only since it follows from the mistake; empty if none is.
        detail: what a reply fills in.
        said: what to say of the mistakes; None if it comes of none that is known.
    """

    passed: int
    of: int
    failure: Failure | None = None
    mistakes: dict[str, Feedback] = field(default_factory=dict)
    case: int = 0
    right: tuple[bool, ...] = ()
    detail: dict[str, Any] = field(default_factory=dict)
    said: Text | None = None
    follows: tuple[bool, ...] = ()


def judge_outcomes(task: TaskCases, variant: Variant, outcomes: Sequence[Plain]) -> Verdict:
    """Return what became of an answer.

    Args:
        task: one task of the cases (see case_types.py).
        variant: the learner's.
        outcomes: for each case what came out, as `to_plain` writes it; of a value task, the one value.
    """
    form, cases = task.form, variant.cases
    if task.counts:
        return _taking_part(form, outcomes[0])
    rights = [form.judge(outcome, case.expected) for case, outcome in zip(cases, outcomes, strict=True)]
    if task.is_function:
        counted = credit.credited(form, cases, outcomes, rights)
    else:
        beyond = credit.beyond_the_given(form, variant.given, cases[0].expected, rights[0])
        counted = [credit.beyond_one_word(form, outcomes[0], cases[0].expected, beyond)]
    right = tuple(probe for row in counted for probe in row)
    if all(right):
        return Verdict(len(right), len(right), right=right)
    wrong = [number for number, row in enumerate(rights) if not all(row)]
    sizes = {number: (is_raised(cases[number].expected), len(json.dumps(cases[number].args))) for number in wrong}
    case = min(wrong, key=sizes.__getitem__)  # the smallest call, one that has an answer if there is one
    try:
        failure, detail, found = _failure(task, variant, outcomes, rights, case)
    except Exception:  # JSON that `to_plain` never wrote: wrong, and there is nothing to say of it
        failure, detail, found = Failure.VALUE, {}, None
    if found is None:
        return Verdict(sum(right), len(right), failure, {}, case, right, {"certain": None} | detail)
    case = case if found.shows is None else found.shows
    follows = () if task.is_function else _following(form, found, right)
    right = tuple(map(max, right, follows)) if follows else right  # one mistake costs the part that it is made in
    return Verdict(sum(right), len(right), failure, found.mistakes, case, right, detail, found.said, follows)


def _following(form: Form, found: Explanation, right: Sequence[bool]) -> tuple[bool, ...]:
    """Return for each part of a value whether it is wrong only since it follows from a mistake; empty if none is."""
    if not found.follows or not isinstance(form, Parts):
        return ()
    return tuple(not was and name in found.follows for was, name in zip(right, form.parts, strict=True))


def _taking_part(form: Parts, outcome: Plain) -> Verdict:
    """Return how many parts were answered, each with one of its options; nothing is compared with anything."""
    right = tuple(map(bool, form.read(outcome) or [()] * len(form.parts)))
    if all(right):
        return Verdict(len(right), len(right), right=right)
    unanswered = is_unanswered(outcome)
    failure, detail = (Failure.UNANSWERED, {}) if unanswered else _coarse(form, outcome) or (Failure.TYPE, {})
    return Verdict(
        sum(right), len(right), failure, right=right, detail={"certain": None, "got": kind_of(outcome)} | detail
    )


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
        if kind in ("tuple", "set"):
            return f"{kind} of {len(body)}"
        if kind == "array":
            return f"array, shape {_shape(body)}"
        return kind
    if isinstance(plain, list):
        return f"list of {len(plain)}"
    return "None" if plain is None else type(plain).__name__


def _failure(
    task: TaskCases, variant: Variant, outcomes: Sequence[Plain], rights: Sequence[list[bool]], case: int
) -> tuple[Failure, dict[str, Any], Explanation | None]:
    """Return what is wrong, the details, and how it came about if that is known; coarse to fine."""
    cases = variant.cases
    form, outcome = task.form, outcomes[case]
    if all(map(is_unanswered, outcomes)):
        return Failure.UNANSWERED, {}, None
    missing = _missing(task, outcomes, outcome)
    if missing is not None:
        return missing[0], {"got": kind_of(outcome), **missing[1]}, None
    found = explain(Question(task, cases, outcomes, variant.given or {}))
    is_unit = found is not None and len(found.mistakes) == 1 and next(iter(found.mistakes)).startswith("unit ")
    if is_unit and not isinstance(form, Message | Command):
        return Failure.UNIT, _unit(form, next(iter(found.mistakes)), rights[case]), found
    if found is not None:
        return Failure.KNOWN, {}, found
    return *_unexplained(task, cases, outcomes, rights, case), None


def _missing(task: TaskCases, outcomes: Sequence[Plain], outcome: Plain) -> tuple[Failure, dict[str, Any]] | None:
    """Return what is wrong with the parts of an answer before they are looked at; of calls, that all lack the same."""
    if not isinstance(task.form, Parts):
        return None
    fault = _coarse(task.form, outcome)
    if fault is None or not task.is_function:
        return fault
    dicts = [other for other in outcomes if isinstance(other, dict) and "dict" in other]
    is_always = fault[0] is Failure.MISSING_PARTS and all(_coarse(task.form, other) == fault for other in dicts)
    return fault if is_always and len(dicts) > 1 else None


def _unexplained(
    task: TaskCases, cases: Sequence[Case], outcomes: Sequence[Plain], rights: Sequence[list[bool]], case: int
) -> tuple[Failure, dict[str, Any]]:
    """Return what can be said of an answer that no mistake gives."""
    form, outcome = task.form, outcomes[case]
    if (ending := _ending(task, outcomes, outcome, cases[case].expected)) is not None:
        return (ending[0], _describe_nothing(form, cases, outcomes, rights)) if outcome is None else ending
    coarse = _coarse(form, outcome)
    if coarse is not None:
        return coarse[0], {"got": kind_of(outcome), **coarse[1]}
    if task.is_function and (pattern := credit.trivial_pattern(form, cases, outcomes)):
        return Failure(pattern), {}
    bounds = _bounds(task, cases, outcomes, rights, case)
    if form.names():
        return Failure.PARTS, {"wrong": _wrong_names(form, rights[case]), "certain": bounds}
    return Failure.VALUE, {"certain": bounds}


def _bounds(
    task: TaskCases, cases: Sequence[Case], outcomes: Sequence[Plain], rights: Sequence[list[bool]], shown: int
) -> Text | None:
    """Return what is certain of the answer; of calls, of all that go wrong, or else of the one that is shown."""
    said = _difference(task.form, outcomes[shown], cases[shown].expected)
    wrong = [number for number, row in enumerate(rights) if not all(row)]
    others = {_difference(task.form, outcomes[number], cases[number].expected) for number in wrong}
    if said is None or others == {said}:
        return said
    return TEXTS["in_this_call"].filled(said=said)


def _difference(form: Form, outcome: Plain, expected: Plain) -> Text | None:
    return None if is_raised(outcome) or is_raised(expected) else form.describe_difference(outcome, expected)


def _describe_nothing(
    form: Form, cases: Sequence[Case], outcomes: Sequence[Plain], rights: Sequence[list[bool]]
) -> dict[str, Any]:
    """Return for which option a function gives nothing, if all other calls are right."""
    if not all(other is None or all(row) for other, row in zip(outcomes, rights, strict=True)):
        return {}
    if isinstance(form, Choice) and (said := word_never_returned(form, outcomes, [case.expected for case in cases])):
        return {"certain": said}
    return {}


def _unit(form: Form, name: str, rights: list[bool]) -> dict[str, Any]:
    """Return in which unit an answer is, and which is asked for; of parts, of the one that is wrong."""
    detail = {}
    if isinstance(form, Parts):
        detail["part"] = _wrong_names(form, rights)[0]
        form = form.parts[detail["part"]]
    return {"unit": name.removeprefix("unit "), "wanted_unit": form.unit, **detail}


def _ending(
    task: TaskCases, outcomes: Sequence[Plain], outcome: Plain, expected: Plain
) -> tuple[Failure, dict[str, Any]] | None:
    """Return what is wrong with how a call ended: it raised, or gave nothing, or did not refuse; None if nothing."""
    if isinstance(outcome, dict) and "changed" in outcome:
        return Failure.INPUT_CHANGED, {"changed": outcome["changed"]}
    if is_raised(outcome) and not task.is_function:  # the value cannot be written down
        return Failure.TYPE, {"got": f"{outcome['raises']}: {outcome.get('text', '')}"}
    if is_raised(outcome):
        return _raising(task.form, outcome["raises"], outcome.get("text", ""), expected)
    if task.is_function and outcome is None and not is_raised(expected):
        always = all(other is None or is_raised(other) for other in outcomes)
        return Failure.NOTHING_RETURNED if always else Failure.SOMETIMES_NOTHING, {}
    return (Failure.NO_REFUSAL, {}) if is_raised(expected) else None


def _raising(form: Form, error: str, text: str, expected: Plain) -> tuple[Failure, dict[str, Any]]:
    """Return what is wrong with an exception that was raised."""
    tip = raised_option(form, text) or python_error_hint(error, text)
    detail = {"error": error, "text": text.rstrip(". "), "tip": tip}
    if not is_raised(expected) or error in ANY_BUG - {"ValueError"}:
        return Failure.RAISES, detail
    return Failure.OTHER_EXCEPTION, detail | {"meant": expected["raises"]}


def _wrong_names(form: Form, rights: list[bool]) -> list[str]:
    return [name for name, good in zip(form.names(), rights, strict=False) if not good]


def _coarse(form: Form, outcome: Plain) -> tuple[Failure, dict[str, Any]] | None:
    """Return what is wrong with the answer before its value is looked at, or None."""
    if isinstance(form, Parts):
        return _coarse_of_parts(form, outcome)
    members = _members(form, outcome)
    if members is not None:
        faults = ((_coarse(form.of, answer), answer) for answer in members)
        return next((_holding(outcome, answer, fault) for fault, answer in faults if fault is not None), None)
    if form.read(outcome) is not None:
        return None
    return _unread(form, outcome)


def _holding(outcome: Plain, answer: Plain, fault: tuple[Failure, dict[str, Any]]) -> tuple[Failure, dict[str, Any]]:
    """Return what is wrong with a member as what is wrong with the whole: a list is right, and holds what is not."""
    held = fault[1].get("got", kind_of(answer))
    return fault[0], fault[1] | {"got": f"{kind_of(outcome)}, holding {held}"}


def _members(form: Form, outcome: Plain) -> list[Plain] | None:
    """Return the members of a list or a set, if such is asked for and given."""
    if isinstance(form, forms.Set):
        return members_of(outcome)
    held = inside(outcome)
    return held if isinstance(form, forms.Sequence) and isinstance(held, list) else None


def _unread(form: Form, outcome: Plain) -> tuple[Failure, dict[str, Any]]:
    """Return why an answer is not of its form."""
    if isinstance(form, Choice) and isinstance(outcome, str) and not form.is_bool:
        return Failure.OPTION, {"answer": outcome, **_tip(near_an_option(form, outcome))}
    if isinstance(form, Urdf) and (fault := form.fault(outcome)):
        return Failure.NO_ROBOT, {"fault": fault}
    frame = member(outcome, "header", "frame_id")
    if isinstance(form, Vector) and form.frame and frame is not None and frame != form.frame:
        return Failure.FRAME, {"frame": frame, "wanted_frame": form.frame}
    if outcome in A_FUNCTION:
        return Failure.A_FUNCTION, {}
    body = inside(outcome)
    if (
        isinstance(body, list | dict)
        and not isinstance(form, Number | Angle | Choice | Message)
        and _holds_numbers(body)
    ):
        return Failure.SHAPE, _tip(describe_type(form, outcome))
    return Failure.TYPE, _meant(form, outcome)


def _meant(form: Form, outcome: Plain) -> dict[str, Any]:
    """Return the tip for what has the wrong kind in a way that is plain to see."""
    if tip := _tip(describe_type(form, outcome)):
        return tip
    body = inside(outcome)
    if isinstance(body, list) and (other := next((held for held in body if not is_number(held)), None)) is not None:
        return {"got": f"{kind_of(outcome)}, holding {kind_of(other)}"}  # such as numbers formatted as text
    if not (isinstance(form, Tree) and isinstance(body, dict)):
        return {}
    odd = next((held for held in body.values() if not isinstance(held, str)), None)
    is_nested = any(isinstance(inside(held), dict) for held in body.values())
    return {"got": f"{kind_of(outcome)}, holding {kind_of(odd)}", **({"tip": TEXTS["nested"]} if is_nested else {})}


def _tip(said: Text | None) -> dict[str, Any]:
    return {"tip": said} if said else {}


def _coarse_of_parts(form: Parts, outcome: Plain) -> tuple[Failure, dict[str, Any]] | None:
    answers = inside(outcome)
    if not (isinstance(outcome, dict) and "dict" in outcome and isinstance(answers, dict)):
        return Failure.TYPE, _tip(single_part_given(form, outcome))
    missing = [name for name in form.parts if name not in answers or is_unanswered(answers[name])]
    more = [name for name in answers if name not in form.parts]
    if missing:
        return Failure.MISSING_PARTS, {"parts": missing, **({"tip": _not_asked_for(more)} if more else {})}
    if form.alone and more:
        return Failure.MORE_PARTS, {"parts": more}
    for name, part in form.parts.items():
        fault = _coarse(part, answers[name])
        if fault is not None:
            detail = _with_tip(form, name, answers, fault)
            return fault[0], {"got": kind_of(answers[name]), **detail, "part": name}
    return None


def _with_tip(
    form: Parts, name: str, answers: dict[str, Plain], fault: tuple[Failure, dict[str, Any]]
) -> dict[str, Any]:
    """Return the details of what is wrong with a part, under which other part its word is to choose from, and which
    further words are none to choose from.
    """
    if fault[0] is not Failure.OPTION:
        return fault[1]
    said = [option_of_another(form, name, answers[name]) or fault[1].get("tip"), invalid_parts(form, name, answers)]
    return fault[1] | ({"tip": Text.joined(*said, between=". ")} if any(said) else {})


def _not_asked_for(names: list[str]) -> Text:
    quoted = ", ".join(f'"{name}"' for name in names[:3])
    return Text(en=f"Nobody asked for {quoted}", ko=f"필요 없는 이름: {quoted}")


def _holds_numbers(body: Plain) -> bool:
    members = body.values() if isinstance(body, dict) else body
    flat = [number for row in members for number in (row if isinstance(row, list) else [row])]
    return bool(flat) and all(isinstance(number, int | float) and not isinstance(number, bool) for number in flat)


def _shape(rows: Plain) -> tuple[int, ...]:
    shape: list[int] = []
    while isinstance(rows, list):
        shape.append(len(rows))
        rows = rows[0] if rows else None
    return tuple(shape)
