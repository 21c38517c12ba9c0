"""Convert messages to and from plain data and other libraries' objects, field by field.

    rosbags' object  --message_from_object-->  our message  --object_from_message-->  rosbags' object

    "{header: {frame_id: map, stamp: now}, point: {x: 1}}"
        --yaml-->  {"header": {...}, "point": {"x": 1}}
        --fill-->  PointStamped, and the stamps that are to be set when it is sent

Only names are compared: fields that our definition lacks (ROS 1's `seq`) are left out.
`fill` accepts an int for a float; fields that are not mentioned keep their defaults.
upstream: rosidl_runtime_py/set_message.py.

`serialize_message` and `deserialize_message` convert messages to and from bytes (CDR), with
the rosbags library. Bags use them, and subscriptions with raw=True.
"""

from __future__ import annotations

from array import array
from collections.abc import Callable, Mapping
from functools import cache, partial
from typing import Any

import numpy as np

from .base import Message, type_named
from .builtin_interfaces import Time
from .checks import field_checks
from .definition import Array, BasicType, BoundedSequence, NamespacedType, SlotType, UnboundedSequence
from .fields import array_converter
from .packages import type_store
from .std_msgs import Header

__all__ = ["deserialize_message", "fill", "message_from_object", "object_from_message", "serialize_message"]


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


def serialize_message(message: Message) -> bytes:
    """Return a message as it travels.

    Raises:
        KeyError: its type is neither one that ROS 2 brings along nor defined here.
    """
    store = type_store()
    return bytes(store.serialize_cdr(object_from_message(message, store.types), message.ROS_TYPE))


def deserialize_message(serialized_message: bytes, message_type: type[Message]) -> Message:
    """Return the message of some bytes.

    Raises:
        KeyError: its type is neither one that ROS 2 brings along nor defined here.
    """
    ros_type = message_type.ROS_TYPE
    return message_from_object(ros_type, type_store().deserialize_cdr(serialized_message, ros_type))
