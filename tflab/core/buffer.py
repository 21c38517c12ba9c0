"""Store transforms and look them up: BufferCore.

    publish -->  set_transform(parent_T_child, stamp)      one sample of one edge
                              |
                       [ tree of histories ]
                              |
    look up -->  lookup_transform(target, source, stamp)   target_T_source

A lookup converts data expressed in *source* into *target*. Stamps are integer
nanoseconds; LATEST (0) requests the newest time at which the whole path is known.

A bad transform is rejected without an exception, as in tf2: it is reported to the
logger `tflab.tf2`, and set_transform returns False. On a robot, the publisher is in
another process and could not catch an exception.

One thread may write while others read. tf2 calls this BufferCore
(tf2/src/buffer_core.cpp, 0.39.1).
"""

from __future__ import annotations

from collections.abc import Sequence
from math import isinf

import numpy as np

from . import batch, columns, validation, velocity
from .cache import Cache, Gap, TimeCache
from .errors import TransformException
from .failures import text_from_failure
from .inspection import Inspection
from .poses import IDENTITY_POSE, Pose, are_ordinary_numbers, canonical_pose, compose
from .requests import RequestCallback, RequestQueue
from .stamps import NSEC_PER_SEC
from .transforms import StampedTransform, Transform, stamped_from_pose
from .tree import LookupFailure, find_path, latest_common_time, pose_along

__all__ = ["DEFAULT_CACHE_TIME_NS", "BufferCore"]

DEFAULT_CACHE_TIME_NS = 10 * NSEC_PER_SEC


