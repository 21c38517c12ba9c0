"""Check lookups at the stamps of messages: those that never work, and those that wait longer than a topic's period.

stamps of scans       |    |    |    |           one every 50 ms
odometry received        |    |    |    |        60 ms later: a queue that holds one scan drops each of them
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from tflab.core import NSEC_PER_SEC
from tflab.text import Text

from ..evidence import Evidence, LookupRow
from ..findings import Finding, Severity, first_of
from ..lookups import CACHE_NS, WAITS_S
from .names import OF_THE_WORLD, SPATIAL

__all__ = ["failing_lookups", "text_of_shares"]

FEWEST_MESSAGES = 8
QUEUED = re.compile(r"LaserScan|PointCloud")  # message filters hold these back until the transform is there
MOST_TOPICS = 6  # that are named


def failing_lookups(evidence: Evidence) -> Iterator[Finding]:
    """Yield a finding for each edge without which no lookup of a sensor works, or for which scans wait too long."""
    kind_of = {header.topic: header.msgtype for header in evidence.headers}
    groups: dict[tuple[str, Severity, str], list[LookupRow]] = {}
    for row in evidence.lookups:
        kind = kind_of[row.topic]
        if row.count < FEWEST_MESSAGES or not row.child or not SPATIAL.search(kind) or OF_THE_WORLD.search(kind):
            continue
        fault = _fault_of(row, is_queued=bool(QUEUED.search(kind)))
        if fault:
            groups.setdefault((*fault, row.child), []).append(row)
    for (code, severity, child), rows in groups.items():
        first = rows[0]
        facts = {
            "topics": first_of(list(dict.fromkeys(row.topic for row in rows)), MOST_TOPICS),
            "fixed": ", ".join(dict.fromkeys(row.fixed for row in rows)),
            "shares": text_of_shares(first),
            "wait": f"{first.wait_ns / NSEC_PER_SEC:.3f}",
            "period": f"{first.period_ns / NSEC_PER_SEC:.3f}",
        }
        yield Finding(code, severity, first.parent, child, first.topic, facts=facts)


def _fault_of(row: LookupRow, *, is_queued: bool) -> tuple[str, Severity] | None:
    """Return the code and the severity of what is wrong with a lookup; None if it works soon enough."""
    if row.wait_ns > CACHE_NS and row.shares[-1] == 0.0:
        return "lookups-fail", "error"
    if CACHE_NS >= row.wait_ns > row.period_ns and (is_queued or row.shares[1] < 0.5):
        return "lookups-wait", "warning" if is_queued else "info"
    return None


def text_of_shares(row: LookupRow) -> Text:
    """Return the shares of a row: "/scan in odom: 0 % at once, 100 % after 0.1 s, ..."."""
    shares = [f"{100.0 * share:.0f} %" for share in row.shares]
    later = ", ".join(f"{share} after {wait_s:g} s" for share, wait_s in zip(shares[1:], WAITS_S[1:], strict=True))
    ko = ", ".join(f"{wait_s:g} s 뒤 {share}" for share, wait_s in zip(shares[1:], WAITS_S[1:], strict=True))
    en = f"{row.topic} in {row.fixed}: {shares[0]} at once, {later}"
    return Text(en, f"{row.topic}, {row.fixed} 기준: 바로 {shares[0]}, {ko}")
