"""The doctor as a gate: what is expected, what is let pass, the forms that machines read, and the exit status."""

import json
import xml.etree.ElementTree as ET
from dataclasses import replace
from pathlib import Path

import pytest
import yaml

from tflab.bags.recording import recording_from_records
from tflab.cli import main
from tflab.core import Transform
from tflab.doctor.ci.expectations import (
    ExpectationError,
    changes_between,
    deviations_from,
    expectations_from,
    read_expectations,
    toml_from,
)
from tflab.doctor.ci.filters import baseline_from, filter_findings
from tflab.doctor.ci.formats import annotations_from_reports, junit_from_reports, sarif_from_reports
from tflab.doctor.diagnose import diagnose_recording
from tflab.doctor.profile import profile_of, text_from_profile
from tflab.robots.faults.inject import inject
from tflab.robots.teaching import TeachingRobot

from .conftest import RECORDS, of_robot, write

CASES = yaml.safe_load(Path(__file__).with_suffix(".yaml").read_text(encoding="utf-8"))


def profile(records):
    return profile_of(recording_from_records(records))


def codes(findings):
    return {finding.code for finding in findings}


# -- exit status -----------------------------------------------------------


@pytest.mark.parametrize(("bag", "least", "status"), CASES["statuses"])
def test_the_exit_status_is_that_of_the_least_severity_that_fails(bag, least, status, request, capsys):
    assert main(["doctor", request.getfixturevalue(bag), "--fail-on", least]) == status
    assert capsys.readouterr().out


@pytest.mark.parametrize("words", [[], ["x", "--live", "3"], ["--live", "-1"], ["x", "--json", "--github"]])
def test_words_that_make_no_sense_end_with_2(words, capsys):
    with pytest.raises(SystemExit) as ended:
        main(["doctor", *words])
    assert ended.value.code == 2 and "tflab doctor: error" in capsys.readouterr().err


# -- expectations ----------------------------------------------------------


def test_a_recording_is_as_expected_of_itself_and_of_another_seed_also_when_read_again(tmp_path):
    expected, file = expectations_from(profile(RECORDS)), tmp_path / "robot.toml"
    file.write_text(toml_from(expected), encoding="utf-8")
    again = read_expectations(file)
    assert [(e.parent, e.child, e.static, e.owners) for e in again.edges] == [
        (e.parent, e.child, e.static, e.owners) for e in expected.edges
    ]
    for expectations in (expected, again):
        assert deviations_from(expectations, profile(RECORDS)) == []
        assert deviations_from(expectations, profile(TeachingRobot(seed=5).records(until_s=6.0))) == []


def test_each_deviation_is_named():
    expected = expectations_from(profile(RECORDS))
    without_odometry = [r for r in RECORDS if r.stamped.child_frame_id != "base_footprint"]
    assert codes(deviations_from(expected, profile(without_odometry))) == {"expected-edge"}
    odometry = [r for r in RECORDS if r.stamped.child_frame_id == "base_footprint"]
    halved = sorted([*without_odometry, *odometry[::2]], key=lambda r: r.receive_ns)
    assert "expected-rate" in codes(deviations_from(expected, profile(halved)))
    renamed = [r._replace(publisher="/other") if r.stamped.child_frame_id == "odom" else r for r in RECORDS]
    assert codes(deviations_from(expected, profile(renamed))) == {"expected-owners"}
    late = [r if r.is_static else r._replace(receive_ns=r.receive_ns + 300_000_000) for r in RECORDS]
    assert codes(deviations_from(expected, profile(late))) == {"expected-delay"}
    shifted = Transform((0.5, 0.0, 0.0))
    moved = [
        r._replace(stamped=replace(r.stamped, transform=shifted)) if r.stamped.child_frame_id == "laser_frame" else r
        for r in RECORDS
    ]
    assert codes(deviations_from(expected, profile(moved))) == {"expected-mount"}
    row = next(row for row in text_from_profile(profile(RECORDS)).splitlines() if row.startswith("odom -> base_f"))
    assert "20.0" in row and row.endswith("/wheel_odometry")  # in the table of edges


def test_what_is_not_written_is_not_asked(tmp_path):
    file = tmp_path / "robot.toml"
    file.write_text('[edges."odom -> base_footprint"]\nrate_hz = [1, 2]\n')
    (finding,) = deviations_from(read_expectations(file), profile(RECORDS))
    assert (finding.code, finding.severity, finding.child) == ("expected-rate", "warning", "base_footprint")


@pytest.mark.parametrize(("text", "reason"), CASES["nonsense"])
def test_a_file_of_expectations_that_says_nonsense_is_one_clear_line(text, reason, tmp_path, clean, capsys):
    file = tmp_path / "robot.toml"
    file.write_text(text)
    with pytest.raises(ExpectationError, match=reason):
        read_expectations(file)
    assert main(["doctor", clean, "--expect", str(file)]) == 2
    captured = capsys.readouterr()
    assert captured.out == "" and captured.err.count("\n") == 1


