"""Draw the frame tree, with its publishers and faults, as SVG, PDF and text.

    map
    └─ odom             D   10.0 Hz   0.050 s   /amcl
       └─ base_link     D   20.0 Hz   0.010 s   /moving_robot_broadcaster
          └─ laser      S                       /static_sensor_broadcaster

One row for each frame, a child below its parent. D is a dynamic transform (a solid line), S a
static one (a dashed line). Faults are drawn and described: several roots, a loop, two publishers
of one edge, two parents. Publishers belong to an edge: two nodes that publish one frame under two
parents are not two owners of either edge. `view_frames_tree.py` draws what `view_frames` shows.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any, Literal

from tflab.core import FrameSnapshot, Snapshot, format_stamp

from . import style
from .sheet import FONT_SIZE, BoxMark, LineMark, Mark, Sheet, TextMark, pdf_from_sheet, svg_from_sheet, text_width
from .style import fmt_name

QUIET, ALARM, WASH = style.GREY, style.ACCENT, "#F8EDF6"
MARGIN, TRUNK, ROW, PILL = 18.0, 14.0, 34.0, 24.0  # [pt] rim, stem from the left, height of a row and of a box
STEP, NARROWEST_STEP, WIDEST_INDENT = 46.0, 28.0, 460.0  # [pt] indent of a child; deep trees get less, down to this
LEGEND = "D dynamic: solid line, valid at its stamps    S static: dashed line, valid at any time"


@dataclass(frozen=True, slots=True)
class TreeFault:
    """Something that a healthy tree does not have: what kind, which frames, and a sentence about it."""

    kind: Literal["roots", "loop", "owners", "parents"]
    frames: tuple[str, ...]
    text: str


@dataclass(frozen=True, slots=True)
class Row:
    """One line of the drawing.

    Attributes:
        frame: whose line it is.
        parent_row: the number of its parent's row, None for a root.
        edge: what is known of it as a child; None for a root.
        role: "again" closes a loop, "also here" stands under a parent it had besides its newest one, and "left over"
            is what the last child has left.
        owners: who publishes this very edge, from this parent; whoever publishes another is not among them.
    """

    frame: str
    parent_row: int | None
    edge: FrameSnapshot | None
    role: Literal["frame", "again", "also here", "left over"] = "frame"
    owners: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class TreePicture:
    """The drawn tree: `svg` for a page, `text` for a terminal, `pdf()` for a file."""

    text: str
    svg: str
    faults: tuple[TreeFault, ...]
    sheet: Sheet

    def pdf(self) -> bytes:
        """Return the drawing as a PDF of one page, the same bytes every time."""
        return pdf_from_sheet(self.sheet)

    def __str__(self) -> str:
        return self.text

    def _repr_mimebundle_(self, include: Any = None, exclude: Any = None) -> dict[str, str]:
        return {"image/svg+xml": self.svg, "text/plain": self.text}


def draw_tree(snapshot: Snapshot, now_ns: int | None = None, title: str = "Frame tree") -> TreePicture:
    """Draw a tree of frames.

    Args:
        snapshot: its `authorities` are shown as the publishers.
        now_ns: the moment that ages are reckoned from [ns]; without it, stamps stand in their place.
    """
    rows, faults = rows_of(snapshot), tree_faults(snapshot)
    text = text_from_tree(snapshot, now_ns)
    sheet = _sheet(rows, faults, now_ns, title, text)
    return TreePicture(text, svg_from_sheet(sheet), faults, sheet)


# -- what is there --------------------------------------------------------


def rows_of(snapshot: Snapshot) -> tuple[Row, ...]:
    """Return every frame in drawing order: trees by the name of their root, then loops; children by name."""
    edges = {edge.name: edge for edge in snapshot.frames}
    children = _children(snapshot)
    rows: list[Row] = []

    def descend(frame: str, parent_row: int | None, role: str, ancestors: tuple[str, ...]) -> None:
        number = len(rows)
        if frame in ancestors:
            role = "again"
        edge = None if parent_row is None else edges[frame]
        owners = () if edge is None else edge.authorities(rows[parent_row].frame)
        rows.append(Row(frame, parent_row, edge, role, owners))
        if role == "frame":
            for child in children.get(frame, ()):
                child_role = "frame" if edges[child].parent == frame else "also here"
                descend(child, number, child_role, (*ancestors, frame))

    for root in _roots(snapshot):
        descend(root, None, "left over" if edges and root not in children else "frame", ())
    for loop in _loops(snapshot):
        descend(loop[0], None, "frame", ())
    return tuple(rows)


def tree_faults(snapshot: Snapshot) -> tuple[TreeFault, ...]:
    """Return what a healthy tree does not have, the worst first."""
    return tuple(_faults(snapshot))


def _faults(snapshot: Snapshot) -> Iterator[TreeFault]:
    loops, parents = _loops(snapshot), {edge.parent for edge in snapshot.frames}
    roots = [root for root in _roots(snapshot) if root in parents]  # one that only had a child once is no tree
    for loop in loops:
        path = " -> ".join(map(fmt_name, (*loop, loop[0])))
        what = "A lookup that enters it fails (LookupException), unless it meets its target on the way up"
        yield TreeFault("loop", loop, f"loop: {path}. {what} from its source.")
    if len(roots) + len(loops) > 1:
        tops = (*roots, *(loop[0] for loop in loops))
        trees = f"{len(tops)} separate trees, from {', '.join(map(fmt_name, tops))}."
        yield TreeFault("roots", tops, f"{trees} No lookup crosses from one to another (ConnectivityException).")
    for edge in sorted(snapshot.frames):
        name = fmt_name(edge.name)
        for parent in edge.parents:
            owners = edge.authorities(parent)
            if len(owners) > 1:
                who = f"{len(owners)} publishers: {', '.join(owners)}."
                what = "The one heard last counts." if edge.is_static else "Lookups land between their values."
                yield TreeFault("owners", (edge.name,), f"{fmt_name(parent)} -> {name} has {who} {what}")
        if len(edge.parents) > 1:
            who = f"{len(edge.parents)} parents: {', '.join(_parent_and_owners(edge, p) for p in edge.parents)}."
            what = "The one heard last counts." if edge.is_static else "It jumps from one to the other."
            yield TreeFault("parents", (edge.name,), f"{name} has {who} {what}")


def _parent_and_owners(edge: FrameSnapshot, parent: str) -> str:
    owners = edge.authorities(parent)
    return f"{fmt_name(parent)} (from {', '.join(owners)})" if owners else fmt_name(parent)


def _children(snapshot: Snapshot) -> dict[str, list[str]]:
    """Return the children of each frame by name, those included that have meanwhile moved to another parent."""
    children: dict[str, list[str]] = {}
    for edge in sorted(snapshot.frames):
        for parent in sorted({edge.parent, *edge.parents}):
            children.setdefault(parent, []).append(edge.name)
    return children


def _roots(snapshot: Snapshot) -> tuple[str, ...]:
    named = {edge.name for edge in snapshot.frames}
    parents = {parent for edge in snapshot.frames for parent in (edge.parent, *edge.parents)}
    return tuple(sorted((parents | set(snapshot.roots)) - named))


def _loops(snapshot: Snapshot) -> tuple[tuple[str, ...], ...]:
    """Return every loop once, parent before child, beginning with its alphabetically first frame."""
    parent_of = {edge.name: edge.parent for edge in snapshot.frames}
    loops, seen = [], set()
    for start in sorted(parent_of):
        path, frame = [], start
        while frame in parent_of and frame not in seen:
            seen.add(frame)
            path.append(frame)
            frame = parent_of[frame]
        if frame in path:
            upwards = path[path.index(frame) :]
            downwards = upwards[::-1]
            first = downwards.index(min(downwards))
            loops.append(tuple(downwards[first:] + downwards[:first]))
    return tuple(sorted(loops))


# -- as text ------------------------------------------------------------


def text_from_tree(snapshot: Snapshot, now_ns: int | None = None) -> str:
    """Return the tree as lines of text, with a line for each fault below it."""
    rows = rows_of(snapshot)
    if not rows:
        return "(no frames yet)"
    branches = _branches(rows)
    table = [(branch + row_name(row), *_cells(row, now_ns)) for branch, row in zip(branches, rows, strict=True)]
    widths = [max(len(line[column]) for line in table) for column in range(5)]
    lines = ["  ".join(cell.ljust(width) for cell, width in zip(line, widths, strict=True)).rstrip() for line in table]
    return "\n".join([*lines, *(f"! {fault.text}" for fault in tree_faults(snapshot))])


def _branches(rows: tuple[Row, ...]) -> list[str]:
    """Return the lines that lead to each name, as in a listing of folders."""
    last_child = {row.parent_row: number for number, row in enumerate(rows)}
    branches = []
    for number, row in enumerate(rows):
        branch, above, below = "", number, row.parent_row
        while below is not None:
            is_last = last_child[below] == above
            piece = ("└─ " if is_last else "├─ ") if above == number else ("   " if is_last else "│  ")
            branch = piece + branch
            above, below = below, rows[below].parent_row
        branches.append(branch)
    return branches


def row_name(row: Row) -> str:
    """Return a frame's name, and its role if it is repeated."""
    return fmt_name(row.frame) if row.role == "frame" else f"{fmt_name(row.frame)} ({row.role})"


