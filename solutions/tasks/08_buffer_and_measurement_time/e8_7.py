"""E8.7: Where is it now?"""

from __future__ import annotations

import math

from tflab.core import TransformException
from tflab.ros.messages import geometry_msgs
from tflab.ros.time import Time
from tflab.workbook.tasks import Vector, define_task

from .draws import _moved, _time, draw_drive, seen


def draw_resting_objects(rng):
    """Draw objects while the robot drives on and the localiser corrects itself; two have no transform."""
    rows = []
    shares = ((0.05, 0.9), (0.2, 0.95), (0.35, 0.9), (0.1, 0.85), (0.5, 1.0), (0.3, 0.97), (0.4, 1.9), (-0.2, 0.8))
    for number, (share, later) in enumerate(shares):
        buffer, start_s, end_s, sensor = draw_drive(rng, number)
        stamp_s, now_s = (round(start_s + part * (end_s - start_s), 3) for part in (share, later))
        rows.append((buffer, seen(rng, sensor, stamp_s), _time(now_s)))
    return rows


def transform_to_base_link(buffer, message, now, *, sight="stamp", base="now", fixed="odom", target="base_link",
                 ends="wanted first", refusal="let through", move="all", source="the message's"):  # fmt: skip
    """Return the coordinates, step by step; other arguments are mistakes."""
    if move == "not":
        return (message.point.x, message.point.y, message.point.z)
    if move in ("at one moment", "mount"):  # which never changes, so no moment is refused
        mount = buffer.lookup_transform(target, message.header.frame_id, Time())
        place = _moved(message, mount).point if move == "at one moment" else mount.transform.translation
        return (place.x, place.y, place.z)
    if move in ("base taken off", "base turned on"):
        seen_in_odom = _moved(message, buffer.lookup_transform("odom", message.header.frame_id, message.header.stamp))
        base = buffer.lookup_transform("odom", "base_link", now).transform
        x, y, z = (getattr(seen_in_odom.point, name) - getattr(base.translation, name) for name in "xyz")
        yaw = 2.0 * math.atan2(base.rotation.z, base.rotation.w) if move == "base turned on" else 0.0
        return (x * math.cos(yaw) - y * math.sin(yaw), x * math.sin(yaw) + y * math.cos(yaw), z)
    if move in ("step taken off", "step added"):
        seen = _moved(message, buffer.lookup_transform(target, message.header.frame_id, message.header.stamp)).point
        then, later = (
            buffer.lookup_transform("odom", "base_link", moment).transform.translation
            for moment in (message.header.stamp, now)
        )
        way = -1.0 if move == "step taken off" else 1.0
        return tuple(getattr(seen, name) + way * (getattr(later, name) - getattr(then, name)) for name in "xyz")
    if move == "second from map":
        seen_in_odom = _moved(message, buffer.lookup_transform("odom", message.header.frame_id, message.header.stamp))
        point = _moved(seen_in_odom, buffer.lookup_transform(target, "map", now)).point
        return (point.x, point.y, point.z)
    if move in ("second way round", "first way round"):
        first, second = ("odom", message.header.frame_id, message.header.stamp), (target, "odom", now)
        for one, other, moment in (first, second):
            is_round = (one == "odom") is (move == "first way round")
            message = _moved(message, buffer.lookup_transform(*((other, one) if is_round else (one, other)), moment))
        return (message.point.x, message.point.y, message.point.z)
    times = {"stamp": Time.from_msg(message.header.stamp), "now": now, "latest": Time()}
    times["sec alone"] = Time(seconds=message.header.stamp.sec)
    target = message.header.frame_id if target == "the sensor" else target
    ends_at = [(target, times[base]), (message.header.frame_id if source == "the message's" else source, times[sight])]
    if target in ("odom", "map"):  # which rests: its time does not matter
        ends_at[0] = (target, times[sight])
    (one, one_time), (other, other_time) = ends_at if ends == "wanted first" else ends_at[::-1]
    one_time, other_time = (other_time, one_time) if ends == "names swapped" else (one_time, other_time)
    try:
        transform = buffer.lookup_transform_full(one, one_time, other, other_time, fixed)
    except TransformException:
        if refusal == "let through":
            raise
        if refusal == "None":
            return None
        transform = buffer.lookup_transform(one, other, Time())
    if move == "step alone":
        transform.transform.rotation = geometry_msgs.Quaternion(w=1.0)
    if move == "turn alone":
        transform.transform.translation = geometry_msgs.Vector3()
    if move == "translation":
        return tuple(getattr(transform.transform.translation, name) for name in "xyz")
    moved = _moved(message, transform)
    moved = _moved(moved, transform) if move == "twice" else moved
    return (moved.point.x, moved.point.y, moved.point.z)


TASK = define_task(
    __file__,
    kind="F",
    points=4,
    answer="object_now",
    form=Vector(3, unit="m", frame="base_link", tolerance=0.002),
    inputs=draw_resting_objects,
    variants=3,
    model=transform_to_base_link,
)
