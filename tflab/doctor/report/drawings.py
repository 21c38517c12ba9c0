"""Draw a recording as SVG that follows the page's colours: its timeline, the time of a finding, the frames in 3D.

    odom -> base_link   |||||||||||||||||    |||||||||||||||   a lane for each edge that moves, dark where samples came
    map -> odom         | | | | | | | | | | | | | | | | | |    and a gap where none came
                                        ====                   what was found, under its lane

In 3D, each frame is at the pose that was received last before the time, as for a listener that does not wait.
The projection is orthographic.
"""

from __future__ import annotations

from collections.abc import Sequence
from html import escape

import numpy as np

from tflab.core import NSEC_PER_SEC, Transform

from ..evidence import Edge, Evidence
from ..findings import Finding

__all__ = ["draw_distribution", "draw_frames_at", "draw_moment", "draw_shares", "draw_timeline", "poses_at"]

MOST_LANES = 40
MOST_LANES_OF_A_MOMENT = 8
BINS = 320  # of a lane
WIDTH, NAMES, RIM, LANE, AXIS = 960.0, 250.0, 10.0, 26.0, 30.0  # px
MOST_LETTERS = 36
SHADES = 4
TICKS = (0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 30.0, 60.0, 120.0, 300.0, 600.0, 1800.0, 3600.0, 7200.0)
MOMENT_S = 1.0  # before and after what was found
LONGEST_MOMENT_S = 30.0
MOST_TICKS = 400  # of samples on a lane
STRIP_BINS, STRIP_WIDTH, STRIP_HEIGHT = 24, 96.0, 20.0


def draw_timeline(evidence: Evidence, findings: Sequence[Finding] = ()) -> str:
    """Return when each moving edge was heard, as SVG; "" if nothing moves."""
    edges = [edge for edge in evidence.moving if len(edge) > 1][:MOST_LANES]
    if not edges:
        return ""
    begin_ns, end_ns = evidence.begin_ns, max(int(edge.receive_ns.max()) for edge in edges)
    bounds_ns = np.linspace(begin_ns, max(end_ns, begin_ns + 1), BINS + 1)
    lanes = [_shaded_lane(edge, row, bounds_ns) for row, edge in enumerate(edges)]
    marks = [_mark(f, edges, begin_ns, end_ns) for f in findings if f.begin_ns and f.severity != "info"]
    return _sheet(edges, [*marks, *lanes], 0.0, (end_ns - begin_ns) / NSEC_PER_SEC, "timeline")


def draw_moment(evidence: Evidence, finding: Finding) -> str:
    """Return the samples around what was found, one by one, as SVG; "" if it is about no moment."""
    length_s = max(finding.end_ns - finding.begin_ns, 0) / NSEC_PER_SEC
    if not finding.begin_ns:
        return ""
    begin_ns = finding.begin_ns - round(MOMENT_S * NSEC_PER_SEC)
    end_ns = finding.begin_ns + round((min(length_s, LONGEST_MOMENT_S) + MOMENT_S) * NSEC_PER_SEC)
    concerned = {finding.child, *finding.siblings}
    edges = [edge for edge in evidence.moving if edge.child in concerned] or list(evidence.moving)
    edges = edges[:MOST_LANES_OF_A_MOMENT]
    if not edges:
        return ""
    marks = [_mark(finding, edges, begin_ns, end_ns)]
    lanes = [_ticked_lane(edge, row, begin_ns, end_ns) for row, edge in enumerate(edges)]
    first_s = (begin_ns - evidence.begin_ns) / NSEC_PER_SEC
    last_s = (end_ns - evidence.begin_ns) / NSEC_PER_SEC
    return _sheet(edges, [*marks, *lanes], first_s, last_s, "moment")


def draw_distribution(values: np.ndarray) -> str:
    """Return how values are distributed, as a small strip of SVG."""
    if len(values) < 2:
        return ""
    low, high = (float(value) for value in np.percentile(values, (0.5, 99.5)))
    counts, _ = np.histogram(np.clip(values, low, high), STRIP_BINS, (low, high if high > low else low + 1.0))
    step, tallest = STRIP_WIDTH / STRIP_BINS, max(int(counts.max()), 1)
    bars = "".join(
        f'<rect x="{i * step:.1f}" y="{STRIP_HEIGHT * (1 - n / tallest):.1f}" width="{step - 0.6:.1f}"'
        f' height="{STRIP_HEIGHT * n / tallest:.1f}"/>'
        for i, n in enumerate(counts.tolist())
        if n
    )
    return f'<svg class="strip" viewBox="0 0 {STRIP_WIDTH:.0f} {STRIP_HEIGHT:.0f}" aria-hidden="true">{bars}</svg>'


