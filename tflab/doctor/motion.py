"""How does it move?  Steps, jumps of a clock, and two stories told at once.

    one owner      o--o--o--o--o--o          steps of one size
    two owners     o     o     o             back and forth, again and again:
                      x     x     x          each story is smooth, the mixture is not

Values are compared as poses: metres, plus the turn in radians as it moves a point
at arm's length.  Everything is measured against the edge's own habits, so a drone
and a gripper need no settings.

Read `names.py` next.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tflab.core import NSEC_PER_SEC

from .evidence import Edge

__all__ = ["Jump", "Stories", "clock_jumps", "distances", "is_constant", "segments", "two_stories"]

ARM_M = 0.3  # a turn counts as far as it moves a point at this distance
LEAST_DIFFERENCE_M = 0.01  # values closer than this do not contradict each other
LEAST_JUMP_S = 0.05
LEVEL_SAMPLES = 7  # that tell where a level is, before and after a jump
LOOK_BACK = 12  # samples: a second owner may be this many times slower
MOST_SAMPLES = 20_000  # of an edge that are looked at for a second owner
CONSTANT = 1e-9


class Jump(NamedTuple):
    """The clock behind an edge jumped before sample `index`, by `size_s` (negative: back)."""

    index: int
    size_s: float


class Stories(NamedTuple):
    """Two smooth sequences of values that were told alternately.

    Attributes:
        apart_m: how far apart they are, where they take turns.
        returns: how often the first came back after the second.
        first, last: samples between which both were told.
    """

    apart_m: float
    returns: int
    first: int
    last: int


def distances(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Return how far poses are from each other [m]: shape (n,), of two arrays of shape (n, 7) of unit rotations."""
    step = np.linalg.norm(a[:, :3] - b[:, :3], axis=1)
    dot = np.clip(np.abs(np.einsum("ij,ij->i", a[:, 3:], b[:, 3:])), 0.0, 1.0)
    # 2 acos(dot) is blind to turns below 1e-8; the chord is not
    chord = np.minimum(np.linalg.norm(a[:, 3:] - b[:, 3:], axis=1), np.linalg.norm(a[:, 3:] + b[:, 3:], axis=1))
    turn = np.where(dot > 0.99, 2.0 * chord, 2.0 * np.arccos(dot))
    return step + ARM_M * turn


def unit(numbers: np.ndarray) -> np.ndarray:
    """Return poses with rotations of length one, shape (n, 7)."""
    scaled = numbers.copy()
    scaled[:, 3:] /= np.linalg.norm(numbers[:, 3:], axis=1)[:, None]
    return scaled


def is_constant(edge: Edge) -> bool:
    """Return whether an edge has the same value throughout."""
    poses = unit(edge.numbers[edge.is_usable])
    return len(poses) > 0 and bool((distances(poses, np.broadcast_to(poses[0], poses.shape)) < CONSTANT).all())


def clock_jumps(edge: Edge) -> list[Jump]:
    """Return where the stamps of an edge left the time of receipt for good.

    A message that was merely late, or came in the wrong order, changes nothing
    for those after it; a clock that was set does.
    """
    offset_s = edge.offset_s
    if len(offset_s) < 4:
        return []
    change_s = np.diff(offset_s)
    habit_s = 1.4826 * float(np.median(np.abs(change_s - np.median(change_s))))
    least_s = max(LEAST_JUMP_S, 8.0 * habit_s, 1.5 * edge.period_ns / NSEC_PER_SEC)
    stamp_step_s = np.diff(edge.stamp_ns) / NSEC_PER_SEC
    receive_step_s = np.diff(edge.receive_ns) / NSEC_PER_SEC
    back = (stamp_step_s < 0.0) & (change_s > least_s)
    forward = (change_s < -least_s) & (stamp_step_s > receive_step_s + least_s)
    jumps = []
    for before in np.flatnonzero(back | forward).tolist():
        after = before + 1
        level_s = np.median(offset_s[max(0, after - LEVEL_SAMPLES) : after])
        new_level_s = np.median(offset_s[after : after + LEVEL_SAMPLES])
        shift_s = float(new_level_s - level_s)
        if abs(shift_s) > 0.7 * abs(change_s[before]) and shift_s * change_s[before] > 0.0:
            jumps.append(Jump(after, -shift_s))
    return jumps


def segments(edge: Edge, jumps: list[Jump]) -> list[slice]:
    """Return the stretches of an edge between the jumps of its clock."""
    bounds = [0, *(jump.index for jump in jumps), len(edge)]
    return [slice(a, b) for a, b in zip(bounds, bounds[1:], strict=False) if b > a]


def two_stories(edge: Edge) -> Stories | None:
    """Return the two stories that an edge tells alternately, or None if it tells one."""
    rows = np.flatnonzero(edge.is_usable)[:MOST_SAMPLES]
    if len(rows) < 6:
        return None
    poses = unit(edge.numbers[rows])
    nearest = np.full(len(poses) - 1, np.inf)  # of each sample but the first: to any of the few before it
    for lag in range(1, min(LOOK_BACK, len(poses) - 1) + 1):
        nearest[lag - 1 :] = np.minimum(nearest[lag - 1 :], distances(poses[lag:], poses[:-lag]))
    apart_m = max(LEAST_DIFFERENCE_M, 3.0 * float(np.percentile(nearest, 90)))
    step = distances(poses[1:], poses[:-1])
    if np.count_nonzero(step > apart_m) < 4:
        return None
    return _told_alternately(poses, rows, apart_m)


def _told_alternately(poses: np.ndarray, rows: np.ndarray, apart_m: float) -> Stories | None:
    """Follow two stories through the samples: each sample continues the nearer one, or begins another."""
    last_of: list[int] = [0]  # the newest sample of each story, the story told last at the end
    returns = []
    apart = []
    for i in range(1, len(poses)):
        here = poses[i : i + 1]
        gaps = [float(distances(here, poses[j : j + 1])[0]) for j in last_of]
        story = int(np.argmin(gaps))
        if gaps[story] > apart_m:
            last_of.append(i)
            del last_of[:-2]
            continue
        if story != len(last_of) - 1 and i - last_of[story] <= LOOK_BACK + 1:
            returns.append(i)
            apart.append(gaps[-1])
        last_of.append(last_of.pop(story))
        last_of[-1] = i
    if len(returns) < 4 or len(returns) < 0.08 * (returns[-1] - returns[0]):
        return None
    return Stories(float(np.median(apart)), len(returns), int(rows[returns[0]]), int(rows[returns[-1]]))
