"""What `tflab doctor` prints and writes, and what its exit status says."""

import json
import re
import string
from dataclasses import replace

import pytest

from tflab.bags.reader import read_bag
from tflab.bags.recording import recording_from_records
from tflab.cli import main
from tflab.core import StampedTransform, Transform
from tflab.core.transforms import TransformRecord
from tflab.doctor.collect_evidence import evidence_from_recording
from tflab.doctor.diagnose import diagnose_recording
from tflab.doctor.report import drawings
from tflab.doctor.report.drawings import draw_frames_at, draw_timeline
from tflab.doctor.report.html import html_from_report
from tflab.doctor.report.sentences import descriptions
from tflab.robots.teaching import TeachingRobot

from .conftest import write


def test_a_clean_bag_exits_with_0_and_says_so(clean, capsys):
    assert main(["doctor", str(clean)]) == 0
    out = capsys.readouterr().out
    assert out.startswith("clean: nothing is wrong\n")
    assert "43 checks made: 15 frames, " in out and " in 5.0 s.\n" in out and "With --edges: the rate" in out


def test_an_error_exits_with_1_and_names_edge_cause_and_next_command(broken, capsys):
    assert main(["doctor", str(broken)]) == 1
    text = capsys.readouterr().out
    assert re.search(r"ERROR {4}\w+ -> \w+ has rotations of \(0, 0, 0, 0\)", text)
    assert "TF_DENORMALIZED_QUATERNION" in text and "Why " in text and "Next  ros2 " in text


def test_an_unusable_bag_exits_with_2_and_one_line(tmp_path, capsys):
    (tmp_path / "x.mcap").write_bytes(b"")
    assert main(["doctor", str(tmp_path / "x.mcap")]) == 2
    captured = capsys.readouterr()
    assert captured.out == "" and captured.err.count("\n") == 1


def test_json_is_the_same_report_in_english_whatever_the_language(broken, capsys):
    assert main(["doctor", str(broken), "--json"]) == 1
    english = capsys.readouterr().out
    data = json.loads(english)
    (finding,) = data["findings"]
    assert finding["code"] == "zero-quaternion" and finding["faults"] == ["zero-quaternion"]
    assert finding["facts"]["count"] > 0 and finding["command"].startswith("ros2")
    assert data["checks_made"] and data["checks_not_made"] == []
    main(["doctor", str(broken), "--json", "--lang", "ko"])
    assert capsys.readouterr().out == english


def test_the_page_holds_its_pictures_and_asks_nobody(broken, tmp_path, capsys):
    page = tmp_path / "report.html"
    assert main(["doctor", str(broken), "--html", str(page)]) == 1
    text = page.read_text(encoding="utf-8")
    assert 'class="timeline"' in text and 'class="moment"' in text and 'href="#moment-1"' in text
    assert not re.search(r"""(src|href)\s*=\s*["']https?:|<script|@import|url\(http""", text)
    assert "TF_" not in capsys.readouterr().err  # the tree's buffer keeps its refusals to itself
    assert main(["doctor", str(broken), "--html", str(page)]) == 2
    assert page.read_text(encoding="utf-8") == text  # an existing report is left alone
    other = tmp_path / "other.html"
    main(["doctor", str(broken), "--html", str(other)])
    assert other.read_text(encoding="utf-8") == text


def test_names_in_a_bag_are_escaped_in_the_page(tmp_path):
    records = TeachingRobot().records(until_s=2.0)
    evil = [r._replace(stamped=r.stamped.__class__("<b>", "/<i>&", r.stamped.stamp_ns, r.stamped.transform))
            for r in records[-5:]]  # fmt: skip
    recording = read_bag(write(tmp_path / "evil", [*records, *evil]))
    page = html_from_report(diagnose_recording(recording), recording)
    assert "<b>" not in page and "<i>&" not in page and "&lt;b&gt;" in page


@pytest.mark.browser
@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_the_page_fits_a_telephone_and_a_desk_in_both_themes(broken, tmp_path, page, scheme):
    recording = read_bag(broken)
    file = tmp_path / "report.html"
    file.write_text(html_from_report(diagnose_recording(recording), recording), encoding="utf-8")
    page.emulate_media(color_scheme=scheme)
    for width in (390, 1100):
        page.set_viewport_size({"width": width, "height": 900})
        page.goto(file.as_uri())
        assert page.evaluate("document.documentElement.scrollWidth") <= width
        assert page.locator("article.error").count() == 1
        page.locator("a[href='#moment-1']").first.click()
        assert page.locator("#moment-1 line.axis-x").count() > 20  # every frame has its axes, in both views


