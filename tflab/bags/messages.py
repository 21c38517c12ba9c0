"""Where in the bytes are the transforms?  A TFMessage on the wire, and the header of any message.

    CDR (ROS 2)      4 bytes about the encoding, then every number at a multiple of its own size
        count | sec nanosec | length frame_id\\0 .. | length child_frame_id\\0 .. | x y z qx qy qz qw | sec ...
    ROS 1            no padding, no closing zero, and a sequence number before each stamp
        count | seq sec nanosec | length frame_id | length child_frame_id | x y z qx qy qz qw | seq ...

A library can read any message, for which it needs the message's definition and
about 10 microseconds.  A recording holds a million TFMessages and always of this
one shape, so they are read here, names and numbers left as bytes.

The OMG calls the first encoding CDR (XCDR1).
"""

from __future__ import annotations

from collections.abc import Iterator
from struct import Struct

from tflab.core import NSEC_PER_SEC

__all__ = [
    "MalformedMessage",
    "clock_in",
    "header_in",
    "names_of_single",
    "single_in_cdr",
    "transforms_in_cdr",
    "transforms_in_ros1",
]

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
