"""Draw the path of a lookup through the frame tree: up from the source, down to the target.

    map
    └─ odom
       └─ base_link        ((ring)) the lowest common ancestor
          ├─ laser_frame   ==1==^   up: a solid line, its head at the parent
          └─ camera_link   ~~2~~>   down: a dashed line, its head at the child

One row for each frame; the edges of the path are thick and numbered. Where there is no path, both
climbs are drawn up to where they end: at two roots, or in a loop.
"""

from __future__ import annotations

import textwrap
from collections.abc import Iterable, Mapping, Sequence
from itertools import count
from typing import NamedTuple

from tflab.core import FrameSnapshot, Snapshot, Transform

from . import style
from .frames import clear_paper
from .picture import Picture
from .style import fmt_name
from .tree import Row, depths_of, row_name, rows_of, tree_faults

WIDTH_PT = 72.0 * style.WIDE[0]
ROW, PILL, RIM, HEAD = 30.0, 21.0, 22.0, 30.0  # a row, a name's box, the margin, the room for a title [pt]
WIDEST_STEP, INDENT = 62.0, 300.0  # of a child, and of the deepest one [pt]
LETTER, LINE = 6.1, 13.0  # of a name, of a line of words below [pt]
MOST_LETTERS = 96  # in a line below the tree


class Walk(NamedTuple):
    """The way from a source to a target.

    Attributes:
        target, source: what was asked.
        up: the frames that one climbs from, the source first.
        down: the frames that one comes down to, the target last.
        met: the frame where both ways meet; None if they do not.
        ends: where each climb ends if they do not meet, the source's first.
    """

    target: str
    source: str
    up: tuple[str, ...] = ()
    down: tuple[str, ...] = ()
    met: str | None = None
    ends: tuple[str, ...] = ()


def walk_between(parent_of: Mapping[str, str], target: str, source: str) -> Walk:
    """Return the way from `source` to `target`, as tf2 climbs: the source first, and all the way if it has to."""
    up, goes_round = _climb(parent_of, source, {target})
    if up[-1] == target:
        return Walk(target, source, tuple(up[:-1]), (), target)
    if goes_round:
        return Walk(target, source, tuple(up[:-1]), (), None, (up[-1],))
    down, goes_round = _climb(parent_of, target, set(up))
    if goes_round or down[-1] not in up:
        return Walk(target, source, tuple(up[:-1]), tuple(reversed(down[:-1])), None, (up[-1], down[-1]))
    met = down[-1]
    return Walk(target, source, tuple(up[: up.index(met)]), tuple(reversed(down[:-1])), met)


def describe_walk(walk: Walk, parent_of: Mapping[str, str]) -> str:
    """Return the figure's text: every step with its number, and where the ways meet or end."""
    steps = [("up", frame, parent_of[frame]) for frame in walk.up]
    steps += [("down", parent_of[frame], frame) for frame in walk.down] if walk.met is not None else []
    lines = [f"from {fmt_name(walk.source)} to {fmt_name(walk.target)}"]
    lines += [f"  {n}  {direction:<4}  {fmt_name(a)} -> {fmt_name(b)}" for n, (direction, a, b) in enumerate(steps, 1)]
    if walk.met is not None:
        return "\n".join([*lines, f"they meet at {fmt_name(walk.met)}"])
    if len(walk.ends) == 1:
        return "\n".join([*lines, f"no way: the climb comes round to {fmt_name(walk.ends[0])} again"])
    return "\n".join([*lines, f"no way: one climb ends at {walk.ends[0]}, the other at {walk.ends[1]}"])


def draw_walk(snapshot: Snapshot, target_frame: str, source_frame: str) -> Picture:
    """Draw a tree, and in it the way from `source_frame` up and down to `target_frame`.

    Raises:
        ValueError: there is no such frame in the tree.
    """
    picture = TreeWalkPicture(len(rows_of(snapshot)))
    picture.show(snapshot, target_frame, source_frame)
    return picture