@pytest.mark.browser
def test_on_paper_the_page_is_light_and_whole_also_for_whoever_reads_it_in_the_dark(broken, tmp_path, page):
    recording = read_bag(broken)
    file = tmp_path / "report.html"
    file.write_text(html_from_report(diagnose_recording(recording), recording), encoding="utf-8")
    paper = "getComputedStyle(document.body).backgroundColor"
    page.set_viewport_size({"width": 718, "height": 1000})  # an A4 page between its margins
    page.emulate_media(color_scheme="dark")
    page.goto(file.as_uri())
    assert page.evaluate(paper) == "rgb(23, 25, 28)"
    page.emulate_media(media="print", color_scheme="dark")
    assert page.evaluate(paper) == "rgb(253, 253, 251)"
    assert page.evaluate("[...document.querySelectorAll('figure')].every(f => f.scrollWidth <= f.clientWidth)")


def test_the_tree_names_both_owners_of_a_static_edge_and_a_circle():
    records = TeachingRobot().records(until_s=5.0)
    laser = next(record for record in records if record.stamped.child_frame_id == "laser_frame")
    moved = replace(laser.stamped, transform=Transform((0.5, 0.0, 0.0)))
    second = laser._replace(publisher="/static_sensor_broadcaster", stamped=moved)
    pairs = (("a", "b"), ("b", "a"))
    loop = [TransformRecord("/tf", 1, "", StampedTransform(p, c, 1, Transform()), False) for p, c in pairs]
    for told, text in (
        ([*records, second], "laser_frame has 2 publishers: /robot_state_publisher, /static_sensor_broadcaster."),
        (loop, "The frames form a loop"),
    ):
        recording = recording_from_records(told)
        assert text in html_from_report(diagnose_recording(recording), recording)


def frames_of(recording, *first):
    drawn = draw_frames_at(evidence_from_recording(recording), recording.end_ns, first)
    return [set(re.findall(r"<title>(.+?)</title>", view)) for view in drawn.split("<svg")[1:]]


def test_frames_far_away_are_in_the_first_picture_and_not_in_the_one_from_nearer():
    names = ["map", "odom", "base_link", *(f"part_{i}" for i in range(6))]
    steps = [Transform((30.0, 0.0, 0.0)), Transform((20.0, 0.0, 0.0)), *[Transform((0.1, 0.0, 0.0))] * 6]
    pairs = zip(["map", "odom", *["base_link"] * 6], names[1:], steps, strict=True)
    records = [TransformRecord("/tf_static", 1, "", StampedTransform(p, c, 1, t), True) for p, c, t in pairs]
    everything, near = frames_of(recording_from_records(records), "base_link", "part_3")
    assert everything == set(names)
    assert near == set(names[2:])


def test_names_in_the_picture_do_not_cover_each_other():
    places = {"base_link": (10.0, 10.0), "laser": (12.0, 11.0), "odom": (300.0, 10.0)}
    drawn = "".join(drawings._names(places, ("laser",)))
    assert re.findall(r"<text [^>]*>(\w+)<", drawn) == ["laser", "odom"]
    assert re.findall(r"<title>(\w+)<", drawn) == ["laser", "base_link", "odom"]


def test_a_lane_whose_periods_do_not_fit_its_bins_shows_no_holes():
    stamps = [round(i * 1e9 / 30) for i in range(600)]  # in each of 320 bins one or two
    poses = [StampedTransform("odom", "base_link", t, Transform((1e-9 * t, 0.0, 0.0))) for t in stamps]
    recording = recording_from_records([TransformRecord("/tf", s.stamp_ns, "", s, False) for s in poses])
    drawn = draw_timeline(evidence_from_recording(recording))
    assert set(re.findall(r'class="spoke" opacity="([\d.]+)"', drawn)) == {"0.90"}


# -- texts in both languages ---------------------------------------------------


def test_each_finding_has_the_same_blanks_in_both_languages():
    for code, description in descriptions().items():
        for text in filter(None, (*description[:3], description.likely, description.open)):
            named = [{name for _, name, _, _ in string.Formatter().parse(part) if name} for part in text]
            assert named[0] == named[1], code
        assert not (description.likely and description.open), code


def test_report_is_korean_on_request_in_the_terminal_and_on_the_page(broken, tmp_path, capsys):
    page = tmp_path / "report.html"
    assert main(["doctor", str(broken), "--lang", "ko", "--html", str(page)]) == 1
    text = capsys.readouterr().out
    assert text.startswith("broken: 오류 1개\n\n오류     ") and "변환의 회전이 (0, 0, 0, 0)입니다" in text
    assert '<html lang="ko">' in page.read_text(encoding="utf-8") and "변환의 회전이" in page.read_text(
        encoding="utf-8"
    )
