"""Define rclpy's exceptions, with its texts."""

from __future__ import annotations

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


class InvalidHandle(Exception):
    """Something destroyed was used."""


class RCLError(RuntimeError):
    """The library below rclpy refused."""


class RCLInvalidROSArgsError(RCLError):
    """Something after `--ros-args` is malformed."""


class UnknownROSArgsError(RuntimeError):
    """Something after `--ros-args` is not known; the text is the list of it."""


class NotInitializedException(Exception):
    """rclpy.init() has not been called, or its context was shut down."""

    def __init__(self, *args: object) -> None:
        super().__init__("rclpy.init() has not been called. msg:" + (str(args[0]) if args else ""))


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

    def __init__(self, name: str, error_msg: str, invalid_index: int) -> None:
        super().__init__("namespace", name, error_msg, invalid_index)


class InvalidNodeNameException(NameValidationException):
    """A node's name is malformed."""

    def __init__(self, name: str, error_msg: str, invalid_index: int) -> None:
        super().__init__("node name", name, error_msg, invalid_index)


class InvalidTopicNameException(NameValidationException):
    """A topic's name is malformed."""

    def __init__(self, name: str, error_msg: str, invalid_index: int) -> None:
        super().__init__("topic name", name, error_msg, invalid_index)


class InvalidServiceNameException(NameValidationException):
    """A service's name is malformed."""

    def __init__(self, name: str, error_msg: str, invalid_index: int) -> None:
        super().__init__("service name", name, error_msg, invalid_index)


class ParameterException(Exception):
    """Something about parameters; `args` are the text and the names."""

    def __init__(self, error_msg: str, parameters: object) -> None:
        names = parameters if isinstance(parameters, str) else list(parameters)
        super().__init__(f"{error_msg}: {names}")


class ParameterNotDeclaredException(ParameterException):
    """A parameter was used that nobody declared."""

    def __init__(self, parameters: object) -> None:
        super().__init__("Invalid access to undeclared parameter(s)", parameters)


class ParameterAlreadyDeclaredException(ParameterException):
    """A parameter was declared twice."""

    def __init__(self, parameters: object) -> None:
        super().__init__("Parameter(s) already declared", parameters)


class InvalidParameterException(ParameterException):
    """A parameter's name is malformed."""

    def __init__(self, parameter: str) -> None:
        super().__init__("Invalid parameter name", parameter)


class InvalidParameterTypeException(ParameterException):
    """A parameter was given a value of another type than it was declared with."""

    def __init__(self, desired_parameter: object, expected_type: object) -> None:
        Exception.__init__(
            self,
            f"Trying to set parameter '{desired_parameter.name}' to '{desired_parameter.value}' of type "
            f"'{desired_parameter.type_.name}', expecting type '{getattr(expected_type, 'name', expected_type)}'",
        )
        self.param_name = desired_parameter.name


class InvalidParameterValueException(ParameterException):
    """A parameter was given a value that its descriptor, or a callback, rejects."""

    def __init__(self, parameter: str, value: object, reason: str) -> None:
        Exception.__init__(self, f"Invalid parameter value ({value}) for parameter '{parameter}'. Reason: {reason}")


class ParameterImmutableException(ParameterException):
    """A read-only parameter was to be changed."""

    def __init__(self, parameter: str) -> None:
        super().__init__("Attempted to modify read-only parameter", parameter)


class ParameterUninitializedException(ParameterException):
    """A parameter that was declared with a type but no value was read."""

    def __init__(self, parameter: str) -> None:
        Exception.__init__(self, f"The parameter '{parameter}' is not initialized")


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
for _class in (RCLError, RCLInvalidROSArgsError, UnknownROSArgsError):
    _class.__module__ = "rclpy._rclpy_pybind11"
for _class in (ConditionReachedException, ExternalShutdownException, ShutdownException, TimeoutException):
    _class.__module__ = "rclpy.executors"
