"""Cache the paths between frames, and forget them when the tree changes.

    ("camera", "laser")  ->  Route    up    laser's history
                                      down  camera's history

If no frame on the way ever changed its parent, the shape is the same at all
times.  Then the way is kept as a `Route`, which ends where the two climbs first
meet, and a lookup merely reads the histories along it.

What the engine remembers only to be fast, and when it forgets it:

    what                            where         forgotten
    a segment, a pose at a sample   segments.py   when samples get other indices (an insert that is not
                                                  the newest, a cut at the old end, clear)
    a route between two names       routes.py     when a child's only parent or the kind of its history
    an edge, as it is published     buffer.py     changes, or the first infinite number comes (and clear):
    a table for batches             columns.py    see BufferCore._shape_changed
    the same table                  columns.py    also when its history changed in any way: see TimeCache.version

tf2 remembers none of these (caching; cache invalidation).
"""

from __future__ import annotations

from .cache import Cache, TimeCache, compose_chain
from .poses import Pose, canonical_pose, compose, invert
from .tree import MAX_DEPTH, FrameTree, histories_of

__all__ = ["Route", "Routes", "plan_route"]

ROUTES_REMEMBERED = 4096
ROUTE_BYTES = 500  # each, in CPython on 64 bits


class Route:
    """The histories to read, at whatever moment; only for a path whose shape has never changed.

    Attributes:
        up: from the source to where the climbs meet.
        down: from the target to there.
        moving: those of both that are not static.
    """

    def __init__(self, up: list[Cache], down: list[Cache]) -> None:
        self.up = up
        self.down = down
        self.moving = [cache for cache in up + down if isinstance(cache, TimeCache)]

    def latest_common_time(self) -> int:
        """Return the moment that LATEST means here [ns]; 0 if nothing on the way moves."""
        earliest_ns = 0
        for cache in self.moving:
            newest_ns = cache.newest_ns
            if newest_ns and (newest_ns < earliest_ns or not earliest_ns):
                earliest_ns = newest_ns
        return earliest_ns

    def pose_at(self, stamp_ns: int) -> Pose:
        """Return source's pose in target, with the sign of the quaternion that tf2 would print.

        Raises:
            Gap: some history does not reach that far.
        """
        if not self.down:
            return canonical_pose(compose_chain(self.up, stamp_ns))
        back = invert(compose_chain(self.down, stamp_ns))
        return canonical_pose(compose(back, compose_chain(self.up, stamp_ns)) if self.up else back)


class Routes:
    """The routes of one tree, by (target_frame, source_frame); None where there can be none."""

    def __init__(self, tree: FrameTree) -> None:
        self._tree = tree
        self.known: dict[tuple[str, str], Route | None] = {}

    def between(self, target_frame: str, source_frame: str) -> Route | None:
        """Return the route between two frames, remembered until the shape of the tree changes."""
        names = (target_frame, source_frame)
        if names not in self.known:
            if len(self.known) >= ROUTES_REMEMBERED:
                self.known.clear()
            target, source = (self._tree.numbers.get(name, 0) for name in names)
            self.known[names] = plan_route(self._tree, target, source) if target and source else None
        return self.known[names]

    def forget(self) -> None:
        """Forget every route: the shape of the tree changed."""
        self.known.clear()

    @property
    def nbytes(self) -> int:
        return ROUTE_BYTES * len(self.known)


def plan_route(tree: FrameTree, target: int, source: int) -> Route | None:
    """Return the route between two frames, or None if its shape may depend on time."""
    if target == source or tree.has_infinity:  # tf2 climbs the whole trunk, and infinity - infinity is not zero
        return None
    from_source = _fixed_climb(tree, source, until=target)
    from_target = _fixed_climb(tree, target, until=source)
    if from_source is None or from_target is None:
        return None
    if from_source[-1] == target and from_target[-1] == source:
        return None  # each is above the other: a loop
    met = next((frame for frame in from_target if frame in set(from_source)), None)
    if met is None:
        return None
    up, down = from_source[: from_source.index(met)], from_target[: from_target.index(met)]
    return Route(histories_of(tree, up), histories_of(tree, down))


def _fixed_climb(tree: FrameTree, frame: int, until: int) -> list[int] | None:
    """Return the frames from `frame` to `until` or to the root; None if one of them changed its parent."""
    climbed = [frame]
    while frame != until and (cache := tree.caches[frame]) is not None:
        frame = cache.only_parent
        climbed.append(frame)
        if frame == 0 or len(climbed) > MAX_DEPTH + 1:
            return None
    return climbed
