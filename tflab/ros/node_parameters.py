"""Declare, set and announce a node's parameters.

    declare -> [type, descriptor] -> set: pre-set, on-set (may refuse), post-set callbacks -> /parameter_events

One of the three mixins that Node is made of; see node.py for the other two.
"""

from __future__ import annotations

import warnings
from collections.abc import Callable, Iterable
from typing import Any

from . import distro
from .clock import Clock
from .exceptions import (
    InvalidParameterException,
    InvalidParameterTypeException,
    InvalidParameterValueException,
    ParameterAlreadyDeclaredException,
    ParameterImmutableException,
    ParameterNotDeclaredException,
    ParameterUninitializedException,
)
from .messages import copy_message, rcl_interfaces
from .parameter import Parameter, parameter_value_to_python
from .topic_endpoints import Publisher

__all__ = ["NodeParameters"]

Descriptor = rcl_interfaces.ParameterDescriptor
Result = rcl_interfaces.SetParametersResult
NOTHING_LEFT = (
    "parameter list cannot be empty, this might be due to pre_set_parameters_callback modifying the original "
    "parameters list."
)
WRONG_TYPE = "Wrong parameter type, expected"


class NodeParameters:
    """The part of Node that deals with parameters.

    Borrows of Node: `_clock` and `_parameter_event_publisher` (None before it is made), and
    `get_fully_qualified_name()`, to announce what changed.
    """

    _clock: Clock
    _parameter_event_publisher: Publisher | None

    def _init_parameters(self, overrides: dict[str, Parameter], allow_undeclared: bool) -> None:
        self._parameters: dict[str, Parameter] = {}
        self._descriptors: dict[str, Descriptor] = {}
        self._parameter_overrides = overrides
        self._allow_undeclared_parameters = allow_undeclared
        self._pre_set_parameters_callbacks: list[Callable] = []
        self._on_set_parameters_callbacks: list[Callable] = []
        self._post_set_parameters_callbacks: list[Callable] = []

    # -- declaring ------------------------------------------------------------------

    def declare_parameter(
        self, name: str, value: Any = None, descriptor: Descriptor | None = None, ignore_override: bool = False
    ) -> Parameter:
        """Declare a parameter with its default, and return it with the value it got.

        `value` may be a Parameter.Type, for a parameter without a default.

        Raises:
            ParameterAlreadyDeclaredException, InvalidParameterException: the name is taken, or malformed.
            InvalidParameterTypeException, InvalidParameterValueException: the value is refused.
        """
        if value is None and descriptor is None:
            warnings.warn(
                f"when declaring parameter named '{name}', declaring a parameter only providing its name is "
                "deprecated. You have to either:\n"
                '\t- Pass a name and a default value different to "PARAMETER NOT SET" (and optionally a descriptor).\n'
                "\t- Pass a name and a parameter type.\n"
                "\t- Pass a name and a descriptor with `dynamic_typing=True`",
                stacklevel=2,
            )
            descriptor = Descriptor(dynamic_typing=True)
        if self.has_parameter(name):
            raise ParameterAlreadyDeclaredException([name])
        if not isinstance(name, str) or not name.strip():
            raise InvalidParameterException(name)
        if not isinstance(descriptor, Descriptor | None):
            raise TypeError(f"descriptor must be a ParameterDescriptor, not {descriptor!r}")
        parameter, kind = self._initial(name, value, ignore_override)
        descriptor = _described(name, descriptor, kind)
        if parameter.type_ is not Parameter.Type.NOT_SET:
            result = self._judge([parameter], {name: descriptor}, check_read_only=False)
            if not result.successful and result.reason.startswith(WRONG_TYPE):
                raise InvalidParameterTypeException(parameter, Parameter.Type(descriptor.type).name)
            if not result.successful:
                raise InvalidParameterValueException(name, parameter.value, result.reason)
        self._descriptors[name] = descriptor
        self._store([parameter])
        return parameter

    def declare_parameters(
        self, namespace: str, parameters: Iterable[tuple], ignore_override: bool = False
    ) -> list[Parameter]:
        """Declare several: (name,), (name, value) or (name, value, descriptor), below a namespace."""
        rows = list(parameters)
        for row in rows:
            if not isinstance(row, tuple) or not 1 <= len(row) <= 3 or not isinstance(row[0], str):
                raise TypeError(
                    f"Expected (name,), (name, value) or (name, value, descriptor) for a parameter, not {row!r}"
                )
        prefix = f"{namespace}." if namespace else ""
        taken = [prefix + row[0] for row in rows if self.has_parameter(prefix + row[0])]
        if taken:  # all of them or none
            raise ParameterAlreadyDeclaredException(taken)
        return [self.declare_parameter(prefix + row[0], *row[1:], ignore_override=ignore_override) for row in rows]

    def undeclare_parameter(self, name: str) -> None:
        """Forget a parameter.

        Raises:
            ParameterNotDeclaredException, ParameterImmutableException: there is none, or it is read-only.
        """
        if not self.has_parameter(name):
            raise ParameterNotDeclaredException(name)
        if self._descriptors[name].read_only:
            raise ParameterImmutableException(name)
        self._forget([name])

    def has_parameter(self, name: str) -> bool:
        """Return whether a parameter was declared."""
        return name in self._parameters

    # -- reading ----------------------------------------------------------------------

    def get_parameter(self, name: str) -> Parameter:
        """Return a parameter.

        Raises:
            ParameterNotDeclaredException: nobody declared it.
            ParameterUninitializedException: it was declared without a value, and has none yet.
        """
        if name in self._parameters:
            parameter = self._parameters[name]
            if parameter.type_ is Parameter.Type.NOT_SET and not self._descriptors[name].dynamic_typing:
                raise ParameterUninitializedException(name)
            return parameter
        if self._allow_undeclared_parameters:
            return Parameter(name, Parameter.Type.NOT_SET, None)
        raise ParameterNotDeclaredException(name)

    def get_parameters(self, names: Iterable[str]) -> list[Parameter]:
        """Return several parameters."""
        names = list(names)
        if not all(isinstance(name, str) for name in names):
            raise TypeError("All names must be instances of type str")
        return [self.get_parameter(name) for name in names]

    def get_parameter_or(self, name: str, alternative_value: Parameter | None = None) -> Parameter:
        """Return a parameter, or the alternative if there is none or it has no value."""
        if alternative_value is None:
            alternative_value = Parameter(name, Parameter.Type.NOT_SET)
        parameter = self._parameters.get(name)
        if parameter is None or parameter.type_ is Parameter.Type.NOT_SET:
            return alternative_value
        return parameter

    def get_parameters_by_prefix(self, prefix: str) -> dict[str, Parameter]:
        """Return the parameters below a prefix, by the rest of their names."""
        prefix = f"{prefix}." if prefix else ""
        return {name[len(prefix) :]: each for name, each in self._parameters.items() if name.startswith(prefix)}

    def get_parameter_type(self, name: str) -> Parameter.Type:
        """Return the type of a parameter."""
        return self._parameters[name].type_ if self.has_parameter(name) else self.get_parameter(name).type_

    def get_parameter_types(self, names: Iterable[str]) -> list[Parameter.Type]:
        """Return the types of several parameters."""
        return [self.get_parameter_type(name) for name in names]

    def describe_parameter(self, name: str) -> Descriptor:
        """Return what is known of a parameter besides its value."""
        if name in self._descriptors:
            return self._descriptors[name]
        if self._allow_undeclared_parameters:
            return Descriptor()
        raise ParameterNotDeclaredException(name)

    def describe_parameters(self, names: Iterable[str]) -> list[Descriptor]:
        """Return what is known of several parameters besides their values."""
        return [self.describe_parameter(name) for name in names]

    def set_descriptor(self, name: str, descriptor: Descriptor, alternative_value: Any = None) -> Any:
        """Replace what is known of a parameter; return its value."""
        if not self.has_parameter(name):
            raise ParameterNotDeclaredException(name)
        if self._descriptors[name].read_only:
            raise ParameterImmutableException(name)
        descriptor = copy_message(descriptor)
        descriptor.name = name
        if not descriptor.dynamic_typing and not descriptor.type:
            descriptor.type = self._parameters[name].type_.value
        parameter = self._parameters[name]
        if alternative_value is not None:
            parameter = Parameter(name, value=parameter_value_to_python(alternative_value))
        result = self._judge([parameter], {name: descriptor}, check_read_only=False)
        if not result.successful:
            raise InvalidParameterValueException(name, parameter.value, result.reason)
        self._descriptors[name] = descriptor
        self._store([parameter])
        return parameter.get_parameter_value()

    def list_parameters(self, prefixes: list[str], depth: int) -> rcl_interfaces.ListParametersResult:
        """Return the names below some prefixes (all if none), down to a depth (0 for all)."""
        names = []
        for name in self._parameters:
            rests = [name] if not prefixes else _rests(name, prefixes)
            if any(depth == 0 or rest.count(".") < depth for rest in rests):
                names.append(name)
        above = sorted({name.rpartition(".")[0] for name in names if "." in name})
        return rcl_interfaces.ListParametersResult(names=names, prefixes=above)

    # -- setting ------------------------------------------------------------------------

    def set_parameters(self, parameter_list: list[Parameter]) -> list[Result]:
        """Set parameters one by one; return whether each was accepted, and if not, why.

        Raises:
            ParameterNotDeclaredException: nobody declared one of them; those before it are set.
        """
        return [self.set_parameters_atomically([parameter]) for parameter in parameter_list]

    def set_parameters_atomically(self, parameter_list: list[Parameter]) -> Result:
        """Set parameters all together or not at all; return whether they were accepted, and if not, why.

        A dynamically typed parameter that is set to nothing (Parameter.Type.NOT_SET) is undeclared by that.
        """
        for parameter in parameter_list:
            if not isinstance(parameter, Parameter):
                raise TypeError("parameter must be instance of type Parameter")
        for callback in self._pre_set_parameters_callbacks:
            parameter_list = callback(parameter_list)
        if self._pre_set_parameters_callbacks and not parameter_list:
            return Result(successful=False, reason=NOTHING_LEFT)
        for parameter in parameter_list:
            if not self.has_parameter(parameter.name):
                if not self._allow_undeclared_parameters:
                    raise ParameterNotDeclaredException([parameter.name])
                self._descriptors[parameter.name] = Descriptor(name=parameter.name, dynamic_typing=True)
        result = self._judge(parameter_list, self._descriptors, check_read_only=True)
        if result.successful:
            self._store([each for each in parameter_list if each.type_ is not Parameter.Type.NOT_SET])
            self._forget([each.name for each in parameter_list if each.type_ is Parameter.Type.NOT_SET])
            for callback in self._post_set_parameters_callbacks:
                callback(parameter_list)
        return result

    def add_pre_set_parameters_callback(self, callback: Callable[[list[Parameter]], list[Parameter]]) -> None:
        """Let `callback(parameters)` change what is to be set; the last one added is asked first."""
        text = "'Node' object has no attribute 'add_pre_set_parameters_callback'"
        distro.require("node_has_set_callbacks", AttributeError, text)
        self._pre_set_parameters_callbacks.insert(0, callback)

    def add_on_set_parameters_callback(self, callback: Callable[[list[Parameter]], Result]) -> None:
        """Let `callback(parameters)` accept or refuse; the last one added is asked first."""
        self._on_set_parameters_callbacks.insert(0, callback)

    def add_post_set_parameters_callback(self, callback: Callable[[list[Parameter]], None]) -> None:
        """Have `callback(parameters)` called after they were set; the last one added comes first."""
        text = "'Node' object has no attribute 'add_post_set_parameters_callback'"
        distro.require("node_has_set_callbacks", AttributeError, text)
        self._post_set_parameters_callbacks.insert(0, callback)

    def remove_pre_set_parameters_callback(self, callback: Callable) -> None:
        """Forget such a callback."""
        self._pre_set_parameters_callbacks.remove(callback)

    def remove_on_set_parameters_callback(self, callback: Callable) -> None:
        """Forget such a callback."""
        self._on_set_parameters_callbacks.remove(callback)

    def remove_post_set_parameters_callback(self, callback: Callable) -> None:
        """Forget such a callback."""
        self._post_set_parameters_callbacks.remove(callback)

    # -- inside -------------------------------------------------------------------------

    def _initial(self, name: str, value: Any, ignore_override: bool) -> tuple[Parameter, Parameter.Type]:
        """Return a new parameter with its first value, and the type it was declared with."""
        if isinstance(value, Parameter.Type):
            kind, parameter = value, Parameter(name, Parameter.Type.NOT_SET)
        else:
            if isinstance(value, rcl_interfaces.ParameterValue):
                value = parameter_value_to_python(value)
            parameter = Parameter(name, value=value)
            kind = parameter.type_
        override = None if ignore_override else self._parameter_overrides.get(name)
        return (parameter if override is None else override), kind

    def _judge(self, parameters: list[Parameter], descriptors: dict[str, Descriptor], check_read_only: bool) -> Result:
        """Return whether descriptors and on-set callbacks accept the values."""
        for parameter in parameters:
            reason = _fault(parameter, descriptors[parameter.name], check_read_only)
            if reason:
                return Result(successful=False, reason=reason)
        for callback in self._on_set_parameters_callbacks:
            result = callback(parameters)
            if not result.successful:
                return result
        return Result(successful=True)

    def _store(self, parameters: list[Parameter]) -> None:
        new = [each for each in parameters if each.name not in self._parameters]
        changed = [each for each in parameters if each.name in self._parameters]
        self._parameters.update({each.name: each for each in parameters})
        if parameters:
            self._announce(new=new, changed=changed)

    def _forget(self, names: list[str]) -> None:
        deleted = [self._parameters.pop(name) for name in names if name in self._parameters]
        for name in names:
            self._descriptors.pop(name, None)
        if deleted:
            self._announce(deleted=deleted)

    def _announce(
        self, new: Iterable[Parameter] = (), changed: Iterable[Parameter] = (), deleted: Iterable[Parameter] = ()
    ) -> None:
        if self._parameter_event_publisher is None:
            return
        event = rcl_interfaces.ParameterEvent(
            stamp=self._clock.now().to_msg(),
            node=self.get_fully_qualified_name(),
            new_parameters=[each.to_parameter_msg() for each in new],
            changed_parameters=[each.to_parameter_msg() for each in changed],
            deleted_parameters=[each.to_parameter_msg() for each in deleted],
        )
        self._parameter_event_publisher.publish(event)


