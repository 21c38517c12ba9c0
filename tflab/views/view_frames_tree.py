"""Draw the frame tree as `view_frames` does: only what the service `tf2_frames` answered.

Each frame stands under the parent that its newest sample names. Other parents, real publishers and
faults are not known to the service; `tree.py` draws them. On a robot Graphviz draws this from the
.gv file (upstream: tf2_tools).
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from . import style
from .sheet import BoxMark, LineMark, Mark, Sheet, TextMark, svg_from_sheet, text_width
from .tree import TreePicture

MARGIN, GAP, OVAL = 18.0, 10.0, 30.0  # [pt] rim, between neighbours, height of a frame
SMALL, LINE = 9.0, 11.5  # [pt] size and height of a line of an edge's label
LABELS = {
    "broadcaster": "Broadcaster",
    "rate": "Average rate",
    "buffer_length": "Buffer length",
    "most_recent_transform": "Most recent transform",
    "oldest_transform": "Oldest transform",
}
BEND, STEM, LOOP = 8.0, 12.0, 12.0  # [pt] where edges part, how long an arrow is, how far left a loop closes
STORY = OVAL + BEND + STEM + LINE * (len(LABELS) + 1.5)  # from one generation to the next
NOTHING = "No tf data received"

Frames = Mapping[str, Mapping[str, Any]]


@dataclass(frozen=True, slots=True)
class _Place:
    """Where a frame stands: the middle of its oval."""

    x: float
    y: float


def draw_upstream_tree(frames: Frames, recorded_s: float) -> TreePicture:
    """Draw what the service `tf2_frames` answered, read as YAML: for each child its parent and five figures."""
    text = _in_words(frames, recorded_s)
    title = "view_frames Result"
    if not frames:
        width = text_width(NOTHING) + 60
        oval = BoxMark(MARGIN, MARGIN, width - 2 * MARGIN, OVAL, style.INK, corner=OVAL / 2)
        marks = (oval, TextMark(width / 2, MARGIN + OVAL / 2, NOTHING, style.INK, centred=True))
        sheet = Sheet(width, OVAL + 2 * MARGIN, marks, title, text)
    else:
        places, width = _places(frames)
        marks = tuple(_marks(frames, places, recorded_s))
        height = max(mark.y for mark in marks if isinstance(mark, TextMark)) + OVAL / 2 + MARGIN
        sheet = Sheet(width, height, marks, title, text)
    return TreePicture(text, svg_from_sheet(sheet), (), sheet)


def _in_words(frames: Frames, recorded_s: float) -> str:
    lines = [f"view_frames Result, recorded at time: {recorded_s}"]
    for name, frame in frames.items():
        figures = ", ".join(f"{label}: {frame[key]}" for key, label in LABELS.items())
        lines.append(f'"{frame["parent"]}" -> "{name}"  {figures}')
    return "\n".join(lines) if frames else NOTHING


# -- where everything stands ----------------------------------------------


def _places(frames: Frames) -> tuple[dict[str, _Place], float]:
    """Return where each frame stands, a child below its parent, and how wide all are together."""
    children: dict[str, list[str]] = {}
    for name, frame in frames.items():
        children.setdefault(frame["parent"], []).append(name)
    places: dict[str, _Place] = {}
    tops = [frame["parent"] for frame in frames.values() if frame["parent"] not in frames]

    def put(name: str, left: float, depth: int) -> tuple[list[str], float]:
        """Place a frame and all below it to the right of `left`; return their names, and where they end."""
        places[name] = _Place(0.0, 0.0)  # it has its turn: in a loop, nobody comes here again
        below: list[str] = []
        mine, right = [], left
        for child in children.get(name, ()):
            if child not in places:
                names, right = put(child, right, depth + 1)
                mine.append(child)
                below += names
        west, east = _room(name, frames.get(name), bool(tops))
        middle = (places[mine[0]].x + places[mine[-1]].x) / 2 if mine else left + west
        x = max(middle, left + west)
        for other in below:  # what is narrower than its parent stands in its middle
            places[other] = _Place(places[other].x + x - middle, places[other].y)
        places[name] = _Place(x, MARGIN + LEGEND_HEIGHT + OVAL / 2 + depth * STORY)
        return [name, *below], max(right + x - middle if mine else left, x + east + GAP)

    right = MARGIN
    for name in (*dict.fromkeys(tops), *frames):  # frames that no top leads to are in loops
        if name not in places:
            _, right = put(name, right, 0)
    return places, max(right - GAP, MARGIN + _legend_width()) + MARGIN


def _room(name: str, frame: Mapping[str, Any] | None, has_top: bool) -> tuple[float, float]:
    """Return the width of a frame left and right of its middle: its oval, and the label of its edge.

    The label stands in the middle; in a loop, where an edge runs back up, on the left.
    """
    oval, label = _oval_width(name) / 2, _label_width(frame)
    return max(oval, label / 2 if has_top else label + LOOP), max(oval, label / 2)


def _oval_width(name: str) -> float:
    return text_width(name) + 32


def _label_width(frame: Mapping[str, Any] | None) -> float:
    """Return the width of an edge's label."""
    if frame is None:
        return 0.0
    return max(text_width(f"{label}: {frame[key]}", SMALL) for key, label in LABELS.items())


