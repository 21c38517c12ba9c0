"""Bad input gets the error that ROS 2 gives, loses nothing, and hangs nothing."""

import pytest

from tflab.ros import client_library as rclpy
from tflab.ros.exceptions import (
    InvalidNamespaceException,
    InvalidNodeNameException,
    InvalidTopicNameException,
    NotInitializedException,
    NoTypeSupportImportedException,
)
from tflab.ros.graph import new_graph
from tflab.ros.messages.geometry_msgs import PointStamped, Vector3
from tflab.ros.messages.std_msgs import String
from tflab.ros.messages.tf2_msgs import TFMessage
from tflab.ros.node import Node
from tflab.ros.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy


@pytest.fixture
def graph():
    made = new_graph()
    yield made
    made.stop()


@pytest.fixture
def node(graph):
    rclpy.init(args=[])
    yield Node("talker")
    rclpy.shutdown()


# Names ----------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("name", "error", "text"),
    [
        (
            "my node",
            InvalidNodeNameException,
            "Invalid node name: node name must not contain characters other than alphanumerics or '_':\n"
            "  'my node'\n"
            "     ^",
        ),
        (
            "2fast",
            InvalidNodeNameException,
            "Invalid node name: node name must not start with a number:\n  '2fast'\n   ^",
        ),
    ],
)
def test_a_bad_node_name_is_refused_with_a_caret_under_the_character(node, name, error, text):
    with pytest.raises(error) as refusal:
        Node(name)
    assert str(refusal.value) == text


def test_a_bad_namespace_is_refused(node):
    with pytest.raises(InvalidNamespaceException):
        Node("n", namespace="robot 1")


@pytest.mark.parametrize("topic", ["my topic", "a//b", "a/", "1scan", ""])
def test_a_bad_topic_name_is_refused(node, topic):
    with pytest.raises(InvalidTopicNameException):
        node.create_publisher(String, topic, 10)
    with pytest.raises(InvalidTopicNameException):
        node.create_subscription(String, topic, print, 10)


@pytest.mark.parametrize(
    ("name", "absolute"),
    [("scan", "/robot1/scan"), ("/scan", "/scan"), ("~/scan", "/robot1/driver/scan")],
)
def test_a_relative_name_gets_the_namespace_and_a_tilde_the_node(node, name, absolute):
    driver = Node("driver", namespace="robot1")
    assert driver.create_publisher(String, name, 10).topic_name == absolute


# Before init, and after -----------------------------------------------------------


def test_a_node_before_init_is_refused(graph):
    with pytest.raises(NotInitializedException, match="cannot create node") as refusal:
        Node("early")
    assert str(refusal.value) == "rclpy.init() has not been called. msg:cannot create node"


def test_init_twice_and_shutdown_without_init_are_refused(graph):
    with pytest.raises(RuntimeError, match="Context must be initialized before it can be shutdown"):
        rclpy.shutdown()
    rclpy.init(args=[])
    with pytest.raises(RuntimeError, match=r"Context.init\(\) must only be called once"):
        rclpy.init(args=[])
    rclpy.shutdown()
    rclpy.init(args=[])  # a new default context
    rclpy.shutdown()


# Messages and QoS -----------------------------------------------------------------


def test_another_type_than_the_topics_cannot_be_published(node):
    publisher = node.create_publisher(PointStamped, "point", 10)
    with pytest.raises(TypeError) as refusal:
        publisher.publish(Vector3())
    assert str(refusal.value) == (
        "Expected <class 'geometry_msgs.msg._point_stamped.PointStamped'>, "
        "got <class 'geometry_msgs.msg._vector3.Vector3'>"
    )


def test_a_field_of_a_wrong_type_is_refused_at_the_latest_when_it_is_published(node):
    heard = []
    node.create_subscription(PointStamped, "point", heard.append, 10)
    publisher = node.create_publisher(PointStamped, "point", 10)
    message = PointStamped(check_fields=False)
    message.point = Vector3()
    with pytest.raises(AssertionError, match="The 'point' field must be a sub message of type 'Point'"):
        publisher.publish(message)
        rclpy.spin_once(node, timeout_sec=0.1)
    assert heard == []


def test_something_that_is_no_message_class_cannot_be_a_topics_type(node):
    for no_type in (int, "std_msgs/msg/String", String()):
        with pytest.raises(NoTypeSupportImportedException):
            node.create_publisher(no_type, "numbers", 10)
        with pytest.raises(NoTypeSupportImportedException):
            node.create_subscription(no_type, "numbers", print, 10)


