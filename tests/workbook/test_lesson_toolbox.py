"""What ROS 2's tools print on a page, and robots with a fault that RViz does not show."""

from __future__ import annotations

import pytest

from tflab.workbook import lesson
from tflab.workbook.lesson import toolbox


def test_each_tool_prints_what_it_has_and_only_one_names_the_rate_of_an_edge():
    lesson.start_robot()
    said = {tool.name: tool.output for tool in toolbox.say_tools()}
    lesson.new_graph()
    assert (
        '"odom" -> "base_footprint"\n    Broadcaster: default_authority\n    Average rate: 20.204'
        in said["view_frames"]
    )
    assert "Net delay     avg = 0.0209299: max = 0.11" in said["tf2_monitor"]
    assert "average rate: 50.000" in said["topic hz"]
    assert "average delay: 0.105" in said["topic delay"]
    assert "Publisher count: 3" in said["topic info"]


@pytest.mark.parametrize(
    ("name", "off"), [("healthy", "0.052"), ("mount", "0.205"), ("header", "0.117"), ("clock", "0.303")]
)
def test_the_list_of_a_disguised_robot_is_all_ok_and_its_points_lie_beside_the_walls(name, off):
    lesson.start_robot(name)
    picture = lesson.draw_rviz(until_s=25.0)
    lesson.new_graph()
    assert "Error" not in picture.text and "Warn" not in picture.text
    assert f"off the walls by {off} m on average" in picture.text


def test_a_robot_or_a_node_that_is_not_there_is_refused():
    with pytest.raises(ValueError, match="no robot 'sick'"):
        lesson.start_robot("sick")
    lesson.start_robot()
    with pytest.raises(ValueError, match="no node 'localisation' runs; there is imu_driver"):
        lesson.stop_node("localisation")
    lesson.stop_node("localization")
    lesson.stop_node("localization")  # by a cell that runs again
    lesson.new_graph()
