"""What is in this file?  From a bag, of ROS 2 or ROS 1, to a `Recording`.

    drive/  metadata.yaml + drive_0.mcap | .db3     rosbag2
    drive_0.mcap, drive_0.db3                       one file of it
    drive.bag                                       ROS 1
        |
        v  rosbags: which messages are there, and their bytes
    TFMessage, Header, Clock       read here (messages.py)
    JointState, Odometry, String   read by rosbags

The definitions that a bag may or may not carry are not needed: the few types
that matter for transforms are the same in every distribution.  All topics whose
messages begin with a header give their stamps and frames.

Read `wire.py` next.
"""

from __future__ import annotations

import re
import struct
from array import array
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from locale import getpreferredencoding
from pathlib import Path

import numpy as np

from tflab.core import stamp_from_sec_nanosec
from tflab.progress_bar import ProgressBar

from .columns import HeaderColumns, TransformColumns
from .errors import BagError
from .messages import (
    MalformedMessage,
    clock_in,
    header_in,
    names_of_single,
    single_in_cdr,
    transforms_in_cdr,
    transforms_in_ros1,
)
from .recording import (
    Clock,
    Connection,
    JointStates,
    Odometry,
    QosProfile,
    Recording,
)

__all__ = ["open_bag", "read_bag"]

TRANSFORM_TYPES = ("tf2_msgs/msg/TFMessage", "tf/msg/tfMessage")
CLOCK_TYPE = "rosgraph_msgs/msg/Clock"
JOINTS_TYPE = "sensor_msgs/msg/JointState"
ODOMETRY_TYPE = "nav_msgs/msg/Odometry"
STRING_TYPE = "std_msgs/msg/String"

MAGICS = {b"#ROSBAG V": ".bag", b"\x89MCAP0\r\n": ".mcap", b"SQLite format 3\0": ".db3"}
SQLITE_HEADER = struct.Struct(">16xH10xI")  # size of a page, and how many there are
FIRST_FIELD = re.compile(r"^\s*(?!#|=|MSG:)(\S+)\s+\w+", re.MULTILINE)
COMMENT = re.compile(r"#.*$", re.MULTILINE)


def read_bag(path: str | Path, show_progress: bool = True) -> Recording:
    """Return what a bag tells about transforms and time.

    Raises:
        BagError: there is no such file, or it is empty, cut short, or not a bag.
    """
    with open_bag(path) as (reader, is_ros1):
        collector = _Collector(reader.connections, is_ros1)
        counts = {c.topic: c.msgcount for c in reader.connections}
        wanted = [c for c in reader.connections if collector.wants(c)]
        total = sum(connection.msgcount for connection in wanted)
        with ProgressBar(total, f"reading {Path(path).name}", quiet=not show_progress) as progress:
            messages = reader.messages(connections=wanted) if wanted else ()
            for done, (connection, receive_ns, data) in enumerate(messages):
                collector.add(connection, receive_ns, data)
                if done % 4096 == 0:
                    progress.at(done)
        has_messages = any(counts.values())
        begin_ns, end_ns = (reader.start_time, reader.end_time - 1) if has_messages else (0, 0)
        return collector.recording(Path(path).name, reader.connections, begin_ns, end_ns)


@contextmanager
def open_bag(path: str | Path) -> Iterator[tuple]:
    """Open a bag for reading: (the reader of rosbags, whether it is ROS 1), closed at the end.

    Raises:
        BagError: also for whatever goes wrong while it is open: a foreign or broken
            file can fail anywhere in the library, in its own words.
    """
    from rosbags.rosbag1 import Reader as Reader1
    from rosbags.rosbag2 import Reader as Reader2

    path = Path(path).expanduser()
    kind = _kind_of(path)
    try:
        with (Reader1 if kind == ".bag" else Reader2)(_as_rosbags_reads_it(path, kind)) as reader:
            yield reader, kind == ".bag"
    except (BagError, KeyboardInterrupt, GeneratorExit):
        raise
    except MemoryError:
        raise BagError(f"{path}: too large for the memory of this machine, or broken") from None
    except Exception as error:
        reason = " ".join(str(error).split()) or type(error).__name__
        raise BagError(f"{path}: cannot be read, it seems to be broken or cut short ({reason})") from error


def _as_rosbags_reads_it(path: Path, kind: str) -> Path:
    """Return what to open: rosbags reads metadata.yaml in the system's encoding, which spoils names that are not ASCII.

    Where that is not UTF-8, as on a Korean Windows, and there is one storage file, that file is opened itself.
    """
    if kind != "directory" or getpreferredencoding(False).lower().replace("-", "") == "utf8":
        return path
    files = [*path.glob("*.mcap"), *path.glob("*.db3")]
    return path if len(files) != 1 or (path / "metadata.yaml").read_bytes().isascii() else files[0]


def _kind_of(path: Path) -> str:
    """Return ".bag", ".mcap", ".db3" or "directory", judged by what is in there."""
    if not path.exists():
        raise BagError(f"{path}: there is no such file or directory")
    if path.is_dir():
        if (path / "metadata.yaml").exists():
            return "directory"
        files = sorted(p.name for p in path.iterdir() if p.suffix in (".mcap", ".db3", ".bag"))
        if not files:
            raise BagError(f"{path}: not a bag, a rosbag2 directory holds a metadata.yaml and .mcap or .db3 files")
        raise BagError(
            f"{path}: metadata.yaml is missing, the recorder was probably killed; try the file {path / files[0]}, "
            f"or `ros2 bag reindex {path}` on a robot"
        )
    try:
        with path.open("rb") as file:
            start = file.read(SQLITE_HEADER.size)
    except OSError as error:
        raise BagError(f"{path}: cannot be opened ({error.strerror})") from None
    if not start:
        raise BagError(f"{path}: the file is empty")
    for magic, kind in MAGICS.items():
        if start.startswith(magic):
            if kind != ".bag" and path.suffix != kind:
                raise BagError(f"{path}: this is a {kind} file, but its name does not end in {kind}; rename it")
            if kind == ".db3" and _is_cut_short(start, path.stat().st_size):
                raise BagError(f"{path}: the file is cut short")
            return kind
    raise BagError(f"{path}: not a bag; known are rosbag2 directories, .mcap, .db3, and .bag of ROS 1 (version 2.0)")


def _is_cut_short(start: bytes, size: int) -> bool:
    """Return whether an SQLite file is smaller than its header says: the missing pages would read as zeros."""
    if len(start) < SQLITE_HEADER.size:
        return True
    page_size, pages = SQLITE_HEADER.unpack(start)
    return pages * (65536 if page_size == 1 else page_size) > size


class _Collector:
    """What has been read so far: one handler for each kind of message."""

    def __init__(self, connections: list, is_ros1: bool) -> None:
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
        self._handlers = {connection.id: self._handler(connection) for connection in connections}

    def wants(self, connection) -> bool:
        """Return whether the messages of a connection are looked into."""
        return self._handlers[connection.id] is not None

    def add(self, connection, receive_ns: int, data: bytes) -> None:
        """Take one message; one that cannot be read is counted and passed over."""
        try:
            self._handlers[connection.id](connection, receive_ns, data)
        except (MalformedMessage, struct.error, IndexError, OverflowError):
            self._unreadable[connection.topic] = self._unreadable.get(connection.topic, 0) + 1

    def recording(self, name: str, connections: list, begin_ns: int, end_ns: int) -> Recording:
        """Return everything as a recording."""
        return Recording(
            name=name,
            connections=tuple(
                Connection(c.topic, c.msgtype, _publisher_of(c), _qos_of(c), c.msgcount) for c in connections
            ),
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
