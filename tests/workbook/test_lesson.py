"""What a page brings in with one line: drawings, panels and the first question."""

from __future__ import annotations

import json
import math
from dataclasses import asdict

import pytest

from tflab.core import Transform
from tflab.workbook import lesson
from tflab.workbook.paths import MARK, Workbook

POSES = {"base_link": Transform(), "laser_frame": Transform.from_rpy(yaw=math.pi / 2, translation=(0.2, 0.0, 0.15))}


@pytest.mark.parametrize(("language", "words"), [("en", ", wanted in"), ("ko", "기준으로 표현된 데이터를")])
def test_the_sentence_of_a_panel_is_in_the_language_of_the_copy(language, words, tmp_path, monkeypatch):
    mark = {"tflab": "0.1.0", "edition": "self-study", "language": language, "learner": None}
    (tmp_path / MARK).write_text(json.dumps(mark))
    monkeypatch.chdir(tmp_path)
    panel = lesson.sentence_panel(POSES, "base_link", "laser_frame")
    labels = [child.value for child in panel.widget.children[0].children if not hasattr(child, "options")]
    assert words in labels
    panel.close()


def test_the_cloud_is_a_wall_two_metres_ahead_and_a_floor_below():
    assert set(lesson.wall_cloud()[:, 2]) == {2.0}
    assert set(lesson.floor_cloud()[:, 1]) == {0.4}


def test_the_drive_is_played_with_a_robot_a_laser_and_the_walls():
    words = lesson.show_drive(for_s=1.0).describe()
    assert "robot, 13 of 13 links" in words
    assert "laser scan, 90 points" in words
    assert "base_link    frame in map" in words


@pytest.mark.parametrize(
    ("answer", "said"),
    [
        ((2.0, 0.5, 0.0), "These are the laser's numbers with another label."),
        ((1.8, 0.5, -0.15), "You subtracted the position of the laser."),
        ((2.0, 0.5, 0.15), "the distance ahead is still the laser's"),
        ((2.2, 0.5, 0.15), "First question ✓ 1/1 point\n"),
        (..., "in place of the dots, and run the cell again"),
    ],
)
def test_the_first_question_has_a_reply_to_each_mistake_and_keeps_nothing(answer, said, tmp_path, monkeypatch, capsys):
    (tmp_path / MARK).write_text(json.dumps(asdict(Workbook())))
    monkeypatch.chdir(tmp_path)
    lesson.ask_first(answer)
    assert said in capsys.readouterr().out
    assert [path.name for path in tmp_path.iterdir()] == [MARK]


def test_a_queue_without_end_makes_data_old_and_a_short_one_keeps_it_young():
    from collections import deque

    endless = lesson.ages_of_decisions("endless", deque())
    short = lesson.ages_of_decisions("short", deque(maxlen=2))
    assert endless.values_s[-1] == pytest.approx(4.1)  # 80 decisions of 150 ms: the scan of 7.9 s is decided on at 12 s
    assert max(short.values_s) == pytest.approx(0.3)


def test_the_arm_is_drawn_as_its_urdf_says_and_the_lines_of_a_joint_stand_beside_it():
    picture = lesson.draw_joints(
        {"shoulder_joint": 0.5, "elbow_joint": -0.6, "wrist_joint": 0.4}, touched="elbow_joint"
    )
    # in the plane of the arm: 0.25 cos 0.6 + 0.32 cos 0.2 = 0.520 ahead and 0.25 sin 0.6 + 0.32 sin 0.2 = 0.205 up,
    # turned by 0.5 about the shoulder, which is 0.1 behind and, with the elbow, 0.15 above
    assert picture.text.splitlines()[0] == "tcp in base_link: (0.356, 0.249, 0.355) m"
    assert '  <origin xyz="0.0 0.0 0.10" rpy="0.0 0.0 0.0"/>' in picture.text
    panel = lesson.joints_panel()
    assert list(panel.controls) == ["shoulder_joint [rad]", "elbow_joint [rad]", "wrist_joint [rad]"]
    assert panel.text.startswith("tcp in base_link: (0.470, 0.000, 0.150) m")
    panel.close()


def test_a_chain_that_the_robot_has_not_got_is_refused_with_what_there_is():
    with pytest.raises(KeyError, match="has no joint 'elbow'"):
        lesson.draw_joints({"elbow": 0.1})


@pytest.mark.parametrize(
    ("child", "parent", "said"),
    [
        ("odom", "laser_frame", "LookupException: The tf tree is invalid because it contains a loop."),
        ("base_link", "odm", "ConnectivityException: Could not find a connection between 'map' and 'base_link'"),
        ("odom", "odom", 'TF_SELF_TRANSFORM: Ignoring transform from authority "node"'),
    ],
)
def test_a_tree_that_is_broken_in_a_panel_is_answered_as_tf2_does(child, parent, said):
    panel = lesson.tree_panel({"odom": "map", "base_link": "odom", "laser_frame": "base_link"}, "map", "base_link")
    panel.controls["move"].value, panel.controls["under"].value = child, parent
    assert said in panel.text
    panel.close()


def test_a_scan_lies_on_the_walls_where_the_drawing_says_what_the_screws_do_and_nowhere_else():
    from tflab.views.map_error import point_errors

    screws = {"laser_frame": Transform.from_rpy(yaw=math.pi / 2, translation=(0.2, 0.0, 0.15))}
    as_drawn = point_errors(lesson.scan_on_map(lesson.TeachingRobot(), at_s=1.0), lesson.ROOM.walls)
    otherwise = point_errors(lesson.scan_on_map(lesson.TeachingRobot(screws=screws), 1.0), lesson.ROOM.walls)
    assert as_drawn.worst_m < 0.03  # the laser's noise: 5 mm, three times
    assert otherwise.mean_m > 1.0
