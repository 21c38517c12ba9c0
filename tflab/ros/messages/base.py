"""Build message classes from their definitions.

    Vector3 = message("geometry_msgs/msg/Vector3", '''
        float64 x
        float64 y
        float64 z
    ''')
    v = Vector3(x=1.0)      # keywords only; the rest has its default
    v.Z = 1.0               # AttributeError: the classic slip is caught
    a.header = b.header     # shared, not copied: now both move together

rosidl writes one such class into a file for each .msg; here `message()` makes it
from the same text.  It is the one place in the project where classes are made by
code, for the reason upstream has: a hundred classes that differ in a table only.
"""

from __future__ import annotations

import re
from array import array
from collections.abc import Callable
from contextlib import suppress
from copy import deepcopy
from importlib import import_module
from operator import attrgetter
from textwrap import dedent
from types import SimpleNamespace
from typing import ClassVar

import numpy as np

from . import checks
from .definition import (
    Array,
    BasicType,
    BoundedString,
    Field,
    NamespacedType,
    SlotType,
    UnboundedString,
    parse_definition,
    type_text,
)
from .fields import array_converter, checker, default_value, numeric_array

__all__ = [
    "Action",
    "Message",
    "Service",
    "action",
    "copy_message",
    "filled",
    "is_action_class",
    "is_message_class",
    "is_service_class",
    "message",
    "message_in",
    "ros_type_of",
    "service",
    "type_named",
    "types_of",
]

# ROS type name -> class: 'geometry_msgs/msg/Point', 'tf2_msgs/srv/FrameGraph_Request', ...
_types: dict[str, type] = {}


class Message:
    """What all messages share."""

    __slots__ = ()

    ROS_TYPE: ClassVar[str]
    DEFINITION: ClassVar[str]
    SLOT_TYPES: ClassVar[tuple[SlotType, ...]]
    _FIELDS: ClassVar[tuple[tuple[str, str, object, Callable | None], ...]]  # see _add_field
    _WIRE: ClassVar[tuple[tuple[str, type | None, Callable], ...]]  # see _wire

    def __init__(self, **kwargs: object) -> None:
        self._check_fields = kwargs.pop("check_fields", checks.on)
        if kwargs and self._check_fields:
            unknown = sorted(name for name in kwargs if f"_{name}" not in self.__slots__)
            if unknown:
                raise AssertionError(f"Invalid arguments passed to constructor: {', '.join(unknown)}")
        for name, slot, zero, fresh in self._FIELDS:
            if name in kwargs:
                setattr(self, name, kwargs[name])
            else:
                setattr(self, slot, zero if fresh is None else fresh())

    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]:
        """Return the name and the type of each field: {'frame_id': 'string', ...}."""
        return {name: type_text(slot) for (name, *_), slot in zip(cls._FIELDS, cls.SLOT_TYPES, strict=True)}

    def __repr__(self) -> str:
        package, kind, name = self.ROS_TYPE.split("/")
        values = (f"{field}={_field_repr(getattr(self, field))}" for field, *_ in self._FIELDS)
        return f"{package}.{kind}.{name}({', '.join(values)})"

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, self.__class__):
            return False
        return all(_equal(getattr(self, name), getattr(other, name)) for name, *_ in self._FIELDS)

    def __reduce__(self) -> tuple:
        # By its ROS name, so that deepcopy and pickle work without the face packages.
        values = {name: getattr(self, name) for name, *_ in self._FIELDS}
        return _rebuilt, (self.ROS_TYPE, values, self._check_fields)


class Service:
    """What all services share: the messages `Request` and `Response`, and `Event`, by which introspection reports."""

    ROS_TYPE: ClassVar[str]
    Request: ClassVar[type[Message]]
    Response: ClassVar[type[Message]]
    Event: ClassVar[type[Message]]

    def __init__(self) -> None:
        raise NotImplementedError("Service classes can not be instantiated")


class Action:
    """What all actions share: three messages, `Goal`, `Result` and `Feedback`.

    `Impl` has what carries them, with the id of the goal: the services SendGoalService, GetResultService and
    CancelGoalService, and the messages FeedbackMessage and GoalStatusMessage.
    """

    ROS_TYPE: ClassVar[str]
    Goal: ClassVar[type[Message]]
    Result: ClassVar[type[Message]]
    Feedback: ClassVar[type[Message]]
    Impl: ClassVar[SimpleNamespace]

    def __init__(self) -> None:
        raise NotImplementedError("Action classes can not be instantiated")


