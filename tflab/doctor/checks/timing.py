"""Is it there in time?  Question 4: stamps in order, no gaps, no delay.

    o--o--o--o--o--o          as it should be
    o--o--o        o--o       a gap: no lookup in there, and a straight line across
    o--o==o--o                the same stamp twice
    o--o-----o                one came late: tf2 sorts it in, if it is not too old
           `--o

If *every* edge is silent at once, it is not the edges: the recorder, the network
or the computer stood still, and that is one event.  Read `clocks.py` next.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from tflab.bags.recording import Headers
from tflab.core import NSEC_PER_SEC

from ..evidence import Edge, Evidence, is_stamped
from ..findings import Finding
from .clocks import settled_delays_s
from .motion import distances, unit

__all__ = ["gaps", "odd_delays", "odd_message_delays", "repeated_stamps", "unordered_stamps", "unset_stamps"]

LEAST_GAP_S = 0.25
GAP_PERIODS = 5.0  # a gap is longer than so many usual steps ...
GAP_HABITS = 3.0  # ... and than so many of the longer steps of an irregular edge
FEWEST_SAMPLES = 8
ODD_SHARE = 0.1  # of the samples of an edge
ALIKE_SHARE = 0.25  # of its length: silences that begin and end within so much of each other are one event
FEWEST_REPEATED = 3  # stamps, before it is more than a slip ...
REPEATED_SHARE = 0.002  # ... and their share of an edge
LATE_S = 0.1  # more than the others: at 1 m/s an error of 10 cm
EARLY_S = 0.05
MESSAGE_EARLY_S = 0.1  # a scan may be stamped at its end, a little after it is published
MESSAGE_LATE_S = 2.0  # finding things in a picture takes time, but a buffer forgets
TOLERANCE_S = 1.5  # how far ahead a localiser may stamp map -> odom (AMCL's transform_tolerance is 1 s)


class Silence(NamedTuple):
    """One edge said nothing between two moments of receipt [ns]; it never spoke again if `is_last`."""

    edge: Edge
    begin_ns: int
    end_ns: int
    is_last: bool


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
            severity = "warning" if len(where) > 1 else "info"
            facts = {"count": len(where), "total": len(edge), "most": f"{max(back_s):.3f}"}
            yield _finding(edge, "unordered-stamps", severity, where[0], where[-1], facts)


def unset_stamps(evidence: Evidence) -> Iterator[Finding]:
    """Yield a finding for each moving edge with stamps of zero."""
    for edge in evidence.moving:
        unset = np.flatnonzero(edge.stamp_ns == 0)
        if not is_stamped(edge):
            facts = {"count": len(unset), "total": len(edge)}
            yield _finding(edge, "unset-stamps", "error", int(unset[0]), int(unset[-1]), facts)


def gaps(evidence: Evidence) -> Iterator[Finding]:
    """Yield a finding for each silence: of everything, of the edges that fell silent together, or of one."""
    together: dict[tuple[str, ...], list[list[Silence]]] = {}
    for event in _events(evidence):
        if _all_are_silent(evidence, event):
            yield _finding_of_silences("stall", [event])
        else:
            children = tuple(sorted(silence.edge.child for silence in event))
            together.setdefault((event[0].is_last, *children), []).append(event)
    for events in together.values():
        yield _finding_of_silences("went-silent" if events[0][0].is_last else "gap", events)


def odd_delays(evidence: Evidence) -> Iterator[Finding]:
    """Yield a finding for each moving edge that is, or was for a while, much earlier or later than the others."""
    delays_s = settled_delays_s(evidence)
    usual_s = [_usual_delay_s(edge, delay_s) for edge, delay_s in zip(evidence.moving, delays_s, strict=True)]
    of_messages_s = [_usual_delay_s(header, evidence.delay_s(header)) for header in evidence.headers]
    for place, (edge, delay_s) in enumerate(zip(evidence.moving, delays_s, strict=True)):
        if len(edge) < FEWEST_SAMPLES or not is_stamped(edge):
            continue
        # of the other source that has the least; 0 if there is none, or it is ahead
        others_s = max(0.0, min([*usual_s[:place], *usual_s[place + 1 :], *of_messages_s, math.inf]))
        others_s = 0.0 if math.isinf(others_s) else others_s
        late_s = others_s + max(LATE_S, 2.0 * others_s)
        for code, is_odd in (("early-stamps", delay_s < -EARLY_S), ("late-stamps", delay_s > late_s)):
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
                yield _finding(edge, code, "warning", int(odd[0]), int(odd[-1]), facts)


def odd_message_delays(evidence: Evidence) -> Iterator[Finding]:
    """Yield a finding for each topic whose messages are stamped ahead of the transforms, or long before them."""
    if not evidence.moving:
        return
    for header in evidence.headers:
        if len(header.stamp_ns) < FEWEST_SAMPLES or not is_stamped(header):
            continue
        usual_s = float(np.median(evidence.delay_s(header)))
        if -MESSAGE_EARLY_S <= usual_s <= MESSAGE_LATE_S:
            continue
        code = "messages-early" if usual_s < 0.0 else "messages-late"
        facts = {"topic": header.topic, "delay": f"{abs(usual_s):.3f}", "count": len(header.stamp_ns)}
        span = (int(header.receive_ns[0]), int(header.receive_ns[-1]))
        yield Finding(code, "warning", "", "", header.topic, *span, facts)


def _usual_delay_s(source: Edge | Headers, delay_s: np.ndarray) -> float:
    """Return the usual delay of a source [s]; infinity if it says too little."""
    return float(np.median(delay_s)) if len(delay_s) >= FEWEST_SAMPLES and is_stamped(source) else math.inf


def _in_a_row(is_odd: np.ndarray) -> np.ndarray:
    """Return the places of odd samples among others like them: one alone was overtaken, or repeats a stamp."""
    bounds = np.flatnonzero(np.diff(np.concatenate([[False], is_odd, [False]]).astype(int)))
    runs = [np.arange(a, b) for a, b in bounds.reshape(-1, 2).tolist() if b - a >= FEWEST_SAMPLES]
    return np.concatenate(runs) if runs else np.zeros(0, dtype=np.int64)


def _may_be_ahead(evidence: Evidence, edge: Edge) -> bool:
    """Return whether an edge is a localiser's: the one at the top of the tree, above a moving one."""
    moving_children = {other.child for other in evidence.moving}
    is_top = edge.usual_parent not in evidence.parent_of
    carries_moving = any(evidence.parent_of[child] == edge.child for child in moving_children)
    return is_top and carries_moving


