"""One message to wait for, and messages as bytes."""

import pytest

from tflab.ros import client_library as rclpy
from tflab.ros.graph import new_graph
from tflab.ros.messages.geometry_msgs import TransformStamped
from tflab.ros.messages.std_msgs import String
from tflab.ros.messages.tf2_msgs import FrameGraph, TFMessage
from tflab.ros.node import Node
from tflab.ros.qos import DurabilityPolicy, QoSProfile
from tflab.ros.serialization import deserialize_message, serialize_message
from tflab.ros.wait_for_message import wait_for_message


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


def test_one_message_is_waited_for_without_spinning(node):
    assert wait_for_message(String, node, "chatter") == (True, String(data="1"))
    assert wait_for_message(String, node, "chatter", time_to_wait=1.0) == (True, String(data="2"))


def test_after_its_time_the_wait_is_given_up(node):
    before = node.get_clock().now()
    assert wait_for_message(String, node, "silence", time_to_wait=0.3) == (False, None)
    assert (node.get_clock().now() - before).nanoseconds == 300_000_000


def test_what_was_published_before_comes_only_between_transient_locals(node):
    assert wait_for_message(String, node, "map_name", time_to_wait=0.3) == (False, None)
    latched = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    assert wait_for_message(String, node, "map_name", qos_profile=latched) == (True, String(data="kitchen"))


def test_nothing_is_left_of_the_subscription(node):
    wait_for_message(String, node, "chatter")
    assert [
        subscription.topic_name for subscription in node.subscriptions if subscription.topic_name == "/chatter"
    ] == []


def test_a_message_survives_the_wire():
    message = TFMessage(transforms=[TransformStamped(child_frame_id="base_link")])
    assert deserialize_message(serialize_message(message), TFMessage) == message


def test_the_bytes_are_cdr():
    #  little endian, then the length with the closing zero, the text, the zero
    assert serialize_message(String(data="hi")) == b"\x00\x01\x00\x00" + b"\x03\x00\x00\x00" + b"hi\x00"


def test_a_type_that_has_no_place_in_a_bag_is_refused():
    with pytest.raises(KeyError):
        serialize_message(FrameGraph.Response())


def test_a_raw_subscription_gets_bytes(node):
    received = []
    node.create_subscription(String, "chatter", received.append, 10, raw=True)
    while not received:
        rclpy.spin_once(node)
    assert deserialize_message(received[0], String) == String(data="1")