class BufferCore(Inspection):
    """Transforms between frames, through time.  What one can read off it besides is in `inspection.py`.

    Args:
        cache_time_ns: how far each history reaches back from its newest sample [ns].
    """

    def __init__(self, cache_time_ns: int = DEFAULT_CACHE_TIME_NS) -> None:
        cache_time_ns = validation.whole_nanoseconds(cache_time_ns, "cache_time_ns")
        if cache_time_ns < 0:
            raise ValueError(f"cache_time_ns must not be negative: {cache_time_ns}")
        super().__init__(cache_time_ns)
        self._edges: dict[tuple[str, str, bool], tuple[Cache, int, int]] = {}  # of sound names, as published
        self._requests = RequestQueue(self._tree)

    # -- publishing -------------------------------------------------------

    def set_transform(
        self, stamped: StampedTransform, authority: str = "default_authority", is_static: bool = False
    ) -> bool:
        """Store where `stamped.child_frame_id` is in `stamped.frame_id`; return False if it is refused.

        One leading slash of a name is dropped.  A rotation of any length is
        scaled to one.  Refused are, with a line in the log for each fault: a frame
        that is its own parent, an empty name, NaN, a quaternion without direction,
        and a stamp older than the newest by more than the cache time.  Then the
        requests that wait are judged.

        Raises:
            TypeError: the stamp is not an integer.
            ValueError: it does not fit in 64 bits.
        """
        numbers = stamped.transform.translation + stamped.transform.rotation
        stamp_ns = stamped.stamp_ns
        if type(stamp_ns) is not int or not -(2**63) <= stamp_ns < 2**63:
            stamp_ns = validation.stamp_in_range(stamp_ns)
        self._lock.acquire()  # a `with` would cost twice as much, and this is done for every transform
        try:
            edge = self._edges.get((stamped.frame_id, stamped.child_frame_id, is_static))
            if edge is None or not are_ordinary_numbers(numbers):
                edge = self._examined_edge(stamped, numbers, authority, is_static)
                if edge is None:
                    return False
            cache, parent, child = edge
            only_parent = cache.only_parent
            if not cache.insert(stamp_ns, numbers, parent, authority):
                validation.log_old_data(self._tree.names[child], stamp_ns, authority)
                return False
            if cache.only_parent != only_parent:
                self._shape_changed()
            self._tree.authorities[child] = authority
            if self._requests.waiting:
                self._requests.judge_all()
            return True
        finally:
            self._lock.release()

    def set_transforms(
        self,
        parent: str,
        child: str,
        stamps_ns: Sequence[int] | np.ndarray,
        translations: np.ndarray,
        rotations_xyzw: np.ndarray,
        authority: str = "default_authority",
    ) -> int:
        """Store many samples of one moving edge, as if set one by one; return how many were accepted.

        Args:
            stamps_ns: shape (N,) [ns], fastest if each is newer than the one before.
            translations: shape (N, 3) [m].
            rotations_xyzw: shape (N, 4).

        Raises:
            ValueError: the shapes do not fit together.
        """
        stamps, numbers = columns.columns_from_arrays(stamps_ns, translations, rotations_xyzw)
        with self._lock:
            cache = self._tree.caches[self._tree.numbers.get(child, 0)]
            newest_ns = cache.newest_ns if isinstance(cache, TimeCache) and len(cache) else None
            if self._requests.waiting or not columns.is_plain(parent, child, stamps, numbers, newest_ns):
                return sum(
                    self.set_transform(StampedTransform(parent, child, stamp, Transform(row[:3], row[3:])), authority)
                    for stamp, row in zip(stamps.tolist(), numbers.tolist(), strict=True)
                )
            if len(stamps):
                cache, parent_number, child_number = self._edge(parent, child, is_static=False)
                assert isinstance(cache, TimeCache)  # what was asked for
                only_parent = cache.only_parent
                cache.extend(stamps, numbers, parent_number, authority)
                if cache.only_parent != only_parent:
                    self._shape_changed()
                self._tree.authorities[child_number] = authority
        return len(stamps)

    def clear(self) -> None:
        """Forget every moving sample; names, static transforms, authorities and requests stay."""
        with self._lock:
            for cache in self._tree.caches:
                if cache is not None:
                    cache.clear()
            self._shape_changed()

    # -- asking -----------------------------------------------------------

    def lookup_transform(self, target_frame: str, source_frame: str, stamp_ns: int) -> StampedTransform:
        """Return `target_T_source` at `stamp_ns` [ns], or at the newest possible moment if it is LATEST.

        The answer carries the moment it holds for (0 if only static transforms
        are involved).  Two equal names are always an identity, even unknown ones.

        Raises:
            InvalidArgumentException: a name is empty or begins with a slash.
            LookupException: a name is unknown, or the tree has a loop.
            ConnectivityException: the frames are in different trees.
            ExtrapolationException: a history on the way does not reach `stamp_ns`.
        """
        if type(stamp_ns) is not int:
            stamp_ns = validation.whole_nanoseconds(stamp_ns)
        self._lock.acquire()  # a `with` would cost twice as much
        try:
            route = self._routes.known.get((target_frame, source_frame))
            if route is None:
                return self._lookup_from_scratch(target_frame, source_frame, stamp_ns)
            moment_ns = stamp_ns or route.latest_common_time()
            try:
                pose = route.pose_at(moment_ns)
            except Gap:
                return self._lookup_from_scratch(target_frame, source_frame, stamp_ns)
            return stamped_from_pose(target_frame, source_frame, moment_ns, pose)
        finally:
            self._lock.release()

    def lookup_transform_full(
        self, target_frame: str, target_ns: int, source_frame: str, source_ns: int, fixed_frame: str
    ) -> StampedTransform:
        """Return source's pose at `source_ns` as seen from target at `target_ns`.

        `fixed_frame` is the one that did not move in between: `source` is looked
        up in it at `source_ns`, and it in `target` at `target_ns`.

        Raises:
            TransformException: as for lookup_transform.
        """
        with self._lock:
            validation.frame_number_or_raise(self._tree, "lookupTransform argument target_frame", target_frame)
            validation.frame_number_or_raise(self._tree, "lookupTransform argument source_frame", source_frame)
            validation.frame_number_or_raise(self._tree, "lookupTransform argument fixed_frame", fixed_frame)
            fixed_T_source = self.lookup_transform(fixed_frame, source_frame, source_ns)
            target_T_fixed = self.lookup_transform(target_frame, fixed_frame, target_ns)
        outer, inner = target_T_fixed.transform, fixed_T_source.transform
        pose = compose(outer.translation + outer.rotation, inner.translation + inner.rotation)
        return stamped_from_pose(target_frame, source_frame, target_T_fixed.stamp_ns, canonical_pose(pose))

    def lookup_transforms(
        self,
        target_frame: str,
        source_frame: str,
        stamps_ns: Sequence[int] | np.ndarray,
        raise_on_failure: bool = False,
    ) -> batch.Batch:
        """Return `target_T_source` at each of `stamps_ns`, shape (N,) [ns], as lookup_transform would.

        Where there is no answer the row is NaN, and `failures` says why; with
        `raise_on_failure` the first such failure is raised instead.
        """
        with self._lock:
            answers = batch.lookup(
                lambda stamp_ns: self.lookup_transform(target_frame, source_frame, stamp_ns),
                self.history_ends,
                self._tables,
                self._routes.between(target_frame, source_frame),
                stamps_ns,
            )
        if raise_on_failure and len(answers.failures):
            raise next(iter(answers.failures.values()))
        return answers

    def can_transform(self, target_frame: str, source_frame: str, stamp_ns: int) -> bool:
        """Return whether lookup_transform would answer."""
        return self.why_not(target_frame, source_frame, stamp_ns)[0]

    def can_transform_full(
        self, target_frame: str, target_ns: int, source_frame: str, source_ns: int, fixed_frame: str
    ) -> bool:
        """Return whether lookup_transform_full would answer."""
        return self.why_not_full(target_frame, target_ns, source_frame, source_ns, fixed_frame)[0]

    def why_not(self, target_frame: str, source_frame: str, stamp_ns: int) -> tuple[bool, str]:
        """Return (can_transform, tf2's text why not), the text "" if it can."""
        stamp_ns = validation.whole_nanoseconds(stamp_ns)
        if target_frame == source_frame:
            return True, ""
        with self._lock:
            text = validation.unknown_frame_text(self._tree, target_frame=target_frame, source_frame=source_frame)
            if text:
                return False, text
            path = find_path(self._tree, self._tree.numbers[target_frame], self._tree.numbers[source_frame], stamp_ns)
            if isinstance(path, LookupFailure):
                return False, text_from_failure(self._tree, path, target_frame, source_frame)
            return True, ""

    def why_not_full(
        self, target_frame: str, target_ns: int, source_frame: str, source_ns: int, fixed_frame: str
    ) -> tuple[bool, str]:
        """Return (can_transform_full, tf2's text why not), the text "" if it can."""
        target_ns, source_ns = validation.whole_nanoseconds(target_ns), validation.whole_nanoseconds(source_ns)
        with self._lock:
            text = validation.unknown_frame_text(
                self._tree, target_frame=target_frame, source_frame=source_frame, fixed_frame=fixed_frame
            )
            if text:
                return False, text
            can, text = self.why_not(target_frame, fixed_frame, target_ns)
            return self.why_not(fixed_frame, source_frame, source_ns) if can else (can, text)

    def latest_common_time_ns(self, target_frame: str, source_frame: str) -> int:
        """Return the moment that LATEST means between two frames [ns]; 0 if only static transforms join them.

        Raises:
            TransformException: a bad or unknown name, or no path.
        """
        with self._lock:
            target = validation.frame_number_or_raise(self._tree, "get_latest_common_time", target_frame)
            source = validation.frame_number_or_raise(self._tree, "get_latest_common_time", source_frame)
            common_ns = latest_common_time(self._tree, target, source)
            if isinstance(common_ns, LookupFailure):
                text = text_from_failure(self._tree, common_ns, target_frame, source_frame)
                raise TransformException(text, target_frame=target_frame, source_frame=source_frame)
            return common_ns

    def lookup_velocity(
        self,
        tracking_frame: str,
        observation_frame: str,
        stamp_ns: int,
        averaging_ns: int,
        reference_frame: str | None = None,
        reference_point: Sequence[float] = (0.0, 0.0, 0.0),
        reference_point_frame: str | None = None,
    ) -> velocity.Velocity:
        """Return how fast `tracking_frame` moves as seen from `observation_frame`, around `stamp_ns`.

        Args:
            averaging_ns: length of the interval that is averaged over [ns].
            reference_frame: whose axes the answer is written in; observation_frame if None.
            reference_point: the point of the moving body to speak of [m], in
                reference_point_frame (tracking_frame if None).

        Raises:
            TransformException: as for lookup_transform.
        """
        with self._lock:
            return velocity.lookup_velocity(
                self.lookup_transform, self.latest_common_time_ns,
                tracking_frame, observation_frame, stamp_ns, averaging_ns,
                reference_frame, reference_point, reference_point_frame,
            )  # fmt: skip

    # -- waiting ----------------------------------------------------------

    def request_transformable(
        self, target_frame: str, source_frame: str, stamp_ns: int, callback: RequestCallback
    ) -> int:
        """Have `callback(handle, target_frame, source_frame, stamp_ns, result)` called once it is decided.

        `result` is "available" or "failure"; the call comes from within the
        set_transform that decided it.  Return the handle, or
        `requests.POSSIBLE_NOW` or `requests.NEVER`, and then there is no call.
        """
        stamp_ns = validation.whole_nanoseconds(stamp_ns)
        with self._lock:
            return self._requests.add(target_frame, source_frame, stamp_ns, callback)

    def cancel_request(self, handle: int) -> None:
        """Forget a request; an unknown handle is ignored."""
        with self._lock:
            self._requests.cancel(handle)

    # -- inside -----------------------------------------------------------

    def _examined_edge(
        self, stamped: StampedTransform, numbers: Pose, authority: str, is_static: bool
    ) -> tuple[Cache, int, int] | None:
        """Look closely at a transform that is new or odd; return its edge, or None if it is refused."""
        parent, child = stamped.frame_id, stamped.child_frame_id
        if not (validation.are_ordinary_names(parent, child) and are_ordinary_numbers(numbers)):
            parent, child = validation.without_slash(parent), validation.without_slash(child)
            if not validation.is_acceptable(parent, child, numbers, authority):
                return None
            if any(map(isinf, numbers)):
                self._tree.has_infinity = True
                self._shape_changed()
            return self._edge(parent, child, is_static)
        edge = self._edges[parent, child, is_static] = self._edge(parent, child, is_static)
        return edge

    def _edge(self, parent: str, child: str, is_static: bool) -> tuple[Cache, int, int]:
        """Return the history of a child, an empty one if it is new or changes its kind, and both numbers."""
        child_number = self._tree.number_of(child)
        before = self._tree.caches[child_number]
        cache = self._tree.cache_for(child_number, is_static)
        if cache is not before:
            self._shape_changed()
        return cache, self._tree.number_of(parent), child_number

    def _shape_changed(self) -> None:
        """Forget every path that was remembered: some frame got another parent, or another history."""
        self._edges.clear()
        self._routes.forget()
        self._tables.clear()

    def _lookup_from_scratch(self, target_frame: str, source_frame: str, stamp_ns: int) -> StampedTransform:
        """Look up the long way, as tf2 does, and try to make the next time shorter."""
        if target_frame == source_frame:
            cache = self._tree.caches[self._tree.numbers.get(source_frame, 0)]
            newest_ns = cache.newest_ns if cache is not None else 0
            return stamped_from_pose(target_frame, source_frame, stamp_ns or newest_ns, IDENTITY_POSE)
        path = self._find_path(target_frame, source_frame, stamp_ns)
        self._routes.between(target_frame, source_frame)
        pose = canonical_pose(pose_along(self._tree, path))
        return stamped_from_pose(target_frame, source_frame, path.stamp_ns, pose)
