"""Run `ros2 param get`, `set` and `list`, through the services that every node has.

    ros2 param set /point_to_map use_sim_time true
        -> request to /point_to_map/set_parameters -> "Set parameter successful"

A value is read as YAML: `true` is a bool, `1.0` a double, `'1.0'` a string.
upstream: ros2cli/ros2param.
"""

from __future__ import annotations

import argparse
import sys
from typing import Any

import yaml

from tflab.ros.node import Node

from .discovery import add_verb
from .node import NOT_FOUND, absolute_name, full_names
from .session import call_service, cli_node

__all__ = ["add_verbs", "python_value", "value_text"]

# type number of rcl_interfaces/msg/ParameterType -> label, field of ParameterValue
KINDS = {
    1: ("Boolean value is:", "bool_value"),
    2: ("Integer value is:", "integer_value"),
    3: ("Double value is:", "double_value"),
    4: ("String value is:", "string_value"),
    5: ("Byte values are:", "byte_array_value"),
    6: ("Boolean values are:", "bool_array_value"),
    7: ("Integer values are:", "integer_array_value"),
    8: ("Double values are:", "double_array_value"),
    9: ("String values are:", "string_array_value"),
}
NUMBERS = {bool: 1, int: 2, float: 3, str: 4}


def add_verbs(verbs: argparse._SubParsersAction) -> None:
    """Add the verbs of `ros2 param` to a parser."""
    verb = _add(verbs, "get", "Get parameter", get)
    verb.add_argument("parameter_name", help="Name of the parameter")
    verb.add_argument("--hide-type", action="store_true", help="Hide the type information")
    verb = _add(verbs, "list", "Output a list of available parameters", list_parameters, nargs="?")
    verb.add_argument("--param-prefixes", nargs="+", default=[], help="Only list parameters with the provided prefixes")
    verb = _add(verbs, "set", "Set parameter", set_parameter)
    verb.add_argument("parameter_name", help="Name of the parameter")
    verb.add_argument("value", help="Value of the parameter")


def _add(verbs: argparse._SubParsersAction, name: str, what: str, run, nargs=None) -> argparse.ArgumentParser:
    verb = add_verb(verbs, name, what, run)
    verb.add_argument("node_name", nargs=nargs, help="Name of the ROS node")
    verb.add_argument("--include-hidden-nodes", action="store_true", help="Consider hidden nodes as well")
    return verb


def python_value(text: str) -> Any:
    """Return the value that `text` means in YAML, as long as it can be a parameter; else the text itself."""
    try:
        value = yaml.safe_load(text)
    except yaml.YAMLError:
        return text
    if type(value) in NUMBERS:
        return value
    if isinstance(value, list) and value and type(value[0]) in NUMBERS and len({type(item) for item in value}) == 1:
        return value
    return text


def parameter_value(text: str):
    """Return the rcl_interfaces/msg/ParameterValue that `text` means in YAML."""
    from tflab.ros.messages.rcl_interfaces import ParameterValue

    value = python_value(text)
    number = 5 + NUMBERS[type(value[0])] if isinstance(value, list) else NUMBERS[type(value)]
    return ParameterValue(type=number, **{KINDS[number][1]: value})


def value_text(value, hide_type: bool = False) -> str:
    """Return what `get` prints of an rcl_interfaces/msg/ParameterValue that is set."""
    label, field = KINDS[value.type]
    shown = getattr(value, field)
    shown = shown.tolist() if hasattr(shown, "tolist") else shown
    return str(shown) if hide_type else f"{label} {shown}"


def get(options: argparse.Namespace) -> str | None:
    """Print the value of a parameter."""
    from tflab.ros.messages.rcl_interfaces import GetParameters

    with cli_node() as node:
        name = absolute_name(options.node_name)
        if not _exists(node, name, options):
            return NOT_FOUND
        request = GetParameters.Request(names=[options.parameter_name])
        values = call_service(node, GetParameters, f"{name}/get_parameters", request).values
        if not values:
            return "Parameter not set"
        if values[0].type not in KINDS:
            print("Parameter not set.")
        else:
            print(value_text(values[0], options.hide_type))
    return None


def set_parameter(options: argparse.Namespace) -> str | None:
    """Set a parameter, and print whether the node took it."""
    from tflab.ros.messages.rcl_interfaces import Parameter, SetParameters

    with cli_node() as node:
        name = absolute_name(options.node_name)
        if not _exists(node, name, options):
            return NOT_FOUND
        parameter = Parameter(name=options.parameter_name, value=parameter_value(options.value))
        request = SetParameters.Request(parameters=[parameter])
        (result,) = call_service(node, SetParameters, f"{name}/set_parameters", request).results
        reason = f": {result.reason}" if result.reason else ""
        if result.successful:
            print(f"Set parameter successful{reason}")
        else:
            print(f"Setting parameter failed{reason}", file=sys.stderr)
    return None


def list_parameters(options: argparse.Namespace) -> str | None:
    """Print the names of the parameters of one node, or of all."""
    from tflab.ros.messages.rcl_interfaces import ListParameters

    with cli_node() as node:
        names = full_names(node.get_node_names_and_namespaces(), options.include_hidden_nodes)
        if options.node_name is not None:
            if absolute_name(options.node_name) not in names:
                return NOT_FOUND
            names = [absolute_name(options.node_name)]
        served = dict(node.get_service_names_and_types())
        for name in dict.fromkeys(names):
            if f"{name}/list_parameters" not in served:
                continue
            request = ListParameters.Request(prefixes=options.param_prefixes)
            found = call_service(node, ListParameters, f"{name}/list_parameters", request).result.names
            if options.node_name is None:
                print(f"{name}:")
            print("\n".join(f"  {parameter}" for parameter in sorted(found)))
    return None


def _exists(node: Node, name: str, options: argparse.Namespace) -> bool:
    return name in full_names(node.get_node_names_and_namespaces(), options.include_hidden_nodes)
