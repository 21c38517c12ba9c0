"""What rclpy's own tests ask of logging, names, clocks, profiles and callback groups."""

from pathlib import Path

import pytest

from tflab.ros import client_library as rclpy
from tflab.ros import logging as ros_logging
from tflab.ros.clock import ROSClock
from tflab.ros.entity import ReentrantCallbackGroup
from tflab.ros.exceptions import RCLError
from tflab.ros.executors import MultiThreadedExecutor
from tflab.ros.logging import LoggingSeverity, get_logger
from tflab.ros.messages.std_msgs import Empty
from tflab.ros.names import expand_topic_name
from tflab.ros.node import Node
from tflab.ros.qos import CQoSProfile, HistoryPolicy, QoSPresetProfiles, QoSProfile, ReliabilityPolicy
from tflab.ros.task import Future
from tflab.ros.time import Duration, Time
from tflab.ros.time_source import TimeSource

# -- logging ------------------------------------------------------------------------


def printed(graph, calls=5, step_s=0.3, **options):
    """Return which of several calls at one place were printed, some time apart."""
    logger = get_logger("test")
    result = []
    for number in range(calls):
        result.append(logger.info(f"message {number}", **options))
        graph.run(seconds=step_s)
    return result


@pytest.mark.parametrize(
    ("options", "expected"),
    [
        ({"once": True}, [True, False, False, False, False]),
        ({"once": False}, [True] * 5),
        ({"skip_first": True}, [False, True, True, True, True]),
        ({"throttle_duration_sec": 1}, [True, False, False, False, True]),
        ({"skip_first": True, "throttle_duration_sec": 1}, [False, False, False, False, True]),
        ({"skip_first": True, "once": True}, [False, True, False, False, False]),
    ],
)
def test_filters_are_asked_in_order_throttle_skip_first_once(graph, options, expected):
    assert printed(graph, **options) == expected


def test_each_place_in_the_code_has_filters_of_its_own(graph):
    logger = get_logger("test")
    assert [logger.info("a", once=True), logger.info("b", once=True)] == [True, True]


def test_what_a_place_asks_for_must_stay(graph):
    logger = get_logger("test")
    with pytest.raises(ValueError, match="parameters cannot be changed between"):
        for period_s in (1, 2):
            logger.log("text", LoggingSeverity.INFO, throttle_duration_sec=period_s)
    with pytest.raises(ValueError, match="name cannot be changed between"):
        for name in ("a", "b"):
            logger.log("text", LoggingSeverity.INFO, name=name)
    with pytest.raises(ValueError, match="severity cannot be changed between"):
        for severity in (LoggingSeverity.INFO, LoggingSeverity.WARN):
            logger.log("text", severity)
    with pytest.raises(TypeError, match=r"required parameter .* not specified"):
        logger.info("text", throttle_time_source_type=ROSClock())
    with pytest.raises(TypeError, match=r"parameter .* is not one of the recognized"):
        logger.info("text", unused_kwarg=1)


def test_on_simulated_time_throttling_begins_at_zero(graph):
    clock, logger = ROSClock(), get_logger("test")
    clock._set_ros_time_is_active(True)
    result = []
    for second in range(1, 6):
        result.append(logger.info("text", throttle_duration_sec=2, throttle_time_source_type=clock))
        clock.set_ros_time_override(Time(seconds=second, clock_type=clock.clock_type))
    assert result == [False, False, True, False, True]


def test_a_severity_is_that_of_the_method_and_a_child_has_a_name(graph):
    logger = get_logger("test")
    with pytest.raises(TypeError, match="got multiple values for argument 'severity'"):
        logger.fatal("text", severity=LoggingSeverity.DEBUG)
    for name in ("", None):
        with pytest.raises(ValueError, match="Child logger name must not be empty"):
            logger.get_child(name)


def test_the_root_logger_has_every_level_that_it_is_given(graph):
    for severity in LoggingSeverity:
        ros_logging._root_logger.set_level(severity)
        assert ros_logging._root_logger.get_effective_level() is severity


def test_severities_have_names_and_levels_are_forgotten(graph):
    assert ros_logging.get_logging_severity_from_string("warn") is LoggingSeverity.WARN
    with pytest.raises(RCLError, match="'loud', it is none of UNSET, DEBUG"):
        ros_logging.get_logging_severity_from_string("loud")
    ros_logging.set_logger_level("test", LoggingSeverity.ERROR)
    assert ros_logging._root_logger.name == ""
    ros_logging.clear_config()
    assert ros_logging.get_logger_effective_level("test") is LoggingSeverity.INFO


