"""Run `ros2 lifecycle nodes`, `get`, `list` and `set`.

    ros2 lifecycle get /camera                unconfigured [1]
    ros2 lifecycle set /camera configure      Transitioning successful

A managed node is one that answers `~/get_state`.
upstream: ros2cli/ros2lifecycle.
"""

from __future__ import annotations

import argparse
import sys
from typing import Any

from tflab.ros.messages import lifecycle_msgs
from tflab.ros.node import Node

from .discovery import add_verb, visible
from .node import NOT_FOUND, absolute_name, full_names
from .session import call_service, cli_node

__all__ = ["add_verbs", "managed_nodes"]

GET_STATE = "lifecycle_msgs/srv/GetState"


def add_verbs(verbs: argparse._SubParsersAction) -> None:
    """Add the verbs of `ros2 lifecycle` to a parser."""
    verb = add_verb(verbs, "get", "Get lifecycle state for one or more nodes", get)
    verb.add_argument(
        "node_name", nargs="?",
        help="Name of the ROS node. If no name is provided, then get the state for all nodes.",
    )  # fmt: skip
    _consider_hidden(verb)
    verb = add_verb(verbs, "list", "Output a list of available transitions", list_transitions)
    verb.add_argument("node_name", help="Name of the ROS node")
    verb.add_argument("-a", "--all", action="store_true", help="Display all existing transitions")
    _consider_hidden(verb)
    verb = add_verb(verbs, "nodes", "Output a list of nodes with lifecycle", list_nodes)
    verb.add_argument("-a", "--all", action="store_true", help="Display all nodes even hidden ones")
    verb.add_argument("-c", "--count-nodes", action="store_true", help="Only display the number of nodes discovered")
    verb = add_verb(verbs, "set", "Trigger lifecycle state transition", set_state)
    verb.add_argument("node_name", help="Name of the ROS node")
    verb.add_argument("transition", help="The lifecycle transition")
    _consider_hidden(verb)


def _consider_hidden(verb: argparse.ArgumentParser) -> None:
    verb.add_argument("--include-hidden-nodes", action="store_true", help="Consider hidden nodes as well")


def managed_nodes(node: Node, hidden: bool = False) -> list[str]:
    """Return the full names of the nodes that have a life cycle, sorted."""
    services = {name for name, types in visible(node.get_service_names_and_types(), hidden) if GET_STATE in types}
    return [
        name for name in full_names(node.get_node_names_and_namespaces(), hidden) if f"{name}/get_state" in services
    ]


def list_nodes(options: argparse.Namespace) -> None:
    """Print the managed nodes."""
    with cli_node() as node:
        names = managed_nodes(node, options.all)
    if options.count_nodes:
        print(len(names))
    elif names:
        print("\n".join(names))


def get(options: argparse.Namespace) -> str | None:
    """Print the state of one managed node, or of each."""
    with cli_node() as node:
        names = managed_nodes(node, options.include_hidden_nodes)
        if options.node_name is None:
            for name in names:
                print(f"{name}: {_state_of(node, name)}")
            return None
        wanted = absolute_name(options.node_name)
        if wanted not in names:
            return NOT_FOUND
        print(_state_of(node, wanted))
    return None


def list_transitions(options: argparse.Namespace) -> str | None:
    """Print what can be done with a managed node now, or ever."""
    with cli_node() as node:
        wanted = absolute_name(options.node_name)
        if wanted not in managed_nodes(node, options.include_hidden_nodes):
            return NOT_FOUND
        for each in _transitions(node, wanted, "get_transition_graph" if options.all else "get_available_transitions"):
            print(f"- {each.transition.label} [{each.transition.id}]")
            print(f"\tStart: {each.start_state.label}\n\tGoal: {each.goal_state.label}")
    return None


def set_state(options: argparse.Namespace) -> str | None:
    """Move a managed node on: by the label of a transition, or its number."""
    with cli_node() as node:
        wanted = absolute_name(options.node_name)
        if wanted not in managed_nodes(node, options.include_hidden_nodes):
            return NOT_FOUND
        transitions = [each.transition for each in _transitions(node, wanted, "get_available_transitions")]
        by_label = [transition for transition in transitions if transition.label == options.transition]
        by_number = [transition for transition in transitions if str(transition.id) == options.transition]
        if not by_label + by_number:
            there = "".join(f"\n- {transition.label} [{transition.id}]" for transition in transitions)
            return f"Unknown transition requested, available ones are:{there}"
        request = lifecycle_msgs.ChangeState.Request(transition=(by_label + by_number)[0])
        if call_service(node, lifecycle_msgs.ChangeState, f"{wanted}/change_state", request).success:
            print("Transitioning successful")
        else:
            print("Transitioning failed", file=sys.stderr)
    return None


def _state_of(node: Node, name: str) -> str:
    """Return the state of a managed node as upstream prints it: 'active [3]'."""
    request = lifecycle_msgs.GetState.Request()
    state = call_service(node, lifecycle_msgs.GetState, f"{name}/get_state", request).current_state
    return f"{state.label} [{state.id}]"


def _transitions(node: Node, name: str, service: str) -> list[Any]:
    """Return the transitions that a managed node has, by the service that is asked."""
    srv_type = lifecycle_msgs.GetAvailableTransitions
    return list(call_service(node, srv_type, f"{name}/{service}", srv_type.Request()).available_transitions)
