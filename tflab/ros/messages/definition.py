"""Parse message definitions in the format of .msg files.

    "geometry_msgs/Point position"        ->  Field("position", NamespacedType(("geometry_msgs", "msg"), "Point"))
    "float64[36] covariance"              ->  Field("covariance", Array(BasicType("double"), 36))
    "float64 w 1"                         ->  Field("w", BasicType("double"), default=1.0)
    "string<=8 label"                     ->  Field("label", BoundedString(8))
    "uint8 FLOAT32=7   # a comment"       ->  Constant("FLOAT32", 7)

The type classes carry the names of `rosidl_parser.definition`; a message class
shows them as `SLOT_TYPES`.
"""

from __future__ import annotations

import re
from ast import literal_eval
from dataclasses import dataclass

__all__ = [
    "Array",
    "BasicType",
    "BoundedSequence",
    "BoundedString",
    "Constant",
    "Field",
    "NamespacedType",
    "SlotType",
    "UnboundedSequence",
    "UnboundedString",
    "parse_definition",
    "type_text",
]


@dataclass(frozen=True, slots=True)
class BasicType:
    """A number, a bool or a byte, under its IDL name: float64 is 'double', bool is 'boolean'."""

    typename: str


@dataclass(frozen=True, slots=True)
class UnboundedString:
    """Text of any length; `typename` is "string" or "wstring"."""

    typename: str = "string"


@dataclass(frozen=True, slots=True)
class BoundedString:
    """Text of at most `maximum_size` characters: string<=8."""

    maximum_size: int
    typename: str = "string"


@dataclass(frozen=True, slots=True)
class NamespacedType:
    """Another message: (('geometry_msgs', 'msg'), 'Point')."""

    namespaces: tuple[str, str]
    name: str


@dataclass(frozen=True, slots=True)
class Array:
    """Exactly `size` values: float64[36]."""

    value_type: BasicType | UnboundedString | BoundedString | NamespacedType
    size: int


@dataclass(frozen=True, slots=True)
class BoundedSequence:
    """At most `maximum_size` values: IntegerRange[<=1]."""

    value_type: BasicType | UnboundedString | BoundedString | NamespacedType
    maximum_size: int


@dataclass(frozen=True, slots=True)
class UnboundedSequence:
    """Any number of values: float32[]."""

    value_type: BasicType | UnboundedString | BoundedString | NamespacedType


SlotType = BasicType | UnboundedString | BoundedString | NamespacedType | Array | BoundedSequence | UnboundedSequence


@dataclass(frozen=True, slots=True)
class Field:
    """One field: its name, its type, and its default if that is not the zero of the type."""

    name: str
    slot_type: SlotType
    default: object = None


@dataclass(frozen=True, slots=True)
class Constant:
    """One constant of a message, such as PointField.FLOAT32."""

    name: str
    value: object


# .msg names that are spelt otherwise in IDL; the integers are spelt alike.
_IDL_NAMES = {"bool": "boolean", "byte": "octet", "char": "uint8", "float32": "float", "float64": "double"}
_INTEGERS = {"int8", "uint8", "int16", "uint16", "int32", "uint32", "int64", "uint64"}

_LINE = re.compile(
    r"(?P<type>[A-Za-z0-9_/]+(<=\d+)?)(?P<many>\[(?P<size>(<=)?\d*)\])?\s+(?P<name>\w+)"
    r"(\s*=\s*(?P<constant>.+)|\s+(?P<default>.+))?"
)


