"""Draw what RViz would show as a static figure: the scene from above and the list of statuses.

Both are made of what `rviz_status` decided. The list says what could be transformed into the Fixed
Frame; whether it lies where it should, only the picture shows: `walls`, what is known of the room,
is drawn beneath.
"""

from __future__ import annotations

import textwrap
from collections import Counter
from collections.abc import Iterator, Sequence

import numpy as np

from tflab.core import Transform

from . import style
from .labels import FloatingLabel, place_labels
from .map_error import Wall, point_errors
from .picture import Picture
from .rviz_status import SIGNS, MapCells, Path, RobotModel, Shown, points_of, statuses_as_text
from .scene.drawing import Part

COLOURS = {"Ok": "#00694E", "Warn": "#8A5A00", "Error": "#B34700"}
SEEN_COLOURS = (style.ACCENT, style.AXIS_COLOURS["z"])
AXIS_M = 0.35  # length of a frame's axes
NEAR_M, OF_ONE_BODY_M = 0.3, 0.9  # a name this near to another's frame is left out; the second, that of a robot's link
WIDTH_PX, LEFT_PX, RIGHT_PX = 490, 46, 14  # of the card, and of the margins beside the map: a phone shows it whole
TOP_PX, MAP_PX, AXIS_PX = 18, 270, 44  # above the map, its height, and below it with ticks and label
LINE_PX, EDGE_PX = 17, 14  # of the list: a row, and the margin below the last
LETTERS, SAME_SHOWN = 62, 2  # of a line of the list; how many lines of one kind are shown in full
MANY = 1500  # points that are drawn smaller
ROUND = np.linspace(0.0, 2.0 * np.pi, 24, endpoint=False)


def describe_shown(shown: Sequence[Shown], walls: Sequence[Wall] = ()) -> str:
    """Return RViz's list as text, then where each frame is, and how far what was seen lies from the walls."""
    lines = [statuses_as_text(shown), ""]
    for entry in shown:
        if entry.name == "TF":
            lines += [f"{frame} at {style.fmt_all(pose.translation)}" for frame, pose in sorted(entry.poses.items())]
        points = _seen(entry)
        if len(points) and walls:
            errors = point_errors(points, walls)
            lines.append(
                f"{entry.name}: {errors.count} points, off the walls by {style.fmt(errors.mean_m)} on average, "
                f"{style.fmt(errors.worst_m)} at worst"
            )
    return "\n".join(lines).rstrip()


def draw_shown(shown: Sequence[Shown], walls: Sequence[Wall] = (), fixed_frame: str = "") -> Picture:
    """Draw from above what RViz shows, and below it what its list reports.

    Args:
        shown: what `look_through` returned.
        walls: what is really there, in the Fixed Frame, each from (x, y) to (x, y) [m]; drawn beneath.
        fixed_frame: its name, for the labels of the axes.
    """
    rows = list(_list_of(shown))
    height_px = TOP_PX + MAP_PX + AXIS_PX + LINE_PX * len(rows) + EDGE_PX
    picture = Picture((WIDTH_PX / style.SCREEN_DPI, height_px / style.SCREEN_DPI))
    with style.our_settings():
        ax = picture.add_axes_px(LEFT_PX, height_px - TOP_PX - MAP_PX, WIDTH_PX - LEFT_PX - RIGHT_PX, MAP_PX)
        _draw_ground(ax, shown, walls)
        of_frame = f" in {fixed_frame}" if fixed_frame else ""
        ax.set_xlabel(f"x [m]{of_frame}", loc="right", labelpad=2)
        ax.set_ylabel(f"y [m]{of_frame}", loc="top", labelpad=2)
        for number, (text, level, is_head) in enumerate(rows):
            y = 1 - (TOP_PX + MAP_PX + AXIS_PX + LINE_PX * (number + 0.5)) / height_px
            picture.figure.text(
                (18 if is_head else 32) / WIDTH_PX, y, text, color=COLOURS[level] if is_head else style.INK,
                fontsize=style.TEXT_PT if is_head else style.SMALL_PT, fontweight="bold" if is_head else "normal",
                va="center",
            )  # fmt: skip
    picture.text = describe_shown(shown, walls)
    return picture


def _list_of(shown: Sequence[Shown]) -> Iterator[tuple[str, str, bool]]:
    """Yield the rows of the list: what stands there, how bad it is, and whether it is a display's own row."""
    for entry in shown:
        yield f"{SIGNS[entry.level]} {entry.title}: {entry.level}", entry.level, True
        kinds = Counter(status.level for status in entry.statuses)
        said: Counter[str] = Counter()
        for status in entry.statuses:
            said[status.level] += 1
            if status.level == "Ok" or said[status.level] > SAME_SHOWN:
                continue
            for line in textwrap.wrap(f"{status.name}: {status.text}", LETTERS, break_on_hyphens=False):
                yield line, status.level, False
        for level in ("Error", "Warn"):
            if kinds[level] > SAME_SHOWN:
                yield f"… {kinds[level] - SAME_SHOWN} more", level, False


# -- the picture ----------------------------------------------------------


