"""Run `ros2 topic pub`: publish a message typed as YAML, once or repeatedly.

    ros2 topic pub /cmd_vel geometry_msgs/msg/Twist "{linear: {x: 0.2}}" -r 10
    ros2 topic pub --once /detected_point geometry_msgs/msg/PointStamped "{header: {frame_id: laser_frame}}"

A header given as `auto`, and a time given as `now`, get the time of sending.  With
--once and --times it waits for somebody to listen, and ends by itself.

upstream: ros2cli/ros2topic/verb/pub.py.
"""

from __future__ import annotations

import argparse
from itertools import count
from typing import Any

import yaml

from tflab.ros.messages.values import fill
from tflab.ros.node import Node
from tflab.ros.qos import DurabilityPolicy, QoSPresetProfiles, QoSProfile, ReliabilityPolicy

from .discovery import add_discovery_options, message_class, unsigned_int
from .session import cli_node, spin_for, tool_node

__all__ = ["add_pub"]

LOOK_EVERY_S, LOOKS_PER_LINE = 0.1, 10


def add_pub(verbs: argparse._SubParsersAction) -> None:
    """Add the verb to `ros2 topic`."""
    what = "Publish a message to a topic"
    parser = verbs.add_parser("pub", help=what, description=what)
    parser.set_defaults(run=pub)
    add_discovery_options(parser)
    add = parser.add_argument
    add("topic_name", help="Name of the ROS topic to publish to (e.g. '/chatter')")
    add("message_type", help="Type of the ROS message (e.g. 'std_msgs/String')")
    add("values", nargs="?", default="{}",
        help="Values to fill the message with in YAML format (e.g. 'data: Hello World'), otherwise the message will be "
             "published with default values")  # fmt: skip
    add("-r", "--rate", metavar="N", type=positive_float, default=1.0, help="Publishing rate in Hz (default: 1)")
    add("-p", "--print", metavar="N", type=int, default=1, help="Only print every N-th published message (default: 1)")
    group = parser.add_mutually_exclusive_group()
    group.add_argument("-1", "--once", action="store_true", help="Publish one message and exit")
    group.add_argument("-t", "--times", type=unsigned_int, default=0, help="Publish this number of times and then exit")
    add("-w", "--wait-matching-subscriptions", type=unsigned_int, default=None,
        help="Wait until finding the specified number of matching subscriptions. Defaults to 1 when using \"-1\"/"
             "\"--once\"/\"--times\", otherwise defaults to 0.")  # fmt: skip
    add("--keep-alive", metavar="N", type=positive_float, default=0.1,
        help="Keep publishing node alive for N seconds after the last msg (default: 0.1)")  # fmt: skip
    add("-n", "--node-name", help="Name of the created publishing node")
    add(
        "--qos-profile",
        choices=QoSPresetProfiles.short_keys(),
        help="Quality of service preset profile to publish with",
    )
    add("--qos-depth", metavar="N", type=unsigned_int, help="Queue size setting to publish with")
    add("--qos-reliability", choices=ReliabilityPolicy.short_keys(),
        help="Quality of service reliability setting to publish with")  # fmt: skip
    add("--qos-durability", choices=DurabilityPolicy.short_keys(),
        help="Quality of service durability setting to publish with")  # fmt: skip


def positive_float(text: str) -> float:
    """Return the number that `text` stands for, or have argparse refuse it as upstream's type does."""
    value = float(text)
    if not 0.0 < value < float("inf"):
        raise ValueError("Value must be positive")
    return value


def pub(options: argparse.Namespace) -> str | None:
    """Publish until stopped, or as often as was asked for."""
    named = None if options.node_name is None else tool_node(options.node_name, start_parameter_services=False)
    with named or cli_node() as node:
        message_type = message_class(options.message_type)
        values = yaml.safe_load(options.values)
        if not isinstance(values, dict):
            return "The passed value needs to be a dictionary in YAML format"
        publisher = node.create_publisher(message_type, options.topic_name, _profile(options))
        times = 1 if options.once else options.times
        wanted = options.wait_matching_subscriptions
        _wait_for_listeners(node, publisher, (1 if times else 0) if wanted is None else wanted)
        message = message_type()
        try:
            setters = fill(message, values)
        except Exception as fault:  # upstream's sentence, whatever went wrong
            return f"Failed to populate field: {fault}"
        print("publisher: beginning loop", flush=True)
        for number in count(1):
            _send(node, publisher, message, setters)
            if options.print and number % options.print == 0:
                print(f"publishing #{number}: {message!r}\n", flush=True)
            if number == times:
                break
            spin_for(node, 1.0 / options.rate)
        spin_for(node, options.keep_alive)
    return None


def _wait_for_listeners(node: Node, publisher: Any, wanted: int) -> None:
    for look in count():
        if publisher.get_subscription_count() >= wanted:
            return
        if look % LOOKS_PER_LINE == 0:
            print(f"Waiting for at least {wanted} matching subscription(s)...", flush=True)
        spin_for(node, LOOK_EVERY_S)


def _send(node: Node, publisher: Any, message: Any, setters: list) -> None:
    now = node.get_clock().now().to_msg()
    for set_stamp in setters:
        set_stamp(now)
    publisher.publish(message)


def _profile(options: argparse.Namespace) -> QoSProfile:
    """Return the profile that was asked for; upstream's own keeps the last message for latecomers."""
    preset = None if options.qos_profile is None else QoSPresetProfiles.get_from_short_key(options.qos_profile)
    reliability = preset.reliability if preset else ReliabilityPolicy.RELIABLE
    durability = preset.durability if preset else DurabilityPolicy.TRANSIENT_LOCAL
    if options.qos_reliability:
        reliability = ReliabilityPolicy[options.qos_reliability.upper()]
    if options.qos_durability:
        durability = DurabilityPolicy[options.qos_durability.upper()]
    depth = options.qos_depth if options.qos_depth is not None else (preset.depth if preset else 1)
    return QoSProfile(depth=depth, reliability=reliability, durability=durability)
