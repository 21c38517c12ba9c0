"""What a page brings in with one line."""

from __future__ import annotations

import json
import math

import pytest

from tflab.core import Transform
from tflab.workbook import lesson
from tflab.workbook.places import MARK

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


def test_the_drive_is_played_with_a_robot_a_laser_and_the_walls():
    words = lesson.show_drive(for_s=1.0).describe()
    assert "robot, 13 of 13 links" in words
    assert "laser scan, 90 points" in words
    assert "base_link    frame in map" in words


def test_a_queue_without_end_makes_data_old_and_a_short_one_keeps_it_young():
    from collections import deque

    endless = lesson.ages_of_decisions("endless", deque())
    short = lesson.ages_of_decisions("short", deque(maxlen=2))
    assert endless.values_s[-1] == pytest.approx(4.1)  # 80 decisions of 150 ms: the scan of 7.9 s is decided on at 12 s
    assert max(short.values_s) == pytest.approx(0.3)


def test_the_cloud_is_a_wall_two_metres_ahead_and_a_floor_below():
    assert set(lesson.wall_cloud()[:, 2]) == {2.0}
    assert set(lesson.floor_cloud()[:, 1]) == {0.4}
