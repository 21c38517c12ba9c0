"""Logging, names, clocks, profiles, parameters and callback groups behave as in rclpy."""

import warnings
from pathlib import Path
from unittest.mock import Mock

import pytest

from tflab.ros import client_library as rclpy
from tflab.ros import logging as ros_logging
from tflab.ros.clock import ROSClock
from tflab.ros.entity import ReentrantCallbackGroup
from tflab.ros.exceptions import ParameterAlreadyDeclaredException, ParameterNotDeclaredException, RCLError
from tflab.ros.executors import MultiThreadedExecutor
from tflab.ros.logging import LoggingSeverity, get_logger
from tflab.ros.messages import rcl_interfaces
from tflab.ros.messages.std_msgs import Empty
from tflab.ros.names import expand_topic_name
from tflab.ros.node import Node
from tflab.ros.parameter import Parameter
from tflab.ros.qos import CQoSProfile, HistoryPolicy, QoSPresetProfiles, QoSProfile, ReliabilityPolicy
from tflab.ros.task import Future
from tflab.ros.time import ClockType, Duration, Time
from tflab.ros.time_source import TimeSource
from tflab.ros.timer import TimerInfo

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
def test_filters_run_in_the_order_throttle_skip_first_once(graph, options, expected):
    assert printed(graph, **options) == expected


def test_each_call_site_has_its_own_filters(graph):
    logger = get_logger("test")
    assert [logger.info("a", once=True), logger.info("b", once=True)] == [True, True]


def test_the_filters_of_a_call_site_must_not_change(graph):
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


def test_a_profile_survives_conversion_to_rmw():
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


def test_a_time_source_knows_its_node(node):
    source = TimeSource(node=node)
    assert source._get_node() is node
    source.detach_node()
    assert source._get_node() is None


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


def test_a_subscription_of_a_reentrant_group_runs_in_parallel_with_itself(graph):
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


def test_a_timer_of_a_millisecond_says_how_long_it_is_to_the_next_call(node):
    timer = node.create_timer(0.001, lambda: None)
    assert timer.time_until_next_call() == 1_000_000
    rclpy.spin_once(node)
    assert 0 < timer.time_until_next_call() <= 1_000_000
    timer.cancel()
    assert timer.time_until_next_call() is None


DYNAMIC = rcl_interfaces.ParameterDescriptor(dynamic_typing=True)


# -- what is made can be used with `with` ---------------------------------------------


def test_a_timer_ends_with_its_with_statement(node):
    calls = []
    with node.create_timer(0.1, lambda: calls.append(1)):
        rclpy.spin_once(node, timeout_sec=0.15)
    rclpy.spin_once(node, timeout_sec=0.5)
    assert calls == [1]


def test_a_destroyed_timer_does_not_wake_an_executor(node, graph):
    with node.create_timer(0.1, Mock()):
        pass
    before_ns = graph.driver.now_ns()
    rclpy.spin_once(node, timeout_sec=2.0)
    assert graph.driver.now_ns() - before_ns == 2_000_000_000


def test_services_and_clients_leave_with_their_with_statement(node):
    kind = rcl_interfaces.GetParameters
    with (
        node.create_service(kind, "ask", lambda request, response: response),
        node.create_client(kind, "ask") as client,
    ):
        assert client.service_is_ready()
    assert node.count_services("ask") == node.count_clients("ask") == 0


# -- timer info -------------------------------------------------------------------------


def test_timer_info_is_given_nanoseconds_and_shows_times():
    info = TimerInfo(expected_call_time=5, actual_call_time=6, clock_type=ClockType.STEADY_TIME)
    assert info.expected_call_time == Time(nanoseconds=5, clock_type=ClockType.STEADY_TIME)
    assert info.actual_call_time == Time(nanoseconds=6, clock_type=ClockType.STEADY_TIME)
    assert TimerInfo().expected_call_time == Time()


# -- quality of service -------------------------------------------------------------------


def make_shallow():
    QoSProfile(history=HistoryPolicy.KEEP_LAST, depth=0)


def make_shallow_later():
    QoSProfile(depth=1).depth = 0


@pytest.mark.parametrize("make", [make_shallow, make_shallow_later])
def test_a_depth_of_zero_warns_once_where_it_was_written(make):
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        make()
    assert [str(each.message) for each in caught] == [
        "A zero depth with KEEP_LAST doesn't make sense; no data could be stored. "
        "This will be interpreted as SYSTEM_DEFAULT"
    ]
    assert caught[0].filename == __file__


# -- parameters -----------------------------------------------------------------------------


def test_several_parameters_are_declared_all_or_none(node):
    node.declare_parameter("b", 1)
    with pytest.raises(ParameterAlreadyDeclaredException, match=r"Parameter\(s\) already declared: \['b'\]"):
        node.declare_parameters("", [("a", 1), ("b", 2)])
    assert not node.has_parameter("a")


def test_a_descriptor_must_be_one(node):
    with pytest.raises(TypeError, match="descriptor must be a ParameterDescriptor, not 'metres'"):
        node.declare_parameter("length", 1.0, "metres")


def test_setting_a_dynamic_parameter_to_nothing_undeclares_it(node):
    node.declare_parameter("a", 1, DYNAMIC)
    (result,) = node.set_parameters([Parameter("a", Parameter.Type.NOT_SET)])
    assert result.successful
    assert not node.has_parameter("a")


def test_setting_a_typed_parameter_to_nothing_is_refused(node):
    node.declare_parameter("a", 1)
    (result,) = node.set_parameters([Parameter("a", Parameter.Type.NOT_SET)])
    assert result.reason == "Static parameter cannot be undeclared"
    assert node.get_parameter("a").value == 1


def test_get_parameter_types_returns_the_types(node):
    node.declare_parameter("a", 1)
    assert node.get_parameter_types(["a", "use_sim_time"]) == [Parameter.Type.INTEGER, Parameter.Type.BOOL]
    with pytest.raises(ParameterNotDeclaredException):
        node.get_parameter_types(["b"])


# -- names of modules ---------------------------------------------------------------------------


def test_rcl_error_can_be_imported_from_its_module(activated):
    from rclpy._rclpy_pybind11 import RCLError

    assert RCLError.__module__ == "rclpy._rclpy_pybind11"
