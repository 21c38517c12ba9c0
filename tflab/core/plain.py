"""Implement tf2's rules in one module, without caches: the reference for the fast implementation.

    set_transform("odom", "base_link", t, odom_T_base)
        moving["base_link"] = [ newest | ... | oldest ]           each sample names its parent

    lookup_transform("camera", "laser", t)
        up from the source      laser  -> base_link -> odom -> map     multiplying on the way
        up from the target      camera -> base_link -> odom -> map     until both meet
        camera_T_laser = inverse(map_T_camera) @ map_T_laser

The other modules do the same faster, with tf2's texts for failures. Tests play the
recordings of tf2 on this module, too, and compare the fast engine with it. Two cases
are left to the fast modules: a frame called NO_PARENT, and infinite translations.

tf2: TimeCache, BufferCore::walkToTopParent.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from . import quaternions
from .errors import ConnectivityException, ExtrapolationException, InvalidArgumentException, LookupException
from .stamps import LATEST
from .transforms import Transform

__all__ = ["PlainBuffer", "PlainSample"]

MAX_DEPTH = 1000  # tf2 takes a longer climb for a loop


class PlainSample(NamedTuple):
    """One stored transform, `parent_T_child`."""

    stamp_ns: int
    parent: str
    transform: Transform


class PlainBuffer:
    """A BufferCore without speed: no texts, no log, no threads, no requests."""

    def __init__(self, cache_time_ns: int) -> None:
        self.cache_time_ns = cache_time_ns
        self.moving: dict[str, list[PlainSample]] = {}  # of each child, newest first
        self.static: dict[str, PlainSample] = {}
        self.names: set[str] = set()

    # -- publishing -------------------------------------------------------

    def set_transform(self, parent: str, child: str, stamp_ns: int, transform: Transform, is_static: bool) -> bool:
        """Keep where `child` is in `parent`; return False if it is refused."""
        parent, child = parent.removeprefix("/"), child.removeprefix("/")
        transform = Transform(transform.translation, quaternions.canonical(transform.rotation))
        if not parent or not child or parent == child or any(map(math.isnan, transform.translation)):
            return False
        if not abs(math.hypot(*transform.rotation) - 1.0) < 0.005:  # also if it is NaN: no direction
            return False
        self.names |= {parent, child}
        sample = PlainSample(stamp_ns, parent, transform)
        if is_static:
            self.moving.pop(child, None)
            self.static[child] = sample
            return True
        self.static.pop(child, None)
        return self.insert(self.moving.setdefault(child, []), sample)

    def insert(self, samples: list[PlainSample], new: PlainSample) -> bool:
        """Put a sample in its place; return False if it is older than the history allows."""
        if not samples:
            samples.append(new)
            return True
        horizon_ns = samples[0].stamp_ns - self.cache_time_ns
        while samples[-1].stamp_ns < horizon_ns:  # before the new one goes in, as in tf2
            samples.pop()
        if new.stamp_ns < horizon_ns:
            return False
        if new not in samples:
            samples.insert(sum(sample.stamp_ns > new.stamp_ns for sample in samples), new)
        return True

    def clear(self) -> None:
        """Forget every moving sample."""
        for samples in self.moving.values():
            samples.clear()

    # -- asking -----------------------------------------------------------

    def lookup_transform(self, target: str, source: str, stamp_ns: int) -> tuple[int, Transform]:
        """Return the moment that the answer holds for [ns], and `target_T_source`.

        Raises:
            TransformException: as BufferCore.lookup_transform, but for the texts.
        """
        if target == source:
            return stamp_ns or self.newest_ns(source), Transform()
        stamp_ns = self.latest_common_time(target, source) if stamp_ns == LATEST else stamp_ns
        self.refuse_bad_names(target, source)
        above_source, source_fault = self.climb(source, stamp_ns, {target})
        top, top_T_source = above_source[-1]
        above_target, target_fault = self.climb(target, stamp_ns, {source, top})
        end, end_T_target = above_target[-1]
        if end == source != top:  # the climb from the target came upon the source
            return stamp_ns, end_T_target.inverse()
        if end != top:
            raise target_fault or source_fault or ConnectivityException()
        return stamp_ns, end_T_target.inverse() @ top_T_source

    def refuse_bad_names(self, *frames: str) -> None:
        """Raise tf2's exception for the first name that is malformed or was never heard."""
        for frame in frames:
            if not frame or frame.startswith("/"):
                raise InvalidArgumentException()
            if frame not in self.names:
                raise LookupException(frame=frame)

    def climb(
        self, frame: str, stamp_ns: int, until: set[str]
    ) -> tuple[list[tuple[str, Transform]], ExtrapolationException | None]:
        """Return each (ancestor, ancestor_T_frame) on the way up, and why it ended, if for want of data."""
        path = [(frame, Transform())]
        while frame not in until and (frame in self.moving or frame in self.static):
            try:
                sample = self.at(frame, stamp_ns)
            except ExtrapolationException as fault:  # only an error if the other climb does not come by
                return path, fault
            frame = sample.parent
            path.append((frame, sample.transform @ path[-1][1]))
            if len(path) > MAX_DEPTH + 1:
                raise LookupException()
        return path, None

    def at(self, frame: str, stamp_ns: int) -> PlainSample:
        """Return where a child was: between two samples on a straight line, and never outside of them."""
        if frame in self.static:
            return self.static[frame]
        samples = self.moving[frame]
        newest_ns, oldest_ns = (samples[0].stamp_ns, samples[-1].stamp_ns) if samples else (0, 0)
        if samples and stamp_ns in (LATEST, newest_ns):
            return samples[0]
        if len(samples) < 2:
            raise ExtrapolationException(direction="no_data", requested_ns=stamp_ns, bound_ns=newest_ns)
        if stamp_ns == oldest_ns:
            return samples[-1]
        if stamp_ns > newest_ns:
            raise ExtrapolationException(direction="future", requested_ns=stamp_ns, bound_ns=newest_ns)
        if stamp_ns < oldest_ns:
            raise ExtrapolationException(direction="past", requested_ns=stamp_ns, bound_ns=oldest_ns)
        i = next(i for i, sample in enumerate(samples) if sample.stamp_ns <= stamp_ns)
        older, newer = samples[i], samples[i - 1]
        if older.parent != newer.parent:  # another parent in between: tf2 does not blend either
            return older
        ratio = (stamp_ns - older.stamp_ns) / (newer.stamp_ns - older.stamp_ns)
        return older._replace(transform=older.transform.interpolate(newer.transform, ratio))

    # -- the newest moment at which the whole path is known ------------------

    def newest_ns(self, frame: str) -> int:
        """Return a child's newest stamp [ns]; 0 for a static one, and for a root."""
        samples = self.moving.get(frame)
        return samples[0].stamp_ns if samples else 0

    def latest_common_time(self, target: str, source: str) -> int:
        """Return the earliest of the newest stamps on the way [ns]; 0 if nothing on it moves.

        Raises:
            TransformException: a bad name, no path, or a loop.
        """
        self.refuse_bad_names(target, source)
        if target == source:
            return self.newest_ns(source)
        from_source = self.climb_by_newest(source, {target})
        from_target = [] if from_source[-1] == target else self.climb_by_newest(target, {source, *from_source[1:]})
        met = from_target[-1] if from_target else target
        if met not in from_source:
            raise ConnectivityException()
        on_the_way = from_source[: from_source.index(met)] + from_target[:-1]
        return min((self.newest_ns(frame) for frame in on_the_way if self.newest_ns(frame)), default=0)

    def climb_by_newest(self, frame: str, until: set[str]) -> list[str]:
        """Return the frames on the way up, following the parents of the newest samples."""
        path = [frame]
        while len(path) == 1 or path[-1] not in until:
            newest = self.static.get(path[-1]) or next(iter(self.moving.get(path[-1], ())), None)
            if newest is None:
                break
            path.append(newest.parent)
            if len(path) > MAX_DEPTH + 1:
                raise LookupException()
        return path
