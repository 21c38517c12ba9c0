"""Check and store the values of message fields, with the error texts of rosidl.

                     check(value)              store(value)
    msg.x = 1   ->   "must be of type 'float'"     -
    msg.x = 1.0 ->   fine                      ->  1.0
    msg.covariance = [0.0] * 36                ->  numpy array
    msg.ranges = [1.0, 2.0]                    ->  array.array('f', ...)

The texts are those of the Python classes that rosidl generates; so is the rule
that an int is not a float and that a bool passes for an int.  Fixed numeric
arrays are kept in numpy arrays, numeric sequences in `array.array`, everything
else as it is given.
"""

from __future__ import annotations

import math
from array import array
from collections import UserList, UserString
from collections.abc import Callable, Sequence, Set
from functools import partial

import numpy as np

from .definition import (
    Array,
    BasicType,
    BoundedSequence,
    BoundedString,
    Field,
    NamespacedType,
    SlotType,
    UnboundedSequence,
    UnboundedString,
)

__all__ = ["array_converter", "checker", "default_value", "numeric_array"]

Check = Callable[[object], None]

# IDL name -> (array.array's type code, numpy's dtype)
_NUMBERS = {
    "float": ("f", np.float32),
    "double": ("d", np.float64),
    "int8": ("b", np.int8),
    "uint8": ("B", np.uint8),
    "int16": ("h", np.int16),
    "uint16": ("H", np.uint16),
    "int32": ("i", np.int32),
    "uint32": ("I", np.uint32),
    "int64": ("q", np.int64),
    "uint64": ("Q", np.uint64),
}

_FLOAT_BOUNDS = {"float": 3.402823466e38, "double": 1.7976931348623157e308}


def default_value(field: Field, message_class: type | None) -> tuple[object, Callable[[], object] | None]:
    """Return the default of a field: (value, None), or (None, maker) where each message needs a value of its own.

    `message_class` is that of a sub-message.
    """
    if isinstance(field.default, list):
        pack = array_converter(field.slot_type) or list
        return None, lambda: pack(field.default)
    match field.slot_type:
        case Array(BasicType(typename), size) if typename in _NUMBERS:
            return None, lambda: np.zeros(size, dtype=_NUMBERS[typename][1])
        case UnboundedSequence(BasicType(typename)) | BoundedSequence(BasicType(typename)) if typename in _NUMBERS:
            return None, lambda: array(_NUMBERS[typename][0])
        case UnboundedSequence() | BoundedSequence():
            return None, list
        case Array(value_type, size):
            zero, fresh = default_value(Field(field.name, value_type), message_class)
            return None, lambda: [zero if fresh is None else fresh() for _ in range(size)]
        case NamespacedType():
            return None, message_class
        case BasicType("octet"):
            return b"\x00", None
    return (_python_type(field.slot_type, None)() if field.default is None else field.default), None


def array_converter(slot_type: SlotType) -> Callable[[object], object] | None:
    """Return the function that packs numbers as the field stores them, or None if values are kept as given."""
    kept_in = numeric_array(slot_type)
    if kept_in is None:
        return None
    code, dtype = _NUMBERS[slot_type.value_type.typename]
    return (
        partial(np.array, dtype=dtype) if kept_in is np.ndarray else partial(_packed_sequence, code=code, dtype=dtype)
    )


def numeric_array(slot_type: SlotType) -> type | None:
    """Return the class that the field keeps its numbers in: numpy.ndarray, array.array, or None."""
    match slot_type:
        case Array(BasicType(typename)) if typename in _NUMBERS:
            return np.ndarray
        case UnboundedSequence(BasicType(typename)) | BoundedSequence(BasicType(typename)) if typename in _NUMBERS:
            return array
    return None


def checker(name: str, slot_type: SlotType, message_class: type | None) -> Check:
    """Return the check of the field `name`: it raises AssertionError with rosidl's text, or returns.

    `message_class` is the class of a sub-message, or of the members of a
    sequence of messages.  (Explicit raises: `python -O` does not silence them.)
    """
    match slot_type:
        case Array() | BoundedSequence() | UnboundedSequence():
            return _sequence_checker(name, slot_type, message_class)
        case NamespacedType():
            return _instance_checker(
                message_class, f"The '{name}' field must be a sub message of type '{message_class.__name__}'"
            )
        case BasicType("octet"):
            text = f"The '{name}' field must be of type 'bytes' or 'ByteString' with length 1"
            return _checker_of(lambda item: isinstance(item, (bytes, bytearray, memoryview)) and len(item) == 1, text)
        case BoundedString(maximum_size):
            text = f"The '{name}' field must be string value not longer than {maximum_size}"
            return _checker_of(lambda value: isinstance(value, str) and len(value) <= maximum_size, text)
        case BasicType(typename) if typename != "boolean":
            return _number_checker(name, typename)
    python_type = _python_type(slot_type, message_class)
    return _instance_checker(python_type, f"The '{name}' field must be of type '{python_type.__name__}'")


def _packed_sequence(value: object, code: str, dtype: type) -> array:
    if isinstance(value, np.ndarray) and value.dtype == dtype:
        value = value.tobytes()  # a million points as one block, not one by one
        packed = array(code)
        packed.frombytes(value)
        return packed
    return array(code, value)