def test_expectations_written_on_the_command_line_hold_there_and_fail_for_another_robot(clean, late, tmp_path, capsys):
    file = str(tmp_path / "robot.toml")
    assert main(["doctor", clean, "--write-expectations", file]) == 0
    assert main(["doctor", clean, "--expect", file, "--fail-on", "warning"]) == 0
    assert main(["doctor", late, "--expect", file, "--fail-on", "warning"]) == 1
    assert "base_link -> shoulder comes later than it should" in " ".join(capsys.readouterr().out.split())
    assert main(["doctor", clean, "--write-expectations", file]) == 2  # nothing is overwritten


# -- what is let pass ------------------------------------------------------


@pytest.mark.parametrize(
    ("pattern", "left"),
    [("zero-quaternion", 0), ("zero-*", 0), ("gap", 1), ("zero-quaternion:/tf", 0), ("zero-quaternion:/scan", 1)],
)
def test_findings_are_ignored_by_code_and_place(pattern, left):
    report = diagnose_recording(recording_from_records(inject(RECORDS, "zero-quaternion", seed=1).records))
    (finding,) = report.findings
    topic_pattern = pattern if finding.topic == "/tf" else pattern.replace(":/tf", f":{finding.topic}")
    kept = filter_findings(report, [topic_pattern])
    assert (len(kept.findings), kept.ignored) == (left, 1 - left)


def test_a_baseline_lets_what_is_known_pass_and_nothing_else(broken, late, tmp_path, capsys):
    file = str(tmp_path / "known.json")
    assert main(["doctor", broken, "--write-baseline", file]) == 1
    assert main(["doctor", broken, "--baseline", file]) == 0
    assert main(["doctor", late, "--baseline", file, "--fail-on", "warning"]) == 1
    (tmp_path / "bad.json").write_text("[]")
    assert main(["doctor", late, "--baseline", str(tmp_path / "bad.json")]) == 2
    assert "not a baseline" in capsys.readouterr().err


# -- two recordings, and many ----------------------------------------------


def test_two_recordings_are_told_by_what_changed(clean, tmp_path, capsys):
    other = [r for r in RECORDS if r.stamped.child_frame_id != "camera_optical_frame"]
    child = other[0].stamped.child_frame_id
    assert {f.code for f in changes_between(profile(RECORDS), profile(RECORDS))} == set()
    shorter = [r for r in RECORDS if r.stamped.child_frame_id != child]
    (change,) = changes_between(profile(RECORDS), profile(shorter))
    assert (change.code, change.child) == ("expected-edge", child)
    (change,) = changes_between(profile(shorter), profile(RECORDS))
    assert (change.code, change.child) == ("unexpected-edge", child)
    second = write(tmp_path / "second", shorter)
    assert main(["doctor", clean, second]) == 1
    assert "what changed since" in capsys.readouterr().out


def test_many_recordings_are_a_table_and_one_that_cannot_be_read_is_a_line_of_it(clean, late, broken, tmp_path, capsys):
    (tmp_path / "cut.mcap").write_bytes(b"")
    assert main(["doctor", clean, late, broken, str(tmp_path / "cut.mcap")]) == 2
    lines = capsys.readouterr().out.splitlines()
    assert len(lines) == 5 and lines[0].split()[:3] == ["bag", "errors", "warnings"]
    assert "cannot be read" in lines[4] and lines[3].split()[1] == "1"
    for name in ("a_1", "a_2"):
        write(tmp_path / name, RECORDS)
    assert main(["doctor", str(tmp_path / "a_*"), "--table"]) == 0  # a pattern that the shell has left alone
    assert len(capsys.readouterr().out.splitlines()) == 3


# -- forms that machines read ----------------------------------------------


def reports():
    return [diagnose_recording(recording_from_records(inject(RECORDS, "zero-quaternion", seed=1).records, "d"))]


def test_junit_counts_what_fails_passes_and_was_not_made():
    root = ET.fromstring(junit_from_reports(reports(), ("error",)))
    (suite,) = root
    assert suite.attrib["failures"] == "1" and int(suite.attrib["tests"]) == len(suite)
    (failure,) = suite.iter("failure")
    assert "rotations of (0, 0, 0, 0)" in failure.attrib["message"]
    assert ET.fromstring(junit_from_reports(reports(), ()))[0].attrib["failures"] == "0"


def test_junit_is_xml_whatever_the_names_in_the_bag_are():
    evil = [r._replace(stamped=replace(r.stamped, frame_id="a\x07<&\"'")) for r in RECORDS[-5:]]
    made = diagnose_recording(recording_from_records([*RECORDS, *evil], "\x00<"))
    assert ET.fromstring(junit_from_reports([made], ("error",))).tag == "testsuites"


