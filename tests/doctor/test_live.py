"""Listening to a robot: through rclpy's own calls, here those of the in-process one."""

import sys

import pytest

import tflab.ros as ros
from tflab.bags.listen import ReceivedRecords
from tflab.cli import main
from tflab.doctor import examine
from tflab.doctor.api import recording_from_ros
from tflab.doctor.diagnose import diagnose_recording
from tflab.robots.nodes import launch
from tflab.ros.graph import new_graph
from tflab.ros.messages import sensor_msgs
from tflab.ros.messages.values import serialize_message
from tflab.ros.node import Node
from tflab.tools import ros2

STATIC = ["run", "tf2_ros", "static_transform_publisher", "--frame-id", "base_link", "--child-frame-id"]


@pytest.fixture
def graph():
    ros.activate("in-process")
    graph = new_graph()
    yield graph
    graph.stop()
    ros.deactivate()
    new_graph()


def test_a_robot_is_heard_through_rclpy_with_its_publishers_by_name(graph):
    launch(graph)
    recording = recording_from_ros(3.0)
    assert {label.publisher for label in recording.transforms.labels} >= {"/wheel_odometry", "/robot_state_publisher"}
    assert {header.topic for header in recording.headers} >= {"/scan"}
    assert diagnose_recording(recording).of_severity("error", "warning") == ()


def test_of_a_scan_only_the_header_is_read_and_of_transforms_all(graph, monkeypatch):
    asked = {}
    subscribe = Node.create_subscription

    def note(self, message_class, topic, callback, profile, **options):
        asked[topic] = options.get("raw", False)
        return subscribe(self, message_class, topic, callback, profile, **options)

    launch(graph)
    graph.run(seconds=1.0)
    monkeypatch.setattr(Node, "create_subscription", note)
    recording = recording_from_ros(2.0)
    assert asked["/scan"] is True and asked["/tf"] is False and asked["/tf_static"] is False
    (scan,) = (header for header in recording.headers if header.topic == "/scan")
    assert scan.frames == ("laser_frame",) and len(scan.stamp_ns) >= 8


def test_a_header_is_the_same_whether_the_message_is_read_or_stays_bytes():
    image = sensor_msgs.Image()
    image.header.frame_id = "camera_optical_frame"
    image.header.stamp.sec, image.header.stamp.nanosec = 3, 5
    image.data = bytes(300)
    read, raw = ReceivedRecords(), ReceivedRecords()
    read.add("/image", image.ROS_TYPE, "/camera", 7, image)
    raw.add_raw("/image", image.ROS_TYPE, "/camera", 7, serialize_message(image))
    for received in (read, raw):
        (header,) = received.recording("live").headers
        assert (header.stamp_ns.tolist(), header.receive_ns.tolist()) == ([3_000_000_005], [7])
        assert header.frames == ("camera_optical_frame",)


def test_bytes_that_are_no_message_are_told_and_do_not_end_the_listening():
    received = ReceivedRecords()
    for data in (b"", b"\0\1\0\0\5", b"\0\7\0\0" + bytes(20)):
        received.add_raw("/image", "sensor_msgs/msg/Image", "/camera", 7, data)
    assert received.recording("live").notes == ("3 messages on /image could not be read and were passed over",)


def test_without_ros_it_says_what_to_do_and_ends_with_2(monkeypatch, capsys):
    monkeypatch.setitem(sys.modules, "rclpy", None)
    assert main(["doctor", "--live", "1"]) == 2
    text = capsys.readouterr().err
    assert "setup.bash" in text and "ros2 bag record" in text and text.count("\n") == 1


def codes_of(graph, seconds=4.0):
    return {finding.code for finding in examine(graph, seconds=seconds).findings}


def test_a_clock_that_is_off_on_another_computer_is_named_and_not_a_late_network(graph):
    launch(graph)
    graph.set_clock_offset("laser_driver", 1.0)
    graph.set_clock_offset("wheel_odometry", -0.5)
    codes = codes_of(graph)
    assert "messages-early" in codes  # the headers of a living graph are read, too
    assert "all-late" not in codes and codes & {"late-stamps", "messages-late", "clock-offset"}


def test_a_late_network_is_not_called_two_clocks_and_a_mount_is_not_missed(graph):
    launch(graph)
    for topic in ("/tf", "/scan", "/odom", "/imu", "/joint_states", "/detected_point"):
        graph.disturb(topic, delay=0.5)
    assert codes_of(graph) == {"all-late"}
    graph.start(ros2.main, [*STATIC, "radar"])
    assert "statics-missing" not in codes_of(graph, seconds=3.0)