def _silences(evidence: Evidence, edge: Edge) -> Iterator[Silence]:
    """Yield where an edge said nothing for much longer than it usually does, neither by its stamps nor in fact."""
    if len(edge) < FEWEST_SAMPLES:
        return
    order = np.argsort(edge.stamp_ns, kind="stable")
    stamp_step_s = np.diff(edge.stamp_ns) / NSEC_PER_SEC
    heard_step_s = np.diff(edge.receive_ns) / NSEC_PER_SEC
    usual_s = float(np.median(np.diff(edge.stamp_ns[order]))) / NSEC_PER_SEC
    habit_s = float(np.percentile(heard_step_s, 90))
    least_s = max(LEAST_GAP_S, GAP_PERIODS * usual_s, GAP_HABITS * habit_s)
    for i in np.flatnonzero((stamp_step_s > least_s) & (heard_step_s > 0.6 * least_s)).tolist():
        yield Silence(edge, int(edge.receive_ns[i]), int(edge.receive_ns[i + 1]), is_last=False)
    least_ns = max(1.0, 2.0 * least_s) * NSEC_PER_SEC
    others = [other for other in evidence.moving if other is not edge]
    heard_longer = [other for other in others if other.receive_ns[-1] - edge.receive_ns[-1] > least_ns]
    stamped_longer = [other for other in heard_longer if other.stamp_ns.max() - edge.stamp_ns.max() > least_ns]
    if others and len(stamped_longer) > len(others) / 2:
        yield Silence(edge, int(edge.receive_ns[-1]), max(int(o.receive_ns[-1]) for o in others), is_last=True)


