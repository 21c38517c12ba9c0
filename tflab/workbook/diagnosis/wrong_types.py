"""Guess what the learner meant by an answer of a wrong type, or by a word that is no option."""

from __future__ import annotations

import difflib
import re
from collections.abc import Callable, Mapping, Sequence
from typing import Any

from ...text import Text, Texts
from ..answers.form import Form, inside, is_number, member
from ..answers.forms import Choice, Number, Parts, Tree
from ..answers.members import dict_of, members_of, pairs_of
from ..answers.values import Plain
from .explanation import Explanation
from .matching import all_alike
from .question import PartialExplanation, Question

__all__ = [
    "TYPES",
    "describe_type",
    "describe_types",
    "explain_other_types",
    "invalid_parts",
    "near_an_option",
    "option_of_another",
    "raised_option",
    "single_part_given",
]

TEXTS = Texts(__file__)

NUMBER = re.compile(r"-?\d+(?:\.\d+)?")


def describe_type(form: Form, outcome: Plain) -> Text | None:
    """Return what to say of an answer of another kind than the one asked for; None if nothing is plain."""
    name = next((name for name in form.mistakes if name in TYPES and TYPES[name](form, outcome)), None)
    if name is None:
        return None
    kind = next(iter(outcome), "") if isinstance(outcome, dict) else ""
    return TEXTS[name].filled(kind=kind, field=_field(outcome), name=str(getattr(form, "type", "")).rpartition("/")[2])


def _field(outcome: Plain) -> str:
    """Return the name that a message of this type has as a field of another one."""
    kind = str(outcome["message"][0]) if isinstance(outcome, dict) and "message" in outcome else ""
    return kind.rpartition("/")[2].lower()


def _numbers_in(outcome: Plain) -> int:
    """Return how many numbers stand in a text."""
    return len(NUMBER.findall(outcome)) if isinstance(outcome, str) else 0


def _is_joined(form: Form, outcome: Plain) -> bool:
    """Return whether a list or tuple holds as many numbers as several points, or quaternions, have."""
    size = getattr(form, "size", 4)
    body = outcome["tuple"] if isinstance(outcome, dict) and "tuple" in outcome else outcome
    return _is_row(body) and len(body) > size and len(body) % size == 0


def _is_row(body: Plain, *sizes: int) -> bool:
    is_list = isinstance(body, list) and (not sizes or len(body) in sizes)
    return is_list and all(map(is_number, body))


def _rows_in(outcome: Plain) -> int:
    """Return how many lists stand in a list; 0 if anything else stands in it."""
    held = inside(outcome)
    is_of_rows = isinstance(held, list) and all(isinstance(inside(row), list) for row in held)
    return len(held) if is_of_rows else 0


def _is_several(form: Choice, outcome: Plain) -> bool:
    held = members_of(outcome)
    return held is not None and len(held) > 1 and all(form.option(one) in form.options for one in held)


def _is_of_kind(*kinds: str) -> Callable[[Form, Plain], bool]:
    return lambda form, outcome: isinstance(outcome, dict) and not {*kinds}.isdisjoint(outcome)


TYPES: dict[str, Callable[[Any, Plain], bool]] = {
    "no_name": lambda form, plain: plain is None and "none" in getattr(form, "options", ("none",)),
    "several": _is_several,
    "a_class": lambda _, plain: plain == {"object": "type"},
    "an_error": lambda _, plain: isinstance(plain, dict) and "returned and not raised" in str(plain.get("object")),
    "a_set": _is_of_kind("set"),
    "one_alone": lambda form, plain: not isinstance(plain, list) and form.of.read(plain) is not None,
    "a_time": lambda form, plain: seconds_of(form, plain) is not None and "message" not in plain,
    "a_stamp": lambda form, plain: seconds_of(form, plain) is not None and "message" in plain,
    "one_text": lambda _, plain: _numbers_in(plain) == 1,
    "a_text": lambda form, plain: _numbers_in(plain) >= form.size,
    "three_angles": lambda _, plain: _is_row(inside(plain), 3),
    "joined": _is_joined,
    "one_inside": lambda _, plain: _rows_in(plain) == 1,
    "a_matrix": lambda _, plain: _rows_in(plain) in (3, 4),
    "rows": lambda _, plain: _rows_in(plain) > 0,
    "without_zeros": lambda _, plain: _is_row(inside(plain), 2),
    "angles": lambda _, plain: _is_row(inside(plain), 3),
    "its_rotation": _is_of_kind("Transform"),
    "its_translation": _is_of_kind("Transform"),
    "its_yaw": _is_of_kind("Transform"),
    "a_field": lambda form, plain: _field(plain) in {path.partition(".")[0] for path in form.fields},
    "no_message": lambda form, plain: form.read(plain) is None and plain is not None,
    "pairs": lambda _, plain: bool(pairs_of(plain)),
}