def _cells(row: Row, now_ns: int | None) -> tuple[str, str, str, str]:
    """Return kind, rate, age and publishers of a row, each "" where there is nothing to say."""
    edge = row.edge
    if edge is None:
        return ("", "", "", "")
    owners = ", ".join(row.owners)
    if edge.is_static or row.role == "also here":
        return ("S" if edge.is_static else "D", "", "", owners)
    rate = f"{edge.rate_hz:.1f} Hz" if edge.samples > 1 else "1 sample"
    age = f"at {format_stamp(edge.newest_ns, 3)} s" if now_ns is None else f"{(now_ns - edge.newest_ns) / 1e9:.3f} s"
    return ("D", rate, age, owners)


# -- as a drawing ---------------------------------------------------------


@dataclass(frozen=True, slots=True)
class _Layout:
    """Where everything stands: the frames on the left, what is known of each to the right, the faults below."""

    rows: tuple[Row, ...]
    cells: tuple[tuple[str, str, str, str], ...]
    faulty: frozenset[tuple[str, str]]
    depths: tuple[int, ...]
    step: float
    columns: tuple[float, ...]

    def left(self, depth: int) -> float:
        return MARGIN + depth * self.step

    def y(self, number: int) -> float:
        return MARGIN + 32 + number * ROW