def test_sarif_names_rule_level_file_and_edge():
    run = json.loads(sarif_from_reports(reports(), ["my bags/drive"]))["runs"][0]
    (result,) = run["results"]
    assert run["tool"]["driver"]["rules"][result["ruleIndex"]]["id"] == result["ruleId"] == "zero-quaternion"
    assert result["level"] == "error"
    assert result["locations"][0]["physicalLocation"]["artifactLocation"]["uri"] == "my%20bags/drive"
    assert " -> " in result["locations"][0]["logicalLocations"][0]["fullyQualifiedName"]


def test_annotations_are_one_line_each_and_encoded():
    (line,) = annotations_from_reports(reports(), ["a,b:c"]).splitlines()
    assert line.startswith("::error file=a%2Cb%3Ac,title=") and "%0ANext%3A" not in line and "%0ANext: " in line


def test_files_are_written_once_and_never_over_another(clean, tmp_path):
    for option in ("--junit", "--sarif"):
        file = tmp_path / option.strip("-")
        assert main(["doctor", clean, option, str(file)]) == 0
        text = file.read_text(encoding="utf-8")
        assert main(["doctor", clean, option, str(file)]) == 2
        assert file.read_text(encoding="utf-8") == text


# -- what a killed recorder has left ----------------------------------------------------


def test_a_recording_that_is_cut_is_examined_as_far_as_it_goes_and_is_not_passed(tmp_path, capsys):
    write(tmp_path / "drive", RECORDS)
    file = tmp_path / "drive" / "drive.mcap"
    data = file.read_bytes()
    file.write_bytes(data[: len(data) // 2])
    assert main(["doctor", str(file), "--fail-on", "never"]) == 2
    said = capsys.readouterr()
    assert said.err.count("\n") == 1 and "read as far as it goes" in said.err
    assert "mcap recover drive.mcap" in said.out


def test_a_bag_that_cannot_be_read_is_an_error_in_every_form_that_ci_shows(tmp_path, clean, capsys):
    (tmp_path / "empty.bag").touch()
    refused = str(tmp_path / "empty.bag")
    assert main(["doctor", clean, refused, "--table", "--github", "--junit", str(tmp_path / "j.xml")]) == 2
    assert f"::error file={refused}::{refused}: the file is empty" in capsys.readouterr().out.splitlines()
    (error,) = ET.parse(tmp_path / "j.xml").getroot().iter("error")
    assert "the file is empty" in error.attrib["message"]


def test_of_several_robots_each_edge_is_expected_of_its_own(tmp_path):
    both = profile([*of_robot("r1", RECORDS), *of_robot("r2", RECORDS)])
    (tmp_path / "robots.toml").write_text(toml_from(expectations_from(both)), encoding="utf-8")
    expectations = read_expectations(tmp_path / "robots.toml")
    assert deviations_from(expectations, both) == []
    missing = deviations_from(expectations, profile(of_robot("r1", RECORDS)))
    assert codes(missing) == {"expected-edge"} and {finding.namespace for finding in missing} == {"/r2"}


def test_a_deviation_that_a_finding_explains_stands_under_it_and_alone_if_that_is_ignored(clean, tmp_path, capsys):
    late = write(tmp_path / "late", inject(RECORDS, "late-stamps", seed=1).records)
    rules = str(tmp_path / "robot.toml")
    assert main(["doctor", clean, "--write-expectations", rules]) == 0
    capsys.readouterr()
    main(["doctor", late, "--expect", rules, "--json"])
    (cause,) = [f for f in json.loads(capsys.readouterr().out)["findings"] if f["severity"] == "warning"]
    assert cause["code"] == "late-stamps" and "expected-delay" in {effect["code"] for effect in cause["effects"]}
    assert {effect["severity"] for effect in cause["effects"]} <= {"warning", "error"}
    main(["doctor", late, "--expect", rules, "--json", "--ignore", "late-stamps"])
    data = json.loads(capsys.readouterr().out)
    assert "expected-delay" in {f["code"] for f in data["findings"]} and data["let_pass"] == 1


def test_the_effects_of_a_cause_that_is_ignored_are_findings_and_those_in_a_baseline_are_not():
    report = diagnose_recording(recording_from_records(inject(RECORDS, "wrong-name", seed=1).records))
    (cause,) = report.of_severity("error")
    effects = {effect.code for effect in cause.effects}
    assert effects and codes(filter_findings(report, [cause.code]).findings) == effects
    kept = filter_findings(report, baseline=json.loads(baseline_from([report]))["known"])
    assert kept.findings == () and kept.ignored > len(effects)
