"""What programs for rclpy rely on, and what is easily forgotten."""

import gc
import warnings
from unittest.mock import Mock

import pytest

from tflab.ros import client_library as rclpy
from tflab.ros.exceptions import ParameterAlreadyDeclaredException, ParameterNotDeclaredException
from tflab.ros.messages import geometry_msgs, rcl_interfaces
from tflab.ros.node import Node
from tflab.ros.parameter import Parameter
from tflab.ros.qos import HistoryPolicy, QoSProfile
from tflab.ros.tf2.broadcaster import TransformBroadcaster
from tflab.ros.tf2.buffer import Buffer
from tflab.ros.tf2.listener import TransformListener
from tflab.ros.time import ClockType, Time
from tflab.ros.timer import TimerInfo

DYNAMIC = rcl_interfaces.ParameterDescriptor(dynamic_typing=True)


@pytest.fixture
def node(graph):
    rclpy.init()
    yield Node("node")
    rclpy.try_shutdown()


def transform(parent="map", child="odom"):
    message = geometry_msgs.TransformStamped(child_frame_id=child)
    message.header.frame_id = parent
    return message


# -- what is made can be used with `with` ---------------------------------------------


def test_a_timer_ends_with_its_with_statement(node):
    calls = []
    with node.create_timer(0.1, lambda: calls.append(1)):
        rclpy.spin_once(node, timeout_sec=0.15)
    rclpy.spin_once(node, timeout_sec=0.5)
    assert calls == [1]


def test_a_destroyed_timer_keeps_nobody_from_waiting(node, graph):
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


def test_timer_info_takes_keywords_only():
    with pytest.raises(TypeError):
        TimerInfo(5, 6)


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


def test_types_of_several_parameters_are_told(node):
    node.declare_parameter("a", 1)
    assert node.get_parameter_types(["a", "use_sim_time"]) == [Parameter.Type.INTEGER, Parameter.Type.BOOL]
    with pytest.raises(ParameterNotDeclaredException):
        node.get_parameter_types(["b"])


# -- listeners ----------------------------------------------------------------------------------


def test_a_replaced_set_transform_is_called(node):
    buffer = Buffer()
    listener = TransformListener(buffer, node)
    buffer.set_transform = Mock()
    TransformBroadcaster(node).sendTransform(transform())
    rclpy.spin_once(node, timeout_sec=0.1)
    buffer.set_transform.assert_called_once_with(transform(), "default_authority")
    del listener
    gc.collect()


# -- names of modules ---------------------------------------------------------------------------


def test_rcl_error_can_be_imported_from_where_it_says_it_lives(activated):
    from rclpy._rclpy_pybind11 import RCLError

    assert RCLError.__module__ == "rclpy._rclpy_pybind11"
