"""Define rclpy's exceptions, with its texts."""

from __future__ import annotations

from functools import partialmethod
from typing import Any

from .distro import current

__all__ = [
    "ConditionReachedException",
    "ExternalShutdownException",
    "InvalidHandle",
    "InvalidNamespaceException",
    "InvalidNodeNameException",
    "InvalidParameterException",
    "InvalidParameterTypeException",
    "InvalidParameterValueException",
    "InvalidServiceNameException",
    "InvalidTopicNameException",
    "NameValidationException",
    "NoTypeSupportImportedException",
    "NotInitializedException",
    "ParameterAlreadyDeclaredException",
    "ParameterException",
    "ParameterImmutableException",
    "ParameterNotDeclaredException",
    "ParameterUninitializedException",
    "RCLError",
    "RCLInvalidROSArgsError",
    "ROSInterruptException",
    "ShutdownException",
    "TimeoutException",
    "UnknownROSArgsError",
]


class InvalidHandle(RuntimeError):
    """Something destroyed was used."""


class RCLError(RuntimeError):
    """The library below rclpy refused."""


class RCLInvalidROSArgsError(RCLError):
    """Something after `--ros-args` is malformed."""


class UnknownROSArgsError(RuntimeError):
    """Something after `--ros-args` is not known; the text is the list of it."""


class NotInitializedException(Exception):
    """rclpy.init() has not been called, or its context was shut down."""

    def __init__(self, *message: str) -> None:
        text = "rclpy.init() has not been called"
        joined = (text + (f". msg:{message[0]}" if message else "."),)
        super().__init__(*joined if current().errors_join_names else (text, *message))


class NoTypeSupportImportedException(Exception):
    """What was given as a type is not a message or service class."""


class NameValidationException(Exception):
    """A name has a character or a shape that is not allowed; the text points at it."""

    def __init__(self, name_type: str, name: str, error_msg: str, invalid_index: int) -> None:
        super().__init__(f"Invalid {name_type}: {error_msg}:\n  '{name}'\n   {' ' * invalid_index}^")
        self.name_type = name_type
        self.name = name
        self.error_msg = error_msg
        self.invalid_index = invalid_index


class InvalidNamespaceException(NameValidationException):
    """A namespace is malformed."""

    __init__ = partialmethod(NameValidationException.__init__, "namespace")


class InvalidNodeNameException(NameValidationException):
    """A node's name is malformed."""

    __init__ = partialmethod(NameValidationException.__init__, "node name")


class InvalidTopicNameException(NameValidationException):
    """A topic's name is malformed."""

    __init__ = partialmethod(NameValidationException.__init__, "topic name")


class InvalidServiceNameException(NameValidationException):
    """A service's name is malformed."""

    __init__ = partialmethod(NameValidationException.__init__, "service name")


class ParameterException(Exception):
    """Something about parameters: a text and their names, which are one argument since Jazzy."""

    def __init__(self, error_msg: str, parameters: object) -> None:
        super().__init__(*[f"{error_msg}: {parameters}"] if current().errors_join_names else [error_msg, parameters])


class ParameterNotDeclaredException(ParameterException):
    """A parameter was used that nobody declared."""

    __init__ = partialmethod(ParameterException.__init__, "Invalid access to undeclared parameter(s)")


class ParameterAlreadyDeclaredException(ParameterException):
    """A parameter was declared twice."""

    __init__ = partialmethod(ParameterException.__init__, "Parameter(s) already declared")


class InvalidParameterException(ParameterException):
    """A parameter's name is malformed."""

    __init__ = partialmethod(ParameterException.__init__, "Invalid parameter name")


class InvalidParameterTypeException(ParameterException):
    """A parameter was given a value of another type than it was declared with."""

    def __init__(self, desired_parameter: Any, expected_type: str) -> None:
        name, value, kind = desired_parameter.name, desired_parameter.value, desired_parameter.type_.name
        text = f"Trying to set parameter '{name}' to '{value}' of type '{kind}', expecting type '{expected_type}'"
        super().__init__(text, name)
        self.args = self.args[:1]  # Humble's does not have the name


class InvalidParameterValueException(ParameterException):
    """A parameter was given a value that its descriptor, or a callback, rejects."""

    def __init__(self, parameter: str, value: object, reason: str) -> None:
        super().__init__(f"Invalid parameter value ({value}) for parameter. Reason: {reason}", parameter)


class ParameterImmutableException(ParameterException):
    """A read-only parameter was to be changed."""

    __init__ = partialmethod(ParameterException.__init__, "Attempted to modify read-only parameter")


class ParameterUninitializedException(ParameterException):
    """A parameter that was declared with a type but no value was read."""

    def __init__(self, parameter: str) -> None:
        super().__init__(f"The parameter '{parameter}' is not initialized", parameter)
        self.args = self.args[:1]  # Humble's does not have the name


class ROSInterruptException(Exception):
    """The context was shut down while somebody slept."""

    def __init__(self) -> None:
        super().__init__("rclpy.shutdown() has been called")


class TimeoutException(Exception):
    """Nothing was ready in time."""


class ConditionReachedException(Exception):
    """A condition that ends the waiting has come true."""


class ShutdownException(Exception):
    """The executor was shut down."""


class ExternalShutdownException(Exception):
    """The context was shut down by somebody else while this waited."""

    def __init__(self, *args: object) -> None:
        super().__init__("The context was shutdown", *args)


# A traceback names the modules of a robot.
for _name in __all__:
    globals()[_name].__module__ = "rclpy.exceptions"
for _class in (InvalidHandle, RCLError, RCLInvalidROSArgsError, UnknownROSArgsError):
    _class.__module__ = "rclpy._rclpy_pybind11"
for _class in (ConditionReachedException, ExternalShutdownException, ShutdownException, TimeoutException):
    _class.__module__ = "rclpy.executors"