def _layout(rows: tuple[Row, ...], faults: tuple[TreeFault, ...], now_ns: int | None) -> _Layout:
    cells = tuple(_cells(row, now_ns) for row in rows)
    depths = depths_of(rows)
    step = min(STEP, max(NARROWEST_STEP, WIDEST_INDENT / (max(depths) or 1)))
    right = max(depth * step + _pill_width(row) for depth, row in zip(depths, rows, strict=True))
    columns = _columns(MARGIN + right + 30, _headings(now_ns), cells)
    faulty = frozenset((fault.kind, frame) for fault in faults for frame in fault.frames)
    return _Layout(rows, cells, faulty, depths, step, columns)


def _sheet(rows: tuple[Row, ...], faults: tuple[TreeFault, ...], now_ns: int | None, title: str, text: str) -> Sheet:
    if not rows:
        return Sheet(260, 60, (TextMark(130, 30, "no frames yet", QUIET, centred=True),), title, text)
    layout = _layout(rows, faults, now_ns)
    marks: list[Mark] = [
        TextMark(x, MARGIN + 4, heading, QUIET, size=11)
        for column, (x, heading) in enumerate(zip(layout.columns, _headings(now_ns), strict=True))
        if any(cell[column] for cell in layout.cells)
    ]
    marks += _trunks(layout)
    for number in range(len(rows)):
        marks += _branch_marks(layout, number)
        marks += _frame_marks(layout, number)
        marks += _figure_marks(layout, number)
    foot = layout.y(len(rows))
    sentences = [*(f"! {fault.text}" for fault in faults), LEGEND]
    for number, sentence in enumerate(sentences):
        colour = QUIET if sentence == LEGEND else ALARM
        marks.append(TextMark(MARGIN, foot + 20 * number, sentence, colour, size=11))
    owners = max(text_width(_headings(now_ns)[3], 11), *(text_width(cell[3]) for cell in layout.cells))
    right = layout.columns[3] + owners
    width = max(right, *(MARGIN + text_width(sentence, 11) for sentence in sentences)) + MARGIN
    return Sheet(width, foot + 20 * len(sentences) + 6, tuple(marks), title, text)


