"""Is an answer of the wrong kind in a way that is plain to see?  Nothing for a word, a class for its name.

    asked for   "none"                 "LookupException"
    given       None                   LookupException, the class itself
                the word needs quotes  `type(error).__name__` is its name

    asked for   a quaternion           a PointStamped            a list of names
    given       a Transform            a Point                   a set
                its `.rotation`        it is only a part         it has no order

A Duration or a Time where seconds are asked for has a number in it: what is wrong with that is said, too.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

from ...text import Text, Texts
from ..answers.form import Form, inside, is_number, member
from ..answers.forms import Angle, Choice, Message, Name, Number, Quaternion, Vector
from ..answers.forms import Sequence as ListForm
from ..answers.members import members_of
from ..answers.values import Plain
from ..mistakes.fitting import all_alike
from ..tasks.case_types import Case, TaskCases
from .explanation import Explains, Explanation, and_then

__all__ = ["kind_said", "kinds_said", "of_times"]

TEXTS = Texts(__file__)


NUMBER = re.compile(r"-?\d+(?:\.\d+)?")
OF_A_TRANSFORM = {Quaternion: "its_rotation", Vector: "its_translation", Angle: "its_yaw"}


def kind_said(form: Form, outcome: Plain) -> Text | None:
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


def kinds_said(form: Form, outcomes: Sequence[Plain]) -> list[Text]:
    """Return the same of all calls of a function, each once."""
    return list(dict.fromkeys(words for outcome in outcomes if (words := kind_said(form, outcome)) is not None))


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


def of_times(
    task: TaskCases, cases: Sequence[Case], outcomes: Sequence[Plain], explained: Explains
) -> Explanation | None:
    """Return what `explained` says of the seconds in Durations or Times, and that they are no numbers; else None."""
    seconds = [seconds_of(task.form, outcome) for outcome in outcomes]
    if None in seconds or all_alike(task.form, seconds, [case.expected for case in cases]):
        return None
    first, said = explained(task, cases, seconds), kind_said(task.form, outcomes[0])
    if first is None or said is None:
        return None
    return and_then(first, Explanation.of("no number", Text(f"{said.en}.", f"{said.ko}.")))