def snapshot_of_parents(parent_of: Mapping[str, str], known: Iterable[str] = ()) -> Snapshot:
    """Return a tree that is known by its parents alone, as a view takes it; `known` frames stay if they are alone."""
    frames = tuple(
        FrameSnapshot(child, parent, True, ((parent, ""),), 1, 0.0, 0, 0, Transform())
        for child, parent in parent_of.items()
    )
    roots = dict.fromkeys(name for name in (*parent_of.values(), *known) if name not in parent_of)
    return Snapshot(tuple(roots), frames)


class TreeWalkPicture(Picture):
    """A tree with one walk in it; it can be shown anew with another tree, another question, or words below it."""

    def __init__(self, rows: int, lines: int = 0) -> None:
        """Choose the size for this many rows, and lines of text below them."""
        self._height_pt = _height_pt(rows, lines)
        super().__init__((style.WIDE[0], self._height_pt / 72.0))
        self._axes = clear_paper(self.figure.add_axes((0.0, 0.0, 1.0, 1.0)))

    def show(
        self, snapshot: Snapshot, target_frame: str, source_frame: str, answer: str = "", is_answer: bool = True
    ) -> None:
        """Draw this tree and this question, the answer in words below.

        Raises:
            ValueError: there is no such frame in the tree.
        """
        parent_of = {edge.name: edge.parent for edge in snapshot.frames}
        rows = rows_of(snapshot)
        names = {row.frame for row in rows}
        for frame in (target_frame, source_frame):
            if frame not in names:
                raise ValueError(f'there is no frame "{frame}" in this tree; there is {", ".join(sorted(names))}')
        walk = walk_between(parent_of, target_frame, source_frame)
        self._axes.clear()
        clear_paper(self._axes)
        self._axes.set_xlim(0.0, WIDTH_PT)
        self._axes.set_ylim(-self._height_pt, 0.0)
        with style.our_settings():
            faulty = {frame for fault in tree_faults(snapshot) for frame in fault.frames}
            _Drawing(self._axes, rows, walk, faulty).draw()
            lines = self._write_below(len(rows), answer, is_answer)
        style.shorten_card(self.figure, min(_height_pt(len(rows), lines), self._height_pt) / 72.0)
        self.redraw_all()
        faults = [f"! {fault.text}" for fault in tree_faults(snapshot)]
        tree = [f"{'   ' * depth}{row_name(row)}" for depth, row in zip(depths_of(rows), rows, strict=True)]
        self.text = "\n".join([*tree, *faults, describe_walk(walk, parent_of), *([answer] if answer else [])])

    def _write_below(self, rows: int, answer: str, is_answer: bool) -> int:
        """Write the answer below so many rows; return how many lines it takes."""
        lines = [part for line in answer.splitlines() for part in textwrap.wrap(line, MOST_LETTERS)]
        y = -(HEAD + ROW * rows + 10.0)
        for number, line in enumerate(lines):
            self._axes.text(RIM, y - LINE * number, line, va="top", fontsize=style.SMALL_PT, family="monospace",
                            color=style.INK if is_answer else style.ACCENT)  # fmt: skip
        return len(lines)


