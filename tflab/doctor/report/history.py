"""When was what heard, and how late?  The timeline of a recording as a picture.

    odom -> base_link   |||||||||||||||||    |||||||||||||||   a lane for each edge: dark where it spoke
    map -> odom         | | | | | | | | | | | | | | | | | |    and a gap where it was silent

    delay [ms]          ~~~~~~~~~~~~~~~~~/\\~~~~~~~~~~~~~~~    received minus stamp, clocks taken off

Only what moves has a lane; what is static was said once.  Findings that have a
place in time are marked on their lane.  Read `html.py` next.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from tflab.core import NSEC_PER_SEC
from tflab.views import style
from tflab.views.picture import Picture

from ..checks.clocks import settled_delays_s
from ..evidence import Edge, Evidence
from ..findings import Finding

__all__ = ["draw_history"]

MOST_LANES = 24
BINS = 380  # of a lane
LANE_INCH = 0.26
DELAYS_INCH = 1.7
RIM_INCH = 0.95
WIDTH_INCH = 9.6
MOST_LINES = 3  # of delays, those that vary most: more cannot be told apart
LINES = (style.INK, style.AXIS_COLOURS["z"], style.AXIS_COLOURS["x"])
STYLES = ("solid", (0, (4.0, 1.6)), (0, (1.0, 1.1)))


def draw_history(evidence: Evidence, findings: Sequence[Finding] = ()) -> Picture:
    """Draw when each moving edge was heard, and how late."""
    edges = [edge for edge in evidence.moving if len(edge) > 1][:MOST_LANES]
    delays_inch = DELAYS_INCH if evidence.has_arrival and edges else 0.0
    height = RIM_INCH + LANE_INCH * max(len(edges), 1) + delays_inch
    picture = Picture((WIDTH_INCH, height))
    longest = max((len(_name(edge)) for edge in edges), default=0)
    left = min(0.08 + 0.0072 * longest, 0.42)
    lanes_bottom = (delays_inch + 0.50) / height
    with style.our_settings():
        lanes = picture.figure.add_axes((left, lanes_bottom, 0.90 - left, 1.0 - lanes_bottom - 0.40 / height))
        _draw_lanes(lanes, evidence, edges, findings)
        if delays_inch:
            below = picture.figure.add_axes((left, 0.5 / height, 0.90 - left, (delays_inch - 0.45) / height))
            _draw_delays(below, evidence, edges)
    delays_s = _delays_s(evidence) if evidence.has_arrival else {}
    picture.text = "\n".join(_line(edge, delays_s.get(edge.child)) for edge in edges) or "nothing moves"
    return picture


def _draw_lanes(axes, evidence: Evidence, edges: list[Edge], findings: Sequence[Finding]) -> None:
    begin_ns, length_s = _span(evidence, edges)
    for row, edge in enumerate(edges):
        _draw_lane(axes, edge, row, (begin_ns, length_s), [f for f in findings if f.child == edge.child])
    for finding in findings:
        if not finding.child and finding.begin_ns and finding.severity != "info":
            begin_s, end_s = ((moment - begin_ns) / NSEC_PER_SEC for moment in (finding.begin_ns, finding.end_ns))
            axes.axvspan(begin_s, max(end_s, begin_s + 0.003 * length_s), color=style.ACCENT, alpha=0.18, zorder=1)
    axes.set(xlim=(0.0, length_s), ylim=(max(len(edges), 1) - 0.5, -0.6), yticks=range(len(edges)))
    axes.set_yticklabels([_name(edge) for edge in edges], color=style.INK)
    axes.tick_params(axis="y", length=0)
    axes.tick_params(axis="x", labelbottom=not evidence.has_arrival)
    axes.set_title("heard", loc="left", color=style.INK)
    for side in ("left", "right", "top"):
        axes.spines[side].set_visible(False)


def _draw_lane(axes, edge: Edge, row: int, span: tuple[int, float], findings: list[Finding]) -> None:
    """Draw when one edge was heard, and what was found of it."""
    begin_ns, length_s = span
    heard_s = (edge.receive_ns - begin_ns) / NSEC_PER_SEC
    spoke, _ = np.histogram(heard_s, np.linspace(0.0, length_s, BINS + 1))
    expected = max(np.median(spoke[spoke > 0]), 1) if spoke.any() else 1
    if edge.period_ns / NSEC_PER_SEC < length_s / BINS:
        shade = np.clip(spoke / expected, 0.0, 1.0)[None, :] * 0.75
        axes.imshow(_grey(shade), extent=(0.0, length_s, row + 0.32, row - 0.32), aspect="auto", zorder=2)
    else:
        axes.vlines(heard_s, row - 0.3, row + 0.3, color=style.GREY, linewidth=0.9, zorder=2)
    marked = [f for f in findings if f.begin_ns and f.severity != "info"]
    for finding in marked:
        begin_s = (finding.begin_ns - begin_ns) / NSEC_PER_SEC
        end_s = max((finding.end_ns - begin_ns) / NSEC_PER_SEC, begin_s + 0.004 * length_s)
        axes.plot([begin_s, end_s], [row + 0.42] * 2, color=style.ACCENT, linewidth=2.4, zorder=4)
    rate = f"{NSEC_PER_SEC / edge.period_ns:.1f} Hz" if edge.period_ns else ""
    axes.text(1.01, row, rate, transform=axes.get_yaxis_transform(), va="center", color=style.GREY,
              fontsize=style.SMALL_PT)  # fmt: skip


def _draw_delays(axes, evidence: Evidence, edges: list[Edge]) -> None:
    begin_ns, length_s = _span(evidence, edges)
    delays_s = _delays_s(evidence)
    shown = sorted(edges, key=lambda edge: -float(np.ptp(delays_s[edge.child])))[:MOST_LINES]
    bounds = np.linspace(0.0, length_s, BINS // 2 + 1)
    middles = (bounds[1:] + bounds[:-1]) / 2
    for edge, colour, line in zip(shown, LINES, STYLES, strict=False):
        which = np.digitize((edge.receive_ns - begin_ns) / NSEC_PER_SEC, bounds) - 1
        delay_ms = 1e3 * delays_s[edge.child]
        filled = [i for i in np.unique(which).tolist() if 0 <= i < len(middles)]
        level = [float(np.median(delay_ms[which == i])) for i in filled]
        axes.plot(middles[filled], level, color=colour, linestyle=line, linewidth=1.3, label=_name(edge))
    axes.axhline(0.0, color=style.FAINT, linewidth=0.8, zorder=0)
    axes.set(xlim=(0.0, length_s), xlabel="time since the beginning [s]")
    axes.set_title("delay [ms]", loc="left", color=style.INK)
    axes.margins(y=0.15)
    axes.legend(loc="lower right", bbox_to_anchor=(1.0, 1.0), borderpad=0.2, fontsize=style.SMALL_PT - 1.0,
                frameon=False, ncols=MOST_LINES, handlelength=2.6)  # fmt: skip
    for side in ("right", "top"):
        axes.spines[side].set_visible(False)


def _span(evidence: Evidence, edges: list[Edge]) -> tuple[int, float]:
    """Return the beginning [ns], and the length [s] of what is drawn."""
    end_ns = max((int(edge.receive_ns.max()) for edge in edges), default=evidence.end_ns)
    return evidence.begin_ns, max((end_ns - evidence.begin_ns) / NSEC_PER_SEC, 1e-3)


def _grey(shade: np.ndarray) -> np.ndarray:
    """Return an image of ink, more opaque where the shade is darker: shape (1, n, 4)."""
    ink = np.array([int(style.INK[i : i + 2], 16) / 255 for i in (1, 3, 5)])
    return np.concatenate([np.broadcast_to(ink, (*shade.shape, 3)), shade[:, :, None]], axis=2)


def _line(edge: Edge, delay_s: np.ndarray | None) -> str:
    """Return one edge in words."""
    rate = f"{NSEC_PER_SEC / edge.period_ns:.1f} Hz" if edge.period_ns else "no rate"
    silence_s = float(np.diff(edge.receive_ns).max()) / NSEC_PER_SEC
    text = f"{_name(edge)}: {len(edge)} samples, {rate}, longest silence {silence_s:.3f} s"
    if delay_s is None:
        return text
    return f"{text}, delay {1e3 * np.median(delay_s):.1f} ms (most {1e3 * delay_s.max():.1f} ms)"


def _delays_s(evidence: Evidence) -> dict[str, np.ndarray]:
    """Return the delays of each moving child [s]."""
    return {edge.child: delay_s for edge, delay_s in zip(evidence.moving, settled_delays_s(evidence), strict=True)}


def _name(edge: Edge) -> str:
    return f"{edge.usual_parent} -> {edge.child}"