def _instance_checker(python_type: type, text: str) -> Check:
    def check(value: object) -> None:
        if not isinstance(value, python_type):
            raise AssertionError(text)

    return check


def _checker_of(fits: Callable[[object], bool], text: str) -> Check:
    def check(value: object) -> None:
        if not fits(value):
            raise AssertionError(text)

    return check


def _number_checker(name: str, typename: str) -> Check:
    python_type = _python_type(BasicType(typename), None)
    low, high = _bounds(typename)
    kind = {"float": "a float", "double": "a double"}.get(typename, _integer_kind(typename))

    def check(value: object) -> None:
        if not isinstance(value, python_type):
            raise AssertionError(f"The '{name}' field must be of type '{python_type.__name__}'")
        if not low <= value <= high and _is_finite(value):
            raise AssertionError(f"The '{name}' field must be {kind} in [{low}, {high}]")

    return check


def _sequence_checker(
    name: str, slot_type: Array | BoundedSequence | UnboundedSequence, message_class: type | None
) -> Check:
    value_type = slot_type.value_type
    python_type = _python_type(value_type, message_class)
    kept_in = numeric_array(slot_type)
    bounds = _bounds(value_type.typename) if kept_in else None
    longest = value_type.maximum_size if isinstance(value_type, BoundedString) else None
    text = f"The '{name}' field must be {_sequence_text(slot_type, python_type, bounds)}"

    def check(value: object) -> None:
        if kept_in is not None and isinstance(value, kept_in):
            _check_packed(name, slot_type, value)
            return
        if (
            not isinstance(value, (Sequence, Set, UserList))
            or isinstance(value, (str, UserString))
            or not _length_fits(slot_type, len(value))
            or not all(isinstance(item, python_type) for item in value)
            or not (longest is None or all(len(item) <= longest for item in value))
            or not (bounds is None or all(bounds[0] <= item <= bounds[1] or not _is_finite(item) for item in value))
        ):
            raise AssertionError(text)

    return check


def _check_packed(name: str, slot_type: Array | BoundedSequence | UnboundedSequence, value: np.ndarray | array) -> None:
    """Check a value that is already packed as the field stores it: by its type code, not number by number."""
    code, dtype = _NUMBERS[slot_type.value_type.typename]
    if isinstance(value, np.ndarray):
        if value.dtype != dtype:
            raise AssertionError(f"The '{name}' numpy.ndarray() must have the dtype of 'numpy.{np.dtype(dtype).name}'")
        if value.size != slot_type.size:
            raise AssertionError(f"The '{name}' numpy.ndarray() must have a size of {slot_type.size}")
        return
    if value.typecode != code:
        raise AssertionError(f"The '{name}' array.array() must have the type code of '{code}'")
    if not _length_fits(slot_type, len(value)):
        raise AssertionError(f"The '{name}' array.array() must have a size <= {slot_type.maximum_size}")


def _sequence_text(
    slot_type: Array | BoundedSequence | UnboundedSequence, python_type: type, bounds: tuple | None
) -> str:
    """Return what the field must be: "a set or sequence with length 36 and each value of type 'float' and ..."."""
    parts = ["a set or sequence"]
    match slot_type:
        case Array(size=size):
            parts.append(f"with length {size}")
        case BoundedSequence(maximum_size=size):
            parts.append(f"with length <= {size}")
    if isinstance(slot_type.value_type, BoundedString):
        parts.append(f"and each string value not longer than {slot_type.value_type.maximum_size}")
    parts.append(f"and each value of type '{python_type.__name__}'")
    if bounds is not None:
        typename = slot_type.value_type.typename
        if typename in _FLOAT_BOUNDS:
            parts.append(f"and each {typename} in [{bounds[0]:f}, {bounds[1]:f}]")
        else:
            kind = _integer_kind(typename).removeprefix("an ").removeprefix("a ")
            parts.append(f"and each {kind} in [{bounds[0]}, {bounds[1]}]")
    return " ".join(parts)


def _length_fits(slot_type: Array | BoundedSequence | UnboundedSequence, length: int) -> bool:
    match slot_type:
        case Array(size=size):
            return length == size
        case BoundedSequence(maximum_size=size):
            return length <= size
    return True


def _python_type(slot_type: SlotType, message_class: type | None) -> type:
    match slot_type:
        case BasicType("boolean"):
            return bool
        case BasicType("octet"):
            return bytes
        case BasicType("float" | "double"):
            return float
        case BasicType():
            return int
        case UnboundedString() | BoundedString():
            return str
    return message_class


def _bounds(typename: str) -> tuple[float, float] | tuple[int, int]:
    if typename in _FLOAT_BOUNDS:
        return -_FLOAT_BOUNDS[typename], _FLOAT_BOUNDS[typename]
    info = np.iinfo(_NUMBERS[typename][1])
    return int(info.min), int(info.max)


def _is_finite(value: float) -> bool:
    """Tell a number that may be out of bounds from infinity and nan, which fit any float field."""
    return isinstance(value, int) or math.isfinite(value)


def _integer_kind(typename: str) -> str:
    return "an unsigned integer" if typename.startswith("u") else "an integer"
