"""Store the samples of one edge and interpolate between them.

Every child frame keeps a short history of samples. This module knows no trees and no
names: parents are numbers.

       insert                                  at(t)
         |                                       |
         v        oldest                         v        newest
    ----[+]----[ o-----o-------o-----o-----------?-----o-----o ]---->  time
     too old    `---------- at most cache_time ------------'

Between two samples the position is interpolated linearly and the rotation along the
shorter arc. Outside of them a lookup fails: tf2 never extrapolates.

A history is stored in columns, 68 bytes a sample, as it was sent (a structure of
arrays). Samples dropped at the old end stay in them for a while, before index
`_first`, and are removed many at a time.

tf2 calls these classes TimeCache and StaticCache, with one interface between them
(tf2/src/cache.cpp, static_cache.cpp, time_cache.hpp).
"""

from __future__ import annotations

from array import array
from bisect import bisect_right
from collections.abc import Callable
from struct import Struct
from sys import getsizeof
from typing import NamedTuple

import numpy as np

from .poses import IDENTITY_POSE, Pose, Sent, compose, through_matrix, unit_pose
from .segments import Segment, Segments
from .stamps import LATEST

__all__ = ["Cache", "Gap", "StaticCache", "StoredTransform", "TimeCache", "compose_chain"]

_seven_doubles = Struct("=7d")  # an array takes and gives bytes twice as fast as floats
_pack_seven = _seven_doubles.pack
_unpack_seven: Callable[[array[float], int], Pose] = _seven_doubles.unpack_from

STATIC_BYTES = 400  # in CPython on 64 bits
NEAR = 16  # how many samples the guess of an index may be off


class Gap(Exception):
    """A history has no answer for a moment.

    Attributes:
        direction: "past", "future" or "no_data".
        requested_ns: the moment asked for [ns].
        bound_ns: the end of the history on that side [ns]; 0 if it is empty.
    """

    def __init__(self, direction: str, requested_ns: int, bound_ns: int) -> None:
        super().__init__(direction, requested_ns, bound_ns)
        self.direction = direction
        self.requested_ns = requested_ns
        self.bound_ns = bound_ns


class StoredTransform(NamedTuple):
    """One stored transform: who said where the child was, and when."""

    stamp_ns: int
    pose: Pose
    parent: int
    authority: str


