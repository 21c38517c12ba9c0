"""Where was the child at time t?  One edge of the tree, through time.

A frame's parent may move it, so every child frame keeps a short history of
samples.  This page knows nothing of trees or names: parents are numbers.

       insert                                  at(t)
         |                                       |
         v        oldest                         v        newest
    ----[+]----[ o-----o-------o-----o-----------?-----o-----o ]---->  time
     too old    `---------- at most cache_time ------------'

Between two samples the child moves on a straight line and turns along the
shorter arc.  Outside them there is no answer: tf2 never extrapolates.

A history is kept in columns, 68 bytes a sample, as it was sent.  What a lookup
needs of two neighbours (a `Segment`) is worked out once and remembered, in a
memo of bounded size that every change of the history keeps true.

tf2 calls these classes TimeCache and StaticCache (tf2/src/cache.cpp,
static_cache.cpp).  Read `tree.py` next.
"""

from __future__ import annotations

from array import array
from bisect import bisect_right
from math import acos, cos, sin, sqrt
from struct import Struct
from sys import getsizeof
from typing import NamedTuple

import numpy as np

from . import quaternions
from .stamps import LATEST
from .transforms import Pose

__all__ = ["Gap", "Sample", "StaticCache", "TimeCache"]

_seven_doubles = Struct("=7d").pack  # an array takes bytes twice as fast as a tuple of floats

SEGMENTS_REMEMBERED = 1024  # for each edge: ten seconds at 100 Hz

# start [ns, an int], 1 / duration [1/ns], both positions [m], rotation, its perpendicular, angle [rad]
Segment = tuple[float, ...]


class Gap(NamedTuple):
    """Why a history has no answer for a moment."""

    direction: str  # "past", "future" or "no_data"
    requested_ns: int
    bound_ns: int  # the end of the history on that side; 0 if it is empty


class Sample(NamedTuple):
    """One stored transform: who said where the child was, and when."""

    stamp_ns: int
    pose: Pose
    parent: int
    authority: str


