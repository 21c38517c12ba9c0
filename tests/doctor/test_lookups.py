"""The share of messages that can be looked up at their stamp, against a replay through a buffer."""

import json
import math
from dataclasses import replace

import numpy as np
import pytest

from tflab.bags.recording import Headers, recording_from_records
from tflab.core import BufferCore, StampedTransform, Transform
from tflab.core.transforms import TransformRecord
from tflab.doctor.ci.expectations import (
    ExpectationError,
    deviations_from,
    expectations_from,
    read_expectations,
    toml_from,
)
from tflab.doctor.collect_evidence import evidence_from_recording
from tflab.doctor.diagnose import diagnose_recording
from tflab.doctor.lookups import WAITS_S, lookups_of
from tflab.doctor.profile import profile_of
from tflab.doctor.report.html import html_from_report
from tflab.doctor.report.text import data_from_report, text_from_report

MS = 1_000_000
NO_ROTATION = Transform((0.0, 0.0, 0.0), (0.0, 0.0, 0.0, 0.0))


def edge(parent, child, period_ms=50, delay_ms=4, spread_ms=0, first_ms=1000, last_ms=5000, value=None, static=False):
    rng = np.random.default_rng(len(child) + period_ms)
    records = []
    for stamp_ms in range(first_ms, last_ms, period_ms):
        receive_ns = (stamp_ms + delay_ms) * MS + round(spread_ms * MS * rng.random())
        pose = value or Transform.from_rpy(yaw=1e-4 * stamp_ms)
        stamped = StampedTransform(parent, child, stamp_ms * MS, pose)
        records.append(TransformRecord("/tf_static" if static else "/tf", receive_ns, "", stamped, static))
    return records


def mount(parent, child, first_ms=900):
    return edge(parent, child, first_ms=first_ms, last_ms=first_ms + 1, static=True)


def recording(edges, topic="/scan", frame="laser", period_ms=97, delay_ms=3, last_ms=5200, zeros=False):
    records = sorted((record for records in edges for record in records), key=lambda record: record.receive_ns)
    stamp_ns = np.arange(950, last_ms, period_ms) * MS
    receive_ns = stamp_ns + delay_ms * MS
    header = Headers(topic, "sensor_msgs/msg/LaserScan", receive_ns, 0 * stamp_ns if zeros else stamp_ns,
                     np.zeros(len(stamp_ns), dtype=int), (frame,))  # fmt: skip
    return replace(recording_from_records(records), headers=(header,))


def replayed(recording, frame, fixed):
    """The shares, with every message looked up in a buffer that receives what was recorded."""
    buffer, pending, waits_s, header = BufferCore(), [], [], recording.headers[0]
    messages = list(zip(header.receive_ns.tolist(), header.stamp_ns.tolist(), strict=True))
    for record in [*recording.records(), None]:
        now_ns = record.receive_ns if record else math.inf
        while messages and messages[0][0] < now_ns:  # what was received by then has been tried
            receive_ns, stamp_ns = messages.pop(0)
            pending.append((receive_ns, stamp_ns))
            waits_s += tried(buffer, pending, fixed, frame, receive_ns)
        if record:
            buffer.set_transform(record.stamped, "", record.is_static)
            waits_s += tried(buffer, pending, fixed, frame, now_ns)
    return tuple(sum(wait_s <= most_s for wait_s in waits_s) / len(header.stamp_ns) for most_s in WAITS_S)


def tried(buffer, pending, fixed, frame, now_ns):
    works = [entry for entry in pending if buffer.can_transform(fixed, frame, entry[1])]
    pending[:] = [entry for entry in pending if entry not in works]
    return [(now_ns - receive_ns) / 1e9 for receive_ns, _ in works]


MAP, ODOM, LASER = edge("map", "odom", 100), edge("odom", "base_link"), mount("base_link", "laser")
PARTED = [*edge("odom", "base_link", last_ms=2000), *edge("dock", "base_link", first_ms=2000, last_ms=3500),
          *edge("odom", "base_link", first_ms=3500)]  # fmt: skip
BROKEN = [replace(r.stamped, transform=NO_ROTATION) for r in ODOM[20:40]]
REFUSED = [*ODOM[:20], *(r._replace(stamped=s) for r, s in zip(ODOM[20:40], BROKEN, strict=True)), *ODOM[40:]]
AHEAD = edge("map", "odom", 100, -25_000, first_ms=26_000, last_ms=95_000)
LONG, BRIEF = {"last_ms": 30_000}, {"last_ms": 31_000}
RECORDINGS = {
    "odometry later than scans": recording([MAP, edge("odom", "base_link", delay_ms=60), LASER], period_ms=50),
    "samples that overtake each other": recording(
        [edge("map", "odom", 90, 300, 700), edge("odom", "base_link", 40, 5, 200), LASER]
    ),
    "an edge with a parent that changes": recording([MAP, PARTED, mount("map", "dock"), LASER]),
    "what tf2 refuses, and a mount that comes late": recording(
        [MAP, REFUSED, mount("base_link", "laser", 3000)]
    ),
    "an edge behind by more than the cache, and one with a hole": recording(
        [edge("map", "odom", 200, 12_000, **LONG), edge("odom", "base_link", **LONG), LASER,
         edge("base_link", "arm", last_ms=4000), edge("base_link", "arm", first_ms=17_000, **LONG)],
        frame="arm", period_ms=331, **BRIEF,
    ),
    "late messages without a stamp": recording([MAP, edge("odom", "base_link", first_ms=2000), LASER], zeros=True),
}  # fmt: skip


