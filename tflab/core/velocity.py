"""Compute the velocity of a frame from two transforms.

         start            stamp             end
    -------|----------------|----------------|------->  time
           `------- averaging interval ------'

The velocity is the motion of `tracking_frame`, seen from `observation_frame`, between
two lookups. Near the newest data the interval is moved back so that it ends there, as
in tf2.

tf2's BufferCore::lookupVelocity (0.39.1) uses the same interval, but rotates both
vectors by the wrong rotation, and multiplies two vectors element by element instead of
using the cross product. It is right only for frames that are not rotated against each
other. `lookup_velocity` computes the velocity; `lookup_velocity_as_tf2` computes what
a robot returns, for code that must agree with one.

Both get functions for the lookup and the newest stamp instead of a buffer. (Finite
differences; a twist.)
"""

from __future__ import annotations

import math
import sys
from collections.abc import Callable, Sequence
from typing import NamedTuple

from . import quaternions
from .errors import TransformException
from .quaternions import Vector3
from .stamps import NSEC_PER_SEC
from .transforms import StampedTransform

__all__ = ["Velocity", "lookup_velocity", "lookup_velocity_as_tf2"]


Ask = Callable[[str, str, int], StampedTransform]  # BufferCore.lookup_transform
Newest = Callable[[str, str], int]  # BufferCore.latest_common_time_ns


class Velocity(NamedTuple):
    """How `body_frame_id` moves.

    Attributes:
        frame_id: the frame in whose axes both vectors are written.
        body_frame_id: the frame that moves.
        stamp_ns: the middle of the interval [ns].
        linear: of the reference point [m/s].
        angular: [rad/s].
    """

    frame_id: str
    body_frame_id: str
    stamp_ns: int
    linear: Vector3
    angular: Vector3


def averaging_interval_ns(
    newest: Newest, observation_frame: str, tracking_frame: str, stamp_ns: int, averaging_ns: int
) -> tuple[int, int]:
    """Return (start, end) [ns] of the interval around a stamp, not newer than the newest data.

    It begins at 10 us after zero at the earliest, because zero would mean LATEST.
    """
    try:
        newest_ns = newest(observation_frame, tracking_frame)
    except TransformException:
        newest_ns = 0  # the first lookup will say why
    end_ns = min(stamp_ns + averaging_ns // 2, newest_ns)
    start_ns = max(10_000 + averaging_ns, end_ns) - averaging_ns
    return start_ns, end_ns


def lookup_velocity(
    ask: Ask,
    newest: Newest,
    tracking_frame: str,
    observation_frame: str,
    stamp_ns: int,
    averaging_ns: int,
    reference_frame: str | None,
    reference_point: Sequence[float],
    reference_point_frame: str | None,
) -> Velocity:
    """Return the velocity of `tracking_frame` in `observation_frame`: see BufferCore.lookup_velocity."""
    reference_frame = reference_frame or observation_frame
    reference_point_frame = reference_point_frame or tracking_frame
    start_ns, end_ns = averaging_interval_ns(newest, observation_frame, tracking_frame, stamp_ns, averaging_ns)
    start = ask(observation_frame, tracking_frame, start_ns).transform
    end = ask(observation_frame, tracking_frame, end_ns).transform
    interval_s = (end_ns - start_ns) / NSEC_PER_SEC
    if interval_s <= 0.0:  # as in tf2, where nothing moves in no time
        linear = angular = (0.0, 0.0, 0.0)
    else:
        (x0, y0, z0), (x1, y1, z1) = start.translation, end.translation
        linear = ((x1 - x0) / interval_s, (y1 - y0) / interval_s, (z1 - z0) / interval_s)
        angular = _angular(start.rotation, end.rotation, interval_s)

    # From the origin of the tracking frame to the reference point: add angular x lever.
    now = ask(observation_frame, tracking_frame, stamp_ns).transform
    point = ask(observation_frame, reference_point_frame, stamp_ns).transform.apply(reference_point)
    lever = tuple(p - o for p, o in zip(point, now.translation, strict=True))
    vx, vy, vz = _cross(angular, lever)
    linear = (linear[0] + vx, linear[1] + vy, linear[2] + vz)

    # From the axes of the observation frame to those of the reference frame.
    turn = ask(reference_frame, observation_frame, stamp_ns).transform.rotation
    return Velocity(
        frame_id=reference_frame,
        body_frame_id=tracking_frame,
        stamp_ns=start_ns + averaging_ns // 2,
        linear=quaternions.rotate(turn, linear),
        angular=quaternions.rotate(turn, angular),
    )


def lookup_velocity_as_tf2(
    ask: Ask,
    newest: Newest,
    tracking_frame: str,
    observation_frame: str,
    stamp_ns: int,
    averaging_ns: int,
    reference_frame: str | None = None,
    reference_point: Sequence[float] = (0.0, 0.0, 0.0),
    reference_point_frame: str | None = None,
) -> Velocity:
    """Return what tf2 0.39.1 answers, step by step and number by number.

    Raises:
        TransformException: as for BufferCore.lookup_transform.
    """
    reference_frame = reference_frame or observation_frame
    start_ns, end_ns = averaging_interval_ns(newest, observation_frame, tracking_frame, stamp_ns, averaging_ns)
    start = ask(observation_frame, tracking_frame, start_ns).transform
    end = ask(observation_frame, tracking_frame, end_ns).transform
    interval_s = (end_ns - start_ns) / NSEC_PER_SEC or math.nan

    x, y, z, w = quaternions.canonical(quaternions.multiply(quaternions.conjugate(start.rotation), end.rotation))
    sine = math.sqrt(max(0.0, 1.0 - w * w))
    axis = (x / sine, y / sine, z / sine) if sine * sine > 10 * sys.float_info.epsilon else (1.0, 0.0, 0.0)
    speed = 2.0 * math.acos(min(1.0, w)) / interval_s
    turning = tuple(speed * c for c in quaternions.rotate(start.rotation, axis))
    moving = tuple((b - a) / interval_s for a, b in zip(start.translation, end.translation, strict=True))

    reference_T_tracking = ask(reference_frame, tracking_frame, stamp_ns).transform
    origin, turn = reference_T_tracking.translation, reference_T_tracking.rotation
    point_frame = reference_point_frame or tracking_frame
    point = ask(reference_frame, point_frame, stamp_ns).transform.apply(reference_point)
    angular = quaternions.rotate(turn, turning)  # the axes were those of the observation frame, not the tracking one
    linear = tuple(
        v + c + w * (p - o)  # here a cross product was meant
        for v, c, w, p, o in zip(
            quaternions.rotate(turn, moving), _cross(origin, angular), angular, point, origin, strict=True
        )
    )
    return Velocity(reference_frame, tracking_frame, start_ns + averaging_ns // 2, linear, angular)


def _angular(start: quaternions.Quaternion, end: quaternions.Quaternion, interval_s: float) -> Vector3:
    """Return the steady turn [rad/s], in outer axes, that leads from one rotation to the other."""
    turn = quaternions.multiply(end, quaternions.conjugate(start))
    x, y, z, w = turn if turn[3] >= 0.0 else tuple(-c for c in turn)
    angle_rad = quaternions.angle((x, y, z, w))
    length = (x * x + y * y + z * z) ** 0.5
    if length == 0.0:
        return (0.0, 0.0, 0.0)
    speed = angle_rad / interval_s / length
    return (x * speed, y * speed, z * speed)


def _cross(a: Vector3, b: Vector3) -> Vector3:
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])
