"""Provide rclpy's Parameter: a name, a type, a value."""

from __future__ import annotations

from array import array
from enum import Enum

from .messages import rcl_interfaces

__all__ = [
    "Parameter",
    "get_parameter_value",
    "parameter_dict_from_yaml_file",
    "parameter_value_to_python",
]


class Parameter:
    """A name with a value of one of nine types, or of none."""

    class Type(Enum):
        """What a value can be."""

        NOT_SET = 0
        BOOL = 1
        INTEGER = 2
        DOUBLE = 3
        STRING = 4
        BYTE_ARRAY = 5
        BOOL_ARRAY = 6
        INTEGER_ARRAY = 7
        DOUBLE_ARRAY = 8
        STRING_ARRAY = 9

        @classmethod
        def from_parameter_value(cls, value: object) -> Parameter.Type:
            """Return the type of a Python value; an empty list is a BYTE_ARRAY, the first that fits.

            Raises:
                TypeError: no type fits.
            """
            for kind in cls:
                if kind.check(value):
                    return kind
            if isinstance(value, (list, tuple, array)):
                raise TypeError(f"The given value is not a list of one of the allowed types '{value}'.")
            raise TypeError(f"The given value is not one of the allowed types '{value}'.")

        def check(self, value: object) -> bool:
            """Return whether a Python value is of this type."""
            if self is Parameter.Type.NOT_SET:
                return value is None
            if self in _SCALARS:
                is_right = isinstance(value, _SCALARS[self])
                return is_right and (self is Parameter.Type.BOOL or not isinstance(value, bool))
            if not isinstance(value, (list, tuple, array)):
                return False
            if self is Parameter.Type.BYTE_ARRAY:
                return all(isinstance(each, bytes) and len(each) == 1 for each in value)
            return all(_MEMBERS[self].check(each) for each in value)

    def __init__(self, name: str, type_: Parameter.Type | None = None, value: object = None) -> None:
        if type_ is None:
            type_ = Parameter.Type.from_parameter_value(value)
        if not isinstance(type_, Parameter.Type):
            raise TypeError(f"type must be an instance of '{Parameter.Type!r}'")
        if not type_.check(value):
            raise ValueError(f"Type '{type_}' and value '{value}' do not agree")
        self._name = name
        self._type = type_
        self._value = value

    @property
    def name(self) -> str:
        """The name."""
        return self._name

    @property
    def type_(self) -> Parameter.Type:
        """The type."""
        return self._type

    @property
    def value(self) -> object:
        """The value, None if it is not set."""
        return self._value

    def __repr__(self) -> str:
        return f"Parameter(name={self._name!r}, type_={self._type!r}, value={self._value!r})"

    @classmethod
    def from_parameter_msg(cls, msg: rcl_interfaces.Parameter) -> Parameter:
        """Return the parameter of a message."""
        kind = Parameter.Type(msg.value.type)
        return cls(msg.name, kind, parameter_value_to_python(msg.value))

    def get_parameter_value(self) -> rcl_interfaces.ParameterValue:
        """Return the value as a message."""
        message = rcl_interfaces.ParameterValue(type=self._type.value)
        if self._type is not Parameter.Type.NOT_SET:
            field = f"{self._type.name.lower()}_value"
            setattr(message, field, list(self._value) if isinstance(self._value, tuple) else self._value)
        return message

    def to_parameter_msg(self) -> rcl_interfaces.Parameter:
        """Return it as a message."""
        return rcl_interfaces.Parameter(name=self._name, value=self.get_parameter_value())


_SCALARS = {
    Parameter.Type.BOOL: bool,
    Parameter.Type.INTEGER: int,
    Parameter.Type.DOUBLE: float,
    Parameter.Type.STRING: str,
}
_MEMBERS = {
    Parameter.Type.BOOL_ARRAY: Parameter.Type.BOOL,
    Parameter.Type.INTEGER_ARRAY: Parameter.Type.INTEGER,
    Parameter.Type.DOUBLE_ARRAY: Parameter.Type.DOUBLE,
    Parameter.Type.STRING_ARRAY: Parameter.Type.STRING,
}


def parameter_value_to_python(message: rcl_interfaces.ParameterValue) -> object:
    """Return the Python value of a message, None if it is not set.

    Raises:
        RuntimeError: its type is none of the nine.
    """
    try:
        kind = Parameter.Type(message.type)
    except ValueError:
        raise RuntimeError(f"Parameter has unknown type: {message.type}") from None
    if kind is Parameter.Type.NOT_SET:
        return None
    value = getattr(message, f"{kind.name.lower()}_value")
    return value if kind in _SCALARS else list(value)


def get_parameter_value(string_value: str) -> rcl_interfaces.ParameterValue:
    """Return the value that a text means, read as YAML; what fits nothing is a string."""
    import yaml  # only where a text says something about parameters

    try:
        value = yaml.safe_load(string_value)
        kind = Parameter.Type.from_parameter_value(value)
    except (yaml.YAMLError, TypeError):
        kind, value = Parameter.Type.STRING, string_value
    if value is None:
        kind, value = Parameter.Type.STRING, string_value
    return Parameter("", kind, value).get_parameter_value()


def parameter_dict_from_yaml_file(
    parameter_file: str,
    use_wildcard: bool = False,
    target_nodes: list[str] | None = None,
    namespace: str = "",
) -> dict[str, rcl_interfaces.Parameter]:
    """Return the parameters of a file as messages, by name.

    Args:
        use_wildcard: whether those of "/**" count; the others override them.
        target_nodes: whose parameters; everybody's if None.
        namespace: put before each name.

    Raises:
        RuntimeError: the file holds nothing for one of them, or is no parameter file.
    """
    import yaml  # only where a text says something about parameters

    with open(parameter_file, encoding="utf-8") as file:
        content = yaml.safe_load(file)
    keys = ["/**"] if use_wildcard and "/**" in content else []
    for node in target_nodes or ():
        if node not in content:
            raise RuntimeError(f"Param file does not contain parameters for {node},only for nodes: {list(content)}")
        keys.append(node)
    if not target_nodes:
        keys += [key for key in content if key != "/**"]
    if not keys:
        raise RuntimeError("Param file does not contain selected parameters")
    found: dict[str, rcl_interfaces.Parameter] = {}
    for key in keys:
        if not isinstance(content[key], dict) or "ros__parameters" not in content[key]:
            raise RuntimeError("YAML file is not a valid ROS parameter file")
        found |= _messages_in(namespace, content[key]["ros__parameters"])
    return found


def _messages_in(prefix: str, values: dict) -> dict[str, rcl_interfaces.Parameter]:
    """Return the parameters of a nested mapping; the names of the levels are joined by dots."""
    found = {}
    for key, value in values.items():
        name = f"{prefix}.{key}" if prefix else str(key)
        if isinstance(value, dict):
            found |= _messages_in(name, value)
        else:
            found[name] = rcl_interfaces.Parameter(name=name, value=get_parameter_value(str(value)))
    return found
