"""Collect transforms, stamps and clocks while a bag is read: a handler for each kind of message.

    connections --> what is each to be asked for?  transforms | header | clock | joints | odometry | description
    messages    --> the handler of their connection --> columns --> Recording

The definitions that a bag may or may not carry are not needed: the few types
that matter for transforms are the same in every distribution.  All topics whose
messages begin with a header give their stamps and frames.
"""

from __future__ import annotations

import re
import struct
from array import array
from collections.abc import Callable
from tempfile import TemporaryFile
from typing import IO

import numpy as np

from tflab.core import stamp_from_sec_nanosec

from .recording import (
    Clock,
    Connection,
    Headers,
    JointStates,
    Odometry,
    QosProfile,
    Recording,
    TransformLabel,
    Transforms,
    Unfinished,
)
from .wire import (
    NUMBERS_SIZE,
    MalformedMessage,
    RawTransform,
    clock_in,
    header_in,
    names_of_single,
    single_in_cdr,
    transforms_in_cdr,
    transforms_in_ros1,
)

__all__ = ["TRANSFORM_TYPES", "Collector", "HeaderColumns", "TransformColumns"]

TRANSFORM_TYPES = ("tf2_msgs/msg/TFMessage", "tf/msg/tfMessage")
CLOCK_TYPE = "rosgraph_msgs/msg/Clock"
JOINTS_TYPE = "sensor_msgs/msg/JointState"
ODOMETRY_TYPE = "nav_msgs/msg/Odometry"
STRING_TYPE = "std_msgs/msg/String"
FIRST_FIELD = re.compile(r"^\s*(?!#|=|MSG:)(\S+)\s+\w+", re.MULTILINE)
COMMENT = re.compile(r"#.*$", re.MULTILINE)


