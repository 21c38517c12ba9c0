"""Calculate the share of each topic's messages that can be looked up at their stamp: at once, and after a wait.

An edge answers at a stamp as soon as a sample at or before the stamp and one at or after it have been received:

    stamps        o-----o-----o--x--o       x: the stamp of a message
    received      1     2     3     4       the edge answers at time 4

Two running minima of the times of receipt give that time for all messages of a topic. The path answers when its last
edge does; that edge is the one that is waited for. If the sample before the stamp is then older than the cache, the
lookup never works. Each message is looked up on the path that the tree had at its stamp. A child that is both static
and moving counts as what most of its samples are.

Headers in another time base are not looked up. A leading slash, which has a finding of its own, is left out.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator

import numpy as np

from tflab.bags.recording import Headers
from tflab.core import NSEC_PER_SEC

from .evidence import Edge, Evidence, LookupRow

__all__ = ["CACHE_NS", "FIXED_FRAMES", "WAITS_S", "lookups_of"]

WAITS_S = (0.0, 0.1, 0.5, 1.0)
CACHE_NS = 10 * NSEC_PER_SEC  # what tf2 keeps by default
FIXED_FRAMES = ("map", "odom", "base_link", "base_footprint")
NEVER = np.iinfo(np.int64).max
FEWEST_WAIT = 0.1  # of the messages wait less than `wait_ns`


def lookups_of(evidence: Evidence) -> tuple[LookupRow, ...]:
    """Return a row for each topic, frame and fixed frame: the root of the tree, and the usual ones that exist.

    Frames outside the tree have no row, and a frame is not looked up in a frame that moves with it.
    """
    edges: dict[str, list[Edge]] = {}
    separated = [samples.source for samples in evidence.in_other_time if isinstance(samples.source, Edge)]
    for edge in (*evidence.edges(), *separated):
        edges.setdefault(edge.child, []).append(edge)
    histories = {child: history for child, parts in edges.items() if len((history := _History(parts)).stamp_ns)}
    rows: list[LookupRow] = []
    for header in evidence.headers:
        for number, frame in enumerate(header.frames):
            mine = header.frame == number
            if frame.removeprefix("/") in evidence.frames and mine.any():
                rows += _rows_of(evidence, histories, header, frame.removeprefix("/"), mine)
    return tuple(rows)


class _History:
    """The samples of one child that a buffer accepts, in the order of arrival and by stamp."""

    def __init__(self, parts: list[Edge]) -> None:
        self.is_static = sum(len(part) if part.is_static else -len(part) for part in parts) > 0
        parts = [part for part in parts if part.is_static == self.is_static]
        self.parents = sorted({parent for part in parts for parent in part.parents})
        samples = np.concatenate([_columns(part, self.parents) for part in parts], axis=1)
        self.receive_ns, _, stamp_ns, parent = samples[:, np.lexsort(samples[1::-1])]
        newest_ns = np.maximum.accumulate(stamp_ns) if len(stamp_ns) else stamp_ns
        self.horizon_ns = np.append(np.iinfo(np.int64).min, newest_ns[:-1] - CACHE_NS)  # an insert drops what is older
        accepted = np.flatnonzero(self.is_static | (stamp_ns >= newest_ns - CACHE_NS))
        by_stamp = accepted if self.is_static else accepted[np.argsort(stamp_ns[accepted], kind="stable")]
        self.stamp_ns, self.parent, arrival_ns = stamp_ns[by_stamp], parent[by_stamp], self.receive_ns[by_stamp]
        self.at_or_after_ns = np.append(np.minimum.accumulate(arrival_ns[::-1])[::-1], NEVER)
        self.at_or_before_ns = np.append(NEVER, np.minimum.accumulate(arrival_ns))

    def ready_ns(self, stamp_ns: np.ndarray) -> np.ndarray:
        """Return from when on the edge answers at each stamp, or NEVER; a stamp of zero asks for the latest sample."""
        if self.is_static:
            return np.full(len(stamp_ns), self.receive_ns[0])
        after_ns = self.at_or_after_ns[np.searchsorted(self.stamp_ns, stamp_ns, "left")]
        before_ns = self.at_or_before_ns[np.searchsorted(self.stamp_ns, stamp_ns, "right")]
        return np.where(stamp_ns == 0, self.receive_ns[0], np.maximum(after_ns, before_ns))

    def is_forgotten(self, stamp_ns: np.ndarray, time_ns: np.ndarray) -> np.ndarray:
        """Return whether the sample at or before each stamp is no longer kept at a time."""
        if self.is_static or self.stamp_ns[-1] - self.stamp_ns[0] <= CACHE_NS:
            return np.zeros(len(stamp_ns), dtype=bool)
        horizon_ns = self.horizon_ns[np.searchsorted(self.receive_ns, time_ns, "right") - 1]
        before_ns = self.stamp_ns[np.searchsorted(self.stamp_ns, stamp_ns, "right") - 1]
        return (before_ns < horizon_ns) & (stamp_ns != 0)

    def parent_at(self, stamp_ns: np.ndarray, receive_ns: np.ndarray) -> np.ndarray:
        """Return the number of the parent at each stamp; of a static edge, of the last one that was received."""
        known_ns, time_ns = (self.receive_ns, receive_ns) if self.is_static else (self.stamp_ns, stamp_ns)
        return self.parent[np.maximum(np.searchsorted(known_ns, time_ns, "right") - 1, 0)]


def _columns(edge: Edge, parents: list[str]) -> np.ndarray:
    """Return receipt, row, stamp and parent of the samples that tf2 accepts: shape (4, n)."""
    number = np.array([parents.index(parent) for parent in edge.parents])
    is_parent = np.array([parent not in ("", edge.child) for parent in edge.parents])
    mine = edge.is_usable & is_parent[edge.parent]
    columns = (edge.receive_ns, edge.rows, edge.stamp_ns, number[edge.parent])
    return np.stack([column[mine] for column in columns]).astype(np.int64)


def _rows_of(
    evidence: Evidence, histories: dict[str, _History], header: Headers, frame: str, mine: np.ndarray
) -> Iterator[LookupRow]:
    """Yield a row for each fixed frame in which the messages of one topic and frame may be looked up."""
    receive_ns, stamp_ns = header.receive_ns[mine], header.stamp_ns[mine]
    period_ns = int(np.median(np.diff(receive_ns))) if len(receive_ns) > 1 else 0
    trees, ready_of = _trees(histories, stamp_ns, receive_ns), {}
    for fixed in dict.fromkeys((evidence.root_of(frame), *FIXED_FRAMES)):
        if fixed not in evidence.frames or evidence.is_below(fixed, frame):
            continue
        wait_ns = np.full(len(stamp_ns), NEVER)
        waited_for: Counter[str] = Counter()
        for parent_of, which in trees:
            path = _path(parent_of, frame, fixed)
            for child in path:
                if child not in ready_of:
                    ready_of[child] = histories[child].ready_ns(stamp_ns)
            if path:
                of_path = np.stack([ready_of[child][which] for child in path])
                time_ns = np.maximum(of_path.max(axis=0), receive_ns[which])
                forgotten = [histories[child].is_forgotten(stamp_ns[which], time_ns) for child in path]
                is_never = (time_ns == NEVER) | np.any(forgotten, axis=0)
                wait_ns[which] = np.where(is_never, NEVER, time_ns - receive_ns[which])
                awaited = _awaited(histories, path, of_path, stamp_ns[which], receive_ns[which])
                last = awaited[wait_ns[which] > 0]
                waited_for.update(dict(zip(path, np.bincount(last, minlength=len(path)).tolist(), strict=True)))
        child = max(waited_for, key=waited_for.__getitem__) if any(waited_for.values()) else ""
        shares = tuple(float((wait_ns <= wait_s * NSEC_PER_SEC).mean()) for wait_s in WAITS_S)
        edge = (evidence.parent_of.get(child, ""), child)
        least_ns = int(np.sort(wait_ns)[int(FEWEST_WAIT * len(wait_ns))])
        yield LookupRow(header.topic, frame, fixed, len(stamp_ns), shares, *edge, least_ns, period_ns)


def _awaited(
    histories: dict[str, _History], path: list[str], ready_ns: np.ndarray, stamp_ns: np.ndarray, receive_ns: np.ndarray
) -> np.ndarray:
    """Return which edge of a path each message waits for: one that has forgotten its sample by itself, or the last."""
    own_ns = np.maximum(ready_ns, receive_ns)
    gone = np.stack([histories[c].is_forgotten(stamp_ns, time_ns) for c, time_ns in zip(path, own_ns, strict=True)])
    is_gone = gone.any(axis=0) & (ready_ns != NEVER).all(axis=0)
    return np.where(is_gone, gone.argmax(axis=0), ready_ns.argmax(axis=0))


def _trees(
    histories: dict[str, _History], stamp_ns: np.ndarray, receive_ns: np.ndarray
) -> list[tuple[dict[str, str], np.ndarray | slice]]:
    """Return the parents in each form that the tree has at these stamps, and at which of them."""
    usual = {child: history.parents[0] for child, history in histories.items()}
    forks = [child for child, history in histories.items() if len(history.parents) > 1]
    if not forks:
        return [(usual, slice(None))]
    numbers = np.stack([histories[child].parent_at(stamp_ns, receive_ns) for child in forks], axis=1)
    forms, form = np.unique(numbers, axis=0, return_inverse=True)
    return [
        (usual | {c: histories[c].parents[n] for c, n in zip(forks, row, strict=True)}, form.ravel() == i)
        for i, row in enumerate(forms.tolist())
    ]


def _path(parent_of: dict[str, str], frame: str, fixed: str) -> list[str]:
    """Return the children of the edges between two frames, none if they are not connected."""
    up, down = _climb(parent_of, frame), _climb(parent_of, fixed)
    if up[-1:] != down[-1:]:
        return []
    return [child for child in (*up, *down) if (child in up) != (child in down)]


def _climb(parent_of: dict[str, str], frame: str) -> list[str]:
    """Return a frame and what is above it up to the root, nothing if the frames go round in a circle."""
    above = [frame]
    while above[-1] in parent_of:
        above.append(parent_of[above[-1]])
        if len(above) > len(parent_of) + 1:
            return []
    return above
