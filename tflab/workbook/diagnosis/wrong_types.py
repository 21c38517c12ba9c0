"""Say what is meant by an answer of another type, or by a word that is no option."""

from __future__ import annotations

import difflib
import re
from collections.abc import Mapping, Sequence

from ...text import Text, Texts
from ..answers.form import Form, inside, is_number, member
from ..answers.forms import Angle, Choice, Message, Name, Number, Parts, Quaternion, Vector
from ..answers.forms import Sequence as ListForm
from ..answers.members import members_of
from ..answers.values import Plain
from .explanation import Explanation
from .matching import all_alike
from .question import Question, Rest

__all__ = [
    "describe_type",
    "describe_types",
    "explain_durations",
    "near_an_option",
    "no_options_either",
    "one_part_alone",
    "option_of_another",
    "raised_option",
]

TEXTS = Texts(__file__)

NUMBER = re.compile(r"-?\d+(?:\.\d+)?")
OF_A_TRANSFORM = {Quaternion: "its_rotation", Vector: "its_translation", Angle: "its_yaw"}


def describe_type(form: Form, outcome: Plain) -> Text | None:
    """Return what to say of an answer of another kind than the one asked for; None if nothing is plain."""
    if outcome is None and (isinstance(form, Name) or (isinstance(form, Choice) and "none" in form.options)):
        return TEXTS["no_name"]
    if isinstance(form, ListForm):
        return _said_of_a_list(form, outcome)
    if seconds_of(form, outcome) is not None:
        kind = next(iter(outcome))
        return TEXTS["a_stamp"] if kind == "message" else TEXTS["a_time"].filled(kind=kind)
    if isinstance(form, Message) and form.read(outcome) is None and outcome is not None:
        return _said_of_no_such_message(form, outcome)
    return _said_of_what_it_holds(form, outcome) or (
        _said_of_an_object(form, outcome) if isinstance(outcome, dict) else None
    )


def _said_of_what_it_holds(form: Form, outcome: Plain) -> Text | None:
    """Return what to say of a list or a text by what stands in it."""
    if _is_joined(form, outcome):
        return TEXTS["joined"]
    if isinstance(form, Choice) and (held := members_of(outcome)) and len(held) > 1:
        return TEXTS["several"] if all(form.option(one) in form.options for one in held) else None
    if isinstance(form, Quaternion) and isinstance(numbers := inside(outcome), list):
        return _said_of_no_quaternion(numbers)
    if isinstance(form, Angle) and isinstance(held := inside(outcome), list) and len(held) == len("rpy"):
        return TEXTS["three_angles"] if all(map(is_number, held)) else None
    return _said_of_a_text(form, outcome) if isinstance(outcome, str) else None


def _said_of_a_text(form: Form, outcome: str) -> Text | None:
    """Return that numbers stand in a text where they are asked for."""
    count = len(NUMBER.findall(outcome))
    if isinstance(form, Number | Angle):
        return TEXTS["one_text"] if count == 1 else None
    return TEXTS["a_text"] if isinstance(form, Vector) and count >= form.size else None


def _is_joined(form: Form, outcome: Plain) -> bool:
    """Return whether a list or tuple holds as many numbers as several points, or quaternions, have."""
    size = form.size if isinstance(form, Vector) else 4 if isinstance(form, Quaternion) else 0
    body = outcome["tuple"] if isinstance(outcome, dict) and "tuple" in outcome else outcome
    is_row = isinstance(body, list) and all(map(is_number, body))
    return size > 0 and is_row and len(body) > size and len(body) % size == 0


def _said_of_no_quaternion(members: list[Plain]) -> Text | None:
    if members and all(isinstance(row, list) or isinstance(inside(row), list) for row in members):
        return {1: TEXTS["one_inside"], 3: TEXTS["a_matrix"], 4: TEXTS["a_matrix"]}.get(len(members), TEXTS["rows"])
    return {2: TEXTS["without_zeros"], 3: TEXTS["angles"]}.get(len(members)) if all(map(is_number, members)) else None


def _said_of_no_such_message(form: Message, outcome: Plain) -> Text:
    kind = str(outcome["message"][0]) if isinstance(outcome, dict) and "message" in outcome else ""
    fields = {path.partition(".")[0] for path in form.fields}
    field = kind.rpartition("/")[2].lower()
    return (
        TEXTS["a_field"].filled(field=field)
        if field in fields
        else TEXTS["no_message"].filled(name=form.type.rpartition("/")[2])
    )


def _said_of_an_object(form: Form, outcome: dict[str, Plain]) -> Text | None:
    if "Transform" in outcome and type(form) in OF_A_TRANSFORM:
        return TEXTS[OF_A_TRANSFORM[type(form)]]
    if not isinstance(form, Name | Choice):
        return None
    held = str(outcome.get("object"))
    return TEXTS["a_class"] if held == "type" else TEXTS["an_error"] if "returned and not raised" in held else None


def _said_of_a_list(form: ListForm, outcome: Plain) -> Text | None:
    if isinstance(outcome, dict) and "set" in outcome:
        return TEXTS["a_set"]
    return TEXTS["one_alone"] if not isinstance(outcome, list) and form.of.read(outcome) is not None else None


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


def explain_durations(question: Question) -> Rest | None:
    """Return that Durations or Times were given for seconds, and the seconds to explain; None if these are right."""
    seconds = [seconds_of(question.form, outcome) for outcome in question.outcomes]
    if None in seconds or all_alike(question.form, seconds, question.expected):
        return None
    said = describe_type(question.form, question.outcomes[0])
    then = Explanation.of("no number", Text(f"{said.en}.", f"{said.ko}.")) if said else None
    return Rest(then, question.with_outcomes(seconds)) if then else None


ON, OFF = ("true", "on", "yes"), ("false", "off", "no")
NEAR = 0.8  # share of letters that two words have in common


def near_an_option(form: Choice, answer: str) -> Text | None:
    """Return which option a word is near to, or is with a name in front; None if it is near none."""
    topic = next((one for one in form.options if one.startswith("/") and answer.endswith(one)), None)
    if topic is not None:
        return TEXTS["a_topic"].filled(option=topic)
    near = difflib.get_close_matches(answer[:100], form.options, 1, NEAR)
    meant = next((words for words in (ON, OFF) if answer.lower() in words), ())
    near += [option for option in form.options if option.lower() in meant]
    return TEXTS["nearly"].filled(option=near[0]) if near else None


def raised_option(form: Form, text: str) -> Text | None:
    """Return that an option was raised as an error's text; None of any other error."""
    option = form.option(text) if isinstance(form, Choice) and text else None
    return None if option is None else TEXTS["raised"].filled(option=option)


def one_part_alone(form: Parts, outcome: Plain) -> Text | None:
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


def no_options_either(form: Parts, name: str, answers: Mapping[str, Plain]) -> Text | None:
    """Return which other parts hold words that are none to choose from; None if no other does."""
    bad = [
        f'"{other}": "{answers[other]}"'
        for other, part in form.parts.items()
        if other != name and isinstance(part, Choice) and isinstance(answers[other], str)
        and part.option(answers[other]) is None
    ]  # fmt: skip
    return TEXTS["neither"].filled(parts=", ".join(bad)) if bad else None
