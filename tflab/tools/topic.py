"""Run `ros2 topic list`, `info`, `type`, `find` and `echo`.

    ros2 topic info /tf --verbose
        Publisher count: 2          <- two nodes on /tf: the only evidence of a second owner
            Node name: ekf
            Node name: wheel_odometry

upstream: ros2cli/ros2topic.
"""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from typing import Any

from tflab.ros import distro
from tflab.ros.node import Node

from .discovery import add_discovery_options, add_verb, topic_class, types_of, unsigned_int, visible
from .session import cli_node, spin, spin_until_done
from .topic_pub import add_pub
from .topic_rates import add_delay, add_hz

__all__ = ["add_echo", "add_verbs", "endpoint_text", "field_of", "info_text", "list_text", "matching_policy"]

NO_LIMIT_NS = 2**63 - 1

# What a policy that was left to the system has become by the time that discovery shows it.
RESOLVED = {"reliability": "RELIABLE", "history": "KEEP_LAST", "durability": "VOLATILE", "liveliness": "AUTOMATIC"}


def add_verbs(verbs: argparse._SubParsersAction) -> None:
    """Add the verbs of `ros2 topic` to a parser."""
    add_delay(verbs)
    add_echo(verbs)
    _add(verbs, "find", "Output a list of available topics of a given type", find, "topic_type",
         "Name of the ROS topic type to filter for (e.g. 'std_msg/msg/String')", hidden=True, count=True)  # fmt: skip
    add_hz(verbs)
    info_parser = _add(verbs, "info", "Print information about a topic", info, "topic_name",
                       "Name of the ROS topic to get info (e.g. '/chatter')")  # fmt: skip
    info_parser.add_argument(
        "--verbose", "-v", action="store_true",
        help="Prints detailed information like the node name, node namespace, topic type, topic type hash, GUID, and "
             "QoS Profile of the publishers and subscribers to this topic",
    )  # fmt: skip
    list_parser = _add(verbs, "list", "Output a list of available topics", list_topics, hidden=True, count=True)
    list_parser.add_argument("-t", "--show-types", action="store_true", help="Additionally show the topic type")
    list_parser.add_argument("-v", "--verbose", action="store_true", help="List full details about each topic")
    add_pub(verbs)
    _add(verbs, "type", "Print a topic's type", topic_type, "topic_name",
         "Name of the ROS topic to get type (e.g. '/chatter')")  # fmt: skip


def _add(verbs, name, what, run, argument="", argument_help="", hidden=False, count=False) -> argparse.ArgumentParser:
    """Add one verb, with the options that several share."""
    verb = add_verb(verbs, name, what, run)
    if argument:
        verb.add_argument(argument, help=argument_help)
    if count:
        verb.add_argument("-c", "--count-topics", action="store_true",
                          help="Only display the number of topics discovered")  # fmt: skip
    if hidden:
        verb.add_argument("-a", "--include-hidden-topics", action="store_true", help="Consider hidden topics as well")
    return verb


# -- what they print ------------------------------------------------------


def list_text(topics: Sequence[tuple[str, Sequence[str]]], show_types: bool = False) -> str:
    """Return a line for each topic."""
    return "\n".join(f"{name} [{', '.join(types)}]" if show_types else name for name, types in topics)


def verbose_list_text(topics: Sequence[tuple[str, Sequence[str], int, int]]) -> str:
    """Return the topics, each (name, types, publishers, subscriptions), that have publishers, then the others."""
    blocks = []
    for heading, who, column in (("Published topics:", "publisher", 2), ("Subscribed topics:", "subscriber", 3)):
        lines = [
            f" * {topic[0]} [{', '.join(topic[1])}] {topic[column]} {who}{'s' if topic[column] > 1 else ''}"
            for topic in topics
            if topic[column]
        ]
        blocks.append("\n".join([heading, *lines]) + "\n")
    return "\n".join(blocks)


