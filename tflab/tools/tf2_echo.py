"""Run `tf2_echo A B`: print the transform again and again.

    tf2_echo map base_link      ->     lookup_transform("map", "base_link", LATEST)
             "source"  "target"                        target   source

The tool calls its first argument source_frame and its second target_frame: the
other way round than lookup_transform does.  The pitch of a level pose prints as
-0.000, and the stamp without leading zeros in its nanoseconds: so it is upstream.

upstream: tf2_ros/src/tf2_echo.cpp.
"""

from __future__ import annotations

import math
import sys
from collections.abc import Sequence

from tflab.core import LATEST, NSEC_PER_SEC, StampedTransform, TransformException, sec_nanosec_from_stamp
from tflab.core.quaternions import to_matrix
from tflab.ros import distro

from .cpp_numbers import stod
from .session import abort, cpp_listener, spin_for, tool_node

__all__ = ["USAGE", "echo_text", "failure_text", "main", "rpy_from_matrix"]

SHORTEST_PERIOD_S = 0.001  # nobody prints faster, whatever the rate; and virtual time must pass

USAGE = """\
Usage: tf2_echo source_frame target_frame [echo_rate]

This will echo the transform from the coordinate frame of the source_frame
to the coordinate frame of the target_frame. 
Note: This is the transform to get data from target_frame into the source_frame.
Default echo rate is 1 if echo_rate is not given."""  # noqa: W291 - upstream's own blank


def echo_text(stamped: StampedTransform, names_quaternion_order: bool = False) -> str:
    """Return one reading as the tool prints it."""
    sec, nanosec = sec_nanosec_from_stamp(stamped.stamp_ns)
    x, y, z = stamped.transform.translation
    matrix = to_matrix(stamped.transform.rotation)
    rpy = rpy_from_matrix(matrix)
    order = " (xyzw)" if names_quaternion_order else ""
    rows = [*(f" {_cells((*row, step))}" for row, step in zip(matrix, (x, y, z), strict=True))]
    lines = [
        f"At time {sec}.{nanosec}",
        f"- Translation: {_list((x, y, z))}",
        f"- Rotation: in Quaternion{order} {_list(stamped.transform.rotation)}",
        f"- Rotation: in RPY (radian) {_list(rpy)}",
        f"- Rotation: in RPY (degree) {_list(tuple(angle * 180.0 / math.pi for angle in rpy))}",
        "- Matrix:",
        *rows,
        f" {_cells((0.0, 0.0, 0.0, 1.0))}",
    ]
    return "\n".join(lines)


def rpy_from_matrix(matrix: Sequence[Sequence[float]]) -> tuple[float, float, float]:
    """Return roll, pitch, yaw [rad] as tf2's Matrix3x3::getRPY does; straight up or down, yaw is 0."""
    m20 = matrix[2][0]
    if abs(m20) >= 1:
        return (math.atan2(matrix[2][1], matrix[2][2]), math.copysign(math.pi / 2, -m20), 0.0)
    pitch = -math.asin(m20)
    side = math.cos(pitch)
    roll = math.atan2(matrix[2][1] / side, matrix[2][2] / side)
    return (roll, pitch, math.atan2(matrix[1][0] / side, matrix[0][0] / side))


def waiting_text(source: str, target: str, reason: str) -> str:
    """Return what C++ tools log while there is nothing to look up yet."""
    return f"Waiting for transform {source} ->  {target}: {reason}"


def failure_text(now_s: float, reason: str, frames: str) -> str:
    """Return what is printed when a lookup fails that could once be answered."""
    return f"Failure at {now_s:.3f}\nException thrown:{reason}\nThe current list of frames is:\n{frames}"


def _list(values: Sequence[float]) -> str:
    return f"[{', '.join(f'{value:.3f}' for value in values)}]"


def _cells(values: Sequence[float]) -> str:
    return " ".join(f"{value:6.3f}" for value in values)


def main(arguments: Sequence[str]) -> int:
    """Print until stopped; return the exit code."""
    if len(arguments) not in (2, 3):
        print(USAGE)
        return 1
    rate_hz = 1.0
    if len(arguments) == 3:
        no_number = f"Failed to convert rate argument '{arguments[2]}' to a floating-point number"
        try:
            rate_hz, is_all = stod(arguments[2])
        except ValueError:
            print(no_number, file=sys.stderr)
            return 2
        if not is_all:
            print(no_number, file=sys.stderr)
            return 3
    if not rate_hz > 0:
        return abort("std::invalid_argument", "rate must be greater than 0")
    return _echo(*arguments[:2], period_s=max(1.0 / rate_hz, SHORTEST_PERIOD_S))


def _echo(source: str, target: str, period_s: float) -> int:
    with tool_node("tf2_echo") as node, cpp_listener(node) as core:
        while not (answer := core.why_not(source, target, LATEST))[0]:
            node.get_logger().info(waiting_text(source, target, answer[1]), throttle_duration_sec=1.0)
            spin_for(node, period_s)
        while True:
            try:
                stamped = core.lookup_transform(source, target, LATEST)
                print(echo_text(stamped, distro.current().names_quaternion_order), flush=True)
            except TransformException as fault:
                now_s = node.get_clock().now().nanoseconds / NSEC_PER_SEC
                print(failure_text(now_s, str(fault), core.all_frames_as_string()), flush=True)
            spin_for(node, period_s)