class TimeCache:
    """A child that moves: its samples, oldest first, no older than `cache_time_ns` before the newest.

    Attributes:
        oldest_ns, newest_ns: where the history begins and ends [ns]; 0 if it is empty.
        newest_parent: the parent in the newest sample; 0 if there is none.
        only_parent: the parent of every sample; 0 if they differ or there are none.
    """

    is_static = False

    def __init__(self, cache_time_ns: int) -> None:
        self._cache_time_ns = cache_time_ns
        self._cut_off = 0  # how many samples were ever removed from the columns
        self._stamps = array("q")
        self._segments = Segments()
        self.clear()

    def clear(self) -> None:
        """Forget every sample."""
        self._cut_off += len(self._stamps)
        self._stamps = array("q")
        self._numbers = array("d")  # x, y, z, qx, qy, qz, qw of each sample, as sent
        self._labels = array("I")  # who sent it, under which parent: an index into _owners
        self._owners: list[tuple[int, str]] = []  # (parent, authority)
        self._first = 0  # the index of the oldest sample
        self.oldest_ns = self.newest_ns = 0
        self.newest_parent = self.only_parent = 0
        self._newest_authority: str | None = None
        self._newest_label = 0
        self._renumbered()

    def __len__(self) -> int:
        return len(self._stamps) - self._first

    @property
    def version(self) -> tuple[int, int]:
        """Something that is different after every change: samples ever stored, samples ever dropped."""
        return self._cut_off + len(self._stamps), self._cut_off + self._first

    # -- tf2's four steps of an insert ----------------------------------------

    def insert(self, stamp_ns: int, numbers: Sent, parent: int, authority: str) -> bool:
        """Keep a sample; return False if it is older than the history allows.

        `numbers` are x, y, z, qx, qy, qz, qw as sent: any length of quaternion
        that `quaternions.canonical` can make a rotation of.
        """
        if self._stamps:
            # 1. Drop what is too old, seen from the newest sample so far, even if the new one is then refused.
            horizon_ns = self.newest_ns - self._cache_time_ns
            if self.oldest_ns < horizon_ns:
                self._prune(horizon_ns)
            # 2. Refuse the new sample if it is too old itself.
            if stamp_ns < horizon_ns:
                return False
            # 3. Find its place: after all that are older, or have the same stamp.
            if stamp_ns <= self.newest_ns:
                self._insert_among(stamp_ns, numbers, parent, authority)
                return True
        else:
            self.oldest_ns = stamp_ns
        # 4. Put it there: almost always at the end.
        if parent != self.newest_parent or authority != self._newest_authority:
            self._newest_label = self._label(parent, authority)
            self.newest_parent, self._newest_authority = parent, authority
        self.newest_ns = stamp_ns
        self._stamps.append(stamp_ns)
        self._numbers.frombytes(_pack_seven(*numbers))
        self._labels.append(self._newest_label)
        return True

    def _prune(self, horizon_ns: int) -> None:
        """Drop every sample older than `horizon_ns`."""
        stamps, first = self._stamps, self._first
        while stamps[first] < horizon_ns:
            first += 1
        self._first = first
        self.oldest_ns = stamps[first]
        if self.only_parent == 0:
            parents = {self._owners[label][0] for label in set(self._labels[first:])}
            self.only_parent = parents.pop() if len(parents) == 1 else 0
        if first > 64 + (len(stamps) - first) // 16:  # rarely, so that an insert costs the same in a long history
            self._cut_off += first
            del self._stamps[:first]
            del self._numbers[: 7 * first]
            del self._labels[:first]
            self._first = 0
            self._renumbered()

    def _insert_among(self, stamp_ns: int, numbers: Sent, parent: int, authority: str) -> None:
        """Keep a sample that is not newer than all others, unless an equal one is there, as in tf2's step 3."""
        i = bisect_right(self._stamps, stamp_ns, self._first)
        sample = (through_matrix(numbers), parent)
        same = i - 1
        while same >= self._first and self._stamps[same] == stamp_ns:
            if sample == (through_matrix(self._as_sent(same)), self._parent(same)):
                return
            same -= 1
        label = self._label(parent, authority)
        self._stamps.insert(i, stamp_ns)
        self._numbers[7 * i : 7 * i] = array("d", numbers)
        self._labels.insert(i, label)
        if i == len(self._stamps) - 1:  # equal to the newest: it came last, so it answers
            self.newest_parent, self._newest_authority, self._newest_label = parent, authority, label
        self.oldest_ns = self._stamps[self._first]
        self._renumbered()

    def extend(self, stamps_ns: np.ndarray, numbers: np.ndarray, parent: int, authority: str) -> None:
        """Keep many samples, each newer than the one before and than all that are stored.

        Shapes (N,), int64, and (N, 7), float64.
        """
        if not self._stamps:
            self.oldest_ns = int(stamps_ns[0])
        self._newest_label = self._label(parent, authority)
        self.newest_parent, self._newest_authority = parent, authority
        self.newest_ns = int(stamps_ns[-1])
        self._stamps.frombytes(stamps_ns.tobytes())
        self._numbers.frombytes(numbers.tobytes())
        self._labels.extend(array("I", [self._newest_label]) * len(stamps_ns))
        if len(self) > 1:  # the last insert saw all the others
            self._prune(self._stamps[-2] - self._cache_time_ns)

    def _label(self, parent: int, authority: str) -> int:
        """Return the label of a new sample's owner, and keep `only_parent` true."""
        if parent != self.only_parent:
            self.only_parent = 0 if self._stamps else parent
        owner = (parent, authority)
        if owner not in self._owners:
            self._owners.append(owner)
        return self._owners.index(owner)

    def _renumbered(self) -> None:
        """Forget what was worked out of the samples: they have other indices now."""
        self._segments.forget()

    # -- asking ---------------------------------------------------------------

    def at(self, stamp_ns: int) -> Pose:
        """Return the child's pose in its parent at `stamp_ns`, of unit rotation.

        Raises:
            Gap: the history does not reach that far.
        """
        oldest_ns, newest_ns = self.oldest_ns, self.newest_ns
        if oldest_ns < stamp_ns < newest_ns and stamp_ns != LATEST:
            first = self._first
            guess = first + (stamp_ns - oldest_ns) * (len(self._stamps) - 1 - first) // (newest_ns - oldest_ns)
            known = self._segments.segments
            segment = known.get(guess)  # right if the publisher is steady, and if it was met before
            if segment is None or not segment.start_ns <= stamp_ns < segment.end_ns:
                i = self._before(stamp_ns, guess)
                segment = known.get(i) or self._segment(i)
            return segment.pose_at(stamp_ns)
        return self._unit_pose(self._find(stamp_ns))

    def parent_at(self, stamp_ns: int) -> int:
        """Return the parent at `stamp_ns`: of two samples, the older one's.

        Raises:
            Gap: the history does not reach that far.
        """
        return self._parent(self._find(stamp_ns))

    def _find(self, stamp_ns: int) -> int:
        """Return the index of the sample that answers for `stamp_ns`: the older of two.

        Of several samples with one stamp the last to come answers, except at the
        old end of the history, where it is the first to come.  That is tf2's order.
        """
        stamps, first = self._stamps, self._first
        count = len(stamps) - first
        if count and stamp_ns in (LATEST, self.newest_ns):
            return len(stamps) - 1
        if count < 2:
            raise Gap("no_data", stamp_ns, self.newest_ns)
        if stamp_ns == self.oldest_ns:
            return first
        if stamp_ns > self.newest_ns:
            raise Gap("future", stamp_ns, self.newest_ns)
        if stamp_ns < self.oldest_ns:
            raise Gap("past", stamp_ns, self.oldest_ns)
        return bisect_right(stamps, stamp_ns, first) - 1

    def _before(self, stamp_ns: int, guess: int) -> int:
        """Return the index of the last sample not newer than a moment between both ends (interpolation search)."""
        stamps, first = self._stamps, self._first
        last = len(stamps) - 1
        if stamps[guess] <= stamp_ns < stamps[guess + 1]:
            return guess
        low, high = max(first, guess - NEAR), min(last, guess + NEAR)
        if not stamps[low] <= stamp_ns < stamps[high]:
            low, high = first, last
        return bisect_right(stamps, stamp_ns, low, high) - 1

    def _segment(self, i: int) -> Segment:
        """Return, and remember, the way from sample `i` to the next one."""
        start, end = self._as_sent(i), self._as_sent(i + 1)
        if not self.only_parent and self._parent(i) != self._parent(i + 1):
            end = start  # another parent in between: tf2 does not blend, the older one holds
        segment = Segment(self._stamps[i], self._stamps[i + 1], start, end)
        self._segments.remember_segment(i, segment)
        return segment

    def _unit_pose(self, i: int) -> Pose:
        """Return, and remember, sample `i` with its rotation scaled to length one."""
        pose = self._segments.poses.get(i)
        if pose is None:
            pose = unit_pose(self._as_sent(i))
            self._segments.remember_pose(i, pose)
        return pose

    def _as_sent(self, i: int) -> Pose:
        return _unpack_seven(self._numbers, 56 * i)

    def _parent(self, i: int) -> int:
        return self._owners[self._labels[i]][0]

    # -- reading ---------------------------------------------------------------

    def samples(self) -> list[StoredTransform]:
        """Return every sample, oldest first, in tf2's canonical form."""
        return [self._sample(i) for i in range(self._first, len(self._stamps))]

    def newest(self) -> StoredTransform | None:
        """Return the newest sample."""
        return self._sample(len(self._stamps) - 1) if len(self) else None

    def _sample(self, i: int) -> StoredTransform:
        parent, authority = self._owners[self._labels[i]]
        return StoredTransform(self._stamps[i], through_matrix(self._as_sent(i)), parent, authority)

    def owners(self) -> set[tuple[int, str]]:
        """Return every (parent, authority) that a sample names."""
        return {self._owners[label] for label in set(self._labels[self._first :])}

    def columns(self) -> tuple[array[int], array[float], int]:
        """Return the stamps, the numbers as sent (seven a sample) and the index of the first live sample.

        For reading only, and only while nobody inserts: `columns.py` makes tables of them.
        """
        return self._stamps, self._numbers, self._first

    def memory(self) -> tuple[int, int]:
        """Return (bytes of the stored columns, bytes of what is remembered besides)."""
        return sum(map(getsizeof, (self._stamps, self._numbers, self._labels))), self._segments.nbytes