# -- as marks -------------------------------------------------------------

LEGEND_HEIGHT = 62.0


def _legend_width() -> float:
    return text_width("Recorded at time: 1700000000.123456") + 24


def _marks(frames: Frames, places: Mapping[str, _Place], recorded_s: float) -> Iterator[Mark]:
    yield from _legend(recorded_s)
    for name, frame in frames.items():
        yield from _edge(places[frame["parent"]], places[name], frame)
    for name, place in places.items():
        width = _oval_width(name)
        corner = OVAL / 2
        yield BoxMark(place.x - width / 2, place.y - OVAL / 2, width, OVAL, style.INK, corner=corner)
        yield TextMark(place.x, place.y, name, style.INK, centred=True)


def _legend(recorded_s: float) -> Iterator[Mark]:
    width, height = _legend_width(), LEGEND_HEIGHT - GAP
    yield BoxMark(MARGIN, MARGIN, width, height, style.INK, corner=0.0)
    yield TextMark(MARGIN + width / 2, MARGIN + 14, "view_frames Result", style.INK, centred=True, bold=True)
    yield TextMark(MARGIN + width / 2, MARGIN + 33, f"Recorded at time: {recorded_s}", style.INK, centred=True)


def _edge(parent: _Place, child: _Place, frame: Mapping[str, Any]) -> Iterator[Mark]:
    """Yield the line from a parent to the label and on to the child; one that closes a loop runs up, on the left."""
    lines = [f"{label}: {frame[key]}" for key, label in LABELS.items()]
    below, width = parent.y + OVAL / 2, _label_width(frame)
    if child.y > parent.y:
        end, bend = child.y - OVAL / 2, below + BEND
        top = end - STEM - LINE * (len(lines) - 0.5)
        yield LineMark(((parent.x, below), (parent.x, bend), (child.x, bend), (child.x, top - LINE)), style.INK)
        yield LineMark(((child.x, end - STEM), (child.x, end)), style.INK, arrow=True)
        x = child.x - width / 2
    else:
        left = parent.x - LOOP
        points = ((left, parent.y - OVAL / 2), (child.x - LOOP, child.y + OVAL / 2))
        if parent == child:
            points = ((left, below), (left, below + BEND), (parent.x, below + BEND), (parent.x, below))
        x, top = left - LOOP / 2 - width, child.y + OVAL / 2 + BEND + LINE
        yield LineMark(points, style.INK, arrow=True)
    for number, line in enumerate(lines):
        yield TextMark(x, top + number * LINE, line, style.INK, size=SMALL)
