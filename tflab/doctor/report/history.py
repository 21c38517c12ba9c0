"""When was what heard, and how late?  The timeline of a recording, as SVG that follows the page's colours.

    odom -> base_link   |||||||||||||||||    |||||||||||||||   a lane for each edge: dark where it spoke
    map -> odom         | | | | | | | | | | | | | | | | | |    and a gap where it was silent
                                        ====                   what was found, under its lane

    4 ms  .:|:..      how its delays, and the steps between its samples, are distributed

Only what moves has a lane; what is static was said once.
"""

from __future__ import annotations

from collections.abc import Sequence
from html import escape

import numpy as np

from tflab.core import NSEC_PER_SEC

from ..evidence import Edge, Evidence
from ..findings import Finding

__all__ = ["draw_distribution", "draw_moment", "draw_timeline"]

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


ABOUT_ALL = ("stall", "tf-silent", "clock-jump-back", "clock-jump-forward", "gap", "went-silent")


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
