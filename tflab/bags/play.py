"""Play a bag into a graph, as `ros2 bag play` does, without its output.

    drive/ --> events in the order of receipt --> publishers with the profiles that were recorded
               every 1/Hz of the bag's time   --> /clock, if asked for and not recorded

Stamps are replayed as they were recorded.  A loop therefore sets /clock, and all
stamps, back: whoever listens must be ready for that.  Stamps in simulated time without
a recorded /clock would be decades away from the times of receipt, so /clock follows the stamps.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from heapq import merge
from itertools import islice
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from tflab.core import NSEC_PER_SEC
from tflab.ros.messages.base import type_named
from tflab.ros.messages.builtin_interfaces import Time
from tflab.ros.qos import DurabilityPolicy, QoSProfile

from . import wire
from .collect import TRANSFORM_TYPES
from .reader import open_bag

if TYPE_CHECKING:
    from rosbags.highlevel import AnyReader

    from tflab.ros.node import Node

__all__ = ["Event", "PlayOptions", "events", "play"]

CLOCK_TOPIC, Clock = "/clock", type_named("rosgraph_msgs/msg/Clock")
OTHER_TIME_NS = 3600 * NSEC_PER_SEC  # no delay, and no clock that was set by hand, is as large
SAMPLED = 200  # messages with transforms, to find the time base of the stamps
# Opening the files again takes a moment.  Without one, listeners would hear the new pass' /clock, which sets their time
# back, before the last messages of the old pass: a buffer that has just been cleared would keep those as the newest.
BETWEEN_PASSES_NS = NSEC_PER_SEC // 100


@dataclass(frozen=True, slots=True)
class PlayOptions:
    """How to play.

    Attributes:
        rate: 2.0 is twice as fast.
        start_offset_s: how much of the beginning to leave out [s].
        loop: whether to begin again at the end.
        topics: which to play; all if empty.
        clock_hz: how often to publish /clock, 0 for never; a recorded /clock is played instead.
    """

    rate: float = 1.0
    start_offset_s: float = 0.0
    loop: bool = False
    topics: tuple[str, ...] = ()
    clock_hz: float = 0.0


class Event(NamedTuple):
    """Something to publish at a moment of the bag's time [ns]."""

    moment_ns: int
    topic: str
    message: Any


def play(node: Node, path: str | Path, options: PlayOptions, wait_until: Callable[[int], None]) -> None:
    """Publish what a bag holds.

    Args:
        wait_until: waits until so many nanoseconds after the beginning of the play.

    Raises:
        BagError: the bag cannot be read.
    """
    publishers = _publishers(node, path, options)
    played_ns = 0
    while True:
        first_ns = last_ns = None
        for event in events(path, options, tuple(publishers)):
            if first_ns is None:
                first_ns = event.moment_ns
            last_ns = event.moment_ns
            wait_until(played_ns + round((event.moment_ns - first_ns) / options.rate))
            publishers[event.topic].publish(event.message)
        if not options.loop or last_ns is None:
            return
        played_ns += round((last_ns - first_ns) / options.rate) + BETWEEN_PASSES_NS


def events(path: str | Path, options: PlayOptions, topics: Sequence[str]) -> Iterator[Event]:
    """Yield what there is to publish on these topics, in the order of the bag's time."""
    with open_bag(path) as (reader, is_ros1):
        if not any(connection.msgcount for connection in reader.connections):
            return
        begin_ns = reader.start_time + round(options.start_offset_s * NSEC_PER_SEC)
        connections = [c for c in reader.connections if c.topic in topics]
        messages = (
            Event(receive_ns, c.topic, wire.message_of(data, _modern(c.msgtype), is_ros1))
            for c, receive_ns, data in (reader.messages(connections, start=begin_ns) if connections else ())
        )
        has_clock = any(c.topic == CLOCK_TOPIC and c.msgcount for c in connections)
        hz = 0.0 if has_clock else options.clock_hz
        ticks = _ticks(begin_ns, reader.end_time, hz, _offset_of_stamps_ns(reader, is_ros1) if hz else 0)
        yield from merge(ticks, messages, key=lambda event: event.moment_ns)


def _publishers(node: Node, path: str | Path, options: PlayOptions) -> dict[str, Any]:
    """Return a publisher for each topic that is played, with the profile that was recorded."""
    publishers = {}
    with open_bag(path) as (reader, _):
        for connection in reader.connections:
            topic = connection.topic
            if topic in publishers or (options.topics and topic not in options.topics):
                continue
            try:
                message_class = type_named(_modern(connection.msgtype))
            except KeyError as unknown:
                node.get_logger().warning(f"Ignoring a topic '{topic}', reason: unknown type {unknown}.")
                continue
            publishers[topic] = node.create_publisher(message_class, topic, _profile(connection))
    if options.clock_hz and CLOCK_TOPIC not in publishers:
        publishers[CLOCK_TOPIC] = node.create_publisher(Clock, CLOCK_TOPIC, 10)
    return publishers


def _profile(connection) -> QoSProfile:
    """Return the first profile that was recorded; ROS 1 promises late listeners the last message by `latching`."""
    offered = getattr(connection.ext, "offered_qos_profiles", None)
    if offered:
        return wire.profile_of(offered[0])
    is_latched = getattr(connection.ext, "latching", 0) or connection.topic.endswith("tf_static")
    if is_latched:
        return QoSProfile(depth=10, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    return QoSProfile(depth=10)


def _ticks(begin_ns: int, end_ns: int, clock_hz: float, offset_ns: int) -> Iterator[Event]:
    """Yield what to publish on /clock."""
    if not clock_hz:
        return
    period_ns = round(NSEC_PER_SEC / clock_hz)
    for moment_ns in range(begin_ns, end_ns, period_ns):
        sec, nanosec = divmod(max(moment_ns + offset_ns, 0), NSEC_PER_SEC)
        yield Event(moment_ns, CLOCK_TOPIC, Clock(clock=Time(sec=sec, nanosec=nanosec)))


def _offset_of_stamps_ns(reader: AnyReader, is_ros1: bool) -> int:
    """Return what to add to a time of receipt to be in the time base of the stamps: 0 if they have the same."""
    moving = [c for c in reader.connections if c.msgtype in TRANSFORM_TYPES and not c.topic.endswith("tf_static")]
    ahead_ns = [
        transform.header.stamp.sec * NSEC_PER_SEC + transform.header.stamp.nanosec - receive_ns
        for c, receive_ns, data in islice(reader.messages(moving) if moving else (), SAMPLED)
        for transform in wire.message_of(data, _modern(c.msgtype), is_ros1).transforms
    ]
    offset_ns = max(ahead_ns, default=0)
    return offset_ns if abs(offset_ns) > OTHER_TIME_NS else 0


def _modern(msgtype: str) -> str:
    """Return today's name of a message type: that of ROS 1's tf had the same fields."""
    return TRANSFORM_TYPES[0] if msgtype in TRANSFORM_TYPES else msgtype
