"""Check for edges that stop, have gaps, begin late or are too slow.

    o--o--o        o--o       a gap: no lookup in there, and a straight line across
       o--o--o--o--o          began late
    o--------o--------o       too slow for how it moves

A node that was blocked first sends the sample that it had in hand, and then leaps:
the silence is heard a little before the hole in the stamps.  If *every* edge is
silent at once, it is not the edges: the recorder, the network or the computer
stood still, and that is one event.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from tflab.core import NSEC_PER_SEC
from tflab.text import Text

from ..evidence import Edge, Evidence, is_stamped
from ..findings import Finding, times_of
from .motion import ARM_M, is_constant, steps_and_turns, unit

__all__ = ["gaps", "late_starts", "slow_edges"]

LEAST_GAP_S = 0.25
GAP_PERIODS = 5.0  # a gap is longer than so many usual steps ...
GAP_HABITS = 3.0  # ... and than so many of the longer steps of an irregular edge
FEWEST_SAMPLES = 8
ALIKE_SHARE = 0.25  # of its length: silences that begin and end within so much of each other are one event
HOLE_AFTER = 4  # samples after a silence in which its hole may show
LONGEST_SILENCE_NS = 3600 * NSEC_PER_SEC  # of everything: nobody waits so long, and a clock may be set by more
STEPS_ACROSS = 2.5  # of usual ones: as far a robot moves while its clock is set
LATE_START_S = 1.0
SOON_S = 5.0  # what starts later than this has waited for something
LATE_START_PERIODS = 10.0
SLOW_S = 0.4  # between samples
SLOWER = 5.0  # than the others
FAR_M = 0.05  # between two samples of a slow edge
MOST_MOMENTS = 12  # that are told


class Silence(NamedTuple):
    """One edge said nothing between two moments of receipt [ns]; it never spoke again if `is_last`.

    Attributes:
        hole_ns: for how long there are no stamps.
    """

    edge: Edge
    begin_ns: int
    end_ns: int
    hole_ns: int
    is_last: bool


def gaps(evidence: Evidence) -> Iterator[Finding]:
    """Yield a finding for each silence: of everything, of all of /tf, of some edges together, or of one."""
    together: dict[tuple, list[list[Silence]]] = {}
    for event in _events(evidence):
        children = tuple(sorted(silence.edge.child for silence in event))
        together.setdefault((_kind_of(evidence, event), children), []).append(event)
    for (code, _), events in together.items():
        yield _finding_of_silences(code, events, evidence)


def _kind_of(evidence: Evidence, event: list[Silence]) -> str:
    """Return which finding silences at the same time are."""
    if event[0].is_last:
        return "went-silent"
    edges_spoke = _has_spoken(evidence, event, evidence.moving)
    topics_spoke = _has_spoken(evidence, event, evidence.headers)
    if edges_spoke or (topics_spoke and len(event) == 1):
        return "gap"
    if topics_spoke:
        return "tf-silent"
    if len(event) == 1 and edges_spoke is None and topics_spoke is None:
        return "gap"
    return "clock-set" if _is_set_clock(evidence, event) else "stall"


def _is_set_clock(evidence: Evidence, event: list[Silence]) -> bool:
    """Return whether it was no silence, but a clock that was set: the robot drives on where it was before."""
    if event[0].end_ns - event[0].begin_ns > LONGEST_SILENCE_NS:
        return True
    has_stayed = []
    last, n = FEWEST_SAMPLES - 1, FEWEST_SAMPLES
    for edge, _, end_ns, hole_ns, _ in event:
        end = int(np.searchsorted(edge.receive_ns, end_ns))
        numbers = edge.numbers[max(0, end - n) : end + n]
        if len(numbers) == 2 * n and edge.is_usable.all() and edge.child in evidence.all_parents:
            poses = unit(numbers)
            far_m, far_rad = steps_and_turns(poses[[0, n, last]], poses[[last, -1, n]])
            before, after, across = far_m + ARM_M * far_rad
            step = min(before, after) / last
            if step * hole_ns / edge.period_ns > FAR_M:
                has_stayed.append(across < STEPS_ACROSS * step)
    return bool(has_stayed) and all(has_stayed)


def late_starts(evidence: Evidence) -> Iterator[Finding]:
    """Yield a finding for each moving edge that begins long after the others."""
    begun_ns = [int(edge.receive_ns[0]) for edge in evidence.moving]
    begun_ns += [int(header.receive_ns[0]) for header in evidence.headers if len(header.receive_ns) >= FEWEST_SAMPLES]
    if len(begun_ns) < 2:
        return
    usual_ns = sorted(begun_ns)[(len(begun_ns) - 1) // 3]
    for edge in evidence.moving:
        late_ns = int(edge.receive_ns[0]) - usual_ns
        least_ns = max(LATE_START_S * NSEC_PER_SEC, LATE_START_PERIODS * edge.period_ns)
        if len(edge) >= FEWEST_SAMPLES and late_ns > least_ns and is_stamped(edge):
            facts = {"late": f"{late_ns / NSEC_PER_SEC:.3f}"}
            span = (usual_ns, int(edge.receive_ns[0]))
            is_urgent = late_ns > SOON_S * NSEC_PER_SEC or _is_needed(evidence, edge)
            severity = "warning" if is_urgent and not evidence.is_detection(edge) else "info"
            yield Finding("late-start", severity, edge.usual_parent, edge.child, edge.topic, *span, facts)


def _is_needed(evidence: Evidence, edge: Edge) -> bool:
    """Return whether lookups from before an edge began need it: all but a localiser's, if nothing was in its frame."""
    is_top = edge.usual_parent not in evidence.parent_of
    if not is_top or not any(other.usual_parent == edge.child for other in evidence.moving):
        return True
    for header in evidence.headers:
        for number in np.unique(header.frame[header.receive_ns < edge.receive_ns[0]]).tolist():
            frame = header.frames[number].removeprefix("/")
            if frame in evidence.frames and not evidence.is_below(frame, edge.child):
                return True
    return False


