"""Show one call of a learner's function: its arguments, and where its result differs from the expected one.

show_call(assigned, 3)                    'path({"odom": "map", …}, "imu_link", "laser_frame")'
differing(got, expected)                  ('["x"]', 1.2, 1.5)
shown_arguments(assigned)                 the arguments of the call that the last reply showed, by name
"""

from __future__ import annotations

import inspect
from types import SimpleNamespace
from typing import Any

from .answers.form import inside, is_number
from .answers.showing import show_in_a_line
from .answers.values import Plain, from_plain, is_raised
from .assigned import AssignedTask
from .diagnosis.calls import return_value
from .diagnosis.verdict import kind_of

__all__ = ["describe_call", "remember_call", "show_call", "shown_arguments"]

CLOSE = 1e-6
LONGEST_ARGUMENT = 60
LONGEST_CALL = 120  # characters that a reader compares at a glance
CUT = (" …", "buffer with")  # of an argument that is not shown whole

_shown: dict[str, tuple[int, list[str]]] = {}  # task -> the call of its last reply, the parameters of its function


def show_call(assigned: AssignedTask, number: int) -> str:
    """Return a call as it was made, cut where it gets long."""
    arguments = ", ".join(
        show_in_a_line(from_plain(arg), LONGEST_ARGUMENT) for arg in assigned.variant.cases[number].args
    )
    return f"{assigned.cases.answer}({arguments})"


def describe_call(assigned: AssignedTask, number: int, outcome: Plain) -> str:
    """Return what a call gave and what is expected, where the two differ, and how to get its arguments."""
    path, got, expected = differing(return_value(outcome), assigned.variant.cases[number].expected)
    call = show_call(assigned, number)
    place = assigned.phrase("differs_at", path=path) if path else ""
    said = assigned.phrase("case", call=call, place=place, got=_shown_value(got), expected=_shown_value(expected))
    is_whole = len(call) <= LONGEST_CALL and not any(cut in call for cut in CUT)
    return said if is_whole else f"{said} {assigned.phrase('get_call')}"


def differing(got: Plain, expected: Plain, path: str = "") -> tuple[str, Plain, Plain]:
    """Return the path to the first place where two results differ, and what stands there in each."""
    for step, a, b in _parts(got, expected):
        if not _is_same(a, b):
            return differing(a, b, path + step)
    return path, got, expected


def _parts(got: Plain, expected: Plain) -> list[tuple[str, Plain, Plain]]:
    """Return the parts of two results of one kind, each with its step of the path; nothing of what is read whole."""
    if fields := _message_fields(got):
        wanted = _message_fields(expected)
        is_whole = fields.keys() != wanted.keys() or all(map(is_number, wanted.values()))
        names = [] if is_whole else sorted(wanted, key=("header", "stamp").__contains__)
        return [(f".{name}", fields[name], wanted[name]) for name in names]
    one, other = inside(got), inside(expected)
    if type(one) is not type(other):
        return []
    if isinstance(one, dict) and "dict" in got and one.keys() == other.keys():
        return [(f'["{key}"]', one[key], other[key]) for key in other]
    if isinstance(one, list) and len(one) == len(other) and not all(map(is_number, other)):
        return [(f"[{at}]", *pair) for at, pair in enumerate(zip(one, other, strict=True))]
    return []


def _message_fields(plain: Plain) -> dict[str, Plain]:
    named = plain.get("message") if isinstance(plain, dict) else None
    return named[1] if isinstance(named, list) and len(named) == 2 and isinstance(named[1], dict) else {}


def _is_same(one: Plain, other: Plain) -> bool:
    """Return whether two results are the same, numbers within a tolerance and q and -q as one rotation."""
    if is_number(one) and is_number(other):
        return abs(one - other) <= CLOSE
    if isinstance(one, list) and isinstance(other, list):
        return len(one) == len(other) and all(map(_is_same, one, other))
    if isinstance(one, dict) and isinstance(other, dict):
        mirrored = {name: -value for name, value in one.items()} if one.keys() == set("xyzw") else one
        return one.keys() == other.keys() and any(
            all(_is_same(each[name], other[name]) for name in other) for each in (one, mirrored)
        )
    return one == other


def _shown_value(outcome: Plain) -> str:
    if is_raised(outcome):
        return outcome["raises"]
    try:
        return show_in_a_line(from_plain(outcome))
    except ValueError:
        return kind_of(outcome)


def remember_call(assigned: AssignedTask, number: int, answer: Any) -> None:
    """Keep which call a reply shows, and how the learner's function names its arguments."""
    try:
        names = list(inspect.signature(answer).parameters)
    except (TypeError, ValueError):
        names = []
    _shown[assigned.id] = (number, names)


def shown_arguments(assigned: AssignedTask) -> SimpleNamespace:
    """Return fresh copies of the arguments of the call that the last reply showed; of the first call before that."""
    number, names = _shown.get(assigned.id, (0, []))
    args = assigned.variant.cases[number].args
    if len(names) != len(args):
        names = [f"argument_{place}" for place in range(1, len(args) + 1)]
    return SimpleNamespace(**{name: from_plain(arg) for name, arg in zip(names, args, strict=True)})
