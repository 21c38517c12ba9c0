"""Show one call of a learner's function: its arguments, and where its result differs from the expected one.

show_call(assigned, 3)                    'path({"odom": "map", …}, "imu_link", "laser_frame")'
differing(form, got, expected)            (Number("m"), '["x"]', 1.2, 1.5)
shown_arguments(assigned)                 the arguments of the call that the last reply showed, by name
"""

from __future__ import annotations

import ast
import inspect
from collections.abc import Iterator, Sequence
from types import SimpleNamespace
from typing import Any

from .answers.form import Form, inside
from .answers.forms import Message, Pair, Parts
from .answers.forms import Sequence as ListForm
from .answers.showing import show_in_a_line
from .answers.values import Plain, from_plain, is_raised
from .assigned_task import AssignedTask
from .diagnosis.calls import return_value
from .diagnosis.verdict import kind_of

__all__ = ["describe_call", "remember_call", "show_call", "shown_arguments"]

LONGEST_ARGUMENT = 60
LONGEST_CALL = 400  # characters of arguments that are shown whole

_shown: dict[str, tuple[int, list[str]]] = {}  # task -> the call of its last reply, the parameters of its function


def show_call(assigned: AssignedTask, number: int) -> str:
    """Return a call: as Python that can be pasted, or where its arguments are long or no literals, cut to a line."""
    args = list(map(from_plain, assigned.variant.cases[number].args or ()))
    written = _literals(args) or [show_in_a_line(arg, LONGEST_ARGUMENT) for arg in args]
    return f"{assigned.cases.answer}({', '.join(written)})"


def _literals(args: Sequence[Any]) -> list[str]:
    """Return arguments as Python reads them; nothing if one is no literal, or they are long."""
    texts = [text if '"' in (text := repr(arg)) else text.replace("'", '"') for arg in args]
    try:
        is_read = list(map(ast.literal_eval, texts)) == list(args)
    except (SyntaxError, ValueError):
        return []
    return texts if is_read and sum(map(len, texts)) <= LONGEST_CALL else []


def describe_call(assigned: AssignedTask, number: int, outcome: Plain) -> str:
    """Return what a call gave and what is expected, where the two differ, and how to get its arguments."""
    case = assigned.variant.cases[number]
    form, path, *values = differing(assigned.cases.form, return_value(outcome), case.expected)
    got, expected = (_shown_value(form, value) for value in values)
    is_alike = form.alike(*values)  # what is wrong is not the result, but what became of an argument
    if got == expected and not is_alike:  # to three decimals
        got, expected = map(str, values)
    place = assigned.phrase("differs_at", path=path) if path else ""
    call = show_call(assigned, number)
    said = assigned.phrase("alike" if is_alike else "case", call=call, place=place, got=got, expected=expected)
    return said if _literals(list(map(from_plain, case.args))) else f"{said} {assigned.phrase('get_call')}"


def differing(form: Form, got: Plain, expected: Plain, path: str = "") -> tuple[Form, str, Plain, Plain]:
    """Return the first part in which two results differ: its form, the path to it, and what stands there in each."""
    for step, part, one, other in _parts_of(form, got, expected):
        if not part.alike(one, other):
            return differing(part, one, other, path + step)
    return form, path, got, expected


def _parts_of(form: Form, got: Plain, expected: Plain) -> Iterator[tuple[str, Form, Plain, Plain]]:
    """Yield the parts that both results have, each with the step that leads to it, its form and its values."""
    if form.read(got) is None or is_raised(got) or is_raised(expected):
        return
    if isinstance(form, Message | Parts):
        step = ".{}" if isinstance(form, Message) else '["{}"]'
        for name, part in form.forms_of_parts(expected).items():
            yield step.format(name), part, form.part_of(got, name), form.part_of(expected, name)
    elif isinstance(form, Pair | ListForm):
        rows = list(zip(inside(got), inside(expected), strict=False))
        forms = [form.first, form.second] if isinstance(form, Pair) else [form.of] * len(rows)
        if len(inside(got)) == len(inside(expected)):
            yield from ((f"[{at}]", part, *row) for at, (part, row) in enumerate(zip(forms, rows, strict=True)))


def _shown_value(form: Form, outcome: Plain) -> str:
    if is_raised(outcome):
        return outcome["raises"]
    numbers = form.numbers(outcome) or ()
    try:
        return show_in_a_line(numbers if len(numbers) > 1 else from_plain(outcome))
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
