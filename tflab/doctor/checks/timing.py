"""Is it there in time?  Question 4, first part: are the stamps set, in order, and each another?

```
o--o--o--o--o--o          as it should be
o--o==o--o                the same stamp twice
o--o-----o                one came late: tf2 sorts it in, if it is not too old
       `--o
o--o--o-----/ /-----o     one stamp far ahead: whatever comes after is old, and refused
```
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from tflab.core import NSEC_PER_SEC
from tflab.text import Text

from ..evidence import Edge, Evidence, is_stamped
from ..findings import Finding
from .clocks import settled_delays_s

__all__ = ["future_stamps", "repeated_stamps", "unordered_stamps", "unset_stamps"]

FEWEST_REPEATED = 3  # stamps, before it is more than a slip ...
REPEATED_SHARE = 0.002  # ... and their share of an edge
FEWEST_UNORDERED = 3
CACHE_S = 10.0  # what tf2 keeps as a rule
FUTURE_S = 5.0  # ahead of the others of its edge
FEW = 0.05  # of an edge: more is a clock that was set


def repeated_stamps(evidence: Evidence) -> Iterator[Finding]:
    """Yield a finding for each moving edge with several samples of one stamp."""
    for edge in evidence.moving:
        repeats = []
        for stretch in edge.stretches():
            stamps = edge.stamp_ns[stretch]
            order = np.argsort(stamps, kind="stable")
            again = order[1:][np.diff(stamps[order]) == 0]
            repeats.extend((stretch.start + again).tolist())
        if not repeats or not is_stamped(edge):
            continue
        repeats.sort()
        severity = "warning" if len(repeats) >= max(FEWEST_REPEATED, REPEATED_SHARE * len(edge)) else "info"
        facts = {"count": len(repeats), "total": len(edge), "values": _values_of_repeats(edge, repeats)}
        yield _finding(edge, "repeated-stamps", severity, repeats[0], repeats[-1], facts)


def unordered_stamps(evidence: Evidence) -> Iterator[Finding]:
    """Yield a finding for each moving edge whose samples did not arrive in the order of their stamps."""
    for edge in evidence.moving:
        back_s = []
        where = []
        for stretch in edge.stretches():
            stamps = edge.stamp_ns[stretch]
            behind = np.maximum.accumulate(stamps) - stamps
            late = np.flatnonzero(behind > 0)
            where.extend((stretch.start + late).tolist())
            back_s.extend((behind[late] / NSEC_PER_SEC).tolist())
        if where:
            severity = "warning" if len(where) >= FEWEST_UNORDERED else "info"
            severity = "error" if max(back_s) > CACHE_S else severity
            facts = {"count": len(where), "total": len(edge), "most": f"{max(back_s):.3f}"}
            yield _finding(edge, "unordered-stamps", severity, where[0], where[-1], facts)


def unset_stamps(evidence: Evidence) -> Iterator[Finding]:
    """Yield a finding for each moving edge with stamps of zero."""
    for edge in evidence.moving:
        unset = np.flatnonzero(edge.stamp_ns == 0)
        if not is_stamped(edge):
            facts = {"count": len(unset), "total": len(edge)}
            yield _finding(edge, "unset-stamps", "error", int(unset[0]), int(unset[-1]), facts)


def future_stamps(evidence: Evidence) -> Iterator[Finding]:
    """Yield a finding for each moving edge of which a few samples are stamped so far ahead that the rest is too old."""
    for edge, delay_s in zip(evidence.moving, settled_delays_s(evidence), strict=True):
        if len(edge) < FEWEST_REPEATED or not is_stamped(edge):
            continue
        ahead_s = float(np.median(delay_s)) - delay_s
        ahead = np.flatnonzero(ahead_s > FUTURE_S)
        if 0 < len(ahead) <= max(1.0, FEW * len(edge)):
            facts = {"count": len(ahead), "total": len(edge), "ahead": f"{ahead_s.max():.3f}"}
            yield _finding(edge, "future-stamp", "error", int(ahead[0]), int(ahead[-1]), facts)


def _values_of_repeats(edge: Edge, repeats: list[int]) -> Text:
    """Return whether samples of one stamp agree: "the same" or "different"."""
    numbers = edge.numbers
    first_of: dict[int, np.ndarray] = {}
    for i in repeats:
        stamp_ns = int(edge.stamp_ns[i])
        if stamp_ns not in first_of:
            first_of[stamp_ns] = numbers[int(np.argmax(edge.stamp_ns == stamp_ns))]
        if not np.array_equal(first_of[stamp_ns], numbers[i], equal_nan=True):
            return Text("different", "서로 다릅니다")
        if len(first_of) > 200:
            break
    return Text("the same", "같습니다")


def _finding(edge: Edge, code: str, severity, first: int, last: int, facts: dict) -> Finding:
    span = (int(edge.receive_ns[first]), int(edge.receive_ns[last]))
    return Finding(code, severity, edge.usual_parent, edge.child, edge.topic, *span, facts)
