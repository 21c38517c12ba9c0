"""Define a Recording: transforms as NumPy columns, and the headers, clock, joint states and QoS of a bag.

    row    receive_ns   stamp_ns    label   x y z qx qy qz qw
      0    1000080000   1000000000    0     ...
      1    1000085000   1000000000    1     ...              label 0: /tf, odom -> base_link
      2    1050081000   1050000000    0     ...              label 1: /tf, base_link -> arm

Rows stand in the order of arrival, with everything as sent: slashes, rotations
of length zero, stamps that go backwards.  What tf2 would make of them is the
buffer's business (`Recording.buffer`), what is wrong with them the doctor's.

ROS calls the file a bag.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np

from tflab.core import NSEC_PER_SEC, BufferCore, StampedTransform, Transform
from tflab.core.transforms import TransformRecord

__all__ = ["Clock", "Connection", "Headers", "JointStates", "Odometry", "QosProfile", "Recording",
           "TransformLabel", "Transforms", "Unfinished", "namespace_of", "recording_from_records"]  # fmt: skip

DEFAULT_AUTHORITY = "default_authority"
EXTRA_CACHE_NS = NSEC_PER_SEC


class QosProfile(NamedTuple):
    """How a topic was offered; the words are those of ROS 2 in lower case ("transient_local")."""

    history: str
    depth: int
    reliability: str
    durability: str


class Connection(NamedTuple):
    """One way into the recorder: a topic, and what is known of who published it.

    Attributes:
        publisher: full node name, "" if not known (a rosbag2 does not say).
        qos: the profiles that were offered; empty if not known.
    """

    topic: str
    msgtype: str
    publisher: str = ""
    qos: tuple[QosProfile, ...] = ()
    count: int = 0


class TransformLabel(NamedTuple):
    """What many transforms share: how they came, and between which frames, as sent."""

    topic: str
    publisher: str
    parent: str
    child: str
    is_static: bool


@dataclass(frozen=True, slots=True, eq=False)
class Transforms:
    """Transforms in the order of arrival, as columns.

    Attributes:
        receive_ns: shape (N,), when each was heard [ns].
        stamp_ns: shape (N,), when each held [ns].
        message: shape (N,), transforms of one message have the same number.
        label: shape (N,), an index into `labels`.
        numbers: shape (N, 7), x, y, z [m], qx, qy, qz, qw.
        labels: in the order of first mention.
    """

    receive_ns: np.ndarray
    stamp_ns: np.ndarray
    message: np.ndarray
    label: np.ndarray
    numbers: np.ndarray
    labels: tuple[TransformLabel, ...]

    def __len__(self) -> int:
        return len(self.stamp_ns)


class Headers(NamedTuple):
    """The headers of one topic of stamped messages.

    Attributes:
        receive_ns, stamp_ns: shape (n,) [ns].
        frame: shape (n,), an index into `frames`.
    """

    topic: str
    msgtype: str
    receive_ns: np.ndarray
    stamp_ns: np.ndarray
    frame: np.ndarray
    frames: tuple[str, ...]


class Clock(NamedTuple):
    """What /clock said, and when: shape (n,) [ns] each."""

    receive_ns: np.ndarray
    time_ns: np.ndarray


class JointStates(NamedTuple):
    """One topic of joint states: when, which joints, where [rad or m]; one entry a message."""

    topic: str
    stamp_ns: np.ndarray
    names: tuple[tuple[str, ...], ...]
    positions: tuple[tuple[float, ...], ...]


class Unfinished(NamedTuple):
    """What is missing of a recording, which command repairs it, and whether messages may be missing.

    Attributes:
        code: "unfinished" if its recorder was killed, "file-missing" if a file of several is gone, "file-renamed"
            if it has another name.
    """

    what: str
    remedy: str
    is_cut: bool
    code: str = "unfinished"


class Odometry(NamedTuple):
    """One topic of odometry: shape (n,) [ns], and (n, 7): x, y, z [m], qx, qy, qz, qw."""

    topic: str
    frame: str
    child: str
    stamp_ns: np.ndarray
    numbers: np.ndarray


def _no_times() -> np.ndarray:
    return np.zeros(0, dtype=np.int64)


@dataclass(frozen=True, slots=True, eq=False)
class Recording:
    """Everything about transforms and time that a bag, or a listener, has heard.

    Attributes:
        name: where it comes from, for people.
        connections: every topic, also those that are not looked into.
        transforms: in the order of arrival.
        headers, joint_states, odometry: of the other topics.
        clock: what /clock said; empty if it was not recorded.
        robot_description: the URDF that was published, "" if none.
        begin_ns, end_ns: first and last moment of receipt [ns].
        notes: what the reader had to pass over, in sentences.
        unfinished: what it lacks if its recorder was killed, or a file of it is gone.
        is_ros1: whether it comes from ROS 1.
    """

    name: str
    connections: tuple[Connection, ...]
    transforms: Transforms
    headers: tuple[Headers, ...] = ()
    clock: Clock = field(default_factory=lambda: Clock(_no_times(), _no_times()))
    joint_states: tuple[JointStates, ...] = ()
    odometry: tuple[Odometry, ...] = ()
    robot_description: str = ""
    begin_ns: int = 0
    end_ns: int = 0
    notes: tuple[str, ...] = ()
    unfinished: Unfinished | None = None
    is_ros1: bool = False

    def namespaces(self) -> tuple[str, ...]:
        """Return the namespaces with transforms, sorted: "" for /tf, "/robot1" for /robot1/tf."""
        return tuple(sorted({namespace_of(label.topic) for label in self.transforms.labels}))

    def records(self) -> list[TransformRecord]:
        """Return every transform as an object of its own, in the order of arrival."""
        table = self.transforms
        records = []
        columns = (table.receive_ns.tolist(), table.stamp_ns.tolist(), table.label.tolist(), table.numbers.tolist())
        for receive_ns, stamp_ns, label, numbers in zip(*columns, strict=True):
            topic, publisher, parent, child, is_static = table.labels[label]
            stamped = StampedTransform(parent, child, stamp_ns, Transform(numbers[:3], numbers[3:]))
            records.append(TransformRecord(topic, receive_ns, publisher, stamped, is_static))
        return records

    def buffer(self, cache_time_ns: int | None = None, namespace: str | None = None) -> BufferCore:
        """Return a buffer that has heard all transforms, in the order of arrival.

        Args:
            cache_time_ns: as for BufferCore [ns]; None keeps the whole recording.
            namespace: which robot's transforms, if there are several ("/robot1" for /robot1/tf).

        Raises:
            ValueError: there are transforms in several namespaces and none is named, or not in this one.
        """
        rows = self._rows_of_namespace(namespace)
        table = self.transforms
        stamps = table.stamp_ns[rows]
        if cache_time_ns is None:
            cache_time_ns = int(stamps.max()) - int(stamps.min()) + EXTRA_CACHE_NS if len(rows) else EXTRA_CACHE_NS
        buffer = BufferCore(cache_time_ns)
        for first, rows_together in _in_order_of_arrival(table, rows):
            label = table.labels[table.label[first]]
            authority = label.publisher or DEFAULT_AUTHORITY
            numbers = table.numbers[rows_together]
            if len(rows_together) > 1:
                buffer.set_transforms(
                    label.parent, label.child, table.stamp_ns[rows_together], numbers[:, :3], numbers[:, 3:], authority
                )
            else:
                row = numbers[0].tolist()
                stamped = StampedTransform(
                    label.parent, label.child, int(table.stamp_ns[first]), Transform(row[:3], row[3:])
                )
                buffer.set_transform(stamped, authority, label.is_static)
        return buffer

    def _rows_of_namespace(self, namespace: str | None) -> np.ndarray:
        namespaces = self.namespaces()
        if namespace is None and len(namespaces) > 1:
            raise ValueError(f"{self.name} has transforms in several namespaces, name one of them: {namespaces}")
        if namespace is not None and namespace not in namespaces:
            raise ValueError(f'{self.name} has no transforms in namespace "{namespace}"; it has {namespaces}')
        table = self.transforms
        if len(namespaces) < 2:
            return np.arange(len(table))
        wanted = np.array([namespace_of(label.topic) == namespace for label in table.labels])
        return np.flatnonzero(wanted[table.label])


def namespace_of(topic: str) -> str:
    """Return "/robot1" of "/robot1/tf_static", and "" of "/tf"."""
    return topic.rpartition("/")[0]


def recording_from_records(records: Sequence[TransformRecord], name: str = "records") -> Recording:
    """Return the recording of a stream of transforms in the order of arrival."""
    labels: dict[TransformLabel, int] = {}
    column = []
    message = []
    previous = None
    for record in records:
        stamped = record.stamped
        label = TransformLabel(
            record.topic, record.publisher, stamped.frame_id, stamped.child_frame_id, record.is_static
        )
        column.append(labels.setdefault(label, len(labels)))
        together = (record.topic, record.publisher, record.receive_ns)
        message.append((message[-1] if message else -1) + (together != previous))
        previous = together
    receive_ns = np.array([record.receive_ns for record in records], dtype=np.int64)
    senders = [label[:2] for label in labels]  # topic, publisher
    messages: dict[tuple[str, str], set[int]] = {}
    for number, i in zip(message, column, strict=True):
        messages.setdefault(senders[i], set()).add(number)
    return Recording(
        name=name,
        connections=tuple(
            Connection(topic, "tf2_msgs/msg/TFMessage", publisher, (), len(numbers))
            for (topic, publisher), numbers in sorted(messages.items())
        ),
        transforms=Transforms(
            receive_ns=receive_ns,
            stamp_ns=np.array([record.stamped.stamp_ns for record in records], dtype=np.int64),
            message=np.array(message, dtype=np.int64),
            label=np.array(column, dtype=np.int64),
            numbers=np.array(
                [(*r.stamped.transform.translation, *r.stamped.transform.rotation) for r in records], dtype=float
            ).reshape(-1, 7),
            labels=tuple(labels),
        ),
        begin_ns=int(receive_ns.min()) if len(receive_ns) else 0,
        end_ns=int(receive_ns.max()) if len(receive_ns) else 0,
    )


def _in_order_of_arrival(table: Transforms, rows: np.ndarray) -> list[tuple[int, np.ndarray]]:
    """Return (first row, rows to insert together), such that the buffer ends up as if fed one by one.

    A child that always came in the same way and ever newer may go in at once, at
    the moment of its first row; the rows of any other child go in alone.  So
    names keep their numbers, and who overwrites whom stays as it was.
    """
    groups = []
    label = table.label[rows]
    by_label = rows[np.argsort(label, kind="stable")]
    bounds = np.flatnonzero(np.diff(table.label[by_label])) + 1
    of_child: dict[str, list[np.ndarray]] = {}
    for group in np.split(by_label, bounds) if len(by_label) else []:
        of_child.setdefault(table.labels[table.label[group[0]]].child.removeprefix("/"), []).append(group)
    for parts in of_child.values():
        together = parts[0]
        label = table.labels[table.label[together[0]]]
        if len(parts) == 1 and not label.is_static and _is_sound_and_ever_newer(table, together):
            groups.append((int(together[0]), together))
        else:
            groups.extend((row, np.array([row])) for part in parts for row in part.tolist())
    return sorted(groups, key=lambda group: group[0])


def _is_sound_and_ever_newer(table: Transforms, rows: np.ndarray) -> bool:
    """Return whether a buffer would accept all of these, each after the one before."""
    numbers = table.numbers[rows]
    return bool(
        (np.diff(table.stamp_ns[rows]) > 0).all() and np.isfinite(numbers).all() and numbers[:, 3:].any(axis=1).all()
    )