def draw_shares(shares: Sequence[float]) -> str:
    """Return a bar of what works at once, dark, and after each longer wait, paler, as a small strip of SVG."""
    bars = [f'<rect y="4" width="{STRIP_WIDTH:.0f}" height="12" fill="none" stroke="currentColor"/>']
    for i, share in reversed(list(enumerate(shares))):  # the longest first: where bars cover each other, it is darker
        bars.append(f'<rect y="4" width="{STRIP_WIDTH * share:.1f}" height="12" opacity="{0.3 if i else 1.0}"/>')
    size = f"0 0 {STRIP_WIDTH:.0f} {STRIP_HEIGHT:.0f}"
    return f'<svg class="strip" viewBox="{size}" aria-hidden="true">{"".join(bars)}</svg>'


def _sheet(edges: list[Edge], drawn: list[str], first_s: float, last_s: float, kind: str) -> str:
    """Return lanes with their names and the axis of time below."""
    bottom = RIM + LANE * len(edges)
    names = "".join(
        f'<text x="{NAMES - 10:.0f}" y="{RIM + LANE * (row + 0.62):.1f}" text-anchor="end">{escape(_name(edge))}'
        f"<title>{escape(f'{edge.usual_parent} -> {edge.child}')}</title></text>"
        for row, edge in enumerate(edges)
    )
    axis = []
    for moment_s in _ticks(first_s, last_s):
        x = _x_of(moment_s, first_s, last_s)
        axis.append(f'<line class="grid" x1="{x:.1f}" y1="{RIM:.0f}" x2="{x:.1f}" y2="{bottom:.1f}"/>')
        axis.append(f'<text class="tick" x="{x:.1f}" y="{bottom + 18:.1f}" text-anchor="middle">{moment_s:g} s</text>')
    return (
        f'<svg class="{kind}" viewBox="0 0 {WIDTH:.0f} {bottom + AXIS:.0f}" role="img" aria-label="{kind}">'
        f"{''.join(axis)}{''.join(drawn)}{names}</svg>"
    )


def _shaded_lane(edge: Edge, row: int, bounds_ns: np.ndarray) -> str:
    """Return where an edge spoke: darker where it said more, in a few shades, one path for each."""
    spoke, _ = np.histogram(edge.receive_ns, bounds_ns)
    usual = max(float(np.median(spoke[spoke > 0])), 1.0) if spoke.any() else 1.0
    # one sample less in a bin is no silence: where bins and periods do not fit, that happens again and again
    shade = np.where(spoke > 0, np.minimum(np.ceil(SHADES * (spoke + 1) / usual), SHADES), 0).astype(int)
    step = (WIDTH - NAMES - RIM) / BINS
    top = RIM + LANE * row + 4
    paths = []
    for level in range(1, SHADES + 1):
        pieces = [f"M{NAMES + i * step:.1f} {top:.1f}h{step:.2f}v{LANE - 12:.0f}h-{step:.2f}z"
                  for i in np.flatnonzero(shade == level).tolist()]  # fmt: skip
        if pieces:
            paths.append(f'<path class="spoke" opacity="{0.2 + 0.7 * level / SHADES:.2f}" d="{"".join(pieces)}"/>')
    return "".join(paths)


