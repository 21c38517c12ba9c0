"""Run `ros2 service list`, `type` and `call`.

    ros2 service call /add_two_ints example_interfaces/srv/AddTwoInts "{a: 1, b: 2}"

upstream: ros2cli/ros2service.
"""

from __future__ import annotations

import argparse
from collections.abc import Callable

import yaml

from tflab.ros.messages import type_named
from tflab.ros.messages.base import is_service_class
from tflab.ros.messages.values import fill

from .discovery import add_verb, full_type_name, visible
from .session import answer_of, cli_node, spin_for
from .topic_pub import positive_float

__all__ = ["add_verbs", "service_class"]


def add_verbs(verbs: argparse._SubParsersAction) -> None:
    """Add the verbs of `ros2 service` to a parser."""
    verb = add_verb(verbs, "call", "Call a service", call, looks_around=False)
    verb.add_argument("service_name", help="Name of the ROS service to call to (e.g. '/add_two_ints')")
    verb.add_argument("service_type", help="Type of the ROS service (e.g. 'std_srvs/srv/Empty')")
    verb.add_argument(
        "values", nargs="?", default="{}",
        help="Values to fill the service request with in YAML format (e.g. '{a: 1, b: 2}'), otherwise the service "
             "request will be published with default values",
    )  # fmt: skip
    verb.add_argument("-r", "--rate", metavar="N", type=positive_float, help="Repeat the call at a specific rate in Hz")
    verb = _looking_verb(verbs, "list", "Output a list of available services", list_services)
    verb.add_argument("-t", "--show-types", action="store_true", help="Additionally show the service type")
    verb.add_argument(
        "-c", "--count-services", action="store_true", help="Only display the number of services discovered"
    )
    verb = _looking_verb(verbs, "type", "Output a service's type", print_type)
    verb.add_argument("service_name", help="Name of the ROS service to get type (e.g. '/talker/list_parameters')")


def _looking_verb(verbs: argparse._SubParsersAction, name: str, what: str, run: Callable) -> argparse.ArgumentParser:
    verb = add_verb(verbs, name, what, run)
    verb.add_argument("--include-hidden-services", action="store_true", help="Consider hidden services as well")
    return verb


def service_class(type_name: str) -> type:
    """Return the class of a service type: 'std_srvs/srv/Empty', or 'std_srvs/Empty'.

    Raises:
        RuntimeError: there is none of that name, with upstream's text.
    """
    try:
        found = type_named(full_type_name(type_name, "srv"))
    except KeyError:
        raise RuntimeError("The passed service type is invalid") from None
    if not is_service_class(found):
        raise RuntimeError("The passed type is not a service")
    return found


def call(options: argparse.Namespace) -> str | None:
    """Ask a service, once or again and again, and print what it answers."""
    service_type = service_class(options.service_type)
    request = service_type.Request()
    try:
        fill(request, yaml.safe_load(options.values))
    except Exception as fault:  # upstream's sentence, whatever went wrong
        return f"Failed to populate field: {fault}"
    with cli_node() as node:
        client = node.create_client(service_type, options.service_name)
        if not client.service_is_ready():
            print("waiting for service to become available...", flush=True)
            client.wait_for_service()
        while True:
            print(f"requester: making request: {request!r}\n", flush=True)
            print(f"response:\n{answer_of(node, client.call_async(request))!r}\n", flush=True)
            if options.rate is None:
                return None
            spin_for(node, 1.0 / options.rate)


def list_services(options: argparse.Namespace) -> None:
    """Print the services."""
    with cli_node() as node:
        services = visible(node.get_service_names_and_types(), options.include_hidden_services)
    if options.count_services:
        print(len(services))
        return
    for name, types in services:
        print(f"{name} [{', '.join(types)}]" if options.show_types else name)


def print_type(options: argparse.Namespace) -> int:
    """Print the type of a service; return 1 if there is none of that name."""
    with cli_node() as node:
        services = dict(visible(node.get_service_names_and_types(), options.include_hidden_services))
    for type_name in services.get(options.service_name, ()):
        print(type_name)
    return 0 if options.service_name in services else 1
