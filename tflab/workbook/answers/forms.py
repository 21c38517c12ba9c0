"""List all forms of answers by name, and read them back from JSON.

form_from_plain(Vector(3, unit="m").plain()) == Vector(3, unit="m")
"""

from __future__ import annotations

from typing import Any

from .discriminating_check import DiscriminatingCheck
from .form import Form
from .members import Pair, Set, Tree
from .numeric import Angle, Number, Pose, Quaternion, Vector
from .proof import Proof
from .structures import Choice, Command, Message, Name, Parts, Sequence
from .urdf_text import Urdf

__all__ = [
    "Angle",
    "Choice",
    "Command",
    "DiscriminatingCheck",
    "Form",
    "Message",
    "Name",
    "Number",
    "Pair",
    "Parts",
    "Pose",
    "Proof",
    "Quaternion",
    "Sequence",
    "Set",
    "Tree",
    "Urdf",
    "Vector",
    "form_from_plain",
]

_CLASSES = {cls.__name__: cls for cls in globals().values() if isinstance(cls, type) and issubclass(cls, Form)}
del _CLASSES["Form"]


def form_from_plain(plain: dict[str, Any]) -> Form:
    """Return the form that `Form.plain()` wrote.

    Raises:
        ValueError: not a form of ours.
    """
    cls = _CLASSES.get(plain.get("form"))
    if cls is None:
        raise ValueError(f"there is no form {plain.get('form')!r}; there is {', '.join(sorted(_CLASSES))}")
    row = {name: value for name, value in plain.items() if name != "form"}
    if cls is Parts:
        names = row.get("order", row["parts"])
        return Parts({name: form_from_plain(row["parts"][name]) for name in names}, row.get("alone", False))
    if cls in (Pair, Sequence, Set):
        inner = {name: form_from_plain(held) if isinstance(held, dict) else held for name, held in row.items()}
        return cls(**inner)
    return cls(**{name: tuple(value) if isinstance(value, list) else value for name, value in row.items()})
