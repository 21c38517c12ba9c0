"""Convert messages to CDR bytes and back, and QoS profiles to the form that a bag stores.

    our message  <-- rosbags' object of the same fields -->  CDR
    QoSProfile   <-- rosbags' Qos -->  metadata.yaml, or the channel of an .mcap

Definitions and hashes that go into a bag are rosbags' own, those of Jazzy.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from struct import Struct
from typing import TYPE_CHECKING

from tflab.core import NSEC_PER_SEC
from tflab.ros.messages.packages import type_store
from tflab.ros.messages.values import message_from_object, object_from_message
from tflab.ros.qos import DurabilityPolicy, HistoryPolicy, LivelinessPolicy, QoSProfile, ReliabilityPolicy
from tflab.ros.time import Duration

__all__ = ["MalformedMessage", "bytes_of", "clock_in", "header_in", "message_of", "names_of_single",
           "profile_of", "qos_of", "single_in_cdr", "transforms_in_cdr", "transforms_in_ros1"]  # fmt: skip

if TYPE_CHECKING:
    from rosbags.interfaces import Qos

    from tflab.ros.messages.base import Message


def bytes_of(message: Message) -> bytes:
    """Return a message as CDR."""
    return bytes(type_store().serialize_cdr(object_from_message(message, type_store().types), message.ROS_TYPE))


def message_of(data: bytes, ros_type: str, is_ros1: bool = False) -> Message:
    """Return the message in these bytes.

    Raises:
        KeyError: we have no such type.
    """
    read = _ros1_store().deserialize_ros1 if is_ros1 else type_store().deserialize_cdr
    return message_from_object(ros_type, read(data, ros_type))


def qos_of(profile: QoSProfile) -> Qos:
    """Return a profile as rosbags writes it."""
    from rosbags import interfaces

    return interfaces.Qos(
        interfaces.QosHistory(profile.history),
        profile.depth,
        interfaces.QosReliability(profile.reliability),
        interfaces.QosDurability(profile.durability),
        _qos_time(profile.deadline),
        _qos_time(profile.lifespan),
        interfaces.QosLiveliness(profile.liveliness),
        _qos_time(profile.liveliness_lease_duration),
        profile.avoid_ros_namespace_conventions,
    )


def profile_of(qos: Qos) -> QoSProfile:
    """Return a recorded profile as one that a publisher can be made with."""
    return QoSProfile(
        history=HistoryPolicy.KEEP_LAST if qos.history.value > 2 else HistoryPolicy(qos.history.value),
        depth=qos.depth or 10,
        reliability=ReliabilityPolicy(qos.reliability.value),
        durability=DurabilityPolicy(qos.durability.value),
        deadline=_duration(qos.deadline),
        lifespan=_duration(qos.lifespan),
        liveliness=LivelinessPolicy[qos.liveliness.name]
        if qos.liveliness.name in LivelinessPolicy.__members__
        else LivelinessPolicy.SYSTEM_DEFAULT,
        liveliness_lease_duration=_duration(qos.liveliness_lease_duration),
        avoid_ros_namespace_conventions=qos.avoid_ros_namespace_conventions,
    )


@cache
def _ros1_store():
    """Return rosbags' table of ROS 1; Noetic's lacks tf2_msgs."""
    from rosbags.typesys import Stores, get_types_from_msg, get_typestore

    table = get_typestore(Stores.ROS1_NOETIC)
    table.register(get_types_from_msg("geometry_msgs/TransformStamped[] transforms\n", "tf2_msgs/msg/TFMessage"))
    return table


def _qos_time(duration: Duration):
    from rosbags.interfaces import QosTime

    return QosTime(*divmod(duration.nanoseconds, NSEC_PER_SEC))


def _duration(time) -> Duration:
    return Duration(nanoseconds=min(time.sec * NSEC_PER_SEC + time.nsec, 2**63 - 1))


ONE_TRANSFORM = b"\0\1\0\0" + b"\1\0\0\0"  # little-endian CDR, count 1
NUMBERS_SIZE = 7 * 8  # x, y, z, qx, qy, qz, qw as doubles

_little_u32, _big_u32 = Struct("<I"), Struct(">I")
_little_stamp, _big_stamp = Struct("<iII"), Struct(">iII")  # sec, nanosec, length of the name that follows
_little_time = Struct("<iI")
_ros1_stamp = Struct("<IIII")  # seq, sec, nanosec, length of the name that follows
_little_numbers, _big_numbers = Struct("<7d"), Struct(">7d")

RawTransform = tuple[int, bytes, bytes, bytes]  # stamp [ns], frame_id, child_frame_id, seven little-endian doubles


class MalformedMessage(Exception):
    """The bytes are not a message of the type that they should be."""


def transforms_in_cdr(data: bytes) -> Iterator[RawTransform]:
    """Yield the transforms of a tf2_msgs/msg/TFMessage of ROS 2.

    Raises:
        MalformedMessage, struct.error: the bytes are not one.
    """
    is_little = _is_little_endian(data)
    u32, stamp = (_little_u32, _little_stamp) if is_little else (_big_u32, _big_stamp)
    at = 8
    for _ in range(u32.unpack_from(data, 4)[0]):
        sec, nanosec, size = stamp.unpack_from(data, at)
        at += 12 + size
        parent = data[at - size : at - 1]
        at += -at % 4
        size = u32.unpack_from(data, at)[0]
        at += 4 + size
        child = data[at - size : at - 1]
        at += (4 - at) % 8  # doubles stand at multiples of eight, counted after the first four bytes
        numbers = data[at : at + NUMBERS_SIZE]
        at += NUMBERS_SIZE
        if at > len(data):
            raise MalformedMessage("a TFMessage that ends too early")
        if not is_little:
            numbers = _little_numbers.pack(*_big_numbers.unpack(numbers))
        yield sec * NSEC_PER_SEC + nanosec, parent, child, numbers


def transforms_in_ros1(data: bytes) -> Iterator[RawTransform]:
    """Yield the transforms of a tf2_msgs/TFMessage, or a tf/tfMessage, of ROS 1.

    Raises:
        MalformedMessage, struct.error: the bytes are not one.
    """
    at = 4
    for _ in range(_little_u32.unpack_from(data, 0)[0]):
        _, sec, nanosec, size = _ros1_stamp.unpack_from(data, at)
        at += 16 + size
        parent = data[at - size : at]
        size = _little_u32.unpack_from(data, at)[0]
        at += 4 + size
        child = data[at - size : at]
        numbers = data[at : at + NUMBERS_SIZE]
        at += NUMBERS_SIZE
        if at > len(data):
            raise MalformedMessage("a TFMessage that ends too early")
        yield sec * NSEC_PER_SEC + nanosec, parent, child, numbers


def names_of_single(data: bytes) -> bytes | None:
    """Return the bytes between the stamp and the numbers of a CDR message of one transform, else None.

    In such a message everything but stamp and numbers is fixed by the two names, so
    whoever has read one with the same bytes in between knows this one.
    """
    return data[16:-NUMBERS_SIZE] if data[:8] == ONE_TRANSFORM else None


def single_in_cdr(data: bytes) -> tuple[int, bytes]:
    """Return stamp [ns] and numbers of a message whose names are known; see names_of_single."""
    sec, nanosec = _little_time.unpack_from(data, 8)
    return sec * NSEC_PER_SEC + nanosec, data[-NUMBERS_SIZE:]


def header_in(data: bytes, is_ros1: bool) -> tuple[int, bytes]:
    """Return the stamp [ns] and the frame of a message that begins with a std_msgs/Header."""
    if is_ros1:
        _, sec, nanosec, size = _ros1_stamp.unpack_from(data, 0)
        return sec * NSEC_PER_SEC + nanosec, data[16 : 16 + size]
    stamp = _little_stamp if _is_little_endian(data) else _big_stamp
    sec, nanosec, size = stamp.unpack_from(data, 4)
    return sec * NSEC_PER_SEC + nanosec, data[16 : 15 + size]


def clock_in(data: bytes, is_ros1: bool) -> int:
    """Return the time [ns] in a rosgraph_msgs/Clock."""
    if is_ros1:
        sec, nanosec = _little_u32.unpack_from(data, 0)[0], _little_u32.unpack_from(data, 4)[0]
    else:
        u32 = _little_u32 if _is_little_endian(data) else _big_u32
        sec, nanosec = u32.unpack_from(data, 4)[0], u32.unpack_from(data, 8)[0]
    return sec * NSEC_PER_SEC + nanosec


def _is_little_endian(data: bytes) -> bool:
    if data[:2] == b"\0\1":
        return True
    if data[:2] == b"\0\0":
        return False
    raise MalformedMessage("not plain CDR")
