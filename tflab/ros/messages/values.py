"""How does a message become plain data, and data a message?  Field by field, by name.

    rosbags' object  --message_from_object-->  our message  --object_from_message-->  rosbags' object

A bag library has classes of its own for the same definitions.  Only names are
compared: what an object has beyond our fields (ROS 1's `seq`) is left out.
This is the last page on messages; `../time.py` is about their stamps.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cache

import numpy as np

from .base import Message, type_named
from .checks import field_checks
from .definition import BasicType, NamespacedType, SlotType
from .fields import array_converter

__all__ = ["message_from_object", "object_from_message"]


def message_from_object(ros_type: str, source: object) -> Message:
    """Return a message of `ros_type` with the values that `source` has under the names of its fields.

    Raises:
        KeyError: there is no such type.
        AttributeError: `source` lacks a field.
    """
    return _reader(ros_type)(source)


def object_from_message(message: Message, classes: Mapping[str, type]) -> object:
    """Return the message as an object of `classes[message.ROS_TYPE]`, made with the fields as keywords.

    Numeric sequences become numpy arrays, sub-messages objects of their own class.

    Raises:
        KeyError: `classes` lacks the type.
    """
    fields = zip(message.get_fields_and_field_types(), message.SLOT_TYPES, strict=True)
    return classes[message.ROS_TYPE](
        **{name: _plain(getattr(message, name), slot_type, classes) for name, slot_type in fields}
    )


@cache
def _reader(ros_type: str) -> Callable[[object], Message]:
    """Return the function that reads a message of this type from an object with the same field names."""
    cls = type_named(ros_type)
    names = cls.get_fields_and_field_types()
    readers = [
        (name, f"_{name}", _value_reader(slot_type)) for name, slot_type in zip(names, cls.SLOT_TYPES, strict=True)
    ]

    def read(source: object) -> Message:
        message = object.__new__(cls)
        message._check_fields = field_checks()
        for name, slot, read_value in readers:
            value = getattr(source, name)
            setattr(message, slot, value if read_value is None else read_value(value))
        return message

    return read


def _value_reader(slot_type: SlotType) -> Callable[[object], object] | None:
    """Return the function that reads one value of a field, or None if it is kept as it is."""
    if isinstance(slot_type, NamespacedType):
        return _reader("/".join((*slot_type.namespaces, slot_type.name)))
    if slot_type == BasicType("octet"):
        return lambda value: bytes((value,))
    if not hasattr(slot_type, "value_type"):
        return None
    pack = array_converter(slot_type)
    if pack is not None:
        return pack
    read_member = _value_reader(slot_type.value_type)
    if read_member is None:  # strings and bools
        return lambda values: values.tolist() if isinstance(values, np.ndarray) else list(values)
    return lambda values: [read_member(value) for value in values]


def _plain(value: object, slot_type: SlotType, classes: Mapping[str, type]) -> object:
    match getattr(slot_type, "value_type", None):
        case None:
            return _plain_single(value, classes)
        case BasicType("octet"):
            return np.frombuffer(b"".join(value), dtype=np.uint8)
        case BasicType("boolean"):
            return np.array(value, dtype=bool)
        case BasicType():
            return np.array(value)  # of array.array: its type code is the dtype
    return [_plain_single(item, classes) for item in value]


def _plain_single(value: object, classes: Mapping[str, type]) -> object:
    if isinstance(value, Message):
        return object_from_message(value, classes)
    return value[0] if isinstance(value, bytes) else value
