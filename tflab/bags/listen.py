"""Record a running graph in memory, with the publishers' names.

    graph --every topic--> a listener for some seconds --> Recording
             /tf, /tf_static     transforms, each with its publisher
             what has a header   stamps and frames
             /clock              the time

A file cannot tell who published a transform; in one process nothing gets lost,
so here every label has its publisher.  The listener asks a node only for what
rclpy's nodes offer, so a robot can be heard in the same way; of its images and
clouds only the first bytes are read (a raw subscription).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from struct import error as StructError
from typing import Any

import numpy as np

from tflab.core import NSEC_PER_SEC, StampedTransform, Transform
from tflab.core.transforms import TransformRecord
from tflab.ros import client_library
from tflab.ros.graph import Graph
from tflab.ros.messages.base import type_named
from tflab.ros.messages.tf2_msgs import TFMessage
from tflab.ros.node import Node

from .record import adapted_profile
from .recording import Clock, Connection, Headers, QosProfile, Recording, recording_from_records
from .wire import MalformedMessage, header_in

__all__ = ["ReceivedRecords", "recording_from_graph", "subscribe_to_all"]

NODE_NAME = "tf_listener"
CLOCK_TYPE = "rosgraph_msgs/msg/Clock"


class ReceivedRecords:
    """What a listener has heard so far."""

    def __init__(self) -> None:
        self._records: list[TransformRecord] = []
        self._headers: dict[tuple[str, str], list[tuple[int, int, str]]] = {}
        self._clock: list[tuple[int, int]] = []
        self._counts: dict[tuple[str, str, str], int] = {}
        self._qos: dict[tuple[str, str, str], tuple[QosProfile, ...]] = {}
        self._unreadable: dict[str, int] = {}

    def add_publisher(self, topic: str, ros_type: str, publisher: str, qos: QosProfile) -> None:
        """Note that a node offers a topic, whether or not it says something."""
        key = (topic, ros_type, publisher)
        self._qos[key] = (*self._qos.get(key, ()), qos)

    def add(self, topic: str, ros_type: str, publisher: str, receive_ns: int, message: Any) -> None:
        """Take one message."""
        key = (topic, ros_type, publisher)
        self._counts[key] = self._counts.get(key, 0) + 1
        if ros_type == TFMessage.ROS_TYPE:
            is_static = topic.endswith("tf_static")
            for transform in message.transforms:
                stamped = _stamped_from(transform)
                self._records.append(TransformRecord(topic, receive_ns, publisher, stamped, is_static))
        elif ros_type == CLOCK_TYPE:
            self._clock.append((receive_ns, _nanoseconds(message.clock)))
        elif hasattr(message, "header"):
            self._add_header(topic, ros_type, receive_ns, _nanoseconds(message.header.stamp), message.header.frame_id)

    def add_raw(self, topic: str, ros_type: str, publisher: str, receive_ns: int, data: bytes) -> None:
        """Take one message that begins with a header, as it is on the wire (CDR)."""
        key = (topic, ros_type, publisher)
        self._counts[key] = self._counts.get(key, 0) + 1
        try:
            stamp_ns, frame = header_in(data, is_ros1=False)
        except (MalformedMessage, StructError):
            self._unreadable[topic] = self._unreadable.get(topic, 0) + 1
            return
        self._add_header(topic, ros_type, receive_ns, stamp_ns, frame.decode("utf-8", errors="replace"))

    def _add_header(self, topic: str, ros_type: str, receive_ns: int, stamp_ns: int, frame: str) -> None:
        self._headers.setdefault((topic, ros_type), []).append((receive_ns, stamp_ns, frame))

    def recording(self, name: str) -> Recording:
        """Return everything as a recording."""
        made = recording_from_records(self._records, name)
        keys = sorted({*self._counts, *self._qos})
        moments = [row[0] for rows in (*self._headers.values(), self._clock) for row in rows]
        moments += [made.begin_ns, made.end_ns] if self._records else []
        clock = np.array(self._clock, dtype=np.int64).reshape(-1, 2)
        return replace(
            made,
            connections=tuple(Connection(*key, self._qos.get(key, ()), self._counts.get(key, 0)) for key in keys),
            headers=tuple(_table(*key, rows) for key, rows in sorted(self._headers.items())),
            clock=Clock(clock[:, 0], clock[:, 1]),
            begin_ns=min(moments, default=0),
            end_ns=max(moments, default=0),
            notes=tuple(
                f"{count} messages on {topic} could not be read and were passed over"
                for topic, count in sorted(self._unreadable.items())
            ),
        )


def recording_from_graph(graph: Graph, seconds: float = 5.0) -> Recording:
    """Let `seconds` pass on a graph, and return every transform and header that was heard meanwhile.

    Topics that have no publisher yet are not heard.
    """
    received = ReceivedRecords()
    participant = graph.start(_listen, received, name=NODE_NAME)
    graph.run(seconds=seconds)
    graph.stop(participant)
    return received.recording("graph")


def subscribe_to_all(
    node: Any, received: ReceivedRecords, class_of: Callable[[str], type | None], raw_headers: bool = False
) -> None:
    """Subscribe a node, of ours or of rclpy, to every topic that tells of transforms, frames or time.

    Args:
        class_of: the class of messages of a type; None if there is none here.
        raw_headers: leave what begins with a header as bytes, and read no more of it than that.
    """
    for topic, types in node.get_topic_names_and_types():
        publishers = node.get_publishers_info_by_topic(topic)
        message_class = class_of(types[0]) if len(types) == 1 and publishers else None
        if message_class is not None and _tells_something(types[0], message_class):
            is_raw = raw_headers and _begins_with_header(message_class)
            _subscribe(node, topic, types[0], message_class, publishers, received, is_raw)


def _listen(received: ReceivedRecords) -> None:
    """Write down everything, as a participant of the graph."""
    client_library.init()
    node = Node(NODE_NAME, start_parameter_services=False)
    subscribe_to_all(node, received, _class_here)
    try:
        client_library.spin(node)
    finally:
        client_library.try_shutdown()


def _class_here(ros_type: str) -> type | None:
    try:
        return type_named(ros_type)
    except KeyError:
        return None


def _tells_something(ros_type: str, message_class: type) -> bool:
    return ros_type in (TFMessage.ROS_TYPE, CLOCK_TYPE) or "header" in message_class.get_fields_and_field_types()


def _begins_with_header(message_class: type) -> bool:
    first = next(iter(message_class.get_fields_and_field_types().items()), None)
    return first == ("header", "std_msgs/Header")


def _subscribe(
    node: Any, topic: str, ros_type: str, message_class: type, publishers: list, received: ReceivedRecords, is_raw: bool
) -> None:
    names = {bytes(p.endpoint_gid): f"{p.node_namespace.rstrip('/')}/{p.node_name}" for p in publishers}
    only = next(iter(set(names.values()))) if len(set(names.values())) == 1 else ""
    for publisher in publishers:
        name = names[bytes(publisher.endpoint_gid)]
        received.add_publisher(topic, ros_type, name, _words_of(publisher.qos_profile))

    take = received.add_raw if is_raw else received.add

    def on_message(message: Any, info: dict) -> None:
        publisher = names.get(bytes(info.get("publisher_gid") or b""), only)
        take(topic, ros_type, publisher, info["received_timestamp"], message)

    node.create_subscription(message_class, topic, on_message, _profile_for(node, publishers), raw=is_raw)


def _profile_for(node: Any, publishers: list) -> Any:
    """Return the profile that hears all of them, in the classes that the node itself speaks."""
    adapted = adapted_profile([p.qos_profile for p in publishers])
    theirs = type(publishers[0].qos_profile)
    if isinstance(adapted, theirs):
        return adapted
    offered = publishers[0].qos_profile
    return theirs(
        depth=adapted.depth,
        durability=type(offered.durability)(int(adapted.durability)),
        reliability=type(offered.reliability)(int(adapted.reliability)),
    )


def _words_of(qos: Any) -> QosProfile:
    return QosProfile(qos.history.name.lower(), qos.depth, qos.reliability.name.lower(), qos.durability.name.lower())


def _stamped_from(transform: Any) -> StampedTransform:
    t, q = transform.transform.translation, transform.transform.rotation
    pose = Transform((t.x, t.y, t.z), (q.x, q.y, q.z, q.w))
    stamp_ns = _nanoseconds(transform.header.stamp)
    return StampedTransform(transform.header.frame_id, transform.child_frame_id, stamp_ns, pose)


def _nanoseconds(time: Any) -> int:
    return time.sec * NSEC_PER_SEC + time.nanosec


def _table(topic: str, msgtype: str, rows: list[tuple[int, int, str]]) -> Headers:
    receive_ns, stamp_ns, names = zip(*rows, strict=True)
    frames = tuple(dict.fromkeys(names))
    frame = [frames.index(name) for name in names]
    columns = (np.array(column, dtype=np.int64) for column in (receive_ns, stamp_ns, frame))
    return Headers(topic, msgtype, *columns, frames)
