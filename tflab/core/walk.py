"""How do I get from one frame to another?  Up from the source, up from the target, until they meet.

                 map                 lookup(target=camera, source=laser, t)
                  |
                 odom                up:    laser -> base_link -> odom -> map
                  |                  down:  camera -> base_link -> odom -> map
              base_link
               /     \\               camera_T_laser =
          camera     laser             inverse(map_T_camera) @ map_T_laser

tf2 climbs from the source all the way to the root (unless it meets the target on
the way), then from the target until it meets the end of the first climb.  Every
step asks one history who the parent was at t.  A history with no answer ends the
climb, and that is only an error if the two climbs then miss each other: a stale
map -> odom does not hurt camera <-> laser.

If no frame on the way ever changed its parent, the shape is the same at all
times.  Then the way is kept as a `Route`, which ends where the two climbs first
meet, and a lookup merely reads the histories along it.

tf2: BufferCore::walkToTopParent, getLatestCommonTime.  Read `buffer.py` next.
"""

from __future__ import annotations

from typing import NamedTuple

from . import quaternions
from .cache import TimeCache
from .describe import all_frames_as_string
from .errors import ConnectivityException, ExtrapolationException, LookupException, TransformException
from .stamps import LATEST, format_stamp
from .transforms import IDENTITY_POSE, Pose, compose, invert
from .tree import Cache, Tree

__all__ = [
    "Failure",
    "Path",
    "Route",
    "exception_from_failure",
    "extrapolation_text",
    "find_path",
    "frames_on_path",
    "latest_common_time",
    "plan_route",
    "pose_on_path",
    "text_from_failure",
]

MAX_DEPTH = 1000  # tf2 takes a longer climb for a loop


class Failure(NamedTuple):
    """Why there is no way: `kind` is "past", "future", "no_data", "disconnected" or "loop"."""

    kind: str
    frame: int = 0  # the child whose history does not reach
    requested_ns: int = 0
    bound_ns: int = 0


class Path(NamedTuple):
    """The children whose transforms are chained at one moment, `up` from the source and `down` to the target."""

    stamp_ns: int
    up: list[int]  # nearest to the source first
    down: list[int]  # nearest to the target first
    is_direct: bool = False  # one climb came upon the other frame, and stopped there


class Route(NamedTuple):
    """The histories to read, at whatever moment; only for a way whose shape has never changed."""

    up: tuple[Cache, ...]
    down: tuple[Cache, ...]
    moving: tuple[TimeCache, ...]  # those of both that are not static

    def latest_common_time(self) -> int:
        """Return the moment that LATEST means here [ns]; 0 if nothing on the way moves."""
        return min((cache.newest_ns for cache in self.moving if cache.newest_ns), default=0)

    def pose_at(self, stamp_ns: int) -> Pose | None:
        """Return source's pose in target, or None if some history does not reach."""
        up = _chained(self.up, stamp_ns)
        if up is None or not self.down:
            return up
        down = _chained(self.down, stamp_ns)
        if down is None:
            return None
        return compose(invert(down), up) if self.up else invert(down)


def plan_route(tree: Tree, target: int, source: int) -> Route | None:
    """Return the route between two frames, or None if its shape may depend on time."""
    if tree.has_infinity:  # tf2 adds and takes off the whole trunk, and infinity - infinity is not zero
        return None
    if target == source:
        return None
    from_source = _fixed_climb(tree, source, until=target)
    if from_source is None:
        return None
    from_target = _fixed_climb(tree, target, until=source)
    if from_target is None or (from_source[-1] == target and from_target[-1] == source):
        return None  # each is above the other: a loop
    met = next((frame for frame in from_target if frame in set(from_source)), None)
    if met is None:
        return None
    up = tuple(tree.caches[frame] for frame in from_source[: from_source.index(met)])
    down = tuple(tree.caches[frame] for frame in from_target[: from_target.index(met)])
    return Route(up, down, tuple(cache for cache in up + down if not cache.is_static))


def _fixed_climb(tree: Tree, frame: int, until: int) -> list[int] | None:
    """Return the frames from `frame` to `until` or to the root; None if one of them changed its parent."""
    climbed = [frame]
    while frame != until and tree.caches[frame] is not None:
        frame = tree.caches[frame].only_parent
        climbed.append(frame)
        if frame == 0 or len(climbed) > MAX_DEPTH + 1:
            return None
    return climbed


