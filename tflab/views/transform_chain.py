"""Draw a product of transforms as a chain in which neighbouring frame names must match, and an arm the same way.

    [ map | odom ][ odom | base_link ][ base_link | laser_frame ]
         =  [ map | laser_frame ]

A domino is `target_T_source`. Two neighbours fit if the names that meet are the same; what is left
is the two ends. Each joint of an arm is one domino, `parent_T_child`: a fixed origin and, if the
joint moves, a movement. The product of an arm's dominoes is its forward kinematics.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import pairwise
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from tflab.core import Transform

from . import style
from .frames import clear_paper, show_all
from .labels import FloatingLabel, place_labels
from .picture import Picture
from .projection import FROM_ABOVE, Eye, eye_at

if TYPE_CHECKING:
    from matplotlib.axes import Axes


Tile = tuple[str, str]  # target, source

HEIGHT, PAD, LETTER, GAP = 34.0, 12.0, 6.3, 30.0  # of a tile, beside a name, of a letter, where two do not fit [pt]
WIDTH_PT = 72.0 * style.WIDE[0]
TALL, TOP, BELOW = 1.75, 88.0, 34.0  # of the card [inch]; of the row and of what it comes to [pt]


def mismatches(tiles: Sequence[Tile]) -> list[int]:
    """Return after which tiles, from 0, the next one does not fit."""
    return [i for i, (left, right) in enumerate(pairwise(tiles)) if left[1] != right[0]]


def describe_dominoes(tiles: Sequence[Tile]) -> str:
    """Return the figure's text: the row, the product, and what is left or what does not fit."""
    row = "".join(f"[{target}|{source}]" for target, source in tiles)
    product = " @ ".join(f"{target}_T_{source}" for target, source in tiles)
    apart = [f"{tiles[i][1]} is not {tiles[i + 1][0]}" for i in mismatches(tiles)]
    if apart:
        return f"{row}\n{product}\ndoes not fit: {', '.join(apart)}"
    target, source = tiles[0][0], tiles[-1][1]
    return f"{row}\n{product}\nfits: {target}_T_{source}"


def draw_dominoes(*tiles: Tile) -> Picture:
    """Draw transforms, each (target, source), as a row of dominoes, and below it what they come to.

    Raises:
        ValueError: there is no tile.
    """
    if not tiles:
        raise ValueError('a row of dominoes needs at least one, such as draw_dominoes(("map", "odom"))')
    apart = mismatches(tiles)
    widths = [_half(target) + _half(source) for target, source in tiles]
    total = sum(widths) + GAP * len(apart)
    scale = min(1.0, (WIDTH_PT - 40.0) / total)
    picture = Picture((style.WIDE[0], TALL))
    with style.our_settings():
        ax = clear_paper(picture.figure.add_axes((0.0, 0.0, 1.0, 1.0)))
        ax.set_xlim(0.0, WIDTH_PT)
        ax.set_ylim(0.0, 72.0 * TALL)
        x = 0.5 * (WIDTH_PT - scale * total)
        for i, tile in enumerate(tiles):
            _draw_tile(ax, x, TOP, tile, scale)
            x += scale * widths[i]
            if i in apart:
                _write(ax, x + 0.5 * scale * GAP, TOP, "≠", style.ACCENT, 16.0)
                x += scale * GAP
            elif i + 1 < len(tiles):
                ax.plot([x], [TOP], "o", color=style.ACCENT, markersize=5, zorder=20)
        if apart:
            said = ", ".join(f"{tiles[i][1]} is not {tiles[i + 1][0]}" for i in apart)
            _write(ax, 0.5 * WIDTH_PT, BELOW, said, style.ACCENT, style.TITLE_PT)
        else:
            end = (tiles[0][0], tiles[-1][1])
            width = _half(end[0]) + _half(end[1])
            _write(ax, 0.5 * (WIDTH_PT - width) - 14.0, BELOW, "=", style.INK, 13.0)
            _draw_tile(ax, 0.5 * (WIDTH_PT - width), BELOW, end, 1.0)
    picture.text = describe_dominoes(tiles)
    return picture


def _half(name: str) -> float:
    """Return how wide the half of a tile with this name is [pt]."""
    return 2.0 * PAD + LETTER * len(name)


