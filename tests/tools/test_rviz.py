"""A look at a graph: what RViz would have to show, and what it says when it cannot."""

from pathlib import Path

import numpy as np
import pytest
import yaml
from IPython.core.interactiveshell import InteractiveShell

from tflab.ros import client_library as rclpy
from tflab.ros.messages import geometry_msgs, nav_msgs, sensor_msgs, std_msgs
from tflab.ros.node import Node
from tflab.ros.qos import DurabilityPolicy, QoSProfile, qos_profile_sensor_data
from tflab.tools import magic
from tflab.tools.rviz import look, open_rviz
from tflab.views.rviz_status import look_through, statuses_as_text

from .robot import fixed, moving, spin, transform

CASES = yaml.safe_load(Path(__file__).with_suffix(".yaml").read_text(encoding="utf-8"))

LATCHED = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
URDF = CASES["urdf"]


def sensor(topic, make, qos=qos_profile_sensor_data, period_s=0.1):
    """A main function that publishes `make(header)` in laser_frame."""

    def main():
        rclpy.init()
        node = Node("sensor")
        header = std_msgs.Header(frame_id="laser_frame")
        publisher = node.create_publisher(type(make(header)), topic, qos)

        def tick():
            header.stamp = transform(node, "a", "b").header.stamp
            publisher.publish(make(header))

        node.create_timer(period_s, tick)
        spin(node)

    return main


def scan(header):
    return sensor_msgs.LaserScan(
        header=header, angle_min=-1.0, angle_increment=1.0, range_min=0.5, range_max=5.0, ranges=[0.1, 2.0, 9.0]
    )


def said(seen, fixed_frame):
    return statuses_as_text(look_through(fixed_frame, *seen))


@pytest.fixture
def robot(graph):
    graph.start(moving())
    graph.start(fixed())
    graph.run(seconds=1)
    return graph


def test_a_scan_stands_where_its_laser_was_at_its_stamp(robot):
    robot.start(sensor("/scan", scan))
    assert len(look(robot, seconds=1.0, decay_s=0.35).displays[0].content) == 4
    seen = look(robot)
    (display,) = seen.displays
    (message,) = display.content
    assert (display.kind, display.topic, message.frame_id) == ("LaserScan", "/scan", "laser_frame")
    assert list(message.ranges_m) == [np.inf, 2.0, np.inf]  # too near and too far are left out
    expected_x = message.stamp_ns / 1e9 - 1.0 + 0.2  # the robot drives 1 m/s, the laser is 0.2 m ahead
    assert seen.ask("odom", "laser_frame", message.stamp_ns).translation[0] == pytest.approx(expected_x)
    assert "Showing [1] points from [1] messages" in said(seen, "odom")


@pytest.mark.parametrize(("delay_s", "period_s", "frame", "status"), CASES["statuses"])
def test_a_message_waits_for_a_transform_that_is_late_and_no_longer(robot, delay_s, period_s, frame, status):
    robot.disturb("/tf", delay=delay_s)
    robot.start(sensor("/scan", scan, period_s=period_s))
    assert status in said(look(robot), frame)


def test_a_healthy_robot_is_no_error_though_its_first_scans_came_before_its_transforms(graph):
    graph.start(sensor("/scan", scan))
    graph.run(seconds=0.5)
    graph.start(moving())
    graph.start(fixed())
    seen = look(graph, seconds=2.0, decay_s=2.0)
    graph.run(seconds=0.1)
    assert len(seen.displays[0].content) > 15
    assert "Transform: Ok" in said(seen, "odom")


def test_a_scan_older_than_all_transforms_is_an_error_in_rviz_words(graph):
    early = std_msgs.Header(frame_id="laser_frame")
    early.stamp.nanosec = 500_000_000
    graph.start(sensor("/scan", lambda header: scan(early)))
    graph.start(moving())
    graph.start(fixed())
    assert "Lookup would require extrapolation into the past." in said(look(graph), "odom")


def test_a_robot_has_its_links_without_meshes(robot):
    robot.start(sensor("/robot_description", lambda header: std_msgs.String(data=URDF), LATCHED))
    (display,) = look(robot).displays
    (part,) = display.content.links["base_link"]
    assert (part.shape, part.size, part.rgba) == ("box", (0.4, 0.3, 0.2), (1.0, 0.0, 0.0, 1.0))
    assert part.link_T_part.translation == (0.0, 0.0, 0.1)


def test_a_path_and_a_map(robot):
    def path(header):
        pose = geometry_msgs.PoseStamped()
        pose.pose.position.x = 2.0
        return nav_msgs.Path(header=header, poses=[pose])

    def grid(header):
        info = nav_msgs.MapMetaData(resolution=0.5, width=2, height=2)
        info.origin.position.x = -1.0
        return nav_msgs.OccupancyGrid(header=header, info=info, data=[0, 100, -1, 0])

    robot.start(sensor("/plan", path, 10))
    robot.start(sensor("/map", grid, LATCHED))
    shown_map, shown_path = look(robot).displays
    assert shown_path.content[0].points == [(2.0, 0.0, 0.0)]
    assert shown_map.content[0].cells.tolist() == [[-0.25, 0.25]]  # row 0, column 1: from -1 m, 1.5 cells of 0.5 m


def test_what_cannot_be_read_is_named_and_left_out(robot, capsys):
    robot.start(sensor("/robot_description", lambda header: std_msgs.String(data="<robt/>"), LATCHED))
    robot.start(sensor("/points", lambda header: sensor_msgs.PointCloud2(header=header)))
    assert look(robot).displays == ()
    said = capsys.readouterr().out.splitlines()
    assert said[0].startswith("/points cannot be shown: ")
    assert said[1].startswith("/robot_description cannot be shown: ")


def test_a_view_of_the_graph_and_then_of_the_graph_later(robot):
    view = open_rviz(robot, "odom")
    assert "base_link" in view.text
    before = view.text
    view.update(*look(robot))
    assert view.text != before


def test_rviz2_in_a_page_shows_the_view(robot, monkeypatch, capsys):
    shown = []
    monkeypatch.setattr("IPython.display.display", lambda *views: shown.extend(views))
    shell = InteractiveShell()
    magic.register(shell)
    shell.run_line_magic("rviz2", "--for 0.5 -f odom")
    shell.run_line_magic("ros2", "--for 0.5 run rviz2 rviz2 -f laser_frame")
    magic.rviz2_line("--nope")
    assert [view.fixed_frame for view in shown] == ["odom", "laser_frame"]
    assert "rviz2: error: unrecognized arguments: --nope" in capsys.readouterr().err
