"""Draw what several tasks of chapter 01 need: points with two labels, at times whose digits matter."""

from __future__ import annotations

from tflab.core import sec_nanosec_from_stamp, seconds
from tflab.ros.messages import builtin_interfaces, geometry_msgs, std_msgs
from tflab.ros.time import ClockType, Time


def ros_time(stamp_s):
    return time_from_ns(seconds(stamp_s))


def time_from_ns(stamp_ns):
    """Return a time on a node's clock, so that it compares with `Time.from_msg`."""
    return Time(nanoseconds=stamp_ns, clock_type=ClockType.ROS_TIME)


def make_point(frame_id, stamp_ns, x):
    sec, nanosec = sec_nanosec_from_stamp(stamp_ns)
    stamp = builtin_interfaces.Time(sec=sec, nanosec=nanosec)
    header = std_msgs.Header(stamp=stamp, frame_id=frame_id)
    return geometry_msgs.PointStamped(header=header, point=geometry_msgs.Point(x=x))