class _Drawing:
    """Where each row stands, and what is drawn there."""

    def __init__(self, ax, rows: Sequence[Row], walk: Walk, faulty: set[str]) -> None:
        self._ax, self._rows, self._walk, self._faulty = ax, rows, walk, faulty
        self._depths = depths_of(rows)
        self._step = min(WIDEST_STEP, INDENT / (max(self._depths, default=0) or 1))
        numbers = count(1)
        self._up = {frame: next(numbers) for frame in walk.up}
        self._down = {frame: next(numbers) for frame in walk.down}

    def draw(self) -> None:
        """Draw the quiet edges first, then the walk, then the names."""
        edges = [number for number, row in enumerate(self._rows) if row.parent_row is not None]
        for number in sorted(edges, key=lambda number: self._is_walked(number)):
            self._draw_edge(number)
        for number, row in enumerate(self._rows):
            self._draw_name(number, row)

    def _place(self, number: int) -> tuple[float, float]:
        return RIM + self._step * self._depths[number], -(HEAD + ROW * (number + 0.5) - 8.0)

    def _is_walked(self, number: int) -> bool:
        row = self._rows[number]
        return row.role in ("frame", "again") and (row.frame in self._up or row.frame in self._down)

    def _draw_edge(self, number: int) -> None:
        """Draw the elbow from a parent's stem to its child, with head and number where the walk takes it."""
        row = self._rows[number]
        (parent_x, parent_y), (x, y) = self._place(row.parent_row), self._place(number)
        ring = 4.0 if self._rows[row.parent_row].frame == self._walk.met else 0.0
        stem, top = parent_x + 13.0, parent_y - PILL / 2 - ring
        if not self._is_walked(number):
            colour = style.ACCENT if row.role != "frame" else style.FAINT
            self._ax.plot([stem, stem, x], [top, y, y], color=colour, linewidth=1.2,
                          linestyle="dotted" if row.role != "frame" else "solid", zorder=2)  # fmt: skip
            return
        is_up = row.frame in self._up
        shift = 3.0 if is_up else -3.0  # two ways may share a stem
        xs, ys = [x, stem + shift, stem + shift], [y, y, top]
        self._ax.plot(xs, ys, color=style.ACCENT, linewidth=2.4, linestyle="solid" if is_up else (0, (2.6, 1.2)),
                      zorder=5)  # fmt: skip
        head = ((stem + shift, top - 1.0), "^") if is_up else ((x - 4.0, y), ">")
        self._ax.plot(*head[0], marker=head[1], markersize=8, color=style.ACCENT, zorder=6)
        middle = (stem + shift + x) / 2.0 - (0.0 if is_up else 2.0)
        self._ax.plot(middle, y, marker="o", markersize=12, color=style.PAPER, markeredgecolor=style.ACCENT, zorder=7)
        self._ax.text(middle, y - 0.4, str(self._up.get(row.frame) or self._down[row.frame]), ha="center",
                      va="center", fontsize=style.SMALL_PT - 0.5, color=style.ACCENT, zorder=8)  # fmt: skip

    def _draw_name(self, number: int, row: Row) -> None:
        from matplotlib.patches import FancyBboxPatch

        x, y = self._place(number)
        said = row_name(row)
        width = LETTER * len(said) + 16.0
        is_odd = row.role != "frame" or row.frame in self._faulty
        colour = style.ACCENT if is_odd else style.INK
        if row.frame == self._walk.met and row.role == "frame":
            self._box(FancyBboxPatch, (x - 4.0, y - PILL / 2 - 4.0), width + 8.0, PILL + 8.0, style.ACCENT, "none")
        self._box(FancyBboxPatch, (x, y - PILL / 2), width, PILL, colour, style.PAPER)
        self._ax.text(x + width / 2.0, y - 0.5, said, ha="center", va="center", fontsize=style.TEXT_PT - 0.5,
                      color=colour, zorder=11)  # fmt: skip
        ends = [word for word, frame in (("source", self._walk.source), ("target", self._walk.target))
                if frame == row.frame and row.role in ("frame", "left over")]  # fmt: skip
        if ends:
            self._ax.text(x + width + 12.0, y - 0.5, " = ".join(ends), va="center", fontsize=style.TEXT_PT,
                          style="italic", color=style.ACCENT)  # fmt: skip

    def _box(self, shape, place, width: float, height: float, edge: str, face: str) -> None:
        self._ax.add_patch(shape(place, width, height, boxstyle="round,pad=0,rounding_size=6", edgecolor=edge,
                                 facecolor=face, linewidth=1.6 if face == "none" else 1.1, zorder=10))  # fmt: skip


def _height_pt(rows: int, lines: int) -> float:
    """Return how high a tree of so many rows is, with so many lines of words below it [pt]."""
    return HEAD + ROW * rows + LINE * lines + (10.0 if lines else 0.0) + 10.0


def _climb(parent_of: Mapping[str, str], frame: str, until: set[str]) -> tuple[list[str], bool]:
    """Return the frames from one upwards, to a root or to one of `until`, and whether it went round in a loop."""
    path = [frame]
    while path[-1] not in until and path[-1] in parent_of:
        parent = parent_of[path[-1]]
        if parent in path:
            return [*path, parent], True
        path.append(parent)
    return path, False