def parse_definition(text: str, package: str) -> tuple[tuple[Field, ...], tuple[Constant, ...]]:
    """Return the fields and the constants of a definition in .msg notation, in its order.

    A type without a package is looked for in `package`.

    Raises:
        ValueError: a line is neither a field nor a constant.
    """
    fields, constants = [], []
    for line in filter(None, map(_without_comment, text.splitlines())):
        match = _LINE.fullmatch(line)
        if match is None:
            raise ValueError(f'cannot read "{line}": expected "type name", "type name default" or "type NAME=value"')
        slot_type = _slot_type(match, package)
        try:
            if match["constant"] is not None:
                constants.append(Constant(match["name"], _value(match["constant"], slot_type)))
            else:
                default = None if match["default"] is None else _value(match["default"], slot_type)
                fields.append(Field(match["name"], slot_type, default))
        except (ValueError, SyntaxError):
            raise ValueError(f'cannot read "{line}": the value is none of type {type_text(slot_type)}') from None
    return tuple(fields), tuple(constants)


def type_text(slot_type: SlotType) -> str:
    """Return the type as `get_fields_and_field_types()` spells it: 'sequence<geometry_msgs/Point>'."""
    match slot_type:
        case BasicType(typename):
            return typename
        case UnboundedString(typename):
            return typename
        case BoundedString(maximum_size, typename):
            return f"{typename}<{maximum_size}>"
        case NamespacedType((package, _), name):
            return f"{package}/{name}"
        case Array(value_type, size):
            return f"{type_text(value_type)}[{size}]"
        case BoundedSequence(value_type, maximum_size):
            return f"sequence<{type_text(value_type)}, {maximum_size}>"
        case UnboundedSequence(value_type):
            return f"sequence<{type_text(value_type)}>"
    raise TypeError(f"not a field type: {slot_type!r}")


def _without_comment(line: str) -> str:
    """Return a line up to its `#`; one inside quotes is a letter."""
    return re.match(r"""([^#"']|"[^"]*"|'[^']*'|["'])*""", line).group().strip()


def _value(text: str, slot_type: SlotType) -> object:
    """Return the value of a constant, or a default, as it is written for a type.

    Raises:
        ValueError, SyntaxError: it is none.
    """
    text = text.strip()
    match slot_type:
        case BasicType("boolean"):
            if text.lower() not in ("true", "false", "1", "0"):
                raise ValueError("neither true nor false")
            return text.lower() in ("true", "1")
        case BasicType("float" | "double"):
            return float(text)
        case BasicType("octet"):
            return bytes([int(text, 0)])
        case BasicType():
            return int(text, 0)
        case UnboundedString() | BoundedString():
            return text[1:-1] if len(text) > 1 and text[0] == text[-1] and text[0] in "\"'" else text
        case NamespacedType():
            raise ValueError("a message has no default")
    words = re.sub(r"\btrue\b", "True", re.sub(r"\bfalse\b", "False", text))
    return [_value(str(item), slot_type.value_type) for item in literal_eval(words)]


def _slot_type(match: re.Match, package: str) -> SlotType:
    value_type = _value_type(match["type"], package)
    if match["many"] is None:
        return value_type
    size = match["size"]
    if size == "":
        return UnboundedSequence(value_type)
    if size.startswith("<="):
        return BoundedSequence(value_type, int(size.removeprefix("<=")))
    return Array(value_type, int(size))


def _value_type(name: str, package: str) -> BasicType | UnboundedString | BoundedString | NamespacedType:
    name, is_bounded, size = name.partition("<=")
    if name in ("string", "wstring"):
        return BoundedString(int(size), name) if is_bounded else UnboundedString(name)
    if is_bounded:
        raise ValueError(f'cannot read the type "{name}<={size}": only a string or wstring has a bound')
    if name in _IDL_NAMES or name in _INTEGERS:
        return BasicType(_IDL_NAMES.get(name, name))
    match name.split("/"):
        case [name]:
            return NamespacedType((package, "msg"), name)
        case [package, name]:
            return NamespacedType((package, "msg"), name)
        case [package, kind, name]:  # the goal of an action
            return NamespacedType((package, kind), name)
    raise ValueError(f'cannot read the type "{name}": expected "Name", "package/Name" or "package/kind/Name"')