def describe_types(form: Form, outcomes: Sequence[Plain]) -> list[Text]:
    """Return the same of all calls of a function, each once."""
    return list(dict.fromkeys(words for outcome in outcomes if (words := describe_type(form, outcome)) is not None))


def seconds_of(form: Form, outcome: Plain) -> float | None:
    """Return the seconds of a Duration, a Time or a stamp that was given for a number of seconds; None of others."""
    if not (isinstance(form, Number) and form.unit == "s" and isinstance(outcome, dict)):
        return None
    sec, nanosec = member(outcome, "sec"), member(outcome, "nanosec")
    if isinstance(sec, int) and isinstance(nanosec, int) and "message" in outcome:
        return sec + nanosec / 1e9
    held = outcome.get("Duration", outcome.get("Time"))
    length = held[0] if isinstance(held, list) and held else held
    return length / 1e9 if isinstance(length, int) else None


def explain_other_types(question: Question) -> PartialExplanation | None:
    """Return that a time was given for seconds, or pairs for a dict, and what these hold; None if that is right."""
    form = question.form
    if isinstance(form, Number):
        values = [seconds_of(form, outcome) for outcome in question.outcomes]
    elif not all(map(pairs_of, question.outcomes)):
        return None
    else:
        rows = [[dict_of(outcome, is_child_first) for outcome in question.outcomes] for is_child_first in (False, True)]
        values = max(rows, key=lambda row: sum(map(sum, map(form.judge, row, question.expected))))
    if None in values or all_alike(question.form, values, question.expected):
        return None
    said = describe_type(question.form, question.outcomes[0])
    then = Explanation.of("other type", Text(f"{said.en}.", f"{said.ko}.")) if said else None
    return then and PartialExplanation(then, question.with_outcomes(values), is_enough=isinstance(question.form, Tree))


NEAR = 0.8  # share of letters that two words have in common


def near_an_option(form: Choice, answer: str) -> Text | None:
    """Return which option a word is near to, or is with a name in front; None if it is near none."""
    topic = next((one for one in form.options if one.startswith("/") and answer.endswith(one)), None)
    if topic is not None:
        return TEXTS["a_topic"].filled(option=topic)
    near = difflib.get_close_matches(answer[:100], form.options, 1, NEAR)
    if not near or not all(map(_is_misspelt, answer.split(), near[0].split())):
        return None
    return TEXTS["nearly"].filled(option=near[0])


def _is_misspelt(word: str, other: str) -> bool:
    return difflib.SequenceMatcher(None, word, other).ratio() >= 0.5


def raised_option(form: Form, text: str) -> Text | None:
    """Return that an option was raised as an error's text; None of any other error."""
    option = form.option(text) if isinstance(form, Choice) and text else None
    return None if option is None else TEXTS["raised"].filled(option=option)


def single_part_given(form: Parts, outcome: Plain) -> Text | None:
    """Return which part a word is for that was given where all parts are asked for; None if it is for none."""
    if not isinstance(outcome, str):
        return None
    parts = (name for name, part in form.parts.items() if isinstance(part, Choice) and part.option(outcome) is not None)
    name = next(parts, None)
    return TEXTS["alone"].filled(name=name) if name else None


def option_of_another(form: Parts, name: str, answer: Plain) -> Text | None:
    """Return under which other part a word is to choose from; None if it is under none, or of a kind of its own."""
    for other, part in form.parts.items():
        if other != name and isinstance(part, Choice) and part.options and part.option(answer) is not None:
            return TEXTS["anothers"].filled(name=other)
    return None


def invalid_parts(form: Parts, name: str, answers: Mapping[str, Plain]) -> Text | None:
    """Return which other parts hold words that are none to choose from; None if no other does."""
    bad = [
        f'"{other}": "{answers[other]}"'
        for other, part in form.parts.items()
        if other != name and isinstance(part, Choice) and isinstance(answers[other], str)
        and part.option(answers[other]) is None
    ]  # fmt: skip
    return TEXTS["neither"].filled(parts=", ".join(bad)) if bad else None
