"""Run `ros2 node list` and `ros2 node info`.

upstream: ros2cli/ros2node.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence

from tflab.ros.action_goals import (
    get_action_client_names_and_types_by_node,
    get_action_server_names_and_types_by_node,
)

from .discovery import add_verb, visible
from .session import cli_node

__all__ = ["NOT_FOUND", "absolute_name", "add_verbs", "duplicates_warning", "full_names", "info_text"]

SAME_NAME = (
    "WARNING: Be aware that there are nodes in the graph that share an exact name, "
    "which can have unintended side effects."
)
NOT_FOUND = "Node not found"  # what `param` and `lifecycle` say
SECTIONS = ("Subscribers", "Publishers", "Service Servers", "Service Clients", "Action Servers", "Action Clients")


def add_verbs(verbs: argparse._SubParsersAction) -> None:
    """Add the verbs of `ros2 node` to a parser."""
    verb = add_verb(verbs, "info", "Output information about a node", info)
    verb.add_argument("node_name", help="Fully qualified node name to request information")
    verb.add_argument(
        "--include-hidden", action="store_true", help="Display hidden topics, services, and actions as well"
    )
    verb = add_verb(verbs, "list", "Output a list of available nodes", list_nodes)
    verb.add_argument("-a", "--all", action="store_true", help="Display all nodes even hidden ones")
    verb.add_argument("-c", "--count-nodes", action="store_true", help="Only display the number of nodes discovered")


def full_names(names_and_namespaces: Sequence[tuple[str, str]], hidden: bool = False) -> list[str]:
    """Return the full names of nodes, sorted; of hidden ones, whose name begins with "_", only if asked."""
    shown = [pair for pair in names_and_namespaces if hidden or not pair[0].startswith("_")]
    return sorted(f"{namespace.rstrip('/')}/{name}" for name, namespace in shown)


def absolute_name(name: str) -> str:
    """Return the full name of a node that was typed without its leading slash, or with it."""
    return name if name.startswith("/") else f"/{name}"


def duplicates_warning(names: Sequence[str]) -> str:
    """Return the warning that two nodes share a name, or ""."""
    return SAME_NAME if len(set(names)) < len(names) else ""


def info_text(name: str, sections: Sequence[Sequence[tuple[str, Sequence[str]]]]) -> str:
    """Return what `info` prints of a node; `sections` as in SECTIONS, each (name, types) of what there is."""
    lines = [name]
    for heading, entries in zip(SECTIONS, sections, strict=True):
        lines.append(f"  {heading}:")
        lines.append("\n".join(f"    {entry}: {', '.join(types)}" for entry, types in entries))
    return "\n".join(lines)


def list_nodes(options: argparse.Namespace) -> None:
    """Print the nodes."""
    with cli_node() as node:
        names = full_names(node.get_node_names_and_namespaces(), options.all)
        if options.count_nodes:
            print(len(names))
            return
        if duplicates_warning(names):
            print(duplicates_warning(names), file=sys.stderr)
        if names:
            print("\n".join(names))


def info(options: argparse.Namespace) -> str | None:
    """Print what a node publishes, listens to and serves."""
    wanted = options.node_name
    with cli_node() as node:
        count = full_names(node.get_node_names_and_namespaces(), options.include_hidden).count(wanted)
        if count == 0:
            return f"Unable to find node '{wanted}'"
        if count > 1:
            print(
                f'There are {count} nodes in the graph with the exact name "{wanted}". '
                "You are seeing information about only one of them.",
                file=sys.stderr,
            )
        namespace, _, name = wanted.rpartition("/")
        ask = (
            node.get_subscriber_names_and_types_by_node,
            node.get_publisher_names_and_types_by_node,
            node.get_service_names_and_types_by_node,
            node.get_client_names_and_types_by_node,
        )
        found = [question(name, namespace or "/") for question in ask]
        sections = [visible(names, options.include_hidden) for names in found]
        ask_actions = (get_action_server_names_and_types_by_node, get_action_client_names_and_types_by_node)
        sections += [question(node, name, namespace or "/") for question in ask_actions]
        print(info_text(wanted, sections))
    return None
