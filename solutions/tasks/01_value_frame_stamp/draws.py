"""What several tasks of this chapter draw: points with two labels, at moments whose digits matter."""

from __future__ import annotations

from tflab.core import sec_nanosec_from_stamp, seconds
from tflab.ros.messages import builtin_interfaces, geometry_msgs, std_msgs
from tflab.ros.time import Time


def time(stamp_s):
    return Time(nanoseconds=seconds(stamp_s))


def point(frame_id, stamp_ns, x):
    sec, nanosec = sec_nanosec_from_stamp(stamp_ns)
    stamp = builtin_interfaces.Time(sec=sec, nanosec=nanosec)
    header = std_msgs.Header(stamp=stamp, frame_id=frame_id)
    return geometry_msgs.PointStamped(header=header, point=geometry_msgs.Point(x=x))