def _draw_tile(ax, x: float, y: float, tile: Tile, scale: float) -> None:
    from matplotlib.patches import FancyBboxPatch

    left, right = (scale * _half(name) for name in tile)
    ax.add_patch(
        FancyBboxPatch((x + 1.5, y - HEIGHT / 2), left + right - 3.0, HEIGHT, boxstyle="round,pad=0,rounding_size=6",
                       facecolor=style.SHADE, edgecolor=style.INK, linewidth=1.3, zorder=5)
    )  # fmt: skip
    ax.plot([x + left] * 2, [y - HEIGHT / 2 + 5, y + HEIGHT / 2 - 5], color=style.INK, linewidth=1.0, zorder=6)
    for name, middle in zip(tile, (x + left / 2, x + left + right / 2), strict=True):
        _write(ax, middle, y, name, style.INK, scale * (style.TITLE_PT - 0.5))


def _write(ax, x: float, y: float, text: str, colour: str, size: float) -> None:
    ax.text(x, y, text, ha="center", va="center", color=colour, fontsize=size, zorder=10)


FROM_THE_SIDE = eye_at(-np.pi / 2.0, 0.0)  # x to the right, z up
SIZE = (7.6, 5.4)
ARM_PX, ROW_PX, EDGE_PX = 280, 112, 16
TILE_PX, HIGH_PX, GAP_PX = 150, 26, 8  # a domino at its widest, its height, and between two
LETTER_PX = 5.6  # of a name on a domino, at most
HINGE_PX = 5  # of a hinge, inside its domino
REACH = 1.04  # of what the arm can reach, so much is in sight


class Step(NamedTuple):
    """One joint, as it stands: where its child is in its parent.

    Attributes:
        position: of a joint that moves [unit]; None for one that is fixed.
        unit: "rad" or "m".
        written: what the robot's file says of it, line by line.
    """

    joint: str
    parent: str
    child: str
    parent_T_child: Transform
    position: float | None = None
    unit: str = "rad"
    written: str = ""


def poses_along(steps: Sequence[Step]) -> dict[str, Transform]:
    """Return where each link is, in the first one: the product of the dominoes up to it."""
    poses = {steps[0].parent: Transform()}
    for step in steps:
        poses[step.child] = poses[step.parent] @ step.parent_T_child
    return poses


def describe_joints(
    steps: Sequence[Step], touched: str = "", ghosts: Mapping[str, Sequence[float]] | None = None
) -> str:
    """Return the figure's text: where the tip is, a line for each joint, and what is written of the touched one."""
    tip, base = steps[-1].child, steps[0].parent
    lines = [f"{tip} in {base}: {style.fmt_all(poses_along(steps)[tip].translation)}"]
    lines += [f"{name} (ghost) at {style.fmt_all(place)}" for name, place in (ghosts or {}).items()]
    width = max(len(step.joint) for step in steps)
    lines += [
        f"  {step.joint:<{width}}  {_position(step):>10}  {step.parent}_T_{step.child}: "
        f"{style.fmt_all(step.parent_T_child.translation)}, rpy {style.fmt_all(step.parent_T_child.rpy(), 'rad')}"
        for step in steps
    ]
    lines += [step.written for step in steps if step.joint == touched and step.written]
    return "\n".join(lines)


class JointsPicture(Picture):
    """The arm from above and from the side, its dominoes, and a piece of its file; `show` moves them."""

    def __init__(self, steps: Sequence[Step]) -> None:
        super().__init__(SIZE)
        width_px, height_px = self.size_px
        half_px = (width_px - 3 * EDGE_PX) / 2
        pivot, reach_m = _reach(steps)
        self._views = []
        with style.our_settings():
            for i, (title, eye) in enumerate({"from above": FROM_ABOVE, "from the side": FROM_THE_SIDE}.items()):
                left_px = EDGE_PX + i * (half_px + EDGE_PX)
                box = (left_px / width_px, 1 - ARM_PX / height_px, half_px / width_px, (ARM_PX - 26) / height_px)
                ax = clear_paper(self.figure.add_axes(box))
                show_all(ax, eye.on_paper(pivot)[None], margin_m=REACH * reach_m)
                self.figure.text(left_px / width_px, 1 - 10 / height_px, title, va="top", fontsize=style.TEXT_PT)
                self._views.append(_ArmArtists(ax, eye, steps))
            self._tiles = _tiles(self, steps)
            top = 1 - (ARM_PX + ROW_PX + 10) / height_px
            self._tip = self.figure.text(
                1 - EDGE_PX / width_px, top, "", va="top", ha="right", color=style.ACCENT,
                fontsize=style.TEXT_PT,
            )  # fmt: skip
            self._written = self.figure.text(
                EDGE_PX / width_px, top, "", va="top", family="monospace", fontsize=style.SMALL_PT, linespacing=1.35,
                color=style.INK,
            )  # fmt: skip
        self.moving = [artist for view in self._views for artist in view.artists]
        self.moving += [artist for tile in self._tiles for artist in tile.artists]
        self.moving += [self._tip, self._written]

    def show(
        self, steps: Sequence[Step], touched: str = "", ghosts: Mapping[str, Sequence[float]] | None = None
    ) -> None:
        """Show the joints as they stand.

        Args:
            touched: the joint whose lines of the file are shown.
            ghosts: wrong places of the tip (x, y, z) [m], by their name; they stay where the picture first put them.
        """
        poses = poses_along(steps)
        tip, base = steps[-1].child, steps[0].parent
        self._tip.set_text(f"{tip} in {base}: {style.fmt_all(poses[tip].translation)}")
        for view in self._views:
            view.move(poses, ghosts or {})
        for tile, step in zip(self._tiles, steps, strict=True):
            tile.move(step, step.joint == touched)
        self._written.set_text("\n".join(step.written for step in steps if step.joint == touched))
        self.text = describe_joints(steps, touched, ghosts)