def slow_edges(evidence: Evidence) -> Iterator[Finding]:
    """Yield a finding for each moving edge that comes so rarely that it moves far from one sample to the next."""
    for edge in evidence.moving:
        period_s = edge.period_ns / NSEC_PER_SEC
        if len(edge) < FEWEST_SAMPLES or period_s < SLOW_S or is_constant(edge):
            continue
        poses = unit(edge.numbers[edge.is_usable])
        if len(poses) < FEWEST_SAMPLES:
            continue
        far_m, far_rad = (float(np.percentile(far, 75)) for far in steps_and_turns(poses[1:], poses[:-1]))
        others_s = [
            other.period_ns / NSEC_PER_SEC for other in evidence.moving if other is not edge and other.period_ns
        ]
        is_slower = bool(others_s) and SLOWER * float(np.median(others_s)) <= period_s
        if far_m + ARM_M * far_rad < FAR_M and not is_slower:
            continue
        facts = {"rate": f"{1.0 / period_s:.1f}", "far": f"{far_m:.3f}", "turned": f"{far_rad:.3f}",
                 "frame": edge.child,
                 "others": f"{1.0 / np.median(others_s):.1f} Hz" if others_s else Text("none", "없음")}  # fmt: skip
        span = (int(edge.receive_ns[0]), int(edge.receive_ns[-1]))
        yield Finding("slow-edge", "warning", edge.usual_parent, edge.child, edge.topic, *span, facts)


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
    largest_hole_ns: dict[int, int] = {}  # of each silence; two holes may follow one
    for hole in np.flatnonzero(stamp_step_s > least_s).tolist():
        first = max(0, hole - HOLE_AFTER + 1)
        silent = first + int(np.argmax(heard_step_s[first : hole + 1]))
        if heard_step_s[silent] > 0.6 * least_s:
            hole_ns = int(edge.stamp_ns[hole + 1] - edge.stamp_ns[hole])
            largest_hole_ns[silent] = max(hole_ns, largest_hole_ns.get(silent, 0))
    for silent, hole_ns in largest_hole_ns.items():
        moments = (int(edge.receive_ns[silent]), int(edge.receive_ns[silent + 1]))
        yield Silence(edge, *moments, hole_ns, is_last=False)
    yield from _last_silence(evidence, edge, max(1.0, 2.0 * least_s) * NSEC_PER_SEC)


