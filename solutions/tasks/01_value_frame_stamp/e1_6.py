"""E1.6: Fill in frame and stamp."""

from __future__ import annotations

from tflab.ros.messages import builtin_interfaces
from tflab.workbook.tasks import Message, define_task

from .draws import make_point, ros_time


def draw_measurements(rng):
    rows = []
    for number in range(5):
        late_s = 0.6 if number == 3 else 0.0  # in its second, where who rounds has the next one
        measured_s = round(float(rng.integers(3, 60)) + float(rng.uniform(0.011, 0.099)) + late_s, 3 + number % 2 * 3)
        age_ms = int(rng.integers(40, 500)) + (1200 if number == 4 else 0)  # one is older than a second
        hair_m = 0.004 if number == 2 else 0.0  # what a range to centimetres has lost
        range_m = round(round(float(rng.uniform(0.4, 6.0)), 2) + hair_m, 3)
        rows.append((range_m, ros_time(measured_s + age_ms / 1e3), age_ms))
    return rows


def label_measurement(range_m, now, age_ms, *, frame="sonar_frame", moment="measured", sight="range", axis="y"):
    """Return the message, step by step; other arguments are mistakes."""
    now_ns, age_s = now.nanoseconds, age_ms / 1e3
    measured_ns = now_ns - age_ms * 10**6
    stamps_ns = {
        "measured": measured_ns,
        "now": now_ns,
        "zero": 0,
        "sec alone": measured_ns // 10**9 * 10**9,
        "age": now_ns - measured_ns,
        "after now": now_ns + age_ms * 10**6,
        "age in nanoseconds": now_ns - age_ms,
        "half way": (measured_ns + now_ns) // 2,
    }
    value = {"range": range_m, "none": 0.0, "age taken off": range_m - age_s, "age added": range_m + age_s,
             "centimetres": round(range_m, 2)}[sight]  # fmt: skip
    message = make_point(frame, stamps_ns.get(moment, 0), 0.0)
    if moment == "all in nanosec":
        message.header.stamp = builtin_interfaces.Time(sec=0, nanosec=measured_ns % 2**32)
    if moment == "milliseconds in nanosec":
        message.header.stamp = builtin_interfaces.Time(sec=measured_ns // 10**9, nanosec=measured_ns % 10**9 // 10**6)
    if moment == "sec rounded":
        message.header.stamp = builtin_interfaces.Time(sec=round(measured_ns / 1e9), nanosec=measured_ns % 10**9)
    for letter in axis:
        setattr(message.point, letter, value)
    return message


TASK = define_task(
    __file__,
    kind="C",
    points=3,
    answer="as_message",
    form=Message("geometry_msgs/msg/PointStamped", ("header.frame_id", "header.stamp", "point")),
    inputs=draw_measurements,
    variants=3,
    model=label_measurement,
)
