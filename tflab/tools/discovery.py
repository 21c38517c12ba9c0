"""Find the topics and types that a graph knows, with the options that the commands share.

    /tf --types_of--> ["tf2_msgs/msg/TFMessage"] --message_class--> TFMessage

The verbs of `ros2 topic`, `node` and `param` share it.
upstream: ros2cli/ros2cli/node/strategy.py, ros2topic/api.
"""

from __future__ import annotations

import argparse
from collections.abc import Callable, Sequence

from tflab.ros.exceptions import InvalidTopicNameException
from tflab.ros.messages import type_named
from tflab.ros.node import Node

__all__ = [
    "add_discovery_options",
    "add_verb",
    "full_type_name",
    "message_class",
    "topic_class",
    "types_of",
    "unsigned_int",
    "visible",
]


def add_discovery_options(parser: argparse.ArgumentParser) -> None:
    """Add the options about discovery, which here is immediate: they are taken, and change nothing."""
    parser.add_argument(
        "--spin-time", type=float,
        help="Spin time in seconds to wait for discovery (only applies when not using an already running daemon)",
    )  # fmt: skip
    parser.add_argument("-s", "--use-sim-time", action="store_true", help="Enable ROS simulation time")
    parser.add_argument("--no-daemon", action="store_true", help="Do not spawn nor use an already running daemon")


def add_verb(
    verbs: argparse._SubParsersAction, name: str, what: str, run: Callable, *, looks_around: bool = True
) -> argparse.ArgumentParser:
    """Add a verb that says `what` in its help; if it looks around in the graph, with the options about discovery."""
    verb = verbs.add_parser(name, help=what, description=what)
    verb.set_defaults(run=run)
    if looks_around:
        add_discovery_options(verb)
    return verb


def visible(names_and_types: Sequence[tuple[str, Sequence[str]]], hidden: bool = False) -> list[tuple[str, list[str]]]:
    """Return those topics or services that are not hidden (no part of their name begins with "_"), by name."""
    return sorted((name, list(types)) for name, types in names_and_types if hidden or "/_" not in name)


def types_of(node: Node, topic_name: str) -> list[str] | None:
    """Return the types of a topic, None if there is no such topic."""
    return dict(node.get_topic_names_and_types()).get(topic_name)


def full_type_name(type_name: str, kind: str) -> str:
    """Return the name of a type with its kind in it: 'geometry_msgs/Point' is 'geometry_msgs/msg/Point'."""
    package, _, name = type_name.rpartition("/")
    return type_name if "/" in package else f"{package}/{kind}/{name}"


def message_class(type_name: str) -> type:
    """Return the class of a message type.

    Raises:
        RuntimeError: there is none of that name; upstream's text.
    """
    try:
        return type_named(full_type_name(type_name, "msg"))
    except KeyError:
        raise RuntimeError(f"The message type '{type_name}' is invalid") from None


def topic_class(node: Node, topic_name: str, type_name: str | None = None) -> type | None:
    """Return the class of a topic's messages, None, with upstream's warning, if nobody knows the topic.

    Raises:
        RuntimeError: it has several types, or one that is not known here, or its name is malformed.
    """
    try:
        full_name = node.resolve_topic_name(topic_name)
    except InvalidTopicNameException as fault:
        raise RuntimeError(str(fault)) from None
    if type_name is not None:
        return message_class(type_name)
    types = types_of(node, full_name)
    if types is None:
        print(f"WARNING: topic [{full_name}] does not appear to be published yet", flush=True)
        return None
    if len(types) > 1:
        raise RuntimeError(f"Cannot echo topic '{full_name}', as it contains more than one type: [{', '.join(types)}]")
    return message_class(types[0])


def unsigned_int(text: str) -> int:
    """Return the number that `text` stands for, or have argparse say upstream's sentence."""
    if not text.isdecimal():
        raise argparse.ArgumentTypeError("value must be non-negative integer")
    return int(text)