class TimeCache:
    """A child that moves: its samples, oldest first, no older than `cache_time_ns` before the newest.

    With `refuse_repeated_stamps` a second sample with the same stamp is refused,
    whatever it says, as in ROS 2 Humble.
    """

    is_static = False

    def __init__(self, cache_time_ns: int, refuse_repeated_stamps: bool = False) -> None:
        self._cache_time_ns = cache_time_ns
        self._refuse_repeated_stamps = refuse_repeated_stamps
        self._cut_off = 0  # how many samples were ever removed from the columns
        self._stamps = array("q")
        self.clear()

    def clear(self) -> None:
        """Forget every sample."""
        self._cut_off += len(self._stamps)
        self._stamps = array("q")
        self._numbers = array("d")  # x, y, z, qx, qy, qz, qw of each sample, as sent
        self._labels = array("I")  # who sent it, under which parent: an index into _names
        self._names: list[tuple[int, str]] = []  # (parent, authority)
        self._first = 0  # samples before this index are dead; now and then they are cut off
        self._last_label = 0  # the label last given out, and to whom; None if it must not be used again
        self._last_authority: str | None = None
        self._segments: dict[int, Segment] = {}
        self.only_parent = 0  # the parent of every sample; 0 if they differ or there are none

    def __len__(self) -> int:
        return len(self._stamps) - self._first

    @property
    def version(self) -> tuple[int, int]:
        """Something that is different after every change: samples ever stored, samples ever dropped."""
        return self._cut_off + len(self._stamps), self._cut_off + self._first

    @property
    def newest_ns(self) -> int:
        """The newest stamp [ns], 0 if there is none."""
        return self._stamps[-1] if self._stamps else 0

    @property
    def oldest_ns(self) -> int:
        """The oldest stamp [ns], 0 if there is none."""
        return self._stamps[self._first] if self._stamps else 0

    @property
    def newest_parent(self) -> int:
        """The parent in the newest sample, 0 if there is none."""
        return self._names[self._labels[-1]][0] if self._labels else 0

    def insert(self, stamp_ns: int, numbers: tuple[float, ...], parent: int, authority: str) -> bool:
        """Keep a sample; return False if it is older than the history allows.

        `numbers` are x, y, z, qx, qy, qz, qw as sent: any length of quaternion
        that `quaternions.canonical` can make a rotation of.

        As in tf2, the history is pruned *before* the sample goes in, and also
        when the sample is then refused.  A sample equal to one already there is
        not stored twice, but counts as kept.
        """
        stamps = self._stamps
        if stamps:
            newest_ns = stamps[-1]
            horizon_ns = newest_ns - self._cache_time_ns
            if stamps[self._first] < horizon_ns:
                self._prune(horizon_ns)
            if stamp_ns <= newest_ns:
                return stamp_ns >= horizon_ns and self._insert_among(stamp_ns, numbers, parent, authority)
        if authority != self._last_authority or parent != self.only_parent:
            self._label(parent, authority)
        stamps.append(stamp_ns)
        self._numbers.frombytes(_seven_doubles(*numbers))
        self._labels.append(self._last_label)
        return True

    def extend(self, stamps_ns: np.ndarray, numbers: np.ndarray, parent: int, authority: str) -> None:
        """Keep many samples, each newer than the one before and than all that are stored.

        Shapes (N,), int64, and (N, 7), float64.
        """
        label = self._label(parent, authority)
        self._stamps.frombytes(stamps_ns.tobytes())
        self._numbers.frombytes(numbers.tobytes())
        self._labels.extend(array("I", [label]) * len(stamps_ns))
        if len(self) > 1:  # the last insert saw all the others
            self._prune(self._stamps[-2] - self._cache_time_ns)

    def has_stamp(self, stamp_ns: int) -> bool:
        """Return whether there is a sample with exactly this stamp."""
        i = bisect_right(self._stamps, stamp_ns, self._first) - 1
        return i >= self._first and self._stamps[i] == stamp_ns

    def at(self, stamp_ns: int) -> Pose | None:
        """Return the child's pose in its parent at `stamp_ns`, or None if the history does not reach."""
        i = bisect_right(self._stamps, stamp_ns, self._first) - 1
        segment = self._segments.get(i)
        if segment is None:
            if stamp_ns == LATEST or not self.oldest_ns < stamp_ns < self.newest_ns:
                i = self._find(stamp_ns)
                return None if i < 0 else self._pose(i)
            segment = self._segment(i)
        start_ns, rate, x, y, z, x1, y1, z1, ax, ay, az, aw, bx, by, bz, bw, theta = segment
        ratio = (stamp_ns - start_ns) * rate
        back = 1.0 - ratio
        turned = ratio * theta
        a, b = cos(turned), sin(turned)
        return (
            back * x + ratio * x1,
            back * y + ratio * y1,
            back * z + ratio * z1,
            a * ax + b * bx,
            a * ay + b * by,
            a * az + b * bz,
            a * aw + b * bw,
        )

    def parent_at(self, stamp_ns: int) -> int:
        """Return the parent at `stamp_ns` (of two samples, the older one's), or 0 if the history does not reach."""
        i = self._find(stamp_ns)
        return 0 if i < 0 else self._names[self._labels[i]][0]

    def gap(self, stamp_ns: int) -> Gap:
        """Return why `at(stamp_ns)` was None."""
        if len(self) < 2:
            return Gap("no_data", stamp_ns, self.newest_ns)
        if stamp_ns > self.newest_ns:
            return Gap("future", stamp_ns, self.newest_ns)
        return Gap("past", stamp_ns, self.oldest_ns)

    def samples(self) -> list[Sample]:
        """Return every sample, oldest first, in tf2's canonical form."""
        return [
            Sample(self._stamps[i], self._pose(i), *self._names[self._labels[i]])
            for i in range(self._first, len(self._stamps))
        ]

    def owners(self) -> set[tuple[int, str]]:
        """Return every (parent, authority) that a sample names."""
        return {self._names[label] for label in set(self._labels[self._first :])}

    def newest(self) -> Sample | None:
        """Return the newest sample."""
        last = len(self._stamps) - 1
        return Sample(self._stamps[last], self._pose(last), *self._names[self._labels[last]]) if len(self) else None

    def columns(self) -> tuple[array, array, int]:
        """Return the stamps, the numbers as sent (seven a sample) and the index of the first live sample.

        For reading only, and only while nobody inserts: `batch.py` makes tables of them.
        """
        return self._stamps, self._numbers, self._first

    def memory(self) -> tuple[int, int]:
        """Return (bytes of the stored columns, number of remembered segments)."""
        return sum(map(getsizeof, (self._stamps, self._numbers, self._labels))), len(self._segments)

    def _find(self, stamp_ns: int) -> int:
        """Return the index of the sample that answers for `stamp_ns`: the older of two; -1 if none does.

        Of several samples with one stamp the last to come answers, except at the
        old end of the history, where it is the first to come.  That is tf2's order.
        """
        stamps, first = self._stamps, self._first
        last = len(stamps) - 1
        if last < first:
            return -1
        if stamp_ns == LATEST or stamp_ns == stamps[last]:
            return last
        if stamp_ns == stamps[first]:
            return first
        if not stamps[first] < stamp_ns < stamps[last]:
            return -1
        return bisect_right(stamps, stamp_ns, first) - 1

    def _pose(self, i: int) -> Pose:
        """Return sample `i` in tf2's canonical form."""
        x, y, z, *rotation = self._numbers[7 * i : 7 * i + 7]
        return (x, y, z, *quaternions.canonical(rotation))

    def _segment(self, i: int) -> Segment:
        """Return, and remember, what it takes to interpolate between samples `i` and `i + 1`."""
        start_ns = self._stamps[i]
        x, y, z, ax, ay, az, aw = self._pose(i)
        x1, y1, z1, bx, by, bz, bw = self._pose(i + 1)
        rate = 1.0 / (self._stamps[i + 1] - start_ns)
        # Slerp from a to b, with what does not depend on the ratio taken out: a turn
        # by ratio * theta in the plane of a and the unit vector b at right angles to it.
        dot = ax * bx + ay * by + az * bz + aw * bw
        if dot < 0.0:
            bx, by, bz, bw, dot = -bx, -by, -bz, -bw, -dot
        lengths = sqrt((ax * ax + ay * ay + az * az + aw * aw) * (bx * bx + by * by + bz * bz + bw * bw))
        theta = acos(min(1.0, dot / lengths))
        if self._names[self._labels[i]][0] != self._names[self._labels[i + 1]][0]:
            rate = x1 = y1 = z1 = theta = 0.0  # another parent in between: tf2 does not blend, the older one holds
        if theta == 0.0:
            bx = by = bz = bw = 0.0
        else:
            c, s = cos(theta), 1.0 / sin(theta)
            bx, by, bz, bw = (bx - c * ax) * s, (by - c * ay) * s, (bz - c * az) * s, (bw - c * aw) * s
        if len(self._segments) >= SEGMENTS_REMEMBERED:
            self._segments.clear()
        segment = (start_ns, rate, x, y, z, x1, y1, z1, ax, ay, az, aw, bx, by, bz, bw, theta)
        # Not remembered: where _find, and not the order of the samples, decides.
        is_twin_of_oldest = start_ns == self.oldest_ns and i != self._first
        holds_latest = start_ns <= LATEST < self._stamps[i + 1]
        if not (is_twin_of_oldest or holds_latest):
            self._segments[i] = segment
        return segment

    def _insert_among(self, stamp_ns: int, numbers: tuple[float, ...], parent: int, authority: str) -> bool:
        """Keep a sample that is not newer than all others."""
        i = bisect_right(self._stamps, stamp_ns, self._first)
        twin = i - 1
        if self._refuse_repeated_stamps and twin >= self._first and self._stamps[twin] == stamp_ns:
            return False
        pose = (*numbers[:3], *quaternions.canonical(numbers[3:]))
        while twin >= self._first and self._stamps[twin] == stamp_ns:
            if self._pose(twin) == pose and self._names[self._labels[twin]][0] == parent:
                return True
            twin -= 1
        self._stamps.insert(i, stamp_ns)
        self._numbers[7 * i : 7 * i] = array("d", numbers)
        self._labels.insert(i, self._label(parent, authority))
        self._segments.clear()
        return True

    def _label(self, parent: int, authority: str) -> int:
        """Return the label of this parent and authority, and keep `only_parent` true."""
        if parent != self.only_parent:
            self.only_parent = 0 if self._stamps else parent
        name = (parent, authority)
        if name not in self._names:
            self._names.append(name)
        self._last_label = self._names.index(name)
        self._last_authority = authority if self.only_parent else None
        return self._last_label

    def _prune(self, horizon_ns: int) -> None:
        """Drop every sample older than `horizon_ns`."""
        stamps, first = self._stamps, self._first
        while stamps[first] < horizon_ns:
            self._segments.pop(first, None)
            first += 1
        self._first = first
        live = len(stamps) - first
        if live > 1 and stamps[first] == stamps[first + 1]:
            self._segments.clear()  # twins at the old end: see _find
        if self.only_parent == 0:
            parents = {self._names[label][0] for label in set(self._labels[self._first :])}
            self.only_parent = parents.pop() if len(parents) == 1 else 0
            self._last_authority = None  # the last label may name a parent that is gone
        if first > 64 + live // 16:
            self._cut_off_the_dead()

    def _cut_off_the_dead(self) -> None:
        """Free the memory of pruned samples; done rarely, so that an insert costs the same however long the history."""
        self._cut_off += self._first
        del self._stamps[: self._first]
        del self._numbers[: 7 * self._first]
        del self._labels[: self._first]
        self._first = 0
        self._segments.clear()