def _ticked_lane(edge: Edge, row: int, begin_ns: int, end_ns: int) -> str:
    inside = np.flatnonzero((edge.receive_ns >= begin_ns) & (edge.receive_ns <= end_ns))
    inside = inside[:: len(inside) // MOST_TICKS + 1]
    top = RIM + LANE * row + 4
    heard = (edge.receive_ns[inside] - begin_ns) / max(end_ns - begin_ns, 1)
    ticks = "".join(
        f"M{NAMES + (WIDTH - NAMES - RIM) * share:.1f} {top:.1f}v{LANE - 12:.0f}" for share in heard.tolist()
    )
    return f'<path class="heard" d="{ticks}"/>' if ticks else ""


def _mark(finding: Finding, edges: list[Edge], begin_ns: int, end_ns: int) -> str:
    """Return a finding's place in time: under its lane, or behind all if it is about all of them."""
    children = [edge.child for edge in edges]
    rows = [children.index(child) for child in (finding.child, *finding.siblings) if child in children]
    if finding.child and not rows:
        return ""
    if not finding.child and finding.code not in ABOUT_ALL:
        return ""
    length_ns = max(end_ns - begin_ns, 1)
    share, last = ((np.clip(moment, begin_ns, end_ns) - begin_ns) / length_ns for moment in
                   (finding.begin_ns, max(finding.end_ns, finding.begin_ns)))  # fmt: skip
    x = NAMES + (WIDTH - NAMES - RIM) * float(share)
    width = max((WIDTH - NAMES - RIM) * float(last - share), 3.0)
    if not rows:
        return f'<rect class="band" x="{x:.1f}" y="{RIM:.0f}" width="{width:.1f}" height="{LANE * len(edges):.0f}"/>'
    return "".join(
        f'<rect class="mark" x="{x:.1f}" y="{RIM + LANE * row + LANE - 6:.1f}" width="{width:.1f}" height="3"/>'
        for row in rows
    )


ABOUT_ALL = ("stall", "clock-set", "tf-silent", "clock-jump-back", "clock-jump-forward", "gap", "went-silent")


def _ticks(first_s: float, last_s: float) -> list[float]:
    """Return five to ten round moments between two [s]."""
    length_s = max(last_s - first_s, 1e-3)
    step_s = next((step for step in TICKS if length_s / step <= 9.0), length_s / 8.0)
    first = int(np.ceil(first_s / step_s))
    return [round(i * step_s, 3) + 0.0 for i in range(first, int(np.floor(last_s / step_s)) + 1)]


def _x_of(moment_s: float, first_s: float, last_s: float) -> float:
    return NAMES + (WIDTH - NAMES - RIM) * (moment_s - first_s) / max(last_s - first_s, 1e-3)


def _name(edge: Edge) -> str:
    name = f"{edge.usual_parent} -> {edge.child}"
    return name if len(name) <= MOST_LETTERS else f"{name[: MOST_LETTERS - 1]}…"


MOST_FRAMES = 80
VIEW_WIDTH, VIEW_HEIGHT, RADIUS = 460.0, 340.0, 130.0  # px
CORNER, ABOVE = (-0.6, 0.5), (0.0, np.pi / 2)  # yaw and pitch of the eye [rad]
LEAST_SIZE_M = 0.3
ARM = 0.14  # of the size of what is shown
NEAR = 3.0  # times the usual distance
LETTER, LINE = 6.8, 13.0  # px, of a name


def draw_frames_at(evidence: Evidence, moment_ns: int, first: tuple[str, ...] = ()) -> str:
    """Return the frames as they were at a moment, all of them and a robot's size of them from nearer, as SVG.

    Args:
        first: the frames that matter most: they are in the middle of the second picture, and have a name in both.
    """
    poses = poses_at(evidence, moment_ns)
    if not poses:  # every frame is in a loop
        return ""
    near = _near(poses, [frame for frame in first if frame in poses])
    views = [_view(evidence, poses, CORNER, "all frames", first)]
    if len(near) < len(poses):
        views.append(_view(evidence, near, CORNER, "close by", first))
    else:
        views.append(_view(evidence, poses, ABOVE, "from above", first))
    return "".join(views)


def poses_at(evidence: Evidence, moment_ns: int) -> dict[str, Transform]:
    """Return root_T_frame of each frame at a moment, parents before children."""
    edges = {edge.child: edge for edge in evidence.edges()}
    poses: dict[str, Transform] = {}
    for root, frames in evidence.trees.items():
        poses[root] = Transform()
        waiting = [frame for frame in frames if frame != root]
        while waiting and len(poses) < MOST_FRAMES:
            frame = next(frame for frame in waiting if evidence.parent_of[frame] in poses)
            waiting.remove(frame)
            poses[frame] = poses[evidence.parent_of[frame]] @ _value_at(edges[frame], moment_ns)
    return poses


def _value_at(edge: Edge, moment_ns: int) -> Transform:
    """Return the last usable value that was heard up to a moment, or the first after it."""
    usable = np.flatnonzero(edge.is_usable)
    if not len(usable):
        return Transform()
    heard = usable[edge.receive_ns[usable] <= moment_ns]
    row = edge.source[edge.rows[int(heard[-1] if len(heard) else usable[0])]].tolist()
    length = float(np.linalg.norm(row[3:]))
    return Transform(tuple(row[:3]), tuple(value / length for value in row[3:]))


def _near(poses: dict[str, Transform], first: list[str]) -> dict[str, Transform]:
    """Return the frames around the first of those that matter, or where most are, without map and odom far away."""
    origins = np.array([pose.translation for pose in poses.values()])
    middle = np.array(poses[first[-1]].translation) if first else np.median(origins, axis=0)
    away_m = np.linalg.norm(origins - middle, axis=1)
    reach_m = max(LEAST_SIZE_M, NEAR * float(np.median(away_m)))
    return {frame: pose for (frame, pose), m in zip(poses.items(), away_m.tolist(), strict=True) if m <= reach_m}


def _view(evidence: Evidence, poses: dict[str, Transform], eye: tuple, caption: str, first: tuple[str, ...]) -> str:
    origins = np.array([pose.translation for pose in poses.values()])
    middle = (origins.min(axis=0) + origins.max(axis=0)) / 2
    size_m = max(LEAST_SIZE_M, float(np.linalg.norm(origins - middle, axis=1).max()))
    links, axes, places = [], [], {}
    for frame, pose in poses.items():
        x, y = places[frame] = _flat(np.array(pose.translation) - middle, size_m, eye)
        parent = evidence.parent_of.get(frame)
        if parent in poses:
            to_x, to_y = _flat(np.array(poses[parent].translation) - middle, size_m, eye)
            links.append(_line("link", x, y, to_x, to_y))
        for axis, tip in zip("xyz", np.eye(3) * ARM * size_m, strict=True):
            end = _flat(np.array(pose.apply(tuple(tip.tolist()))) - middle, size_m, eye)
            axes.append(_line(f"axis-{axis}", x, y, *end))
    told = f'<text class="view" x="8" y="{VIEW_HEIGHT - 10:.0f}">{caption}</text>'
    drawn = "".join([*links, *axes, *_names(places, first), told])
    box = f'viewBox="0 0 {VIEW_WIDTH:.0f} {VIEW_HEIGHT:.0f}"'
    return f'<svg class="frames" {box} role="img" aria-label="{caption}">{drawn}</svg>'


def _names(places: dict[str, tuple[float, float]], first: tuple[str, ...]) -> list[str]:
    """Return the names that fit, those that matter first; where one would cover another, pointing at the dot tells."""
    drawn, taken = [], []
    for frame in sorted(places, key=lambda frame: (frame not in first, list(places).index(frame))):
        x, y = places[frame]
        length = LETTER * len(frame)
        left, base = min(x + 5.0, VIEW_WIDTH - length - 4.0), y + 13.0
        box = (left, base - LINE, left + length, base)
        drawn.append(f'<circle class="dot" cx="{x:.1f}" cy="{y:.1f}" r="3"><title>{escape(frame)}</title></circle>')
        if any(box[0] < b[2] and b[0] < box[2] and box[1] < b[3] and b[1] < box[3] for b in taken):
            continue
        taken.append(box)
        drawn.append(f'<text x="{left:.1f}" y="{base:.1f}">{escape(frame)}</text>')
    return drawn


def _flat(point: np.ndarray, size_m: float, eye: tuple[float, float]) -> tuple[float, float]:
    """Return where a point stands on the page, seen by an eye that looks down by `pitch` after a turn by `yaw`."""
    yaw, pitch = eye
    x, y, z = (point * RADIUS / size_m).tolist()
    right = np.cos(yaw) * x - np.sin(yaw) * y
    ahead = np.sin(yaw) * x + np.cos(yaw) * y
    return float(VIEW_WIDTH / 2 + right), float(VIEW_HEIGHT / 2 - np.cos(pitch) * z - np.sin(pitch) * ahead)


def _line(kind: str, x: float, y: float, to_x: float, to_y: float) -> str:
    return f'<line class="{kind}" x1="{x:.1f}" y1="{y:.1f}" x2="{to_x:.1f}" y2="{to_y:.1f}"/>'
