"""Where is the child between two samples?  On a straight line, turning along the shorter arc.

    sample i                                sample i + 1
       o------------------x---------------------o
    start_ns          stamp_ns
       `---- ratio ------'                           position: (1 - ratio) * start + ratio * end
                                                     rotation: slerp(start, end, ratio)

What does not depend on the moment, a `Segment`, is worked out once for two
neighbours and remembered, and so is the pose at a sample: asked a second time,
one edge costs a third.  `Segments` is all that a history remembers besides its
samples.  It goes by their index, so it has to be forgotten when samples get other
indices, and never else: see `TimeCache._renumbered`, the only place that does.

tf2 works everything out anew each time (TimeCache::interpolate).  (Spherical linear
interpolation; memoization.)  Read `cache.py` next.
"""

from __future__ import annotations

from math import acos, cos, sin

from .poses import A_BIT, Pose, through_matrix

__all__ = ["Segment", "Segments", "pose_within", "segment_between"]

SEGMENTS_REMEMBERED = 1024  # for each edge: ten seconds at 100 Hz
POSES_REMEMBERED = 64
SEGMENT_BYTES, POSE_BYTES = 750, 300  # each, in CPython on 64 bits

# start [ns], 1 / duration [1/ns], angle [rad],
# position and rotation at the start, position at the end and the rotation's perpendicular: see segment_between
Segment = tuple[
    int, float, float,
    float, float, float, float, float, float, float, float, float, float, float, float, float, float,
]  # fmt: skip


class Segments:
    """What is remembered of one history: segments by the index of their older sample, poses by that of theirs."""

    def __init__(self) -> None:
        self.segments: dict[int, Segment] = {}
        self.poses: dict[int, Pose] = {}

    def remember_segment(self, i: int, segment: Segment) -> None:
        if len(self.segments) >= SEGMENTS_REMEMBERED:
            self.segments.clear()
        self.segments[i] = segment

    def remember_pose(self, i: int, pose: Pose) -> None:
        if len(self.poses) >= POSES_REMEMBERED:
            self.poses.clear()
        self.poses[i] = pose

    def forget(self) -> None:
        self.segments.clear()
        self.poses.clear()

    @property
    def nbytes(self) -> int:
        return SEGMENT_BYTES * len(self.segments) + POSE_BYTES * len(self.poses)


def segment_between(start_ns: int, end_ns: int, start: Pose, end: Pose) -> Segment:
    """Return what it takes to interpolate between two poses of unit rotation.

    This is `quaternions.slerp` from a to b, with what does not depend on the ratio
    taken out: a turn by ratio * theta in the plane of a and of the unit quaternion
    at right angles to it, (b - cos(theta) a) / sin(theta).
    """
    cosine = _cosine(start, end)
    if -A_BIT < cosine < A_BIT:  # half a turn apart: the last digit decides which way round, so take tf2's digits
        start, end = through_matrix(start), through_matrix(end)
        cosine = _cosine(start, end)
    x0, y0, z0, ax, ay, az, aw = start
    x, y, z, bx, by, bz, bw = end
    if cosine < 0.0:  # b and -b are one rotation: go the short way
        bx, by, bz, bw, cosine = -bx, -by, -bz, -bw, -cosine
    theta = acos(min(1.0, cosine))
    rate = 1.0 / (end_ns - start_ns)
    if theta == 0.0:
        return start_ns, rate, theta, x0, y0, z0, ax, ay, az, aw, x, y, z, 0.0, 0.0, 0.0, 0.0
    b = 1.0 / sin(theta)
    a = cosine * b
    bx, by, bz, bw = bx * b - ax * a, by * b - ay * a, bz * b - az * a, bw * b - aw * a
    return start_ns, rate, theta, x0, y0, z0, ax, ay, az, aw, x, y, z, bx, by, bz, bw


def _cosine(start: Pose, end: Pose) -> float:
    """Return the cosine of the angle between two unit quaternions."""
    _, _, _, ax, ay, az, aw = start
    _, _, _, bx, by, bz, bw = end
    return ax * bx + ay * by + az * bz + aw * bw


def pose_within(segment: Segment, stamp_ns: int) -> Pose:
    """Return the pose at a moment within a segment."""
    start_ns, rate, theta, x, y, z, ax, ay, az, aw, x1, y1, z1, bx, by, bz, bw = segment
    ratio = (stamp_ns - start_ns) * rate
    back = 1.0 - ratio
    a, b = cos(ratio * theta), sin(ratio * theta)
    return (
        back * x + ratio * x1,
        back * y + ratio * y1,
        back * z + ratio * z1,
        a * ax + b * bx,
        a * ay + b * by,
        a * az + b * bz,
        a * aw + b * bw,
    )