class StaticCache:
    """A child that is bolted on: one sample, the last to come, good for any time."""

    is_static = True
    newest_ns = oldest_ns = 0  # tf2 gives a static transform no time of its own

    def __init__(self) -> None:
        self._sample: Sample | None = None

    def __len__(self) -> int:
        return 0 if self._sample is None else 1

    @property
    def newest_parent(self) -> int:
        return self._sample.parent if self._sample else 0

    only_parent = newest_parent

    def insert(self, stamp_ns: int, numbers: tuple[float, ...], parent: int, authority: str) -> bool:
        """Replace the sample; its stamp is remembered for people to read, and has no other use."""
        self._sample = Sample(stamp_ns, (*numbers[:3], *quaternions.canonical(numbers[3:])), parent, authority)
        return True

    def at(self, stamp_ns: int) -> Pose | None:
        return self._sample.pose if self._sample else None

    def parent_at(self, stamp_ns: int) -> int:
        return self.newest_parent

    def newest(self) -> Sample | None:
        return self._sample

    def samples(self) -> list[Sample]:
        return [self._sample] if self._sample else []

    def owners(self) -> set[tuple[int, str]]:
        return {(self._sample.parent, self._sample.authority)} if self._sample else set()

    def clear(self) -> None:
        """Do nothing: tf2's clear() keeps static transforms."""