def _draw_ground(ax, shown: Sequence[Shown], walls: Sequence[Wall]) -> None:
    ax.set_aspect("equal", adjustable="datalim")
    for wall in np.asarray(walls, dtype=float).reshape(-1, 2, 2):
        ax.plot(*wall.T, color=style.HAIR, linewidth=5.0, zorder=1, solid_capstyle="round")
    colours = iter(SEEN_COLOURS * len(shown))
    for entry in shown:
        for link, pose in entry.poses.items() if entry.display else ():
            if isinstance(entry.display.content, RobotModel):
                _draw_link(ax, entry.display.content.links[link], pose)
        if entry.placed:
            is_map = isinstance(entry.placed[0][0], MapCells)
            _draw_seen(ax, entry, style.GREY if is_map else next(colours))
    ax.margins(0.05)
    ax.autoscale_view()
    _draw_frames(ax, shown)


def _draw_seen(ax, entry: Shown, colour: str) -> None:
    clouds = [pose.apply(points_of(message)) for message, pose in entry.placed]
    size = 2.4 if sum(map(len, clouds)) < MANY else 1.2
    for (message, _), points in zip(entry.placed, clouds, strict=True):
        line = "solid" if isinstance(message, Path) else "none"
        ax.plot(
            *points[:, :2].T, marker="o", markersize=size, markeredgewidth=0.0, linestyle=line, color=colour, zorder=3
        )


def _draw_link(ax, parts: Sequence[Part], fixed_T_link: Transform) -> None:
    for part in parts:
        corners = fixed_T_link.apply(part.link_T_part.apply(_corners(part)))
        ax.fill(*_around(corners[:, :2]).T, facecolor=style.SHADE, edgecolor=style.GREY, linewidth=0.8, zorder=2)


def _corners(part: Part) -> np.ndarray:
    """Return points of a part's surface whose outline is the part's, shape (n, 3) [m]."""
    if part.shape == "box":
        return np.array([[x, y, z] for x in (-0.5, 0.5) for y in (-0.5, 0.5) for z in (-0.5, 0.5)]) * part.size
    ring = part.size[0] * np.column_stack([np.cos(ROUND), np.sin(ROUND), np.zeros(len(ROUND))])
    if part.shape == "sphere":
        return np.vstack([ring, ring[:, (0, 2, 1)], ring[:, (2, 0, 1)]])
    half = np.array([0.0, 0.0, part.size[1] / 2])
    return np.vstack([ring - half, ring + half])


def _around(points: np.ndarray) -> np.ndarray:
    """Return the corners of the tightest fence around points, shape (n, 2): their convex hull."""
    order = sorted(map(tuple, np.round(points, 9).tolist()))
    fence: list[tuple[float, float]] = []
    for way in (order, order[::-1]):
        start = len(fence)
        for x, y in way:
            while len(fence) >= start + 2 and _turn(fence[-2], fence[-1], (x, y)) <= 0.0:
                fence.pop()
            fence.append((x, y))
        fence.pop()
    return np.array(fence or order[:1])


def _turn(a: Sequence[float], b: Sequence[float], c: Sequence[float]) -> float:
    """Return whether the way a, b, c turns left (above 0), right (below 0) or not at all."""
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def _draw_frames(ax, shown: Sequence[Shown]) -> None:
    """Draw x and y of each frame that can be named beside the others: the tree's upper frames first.

    The links of a robot are drawn as its outline; of their frames the first is enough.
    """
    poses = next((entry.poses for entry in shown if entry.name == "TF"), {})
    links = {link for entry in shown if entry.display for link in entry.poses}
    sensors = {message.frame_id for entry in shown for message, _ in entry.placed}
    labels: list[FloatingLabel] = []
    axes: list[tuple] = []
    parts = links - sensors
    for frame, pose in sorted(poses.items(), key=lambda row: (row[0] in parts, row[0])):
        origin = np.array(pose.translation[:2])
        near_m = OF_ONE_BODY_M if frame in parts else NEAR_M
        if any(np.hypot(*(origin - label.anchor)) <= near_m for label in labels):
            continue
        for axis, tip in (("x", (AXIS_M, 0.0, 0.0)), ("y", (0.0, AXIS_M, 0.0))):
            ends = np.vstack([origin, pose.apply(tip)[:2]])
            colour, line = style.AXIS_COLOURS[axis], style.AXIS_LINES[axis]
            ax.plot(*ends.T, color=colour, linestyle=line, linewidth=1.8, zorder=5)
            axes.append(tuple(map(tuple, ends)))
        label = FloatingLabel(ax, frame)
        label.follow(tuple(origin))
        label.keep_off = axes
        labels.append(label)
    ax.apply_aspect()
    place_labels(labels)


def _seen(entry: Shown) -> np.ndarray:
    """Return what a display's scans and clouds show, in the Fixed Frame, shape (n, 3) [m]."""
    clouds = [
        pose.apply(points_of(message)) for message, pose in entry.placed if not isinstance(message, MapCells | Path)
    ]
    return np.vstack(clouds) if clouds else np.empty((0, 3))
