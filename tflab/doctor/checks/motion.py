"""Measure how far poses move and rotate between samples, and find two publishers mixed on one edge.

    one owner      o--o--o--o--o--o          steps of one size
    two owners     o     o     o             back and forth, again and again:
                      x     x     x          each stream is smooth, the mixture is not

Values are compared as poses: metres, plus the turn in radians as it moves a point
at arm's length.  Everything is measured against the edge's own habits, so a drone
and a gripper need no settings.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from ..evidence import Edge

__all__ = ["ARM_M", "InterleavedStreams", "distances", "interleaved_streams", "is_constant", "steps_and_turns", "unit"]

ARM_M = 0.3  # a turn counts as far as it moves a point at this distance
LEAST_DIFFERENCE_M = 0.01  # values closer than this do not contradict each other
LOOK_BACK = 12  # samples: a second owner may be this many times slower
LARGEST_STEP = 1 / 3  # within a stream, as a fraction of the distance between the streams
MOST_SAMPLES = 5_000  # of an edge that are looked at for a second owner
CONSTANT = 1e-9
UNTURNED = (0.0, 0.0, 0.0, 1.0)


class InterleavedStreams(NamedTuple):
    """Two smooth sequences of values that alternate on one edge.

    Attributes:
        apart_m: how far apart they are, where they take turns.
        returns: how often the first came back after the second.
        first, last: first and last sample between which the two alternate.
    """

    apart_m: float
    returns: int
    first: int
    last: int


def distances(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Return how far poses are from each other [m]: shape (n,), of two arrays of shape (n, 7) of unit rotations."""
    step, turn = steps_and_turns(a, b)
    return step + ARM_M * turn


def steps_and_turns(a: np.ndarray, b: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return how far poses are from each other [m], and how far they are turned [rad]: shape (n,) each."""
    step = np.linalg.norm(a[:, :3] - b[:, :3], axis=1)
    dot = np.clip(np.abs(np.einsum("ij,ij->i", a[:, 3:], b[:, 3:])), 0.0, 1.0)
    # 2 acos(dot) is blind to turns below 1e-8; the chord is not
    chord = np.minimum(np.linalg.norm(a[:, 3:] - b[:, 3:], axis=1), np.linalg.norm(a[:, 3:] + b[:, 3:], axis=1))
    return step, np.where(dot > 0.99, 2.0 * chord, 2.0 * np.arccos(dot))


def unit(numbers: np.ndarray) -> np.ndarray:
    """Return poses with rotations of length one, shape (n, 7)."""
    scaled = numbers.copy()
    scaled[:, 3:] /= np.linalg.norm(numbers[:, 3:], axis=1)[:, None]
    return scaled


def is_constant(edge: Edge) -> bool:
    """Return whether an edge has the same value throughout."""
    poses = unit(edge.numbers[edge.is_usable])
    return len(poses) > 0 and bool((distances(poses, np.broadcast_to(poses[0], poses.shape)) < CONSTANT).all())


def interleaved_streams(edge: Edge) -> InterleavedStreams | None:
    """Return the two streams that alternate on an edge, or None if there is one.

    Samples are followed in the order of their stamps, so that one who merely came
    late is no second owner; if the clock was set, that order means nothing, and
    they are followed as they arrived.
    """
    rows = np.arange(len(edge)) if edge.jumps else np.argsort(edge.stamp_ns, kind="stable")
    rows = rows[edge.is_usable[rows]][:MOST_SAMPLES]
    if len(rows) < 6:
        return None
    poses = unit(edge.numbers[rows])
    return _streams_of(poses, rows) or _streams_of(_without_turns(poses), rows)


def _without_turns(poses: np.ndarray) -> np.ndarray:
    """Return poses that do not turn: a wheel turns too fast to tell who turned it, but its hub stays where it is."""
    places = poses.copy()
    places[:, 3:] = UNTURNED
    return places


def _streams_of(poses: np.ndarray, rows: np.ndarray) -> InterleavedStreams | None:
    look_back = _less_than_half_a_turn(poses)
    if look_back < 2:
        return None
    nearest = np.full(len(poses) - 1, np.inf)  # of each sample but the first: to any of the few before it
    for lag in range(1, min(look_back, len(poses) - 1) + 1):
        nearest[lag - 1 :] = np.minimum(nearest[lag - 1 :], distances(poses[lag:], poses[:-lag]))
    apart_m = max(LEAST_DIFFERENCE_M, 3.0 * float(np.percentile(nearest, 90)))
    step = distances(poses[1:], poses[:-1])
    if np.count_nonzero(step > apart_m) < 4:
        return None
    return _follow_streams(poses, rows, apart_m, look_back)


def _less_than_half_a_turn(poses: np.ndarray) -> int:
    """Return how many samples to look back: a wheel, which only turns, is back where it was after each turn."""
    if np.ptp(poses[:, :3], axis=0).max() > LEAST_DIFFERENCE_M:
        return LOOK_BACK
    dot = np.abs(np.einsum("ij,ij->i", poses[1:, 3:], poses[:-1, 3:]))
    turn_rad = 2.0 * float(np.percentile(np.arccos(np.clip(dot, 0.0, 1.0)), 90))
    return LOOK_BACK if turn_rad * LOOK_BACK < np.pi else int(0.5 * np.pi / turn_rad)


def _follow_streams(poses: np.ndarray, rows: np.ndarray, apart_m: float, look_back: int) -> InterleavedStreams | None:
    """Follow two streams through the samples: each sample continues the nearer one, or begins another."""
    last_of: list[int] = [0]  # the newest sample of each stream, the latest stream at the end
    returns = []
    apart: list[float] = []
    within: list[float] = []  # how far each sample is from the one before it in its own stream
    for i in range(1, len(poses)):
        here = poses[i : i + 1]
        gaps = [float(distances(here, poses[j : j + 1])[0]) for j in last_of]
        stream = int(np.argmin(gaps))
        if gaps[stream] > apart_m:
            last_of.append(i)
            del last_of[:-2]
            continue
        if stream != len(last_of) - 1 and i - last_of[stream] <= look_back + 1:
            returns.append(i)
            apart.append(gaps[-1])
        within.append(gaps[stream])
        last_of.append(last_of.pop(stream))
        last_of[-1] = i
    if len(returns) < 4 or len(returns) < 0.08 * (returns[-1] - returns[0]):
        return None
    apart_m = float(np.median(apart))
    if float(np.median(within)) > LARGEST_STEP * apart_m:
        return None  # one noisy owner: its values are as far from each other as the two streams
    return InterleavedStreams(apart_m, len(returns), int(rows[returns[0]]), int(rows[returns[-1]]))
