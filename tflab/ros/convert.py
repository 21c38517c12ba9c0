"""Convert between messages and engine values. No other module does.

```
geometry_msgs/TransformStamped  <->  StampedTransform
rclpy Time, builtin Time, ...    ->  integer nanoseconds
```
"""

from __future__ import annotations

import warnings
from typing import Any

from tflab.core import NSEC_PER_SEC, StampedTransform, Transform, sec_nanosec_from_stamp, stamp_from_sec_nanosec
from tflab.core.transforms import stamped_from_pose

from .messages import builtin_interfaces, geometry_msgs, std_msgs
from .messages.base import filled

__all__ = [
    "duration_ns_from",
    "msg_from_stamp",
    "msg_from_stamped",
    "msg_from_transform",
    "stamp_ns_from",
    "stamped_from_msg",
    "stampeds_from_plain_msgs",
]


def stamp_ns_from(time: Any) -> int:
    """Return the nanoseconds of an rclpy Time, a message, or anything alike.

    Raises:
        TypeError: it has neither `sec` and `nanosec` nor `nanoseconds`.
    """
    return _nanoseconds(time, "time")


def duration_ns_from(duration: Any) -> int:
    """Return the nanoseconds of an rclpy Duration, a message, or anything alike.

    Raises:
        TypeError: it has neither `sec` and `nanosec` nor `nanoseconds`.
    """
    return _nanoseconds(duration, "duration")


def _nanoseconds(value: Any, what: str) -> int:
    try:
        return stamp_from_sec_nanosec(value.sec, value.nanosec)
    except AttributeError:
        pass
    try:
        return int(value.nanoseconds)
    except AttributeError:
        raise TypeError(f"{what} must have sec and nanosec, or nanoseconds.") from None


def plain_names(*names: Any) -> list[Any]:
    """Return names as plain text: an Enum that is a str, too, is named by its value."""
    return [str.__str__(name) if isinstance(name, str) else name for name in names]


def msg_from_stamp(stamp_ns: int) -> builtin_interfaces.Time:
    """Return the message of a stamp [ns]."""
    sec, nanosec = sec_nanosec_from_stamp(stamp_ns)
    return builtin_interfaces.Time(sec=sec, nanosec=nanosec)


def stamped_from_msg(msg: Any) -> StampedTransform:
    """Return the engine's value of a geometry_msgs/TransformStamped, or of anything alike.

    Raises:
        TypeError: the translation is no Vector3, or a time or number is none.
    """
    header, transform = msg.header, msg.transform
    move, turn = transform.translation, transform.rotation
    if not isinstance(move, geometry_msgs.Vector3):
        warnings.warn("translation should be of type Vector3", UserWarning, stacklevel=3)
        raise TypeError("transform.translation must have members x, y, z")
    if not isinstance(turn, geometry_msgs.Quaternion):
        warnings.warn("rotation should be of type Quaternion", UserWarning, stacklevel=3)
    pose = tuple(map(float, (move.x, move.y, move.z, turn.x, turn.y, turn.z, turn.w)))
    return stamped_from_pose(*plain_names(header.frame_id, msg.child_frame_id), stamp_ns_from(header.stamp), pose)


def stampeds_from_plain_msgs(msgs: list) -> list[StampedTransform] | None:
    """Return the engine's values of some TransformStamped, or None if a field holds an unusual value.

    Nothing is lost: msg_from_stamped gives an equal message back.  Most traffic is
    of this kind, and it spares /tf a copy of every message.
    """
    stampeds = []
    for msg in msgs:
        if msg.__class__ is not geometry_msgs.TransformStamped:
            return None
        header, transform = msg.header, msg.transform
        stamp, move, turn = header.stamp, transform.translation, transform.rotation
        pose = (move.x, move.y, move.z, turn.x, turn.y, turn.z, turn.w)
        frame_id, child_frame_id, sec, nanosec = header.frame_id, msg.child_frame_id, stamp.sec, stamp.nanosec
        if (
            tuple(map(type, pose)) != _SEVEN_FLOATS
            or (type(frame_id), type(child_frame_id), type(sec), type(nanosec)) != _NAMES_AND_STAMP
            or not (0 <= sec < 2**31 and 0 <= nanosec < NSEC_PER_SEC)
        ):
            return None
        stampeds.append(stamped_from_pose(frame_id, child_frame_id, sec * NSEC_PER_SEC + nanosec, pose))
    return stampeds


_SEVEN_FLOATS = (float,) * 7
_NAMES_AND_STAMP = (str, str, int, int)


def msg_from_transform(transform: Transform) -> geometry_msgs.Transform:
    """Return the message of a transform; its numbers are floats, and fit."""
    move = filled(geometry_msgs.Vector3, *transform.translation)
    turn = filled(geometry_msgs.Quaternion, *transform.rotation)
    return filled(geometry_msgs.Transform, move, turn)


def msg_from_stamped(stamped: StampedTransform) -> geometry_msgs.TransformStamped:
    """Return the message of a stamped transform."""
    return geometry_msgs.TransformStamped(
        header=std_msgs.Header(stamp=msg_from_stamp(stamped.stamp_ns), frame_id=stamped.frame_id),
        child_frame_id=stamped.child_frame_id,
        transform=msg_from_transform(stamped.transform),
    )
