"""tf2 without a single memo: lists, searched from one end.  What the engine must agree with, always.

Written from the rules (newest sample first, as in tf2), not from the engine, and
as slow as it likes.
"""

from __future__ import annotations

from typing import NamedTuple

from tflab.core import Transform, quaternions

LATEST = 0


class Sample(NamedTuple):
    stamp_ns: int
    parent: str
    transform: Transform


class NoAnswer(Exception):
    """Why not: the kind, and for extrapolation the requested and the nearest stamp."""


class PlainBuffer:
    def __init__(self, cache_time_ns: int) -> None:
        self.cache_time_ns = cache_time_ns
        self.moving: dict[str, list[Sample]] = {}
        self.static: dict[str, Sample] = {}
        self.names: set[str] = set()

    def set_transform(self, parent: str, child: str, stamp_ns: int, transform: Transform, is_static: bool) -> bool:
        transform = Transform(transform.translation, quaternions.canonical(transform.rotation))
        self.names |= {parent, child}
        new = Sample(stamp_ns, parent, transform)
        if is_static:
            self.moving.pop(child, None)
            self.static[child] = new
            return True
        self.static.pop(child, None)
        samples = self.moving.setdefault(child, [])
        newest_ns = samples[0].stamp_ns if samples else 0
        while samples and samples[-1].stamp_ns + self.cache_time_ns < newest_ns:
            samples.pop()
        if samples and stamp_ns < newest_ns - self.cache_time_ns:
            return False
        place = 0
        while place < len(samples) and samples[place].stamp_ns > stamp_ns:
            place += 1
        if new in [s for s in samples if s.stamp_ns == stamp_ns]:
            return True
        samples.insert(place, new)
        return True

    def clear(self) -> None:
        for samples in self.moving.values():
            samples.clear()

    def lookup(self, target: str, source: str, stamp_ns: int) -> tuple[int, Transform]:
        """Return (stamp, target_T_source)."""
        if target == source:
            return stamp_ns or self.newest_ns(source), Transform()
        for name in (target, source):
            if name not in self.names:
                raise NoAnswer("unknown", name)
        stamp_ns = stamp_ns or self.latest_common_time(target, source)
        above_source, source_error = self.climb(source, stamp_ns, until=target)
        top = above_source[-1][0]
        if top == target:
            return stamp_ns, above_source[-1][1]
        above_target, target_error = self.climb(target, stamp_ns, until=source, top=top)
        if above_target[-1][0] == source:
            return stamp_ns, above_target[-1][1].inverse()
        if above_target[-1][0] != top:
            raise target_error or source_error or NoAnswer("disconnected")
        return stamp_ns, above_target[-1][1].inverse() @ above_source[-1][1]

    def climb(self, frame: str, stamp_ns: int, until: str, top: str | None = None):
        """Return [(ancestor, ancestor_T_frame), ...] and why the climb ended, if for want of data."""
        way = [(frame, Transform())]
        while frame not in (until, top):
            if frame not in self.moving and frame not in self.static:
                return way, None
            try:
                sample = self.at(frame, stamp_ns)
            except NoAnswer as error:
                return way, error
            frame = sample.parent
            way.append((frame, sample.transform @ way[-1][1]))
            if len(way) > 50:
                raise NoAnswer("loop")
        return way, None

    def at(self, frame: str, stamp_ns: int) -> Sample:
        if frame in self.static:
            return self.static[frame]
        samples = self.moving[frame]
        if not samples:
            raise NoAnswer("no_data", stamp_ns, 0)
        if stamp_ns in (LATEST, samples[0].stamp_ns):
            return samples[0]
        if len(samples) == 1:
            raise NoAnswer("no_data", stamp_ns, samples[0].stamp_ns)
        if stamp_ns == samples[-1].stamp_ns:
            return samples[-1]
        if stamp_ns > samples[0].stamp_ns:
            raise NoAnswer("future", stamp_ns, samples[0].stamp_ns)
        if stamp_ns < samples[-1].stamp_ns:
            raise NoAnswer("past", stamp_ns, samples[-1].stamp_ns)
        place = next(i for i, sample in enumerate(samples) if sample.stamp_ns <= stamp_ns)
        older, newer = samples[place], samples[place - 1]
        if older.parent != newer.parent:
            return older
        ratio = (stamp_ns - older.stamp_ns) / (newer.stamp_ns - older.stamp_ns)
        return older._replace(transform=older.transform.interpolate(newer.transform, ratio))

    def newest_ns(self, frame: str) -> int:
        samples = self.moving.get(frame)
        return samples[0].stamp_ns if samples else 0

    def latest_common_time(self, target: str, source: str) -> int:
        from_source = self.climb_by_newest(source, until={target})
        if from_source[-1] == target:
            on_the_way = from_source[:-1]
        else:
            from_target = self.climb_by_newest(target, until={source, *from_source[1:]})
            if from_target[-1] not in from_source:
                raise NoAnswer("disconnected")
            on_the_way = from_source[: from_source.index(from_target[-1])] + from_target[:-1]
        return min((self.newest_ns(frame) for frame in on_the_way if self.newest_ns(frame)), default=0)

    def climb_by_newest(self, frame: str, until: set[str]) -> list[str]:
        """Return the frames on the way up, following the parents of the newest samples."""
        way = [frame]
        while way[-1] not in until or len(way) == 1:
            newest = self.static.get(way[-1]) or next(iter(self.moving.get(way[-1], [])), None)
            if newest is None:
                break
            way.append(newest.parent)
            if len(way) > 50:
                raise NoAnswer("loop")
        return way