class _ArmArtists:
    """The arm as one sees it from one side: a line from link to link, rings where it bends, a dot at its tip."""

    def __init__(self, ax: Axes, eye: Eye, steps: Sequence[Step]) -> None:
        self._ax, self._eye = ax, eye
        self._moving = [step.child for step in steps if step.position is not None]
        self._tip = steps[-1].child
        (self.line,) = ax.plot([], [], color=style.INK, linewidth=3.0, solid_capstyle="round", zorder=10)
        (self.hinges,) = ax.plot([], [], "o", color=style.INK, markersize=9.0, markerfacecolor=style.PAPER,
                                 markeredgewidth=1.8, zorder=12)  # fmt: skip
        (self.base,) = ax.plot([], [], "s", color=style.INK, markersize=10.0, zorder=11)
        (self.tip,) = ax.plot([], [], "o", color=style.ACCENT, markersize=8.0, zorder=14)
        named = [steps[0].parent, *self._moving, self._tip]
        self.labels = {name: FloatingLabel(ax, name) for name in dict.fromkeys(named)}
        self.labels[self._tip].text.set_color(style.ACCENT)
        self._ghosts: dict[str, list] = {}
        self.artists = [self.line, self.hinges, self.base, self.tip]
        self.artists += [artist for label in self.labels.values() for artist in label.artists]

    def move(self, poses: Mapping[str, Transform], ghosts: Mapping[str, Sequence[float]]) -> None:
        """Draw the links at `poses`, which are in the first link."""
        places = {name: self._eye.on_paper(pose.translation) for name, pose in poses.items()}
        points = np.array(list(places.values()))
        self.line.set_data(*points.T)
        self.hinges.set_data(*np.array([places[name] for name in self._moving]).reshape(-1, 2).T)
        self.base.set_data(*points[:1].T)
        self.tip.set_data(*places[self._tip].reshape(1, 2).T)
        lines = [(tuple(a), tuple(b)) for a, b in pairwise(points)]
        for name, label in self.labels.items():
            label.follow(places[name])
            label.keep_off = lines
        for name, place in ghosts.items():
            self._draw_ghost(name, self._eye.on_paper(place))
        place_labels(list(self.labels.values()))

    def _draw_ghost(self, name: str, place: np.ndarray) -> None:
        """Draw a wrong place of the tip once: a hollow ring, its name in italics."""
        if name in self._ghosts:
            return
        self._ghosts[name] = self._ax.plot(*place.reshape(1, 2).T, "o", color=style.GREY, markersize=8.0, zorder=13,
                                           markerfacecolor=style.PAPER, markeredgewidth=1.4)  # fmt: skip
        self.labels[name] = FloatingLabel(self._ax, name, colour=style.GREY, is_italic=True)
        self.labels[name].follow(place)


