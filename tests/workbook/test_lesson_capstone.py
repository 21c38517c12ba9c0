"""A robot that was only written down is launched as it was written, right or wrong."""

from __future__ import annotations

import json
from pathlib import Path
from types import SimpleNamespace

import pytest
import yaml

from tflab.workbook import lesson
from tflab.workbook.paths import MARK

CASES = yaml.safe_load(Path(__file__).with_suffix(".yaml").read_text(encoding="utf-8"))

ASKED = SimpleNamespace(robot="alpha", sensor="rgb", fused=True)
SEEN, FEET = "alpha/rgb_optical_frame", "alpha/odom -> alpha/base_footprint"
FRAMES = ("odom", "base_footprint", "base_link", "rgb_link", "rgb_optical_frame")


def robot(prefix="alpha/", parents=(), **parts):
    """Return a right answer, but for a prefix, some parents (child, parent), and some parts."""
    names = [prefix + name for name in FRAMES]
    return {
        "tree": {**dict(zip(names, ["map", *names], strict=False)), **dict(parents)},
        "moving": "/tf",
        "mounts": "/tf_static",
        "odom owner": "ekf_filter_node",
        "mounts owner": "robot_state_publisher",
        "wheel_odometry publish_tf": False,
        "ekf publish_tf": True,
        "camera_driver publish_tf": False,
        "bag": {"/tf", "/tf_static"},
        **{name.replace("__", " "): part for name, part in parts.items()},
    }


def seen_of(answer, capsys):
    view = lesson.launch_answer(answer, ASKED)
    lesson.current_graph().stop()
    assert view.fixed_frame == "map"
    view.close()
    return [" ".join(line.split()) for line in capsys.readouterr().out.splitlines()]


def test_a_right_robot_stands_on_the_map_with_one_owner_for_each_edge(capsys):
    lines = seen_of(robot(), capsys)
    assert "TF: Ok" in lines and "PointCloud2 (/alpha/points): Ok" in lines
    assert lines[lines.index("Which node publishes which edge, in 3 s") + 1 :] == CASES["seen"]


@pytest.mark.parametrize(
    ("wrong", "seen"),
    [
        ({"prefix": ""}, f"Transform: For frame [{SEEN}]: Frame [{SEEN}] does not exist"),
        ({"wheel_odometry__publish_tf": True}, f"{FEET} /alpha/wheel_odometry /tf 20 Hz ! 2 owners"),
        ({"ekf__publish_tf": False}, "alpha/odom -> alpha/base_footprint nobody ! 0"),
        ({"camera_driver__publish_tf": True}, f"alpha/rgb_link -> {SEEN} /alpha/camera_driver /tf_static ! 2 owners"),
        ({"mounts": "/tf"}, "alpha/base_footprint -> alpha/base_link /alpha/robot_state_publisher /tf 20 Hz"),
        ({"moving": "/tf_static"}, "alpha/rgb_optical_frame did not move in map."),
        ({"parents": [("alpha/base_footprint", "map")]}, f"{FEET} /alpha/ekf_filter_node /tf 20 Hz ! 2 parents"),
        ({"parents": [("alpha/base_link", "alpha/odm")]}, "alpha/odm: No transform from [alpha/odm] to frame [map]"),
    ],
)  # fmt: skip
def test_a_wrong_robot_shows_what_a_real_one_would(wrong, seen, capsys):
    assert seen in seen_of(robot(**wrong), capsys)


def test_what_is_no_robot_yet_is_not_launched(capsys):
    for nothing in (..., None, {}, {"tree": {}}, {"tree": {"alpha/odom": ...}}, {"tree": {"map": ["odom"]}}):
        assert lesson.launch_answer(nothing, ASKED) is None
        assert "no robot yet" in capsys.readouterr().out


def test_without_a_specification_it_says_where_one_comes_from():
    with pytest.raises(TypeError, match=r'e12_5 = task\("E12.5"\)'):
        lesson.launch_answer(robot(), None)


def test_a_korean_copy_hears_of_it_in_korean(tmp_path, monkeypatch, capsys):
    mark = {"tflab": "0.1.0", "edition": "self-study", "language": "ko", "learner": None}
    (tmp_path / MARK).write_text(json.dumps(mark))
    monkeypatch.chdir(tmp_path)
    lines = seen_of(robot(bag={"/tf"}), capsys)
    assert "내일 재생할 bag의 토픽: /tf. 영상 17장 가운데 0장의 위치를 map 기준으로 구할 수 있습니다." in lines
