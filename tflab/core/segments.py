"""Interpolate between two samples: linear in position, slerp in rotation.

    sample i                                sample i + 1
       o------------------x---------------------o
    start_ns          stamp_ns
       `---- ratio ------'                           position: (1 - ratio) * start + ratio * end
                                                     rotation: slerp(start, end, ratio)

A `Segment` holds what does not depend on the stamp. It is computed once for two
neighbours and cached, as is the pose at a sample: the second lookup of an edge takes a
third of the time. `Segments` is the cache of one history, by index, so it must be
cleared when samples get other indices, and only then (`TimeCache._renumbered`).

tf2 computes everything anew each time (TimeCache::interpolate). (Spherical linear
interpolation; memoization.)
"""

from __future__ import annotations

from math import acos, cos, sin, sqrt

from .poses import A_BIT, Pose, through_matrix

__all__ = ["Segment", "Segments"]

SEGMENTS_REMEMBERED = 1024  # for each edge: ten seconds at 100 Hz
POSES_REMEMBERED = 64
SEGMENT_BYTES, POSE_BYTES = 750, 300  # each, in CPython on 64 bits; compiled, a segment takes a third


class Segment:
    """The way from one sample to the next; what does not depend on the moment is worked out once, here.

    The rotation is `quaternions.slerp` from a to b, with what does not depend on
    the ratio taken out: a turn by ratio * theta in the plane of a and of the unit
    quaternion at right angles to it, (b - cos(theta) a) / sin(theta).
    """

    __slots__ = ("_end", "_rate", "_scale", "_start", "_theta", "end_ns", "start_ns")

    def __init__(self, start_ns: int, end_ns: int, start: Pose, end: Pose) -> None:
        """Take the stamps of two samples [ns], and both as sent, with quaternions of any length."""
        aa, ab, bb = _products(start, end)
        if not (1e-300 < aa < 1e300 and 1e-300 < bb < 1e300 and abs(ab) > A_BIT * sqrt(aa * bb)):
            # a length out of all proportion; or half a turn apart, where the last digit decides which way round
            start, end = through_matrix(start), through_matrix(end)
            aa, ab, bb = _products(start, end)
        theta = acos(min(1.0, abs(ab) / sqrt(aa * bb)))
        # what is to be taken of a, and of b or -b (one rotation: the one that goes the short way)
        a, b = 0.0, 0.0
        if theta > 0.0:
            b = (-1.0 if ab < 0.0 else 1.0) / (sqrt(bb) * sin(theta))
            a = b * ab / aa
        _, _, _, ax, ay, az, aw = start
        x, y, z, bx, by, bz, bw = end
        self.start_ns = start_ns
        self.end_ns = end_ns
        self._rate = 1.0 / (end_ns - start_ns)  # [1/ns]
        self._theta = theta  # [rad]
        self._scale = 1.0 / sqrt(aa)
        self._start = start
        self._end: Pose = (x, y, z, bx * b - ax * a, by * b - ay * a, bz * b - az * a, bw * b - aw * a)

    def pose_at(self, stamp_ns: int) -> Pose:
        """Return the pose at a moment between both samples."""
        x0, y0, z0, ax, ay, az, aw = self._start
        x1, y1, z1, bx, by, bz, bw = self._end
        ratio = (stamp_ns - self.start_ns) * self._rate
        back = 1.0 - ratio
        a, b = cos(ratio * self._theta) * self._scale, sin(ratio * self._theta)
        return (
            back * x0 + ratio * x1,
            back * y0 + ratio * y1,
            back * z0 + ratio * z1,
            a * ax + b * bx,
            a * ay + b * by,
            a * az + b * bz,
            a * aw + b * bw,
        )


def _products(start: Pose, end: Pose) -> tuple[float, float, float]:
    """Return the dot products of two poses' quaternions: a a, a b, b b."""
    _, _, _, ax, ay, az, aw = start
    _, _, _, bx, by, bz, bw = end
    return (
        ax * ax + ay * ay + az * az + aw * aw,
        ax * bx + ay * by + az * bz + aw * bw,
        bx * bx + by * by + bz * bz + bw * bw,
    )


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