def _described(name: str, descriptor: Descriptor | None, kind: Parameter.Type) -> Descriptor:
    """Return the descriptor of a new parameter: a copy of what was given, with its name and, if fixed, its type."""
    descriptor = Descriptor() if descriptor is None else copy_message(descriptor)
    descriptor.name = name
    if descriptor.dynamic_typing:
        return descriptor
    if kind is Parameter.Type.NOT_SET and descriptor.type:
        kind = Parameter.Type(descriptor.type)
    if kind is Parameter.Type.NOT_SET:
        raise ValueError(
            f"Static typing: cannot declare parameter '{name}' without a value or a type; give one, or a "
            "descriptor with dynamic_typing=True"
        )
    descriptor.type = kind.value
    return descriptor


def _fault(parameter: Parameter, descriptor: Descriptor, check_read_only: bool) -> str:
    """Return why a descriptor refuses a value, "" if it does not."""
    if check_read_only and descriptor.read_only:
        return f"Trying to set a read-only parameter: {parameter.name}."
    if not descriptor.dynamic_typing and parameter.type_ is Parameter.Type.NOT_SET:
        return "Static parameter cannot be undeclared"
    if not descriptor.dynamic_typing and descriptor.type != parameter.type_.value:
        return f"{WRONG_TYPE} '{Parameter.Type(descriptor.type)}' got '{parameter.type_}'"
    if parameter.type_ is Parameter.Type.INTEGER and descriptor.integer_range:
        return _fault_in_range(parameter, descriptor.integer_range[0], 0)
    if parameter.type_ is Parameter.Type.DOUBLE and descriptor.floating_point_range:
        return _fault_in_range(parameter, descriptor.floating_point_range[0], 1e-9)
    return ""


def _fault_in_range(parameter: Parameter, limits: Any, tolerance: float) -> str:
    value, low, high, step = parameter.value, limits.from_value, limits.to_value, limits.step
    at_end = abs(value - low) <= tolerance or abs(value - high) <= tolerance
    if at_end:
        return ""
    if not low <= value <= high:
        return f"Parameter {parameter.name} out of range. Min: {low}, Max: {high}, value: {value}"
    if step:
        steps = (value - low) / step
        if abs(steps - round(steps)) * step > max(tolerance, 0):
            return (
                f"The parameter value for {parameter.name} is not a valid step. Min: {low}, max: {high}, value: "
                f"{value}, step: {step}"
            )
    return ""


def _rests(name: str, prefixes: list[str]) -> list[str]:
    """Return what remains of a name below each prefix that it is below."""
    return [
        "" if name == prefix else name[len(prefix) + 1 :]
        for prefix in prefixes
        if name == prefix or name.startswith(f"{prefix}.")
    ]
