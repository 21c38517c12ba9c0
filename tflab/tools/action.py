"""Run `ros2 action list`, `info` and `send_goal`.

    ros2 action send_goal /fibonacci example_interfaces/action/Fibonacci "{order: 5}" --feedback

upstream: ros2cli/ros2action.
"""

from __future__ import annotations

import argparse
from collections.abc import Callable, Sequence
from typing import Any

import yaml

from tflab.ros.action_client import ActionClient
from tflab.ros.action_goals import (
    get_action_client_names_and_types_by_node,
    get_action_names_and_types,
    get_action_server_names_and_types_by_node,
    goal_key,
    status_name,
)
from tflab.ros.messages import type_named
from tflab.ros.messages.base import Message, is_action_class
from tflab.ros.messages.text import message_to_yaml
from tflab.ros.messages.values import fill
from tflab.ros.node import Node

from .discovery import add_verb
from .session import answer_of, cli_node, tool_node

__all__ = ["action_class", "add_verbs"]


def add_verbs(verbs: argparse._SubParsersAction) -> None:
    """Add the verbs of `ros2 action` to a parser."""
    verb = add_verb(verbs, "info", "Print information about an action", info, looks_around=False)
    verb.add_argument("action_name", help="Name of the ROS action to get info (e.g. '/fibonacci')")
    verb.add_argument("-t", "--show-types", action="store_true", help="Additionally show the action type")
    verb.add_argument(
        "-c", "--count", action="store_true", help="Only display the number of action clients and action servers"
    )
    verb = add_verb(verbs, "list", "Output a list of action names", list_actions, looks_around=False)
    verb.add_argument("-t", "--show-types", action="store_true", help="Additionally show the action type")
    verb.add_argument(
        "-c", "--count-actions", action="store_true", help="Only display the number of actions discovered"
    )
    verb = add_verb(verbs, "send_goal", "Send an action goal", send_goal, looks_around=False)
    verb.add_argument("action_name", help="Name of the ROS action (e.g. '/fibonacci')")
    verb.add_argument("action_type", help="Type of the ROS action (e.g. 'example_interfaces/action/Fibonacci')")
    verb.add_argument("goal", nargs="?", default="{}", help="Goal request values in YAML format (e.g. '{order: 10}')")
    verb.add_argument("-f", "--feedback", action="store_true", help="Echo feedback messages for the goal")


def action_class(type_name: str) -> type:
    """Return the class of an action type: 'example_interfaces/action/Fibonacci'.

    Raises:
        RuntimeError: there is none of that name, with upstream's text.
    """
    try:
        found = type_named(type_name)
    except KeyError:
        found = None
    if not is_action_class(found):
        raise RuntimeError("The passed action type is invalid")
    return found


def list_actions(options: argparse.Namespace) -> None:
    """Print the actions that somebody serves, or asks for."""
    with cli_node() as node:
        known = get_action_names_and_types(node)
    if options.count_actions:
        print(len(known))
        return
    for name, types in known:
        print(_line(name, types, options.show_types))


def info(options: argparse.Namespace) -> None:
    """Print who asks for an action, and who serves it."""
    with cli_node() as node:
        full_name = node.resolve_service_name(options.action_name)
        sides = {
            "clients": _of_all(node, get_action_client_names_and_types_by_node),
            "servers": _of_all(node, get_action_server_names_and_types_by_node),
        }
    print(f"Action: {options.action_name}")
    for side, entries in sides.items():
        found = [(who, types) for who, (name, types) in entries if name == full_name]
        print(f"Action {side}: {len(found)}")
        for who, types in () if options.count else found:
            print(f"    {_line(who, types, options.show_types)}")


def send_goal(options: argparse.Namespace) -> str | None:
    """Send a goal, and print how it goes and how it ends."""
    action_type = action_class(options.action_type)
    goal = action_type.Goal()
    try:
        fill(goal, yaml.safe_load(options.goal))
    except Exception as fault:  # upstream's sentence, whatever went wrong
        return f"Failed to populate message fields: {fault!r}"
    with tool_node(f"_ros2cli_send_goal_{options.action_type.replace('/', '_')}") as node:
        client = ActionClient(node, action_type, options.action_name)
        print("Waiting for an action server to become available...", flush=True)
        client.wait_for_server()
        print(f"Sending goal:\n     {message_to_yaml(goal)}", flush=True)
        handle = answer_of(node, client.send_goal_async(goal, _print_feedback if options.feedback else None))
        if not handle.accepted:
            print("Goal was rejected.")
            return None
        print(f"Goal accepted with ID: {goal_key(handle.goal_id).hex()}\n", flush=True)
        answer = answer_of(node, handle.get_result_async())
        print(f"Result:\n    {message_to_yaml(answer.result)}")
        print(f"Goal finished with status: {status_name(answer.status)}", flush=True)
    return None


def _print_feedback(message: Message) -> None:
    print(f"Feedback:\n    {message_to_yaml(message.feedback)}", flush=True)


def _line(name: str, types: Sequence[str], show_types: bool) -> str:
    return f"{name} [{', '.join(types)}]" if show_types else name


def _of_all(node: Node, actions_of: Callable[..., Any]) -> list[tuple[str, tuple[str, list[str]]]]:
    """Return (node, (action, types)) of what every node serves, or asks for."""
    return [
        (f"{namespace.rstrip('/')}/{name}", entry)
        for name, namespace in sorted(node.get_node_names_and_namespaces())
        for entry in actions_of(node, name, namespace)
    ]
