"""E8.3: PointToMap: a point onto the map."""

from __future__ import annotations

import math

from tflab.core import ExtrapolationException, TransformException
from tflab.ros.messages import builtin_interfaces, geometry_msgs, std_msgs
from tflab.ros.time import Time
from tflab.workbook.tasks import Message, define_task

from .draws import _moved, _time, draw_drive, seen


def draw_detections(rng):
    """Draw points within the buffer, one before it, and one whose transform has not arrived."""
    rows = []
    for number, share in enumerate((0.1, 0.35, 0.6, 0.75, -0.3, 1.2, 0.15, -0.15)):
        buffer, start_s, end_s, sensor = draw_drive(rng, number)
        stamp_s = round(start_s + share * (end_s - start_s), 3)
        if share == 0.1:  # its nanosec starts with a zero, and without that zero there is a transform, too
            stamp_s = round(math.floor(start_s) + 0.045, 3)
        now_s = round(max(end_s, stamp_s) + float(rng.uniform(0.45, 0.7)), 3)
        if share == 0.1:  # it came at once, and transforms have gone on coming
            now_s = round(stamp_s + 0.3, 3)
        if share == 0.15:  # it is old, and transforms have come for what is now
            now_s = round(stamp_s + 0.9, 3)
        if share == -0.15:  # it is from before all transforms, and there are some for what is now
            now_s = round(start_s + 0.5, 3)
        rows.append((buffer, seen(rng, sensor, stamp_s), _time(now_s)))
    buffer, message, now = rows[2]
    unknown = seen(rng, "sonar_link", Time.from_msg(message.header.stamp).nanoseconds / 1e9)
    return [*rows, (buffer, unknown, now)]


def lookup_time(moment, stamp, now):
    """Return the time of the lookup."""
    right = Time.from_msg(stamp)
    return {
        "stamp": right,
        "latest": Time(),
        "now": now,
        "sec alone": Time(seconds=stamp.sec),
        "digits": Time(seconds=float(f"{stamp.sec}.{stamp.nanosec}")),
        "a tenth before now": Time(nanoseconds=now.nanoseconds - 100_000_000),
        "half way": Time(nanoseconds=(right.nanoseconds + now.nanoseconds) // 2),
    }[moment]


def look_up(buffer, names, moment, stamp, now):
    """Return the transform for one time, or for two: that of map and that of the sensor."""
    one, _, other = moment.partition(" and ")
    target_time, source_time = (lookup_time(each, stamp, now) for each in (one, other or one))
    if not other:
        return buffer.lookup_transform(*names, target_time)
    return buffer.lookup_transform_full(names[0], target_time, names[1], source_time, "odom")


def transform_to_map(buffer, message, now, *, ends="wanted first", target="map", source="the message's", moment="stamp",
               refusal="let through", move="all", stamp="kept", asks="nothing", label="true"):  # fmt: skip
    """Return the point, step by step; other arguments are mistakes."""
    if move == "label":
        return geometry_msgs.PointStamped(
            header=std_msgs.Header(stamp=message.header.stamp, frame_id=target), point=message.point
        )
    if asks == "for now" and not buffer.can_transform(target, message.header.frame_id, now):
        return None
    if asks.startswith("how old") and now.nanoseconds - Time.from_msg(message.header.stamp).nanoseconds > 400_000_000:
        if asks == "how old, and refuses":
            raise ExtrapolationException("too old")
        return None
    names = (target, message.header.frame_id if source == "the message's" else source)
    names = names[::-1] if ends == "swapped" else names
    try:
        transform = look_up(buffer, names, moment, message.header.stamp, now)
    except TransformException:
        if refusal == "let through":
            raise
        if refusal == "None":
            return None
        if refusal == "as it came":
            return message
        transform = buffer.lookup_transform(*names, now if refusal == "now" else Time())
    if move == "nothing":
        return message
    if move == "step":
        transform.transform.rotation = geometry_msgs.Quaternion(w=1.0)
    if move == "turn":
        transform.transform.translation = geometry_msgs.Vector3()
    if move == "turned back":
        transform.transform.rotation.z *= -1.0
    if move == "half turned":
        yaw = math.atan2(transform.transform.rotation.z, transform.transform.rotation.w)
        transform.transform.rotation = geometry_msgs.Quaternion(z=math.sin(yaw / 2), w=math.cos(yaw / 2))
    if move == "step taken off":
        step = transform.transform.translation
        transform.transform.translation = geometry_msgs.Vector3(x=-step.x, y=-step.y, z=-step.z)
        transform.transform.rotation = geometry_msgs.Quaternion(w=1.0)
    moved = _moved(message, transform)
    if move == "on the floor":
        moved.point.z = message.point.z
    moved = _moved(moved, transform) if move == "twice" else moved
    stamps = {"now": now.to_msg(), "zero": builtin_interfaces.Time(), "put back": message.header.stamp}
    moved.header.stamp = stamps.get(stamp, moved.header.stamp)
    moved.header.frame_id = "map" if label == "map" else moved.header.frame_id
    return moved


TASK = define_task(
    __file__,
    kind="F",
    points=4,
    answer="point_to_map",
    form=Message("geometry_msgs/msg/PointStamped", ("point", "header.frame_id", "header.stamp"), tolerance=0.002),
    inputs=draw_detections,
    variants=3,
    model=transform_to_map,
)
