"""How does what somebody typed become a message?  A dict of fields fills it.

    "{header: {frame_id: map, stamp: now}, point: {x: 1}}"
        --yaml-->  {"header": {...}, "point": {"x": 1}}
        --fill-->  PointStamped, and the stamps that are to be set when it is sent

A number that was written without a point fills a float, too; what is not
mentioned keeps its default.  upstream: rosidl_runtime_py/set_message.py.
"""

from __future__ import annotations

from array import array
from collections.abc import Callable, Mapping
from functools import partial
from typing import Any

import numpy as np

from .base import Message, type_named
from .builtin_interfaces import Time
from .definition import Array, BoundedSequence, NamespacedType, SlotType, UnboundedSequence
from .std_msgs import Header

__all__ = ["fill"]

StampSetter = Callable[[Time], None]


def fill(message: Message, values: Mapping[str, Any]) -> list[StampSetter]:
    """Set the fields of a message; return what sets the stamps of a Header given as "auto" and a Time given as "now".

    Raises:
        AttributeError: the message has no such field.
        TypeError, ValueError: a value is not one of its field.
    """
    if not isinstance(values, Mapping):
        kind = type(values).__name__
        raise TypeError(f"Value '{values}' is expected to be a dictionary but is a {kind}")
    setters: list[StampSetter] = []
    slot_types = dict(zip(message.get_fields_and_field_types(), message.SLOT_TYPES, strict=True))
    for name, value in values.items():
        field = getattr(message, name)
        if isinstance(field, Header) and value == "auto":
            setters.append(partial(setattr, field, "stamp"))
        elif isinstance(field, Time) and value == "now":
            setters.append(partial(setattr, message, name))
        elif isinstance(field, Message):
            setters += fill(field, value)
        else:
            setattr(message, name, _value(field, value, slot_types[name], setters))
    return setters


def _value(field: Any, value: Any, slot_type: SlotType, setters: list[StampSetter]) -> Any:
    """Return what the field takes for a value as YAML has it."""
    if isinstance(field, array):
        return array(field.typecode, value)
    if isinstance(field, np.ndarray):
        return np.array(value, dtype=field.dtype)
    if isinstance(slot_type, Array | BoundedSequence | UnboundedSequence):
        member_type = slot_type.value_type
        if not isinstance(member_type, NamespacedType):
            return list(value)
        member_class = type_named("/".join((*member_type.namespaces, member_type.name)))
        members = [member_class() for _ in value]
        for member, values in zip(members, value, strict=True):
            setters += fill(member, values)
        return members
    return type(field)(value)