class StaticCache:
    """A child that is bolted on: one sample, the last to come, good for any time."""

    is_static = True

    def __init__(self) -> None:
        self.oldest_ns = self.newest_ns = 0  # tf2 gives a static transform no time of its own
        self.newest_parent = self.only_parent = 0
        self._sample: StoredTransform | None = None

    def clear(self) -> None:
        """Do nothing: tf2's clear() keeps static transforms."""

    def __len__(self) -> int:
        return 0 if self._sample is None else 1

    def insert(self, stamp_ns: int, numbers: Sent, parent: int, authority: str) -> bool:
        """Replace the sample; its stamp is remembered for people to read, and has no other use."""
        self._sample = StoredTransform(stamp_ns, through_matrix(numbers), parent, authority)
        self.newest_parent = self.only_parent = parent
        return True

    def at(self, stamp_ns: int) -> Pose:
        if self._sample is None:
            raise Gap("no_data", stamp_ns, 0)
        return self._sample.pose

    def parent_at(self, stamp_ns: int) -> int:
        return self.newest_parent

    def samples(self) -> list[StoredTransform]:
        return [self._sample] if self._sample else []

    def newest(self) -> StoredTransform | None:
        return self._sample

    def owners(self) -> set[tuple[int, str]]:
        return {(sample.parent, sample.authority) for sample in self.samples()}

    def memory(self) -> tuple[int, int]:
        return STATIC_BYTES, 0


Cache = TimeCache | StaticCache


def compose_chain(caches: list[Cache], stamp_ns: int) -> Pose:
    """Return the first child's pose in the last one's parent.

    Raises:
        Gap: one of the histories does not reach that far.
    """
    if not caches:
        return IDENTITY_POSE
    total = caches[0].at(stamp_ns)
    for cache in caches[1:]:
        total = compose(cache.at(stamp_ns), total)
    return total
