"""Draw how far points and tracks in a map are from what is really there.

    at the stamp               with the newest pose
    +------------------+       +------------------+
    |        wall      |       |  : : wall . :    |      dots: where the points were put
    |   o              |       |   o  . .. .      |      lines and rings: what is really there
    +------------------+       +------------------+
    off by 0.004 m on average  off by 0.210 m on average

`draw_detections` shows one such group of points beside the robot's path, and enlarged.
`draw_tracks` compares one drive in several frames (REP-105): odom drifts and never jumps, map
jumps and never drifts. Its lower curve is the absolute trajectory error.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np

from . import style
from .frames import show_all
from .picture import Picture

Point2 = tuple[float, float]
Wall = tuple[Point2, Point2]

CAPTION_PX, LINE_PX, TITLE_PX, GAP_PX, EDGE_PX, TICKS_PX = 62, 14, 34, 18, 16, 58
LOWEST_PX, HIGHEST_PX = 130, 360
MARGIN_M = 0.3
RING_PT = 11.0
NARROW_PX, ENLARGED_PX = 540, 240  # of `draw_detections`: the width, and the height of the enlarged part
ENLARGED_PART = 1.3  # half the height of the enlarged part, in largest errors


class PointErrors(NamedTuple):
    """How far a group of points lies from what is really there [m]."""

    count: int
    mean_m: float
    worst_m: float


def distances_to(points: np.ndarray, walls: Sequence[Wall] = (), things: Sequence[Sequence[float]] = ()) -> np.ndarray:
    """Return how far each point is from the nearest wall or thing [m].

    Args:
        points: shape (n, 2) or (n, 3); only x and y count [m].
        walls: each from a point (x, y) to another [m].
        things: (x, y) or (x, y, z) of each [m].

    Raises:
        ValueError: there is neither a wall nor a thing.
    """
    if not len(walls) and not len(things):
        raise ValueError("nothing is really there: give walls, things or both, and points are measured from them")
    points = _flat(points)
    each = [np.linalg.norm(points - thing, axis=1) for thing in _flat(things)] if len(things) else []
    for begin, end in np.asarray(walls, dtype=float).reshape(-1, 2, 2):
        along = end - begin
        share = np.clip((points - begin) @ along / max(along @ along, 1e-12), 0.0, 1.0)
        each.append(np.linalg.norm(points - (begin + share[:, None] * along), axis=1))
    return np.min(each, axis=0)


def point_errors(points: np.ndarray, walls: Sequence[Wall] = (), things: Sequence[Sequence[float]] = ()) -> PointErrors:
    """Return how far points lie from the nearest wall or thing, on average and at worst; NaN rows are left out."""
    points = _seen(points)
    if not len(points):
        return PointErrors(0, 0.0, 0.0)
    distances = distances_to(points, walls, things)
    return PointErrors(len(points), float(distances.mean()), float(distances.max()))


def describe_placed(
    placed: Mapping[str, np.ndarray], walls: Sequence[Wall] = (), things: Sequence[Sequence[float]] = ()
) -> str:
    """Return the figure's text: for each way, how many points, and how far off they are."""
    width = max(map(len, placed))
    lines = []
    for name, points in placed.items():
        error = point_errors(points, walls, things)
        lines.append(
            f"{name:<{width}}  {error.count:>5} points, off by {style.fmt(error.mean_m)} on average, "
            f"{style.fmt(error.worst_m)} at worst"
        )
    return "\n".join(lines)


def draw_placed(
    placed: Mapping[str, np.ndarray],
    walls: Sequence[Wall] = (),
    things: Sequence[Sequence[float]] = (),
    shown_m: tuple[float, float, float, float] | None = None,
) -> Picture:
    """Draw points as each way puts them, in panels side by side, from above.

    Args:
        placed: by the name of the way, shape (n, 2) or (n, 3) [m] in the fixed frame.
        walls, things: what is really there.
        shown_m: x from, y from, x to, y to [m]; all there is if None.
    """
    x_low, y_low, x_high, y_high = shown_m or _everything(placed, walls, things)
    width_px = round(style.WIDE[0] * style.SCREEN_DPI)
    panel_px = (width_px - TICKS_PX - EDGE_PX - GAP_PX * (len(placed) - 1)) / len(placed)
    tall_px = round(np.clip(panel_px * (y_high - y_low) / (x_high - x_low), LOWEST_PX, HIGHEST_PX))
    height_px = TITLE_PX + tall_px + CAPTION_PX
    picture = Picture(style.wide(height_px))
    with style.our_settings():
        for i, (name, points) in enumerate(placed.items()):
            left = TICKS_PX + i * (panel_px + GAP_PX)
            ax = picture.add_axes_px(left, CAPTION_PX, panel_px, tall_px)
            _draw_panel(ax, _seen(points), walls, things)
            show_all(ax, np.array([(x_low, y_low), (x_high, y_high)]), margin_m=0.0)
            ax.set_title(name, loc="left", pad=7)
            _draw_ticks(ax, with_y=i == 0, below_pt=31.0)
            err = point_errors(points, walls, things)
            ax.set_xlabel(f"off by {style.fmt(err.mean_m)} on average\n{style.fmt(err.worst_m)} at worst", loc="left")
    picture.text = describe_placed(placed, walls, things)
    return picture