class Collector:
    """What has been read so far, of one file or of several after each other."""

    def __init__(self, is_ros1: bool) -> None:
        self._is_ros1 = is_ros1
        self._raw_transforms = transforms_in_ros1 if is_ros1 else transforms_in_cdr
        self._transforms = TransformColumns()
        self._headers: dict[str, HeaderColumns] = {}
        self._clock = (array("q"), array("q"))
        self._joints: dict[str, list] = {}
        self._odometry: dict[str, list] = {}
        self._robot_description = ""
        self._unreadable: dict[str, int] = {}
        self._store = None
        self._handlers: dict[int, Callable | None] = {}
        self._connections: dict[tuple, Connection] = {}

    def begin_file(self, connections: list) -> None:
        """Get ready for the messages of these connections."""
        self._handlers = {connection.id: self._handler(connection) for connection in connections}
        for number, c in enumerate(connections):
            made = Connection(c.topic, c.msgtype, _publisher_of(c), _qos_of(c), c.msgcount)
            key = (number, *made[:-1])  # a recording in several files has the same connections in each
            before = self._connections.get(key)
            self._connections[key] = made._replace(count=made.count + before.count) if before else made

    def wants(self, connection) -> bool:
        """Return whether the messages of a connection are looked into."""
        return self._handlers[connection.id] is not None

    def add(self, connection, receive_ns: int, data: bytes) -> None:
        """Take one message; one that cannot be read is counted and passed over."""
        try:
            self._handlers[connection.id](connection, receive_ns, data)
        except (MalformedMessage, struct.error, IndexError, OverflowError):
            self._unreadable[connection.topic] = self._unreadable.get(connection.topic, 0) + 1

    def recording(self, name: str, begin_ns: int, end_ns: int, unfinished: Unfinished | None) -> Recording:
        """Return everything as a recording."""
        return Recording(
            name=name,
            connections=tuple(self._connections.values()),
            transforms=self._transforms.table(),
            headers=tuple(self._headers[topic].table(topic) for topic in sorted(self._headers)),
            clock=Clock(*(np.array(column, dtype=np.int64) for column in self._clock)),
            joint_states=tuple(_joint_states(topic, self._joints[topic]) for topic in sorted(self._joints)),
            odometry=tuple(_odometry(topic, self._odometry[topic]) for topic in sorted(self._odometry)),
            robot_description=self._robot_description,
            begin_ns=begin_ns,
            end_ns=end_ns,
            notes=tuple(
                f"{count} messages on {topic} could not be read and were passed over"
                for topic, count in sorted(self._unreadable.items())
            ),
            unfinished=unfinished,
            is_ros1=self._is_ros1,
        )

    def _handler(self, connection) -> Callable | None:
        """Return what to do with the messages of a connection, None if nothing."""
        if connection.msgtype in TRANSFORM_TYPES:
            return self._transform_handler(connection)
        if connection.msgtype == CLOCK_TYPE:
            return self._add_clock
        if connection.msgtype == JOINTS_TYPE:
            return self._add_joints
        if connection.msgtype == ODOMETRY_TYPE:
            return self._add_odometry
        if connection.msgtype == STRING_TYPE and connection.topic.endswith("robot_description"):
            return self._add_description
        return self._add_header if _begins_with_header(connection) else None

    def _transform_handler(self, connection) -> Callable:
        """Return what to do with the messages of a topic of transforms; those of known names take the short way."""
        how = (connection.topic, _publisher_of(connection), connection.topic.endswith("tf_static"))
        columns, known = self._transforms, {}

        def add(_, receive_ns: int, data: bytes) -> None:
            names = None if self._is_ros1 else names_of_single(data)
            if names in known:
                stamp_ns, numbers = single_in_cdr(data)
                columns.add_one(known[names], receive_ns, stamp_ns, numbers)
                return
            columns.add(how, receive_ns, list(self._raw_transforms(data)))
            if names is not None and columns.ends_with(data):
                known[names] = columns.newest_label

        return add

    def _add_clock(self, _, receive_ns: int, data: bytes) -> None:
        self._clock[1].append(clock_in(data, self._is_ros1))
        self._clock[0].append(receive_ns)

    def _add_header(self, connection, receive_ns: int, data: bytes) -> None:
        stamp_ns, frame = header_in(data, self._is_ros1)
        if connection.topic not in self._headers:
            self._headers[connection.topic] = HeaderColumns(connection.msgtype)
        self._headers[connection.topic].add(receive_ns, stamp_ns, frame)

    def _add_joints(self, connection, receive_ns: int, data: bytes) -> None:
        self._add_header(connection, receive_ns, data)
        state = self._deserialize(connection, data)
        stamp_ns = stamp_from_sec_nanosec(state.header.stamp.sec, state.header.stamp.nanosec)
        self._joints.setdefault(connection.topic, []).append((stamp_ns, tuple(state.name), tuple(state.position)))

    def _add_odometry(self, connection, receive_ns: int, data: bytes) -> None:
        self._add_header(connection, receive_ns, data)
        odometry = self._deserialize(connection, data)
        p, q = odometry.pose.pose.position, odometry.pose.pose.orientation
        stamp_ns = stamp_from_sec_nanosec(odometry.header.stamp.sec, odometry.header.stamp.nanosec)
        row = (odometry.header.frame_id, odometry.child_frame_id, stamp_ns, (p.x, p.y, p.z, q.x, q.y, q.z, q.w))
        self._odometry.setdefault(connection.topic, []).append(row)

    def _add_description(self, connection, receive_ns: int, data: bytes) -> None:
        self._robot_description = self._deserialize(connection, data).data

    def _deserialize(self, connection, data: bytes):
        """Let rosbags read a message of a standard type."""
        from rosbags.typesys import Stores, get_typestore

        if self._store is None:
            self._store = get_typestore(Stores.ROS1_NOETIC if self._is_ros1 else Stores.ROS2_HUMBLE)
        read = self._store.deserialize_ros1 if self._is_ros1 else self._store.deserialize_cdr
        try:
            return read(data, connection.msgtype)
        except Exception as error:  # broken bytes can fail anywhere in the library
            raise MalformedMessage(str(error)) from error


def _joint_states(topic: str, rows: list) -> JointStates:
    stamps, names, positions = zip(*rows, strict=True)
    return JointStates(topic, np.array(stamps, dtype=np.int64), names, positions)


def _odometry(topic: str, rows: list) -> Odometry:
    frames, children, stamps, numbers = zip(*rows, strict=True)
    return Odometry(topic, frames[0], children[0], np.array(stamps, dtype=np.int64), np.array(numbers, dtype=float))


def _begins_with_header(connection) -> bool:
    """Return whether messages of a connection begin with a std_msgs/Header.

    A bag that carries the definition says so; for the usual messages rosbags knows.
    """
    from rosbags.typesys import Stores, get_typestore

    text = connection.msgdef.data
    if connection.msgdef.format.name == "MSG" and text:
        first = FIRST_FIELD.search(COMMENT.sub("", text.split("=" * 80)[0]))
        return first is not None and first[1] in ("Header", "std_msgs/Header", "std_msgs/msg/Header")
    fields = get_typestore(Stores.ROS2_HUMBLE).fielddefs.get(connection.msgtype)
    return bool(fields and fields[1] and fields[1][0][1][1] == "std_msgs/msg/Header")