def test_log_files_would_be_where_ros_2_has_them(monkeypatch):
    for variable in ("ROS_LOG_DIR", "ROS_HOME"):
        monkeypatch.delenv(variable, raising=False)
    monkeypatch.setattr(Path, "home", lambda: Path("/home/ada"))
    assert ros_logging.get_logging_directory() == Path("/home/ada/.ros/log")
    monkeypatch.setenv("ROS_HOME", "/ros")
    assert ros_logging.get_logging_directory() == Path("/ros/log")
    monkeypatch.setenv("ROS_LOG_DIR", "/logs")
    assert ros_logging.get_logging_directory() == Path("/logs")


# -- names --------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("names", "text"),
    [
        (("topic", "invalid_node_name?", "/ns"), "node name"),
        (("topic", "node_name", ""), "namespace"),
        (("topic", "node_name", "ns"), "namespace"),
        (("invalid/topic?", "node_name", "/ns"), "topic name"),
    ],
)
def test_a_malformed_name_is_not_completed(names, text):
    with pytest.raises(ValueError, match=text):
        expand_topic_name(*names)


def test_good_names_are_completed():
    assert expand_topic_name("~/chatter", "node_name", "/ns") == "/ns/node_name/chatter"
    assert expand_topic_name("chatter", "node_name", "/") == "/chatter"


# -- utilities, profiles, time sources ------------------------------------------------


def test_a_timeout_in_nanoseconds_is_truncated_and_negative_for_ever():
    assert [rclpy.timeout_sec_to_nsec(each) for each in (None, -1, 0, 0.5e-9, 1.5)] == [-1, -1, 0, 0, 1_500_000_000]


def test_a_profile_goes_through_the_lower_half_and_comes_back():
    profile = QoSProfile(
        history=HistoryPolicy.KEEP_ALL,
        depth=12,
        reliability=ReliabilityPolicy.BEST_EFFORT,
        lifespan=Duration(seconds=4),
    )
    assert QoSProfile(**profile.get_c_qos_profile().to_dict()) == profile
    unknown = QoSProfile(**CQoSProfile.predefined("qos_profile_unknown").to_dict())
    assert unknown == QoSPresetProfiles.UNKNOWN.value == QoSPresetProfiles.get_from_short_key("unknown")
    assert HistoryPolicy.short_keys() == ["system_default", "keep_last", "keep_all", "unknown"]
    with pytest.raises(ValueError, match="unknown rmw_qos_profile: qos_profile_loud"):
        CQoSProfile.predefined("qos_profile_loud")


def test_a_time_source_says_whom_it_follows(graph):
    rclpy.init()
    node = Node("node")
    source = TimeSource(node=node)
    assert source._get_node() is node
    source.detach_node()
    assert source._get_node() is None
    rclpy.shutdown()


# -- callbacks beside each other ------------------------------------------------------


def test_in_a_reentrant_group_a_short_callback_runs_during_a_long_one(graph):
    order = []

    def main():
        rclpy.init()
        node = Node("node")
        executor = MultiThreadedExecutor(num_threads=2)
        executor.add_node(node)
        begun, ended = Future(), Future()

        def long(message):
            begun.set_result(None)
            node.get_clock().sleep_for(Duration(seconds=1))
            order.append("long")
            ended.set_result(None)

        group = ReentrantCallbackGroup()
        node.create_subscription(Empty, "long", long, 1, callback_group=group)
        node.create_subscription(Empty, "short", lambda message: order.append("short"), 1, callback_group=group)
        to_long, to_short = node.create_publisher(Empty, "long", 1), node.create_publisher(Empty, "short", 1)
        to_long.publish(Empty())
        executor.spin_until_future_complete(begun)
        to_short.publish(Empty())
        executor.spin_until_future_complete(ended)

    graph.start(main)
    graph.run(seconds=3)
    assert order == ["short", "long"]


def test_one_subscription_of_a_reentrant_group_runs_beside_itself(graph):
    running, most = [], []

    def main():
        rclpy.init()
        node = Node("node")

        def callback(message):
            running.append(message)
            most.append(len(running))
            node.get_clock().sleep_for(Duration(seconds=1))
            running.pop()

        node.create_subscription(Empty, "topic", callback, 10, callback_group=ReentrantCallbackGroup())
        publisher = node.create_publisher(Empty, "topic", 10)
        for _ in range(3):
            publisher.publish(Empty())
        executor = MultiThreadedExecutor(num_threads=4)
        executor.add_node(node)
        executor.spin()

    graph.start(main)
    graph.run(seconds=3)
    assert max(most) == 3


def test_a_timer_of_a_millisecond_says_how_long_it_is_to_the_next_call(graph):
    rclpy.init()
    node = Node("node")
    timer = node.create_timer(0.001, lambda: None)
    assert timer.time_until_next_call() == 1_000_000
    rclpy.spin_once(node)
    assert 0 < timer.time_until_next_call() <= 1_000_000
    timer.cancel()
    assert timer.time_until_next_call() is None
    rclpy.shutdown()
