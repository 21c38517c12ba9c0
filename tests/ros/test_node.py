"""Nodes: names, remapping, errors with a caret, logs, and graph queries."""

import pytest

from tflab.ros import client_library as rclpy
from tflab.ros.exceptions import (
    InvalidNamespaceException,
    InvalidNodeNameException,
    InvalidServiceNameException,
    InvalidTopicNameException,
    NoTypeSupportImportedException,
    RCLInvalidROSArgsError,
    UnknownROSArgsError,
)
from tflab.ros.logging import LoggingSeverity
from tflab.ros.messages.geometry_msgs import PointStamped
from tflab.ros.messages.rcl_interfaces import Log
from tflab.ros.messages.std_msgs import String
from tflab.ros.messages.tf2_msgs import FrameGraph, TFMessage
from tflab.ros.node import Node
from tflab.ros.qos import qos_profile_rosout_default


@pytest.fixture
def node(graph):
    rclpy.init()
    yield Node("camera", namespace="robot")
    rclpy.try_shutdown()


def test_a_node_that_fails_to_construct_is_removed_without_a_second_error(graph, tmp_path):
    mixed = tmp_path / "parameters.yaml"
    mixed.write_text("early:\n  ros__parameters:\n    x: [1, a]\n", encoding="utf-8")
    rclpy.init(args=["--ros-args", "--params-file", str(mixed)])
    with pytest.raises(TypeError, match="is not a list of one of the allowed types"):
        Node("early")
    rclpy.shutdown()


def test_names_are_completed_as_the_node_means_them(node):
    assert (node.get_name(), node.get_namespace()) == ("camera", "/robot")
    assert node.get_fully_qualified_name() == "/robot/camera"
    assert node.resolve_topic_name("points") == "/robot/points"
    assert node.resolve_topic_name("~/points") == "/robot/camera/points"
    assert node.resolve_topic_name("/points") == "/points"


def test_nodes_and_topics_are_remapped_from_the_command_line(graph):
    with pytest.raises(UnknownROSArgsError, match=r"\['--remapp', 'a:=b'\]"):
        rclpy.init(args=["x", "--ros-args", "--remapp", "a:=b", "-r", "c:=d"])
    with pytest.raises(RCLInvalidROSArgsError, match=r"Failed to parse ROS arguments: .*not-a-remap"):
        rclpy.init(args=["x", "--ros-args", "-r", "not-a-remap"])
    rclpy.init(args=["x", "--ros-args", "-r", "__node:=lidar", "-r", "__ns:=/left", "-r", "scan:=cloud"])
    node = Node("sensor")
    assert node.get_fully_qualified_name() == "/left/lidar"
    assert node.create_publisher(String, "scan", 1).topic_name == "/left/cloud"
    rclpy.shutdown()


@pytest.mark.parametrize(
    ("make", "error", "text"),
    [
        (
            lambda node: Node("my node"),
            InvalidNodeNameException,
            "Invalid node name: node name must not contain characters other than alphanumerics or '_':\n"
            "  'my node'\n"
            "     ^",
        ),
        (
            lambda node: Node("n", namespace="/a//b"),
            InvalidNamespaceException,
            "Invalid namespace: namespace must not contain repeated '/':\n  '/a//b'\n      ^",
        ),
        (
            lambda node: node.create_publisher(String, "my topic", 1),
            InvalidTopicNameException,
            "Invalid topic name: topic name must not contain characters other than alphanumerics, '_', '~', '{', or "
            "'}':\n  'my topic'\n     ^",
        ),
        (
            lambda node: node.create_subscription(String, "9lives", print, 1),
            InvalidTopicNameException,
            "Invalid topic name: topic name token must not start with a number:\n  '9lives'\n   ^",
        ),
        (
            lambda node: node.create_service(FrameGraph, "frames/", print),
            InvalidServiceNameException,
            "Invalid service name: topic name must not end with a forward slash:\n  'frames/'\n         ^",
        ),
        (
            lambda node: node.create_publisher(String, "arm/{side}", 1),
            ValueError,
            "topic name 'arm/{side}' is invalid: unknown substitution: {side}",
        ),
    ],
)
def test_an_invalid_name_is_refused_with_a_caret_under_the_character(node, make, error, text):
    with pytest.raises(error) as refused:
        make(node)
    assert str(refused.value) == text


