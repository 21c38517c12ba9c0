"""Which parts does an answer have?  Those of a dict by their names, those of a message by their fields.

    Parts({"x": Number(), ...})                      "x", "y", "yaw"
    Message(..., ("header.frame_id", "point"))       a name, three numbers [m]

Read `fitting.py` next.
"""

from __future__ import annotations

from ..answers import sealed
from ..answers.form import Form, inside, member, numbers_of
from ..answers.forms import Message, Name, Number, Parts, Quaternion, Vector
from ..answers.values import Plain

__all__ = ["section", "sections"]


def sections(form: Form, like: Plain) -> dict[str, Form]:
    """Return the parts of an answer that are judged each on its own; of a message its fields, as `like` has them."""
    if isinstance(form, Parts):
        return dict(form.parts)
    if isinstance(form, Message):
        held = {path: section(form, like, number, path) for number, path in enumerate(form.fields)}
        return {path: _form_of_field(path, field, form.tolerance) for path, field in held.items()}
    return {}


def section(form: Form, plain: Plain, number: int, name: str) -> Plain:
    """Return one of an answer's parts, the `number`th; of something else, None."""
    if sealed.is_sealed(plain) or isinstance(form, Parts):
        held = inside(plain)
        return sealed.part_of(plain, number, name) if sealed.is_sealed(plain) or isinstance(held, dict) else None
    return member(plain, *name.split("."))


def _form_of_field(path: str, held: Plain, tolerance: float) -> Form:
    """Return the form of a message's field: its numbers are metres, its rotation a quaternion, its texts words."""
    if numbers_of(held, 4) is not None or path.endswith("rotation"):
        return Quaternion(tolerance)
    if numbers_of(held, 3) is not None or path.endswith(("translation", "point", "position")):
        return Vector(3, "m", "", tolerance)
    return Number("", tolerance) if numbers_of(held, None) is not None else Name()