def _last_silence(evidence: Evidence, edge: Edge, least_ns: float) -> Iterator[Silence]:
    """Yield the silence at the end of an edge, if most of the others went on."""
    others = [other for other in evidence.moving if other is not edge] or [
        header for header in evidence.headers if len(header.receive_ns) >= FEWEST_SAMPLES
    ]
    heard_longer = [other for other in others if other.receive_ns[-1] - edge.receive_ns[-1] > least_ns]
    stamped_longer = [other for other in heard_longer if other.stamp_ns.max() - edge.stamp_ns.max() > least_ns]
    if others and len(stamped_longer) > len(others) / 2:
        begin_ns, end_ns = int(edge.receive_ns[-1]), max(int(other.receive_ns[-1]) for other in others)
        yield Silence(edge, begin_ns, end_ns, end_ns - begin_ns, is_last=True)


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


def _has_spoken(evidence: Evidence, event: list[Silence], others) -> bool | None:
    """Return whether, while these edges were silent, another spoke that should have; None if there is none to ask."""
    begin_ns, end_ns = event[0].begin_ns, event[0].end_ns
    margin_ns = (end_ns - begin_ns) // 5
    silent = [silence.edge for silence in event]
    asked = 0
    for other in others:
        if any(other is edge for edge in silent) or len(other.stamp_ns) < FEWEST_SAMPLES:
            continue
        spoke = other.receive_ns
        period_ns = float(np.median(np.diff(np.sort(spoke))))
        if spoke[0] > begin_ns or spoke[-1] < end_ns or 2.0 * period_ns > end_ns - begin_ns:
            continue
        asked += 1
        if ((spoke > begin_ns + margin_ns) & (spoke < end_ns - margin_ns)).any():
            return True
    return False if asked else None


def _finding_of_silences(code: str, events: list[list[Silence]], evidence: Evidence) -> Finding:
    """Return one finding for all silences of the same edges."""
    longest = max((silence for event in events for silence in event), key=lambda s: s.end_ns - s.begin_ns)
    edges = [silence.edge for silence in events[0]]
    length_s = (longest.end_ns - longest.begin_ns) / NSEC_PER_SEC
    moved_m, turned_rad = _moved_across(longest)
    facts = {
        "times": _times_of(events, evidence.begin_ns),
        "edges": ", ".join(dict.fromkeys(f"{edge.usual_parent} -> {edge.child}" for edge in edges)),
        "longest": f"{length_s:.3f}", "period": f"{longest.edge.period_ns / NSEC_PER_SEC:.3f}",
        "hole": f"{longest.hole_ns / NSEC_PER_SEC:.3f}", "frame": longest.edge.child,
        "moved": f"{moved_m:.3f}", "turned": f"{turned_rad:.3f}",
    }  # fmt: skip
    edge = edges[0]
    is_one = len(edges) == 1 and code not in ("stall", "clock-set", "tf-silent")
    parent, child = (edge.usual_parent, edge.child) if is_one else ("", "")
    severity = "info" if all(map(evidence.is_detection, edges)) else "warning"
    return Finding(code, severity, parent, child, edge.topic, longest.begin_ns, longest.end_ns, facts)


def _times_of(events: list[list[Silence]], start_ns: int) -> Text:
    """Return how often, and when if more than once, in seconds from the beginning."""
    begins_s = [(event[0].begin_ns - start_ns) / NSEC_PER_SEC for event in events]
    shown = ", ".join(f"{begin_s:.1f}" for begin_s in begins_s[:MOST_MOMENTS])
    return times_of(len(events), f"{shown}{', ...' if len(events) > MOST_MOMENTS else ''}")


def _moved_across(silence: Silence) -> tuple[float, float]:
    """Return how far an edge moved [m] and turned [rad] while it was silent: what a straight line has to stand for."""
    edge = silence.edge
    ends = np.flatnonzero((edge.receive_ns == silence.begin_ns) | (edge.receive_ns == silence.end_ns))
    ends = ends[edge.is_usable[ends]]
    if silence.is_last or len(ends) < 2:
        return 0.0, 0.0
    (start, *_, end) = unit(edge.numbers[ends])
    dot = min(1.0, abs(float(np.dot(start[3:], end[3:]))))
    return float(np.linalg.norm(end[:3] - start[:3])), 2.0 * float(np.arccos(dot))