@pytest.mark.parametrize(
    ("make", "error"),
    [
        (lambda node: node.create_publisher(String, "t", -1), ValueError),
        (lambda node: node.create_publisher(String, "t", "10"), TypeError),
        (lambda node: node.create_subscription(String, "t", print, "10"), TypeError),
        (lambda node: node.create_publisher(String, "", 1), InvalidTopicNameException),
        (lambda node: node.create_publisher(String(), "t", 1), NoTypeSupportImportedException),
        (lambda node: node.create_publisher(int, "t", 1), NoTypeSupportImportedException),
        (lambda node: node.create_subscription("String", "t", print, 1), NoTypeSupportImportedException),
        (lambda node: node.create_subscription(String, "t", lambda: None, 1), RuntimeError),
        (lambda node: setattr(node, "handle", None), AttributeError),
    ],
)
def test_bad_arguments_are_refused(node, make, error):
    with pytest.raises(error):
        make(node)


def test_a_message_of_another_type_or_with_an_invalid_field_is_refused_by_publish(node):
    with pytest.raises(TypeError, match=r"^Expected <class 'std_msgs\.msg\._string\.String'>, got <class 'geometry_"):
        node.create_publisher(String, "t", 1).publish(PointStamped())
    with pytest.raises(AssertionError, match="each value of type 'TransformStamped'"):
        invalid = TFMessage(transforms=[PointStamped()], check_fields=False)
        node.create_publisher(TFMessage, "/tf", 10).publish(invalid)


def test_topics_of_different_types_are_not_connected(node):
    publisher = node.create_publisher(String, "t", 1)
    node.create_subscription(PointStamped, "t", print, 1)
    assert publisher.get_subscription_count() == 0
    assert ("/robot/t", ["geometry_msgs/msg/PointStamped", "std_msgs/msg/String"]) in node.get_topic_names_and_types()


def test_every_node_has_its_parameter_services_and_topics(node):
    names = [name for name, _ in node.get_service_names_and_types_by_node("camera", "/robot")]
    assert [name.rpartition("/")[2] for name in names] == [
        "describe_parameters",
        "get_parameter_types",
        "get_parameters",
        "get_type_description",
        "list_parameters",
        "set_parameters",
        "set_parameters_atomically",
    ]
    assert node.get_publisher_names_and_types_by_node("camera", "/robot") == [
        ("/parameter_events", ["rcl_interfaces/msg/ParameterEvent"]),
        ("/rosout", ["rcl_interfaces/msg/Log"]),
    ]


def test_a_node_sees_the_others_and_who_is_on_a_topic(node):
    other = Node("other")
    other.create_publisher(String, "/t", 7)
    assert node.get_fully_qualified_node_names() == ["/robot/camera", "/other"]
    (info,) = node.get_publishers_info_by_topic("/t")
    assert (info.node_name, info.node_namespace, info.topic_type) == ("other", "/", "std_msgs/msg/String")
    assert info.qos_profile.depth == 7
    assert (node.count_publishers("/t"), node.count_subscribers("/t")) == (1, 0)


def test_destroying_twice_returns_false(node):
    publisher = node.create_publisher(String, "t", 1)
    assert node.destroy_publisher(publisher)
    assert not node.destroy_publisher(publisher)
    assert node.count_publishers("t") == 0
    node.destroy_node()
    node.destroy_node()


# -- logs ------------------------------------------------------------------------------


def test_a_log_line_has_the_format_of_ros_2_and_debug_is_silent_until_the_level_is_set(node, capsys, monkeypatch):
    logger = node.get_logger()
    logger.warning("low battery")
    logger.get_child("driver").error("gone")
    assert not logger.debug("quiet")
    logger.set_level(LoggingSeverity.DEBUG)
    assert logger.debug("loud")
    logger.set_level(LoggingSeverity.UNSET)
    assert capsys.readouterr().err == (
        "[WARN] [1.000000000] [robot.camera]: low battery\n[ERROR] [1.000000000] [robot.camera.driver]: gone\n"
        "[DEBUG] [1.000000000] [robot.camera]: loud\n"
    )
    monkeypatch.setenv("RCUTILS_LOGGING_USE_STDOUT", "1")
    logger.info("here")
    assert capsys.readouterr().out == "[INFO] [1.000000000] [robot.camera]: here\n"
    with pytest.raises(TypeError, match="a log message is a str, not ZeroDivisionError"):
        logger.error(ZeroDivisionError("x"))


def test_logs_go_to_rosout_also_for_late_subscribers(node, capsys):
    node.get_logger().info("early")
    heard = []
    late = Node("late")
    late.create_subscription(Log, "/rosout", heard.append, qos_profile_rosout_default)
    rclpy.spin_once(late, timeout_sec=0.1)
    assert [(log.name, log.msg, log.level, log.stamp.sec) for log in heard] == [("robot.camera", "early", 20, 1)]
    capsys.readouterr()