class _TileArtists:
    """One joint as a domino, and below it its name, its position and its numbers; a thick edge if it is touched."""

    def __init__(self, ax: Axes, middle_px: float, width_px: float, step: Step) -> None:
        from matplotlib.patches import FancyBboxPatch

        left, bottom = middle_px - width_px / 2, ROW_PX - 30
        where = ((left, bottom), width_px, HIGH_PX)
        how = {"boxstyle": "round,pad=0,rounding_size=5", "edgecolor": style.INK}
        ax.add_patch(FancyBboxPatch(*where, facecolor=style.SHADE, linewidth=1.0, zorder=5, **how))
        self.edge = FancyBboxPatch(*where, facecolor="none", linewidth=2.6, zorder=11, **how)
        ax.add_patch(self.edge)
        part = len(step.parent) / (len(step.parent) + len(step.child))
        begins = left + (HINGE_PX if step.position is not None else 0.0)  # the hinge lies over what is left of it
        room_px = left + width_px - begins
        size = style.SMALL_PT * min(1.0, (room_px - 20) / (LETTER_PX * (len(step.parent) + len(step.child))))
        at_px = begins + 7 + part * (room_px - 14)
        ax.plot([at_px, at_px], [bottom + 4, bottom + HIGH_PX - 4], color=style.INK, linewidth=0.9, zorder=6)
        for name, x in ((step.parent, (begins + at_px) / 2), (step.child, (at_px + left + width_px) / 2)):
            ax.text(x, bottom + HIGH_PX / 2, name, ha="center", va="center", fontsize=size, zorder=10)
        if step.position is not None:  # the hinge
            ax.plot([left], [bottom + HIGH_PX / 2], "o", color=style.INK, markersize=8.0, markerfacecolor=style.PAPER,
                    markeredgewidth=1.6, zorder=12)  # fmt: skip
        ax.text(middle_px, bottom - 12, step.joint, ha="center", va="center", fontsize=min(size, style.SMALL_PT))
        self.position = ax.text(middle_px, bottom - 28, "", ha="center", va="center", color=style.ACCENT)
        self.numbers = ax.text(middle_px, bottom - 56, "", ha="center", va="center", color=style.GREY,
                               fontsize=style.SMALL_PT * min(1.0, width_px / 134.0), linespacing=1.5)  # fmt: skip
        self.artists = [self.edge, self.position, self.numbers]

    def move(self, step: Step, is_touched: bool) -> None:
        """Show the joint as it stands."""
        self.edge.set_visible(is_touched)
        self.position.set_text(_position(step))
        self.position.set_fontweight("bold" if is_touched else "normal")
        self.position.set_color(style.GREY if step.position is None else style.ACCENT)
        xyz, rpy = step.parent_T_child.translation, step.parent_T_child.rpy()
        self.numbers.set_text(f"{style.fmt_all(xyz, '', 2)} m\nrpy {style.fmt_all(rpy, '', 2)}")


def draw_joints(
    steps: Sequence[Step], touched: str = "", ghosts: Mapping[str, Sequence[float]] | None = None
) -> JointsPicture:
    """Draw a chain of joints as they stand; see `JointsPicture.show`.

    Raises:
        ValueError: there is no joint, or one does not hang on the one before it.
    """
    if not steps:
        raise ValueError("a chain needs at least one joint")
    for above, step in pairwise(steps):
        if step.parent != above.child:
            raise ValueError(f'joint "{step.joint}" hangs on "{step.parent}", and before it comes "{above.child}"')
    picture = JointsPicture(steps)
    picture.show(steps, touched, ghosts)
    return picture


def _tiles(picture: Picture, steps: Sequence[Step]) -> list[_TileArtists]:
    """Make the row of dominoes, as wide as the card at most."""
    width_px, height_px = picture.size_px
    ax = picture.figure.add_axes((0.0, 1 - (ARM_PX + ROW_PX) / height_px, 1.0, ROW_PX / height_px))
    ax.set_axis_off()
    ax.set_xlim(0, width_px)
    ax.set_ylim(0, ROW_PX)
    each_px = min(TILE_PX, (width_px - 2 * EDGE_PX) / len(steps))
    first_px = width_px / 2 - each_px * (len(steps) - 1) / 2
    return [_TileArtists(ax, first_px + i * each_px, each_px - GAP_PX, step) for i, step in enumerate(steps)]


def _reach(steps: Sequence[Step]) -> tuple[np.ndarray, float]:
    """Return about which place the tip can turn, and how far away it can be [m]."""
    poses = poses_along(steps)
    lengths = [float(np.linalg.norm(step.parent_T_child.translation)) for step in steps]
    first = next((i for i, step in enumerate(steps) if step.position is not None), 0)
    return np.array(poses[steps[first].child].translation), sum(lengths[first + 1 :]) or sum(lengths) or 1.0


def _position(step: Step) -> str:
    return "fixed" if step.position is None else f"{style.fmt(step.position, '', 2)} {step.unit}"
