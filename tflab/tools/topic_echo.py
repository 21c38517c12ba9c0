"""What do they say?  `ros2 topic echo`: every message of a topic, as YAML.

    publishers offer                         echo requests
    all TRANSIENT_LOCAL                      TRANSIENT_LOCAL: so --once on /tf_static answers
    some                                     VOLATILE, with a warning
    the same with RELIABLE and BEST_EFFORT

upstream: ros2cli/ros2topic/verb/echo.py.
"""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from typing import Any

from tflab.ros.node import Node

from .discovery import add_discovery_options, topic_class
from .session import cli_node, spin, spin_until_done

__all__ = ["add_echo", "field_of", "matching_policy"]

TRUNCATE_LENGTH = 128


def add_echo(verbs: argparse._SubParsersAction) -> None:
    """Add the verb to `ros2 topic`."""
    echo_parser = verbs.add_parser(
        "echo", help="Output messages from a topic", description="Output messages from a topic"
    )
    echo_parser.set_defaults(run=echo)
    add_discovery_options(echo_parser)
    add = echo_parser.add_argument
    add("topic_name", help="Name of the ROS topic to listen to (e.g. '/chatter')")
    add("message_type", nargs="?", help="Type of the ROS message (e.g. 'std_msgs/msg/String')")
    add("--qos-depth", metavar="N", type=unsigned_int, default=5, help="Queue size setting to subscribe with")
    add("--qos-reliability", choices=["system_default", "reliable", "best_effort"],
        help="Quality of service reliability setting to subscribe with")  # fmt: skip
    add("--qos-durability", choices=["system_default", "transient_local", "volatile"],
        help="Quality of service durability setting to subscribe with")  # fmt: skip
    add("--field", metavar="FIELD_NAME", help="Echo a selected field of a message. Use '.' to select sub-fields.")
    add("--full-length", "-f", action="store_true",
        help="Output all elements for arrays, bytes, and string with a length > '--truncate-length', by default they "
             "are truncated after '--truncate-length' elements with '...'")  # fmt: skip
    add("--truncate-length", "-l", metavar="N", type=unsigned_int, default=TRUNCATE_LENGTH,
        help=f"The length to truncate arrays, bytes, and string to (default: {TRUNCATE_LENGTH})")  # fmt: skip
    add("--no-arr", action="store_true", help="Don't print array fields of messages")
    add("--no-str", action="store_true", help="Don't print string fields of messages")
    add(
        "--flow-style", action="store_true", help="Print collections in the block style (not available with csv format)"
    )
    add("--once", action="store_true", help="Print the first message received and then exit.")


def unsigned_int(text: str) -> int:
    """Return the number that `text` stands for, or have argparse say upstream's sentence."""
    if not text.isdecimal():
        raise argparse.ArgumentTypeError("value must be non-negative integer")
    return int(text)


def matching_policy(offers: Sequence[Any], strict: Any, lenient: Any) -> tuple[Any, str]:
    """Return the policy that connects to every publisher, and the warning if that is less than some offer."""
    count = sum(offer == strict for offer in offers)
    if offers and count == len(offers):
        return strict, ""
    if count == 0:
        return lenient, ""
    # Upstream prints the old names of the classes, QoSDurabilityPolicy and QoSReliabilityPolicy.
    kind = f"QoS{type(strict).__name__}"
    return lenient, (
        f"Some, but not all, publishers are offering {kind}.{strict.name}. "
        f"Falling back to {kind}.{lenient.name} as it will connect to all publishers"
    )


def field_of(message: Any, path: str) -> Any:
    """Return a field of a message, or of one inside it: "header.stamp".

    Raises:
        RuntimeError: there is no such field; upstream's text.
    """
    value = message
    for name in path.split("."):
        try:
            value = getattr(value, name)
        except AttributeError as fault:
            raise RuntimeError(f"Invalid field '{path}': {fault}") from None
    return value


def echo(options: argparse.Namespace) -> str | None:
    """Print messages until stopped, or one of them."""
    with cli_node() as node:
        message_type = topic_class(node, options.topic_name, options.message_type)
        if message_type is None:
            return "Could not determine the type for the passed topic"
        if options.field:
            field_of(message_type(), options.field)
        first = _print_messages(node, message_type, options)
        if options.once:
            spin_until_done(node, first)
        else:
            spin(node)
    return None


def _print_messages(node: Node, message_type: type, options: argparse.Namespace):
    """Subscribe, print whatever comes, and return a future of the first."""
    from tflab.ros.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy
    from tflab.ros.task import Future

    first, topic = Future(), node.resolve_topic_name(options.topic_name)
    offers = [each.qos_profile for each in node.get_publishers_info_by_topic(topic)]
    reliability = _policy(
        options.qos_reliability, [offer.reliability for offer in offers],
        ReliabilityPolicy.RELIABLE, ReliabilityPolicy.BEST_EFFORT,
    )  # fmt: skip
    durability = _policy(
        options.qos_durability, [offer.durability for offer in offers],
        DurabilityPolicy.TRANSIENT_LOCAL, DurabilityPolicy.VOLATILE,
    )  # fmt: skip
    qos = QoSProfile(depth=options.qos_depth, reliability=reliability, durability=durability)

    def on_message(message: Any) -> None:
        if options.once and first.done():
            return
        print(_text(message, options), end="---\n", flush=True)
        if options.once:
            first.set_result(True)

    node.create_subscription(message_type, topic, on_message, qos)
    return first


def _policy(wanted: str | None, offers: Sequence[Any], strict: Any, lenient: Any) -> Any:
    if wanted is not None:
        return type(strict)[wanted.upper()]
    policy, warning = matching_policy(offers, strict, lenient)
    if warning:
        print(warning)
    return policy


def _text(message: Any, options: argparse.Namespace) -> str:
    from tflab.ros.messages.base import Message
    from tflab.ros.messages.text import message_to_yaml

    shown = field_of(message, options.field) if options.field else message
    if not isinstance(shown, Message):
        return f"{shown}\n"
    return message_to_yaml(
        shown,
        truncate_length=None if options.full_length else options.truncate_length,
        no_arr=options.no_arr,
        no_str=options.no_str,
        flow_style=options.flow_style,
    )
