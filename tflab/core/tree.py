"""Keep the frames and their caches, and find the path between two frames.

            map  (1: no history, so a root)
             |
            odom (2: its samples name 1 as parent)
             |                        lookup(target=camera, source=laser, t)
         base_link (3)                up:    laser -> base_link -> odom -> map
           /     \\                    down:  camera -> base_link -> odom -> map
    camera (4)  laser (5)             camera_T_laser = inverse(map_T_camera) @ map_T_laser

    NO_PARENT (0) is tf2's name for "none"

A frame gets the next number when its name is first published, as child or as parent,
and is never forgotten. The tree itself is not stored: each sample names its own
parent, so the shape may change over time, and two samples may close a loop.

tf2 walks from the source up to the root, unless it meets the target on the way, then
from the target until it meets the end of the first walk. Each step reads one history
at t. A history without an answer ends the walk, which is an error only if the two
walks do not meet: a stale map -> odom does not affect camera <-> laser. LATEST is
first replaced by the newest time at which the whole path is known.

tf2: BufferCore (frameIDs_, frames_, frame_authority_), walkToTopParent,
getLatestCommonTime. (The lowest common ancestor of two nodes.)
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from . import quaternions
from .cache import Cache, Gap, StaticCache, TimeCache, compose_chain
from .poses import IDENTITY_POSE, Pose, compose, invert
from .stamps import LATEST

__all__ = [
    "MAX_DEPTH",
    "NO_PARENT",
    "FrameTree",
    "LookupFailure",
    "TreePath",
    "find_path",
    "frames_on_path",
    "histories_of",
    "latest_common_time",
    "pose_along",
]


NO_PARENT = "NO_PARENT"


class FrameTree:
    """Every frame ever named; `caches[n]` is the history of frame number n, None for a root.

    Attributes:
        names: name of each number.
        numbers: number of each name.
        caches: history of each number.
        authorities: who last set each child, by number.
        has_infinity: whether any translation ever stored was infinite (tf2 allows it).
    """

    def __init__(self, cache_time_ns: int) -> None:
        self.cache_time_ns = cache_time_ns
        self.names: list[str] = [NO_PARENT]
        self.numbers: dict[str, int] = {NO_PARENT: 0}
        self.caches: list[Cache | None] = [None]
        self.authorities: dict[int, str] = {}
        self.has_infinity = False

    def number_of(self, name: str) -> int:
        """Return the number of a frame, a new one if the name was never heard."""
        number = self.numbers.get(name)
        if number is None:
            number = self.numbers[name] = len(self.names)
            self.names.append(name)
            self.caches.append(None)
        return number

    def cache_for(self, number: int, is_static: bool) -> Cache:
        """Return the history of a child, of the kind asked for.

        A child that changes its kind starts anew with an empty history, as in tf2.
        """
        cache = self.caches[number]
        if cache is None or cache.is_static != is_static:
            cache = self.caches[number] = StaticCache() if is_static else TimeCache(self.cache_time_ns)
        return cache

    def known_names(self) -> tuple[str, ...]:
        """Return every name, in the order in which they were first heard."""
        return tuple(self.names[1:])


MAX_DEPTH = 1000  # tf2 takes a longer climb for a loop


class LookupFailure(NamedTuple):
    """Why there is no path: `kind` is "past", "future", "no_data", "disconnected" or "loop"."""

    kind: str
    frame: int = 0  # the child whose history does not reach
    requested_ns: int = 0
    bound_ns: int = 0


class TreePath(NamedTuple):
    """The children whose transforms are chained at one moment, `up` from the source and `down` to the target."""

    stamp_ns: int
    up: list[int]  # nearest to the source first
    down: list[int]  # nearest to the target first
    is_direct: bool = False  # one climb came upon the other frame, and stopped there


class _Climb(NamedTuple):
    children: list[int]  # each frame that was climbed from, the lowest first
    end: int
    is_direct: bool = False  # it ended because it came upon the other frame
    failure: LookupFailure | None = None  # it ended because a history does not reach, or because it goes in a circle


def find_path(tree: FrameTree, target: int, source: int, stamp_ns: int) -> TreePath | LookupFailure:
    """Return the path from `source` to `target` at `stamp_ns`, as tf2 finds it, or why there is none."""
    if target == source:
        return TreePath(stamp_ns, [], [])
    if stamp_ns == LATEST:
        common = latest_common_time(tree, target, source)
        if isinstance(common, LookupFailure):
            return common
        stamp_ns = common
    up = _climb(tree, source, stamp_ns, other=target)
    if up.is_direct:
        return TreePath(stamp_ns, up.children, [], is_direct=True)
    if up.failure is not None and up.failure.kind == "loop":
        return up.failure
    down = _climb(tree, target, stamp_ns, other=source, top=up.end)
    if down.is_direct:
        return TreePath(stamp_ns, [], down.children, is_direct=True)
    if down.end == up.end and down.failure is None:
        return TreePath(stamp_ns, up.children, down.children)
    return down.failure or up.failure or LookupFailure("disconnected")  # a gap above the source is only fatal now


def _climb(tree: FrameTree, frame: int, stamp_ns: int, other: int, top: int = 0) -> _Climb:
    """Follow the parents at a moment up to `top`, a root or a gap, unless the `other` frame is on the way."""
    children: list[int] = []
    while frame != top and (cache := tree.caches[frame]) is not None:
        try:
            parent = cache.parent_at(stamp_ns)
        except Gap as gap:
            failure = LookupFailure(gap.direction, frame, gap.requested_ns, gap.bound_ns)
            return _Climb(children, frame, failure=failure)
        if parent == 0:  # a parent that is called NO_PARENT: tf2 then answers with an identity that means nothing
            break
        if frame == other:
            return _Climb(children, frame, is_direct=True)
        children.append(frame)
        frame = parent
        if len(children) > MAX_DEPTH:
            return _Climb(children, frame, failure=LookupFailure("loop"))
    return _Climb(children, frame)


def latest_common_time(tree: FrameTree, target: int, source: int) -> int | LookupFailure:
    """Return the newest moment at which every frame on the way is known [ns].

    It is the earliest of the newest stamps below the frame where both climbs
    meet.  Static transforms do not count; 0 if nothing else is on the way.
    Parents are today's: those of the newest samples.
    """
    if target == source:
        cache = tree.caches[target]
        return cache.newest_ns if cache is not None else 0
    limits: dict[int, int] = {}  # parent -> earliest newest stamp up to there, 0 for "no limit yet"
    for depth, (parent, limit_ns) in enumerate(_climb_by_newest(tree, source)):
        limits.setdefault(parent, limit_ns)
        if parent == target:
            return limit_ns
        if depth >= MAX_DEPTH:
            return LookupFailure("loop")
    for depth, (parent, limit_ns) in enumerate(_climb_by_newest(tree, target)):
        if parent in limits:
            return _earlier(limit_ns, limits[parent])
        if parent == source:
            return limit_ns
        if depth >= MAX_DEPTH:
            return LookupFailure("loop")
    return LookupFailure("disconnected")


def _climb_by_newest(tree: FrameTree, frame: int) -> Iterator[tuple[int, int]]:
    """Yield each parent on the way up, and the earliest of the newest stamps below it [ns]."""
    limit_ns = 0
    while (cache := tree.caches[frame]) is not None and cache.newest_parent != 0:
        limit_ns = _earlier(limit_ns, cache.newest_ns)
        frame = cache.newest_parent
        yield frame, limit_ns


def _earlier(a_ns: int, b_ns: int) -> int:
    """Return the earlier of two stamps, where 0 stands for no limit."""
    return min(a_ns, b_ns) if a_ns and b_ns else a_ns or b_ns


def pose_along(tree: FrameTree, path: TreePath) -> Pose:
    """Return source's pose in target, chained along a path in tf2's order."""
    up, down = histories_of(tree, path.up), histories_of(tree, path.down)
    if tree.has_infinity:
        return _pose_at_infinity(up, down, path)
    if not down:
        return compose_chain(up, path.stamp_ns)
    return compose(invert(compose_chain(down, path.stamp_ns)), compose_chain(up, path.stamp_ns))


def frames_on_path(tree: FrameTree, path: TreePath, source: int) -> list[int]:
    """Return the frames on a path, from source to target, without what it climbs above the turning point."""
    climbed = [source, *(cache.parent_at(path.stamp_ns) for cache in histories_of(tree, path.up))]
    frames: list[int] = []
    for frame in [*climbed, *reversed(path.down)]:
        if frame in frames:
            del frames[frames.index(frame) :]
        frames.append(frame)
    return frames


def histories_of(tree: FrameTree, children: list[int]) -> list[Cache]:
    """Return the histories of some children, in the same order."""
    return [cache for child in children if (cache := tree.caches[child]) is not None]


# -- a robot at infinity: tf2 allows it, and formulas differ in what they make of it ----


def _pose_at_infinity(up: list[Cache], down: list[Cache], path: TreePath) -> Pose:
    """Return what pose_along does, but number by number as tf2."""
    above_source = _chained_literally(up, path.stamp_ns)
    if path.is_direct and not down:
        return above_source
    x, y, z, qx, qy, qz, qw = _chained_literally(down, path.stamp_ns)
    back = quaternions.conjugate((qx, qy, qz, qw))
    x, y, z = _turned_literally(back, (-x, -y, -z))
    if path.is_direct:
        return (x, y, z, *back)
    dx, dy, dz = _turned_literally(back, above_source[:3])
    return (dx + x, dy + y, dz + z, *quaternions.multiply(back, above_source[3:]))


def _chained_literally(caches: list[Cache], stamp_ns: int) -> Pose:
    total = IDENTITY_POSE
    for cache in caches:
        x, y, z, qx, qy, qz, qw = cache.at(stamp_ns)
        dx, dy, dz = _turned_literally((qx, qy, qz, qw), total[:3])
        total = (dx + x, dy + y, dz + z, *quaternions.multiply((qx, qy, qz, qw), total[3:]))
    return total


def _turned_literally(q: quaternions.Quaternion, v: quaternions.Vector3) -> quaternions.Vector3:
    """Return `v` turned by `q` as two products of quaternions: q (v, 0) conj(q)."""
    return quaternions.multiply(quaternions.multiply(q, (*v, 0.0)), quaternions.conjugate(q))[:3]
