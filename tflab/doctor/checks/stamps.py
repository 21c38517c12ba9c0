"""Check the stamps of each edge: unset, repeated, out of order, in the future, or too long before receipt.

```
o--o--o--o--o--o          as it should be
o--o==o--o                the same stamp twice
o--o-----o                one came late: tf2 sorts it in, if it is not too old
       `--o
o--o--o-----/ /-----o     one stamp far ahead: whatever comes after is old, and refused

stamp     o    o    o    o    o
received   o    o      o    o    o      late: a slow node, or its clock is behind
received o    o    o                    early: a clock that is ahead, or a localiser's tolerance
received ............... years          another source of time: use_sim_time
```

A localiser stamps map -> odom ahead so that lookups between two of its corrections
succeed; nobody else may.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from tflab.bags.recording import Headers
from tflab.core import NSEC_PER_SEC
from tflab.text import Text

from ..evidence import SAME_CLOCK_NS, Edge, Evidence, OtherSamples, is_stamped, part_of
from ..findings import Finding, Severity
from .clocks import settled_delays_s
from .time_bases import CACHE_S, LONGEST_WAIT_S, finding_of_sources, has_copied_stamps, in_groups

__all__ = ["future_stamps", "odd_delays", "odd_message_delays", "repeated_stamps", "unordered_stamps",
           "unset_stamps"]  # fmt: skip

FEWEST_REPEATED = 3  # stamps, before it is more than a slip ...
REPEATED_SHARE = 0.002  # ... and their share of an edge
FROZEN_S, FROZEN_PERIODS = 1.0, 5.0  # for which one stamp is repeated
FEWEST_UNORDERED = 3
FUTURE_S = 5.0  # ahead of the others of its edge
FEW = 0.05  # of an edge: more is a clock that was set


def repeated_stamps(evidence: Evidence) -> Iterator[Finding]:
    """Yield a finding for each moving edge with several samples of one stamp."""
    yield from _frozen_stamps(evidence)
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
        values = _values_of_repeats(edge, repeats)
        is_harmless = values.en == "the same" or len(repeats) < max(FEWEST_REPEATED, REPEATED_SHARE * len(edge))
        severity = "info" if is_harmless or _has_stamps_of_a_slow_clock(evidence, edge) else "warning"
        facts = {"count": len(repeats), "total": len(edge), "values": values}
        yield _finding(edge, "repeated-stamps", severity, repeats[0], repeats[-1], facts)


def _frozen_stamps(evidence: Evidence) -> Iterator[Finding]:
    """Yield a finding for the edges that repeat one stamp from some time on, while other stamps advance."""
    frozen = []
    for edge in evidence.moving if evidence.has_arrival else ():
        bounds = np.flatnonzero(np.diff(edge.stamp_ns, prepend=-1, append=-1))
        longest = int(np.argmax(np.diff(bounds)))
        run = part_of(edge, slice(*bounds[longest : longest + 2]))
        span_s = float(np.ptp(evidence.delay_s(run))) if len(run) >= FEWEST_SAMPLES and is_stamped(edge) else 0.0
        if span_s > max(FROZEN_S, FROZEN_PERIODS * edge.period_ns / NSEC_PER_SEC):
            frozen.append(OtherSamples(run, len(edge)))
    for group in in_groups(frozen, lambda a, b: a.source.stamp_ns[0] == b.source.stamp_ns[0]):
        sources = [part.source for part in group]
        facts = {"count": sum(map(len, sources)), "total": sum(part.total for part in group),
                 "stamp": f"{sources[0].stamp_ns[0] / NSEC_PER_SEC:.1f}"}  # fmt: skip
        severity = "error" if np.ptp(sources[0].receive_ns) > CACHE_S * NSEC_PER_SEC else "warning"
        yield finding_of_sources("time-frozen", severity, sources, facts)


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
            facts = {"count": len(unset), "total": len(edge), "stamp": "0.0"}
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


def _has_stamps_of_a_slow_clock(evidence: Evidence, edge: Edge) -> bool:
    """Return whether /clock comes no more often than an edge, whose stamps then repeat."""
    return evidence.clock.resolution_s > 1.35 * float(np.median(np.diff(edge.receive_ns))) / NSEC_PER_SEC


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


FEWEST_SAMPLES = 8
ODD_SHARE = 0.1  # of the samples of an edge
LATE_S = 0.1  # more than the others: at 1 m/s an error of 10 cm
EARLY_S = 0.05
MESSAGE_EARLY_S = 0.1  # a scan may be stamped at its end, a little after it is published
MESSAGE_LATE_S = 2.0  # finding things in a picture takes time, but a buffer forgets
QUICK = re.compile(r"LaserScan|Imu|JointState|Odometry|Range|NavSatFix")
QUICK_LATE_S = 0.5  # nothing is looked for in these
TOLERANCE_S = 3.0  # how far ahead a localiser may stamp map -> odom (AMCL's transform_tolerance is 1 s)
OTHER_TIME_S = SAME_CLOCK_NS / NSEC_PER_SEC
ONE_HOST_S = 0.02  # between the offsets of topics of one host
SWEEP_S = 0.15  # between those of one driver: what is measured for a while may be stamped at its beginning
TAI_S, TAI_SLACK_S = 37.0, 0.05  # ahead of UTC
MAP = re.compile(r"(^|[/_])map$")
ODOM = re.compile(r"(^|[/_])odom")


def odd_delays(evidence: Evidence) -> Iterator[Finding]:
    """Yield a finding for each moving edge that is, or was for a while, much earlier or later than the others."""
    delays_s = settled_delays_s(evidence)
    usual_s = [_usual_delay_s(edge, delay_s) for edge, delay_s in zip(evidence.moving, delays_s, strict=True)]
    of_messages_s = [_usual_delay_s(header, evidence.delay_s(header)) for header in evidence.headers]
    early_s = max(EARLY_S, evidence.clock.resolution_s)
    for place, (edge, delay_s) in enumerate(zip(evidence.moving, delays_s, strict=True)):
        if len(edge) < FEWEST_SAMPLES or not is_stamped(edge):
            continue
        if abs(usual_s[place]) > OTHER_TIME_S:
            continue  # see other_times
        # of the other source that has the least; 0 if there is none, or it is ahead
        others_s = max(0.0, min([*usual_s[:place], *usual_s[place + 1 :], *of_messages_s, math.inf]))
        others_s = 0.0 if math.isinf(others_s) else others_s
        late_s = others_s + max(LATE_S, 2.0 * others_s)
        for code, is_odd in (("early-stamps", delay_s < -early_s), ("late-stamps", delay_s > late_s)):
            odd = _in_a_row(is_odd)
            if len(odd) < max(FEWEST_SAMPLES, ODD_SHARE * len(edge)):
                continue
            odd_s = float(np.median(delay_s[odd]))
            spread_s = float(np.percentile(delay_s[odd], 90) - np.percentile(delay_s[odd], 10))
            facts = {"delay": f"{abs(odd_s):.3f}", "others": f"{others_s:.3f}", "spread": f"{spread_s:.3f}",
                     "count": len(odd), "total": len(edge)}  # fmt: skip
            if code == "early-stamps" and _may_be_ahead(evidence, edge) and -odd_s < TOLERANCE_S:
                yield _finding(edge, "stamped-ahead", "info", int(odd[0]), int(odd[-1]), facts)
            else:
                code = "time-tai" if _is_tai(odd_s) else code
                severity, facts["never"] = _severity_of_delay(odd_s)
                finding = _finding(edge, code, severity, int(odd[0]), int(odd[-1]), facts)
                yield replace(finding, siblings=_topics_of_one_node(evidence, edge, odd_s))


def _topics_of_one_node(evidence: Evidence, edge: Edge, odd_s: float) -> tuple[str, ...]:
    """Return the topics with the stamps of an edge that are about as late, or early, as it is [s]."""
    usual_s = [_usual_delay_s(header, evidence.delay_s(header)) for header in evidence.headers]
    alike = [h for h, s in zip(evidence.headers, usual_s, strict=True) if abs(s - odd_s) < 0.5 * abs(odd_s)]
    return tuple(header.topic for header in alike if has_copied_stamps(edge, header))


def odd_message_delays(evidence: Evidence) -> Iterator[Finding]:
    """Yield a finding for each device whose messages are stamped ahead of the transforms, or long before them."""
    odd = []
    for header in evidence.headers if evidence.moving else ():
        usual_s = _usual_delay_s(header, evidence.delay_s(header))
        late_s = QUICK_LATE_S if QUICK.search(header.msgtype) else MESSAGE_LATE_S
        if not -MESSAGE_EARLY_S <= usual_s <= late_s and abs(usual_s) <= OTHER_TIME_S:
            odd.append((usual_s, header))

    def is_one_device(a: tuple[float, Headers], b: tuple[float, Headers]) -> bool:
        is_one_driver = a[1].topic.split("/")[:2] == b[1].topic.split("/")[:2]
        return a[0] * b[0] > 0.0 and abs(a[0] - b[0]) < (SWEEP_S if is_one_driver else ONE_HOST_S)

    for group in in_groups(odd, is_one_device):
        usual_s = group[0][0]
        severity, never = _severity_of_delay(usual_s)
        count = sum(len(header.stamp_ns) for _, header in group)
        facts = {"delay": f"{abs(usual_s):.3f}", "count": count, "never": never}
        code = "messages-late" if usual_s > 0.0 else "time-tai" if _is_tai(usual_s) else "messages-early"
        yield finding_of_sources(code, severity, [header for _, header in group], facts)


def _is_tai(delay_s: float) -> bool:
    return abs(delay_s + TAI_S) < SWEEP_S + TAI_SLACK_S


def _severity_of_delay(delay_s: float) -> tuple[Severity, Text | str]:
    """Return "error", and why, for what can never be looked up."""
    if delay_s > CACHE_S:
        text = f" tf2 keeps {CACHE_S:.0f} s: no lookup combines it with the others."
        return "error", Text(text, f" tf2의 보관 시간은 {CACHE_S:.0f} s이므로 다른 변환과 함께 조회할 수 없습니다.")
    if delay_s < -LONGEST_WAIT_S:
        return "error", Text(" No lookup waits so long.", " 조회가 이만큼 오래 기다리지는 않습니다.")
    return "warning", ""


def _usual_delay_s(source: Edge | Headers, delay_s: np.ndarray) -> float:
    """Return the usual delay of a source [s]; infinity if it says too little."""
    return float(np.median(delay_s)) if len(delay_s) >= FEWEST_SAMPLES and is_stamped(source) else math.inf


def _in_a_row(is_odd: np.ndarray) -> np.ndarray:
    """Return the places of odd samples among others like them: one alone was overtaken, or repeats a stamp."""
    bounds = np.flatnonzero(np.diff(np.concatenate([[False], is_odd, [False]]).astype(int)))
    runs = [np.arange(a, b) for a, b in bounds.reshape(-1, 2).tolist() if b - a >= FEWEST_SAMPLES]
    return np.concatenate(runs) if runs else np.zeros(0, dtype=np.int64)


def _may_be_ahead(evidence: Evidence, edge: Edge) -> bool:
    """Return whether an edge is a localiser's: under map, or the one at the top of the tree, above others."""
    if any(MAP.search(parent) for parent in edge.parents):
        return True
    is_top = edge.usual_parent not in evidence.parent_of and not ODOM.search(edge.usual_parent)
    moving_children = {other.child for other in evidence.moving}
    return is_top and any(evidence.parent_of[child] == edge.child for child in moving_children)
