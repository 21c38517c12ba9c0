"""Draw frames, points, arrows and the ground on matplotlib axes.

        z
        :      y                 poses:  name -> where it is in the drawing's own frame
        :    /                   eye:    the projection
        :  /                     (.)     an arrow that comes out of the paper
        :/____________ x         (x)     an arrow that goes into it
     base_link

`draw_frames`, `draw_points` and `draw_arrow` return artists that can `move`, so a slider need not
draw anything again. A ghost is the wrong answer: the same shape in grey outline. `draw_scene`
makes a whole picture. RViz draws the same with its TF and Axes displays.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from tflab.core import Transform
from tflab.core.quaternions import Vector3

from . import style
from .labels import FloatingLabel, letter_outline, letter_size_pt, place_labels
from .picture import Picture
from .projection import FROM_ABOVE, SLANTING, Eye

if TYPE_CHECKING:
    from matplotlib.artist import Artist
    from matplotlib.axes import Axes

LETTERS_Z = 45  # above every shaft, below arrows, points and names
FLAT = 0.2  # an axis shorter than this part of its length is seen end-on
HEAD_LENGTH, HEAD_WIDTH = 0.16, 0.1  # parts of an axis's length
CROWD = 5  # frames in one spot: none of them has letters at its axes
ARROW_LENGTH = 1.6  # the longest arrow of a scene, in lengths of an axis
TICKS_PX = (54, 48)  # left of and below a scene from above: its ticks and the names of its axes


class AxisArtists:
    """One arrow of a frame: shaft, head, letter, and the sign for an arrow seen end-on."""

    def __init__(self, axis: str, ax: Axes, is_ghost: bool) -> None:
        from matplotlib.lines import Line2D
        from matplotlib.patches import Polygon
        from matplotlib.patheffects import withStroke

        colour = style.GREY if is_ghost else style.AXIS_COLOURS[axis]
        width = 1.1 if is_ghost else 2.2
        self.axis = axis
        self.shaft = Line2D([], [], color=colour, linewidth=width, linestyle=style.AXIS_LINES[axis])
        self.head = Polygon([(0, 0)] * 3, closed=True, facecolor=style.PAPER if is_ghost else colour,
                            edgecolor=colour, linewidth=1.0, joinstyle="miter")  # fmt: skip
        self.ring = Line2D([], [], color=colour, marker="o", markersize=9, markerfacecolor=style.PAPER,
                           markeredgewidth=1.4, linestyle="none")  # fmt: skip
        self.sign = Line2D([], [], color=colour, markersize=3.5, markeredgewidth=1.4, linestyle="none")
        self.letter = Line2D([], [], color=colour, marker=letter_outline(axis), markersize=letter_size_pt(axis),
                             markeredgewidth=0.0, linestyle="none", gid=axis,
                             path_effects=[withStroke(linewidth=2.0, foreground=style.PAPER)])  # fmt: skip
        self._along = np.zeros(2)  # where it points on paper, if it is seen from the side
        self.beside = np.array((-0.28, -0.28))  # of an axis seen end-on: from it to its letter, in lengths of the axis
        self.artists = [self.shaft, self.head, self.ring, self.sign, self.letter]
        for artist in self.artists:
            ax.add_artist(artist)

    def move(self, origin: np.ndarray, tip: np.ndarray, towards_eye: bool, length_m: float, nearness: float) -> None:
        """Draw from `origin` to `tip`, both on paper [m]; `towards_eye` tells dot from cross if it is end-on."""
        step = tip - origin
        seen = float(np.hypot(*step))
        is_flat = seen < FLAT * length_m
        for artist in (self.shaft, self.head):
            artist.set_visible(not is_flat)
        for artist in (self.ring, self.sign):
            artist.set_visible(is_flat)
        height = 10 + 4 * nearness / (1 + abs(nearness))  # between the ground and the names, however far
        for rank, artist in enumerate(self.artists):
            artist.set_zorder(height + (5 if is_flat else 0) + 0.001 * rank)
        self.letter.set_zorder(LETTERS_Z + 0.01 * height)
        self._along = np.zeros(2) if is_flat else step / seen
        if is_flat:
            self.ring.set_data([origin[0]], [origin[1]])
            self.sign.set_data([origin[0]], [origin[1]])
            self.sign.set_marker("o" if towards_eye else "x")
            self._write(origin + self.beside * length_m)
            return
        along = self._along
        across = np.array((-along[1], along[0]))
        neck = tip - HEAD_LENGTH * length_m * along
        wing = 0.5 * HEAD_WIDTH * length_m * across
        self.shaft.set_data(*zip(origin, neck, strict=True))
        self.head.set_xy((neck + wing, tip, neck - wing))
        self._write(tip + 0.15 * length_m * along)

    @property
    def letter_place(self) -> tuple[float, float]:
        """Where the letter stands on paper [m]."""
        return (self.letter.get_xdata()[0], self.letter.get_ydata()[0])

    def step_aside(self, taken: Sequence[tuple[float, float]], length_m: float) -> None:
        """Move the letter farther out along its arrow where another one stands already: two axes in one line."""
        place, along = np.array(self.letter_place), self._along
        while any(np.hypot(*(place - other)) < 0.1 * length_m for other in taken) and along.any():
            place = place + 0.2 * length_m * along
        self._write(place)

    def _write(self, place: np.ndarray) -> None:
        self.letter.set_data([place[0]], [place[1]])


class FrameArtists:
    """A frame on paper: its three arrows and its name."""

    def __init__(self, name: str, ax: Axes, eye: Eye, length_m: float, is_ghost: bool) -> None:
        self.name, self._eye, self._length_m = name, eye, length_m
        self.axes = {axis: AxisArtists(axis, ax, is_ghost) for axis in style.AXES}
        self.label = FloatingLabel(ax, name, colour=style.GREY if is_ghost else style.INK, is_italic=is_ghost)

    @property
    def artists(self) -> list[Artist]:
        """Everything that `move` moves."""
        return [*(artist for axis in self.axes.values() for artist in axis.artists), *self.label.artists]

    def move(self, pose: Transform) -> None:
        """Draw the frame at `pose`, which is in the drawing's own frame."""
        matrix = pose.matrix()
        origin = matrix[:3, 3]
        tips = origin + self._length_m * matrix[:3, :3].T  # one row each for x, y, z
        on_paper = self._eye.on_paper(np.vstack((origin, tips)))
        nearness = self._eye.nearness(tips)
        for axis, tip, near in zip(style.AXES, on_paper[1:], nearness, strict=True):
            comes_out = near > self._eye.nearness(origin)
            self.axes[axis].move(on_paper[0], tip, bool(comes_out), self._length_m, float(near))
        self.label.follow(on_paper[0])
        self.label.keep_off = [(tuple(on_paper[0]), axis.letter_place) for axis in self.axes.values()]


