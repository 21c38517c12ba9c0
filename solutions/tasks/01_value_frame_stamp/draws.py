"""What several tasks of this chapter draw: points with two labels, at moments whose digits matter."""

from __future__ import annotations

from tflab.core import sec_nanosec_from_stamp, seconds
from tflab.ros.clock_type import ClockType
from tflab.ros.messages import builtin_interfaces, geometry_msgs, std_msgs
from tflab.ros.time import Time


def time(stamp_s):
    return clock(seconds(stamp_s))


def clock(stamp_ns):
    """Return a moment as a node's own clock tells it: its kind is that of `Time.from_msg`, so the two compare."""
    return Time(nanoseconds=stamp_ns, clock_type=ClockType.ROS_TIME)


def point(frame_id, stamp_ns, x):
    sec, nanosec = sec_nanosec_from_stamp(stamp_ns)
    stamp = builtin_interfaces.Time(sec=sec, nanosec=nanosec)
    header = std_msgs.Header(stamp=stamp, frame_id=frame_id)
    return geometry_msgs.PointStamped(header=header, point=geometry_msgs.Point(x=x))
