"""Fill buffers and name exceptions for several tasks of chapter 09."""

from __future__ import annotations

from tflab.core import BufferCore, StampedTransform, Transform, TransformException, seconds
from tflab.ros.tf2.buffer import Buffer
from tflab.ros.time import Duration, Time


def edge(parent: str, child: str, *times_s: float, x: float = 0.1) -> list[StampedTransform]:
    """Return one transform for each time [s]; with none it is static."""
    return [StampedTransform(parent, child, seconds(t), Transform((x, 0.0, 0.0))) for t in times_s or (0.0,)]


def fill(buffer: BufferCore | Buffer, *edges: list[StampedTransform]):
    """Put edges into a buffer and return it; those at 0 s are static."""
    store = buffer.core if isinstance(buffer, Buffer) else buffer
    for stamped in (one for each in edges for one in each):
        store.set_transform(stamped, "robot", is_static=stamped.stamp_ns == 0)
    return buffer


def make_buffer(t: float, *, is_localized: bool = True, wheels_s: float = 4.5) -> Buffer:
    """Return a buffer with map <- laser_frame from `t` + 1 to `t` + 4 [s], or without map."""
    return fill(
        Buffer(Duration(seconds=20)),
        edge("map", "odom", t, t + 2.0, t + 4.0) if is_localized else [],
        edge("odom", "base_footprint", t + 1.0, t + 2.5, t + wheels_s),
        edge("base_footprint", "base_link"),
        edge("base_link", "laser_frame", x=0.2),
        edge("base_link", "tool0", t + 2.0),
        edge("base_link", "gripper_link", t + 1.0, t + 2.5, t + 3.6),
        edge("base_lnk", "camera_link"),
        edge("base_link", "left/future_lamp"),
        edge("base_link", "right/past_lamp"),
    )


def refusal_of(buffer: Buffer, target: str, source: str, stamp: Time) -> TransformException | None:
    """Return the exception of a lookup, or None if it succeeds."""
    try:
        buffer.lookup_transform(target, source, stamp)
    except TransformException as error:
        return error
    return None


def kind_of(error: TransformException | None) -> str:
    """Return the kind of an exception, as the task names them."""
    if error is None:
        return "ok"
    directions = {"future": "future", "past": "past", "no_data": "one sample"}
    names = {"LookupException": "lookup", "ConnectivityException": "connectivity"}
    return directions.get(getattr(error, "direction", "")) or names.get(type(error).__name__, "invalid argument")