def _publisher_of(connection) -> str:
    return getattr(connection.ext, "callerid", None) or ""


def _qos_of(connection) -> tuple[QosProfile, ...]:
    """Return the offered profiles; ROS 1 has one flag, latching, which promises late listeners the last message."""
    ext = connection.ext
    if hasattr(ext, "latching"):
        if ext.latching is None:
            return ()
        return (QosProfile("keep_last", 1, "reliable", "transient_local" if ext.latching else "volatile"),)
    return tuple(
        QosProfile(q.history.name.lower(), q.depth, q.reliability.name.lower(), q.durability.name.lower())
        for q in ext.offered_qos_profiles
    )


MOST_IN_MEMORY = 128 * 2**20  # bytes of numbers, about two million transforms


class TransformColumns:
    """Transforms, as many as there are, in growing columns; of a long recording the numbers lie on disk."""

    def __init__(self) -> None:
        self._receive_ns, self._stamp_ns = array("q"), array("q")
        self._message, self._label = array("i"), array("i")
        self._numbers = bytearray()
        self._on_disk: IO[bytes] | None = None
        self._labels: dict[tuple, int] = {}
        self._messages = 0

    def add(self, how: tuple[str, str, bool], receive_ns: int, transforms: list[RawTransform]) -> None:
        """Take the transforms of one message; `how` is topic, publisher, is_static."""
        for stamp_ns, parent, child, numbers in transforms:
            key = (how, parent, child)
            label = self._labels.setdefault(key, len(self._labels))
            self._append(label, receive_ns, stamp_ns, numbers)
        self._messages += 1

    def add_one(self, label: int, receive_ns: int, stamp_ns: int, numbers: bytes) -> None:
        """Take the one transform of a message whose label is known."""
        self._append(label, receive_ns, stamp_ns, numbers)
        self._messages += 1

    @property
    def newest_label(self) -> int:
        return self._label[-1]

    def ends_with(self, data: bytes) -> bool:
        """Return whether the numbers that came last are the last bytes of `data`."""
        return bool(self._numbers) and data.endswith(bytes(self._numbers[-NUMBERS_SIZE:]))

    def _append(self, label: int, receive_ns: int, stamp_ns: int, numbers: bytes) -> None:
        self._stamp_ns.append(stamp_ns)
        self._label.append(label)
        self._numbers += numbers
        if len(self._numbers) >= MOST_IN_MEMORY:
            self._to_disk()
        self._receive_ns.append(receive_ns)
        self._message.append(self._messages)

    def _to_disk(self) -> None:
        """Move the numbers into a file without a name, but for the newest; it is gone when nobody holds it any more."""
        if self._on_disk is None:
            self._on_disk = TemporaryFile()  # noqa: SIM115
        self._on_disk.write(memoryview(self._numbers)[:-NUMBERS_SIZE])
        self._numbers = self._numbers[-NUMBERS_SIZE:]

    def _all_numbers(self) -> np.ndarray:
        if self._on_disk is None:
            return np.frombuffer(self._numbers, dtype="<f8").reshape(-1, 7)
        self._on_disk.write(self._numbers)
        self._on_disk.flush()
        return np.memmap(self._on_disk, dtype="<f8", mode="r", shape=(len(self._stamp_ns), 7))

    def table(self) -> Transforms:
        columns = (self._receive_ns, self._stamp_ns, self._message, self._label)
        return Transforms(
            *(np.frombuffer(column, dtype=np.dtype(column.typecode)) for column in columns),
            self._all_numbers(),
            tuple(
                TransformLabel(topic, publisher, _text(parent), _text(child), is_static)
                for (topic, publisher, is_static), parent, child in self._labels
            ),
        )


class HeaderColumns:
    """The headers of one topic, in growing columns."""

    def __init__(self, msgtype: str) -> None:
        self._msgtype = msgtype
        self._receive_ns, self._stamp_ns, self._frame = array("q"), array("q"), array("q")
        self._frames: dict[bytes, int] = {}

    def add(self, receive_ns: int, stamp_ns: int, frame: bytes) -> None:
        self._stamp_ns.append(stamp_ns)
        self._receive_ns.append(receive_ns)
        self._frame.append(self._frames.setdefault(frame, len(self._frames)))

    def table(self, topic: str) -> Headers:
        columns = (np.frombuffer(c, dtype=np.int64) for c in (self._receive_ns, self._stamp_ns, self._frame))
        return Headers(topic, self._msgtype, *columns, tuple(map(_text, self._frames)))


def _text(name: bytes) -> str:
    return name.decode("utf-8", errors="replace")