def message(ros_type: str, definition: str = "") -> type[Message]:
    """Make the class of a message from its name, 'package/msg/Name', and its definition in .msg notation."""
    package = ros_type.split("/")[0]
    fields, constants = parse_definition(definition, package)
    members = {constant.name: constant.value for constant in constants}
    cls = _named_class(
        ros_type, Message, __slots__=[f"_{field.name}" for field in fields] + ["_check_fields"], **members
    )
    cls.DEFINITION = dedent(definition).strip("\n")
    cls.SLOT_TYPES = tuple(field.slot_type for field in fields)
    cls._FIELDS = tuple(_add_field(cls, field) for field in fields)
    cls._WIRE = tuple(_wire(field) for field in fields)
    return cls


def service(ros_type: str, request: str = "", response: str = "") -> type[Service]:
    """Make the class of a service from its name, 'package/srv/Name', and the definitions of its first two messages."""
    return _named_class(
        ros_type,
        Service,
        Request=message(f"{ros_type}_Request", request),
        Response=message(f"{ros_type}_Response", response),
        Event=message(
            f"{ros_type}_Event",
            f"service_msgs/ServiceEventInfo info\n{ros_type}_Request[<=1] request\n{ros_type}_Response[<=1] response",
        ),
    )


def action(ros_type: str, goal: str = "", result: str = "", feedback: str = "") -> type[Action]:
    """Make the class of an action from its name, 'package/action/Name', and the definitions of its three messages."""
    return _named_class(
        ros_type,
        Action,
        Goal=message(f"{ros_type}_Goal", goal),
        Result=message(f"{ros_type}_Result", result),
        Feedback=message(f"{ros_type}_Feedback", feedback),
        Impl=_carriers(ros_type),
    )


def _carriers(ros_type: str) -> SimpleNamespace:
    """Return what carries the three messages of an action, once these are there."""
    return SimpleNamespace(
        SendGoalService=service(
            f"{ros_type}_SendGoal",
            request=f"unique_identifier_msgs/UUID goal_id\n{ros_type}_Goal goal",
            response="bool accepted\nbuiltin_interfaces/Time stamp",
        ),
        GetResultService=service(
            f"{ros_type}_GetResult",
            request="unique_identifier_msgs/UUID goal_id",
            response=f"int8 status\n{ros_type}_Result result",
        ),
        CancelGoalService=type_named("action_msgs/srv/CancelGoal"),
        FeedbackMessage=message(
            f"{ros_type}_FeedbackMessage",
            f"unique_identifier_msgs/UUID goal_id\n{ros_type}_Feedback feedback",
        ),
        GoalStatusMessage=type_named("action_msgs/msg/GoalStatusArray"),
    )


def is_message_class(given: object) -> bool:
    """Return whether something is the class of a message: one of ours, or one that looks like rosidl's."""
    return isinstance(given, type) and callable(getattr(given, "get_fields_and_field_types", None))


def is_service_class(given: object) -> bool:
    """Return whether something is the class of a service: one with a Request and a Response."""
    return isinstance(given, type) and all(
        is_message_class(getattr(given, side, None)) for side in ("Request", "Response")
    )


def is_action_class(given: object) -> bool:
    """Return whether something is the class of an action: one with a Goal, a Result and a Feedback."""
    return isinstance(given, type) and all(
        is_message_class(getattr(given, part, None)) for part in ("Goal", "Result", "Feedback")
    )


def ros_type_of(cls: type) -> str:
    """Return the ROS name of the class of a message or service: 'my_msgs/msg/Detection', from its module if need be."""
    if hasattr(cls, "ROS_TYPE"):
        return cls.ROS_TYPE
    package, *_ = cls.__module__.split(".")
    kind = "msg" if is_message_class(cls) else "srv"
    return f"{package}/{kind}/{cls.__name__}"


def copy_message(message: Message) -> Message:
    """Return what a receiver gets of a published message: equal values, nothing shared.

    A message of a class that is not ours is copied whole, without a check.

    As on a wire, float32 fields come out rounded to float32, and numpy's floats
    and bools given for ints come out as plain floats and ints.

    Raises:
        AssertionError: a field holds something that cannot be sent, with the text
            that the checks of the field have.  (ROS 2 aborts the process here.)
    """
    if not isinstance(message, Message):
        return deepcopy(message)
    copied = object.__new__(message.__class__)
    copied._check_fields = checks.on
    for slot, as_is, received in message._WIRE:
        value = getattr(message, slot)
        setattr(copied, slot, value if value.__class__ is as_is else received(value))
    return copied


def filled(cls: type[Message], *values: object) -> Message:
    """Return a message with these values, one a field in their order, taken as they are: for those known to fit."""
    made = object.__new__(cls)
    made._check_fields = checks.on
    for (_, slot, _, _), value in zip(cls._FIELDS, values, strict=True):
        setattr(made, slot, value)
    return made


