"""Whose clock is it?  Step 5 of the lecture's order: stamps and receipt must tell the same story.

    receipt   |----|----|----|----|----|
    stamps    |----|----|  |----|----|        the clock was set back: a bag in a loop, a simulator
                          back                that was reset, NTP after the start

All publishers together: it is the time source.  One of them: it is that computer.
Read `statics.py` next.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from tflab.core import NSEC_PER_SEC

from .evidence import Edge, Evidence
from .findings import Finding
from .motion import Jump, clock_jumps

__all__ = ["clock_offset", "jumping_clocks", "other_time_source"]

TOGETHER_NS = 2 * NSEC_PER_SEC  # jumps this close to each other are one event
OFFSET_S = 0.1


def jumping_clocks(evidence: Evidence) -> Iterator[Finding]:
    """Yield a finding for each moment at which a clock was set, of one edge or of several."""
    jumps = sorted(
        ((int(edge.receive_ns[jump.index]), edge, jump) for edge in evidence.moving for jump in clock_jumps(edge)),
        key=lambda entry: entry[0],
    )
    events: list[list[tuple[int, Edge, Jump]]] = []
    for entry in jumps:
        if events and entry[0] - events[-1][0][0] < TOGETHER_NS and _same_way(entry[2], events[-1][0][2]):
            events[-1].append(entry)
        else:
            events.append([entry])
    for event in events:
        moment_ns, edge, _ = event[0]
        size_s = float(np.median([jump.size_s for *_, jump in event]))
        edges = sorted({f"{e.usual_parent} -> {e.child}" for _, e, _ in event})
        facts = {"size": f"{abs(size_s):.3f}", "edges": ", ".join(edges), "count": len(edges)}
        code = "clock-jump-back" if size_s < 0 else "clock-jump-forward"
        only = edge if len(edges) == 1 else None
        parent, child = (only.usual_parent, only.child) if only else ("", "")
        yield Finding(
            code, "error" if size_s < 0 else "warning", parent, child, edge.topic, moment_ns, moment_ns, facts
        )


def other_time_source(evidence: Evidence) -> Iterator[Finding]:
    """Yield a note if stamps come from another clock than the times of receipt, as in simulation."""
    if evidence.clock.source != "same":
        difference_s = evidence.clock.difference_s
        drift_ms = 1e3 * float(difference_s[-1] - difference_s[0])
        facts = {
            "source": evidence.clock.source,
            "difference": f"{np.median(difference_s):.3f}",
            "drift": f"{drift_ms:.0f}",
        }
        yield Finding("other-clock", "info", facts=facts)


def clock_offset(evidence: Evidence) -> Iterator[Finding]:
    """Yield a finding if everything is stamped early, or late, by the same amount."""
    sources = [source for source in (*evidence.moving, *evidence.headers) if len(source.stamp_ns) > 7]
    sources = [source for source in sources if source.stamp_ns.all()]
    if not sources or evidence.clock.source != "same":
        return
    usual_s = np.array([float(np.median(evidence.delay_s(source))) for source in sources])
    common_s = float(np.median(usual_s))
    near = np.abs(usual_s - common_s) < max(0.05, 0.1 * abs(common_s))
    if abs(common_s) > OFFSET_S and near.mean() > 0.5:
        facts = {
            "offset": f"{abs(common_s):.3f}",
            "way": "after" if common_s > 0 else "before",
            "count": int(near.sum()),
        }
        yield Finding("clock-offset", "warning", facts=facts)


def _same_way(a: Jump, b: Jump) -> bool:
    return abs(a.size_s - b.size_s) < 0.2 * max(abs(a.size_s), abs(b.size_s)) + 0.05
