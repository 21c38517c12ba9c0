"""Logging, names, clocks, profiles, parameters and callback groups behave as in rclpy."""

import warnings
from pathlib import Path

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
from tflab.ros.qos import HistoryPolicy, QoSPresetProfiles, QoSProfile
from tflab.ros.service import ServiceIntrospectionState
from tflab.ros.time import Duration, Time

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


def test_severities_have_names_and_levels_are_forgotten(graph):
    assert ros_logging.get_logging_severity_from_string("warn") is LoggingSeverity.WARN
    with pytest.raises(RCLError, match="'loud', it is none of UNSET, DEBUG"):
        ros_logging.get_logging_severity_from_string("loud")
    ros_logging.set_logger_level("test", LoggingSeverity.ERROR)
    assert get_logger("test").get_effective_level() is LoggingSeverity.ERROR
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
def test_a_name_is_completed_unless_it_is_malformed(names, text):
    assert expand_topic_name("~/chatter", "node_name", "/ns") == "/ns/node_name/chatter"
    assert expand_topic_name("chatter", "node_name", "/") == "/chatter"
    with pytest.raises(ValueError, match=text):
        expand_topic_name(*names)


# -- utilities, profiles, time sources ------------------------------------------------


def test_a_timeout_in_nanoseconds_is_truncated_and_negative_for_ever():
    assert [rclpy.timeout_sec_to_nsec(each) for each in (None, -1, 0, 0.5e-9, 1.5)] == [-1, -1, 0, 0, 1_500_000_000]


def test_presets_and_policies_have_short_names():
    assert QoSPresetProfiles.get_from_short_key("unknown") == QoSPresetProfiles.UNKNOWN.value
    assert HistoryPolicy.short_keys() == ["system_default", "keep_last", "keep_all", "unknown"]


# -- callbacks beside each other ------------------------------------------------------


def test_a_callback_of_a_reentrant_group_runs_during_others_and_during_itself(graph):
    running, most = [], []

    def main():
        rclpy.init()
        node = Node("node")

        def callback(message):
            running.append(message)
            most.append(len(running))
            node.get_clock().sleep_for(Duration(seconds=1))
            running.pop()

        group = ReentrantCallbackGroup()
        publishers = [node.create_publisher(Empty, topic, 10) for topic in ("one", "other")]
        for topic in ("one", "other"):
            node.create_subscription(Empty, topic, callback, 10, callback_group=group)
        for publisher in (*publishers, publishers[0]):
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


# -- what is made can be used with `with` ---------------------------------------------


def test_a_timer_ends_with_its_with_statement_and_wakes_nobody(node, graph):
    calls = []
    with node.create_timer(0.1, lambda: calls.append(1)):
        rclpy.spin_once(node, timeout_sec=0.15)
    before_ns = graph.now_ns
    rclpy.spin_once(node, timeout_sec=2.0)
    assert (calls, graph.now_ns - before_ns) == ([1], 2_000_000_000)


def test_services_and_clients_leave_with_their_with_statement(node):
    kind = rcl_interfaces.GetParameters
    with (
        node.create_service(kind, "ask", lambda request, response: response),
        node.create_client(kind, "ask") as client,
    ):
        assert client.service_is_ready()
    assert node.count_services("ask") == node.count_clients("ask") == 0


def test_introspection_publishes_each_request_and_response(node):
    kind = rcl_interfaces.GetParameters
    service = node.create_service(kind, "ask", lambda request, response: response)
    client = node.create_client(kind, "ask")
    service.configure_introspection(node.get_clock(), QoSProfile(depth=9), ServiceIntrospectionState.METADATA)
    client.configure_introspection(node.get_clock(), QoSProfile(depth=9), ServiceIntrospectionState.CONTENTS)
    events = []
    node.create_subscription(kind.Event, "/ask/_service_event", events.append, 10)
    for state in (ServiceIntrospectionState.OFF, ServiceIntrospectionState.OFF):
        rclpy.spin_until_future_complete(node, client.call_async(kind.Request(names=["a"])), timeout_sec=1.0)
        for _ in range(4):
            rclpy.spin_once(node, timeout_sec=0)
        for end in (service, client):
            end.configure_introspection(node.get_clock(), QoSProfile(depth=9), state)
    seen = sorted((e.info.event_type, e.info.sequence_number, len(e.request), len(e.response)) for e in events)
    assert seen == [(0, 1, 1, 0), (1, 1, 0, 0), (2, 1, 0, 0), (3, 1, 0, 1)]
    assert events[0].request[0].names == ["a"] and len({bytes(e.info.client_gid) for e in events}) == 1


# -- quality of service -------------------------------------------------------------------


def test_a_depth_of_zero_warns_once_where_it_was_written():
    for make in (lambda: QoSProfile(history=HistoryPolicy.KEEP_LAST, depth=0), lambda: profile_of_depth(1, then=0)):
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            make()
        assert [str(each.message) for each in caught] == [
            "A zero depth with KEEP_LAST doesn't make sense; no data could be stored. "
            "This will be interpreted as SYSTEM_DEFAULT"
        ]
        assert caught[0].filename == __file__


def profile_of_depth(depth, then):
    QoSProfile(depth=depth).depth = then


# -- parameters -----------------------------------------------------------------------------


def test_several_parameters_are_declared_all_or_none(node):
    node.declare_parameter("b", 1)
    with pytest.raises(ParameterAlreadyDeclaredException, match=r"Parameter\(s\) already declared: \['b'\]"):
        node.declare_parameters("", [("a", 1), ("b", 2)])
    assert not node.has_parameter("a")
    with pytest.raises(TypeError, match="descriptor must be a ParameterDescriptor, not 'metres'"):
        node.declare_parameter("length", 1.0, "metres")


def test_get_parameter_types_returns_the_types(node):
    node.declare_parameter("a", 1)
    assert node.get_parameter_types(["a", "use_sim_time"]) == [Parameter.Type.INTEGER, Parameter.Type.BOOL]
    with pytest.raises(ParameterNotDeclaredException):
        node.get_parameter_types(["b"])
