"""RViz standing still: its list beside what it shows, and what lies wrong although it is Ok."""

from __future__ import annotations

import numpy as np
import pytest

from tflab.core import LookupException, Transform
from tflab.views.rviz_figure import describe_shown, draw_shown
from tflab.views.rviz_status import Display, LaserScan, MapCells, PointCloud2, RobotModel, look_through, points_of
from tflab.views.scene.drawing import Part

#   map -(2 m along x)-> base_link, which sees a wall at x = 5: one ray straight ahead, 3 m long, and one into the void
POSES = {"map": Transform(), "base_link": Transform((2.0, 0.0, 0.0))}
SCAN = LaserScan("base_link", 0, (3.0, np.inf), 0.0, 0.1)
MODEL = RobotModel({"base_link": (Part("box", (0.4, 0.2, 0.1)), Part("cylinder", (0.05, 0.1)), Part("sphere", (0.1,)))})
WALL = ((5.0, -1.0), (5.0, 1.0))


def shown(fixed_frame="map", scan=SCAN, poses=POSES):
    def ask(target, source, stamp_ns):
        if target not in poses or source not in poses:
            raise LookupException(f"no {target} or {source}")
        return poses[target].inverse() @ poses[source]

    displays = (
        Display("Map", (MapCells("map", 0, [(5.0, 0.0)]),), "/map"),
        Display("RobotModel", MODEL, "/robot_description"),
        Display("LaserScan", (scan,), "/scan"),
    )
    return look_through(fixed_frame, {"map": "", "base_link": "map"}, displays, ask)


def written(picture):
    return [text.get_text() for text in picture.figure.texts]


def test_what_is_ok_has_one_row_with_a_sign_and_a_word():
    assert written(draw_shown(shown())) == [
        "✓ Global Status: Ok",
        "✓ TF: Ok",
        "✓ Map (/map): Ok",
        "✓ RobotModel (/robot_description): Ok",
        "✓ LaserScan (/scan): Ok",
    ]


def test_what_is_not_says_why_in_rviz_words():
    rows = written(draw_shown(shown("Map")))
    assert rows[:2] == ["✗ Global Status: Error", "Fixed Frame: Frame [Map] does not exist"]
    assert "✗ Map (/map): Error" in rows and "Transform: Could not transform from [map] to [Map]" in rows


def test_many_lines_of_one_kind_are_counted():
    parts = {f"finger_{i}": (Part("sphere", (0.01,)),) for i in range(5)}
    display = Display("RobotModel", RobotModel(parts), "/robot_description")

    def ask(target, source, stamp_ns):
        raise LookupException("no")

    rows = written(draw_shown(look_through("map", {"map": ""}, (display,), ask)))
    assert "finger_1: No transform from [finger_1] to [map]" in rows and "… 3 more" in rows
    assert not any("finger_2" in row for row in rows)


def test_ok_says_nothing_of_the_walls_and_the_words_measure_it():
    late = draw_shown(shown(poses={**POSES, "base_link": Transform((1.6, 0.0, 0.0))}), [WALL])
    assert "LaserScan (/scan): Ok" in late.text
    assert "LaserScan: 1 points, off the walls by 0.400 m on average, 0.400 m at worst" in late.text
    assert "off the walls by 0.000 m" in describe_shown(shown(), [WALL])


def test_a_link_is_drawn_as_its_outline_from_above():
    assert "map at (-2.000, 0.000, 0.000) m" in draw_shown(shown("base_link")).text
    assert points_of(PointCloud2("base_link", 0, [(1.0, 2.0, 3.0)])).tolist() == [[1.0, 2.0, 3.0]]
    assert points_of(SCAN).tolist() == [[3.0, 0.0, 0.0]]
    ax = draw_shown(shown()).figure.axes[0]
    box = ax.patches[0].get_xy()
    assert box.min(axis=0) == pytest.approx((1.8, -0.1)) and box.max(axis=0) == pytest.approx((2.2, 0.1))
    assert len(box) == 5  # four corners, and the first again
