"""Wait for a message, serialize messages, and print them as `ros2 topic echo` does."""

import numpy as np
import pytest

from tflab.ros import client_library as rclpy
from tflab.ros.client_library import wait_for_message
from tflab.ros.graph import new_graph
from tflab.ros.messages.geometry_msgs import PoseWithCovariance, TransformStamped
from tflab.ros.messages.sensor_msgs import JointState, LaserScan
from tflab.ros.messages.std_msgs import Byte, String
from tflab.ros.messages.text import TRUNCATE_LENGTH, message_to_dict, message_to_yaml
from tflab.ros.messages.tf2_msgs import FrameGraph, TFMessage
from tflab.ros.messages.values import deserialize_message, serialize_message
from tflab.ros.node import Node
from tflab.ros.qos import DurabilityPolicy, QoSProfile


@pytest.fixture
def node():
    graph = new_graph()
    graph.start(talker)
    rclpy.init(args=[])
    yield Node("listener")
    rclpy.shutdown()
    graph.stop()


def talker():
    """Says a number every 0.5 s."""
    rclpy.init()
    node = Node("talker")
    publisher = node.create_publisher(String, "chatter", 10)
    latched = node.create_publisher(
        String, "map_name", QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    )
    latched.publish(String(data="kitchen"))
    said = []

    def tick():
        said.append(1)
        publisher.publish(String(data=str(len(said))))

    node.create_timer(0.5, tick)
    rclpy.spin(node)


def test_one_message_is_waited_for_without_spinning_until_a_timeout(node):
    assert wait_for_message(String, node, "chatter") == (True, String(data="1"))
    assert wait_for_message(String, node, "chatter", time_to_wait=1.0) == (True, String(data="2"))
    assert "/chatter" not in [subscription.topic_name for subscription in node.subscriptions]
    before = node.get_clock().now()
    assert wait_for_message(String, node, "silence", time_to_wait=0.3) == (False, None)
    assert (node.get_clock().now() - before).nanoseconds == 300_000_000


def test_what_was_published_before_comes_only_between_transient_locals(node):
    assert wait_for_message(String, node, "map_name", time_to_wait=0.3) == (False, None)
    latched = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    assert wait_for_message(String, node, "map_name", qos_profile=latched) == (True, String(data="kitchen"))


def test_the_bytes_are_cdr():
    #  little endian, then the length with the closing zero, the text, the zero
    assert serialize_message(String(data="hi")) == b"\x00\x01\x00\x00" + b"\x03\x00\x00\x00" + b"hi\x00"
    message = TFMessage(transforms=[TransformStamped(child_frame_id="base_link")])
    assert deserialize_message(serialize_message(message), TFMessage) == message
    with pytest.raises(KeyError):
        serialize_message(FrameGraph.Response())  # which has no place in a bag


def test_a_raw_subscription_gets_bytes(node):
    received = []
    node.create_subscription(String, "chatter", received.append, 10, raw=True)
    while not received:
        rclpy.spin_once(node)
    assert deserialize_message(received[0], String) == String(data="1")


def test_a_message_is_written_as_echo_prints_it():
    assert message_to_yaml(TFMessage()) == "transforms: []\n"
    assert message_to_yaml(String()) == "data: ''\n"
    assert message_to_yaml(String(data="hi"), flow_style=True) == "{data: hi}\n"
    assert message_to_yaml(String(data="지도")) == "data: 지도\n"
    assert message_to_dict(Byte(data=b"A"))["data"] == "A"
    covariance = message_to_dict(PoseWithCovariance(covariance=np.arange(36.0)))["covariance"]
    assert covariance == [float(i) for i in range(36)]
    assert all(type(value) is float for value in covariance)


def test_sequences_and_strings_longer_than_128_are_truncated():
    assert TRUNCATE_LENGTH == 128
    cut = message_to_dict(LaserScan(ranges=[1.0] * 129), truncate_length=128)["ranges"]
    assert cut == [1.0] * 128 + ["..."]
    assert message_to_dict(LaserScan(ranges=[1.0] * 128), truncate_length=128)["ranges"] == [1.0] * 128
    assert message_to_dict(String(data="x" * 130), truncate_length=128)["data"] == "x" * 128 + "..."
    assert message_to_yaml(JointState(name=["a", "b"]), truncate_length=1).splitlines()[5:8] == [
        "name:",
        "- a",
        "- '...'",
    ]


def test_without_arrays_and_strings_their_type_and_length_is_left():
    values = message_to_dict(LaserScan(ranges=[1.0, 2.0]), no_arr=True, no_str=True)
    assert values["ranges"] == "<sequence type: float, length: 2>"
    assert values["header"]["frame_id"] == "<string length: <0>>"
    assert message_to_dict(PoseWithCovariance(), no_arr=True)["covariance"] == "<array type: double[36]>"
    assert message_to_dict(TFMessage(), no_arr=True)["transforms"] == (
        "<sequence type: geometry_msgs/msg/TransformStamped, length: 0>"
    )