@pytest.mark.parametrize("recording", RECORDINGS.values(), ids=RECORDINGS)
def test_the_shares_are_those_of_a_buffer_that_receives_the_recording(recording):
    rows = lookups_of(evidence_from_recording(recording))
    assert {row.fixed for row in rows} >= {"map", "odom", "base_link"}
    for row in rows:
        frame = recording.headers[0].frames[0]
        assert row.shares == pytest.approx(replayed(recording, frame, row.fixed)), row.fixed


def test_a_row_names_the_edge_that_is_waited_for_and_the_period_of_the_topic():
    (in_odom,) = (row for row in lookups_of(evidence_from_recording(RECORDINGS["odometry later than scans"]))
                  if row.fixed == "odom")  # fmt: skip
    assert (in_odom.parent, in_odom.child, in_odom.period_ns) == ("odom", "base_link", 50 * MS)
    assert in_odom.shares[0] == 0.0 and in_odom.wait_ns == 57 * MS
    assert lookups_of(evidence_from_recording(recording([MAP, ODOM, LASER], frame="nobody"))) == ()


GOOD, BAD = recording([MAP, ODOM, LASER]), RECORDINGS["odometry later than scans"]
FINDINGS = {
    "a healthy robot": (GOOD, set()),
    "odometry that comes later than the next scan": (BAD, {"lookups-wait"}),
    "a mount that was sent once on /tf": (
        recording([MAP, ODOM, edge("base_link", "laser", last_ms=1001), mount("base_link", "imu")]), {"lookups-fail"},
    ),
    "a localiser that is late, which explains the wait": (
        recording([edge("map", "odom", 100, 300), ODOM, LASER]), {"late-stamps"},
    ),
    "a localiser that is far ahead, which explains that nothing works": (
        recording([AHEAD, edge("odom", "base_link", last_ms=70_000), LASER], last_ms=70_000), {"early-stamps"},
    ),
    "scans without a frame": (recording([MAP, ODOM, LASER], frame=""), {"empty-frame-id"}),
    "odometry that is static": (recording([MAP, mount("odom", "base_link"), LASER]), {"odometry-on-static"}),
}  # fmt: skip


@pytest.mark.parametrize(("recording", "codes"), FINDINGS.values(), ids=FINDINGS)
def test_what_cannot_be_looked_up_is_named_unless_another_finding_explains_it(recording, codes):
    assert {finding.code for finding in diagnose_recording(recording).of_severity("error", "warning")} == codes


def test_the_table_is_in_the_report_in_the_data_and_on_the_page():
    report = diagnose_recording(BAD)
    assert "94 %   94 %  94 %  waits for odom -> base_link, period 0.050 s" in text_from_report(report)
    assert "바로 조회되는" in text_from_report(report, "ko")
    in_odom = next(row for row in data_from_report(report)["lookups"] if row["fixed"] == "odom")
    assert json.loads(json.dumps(in_odom))["shares"][0] == 0.0 and in_odom["child"] == "base_link"
    page = html_from_report(report, BAD)
    assert "<td>94 %</td><td>94 %</td><td>94 %</td><td>waits for odom -&gt; base_link" in page
    assert page.count('class="strip"') >= len(report.lookups)


def test_lookups_are_expected_as_they_were_in_a_good_recording(tmp_path):
    file = tmp_path / "robot.toml"
    file.write_text(toml_from(expectations_from(profile_of(GOOD))), encoding="utf-8")
    expected = read_expectations(file)
    assert expected.lookups["/scan -> odom"][0] == 0.1
    assert deviations_from(expected, profile_of(GOOD)) == []
    late = profile_of(recording([MAP, edge("odom", "base_link", delay_ms=200), LASER]))
    late = [finding for finding in deviations_from(expected, late) if finding.code == "expected-lookup"]
    assert {(finding.topic, finding.child) for finding in late} == {("/scan", "base_link")}
    lost = deviations_from(expected, profile_of(recording([MAP, ODOM, LASER], frame="lost")))
    assert {finding.facts["fixed"] for finding in lost if finding.code == "expected-lookup"} == {
        "map",
        "odom",
        "base_link",
    }
    for line in ('"/scan -> odom" = [0.2, 0.5]', '"/scan" = [0.1, 0.5]', '"/scan -> odom" = [0.1, 50]'):
        file.write_text(f"[lookups]\n{line}\n", encoding="utf-8")
        with pytest.raises(ExpectationError, match=r"lookups\."):
            read_expectations(file)