class PointArtists:
    """A point on paper: a round mark and its name."""

    def __init__(self, name: str, ax: Axes, eye: Eye, is_ghost: bool) -> None:
        self._eye = eye
        colour = style.GREY if is_ghost else style.ACCENT
        (self.mark,) = ax.plot([], [], linestyle="none", marker="o", markersize=8, color=colour,
                               markerfacecolor=style.PAPER if is_ghost else colour, markeredgewidth=1.4,
                               zorder=60)  # fmt: skip
        self.label = FloatingLabel(ax, name, colour=colour, is_italic=is_ghost)
        self.artists = [self.mark, *self.label.artists]

    def move(self, point: Sequence[float]) -> None:
        """Draw the mark at `point` (x, y, z) [m]."""
        x, y = self._eye.on_paper(point)
        self.mark.set_data([x], [y])
        self.label.follow((x, y))


class ArrowArtists:
    """An arrow on paper, with what it means written beside its middle."""

    def __init__(self, label: str, ax: Axes, eye: Eye, colour: str, line, curve: float) -> None:
        from matplotlib.patches import FancyArrowPatch

        self._eye, self._curve = eye, curve
        self.arrow = FancyArrowPatch((0, 0), (1, 1), arrowstyle="-|>,head_length=0.5,head_width=0.25",
                                     mutation_scale=14, color=colour, linewidth=1.6, linestyle=line, zorder=50,
                                     shrinkA=4, shrinkB=4, connectionstyle=f"arc3,rad={curve}")  # fmt: skip
        ax.add_patch(self.arrow)
        self.label = FloatingLabel(ax, label, colour=colour)
        self.artists = [self.arrow, *self.label.artists]

    def move(self, tail: Sequence[float], head: Sequence[float]) -> None:
        """Draw from `tail` to `head`, both (x, y, z) [m]."""
        a, b = self._eye.on_paper(np.array((tail, head), dtype=float))
        self.arrow.set_positions(a, b)
        ratios = np.linspace(0.0, 1.0, 9)[:, None]
        bend = (a + b) / 2 + self._curve * np.array((b[1] - a[1], a[0] - b[0]))  # matplotlib's arc3
        places = (1 - ratios) ** 2 * a + 2 * ratios * (1 - ratios) * bend + ratios**2 * b
        self.label.follow(places[len(places) // 2])
        self.label.keep_off = [(tuple(p), tuple(q)) for p, q in pairwise(places)]


def draw_frames(
    ax: Axes,
    poses: Mapping[str, Transform],
    eye: Eye = SLANTING,
    length_m: float = 0.3,
    is_ghost: bool = False,
) -> dict[str, FrameArtists]:
    """Draw frames on `ax` and return the artists of each; `poses` are in the drawing's own frame."""
    drawn, crowd = {}, _crowd(poses, eye, length_m)
    for name, pose in poses.items():
        drawn[name] = FrameArtists(name, ax, eye, length_m, is_ghost)
        drawn[name].move(pose)
    taken: list[tuple[float, float]] = []
    for name, frame in drawn.items():
        for axis in frame.axes.values():
            if name in crowd:
                axis.letter.set_visible(False)
            else:
                axis.step_aside(taken, length_m)
                taken.append(axis.letter_place)
    place_labels([frame.label for frame in drawn.values()])
    return drawn


def _crowd(poses: Mapping[str, Transform], eye: Eye, length_m: float) -> set[str]:
    """Return the frames that stand with many others in one spot of the paper: their letters would cover each other."""
    if len(poses) < CROWD:
        return set()
    places = eye.on_paper(np.array([pose.translation for pose in poses.values()]))
    far = np.linalg.norm(places[:, None] - places, axis=-1)
    near = (far < length_m).sum(axis=1)
    return {name for name, count in zip(poses, near, strict=True) if count >= CROWD}


def draw_points(
    ax: Axes, points: Mapping[str, Sequence[float]], eye: Eye = SLANTING, is_ghost: bool = False
) -> dict[str, PointArtists]:
    """Draw named points, each (x, y, z) [m], on `ax` and return the artists of each."""
    drawn = {}
    for name, point in points.items():
        drawn[name] = PointArtists(name, ax, eye, is_ghost)
        drawn[name].move(point)
    place_labels([point.label for point in drawn.values()])
    return drawn


def draw_arrow(
    ax: Axes,
    tail: Sequence[float],
    head: Sequence[float],
    label: str = "",
    eye: Eye = SLANTING,
    colour: str = style.ACCENT,
    line="solid",
    curve: float = 0.0,
) -> ArrowArtists:
    """Draw an arrow between two points (x, y, z) [m] on `ax` and return its artists."""
    drawn = ArrowArtists(label, ax, eye, colour, line, curve)
    drawn.move(tail, head)
    place_labels([drawn.label])
    return drawn


def draw_ground(ax: Axes, eye: Eye, x_m: tuple[float, float], y_m: tuple[float, float], step_m: float = 1.0):
    """Draw the ground z = 0 as a grid of `step_m` [m] between these limits, and return it."""
    from matplotlib.collections import LineCollection

    (x0, x1), (y0, y1) = x_m, y_m
    along = [((x0, y, 0.0), (x1, y, 0.0)) for y in _multiples(y0, y1, step_m)]
    across = [((x, y0, 0.0), (x, y1, 0.0)) for x in _multiples(x0, x1, step_m)]
    grid = LineCollection(eye.on_paper(np.array(along + across)), colors=style.HAIR, linewidths=0.9, zorder=-50)
    ax.add_collection(grid, autolim=False)
    return grid


def clear_paper(ax: Axes) -> Axes:
    """Make `ax` plain paper: no spines, no ticks, one metre as long upwards as sideways."""
    ax.set_axis_off()
    ax.set_aspect("equal", adjustable="box")
    return ax


def write_caption(ax: Axes, text: str) -> None:
    """Write in small grey what `ax` shows, in its upper left corner."""
    paper = {"facecolor": style.PAPER, "edgecolor": "none", "pad": 2.0}
    ax.text(0.0, 1.0, text, transform=ax.transAxes, va="top", color=style.GREY, fontsize=style.SMALL_PT, bbox=paper)


def show_all(ax: Axes, on_paper: np.ndarray, margin_m: float) -> None:
    """Choose the limits of `ax` so that points on paper, shape (n, 2) [m], fill its box with a margin."""
    low, high = on_paper.min(axis=0) - margin_m, on_paper.max(axis=0) + margin_m
    box = ax.get_window_extent()
    middle, span = (low + high) / 2, high - low
    metres_per_pixel = max(span[0] / box.width, span[1] / box.height)
    half = np.array((box.width, box.height)) * metres_per_pixel / 2
    ax.set_xlim(middle[0] - half[0], middle[0] + half[0])
    ax.set_ylim(middle[1] - half[1], middle[1] + half[1])


def show_frames(ax: Axes, eye: Eye, places: np.ndarray, length_m: float, margin_m: float) -> None:
    """Choose the limits of `ax` so that frames at `places`, shape (n, 3) [m], fit, however they are rotated."""
    reach = length_m * np.array([(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (0, 1)])
    show_all(ax, eye.on_paper((places[:, None] + reach).reshape(-1, 3)), margin_m)


def draw_scene(
    poses: Mapping[str, Transform],
    points: Mapping[str, Sequence[float]] | None = None,
    ghosts: Mapping[str, Transform] | None = None,
    ghost_points: Mapping[str, Sequence[float]] | None = None,
    eye: Eye = SLANTING,
    fixed_frame: str = "map",
    length_m: float | None = None,
    arrows: Mapping[str, tuple[str, Sequence[float]]] | None = None,
    size_inch: tuple[float, float] = style.WIDE,
    caption: str = "",
) -> Picture:
    """Draw frames, points and their ghosts (the wrong answers) as one picture; from above, with ticks in metres.

    Args:
        poses, ghosts: `fixed_frame`_T_name of each.
        points, ghost_points: (x, y, z) [m] in `fixed_frame`.
        length_m: how long to draw an axis [m]; a fifth of the scene if None.
        arrows: vectors, a velocity or a pull, by their name: of which frame of `poses`, and (x, y, z) in that
            frame's own axes.  They start at the frame; the longest is drawn a little longer than an axis.
        size_inch: width and height [inch], a hundred screen pixels each.
        caption: a line in the corner, such as the view and the width of the grid.

    Raises:
        ValueError: an arrow belongs to a frame that has no pose.
    """
    points, ghosts, ghost_points, arrows = points or {}, ghosts or {}, ghost_points or {}, arrows or {}
    for name, (frame, _) in arrows.items():
        if frame not in poses:
            raise ValueError(f'arrow "{name}" is of "{frame}", which has no pose; there is {", ".join(poses)}')
    places = [pose.translation for pose in (*poses.values(), *ghosts.values())]
    places = np.array([*places, *points.values(), *ghost_points.values(), (0.0, 0.0, 0.0)], dtype=float)
    span_m = float(np.ptp(places, axis=0).max()) or 1.0
    length_m = length_m or 0.2 * span_m
    step_m = _round_step(span_m / 5)
    picture = Picture(size_inch)
    with style.our_settings():
        ax = clear_paper(picture.figure.add_axes((0.02, 0.03, 0.96, 0.94)))
        if eye is FROM_ABOVE:
            _make_room_for_ticks(ax, picture, fixed_frame, step_m)
        show_frames(ax, eye, places, length_m, margin_m=0.3 * length_m)
        low, high = places.min(axis=0) - length_m, places.max(axis=0) + length_m
        draw_ground(ax, eye, (low[0], high[0]), (low[1], high[1]), step_m)
        ax.set(xticks=_multiples(*ax.get_xlim(), step_m), yticks=_multiples(*ax.get_ylim(), step_m))
        drawn = [
            *draw_frames(ax, ghosts, eye, length_m, is_ghost=True).values(),
            *draw_points(ax, ghost_points, eye, is_ghost=True).values(),
            *draw_frames(ax, poses, eye, length_m).values(),
            *draw_points(ax, points, eye).values(),
            *(draw_arrow(ax, *ends, name, eye) for name, ends in _on_stage(poses, arrows, length_m).items()),
        ]
        place_labels([artists.label for artists in drawn])
        write_caption(ax, caption)
    picture.text = describe_scene(poses, points, ghosts, ghost_points, fixed_frame, arrows)
    return picture


def describe_scene(
    poses: Mapping[str, Transform],
    points: Mapping[str, Vector3],
    ghosts: Mapping[str, Transform],
    ghost_points: Mapping[str, Vector3],
    fixed_frame: str,
    arrows: Mapping[str, tuple[str, Sequence[float]]],
) -> str:
    """Return the figure's text, one line each."""
    lines = [f"As seen from {fixed_frame}:"]
    for title, frames in (("frame", poses), ("ghost", ghosts)):
        for name, pose in frames.items():
            roll, pitch, yaw = (style.fmt(angle, "") for angle in pose.rpy())
            lines.append(
                f"  {title} {name} at {style.fmt_all(pose.translation)}, roll {roll}, pitch {pitch}, yaw {yaw} rad"
            )
    for title, places in (("point", points), ("ghost point", ghost_points)):
        lines += [f"  {title} {name} at {style.fmt_all(place)}" for name, place in places.items()]
    for name, (frame, vector) in arrows.items():
        ways = (f"{way} {style.fmt(part, '')}" for way, part in zip(("forward", "left", "up"), vector, strict=True))
        lines.append(f"  arrow {name} in {frame}: {', '.join(ways)}")
    return "\n".join(lines)


def _make_room_for_ticks(ax: Axes, picture: Picture, fixed_frame: str, step_m: float) -> None:
    """Let the axes of a scene from above be seen, and name them."""
    (left, below), (width, height) = TICKS_PX, picture.size_px
    left += 20 if step_m < 0.1 else 0  # for a second decimal
    ax.set_axis_on()
    ax.set_position((left / width, below / height, 1 - (left + 14) / width, 1 - (below + 14) / height))
    style.name_plane(ax, fixed_frame)


def _on_stage(
    poses: Mapping[str, Transform], arrows: Mapping[str, tuple[str, Sequence[float]]], length_m: float
) -> dict[str, tuple[Vector3, Vector3]]:
    """Return from where to where each arrow goes [m], all at one scale; one of no length is left out."""
    longest = max((float(np.linalg.norm(vector)) for _, vector in arrows.values()), default=0.0)
    return {
        name: (poses[frame].translation, poses[frame].apply(np.array(vector) * ARROW_LENGTH * length_m / longest))
        for name, (frame, vector) in arrows.items()
        if np.linalg.norm(vector) > 1e-3 * longest
    }


def _multiples(low: float, high: float, step: float) -> list[float]:
    """Return the multiples of `step` between `low` and `high`."""
    first, last = int(np.ceil(low / step - 1e-9)), int(np.floor(high / step + 1e-9))
    return [step * i for i in range(first, last + 1)]


def _round_step(wish: float) -> float:
    """Return 1, 2 or 5 times a power of ten, near `wish`."""
    power = 10.0 ** np.floor(np.log10(wish))
    return float(min((1.0, 2.0, 5.0, 10.0), key=lambda step: abs(np.log(step * power / wish))) * power)