def _chained(caches: tuple[Cache, ...], stamp_ns: int) -> Pose | None:
    """Return the first child's pose in the last one's parent."""
    total = None
    for cache in caches:
        pose = cache.at(stamp_ns)
        if pose is None:
            return None
        total = pose if total is None else compose(pose, total)
    return IDENTITY_POSE if total is None else total


def find_path(tree: Tree, target: int, source: int, stamp_ns: int) -> Path | Failure:
    """Return the way from `source` to `target` at `stamp_ns`, as tf2 finds it, or why there is none."""
    if target == source:
        return Path(stamp_ns, [], [])
    if stamp_ns == LATEST:
        common = latest_common_time(tree, target, source)
        if isinstance(common, Failure):
            return common
        stamp_ns = common

    up: list[int] = []
    source_failure = None  # only fatal if the climb from the target does not come by
    frame = source
    while (cache := tree.caches[frame]) is not None:
        parent = cache.parent_at(stamp_ns)
        if parent == 0:
            source_failure = _gap(tree, frame, stamp_ns)
            break
        if frame == target:
            return Path(stamp_ns, up, [], is_direct=True)
        up.append(frame)
        frame = parent
        if len(up) > MAX_DEPTH:
            return Failure("loop")
    top = frame

    down: list[int] = []
    frame = target
    while frame != top and (cache := tree.caches[frame]) is not None:
        parent = cache.parent_at(stamp_ns)
        if parent == 0:
            target_failure = _gap(tree, frame, stamp_ns)
            if target_failure is not None:
                return target_failure
            break
        if frame == source:
            return Path(stamp_ns, [], down, is_direct=True)
        down.append(frame)
        frame = parent
        if len(down) > MAX_DEPTH:
            return Failure("loop")

    if frame == top:
        return Path(stamp_ns, up, down)
    return source_failure or Failure("disconnected")


def pose_on_path(tree: Tree, path: Path) -> Pose:
    """Return source's pose in target, chained along a path in tf2's order."""
    chained = _chained_literally if tree.has_infinity else _chained
    up = chained(tuple(tree.caches[frame] for frame in path.up), path.stamp_ns)
    if path.is_direct and not path.down:
        return up
    down = chained(tuple(tree.caches[frame] for frame in path.down), path.stamp_ns)
    if tree.has_infinity:
        back = quaternions.conjugate(down[3:])
        x, y, z = _turned_literally(back, (-down[0], -down[1], -down[2]))
        if path.is_direct:
            return (x, y, z, *back)
        dx, dy, dz = _turned_literally(back, up[:3])
        return (dx + x, dy + y, dz + z, *quaternions.multiply(back, up[3:]))
    return compose(invert(down), up)


def _chained_literally(caches: tuple[Cache, ...], stamp_ns: int) -> Pose:
    """Return what _chained does, but number by number as tf2: formulas differ in what they make of infinity."""
    total = IDENTITY_POSE
    for cache in caches:
        pose = cache.at(stamp_ns)
        dx, dy, dz = _turned_literally(pose[3:], total[:3])
        total = (dx + pose[0], dy + pose[1], dz + pose[2], *quaternions.multiply(pose[3:], total[3:]))
    return total


def _turned_literally(q: quaternions.Quaternion, v: quaternions.Vector3) -> quaternions.Vector3:
    """Return `v` turned by `q` as two products of quaternions: q (v, 0) conj(q)."""
    return quaternions.multiply(quaternions.multiply(q, (*v, 0.0)), quaternions.conjugate(q))[:3]


def frames_on_path(tree: Tree, path: Path, source: int) -> list[int]:
    """Return the frames on a path, from source to target, without what it climbs above the turning point."""
    climbed = [source, *(tree.caches[frame].parent_at(path.stamp_ns) for frame in path.up)]
    way: list[int] = []
    for frame in [*climbed, *reversed(path.down)]:
        if frame in way:
            del way[way.index(frame) :]
        way.append(frame)
    return way