def _events(evidence: Evidence) -> list[list[Silence]]:
    """Return the silences, those together that began and ended at about the same time."""
    events: list[list[Silence]] = []
    silences = [silence for edge in evidence.moving for silence in _silences(evidence, edge)]
    for silence in sorted(silences, key=lambda s: (s.begin_ns, s.end_ns)):
        for event in events:
            first = event[0]
            slack_ns = ALIKE_SHARE * (first.end_ns - first.begin_ns)
            begins_alike = abs(silence.begin_ns - first.begin_ns) < slack_ns
            if begins_alike and abs(silence.end_ns - first.end_ns) < slack_ns and silence.is_last == first.is_last:
                event.append(silence)
                break
        else:
            events.append([silence])
    return events


def _all_are_silent(evidence: Evidence, event: list[Silence]) -> bool:
    """Return whether nothing else that should have spoken did, while these edges were silent."""
    begin_ns, end_ns = event[0].begin_ns, event[0].end_ns
    margin_ns = (end_ns - begin_ns) // 5
    silent = [silence.edge for silence in event]
    asked = len(silent) - 1
    for other in (*evidence.moving, *evidence.headers):
        if any(other is edge for edge in silent) or len(other.stamp_ns) < FEWEST_SAMPLES:
            continue
        spoke = other.receive_ns
        period_ns = float(np.median(np.diff(np.sort(spoke))))
        if spoke[0] > begin_ns or spoke[-1] < end_ns or 2.0 * period_ns > end_ns - begin_ns:
            continue
        asked += 1
        if ((spoke > begin_ns + margin_ns) & (spoke < end_ns - margin_ns)).any():
            return False
    return asked > 0 and not event[0].is_last


def _finding_of_silences(code: str, events: list[list[Silence]]) -> Finding:
    """Return one finding for all silences of the same edges."""
    longest = max((silence for event in events for silence in event), key=lambda s: s.end_ns - s.begin_ns)
    edges = [silence.edge for silence in events[0]]
    length_s = (longest.end_ns - longest.begin_ns) / NSEC_PER_SEC
    facts = {
        "count": len(events),
        "edges": ", ".join(f"{edge.usual_parent} -> {edge.child}" for edge in edges),
        "longest": f"{length_s:.3f}",
        "period": f"{longest.edge.period_ns / NSEC_PER_SEC:.3f}",
        "moved": f"{_moved_across(longest):.3f}",
    }
    edge = edges[0]
    parent, child = (edge.usual_parent, edge.child) if len(edges) == 1 and code != "stall" else ("", "")
    return Finding(code, "warning", parent, child, edge.topic, longest.begin_ns, longest.end_ns, facts)


def _moved_across(silence: Silence) -> float:
    """Return how far an edge moved while it was silent [m]: what a straight line has to stand for."""
    edge = silence.edge
    ends = np.flatnonzero((edge.receive_ns == silence.begin_ns) | (edge.receive_ns == silence.end_ns))
    ends = ends[edge.is_usable[ends]]
    if silence.is_last or len(ends) < 2:
        return 0.0
    poses = unit(edge.numbers[ends[[0, -1]]])
    return float(distances(poses[:1], poses[1:])[0])


def _values_of_repeats(edge: Edge, repeats: list[int]) -> str:
    """Return whether samples of one stamp agree: "the same" or "different"."""
    first_of: dict[int, np.ndarray] = {}
    for i in repeats:
        stamp_ns = int(edge.stamp_ns[i])
        if stamp_ns not in first_of:
            first_of[stamp_ns] = edge.numbers[int(np.argmax(edge.stamp_ns == stamp_ns))]
        if not np.array_equal(first_of[stamp_ns], edge.numbers[i], equal_nan=True):
            return "different"
        if len(first_of) > 200:
            break
    return "the same"


def _finding(edge: Edge, code: str, severity, first: int, last: int, facts: dict) -> Finding:
    span = (int(edge.receive_ns[first]), int(edge.receive_ns[last]))
    return Finding(code, severity, edge.usual_parent, edge.child, edge.topic, *span, facts)
