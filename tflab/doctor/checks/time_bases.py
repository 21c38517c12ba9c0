"""Check whose clock stamped what (question 5): sources with one offset are one host or one device, and one finding.

    stamps       0.2   0.2   0.2           not set, or a tolerance added to a time that was not set
    stamps      1503  1504  1505           since the device was switched on
    stamps     13.50 13.51 13.52           simulated, at another pace than the times of receipt
    delay [s]   -37   -37   -37            TAI, which has no leap seconds: 37 s ahead of UTC
    delay [s]  0.10  0.12  0.14  0.16      a clock that loses 2 ms in each second: the least delay drifts

`collect_evidence` separates samples in another time base from the rest of their source.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator

import numpy as np

from tflab.bags.recording import Headers
from tflab.core import NSEC_PER_SEC
from tflab.text import Text

from ..evidence import SAME_CLOCK_NS, YEAR_NS, ClockRelation, Edge, Evidence, OtherSamples, is_stamped
from ..findings import Finding, Severity
from .names import SPATIAL

__all__ = ["CACHE_S", "LONGEST_WAIT_S", "drifting_clocks", "finding_of_sources", "has_copied_stamps", "in_groups",
           "other_hosts", "other_times"]  # fmt: skip

FEWEST_SAMPLES = 8
CACHE_S = 10.0  # what tf2 keeps as a rule: what is further behind can never be looked up
LONGEST_WAIT_S = 5.0  # of a lookup, for what is ahead
UNSET_NS = 60 * NSEC_PER_SEC  # a time that was not set, and at most a tolerance
SAME_PACE = 0.02  # from one second a second: a simulation is seldom so close to it, a device always is
ONE_CLOCK_S = 1.0  # offsets of many years this close to each other are one clock
SENSOR = re.compile(r"LaserScan|PointCloud|Image|CameraInfo|Imu|Range|Odometry|JointState")
PROMPT = re.compile(r"Imu|JointState|Odometry|NavSatFix")  # sent as soon as it is measured
MANY = 5_000  # samples tell enough
HOST_S = 0.08  # that a host is behind or ahead
HOST_SPREAD_S, HOST_SHARE = 0.01, 0.02  # of the least delays of one host, and their share of a large offset
FAR_HOST_S = 0.5  # from which on scans and images are witnesses, too: no processing of theirs takes as long
FEWEST_ON_A_HOST = 3
BIN_S = 10.0
FEWEST_BINS = 6
LEAST_DRIFT = 2e-4  # seconds a second: quartz is better, and NTP corrects by less than 5e-4
LEAST_DRIFT_S = 0.03  # in all


def other_times(evidence: Evidence) -> Iterator[Finding]:
    """Yield a finding for each other time base that edges and topics are stamped in, wholly or in a part."""
    whole = [OtherSamples(s, len(s.stamp_ns)) for s in (*evidence.moving, *evidence.headers) if _is_far(evidence, s)]
    separated = [(_time_base_of(samples, evidence.clock), samples) for samples in (*evidence.in_other_time, *whole)]
    separated = [entry for entry in separated if _has_enough_samples(*entry)]

    def is_one_clock(a: tuple, b: tuple) -> bool:
        away_s = abs(_usual_s(evidence, a[1].source) - _usual_s(evidence, b[1].source))
        return a[0] == b[0] and (a[0] in ("time-wall", "unset-stamps") or away_s < ONE_CLOCK_S)

    for group in in_groups(separated, is_one_clock):
        parts = [samples for _, samples in group]
        usual_s = _usual_s(evidence, parts[0].source)
        facts = {
            "count": sum(len(part.source.stamp_ns) for part in parts),
            "total": sum(part.total for part in parts),
            "away": f"{abs(usual_s):.0f}",
            "way": Text("behind", "과거") if usual_s > 0.0 else Text("ahead of", "미래"),
            "stamp": f"{parts[0].source.stamp_ns[0] / NSEC_PER_SEC:.1f}",
        }
        code = "time-date-ahead" if group[0][0] == "time-date" and usual_s < 0.0 else group[0][0]
        yield finding_of_sources(code, _severity_of(parts), [part.source for part in parts], facts)


def other_hosts(evidence: Evidence) -> Iterator[Finding]:
    """Yield a finding for each computer of which everything is late, or early, by one offset, unlike the others."""
    shares = [(np.percentile(evidence.delay_s(source), (5, 90)), source) for source in _dated_sources(evidence)]
    # what was ahead for a while only had its clock set, see jumping_clocks
    least_s = [(float(max(least, min(2.0 * most, 0.0))), source) for (least, most), source in shares]
    prompt = sorted((entry for entry in least_s if _is_prompt(entry[1])), key=lambda entry: entry[0])
    nearest_s = min((abs(delay_s) for delay_s, _ in least_s), default=0.0)
    for entries in in_groups(prompt, lambda a, b: b[0] - a[0] < max(HOST_SPREAD_S, HOST_SHARE * abs(a[0]))):
        offset_s, group = entries[0][0], [source for _, source in entries]
        if abs(offset_s) <= max(HOST_S, evidence.clock.resolution_s, 2.0 * nearest_s):
            continue
        sweeps = [source for delay_s, source in least_s if _is_sweep_of_host(source, delay_s, offset_s)]
        if _are_witnesses(group, sweeps, offset_s):
            group += sweeps
            # edges with children of their own come first, and topics last
            group.sort(key=lambda s: s.child not in evidence.all_parents if isinstance(s, Edge) else 2)
            code = "host-late" if offset_s > 0.0 else "host-early"
            severity = "warning" if -LONGEST_WAIT_S <= offset_s <= CACHE_S else "error"
            yield finding_of_sources(code, severity, group, {"offset": f"{abs(offset_s):.3f}", "count": len(group)})


def _are_witnesses(prompt: list[Edge | Headers], sweeps: list[Edge | Headers], offset_s: float) -> bool:
    """Return whether sources are enough for one host, and not all copies of one."""
    sources = prompt + sweeps if abs(offset_s) > FAR_HOST_S else prompt
    return len(sources) >= FEWEST_ON_A_HOST and len(in_groups(sources, has_copied_stamps)) > 1


def _is_prompt(source: Edge | Headers) -> bool:
    return isinstance(source, Edge) or bool(PROMPT.search(source.msgtype))


def _is_sweep_of_host(source: Edge | Headers, least_s: float, offset_s: float) -> bool:
    """Return whether the delay of a scan or an image needs both: the offset of a host, and at most its own period."""
    period_s = float(np.median(np.diff(source.receive_ns))) / NSEC_PER_SEC
    is_explained = _is_prompt(source) or 0.0 <= least_s <= period_s + HOST_S
    return not is_explained and -HOST_SPREAD_S < least_s - offset_s < period_s + HOST_SPREAD_S


def drifting_clocks(evidence: Evidence) -> Iterator[Finding]:
    """Yield a finding for each clock that runs fast or slow: the least delay of its messages drifts evenly."""
    drifts = [(drift, s) for s in _dated_sources(evidence) if (drift := _drift_of(evidence, s))]
    for group in in_groups(drifts, lambda a, b: abs(a[0] - b[0]) < 0.1 * abs(a[0])):
        drift, sources = group[0][0], [source for _, source in group]
        seconds = max(np.ptp(source.receive_ns) for source in sources) / NSEC_PER_SEC
        facts = {"rate": f"{1e3 * abs(drift):.2f}", "most": f"{abs(drift) * seconds:.3f}"}
        yield finding_of_sources("clock-slow" if drift > 0.0 else "clock-fast", "warning", sources, facts)


def _drift_of(evidence: Evidence, source: Edge | Headers) -> float:
    """Return the slope of the least delays of each ten seconds, 0 if they are not on a line, or a level one."""
    place = (source.receive_ns - source.receive_ns.min()) // round(BIN_S * NSEC_PER_SEC)
    least_s = np.full(int(place.max()) + 1, np.inf)
    np.minimum.at(least_s, place, evidence.delay_s(source))
    least_s = least_s[:-1]  # the last ten seconds are not whole
    bins = np.flatnonzero(np.isfinite(least_s))
    if len(bins) < FEWEST_BINS:
        return 0.0
    slope, level = np.polyfit(bins * BIN_S, least_s[bins], 1)
    total_s = abs(slope) * BIN_S * np.ptp(bins)
    is_line = np.abs(slope * bins * BIN_S + level - least_s[bins]).max() < 0.1 * total_s
    return float(slope) if is_line and total_s > LEAST_DRIFT_S and abs(slope) > LEAST_DRIFT else 0.0


def finding_of_sources(
    code: str, severity: Severity, sources: list[Edge | Headers], facts: dict[str, object]
) -> Finding:
    """Return one finding about edges and topics of one host or device."""
    first, *rest = sources
    parent, child = (first.usual_parent, first.child) if isinstance(first, Edge) else ("", "")
    siblings = tuple(source.child if isinstance(source, Edge) else source.topic for source in rest)
    begin_ns = min(int(source.receive_ns[0]) for source in sources)
    end_ns = max(int(source.receive_ns[-1]) for source in sources)
    return Finding(code, severity, parent, child, first.topic, begin_ns, end_ns, facts, siblings=siblings)


def has_copied_stamps(a: Edge | Headers, b: Edge | Headers) -> bool:
    """Return whether a source has the stamps of another, and does not count as a second one."""
    return bool(np.isin(a.stamp_ns[:MANY], b.stamp_ns).mean() > 0.5)


def in_groups(items: list, is_alike: Callable) -> list[list]:
    """Return items in groups, each with those that are like its first."""
    groups: list[list] = []
    for item in items:
        group = next((group for group in groups if is_alike(group[0], item)), None)
        groups.append([item]) if group is None else group.append(item)
    return groups


def _time_base_of(samples: OtherSamples, clock: ClockRelation) -> str:
    """Return the code of the time base of stamps that are far from the others."""
    stamp_ns, receive_ns = samples.source.stamp_ns, samples.source.receive_ns
    pace = float(np.ptp(stamp_ns)) / max(float(np.ptp(receive_ns)), 1.0)
    if clock.source != "same" and abs(float(np.median(receive_ns - stamp_ns))) < SAME_CLOCK_NS:
        return "time-wall"
    if len(stamp_ns) == 1 or pace < SAME_PACE:
        return "unset-stamps" if stamp_ns.max() < UNSET_NS else "time-frozen"
    if np.median(stamp_ns) > YEAR_NS:
        return "time-date"
    return "time-uptime" if abs(pace - 1.0) < SAME_PACE else "time-simulated"


def _has_enough_samples(code: str, samples: OtherSamples) -> bool:
    """Return whether there are enough messages in another time base to report it.

    A stamp of zero asks for the latest transform, so it is reported of sensors and edges only.
    """
    if code == "time-wall" or (isinstance(samples.source, Edge) and len(samples.source) < samples.total):
        return True
    is_sensor = isinstance(samples.source, Edge) or SENSOR.search(samples.source.msgtype)
    return len(samples.source.stamp_ns) >= FEWEST_SAMPLES and (code not in ("unset-stamps", "time-frozen") or is_sensor)


def _severity_of(parts: list[OtherSamples]) -> Severity:
    sources = [part.source for part in parts]
    if any(isinstance(source, Edge) or SPATIAL.search(source.msgtype) for source in sources):
        return "error"
    return "warning" if any(any(source.frames) for source in sources) else "info"


def _dated_sources(evidence: Evidence) -> list[Edge | Headers]:
    sources = [s for s in (*evidence.moving, *evidence.headers) if len(s.stamp_ns) >= FEWEST_SAMPLES and is_stamped(s)]
    return [source for source in sources if not _is_far(evidence, source)]


def _usual_s(evidence: Evidence, source: Edge | Headers) -> float:
    return float(np.median(evidence.delay_s(source)))


def _is_far(evidence: Evidence, source: Edge | Headers) -> bool:
    """Return whether a source is in another time base, but for edges without stamps, which `unset_stamps` reports."""
    if not len(source.stamp_ns) or (isinstance(source, Edge) and not is_stamped(source)):
        return False
    # a clock that was set meanwhile is far for a part of the time only
    return float(np.percentile(np.abs(evidence.delay_s(source)), 10)) * NSEC_PER_SEC > SAME_CLOCK_NS