@pytest.mark.parametrize(("qos", "error"), [(-1, ValueError), ("10", TypeError), (None, TypeError)])
def test_what_is_neither_a_depth_nor_a_profile_is_refused(node, qos, error):
    with pytest.raises(error):
        node.create_publisher(String, "chatter", qos)
    with pytest.raises(error):
        node.create_subscription(String, "chatter", print, qos)


@pytest.mark.parametrize(
    ("offered", "requested", "policy"),
    [
        ({"reliability": ReliabilityPolicy.BEST_EFFORT}, {}, "RELIABILITY"),
        ({}, {"durability": DurabilityPolicy.TRANSIENT_LOCAL}, "DURABILITY"),
    ],
)
def test_an_offer_that_is_less_than_the_request_is_warned_of_on_both_sides(node, capsys, offered, requested, policy):
    listener, heard = Node("listener"), []
    publisher = node.create_publisher(String, "chatter", QoSProfile(depth=10, **offered))
    listener.create_subscription(String, "chatter", heard.append, QoSProfile(depth=10, **requested))
    publisher.publish(String(data="hello"))
    rclpy.spin_once(listener, timeout_sec=0.5)
    assert heard == []
    lines = capsys.readouterr().err.splitlines()
    assert (
        sum(
            line.endswith(
                "[talker]: New subscription discovered on topic '/chatter', requesting incompatible QoS. "
                f"No messages will be sent to it. Last incompatible policy: {policy}"
            )
            for line in lines
        )
        == 1
    )
    assert (
        sum(
            line.endswith(
                "[listener]: New publisher discovered on topic '/chatter', offering incompatible QoS. "
                f"No messages will be received from it. Last incompatible policy: {policy}"
            )
            for line in lines
        )
        == 1
    )


def test_a_log_message_that_is_no_text_is_refused(node):
    with pytest.raises(TypeError):
        node.get_logger().info(42)


def test_timers_and_rates_need_sensible_periods(node):
    with pytest.raises(ValueError):
        node.create_rate(0)
    with pytest.raises(ValueError):
        node.create_rate(-1.0)


# Participants ---------------------------------------------------------------------


def test_an_endless_loop_is_named_and_the_others_go_on(graph, capsys):
    graph.driver.patience_s = 0.3
    ticks = []

    def busy():
        while True:
            pass

    def healthy():
        rclpy.init()
        node = Node("healthy")
        node.create_timer(0.1, lambda: ticks.append(1))
        rclpy.spin(node)

    graph.start(busy)
    graph.start(healthy)
    graph.run(seconds=1)
    assert len(ticks) >= 9
    printed = capsys.readouterr().err
    assert 'participant "busy"' in printed
    assert "Endless loop" in printed
    assert "test_bad_input.py" in printed


def test_an_exception_in_one_participant_is_reported_and_does_not_hurt_the_others(graph, capsys):
    ticks = []

    def broken():
        rclpy.init()
        node = Node("broken")
        node.create_timer(0.2, lambda: 1 / 0)
        rclpy.spin(node)

    def healthy():
        rclpy.init()
        node = Node("healthy")
        node.create_timer(0.1, lambda: ticks.append(1))
        rclpy.spin(node)

    failed = graph.start(broken)
    graph.start(healthy)
    graph.run(seconds=1)
    assert len(ticks) >= 9
    assert isinstance(failed.exception, ZeroDivisionError)
    printed = capsys.readouterr().err
    assert 'participant "broken" ended with an exception' in printed
    assert "ZeroDivisionError" in printed


def test_a_bad_transform_is_refused_by_type_before_it_travels(node):
    publisher = node.create_publisher(TFMessage, "/tf", 10)
    with pytest.raises(AssertionError, match="each value of type 'TransformStamped'"):
        publisher.publish(TFMessage(transforms=[Vector3()], check_fields=False))


def test_time_cannot_run_back_and_trouble_has_its_limits(graph):
    with pytest.raises(ValueError, match="time cannot run back"):
        graph.run(seconds=-1)
    with pytest.raises(ValueError):
        graph.disturb("/tf", delay=-0.1)
    with pytest.raises(ValueError):
        graph.disturb("/tf", loss=1.5)
    with pytest.raises(ValueError, match='"/tf", not "tf"'):
        graph.disturb("tf", delay=0.1)