def latest_common_time(tree: Tree, target: int, source: int) -> int | Failure:
    """Return the newest moment at which every frame on the way is known [ns].

    It is the earliest of the newest stamps below the frame where both climbs
    meet.  Static transforms do not count; 0 if nothing else is on the way.
    Parents are today's: those of the newest samples.
    """
    if target == source:
        cache = tree.caches[target]
        return cache.newest_ns if cache is not None else 0

    from_source: dict[int, int] = {}  # parent -> earliest newest stamp up to there, 0 for "no limit yet"
    limit, frame, depth = 0, source, 0
    while (cache := tree.caches[frame]) is not None and (parent := cache.newest_parent) != 0:
        limit = _earlier(limit, cache.newest_ns)
        from_source.setdefault(parent, limit)
        frame = parent
        if frame == target:
            return limit
        depth += 1
        if depth > MAX_DEPTH:
            return Failure("loop")

    limit, frame, depth = 0, target, 0
    while (cache := tree.caches[frame]) is not None and (parent := cache.newest_parent) != 0:
        limit = _earlier(limit, cache.newest_ns)
        if parent in from_source:
            return _earlier(limit, from_source[parent])
        frame = parent
        if frame == source:
            return limit
        depth += 1
        if depth > MAX_DEPTH:
            return Failure("loop")
    return Failure("disconnected")


def _earlier(a_ns: int, b_ns: int) -> int:
    """Return the earlier of two stamps, where 0 stands for no limit."""
    return min(a_ns, b_ns) if a_ns and b_ns else a_ns or b_ns


def _gap(tree: Tree, frame: int, stamp_ns: int) -> Failure | None:
    """Return why a history named no parent; None if it named NO_PARENT itself, and so is a root.

    In that last case tf2 answers with an identity that means nothing.  We do not.
    """
    cache = tree.caches[frame]
    if cache.at(stamp_ns) is not None:
        return None
    gap = cache.gap(stamp_ns)
    return Failure(gap.direction, frame, gap.requested_ns, gap.bound_ns)


def extrapolation_text(direction: str, requested_ns: int, bound_ns: int, target_frame: str, source_frame: str) -> str:
    """Return tf2's words for a history that does not reach."""
    requested, bound = format_stamp(requested_ns), format_stamp(bound_ns)
    if direction == "no_data":
        fault = f"at time {requested}, but only time {bound} is in the buffer"
    else:
        end = "latest" if direction == "future" else "earliest"
        fault = f"into the {direction}.  Requested time {requested} but the {end} data is at time {bound}"
    return (
        f"Lookup would require extrapolation {fault}, "
        f"when looking up transform from frame [{source_frame}] to frame [{target_frame}]"
    )


def text_from_failure(tree: Tree, failure: Failure, target_frame: str, source_frame: str) -> str:
    """Return tf2's words for a failure."""
    if failure.kind == "loop":
        return f"The tf tree is invalid because it contains a loop.\n{all_frames_as_string(tree)}\n"
    if failure.kind == "disconnected":
        return (
            f"Could not find a connection between '{target_frame}' and '{source_frame}' because they are "
            "not part of the same tree.Tf has two or more unconnected trees."
        )
    return extrapolation_text(failure.kind, failure.requested_ns, failure.bound_ns, target_frame, source_frame)


def exception_from_failure(tree: Tree, failure: Failure, target_frame: str, source_frame: str) -> TransformException:
    """Return the exception that tf2 raises for a failure, with what we know of the cause beside its text."""
    text = text_from_failure(tree, failure, target_frame, source_frame)
    asked = {"target_frame": target_frame, "source_frame": source_frame}
    if failure.kind == "loop":
        return LookupException(text, **asked)
    if failure.kind == "disconnected":
        return ConnectivityException(
            text,
            **asked,
            target_root=_root_name(tree, target_frame),
            source_root=_root_name(tree, source_frame),
        )
    return ExtrapolationException(
        text,
        **asked,
        direction=failure.kind,
        frame=tree.names[failure.frame],
        parent=tree.names[tree.caches[failure.frame].newest_parent] if len(tree.caches[failure.frame]) else "",
        requested_ns=failure.requested_ns,
        bound_ns=failure.bound_ns,
    )


def _root_name(tree: Tree, name: str) -> str:
    """Return where today's parents lead from a frame."""
    frame, seen = tree.numbers[name], set()
    while frame not in seen and tree.caches[frame] is not None and tree.caches[frame].newest_parent:
        seen.add(frame)
        frame = tree.caches[frame].newest_parent
    return tree.names[frame]