def _trunks(layout: _Layout) -> Iterator[Mark]:
    """Yield, for each parent, the upright line that its children branch off from."""
    last_child = {row.parent_row: number for number, row in enumerate(layout.rows) if row.parent_row is not None}
    for parent, last in last_child.items():
        x = layout.left(layout.depths[parent]) + TRUNK
        yield LineMark(((x, layout.y(parent) + PILL / 2), (x, layout.y(last))), QUIET, width=1.2)


def _branch_marks(layout: _Layout, number: int) -> Iterator[Mark]:
    """Yield the line from the parent's trunk; with two publishers a doubled one."""
    row, y, depth = layout.rows[number], layout.y(number), layout.depths[number]
    if row.parent_row is None:
        return
    is_repeated = row.role != "frame"
    has_two_owners = len(row.owners) > 1
    line_style = "dotted" if is_repeated else "dashed" if row.edge.is_static else "solid"
    colour = ALARM if is_repeated or has_two_owners else style.INK
    for shift in (-2.5, 2.5) if has_two_owners else (0,):
        start, end = layout.left(depth - 1) + TRUNK, layout.left(depth)
        yield LineMark(((start, y + shift), (end, y + shift)), colour, style=line_style, arrow=shift == 0)


def _frame_marks(layout: _Layout, number: int) -> Iterator[Mark]:
    """Yield the box with the name."""
    row, x, y = layout.rows[number], layout.left(layout.depths[number]), layout.y(number)
    is_root, is_repeated = row.parent_row is None, row.role in ("again", "also here")
    is_faulty = any((kind, row.frame) in layout.faulty for kind in ("loop", "parents"))
    is_alarming = is_repeated or is_faulty or (is_root and ("roots", row.frame) in layout.faulty)
    colour, fill = (ALARM, WASH) if is_alarming else (style.INK, style.PAPER)
    yield BoxMark(x, y - PILL / 2, _pill_width(row), PILL, colour, fill, "dotted" if is_repeated else "solid")
    yield TextMark(x + 10, y, row_name(row), colour, bold=is_root)


def _figure_marks(layout: _Layout, number: int) -> Iterator[Mark]:
    """Yield the letter, and what is known of the edge."""
    y, (x_kind, x_rate, x_age, x_owners) = layout.y(number), layout.columns
    kind, rate, age, owners = layout.cells[number]
    if kind:
        yield BoxMark(x_kind, y - 9, 18, 18, QUIET, style.PAPER, "dashed" if kind == "S" else "solid", corner=9)
        yield TextMark(x_kind + 9, y, kind, style.INK, size=11, bold=True, centred=True)
    yield from (TextMark(x, y, cell, style.INK) for x, cell in ((x_rate, rate), (x_age, age)) if cell)
    if owners:
        has_two = len(layout.rows[number].owners) > 1
        yield TextMark(x_owners, y, owners, ALARM if has_two else style.INK, bold=has_two)


def depths_of(rows: Sequence[Row]) -> tuple[int, ...]:
    """Return how far below its root each row is."""
    depths: list[int] = []
    for row in rows:
        depths.append(0 if row.parent_row is None else depths[row.parent_row] + 1)
    return tuple(depths)


def _headings(now_ns: int | None) -> tuple[str, str, str, str]:
    return ("", "rate", "newest stamp" if now_ns is None else "age", "published by")


def _columns(x: float, headings: tuple[str, ...], cells: tuple[tuple[str, ...], ...]) -> tuple[float, ...]:
    """Return where the letter, the rate, the age and the publishers begin; an empty column has no width."""
    places = [x, x + 36]
    for column in (1, 2):
        width = max(text_width(cell[column]) for cell in cells)
        places.append(places[-1] + (max(width, text_width(headings[column], 11)) + 18 if width else 0))
    return tuple(places)


def _pill_width(row: Row) -> float:
    return text_width(row_name(row), FONT_SIZE) + 20