def _draw_panel(ax, points: np.ndarray, walls: Sequence[Wall], things: Sequence[Sequence[float]]) -> None:
    for spine in ax.spines.values():
        spine.set_color(style.HAIR)
    for wall in np.asarray(walls, dtype=float).reshape(-1, 2, 2):
        ax.plot(*wall.T, color=style.FAINT, linewidth=2.0, zorder=1, solid_capstyle="round")
    size = 5.0 if len(points) < 200 else 1.4
    ax.plot(*points.T, "o", color=style.ACCENT, markersize=size, markeredgewidth=0.0, alpha=0.75, zorder=2)
    for thing in things:
        ax.plot(*thing[:2], "o", color=style.INK, markersize=RING_PT, markerfacecolor="none", markeredgewidth=1.6)


def _draw_ticks(ax, with_y: bool, below_pt: float) -> None:
    """Give axes ticks in metres, and labels with the frame `map`; the label of x stands `below_pt` below the axes."""
    from matplotlib.ticker import MaxNLocator

    for axis in (ax.xaxis, ax.yaxis):
        axis.set_major_locator(MaxNLocator(6, steps=(1, 2, 5, 10)))
    ax.tick_params(length=3.0, labelleft=with_y)
    ax.annotate("x in map [m]", (1.0, 0.0), (0.0, -below_pt), xycoords="axes fraction", textcoords="offset points",
                ha="right", va="top", color=style.GREY, fontsize=style.SMALL_PT)  # fmt: skip
    if with_y:
        ax.set_ylabel("y in map [m]")


def draw_detections(
    points: Sequence[Sequence[float]], ball: Sequence[float], path: Sequence[Sequence[float]], how: str
) -> Picture:
    """Draw a robot's path and a ball from above, and enlarged below them, where detections put the ball.

    Args:
        points: where each detection put it, shape (n, 2) or (n, 3) [m] in `map`.
        ball: its true position [m].
        path: where the robot drove, shape (n, 2) or (n, 3) [m].
        how: how the detections were transformed, as their label.
    """
    from matplotlib.patches import ConnectionPatch, Rectangle

    points, path, (ball,) = _flat(points), _flat(path), _flat([ball])
    error = point_errors(points, things=[ball])
    across_px, below_px = NARROW_PX - TICKS_PX - EDGE_PX, CAPTION_PX - LINE_PX
    half_m = ENLARGED_PART * error.worst_m * np.array((across_px / ENLARGED_PX, 1.0))
    enlarged = np.array((ball - half_m, ball + half_m))
    everything = np.vstack((path, enlarged))
    low, high = everything.min(axis=0) - MARGIN_M / 2, everything.max(axis=0) + MARGIN_M / 2
    up_px = max(LOWEST_PX, across_px * (high[1] - low[1]) / (high[0] - low[0]))
    height_px = EDGE_PX + up_px + 2 * below_px + ENLARGED_PX
    picture = Picture((NARROW_PX / style.SCREEN_DPI, height_px / style.SCREEN_DPI))
    with style.our_settings():
        near = picture.add_axes_px(TICKS_PX, below_px, across_px, ENLARGED_PX)
        far = picture.add_axes_px(TICKS_PX, 2 * below_px + ENLARGED_PX, across_px, up_px)
        for ax, shown in ((far, np.array((low, high))), (near, enlarged)):
            _draw_panel(ax, points, (), [ball])
            show_all(ax, shown, margin_m=0.0)
            _draw_ticks(ax, with_y=True, below_pt=19.0)
        far.add_patch(Rectangle(enlarged[0], *np.ptp(enlarged, axis=0), fill=False, edgecolor=style.GREY))
        for x in enlarged[:, 0]:
            far.add_artist(ConnectionPatch((x, enlarged[0, 1]), (x, enlarged[1, 1]), "data", "data", axesA=far,
                                           axesB=near, color=style.FAINT, linewidth=0.8))  # fmt: skip
        far.plot(*path.T, color=style.INK, linewidth=TRACK_WIDTH)
        far.annotate("", path[-1], path[-2], arrowprops={"arrowstyle": "-|>", "color": style.INK, "mutation_scale": 16})
        for ax, text, at, colour in (
            (far, "the robot's path", (path[0, 0], path[:, 1].max() + 0.15), style.INK),
            (near, "ball (true position)", (ball[0] + 0.05, ball[1]), style.INK),
            (near, f"detections,\n{how}", (points[:, 0].max() + 0.03, points[:, 1].max()), style.ACCENT),
        ):
            ax.text(*at, text, va="center", color=colour)
        near.set_xlabel(f"off by {style.fmt(error.mean_m)} on average, {style.fmt(error.worst_m)} at worst", loc="left")
    picture.text = "\n".join((
        f"the robot's path: from {style.fmt_all(path[0], digits=2)} to {style.fmt_all(path[-1], digits=2)} in map",
        f"ball (true position): {style.fmt_all(ball, digits=2)}",
        describe_placed({f"detections, {how}": points}, things=[ball]),
    ))  # fmt: skip
    return picture


