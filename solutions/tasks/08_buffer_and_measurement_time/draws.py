"""Draw a driving robot for several tasks of chapter 08."""

from __future__ import annotations

import math

from tflab.core import StampedTransform, Transform, seconds
from tflab.ros.convert import msg_from_stamp, msg_from_stamped
from tflab.ros.messages import geometry_msgs, std_msgs
from tflab.ros.tf2.buffer import Buffer
from tflab.ros.time import ClockType, Time

SENSORS = ("laser_frame", "left/camera_link", "camera_link")


def draw_drive(rng, number):
    """Return a filled buffer, its first and newest common stamp [s], and the frame of a sensor, each in turn."""
    buffer = Buffer()
    start_s = float(rng.integers(2, 20))
    speed, way = float(rng.uniform(0.5, 1.5)), float(rng.choice([-1.0, 1.0]))
    yaw_rate = way * float(rng.uniform(0.4, 0.9))
    yaw = float(rng.uniform(-2.5, 2.5))
    x, y = rng.uniform(-2.0, 2.0, 2).tolist()
    for sensor in SENSORS:
        place = (0.2, float(rng.uniform(0.05, 0.2)), float(rng.uniform(0.1, 0.4)))
        mount = Transform.from_rpy(yaw=float(rng.uniform(0.4, 1.2)), translation=place)
        _put(buffer, "base_link", sensor, start_s, mount, is_static=True)
    for i in range(9):  # 5 Hz
        pose = Transform.from_rpy(yaw=yaw, translation=(x, y, 0.0))
        _put(buffer, "odom", "base_link", start_s + 0.2 * i, pose)
        x, y, yaw = x + 0.2 * speed * math.cos(yaw), y + 0.2 * speed * math.sin(yaw), yaw + 0.2 * yaw_rate
    before = Transform.from_rpy(
        yaw=float(rng.uniform(0.2, 0.6)), translation=tuple(rng.uniform(-1.0, 1.0, 3) * (1, 1, 0))
    )
    jump = Transform.from_rpy(yaw=0.12, translation=(0.25, -0.2, 0.0))
    for i in range(4):  # 2.5 Hz; the localiser corrects itself at the last one
        _put(buffer, "map", "odom", start_s + 0.4 * i, before if i < 3 else before @ jump)
    return buffer, start_s, start_s + 1.2, SENSORS[number % len(SENSORS)]


def _put(buffer, parent, child, stamp_s, pose, is_static=False):
    message = msg_from_stamped(StampedTransform(parent, child, seconds(stamp_s), pose))
    (buffer.set_transform_static if is_static else buffer.set_transform)(message, "robot")


def seen(rng, frame_id, stamp_s):
    x, y, z = rng.uniform((2.0, -1.5, 0.1), (5.0, 1.5, 0.6)).tolist()
    header = std_msgs.Header(stamp=msg_from_stamp(seconds(stamp_s)), frame_id=frame_id)
    return geometry_msgs.PointStamped(header=header, point=geometry_msgs.Point(x=x, y=y, z=z))


def _time(stamp_s):
    return Time(nanoseconds=seconds(stamp_s), clock_type=ClockType.ROS_TIME)  # as a node's own clock tells it


def _moved(message, transform):
    from tflab.ros.tf2.geometry import do_transform_point

    return do_transform_point(message, transform)
