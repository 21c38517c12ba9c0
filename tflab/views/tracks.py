"""Which is smoother, and which is right?  One drive, told by several frames.

    from above                   step from one sample to the next [m]
       ____________              |            |          |         map: small, and now and then a leap
      /  ......    \\             |____________|__________|___
      | :  truth :  |            how far from the truth [m]
      \\  ''''''   /              |                     ______     odom: never a leap, and ever farther off
        odom                     |_________-----------

A track that drifts and never leaps is good for the next half metre; one that leaps
and never drifts is good for tomorrow.  REP-105 gives each its frame.

What the field calls absolute trajectory error is the lower curve.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np

from . import style
from .picture import Picture

__all__ = ["Smoothness", "describe_tracks", "draw_tracks", "errors_of", "smoothness", "steps_of"]

LINES = ("solid", (0, (4.0, 1.6)), (0, (1.0, 1.1)))
COLOURS = (style.ACCENT, style.INK, style.AXIS_COLOURS["z"])
TRUTH_WIDTH, TRACK_WIDTH = 5.0, 1.6


class Smoothness(NamedTuple):
    """What a track is like [m]: its largest step between two samples, and how far from the truth it is at worst."""

    largest_step_m: float
    worst_error_m: float


def steps_of(track: np.ndarray) -> np.ndarray:
    """Return how far each sample of a track, shape (n, 2), is from the one before it [m], shape (n - 1,)."""
    return np.linalg.norm(np.diff(track, axis=0), axis=1)


def errors_of(track: np.ndarray, truth: np.ndarray) -> np.ndarray:
    """Return how far each sample of a track is from the truth's, both of shape (n, 2) [m]."""
    return np.linalg.norm(track - truth, axis=1)


def smoothness(track: np.ndarray, truth: np.ndarray) -> Smoothness:
    """Return the largest step and the worst error of a track [m]."""
    track, truth = _flat(track), _flat(truth)
    return Smoothness(float(steps_of(track).max()), float(errors_of(track, truth).max()))


def describe_tracks(tracks: Mapping[str, np.ndarray], truth: np.ndarray) -> str:
    """Return the same in words: for each track its largest step and its worst error."""
    width = max(map(len, tracks))
    rows = {name: smoothness(track, truth) for name, track in tracks.items()}
    return "\n".join(
        f"{name:<{width}}  largest step {style.fmt(row.largest_step_m)}, worst error {style.fmt(row.worst_error_m)}"
        for name, row in rows.items()
    )


def draw_tracks(tracks: Mapping[str, np.ndarray], truth: np.ndarray, times_s: Sequence[float]) -> Picture:
    """Draw tracks from above beside their steps and their errors through time.

    Args:
        tracks: by the name of the frame that tells them, at most three; each of shape (n, 2) or (n, 3) [m], all laid
            onto the same ground.
        truth: where the robot really was, of the same shape [m].
        times_s: when [s], shape (n,).

    Raises:
        ValueError: no track, more than three, or one of another length.
    """
    tracks = {name: _flat(track) for name, track in tracks.items()}
    truth, times = _flat(truth), np.asarray(times_s, dtype=float)
    if not 1 <= len(tracks) <= len(LINES):
        raise ValueError(f"between one and {len(LINES)} tracks can be told apart, not {len(tracks)}")
    for name, track in {**tracks, "truth": truth}.items():
        if len(track) != len(times):
            raise ValueError(f"{name} has {len(track)} samples, and there are {len(times)} times")
    picture = Picture(style.WIDE)
    with style.our_settings():
        _draw_ground(picture.figure.add_axes((0.03, 0.05, 0.46, 0.86)), tracks, truth)
        steps = _curves(picture.figure.add_axes((0.575, 0.60, 0.39, 0.29)), "step [m]")
        errors = _curves(picture.figure.add_axes((0.575, 0.14, 0.39, 0.29)), "error [m]")
        errors.set_xlabel("time [s]", loc="right")
        for (name, track), line, colour in zip(tracks.items(), LINES, COLOURS, strict=False):
            how = {"color": colour, "linestyle": line, "linewidth": TRACK_WIDTH, "label": name}
            steps.plot(times[1:], steps_of(track), **how)
            errors.plot(times, errors_of(track, truth), **how)
        for ax in (steps, errors):
            ax.set_xlim(times[0], times[-1])
            ax.set_ylim(bottom=0.0)
    picture.text = describe_tracks(tracks, truth)
    return picture


def _draw_ground(ax, tracks: Mapping[str, np.ndarray], truth: np.ndarray) -> None:
    """Draw the paths from above, the truth as a broad grey way below them."""
    ax.set_axis_off()
    ax.set_aspect("equal", adjustable="datalim")
    ax.plot(*truth.T, color=style.HAIR, linewidth=TRUTH_WIDTH, label="truth", zorder=1, solid_capstyle="round")
    for (name, track), line, colour in zip(tracks.items(), LINES, COLOURS, strict=False):
        ax.plot(*track.T, color=colour, linestyle=line, linewidth=TRACK_WIDTH, label=name, zorder=2)
        ax.plot(*track[-1], "o", color=colour, markersize=6.0, zorder=3)
    ax.margins(0.06)
    ax.legend(loc="lower left", bbox_to_anchor=(0.0, 1.0), ncols=4, frameon=False, fontsize=style.SMALL_PT,
              borderaxespad=0.0, handlelength=2.4)  # fmt: skip


def _curves(ax, title: str):
    """Make a small graph with its title above it."""
    for side in ("top", "right"):
        ax.spines[side].set_visible(False)
    ax.set_title(title, loc="left", fontsize=style.TEXT_PT, pad=6)
    return ax


def _flat(track: np.ndarray) -> np.ndarray:
    return np.asarray(track, dtype=float)[:, :2]