def _everything(
    placed: Mapping[str, np.ndarray], walls: Sequence[Wall], things: Sequence[Sequence[float]]
) -> tuple[float, float, float, float]:
    """Return the corners of a box around everything, with a margin [m]."""
    groups = [*(_seen(points) for points in placed.values()), np.asarray(walls, dtype=float).reshape(-1, 2)]
    if len(things):
        groups.append(_flat(things))
    both = np.vstack(groups)
    (x_low, y_low), (x_high, y_high) = both.min(axis=0) - MARGIN_M, both.max(axis=0) + MARGIN_M
    return x_low, y_low, x_high, y_high


def _seen(points: np.ndarray) -> np.ndarray:
    """Return the points that are any, x and y only: a ray that hit nothing has NaN."""
    points = np.asarray(points, dtype=float).reshape(len(points), -1)[:, :2]
    return points[np.isfinite(points).all(axis=1)]


LINES = ("solid", (0, (4.0, 1.6)), (0, (1.0, 1.1)))
COLOURS = (style.ACCENT, style.INK, style.AXIS_COLOURS["z"])
TRUTH_WIDTH, TRACK_WIDTH = 5.0, 1.6
TRACKS_INCH = (5.4, 6.2)  # narrow, so that its letters can be read on a phone


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
    """Return the figure's text: for each track its largest step and its worst error."""
    width = max(map(len, tracks))
    rows = {name: smoothness(track, truth) for name, track in tracks.items()}
    return "\n".join(
        f"{name:<{width}}  largest step {style.fmt(row.largest_step_m)}, worst error {style.fmt(row.worst_error_m)}"
        for name, row in rows.items()
    )


def draw_tracks(
    tracks: Mapping[str, np.ndarray], truth: np.ndarray, times_s: Sequence[float], fixed_frame: str = "map"
) -> Picture:
    """Draw tracks from above, and below them the distance between samples and the error through time.

    Args:
        tracks: by the name of the frame that tells them, at most three; each of shape (n, 2) or (n, 3) [m], all laid
            onto the same ground.
        truth: where the robot really was, of the same shape [m].
        times_s: when [s], shape (n,).
        fixed_frame: the frame of all coordinates.

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
    picture = Picture(TRACKS_INCH)
    with style.our_settings():
        ground = picture.figure.add_axes((0.11, 0.46, 0.86, 0.47))
        style.name_plane(ground, fixed_frame)
        _draw_ground(ground, tracks, truth)
        steps = _curves(picture.figure.add_axes((0.11, 0.262, 0.86, 0.09)), "distance between two samples [m]")
        error = _curves(picture.figure.add_axes((0.11, 0.075, 0.86, 0.1)), "error: distance from the truth [m]")
        error.set_xlabel("time [s]", loc="right")
        for (name, track), line, colour in zip(tracks.items(), LINES, COLOURS, strict=False):
            how = {"color": colour, "linestyle": line, "linewidth": TRACK_WIDTH, "label": name}
            steps.plot(times[1:], steps_of(track), **how)
            error.plot(times, errors_of(track, truth), **how)
        for ax in (steps, error):
            ax.set_xlim(times[0], times[-1])
            ax.set_ylim(bottom=0.0)
    picture.text = describe_tracks(tracks, truth)
    return picture


def _draw_ground(ax, tracks: Mapping[str, np.ndarray], truth: np.ndarray) -> None:
    """Draw the paths from above, the truth as a broad grey line below them."""
    ax.set_aspect("equal", adjustable="datalim")
    ax.plot(*truth.T, color=style.HAIR, linewidth=TRUTH_WIDTH, label="truth", zorder=1, solid_capstyle="round")
    for (name, track), line, colour in zip(tracks.items(), LINES, COLOURS, strict=False):
        ax.plot(*track.T, color=colour, linestyle=line, linewidth=TRACK_WIDTH, label=name, zorder=2)
        ax.plot(*track[-1], "o", color=colour, markersize=6.0, zorder=3)
    ax.margins(0.06)
    ax.legend(loc="lower left", bbox_to_anchor=(0.0, 1.01), ncols=4, frameon=False, fontsize=style.SMALL_PT,
              borderaxespad=0.0, handlelength=2.4)  # fmt: skip


def _curves(ax, title: str):
    """Make a small graph with its title above it."""
    style.hide_spines(ax, "top", "right")
    ax.set_title(title, loc="left", fontsize=style.TEXT_PT, pad=6)
    return ax


def _flat(track: np.ndarray) -> np.ndarray:
    return np.asarray(track, dtype=float)[:, :2]