def type_named(ros_type: str) -> type:
    """Return the class of a ROS type: type_named('geometry_msgs/msg/Point').

    Raises:
        KeyError: there is no such type here.
    """
    if ros_type not in _types:
        package, packages = ros_type.split("/")[0], import_module(f"{__package__}.packages")
        packages.ros_package(package)
        if package not in packages.definitions() and re.fullmatch(r"\w+", package):
            with suppress(ModuleNotFoundError):  # otherwise one of the workspace
                import_module(package)
    return _types[ros_type]


def types_of(package: str) -> dict[str, type]:
    """Return the types of one package that are made, with what its services and actions are made of."""
    return {name: cls for name, cls in sorted(_types.items()) if name.split("/")[0] == package}


def _named_class(ros_type: str, base: type, **members: object) -> type:
    """Make a class that is named, and says where it comes from, as rosidl's does."""
    package, kind, name = ros_type.split("/")
    module = f"{package}.{kind}._{_snake_case(name.partition('_')[0])}"  # FrameGraph_Request: that of FrameGraph
    kind_text = base.__name__
    members |= {"__module__": module, "__doc__": f"{kind_text} class '{name}'.", "ROS_TYPE": ros_type}
    _types[ros_type] = type(name, (base,), members)
    return _types[ros_type]


def _add_field(cls: type[Message], field: Field) -> tuple[str, str, object, Callable | None]:
    """Give the class the property of a field; return the field's row: name, slot, default, maker of a fresh default."""
    slot = f"_{field.name}"
    message_class = message_in(field.slot_type)
    check = checker(field.name, field.slot_type, message_class)
    pack, packed = array_converter(field.slot_type), numeric_array(field.slot_type)

    def assign(self: Message, value: object) -> None:
        if self._check_fields:
            check(value)
        setattr(self, slot, value)

    def assign_numbers(self: Message, value: object) -> None:
        if self._check_fields:
            check(value)
            if isinstance(value, packed):  # kept, not copied; unchecked messages copy
                setattr(self, slot, value)
                return
        setattr(self, slot, pack(value))

    setter = assign if pack is None else assign_numbers
    setattr(cls, field.name, property(attrgetter(slot), setter, doc=f"Message field '{field.name}'."))
    return field.name, slot, *default_value(field, message_class)


def _wire(field: Field) -> tuple[str, type | None, Callable]:
    """Return how a field travels: its slot, the class of value that goes as it is, and received(value) for others."""
    slot_type = field.slot_type
    check = checker(field.name, slot_type, message_in(slot_type))
    as_is = {BasicType("double"): float, BasicType("boolean"): bool, UnboundedString(): str}.get(slot_type)
    plain = _plain_value(slot_type)

    def received(value: object) -> object:
        check(value)
        return plain(value)

    return f"_{field.name}", as_is, received


def _plain_value(slot_type: SlotType) -> Callable[[object], object]:
    """Return the function that makes a value of the field as it comes off the wire, from one that was checked."""
    match slot_type:
        case BasicType("float"):
            return lambda value: array("f", (value,))[0]
        case BasicType("double"):
            return float
        case BasicType("boolean"):
            return bool
        case BasicType("octet"):
            return bytes
        case BasicType():
            return int
        case UnboundedString() | BoundedString():
            return str.__str__  # of an Enum that is a str, too, its text and not its name
        case NamespacedType():
            return copy_message
    pack = array_converter(slot_type)
    if pack is not None:
        return pack if not isinstance(slot_type, Array) else lambda value: pack(value).reshape(-1)
    member = _plain_value(slot_type.value_type)
    return lambda values: [member(value) for value in values]


def message_in(slot_type: SlotType) -> type[Message] | None:
    """Return the class of the message that a field holds, alone or many times; None of a number or a text."""
    value_type = getattr(slot_type, "value_type", slot_type)
    if isinstance(value_type, NamespacedType):
        return type_named("/".join((*value_type.namespaces, value_type.name)))
    return None


def _rebuilt(ros_type: str, values: dict[str, object], check_fields: bool) -> Message:
    """Make a message again from what `Message.__reduce__` took of it."""
    cls = type_named(ros_type)
    message = object.__new__(cls)
    message._check_fields = check_fields
    for name, slot, *_ in cls._FIELDS:
        setattr(message, slot, values[name])
    return message


def _equal(a: object, b: object) -> bool:
    # Upstream calls two arrays equal unless every element differs: a bug, not copied.
    if isinstance(a, np.ndarray) or isinstance(b, np.ndarray):
        return np.array_equal(a, b)
    return a == b


def _field_repr(value: object) -> str:
    return repr(value.tolist()) if isinstance(value, array) else repr(value)


def _snake_case(name: str) -> str:
    """Return a class's name as rosidl names its module: TF2Error -> tf2_error, UInt8 -> u_int8."""
    name = re.sub(r"(.)([A-Z][a-z]+)", r"\1_\2", name)
    return re.sub(r"([a-z0-9])([A-Z])", r"\1_\2", name).lower()