def info_text(types: Sequence[str], publishers: Sequence[str] | int, subscriptions: Sequence[str] | int) -> str:
    """Return what `info` prints: given numbers the short form, given the texts of the endpoints the long one."""
    type_text = types[0] if len(types) == 1 else list(types)
    if isinstance(publishers, int):
        return f"Type: {type_text}\nPublisher count: {publishers}\nSubscription count: {subscriptions}"
    blocks = [
        f"Type: {type_text}",
        f"Publisher count: {len(publishers)}",
        *publishers,
        f"Subscription count: {len(subscriptions)}",
        *subscriptions,
    ]
    return "\n\n".join(blocks) + "\n"


def endpoint_text(endpoint, type_hash: str | None) -> str:
    """Return one publisher or subscription as `info --verbose` prints it; Humble has no line for the hash."""
    qos = endpoint.qos_profile
    policies = {kind: getattr(qos, kind).name for kind in RESOLVED}
    policies = {kind: RESOLVED[kind] if name == "SYSTEM_DEFAULT" else name for kind, name in policies.items()}
    depth = f" ({qos.depth})" if policies["history"] == "KEEP_LAST" else ""
    lines = [
        f"Node name: {endpoint.node_name}",
        f"Node namespace: {endpoint.node_namespace}",
        f"Topic type: {endpoint.topic_type}",
        *([f"Topic type hash: {type_hash}"] if type_hash else []),
        f"Endpoint type: {endpoint.endpoint_type.name}",
        f"GID: {'.'.join(f'{byte:02x}' for byte in endpoint.endpoint_gid)}",
        "QoS profile:",
        f"  Reliability: {policies['reliability']}",
        f"  History (Depth): {policies['history']}{depth}",
        f"  Durability: {policies['durability']}",
        f"  Lifespan: {_duration_text(qos.lifespan)}",
        f"  Deadline: {_duration_text(qos.deadline)}",
        f"  Liveliness: {policies['liveliness']}",
        f"  Liveliness lease duration: {_duration_text(qos.liveliness_lease_duration)}",
    ]
    return "\n".join(lines)


def _duration_text(duration) -> str:
    is_unlimited = duration.nanoseconds in (0, NO_LIMIT_NS)
    return "Infinite" if is_unlimited else f"{duration.nanoseconds} nanoseconds"


# -- the verbs ------------------------------------------------------------


def list_topics(options: argparse.Namespace) -> str | None:
    """Print the topics."""
    with cli_node() as node:
        topics = visible(node.get_topic_names_and_types(), options.include_hidden_topics)
        if options.count_topics:
            print(len(topics))
        elif topics and options.verbose:
            counts = [(n, t, node.count_publishers(n), node.count_subscribers(n)) for n, t in topics]
            print(verbose_list_text(counts))
        elif topics:
            print(list_text(topics, options.show_types))


def info(options: argparse.Namespace) -> str | None:
    """Print who publishes and who listens."""
    with cli_node() as node:
        name = options.topic_name
        types = types_of(node, name)
        if types is None:
            return f"Unknown topic '{name}'"
        if not options.verbose:
            print(info_text(types, node.count_publishers(name), node.count_subscribers(name)))
            return None
        publishers = [_endpoint(each) for each in node.get_publishers_info_by_topic(name)]
        subscriptions = [_endpoint(each) for each in node.get_subscriptions_info_by_topic(name)]
        print(info_text(types, publishers, subscriptions))
    return None


def _endpoint(endpoint) -> str:
    from tflab.ros.messages.text import type_hash

    return endpoint_text(endpoint, type_hash(endpoint.topic_type) if distro.current().has_type_hash else None)


def topic_type(options: argparse.Namespace) -> str | int | None:
    """Print the type of a topic; an unknown one is exit code 1 and no word."""
    with cli_node() as node:
        types = types_of(node, options.topic_name)
        if types is None:
            return 1
        print("\n".join(types))
    return None


def find(options: argparse.Namespace) -> None:
    """Print the topics of a type."""
    with cli_node() as node:
        topics = visible(node.get_topic_names_and_types(), options.include_hidden_topics)
        names = [name for name, types in topics if options.topic_type in types]
        if options.count_topics:
            print(len(names))
        elif names:
            print("\n".join(names))


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
