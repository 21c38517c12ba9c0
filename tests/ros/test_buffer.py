"""tf2_ros.Buffer and tf2_py.BufferCore: their arguments, waiting without blocking, velocity, services."""

from enum import Enum

import pytest

from tflab.core import ConnectivityException, ExtrapolationException, LookupException, TransformException, seconds
from tflab.ros import client_library as rclpy
from tflab.ros.messages.geometry_msgs import Point, Quaternion, TransformStamped, Vector3
from tflab.ros.messages.tf2_msgs import FrameGraph, TFMessage
from tflab.ros.node import Node
from tflab.ros.tf2.buffer import Buffer
from tflab.ros.tf2.core import BufferCore
from tflab.ros.tf2.interface import BufferInterface, NotImplementedException, TransformRegistration, TypeException
from tflab.ros.tf2.topics import StaticTransformListener, TransformBroadcaster, TransformListener
from tflab.ros.time import ClockType, Duration, Time


def transform(parent, child, stamp_s=0.0, x=0.0):
    message = TransformStamped(child_frame_id=child)
    message.header.frame_id = parent
    message.header.stamp = Time(nanoseconds=seconds(stamp_s)).to_msg()
    message.transform.translation.x = x
    return message


@pytest.fixture
def buffer(graph):
    """odom -> base_link, x = 1 at 1 s, and 2 at 2 s."""
    buffer = Buffer()
    buffer.set_transform(transform("odom", "base_link", 1.0, 1.0), "test")
    buffer.set_transform(transform("odom", "base_link", 2.0, 2.0), "test")
    return buffer


@pytest.mark.parametrize(
    "time",
    [
        Time(seconds=1.5),
        Time(seconds=1.5, clock_type=ClockType.ROS_TIME),
        Time(seconds=1.5).to_msg(),
        Duration(seconds=1.5),
    ],
)
def test_a_time_is_any_object_with_seconds_and_nanoseconds(buffer, time):
    assert buffer.lookup_transform("odom", "base_link", time).transform.translation.x == 1.5


def test_an_enum_that_is_a_str_names_a_frame_or_a_node_by_its_value(buffer):
    frame = Enum("Frame", {"MAP": "map", "CAMERA": "camera"}, type=str)
    buffer.set_transform_static(transform(frame.MAP, frame.CAMERA, x=3.0), "test")
    assert buffer.lookup_transform("map", "camera", Time()) == buffer.lookup_transform(frame.MAP, frame.CAMERA, Time())
    assert buffer.can_transform_full(frame.MAP, Time(), frame.CAMERA, Time(), frame.MAP)
    rclpy.init()
    assert Node(frame.CAMERA, namespace=frame.MAP).get_fully_qualified_name() == "/map/camera"
    rclpy.shutdown()


def test_what_is_no_time_is_refused_and_the_binding_takes_positions_where_it_does(buffer):
    with pytest.raises(TypeError, match=r"time must have sec and nanosec, or nanoseconds\."):
        buffer.lookup_transform_core("odom", "base_link", 1.5)
    with pytest.raises(TypeError, match=r"duration must have sec and nanosec, or nanoseconds\."):
        BufferCore(10.0)
    with pytest.raises(TypeError):
        BufferCore(cache_time=Duration(seconds=1))
    for frame in ("base_link", "nobody"):  # also where the transform is there
        with pytest.raises(TypeError, match=r"unsupported operand type\(s\) for \+: 'Time' and 'float'"):
            buffer.lookup_transform("odom", frame, Time(), timeout=1.0)
    with pytest.raises(TypeError, match="argument 2 must be str, not int"):
        BufferCore.set_transform(buffer, transform("a", "b"), 7)


def test_a_translation_must_be_a_vector_and_a_rotation_should_be_a_quaternion(buffer):
    message = transform("a", "b", 1.0)
    message.transform.translation = Point()
    with (
        pytest.warns(UserWarning, match="translation should be of type Vector3"),
        pytest.raises(TypeError, match=r"transform\.translation must have members x, y, z"),
    ):
        buffer.set_transform(message, "test")


def test_a_stamp_may_be_an_rclpy_time_and_numbers_may_be_ints(buffer):
    message = TransformStamped(child_frame_id="tool", check_fields=False)
    message.header.frame_id = "base_link"
    message.header._check_fields = False
    message.header.stamp = Time(seconds=3)
    message.transform.translation = Vector3(x=1, y=2, z=3, check_fields=False)
    message.transform.rotation = Quaternion(x=0, y=0, z=0, w=1, check_fields=False)
    buffer.set_transform(message, "test")
    assert buffer.lookup_transform("base_link", "tool", Time(seconds=3)).transform.translation.z == 3.0


def test_set_transform_returns_none_even_if_it_refuses(buffer, capsys):
    assert buffer.set_transform(transform("a", "a", 1.0), "somebody") is None
    assert capsys.readouterr().err == (
        '[ERROR] [1.000000000] []: TF_SELF_TRANSFORM: Ignoring transform from authority "somebody" with frame_id and  '
        'child_frame_id "a" because they are the same\n'
    )


def test_can_transform_returns_the_reason_on_request(buffer):
    assert buffer.can_transform("odom", "base_link", Time()) == 1
    assert buffer.can_transform("odom", "nobody", Time(), return_debug_tuple=True) == (
        0,
        'Invalid frame ID "nobody" passed to canTransform argument source_frame - frame does not exist',
    )


def test_an_expired_wait_raises_the_cause_not_a_timeout(buffer, graph):
    with pytest.raises(LookupException):
        buffer.lookup_transform("odom", "nobody", Time(), timeout=Duration(seconds=0.5))
    assert graph.now_ns == seconds(1.5)
    with pytest.raises(ExtrapolationException):
        buffer.lookup_transform("odom", "base_link", Time(seconds=3), timeout=Duration(seconds=0.5))
    buffer.set_transform(transform("map", "elsewhere", 1.0), "test")
    with pytest.raises(ConnectivityException):
        buffer.lookup_transform("map", "base_link", Time(), timeout=Duration(seconds=0.5))


def test_the_full_forms_take_two_times_and_a_frame_that_stands_still(buffer):
    question = ("base_link", Time(seconds=1), "base_link", Time(seconds=2), "odom")
    assert buffer.can_transform_full(*question) == 1
    # Where base_link was at 2 s, as seen from where it was at 1 s.
    assert buffer.lookup_transform_full(*question).transform.translation.x == pytest.approx(1.0)


def test_the_latest_common_time_is_a_system_time(buffer):
    assert buffer.get_latest_common_time("odom", "base_link") == Time(seconds=2)
    with pytest.raises(LookupException, match=r'^"nobody" passed to get_latest_common_time does not exist\. $'):
        buffer.get_latest_common_time("odom", "nobody")


def test_the_chain_goes_from_source_to_target(buffer):
    buffer.set_transform_static(transform("base_link", "laser"), "test")
    now = Time(seconds=1)
    assert buffer._chain("odom", now, "laser", now, "odom") == ["laser", "base_link", "odom"]
    assert buffer._chain("base_link", now, "laser", now, "odom") == ["laser", "base_link"]


# -- without blocking ----------------------------------------------------------------


def test_a_future_is_done_with_the_transform_that_makes_it_possible(buffer):
    future = buffer.wait_for_transform_async("odom", "base_link", Time(seconds=1.5))
    assert future.done() and future.result().transform.translation.x == 1.5  # at once
    future = buffer.wait_for_transform_async("odom", "base_link", Time(seconds=2.5))
    coroutine = buffer.lookup_transform_async("odom", "base_link", Time(seconds=2.5))
    assert coroutine.send(None) is None
    buffer.set_transform(transform("other", "thing", 5.0), "test")
    assert not future.done()
    buffer.set_transform(transform("odom", "base_link", 3.0, 3.0), "test")
    assert future.result().transform.translation.x == 2.5
    with pytest.raises(StopIteration) as end:
        coroutine.send(None)
    assert end.value.value.transform.translation.x == 2.5


def test_a_future_of_what_never_comes_stays_pending_until_it_is_cancelled(buffer):
    future = buffer.wait_for_transform_async("odom", "base_lnik", Time(seconds=1))
    buffer.set_transform(transform("odom", "base_link", 3.0), "test")
    assert not future.done()
    future.cancel()
    buffer.set_transform(transform("odom", "base_lnik", 1.0), "test")
    assert future.cancelled() and not buffer.has_waiting()


# -- listeners and broadcasters ---------------------------------------------------------


@pytest.fixture
def node(graph):
    rclpy.init()
    yield Node("node", namespace="/robot")
    rclpy.shutdown()


def test_tf_is_absolute_whatever_the_namespace_but_can_be_remapped(graph):
    rclpy.init(args=["x", "--ros-args", "-r", "/tf:=/robot/tf"])
    node = Node("node", namespace="/robot")
    listener = TransformListener(Buffer(), node)
    assert (listener.tf_sub.topic_name, listener.tf_static_sub.topic_name) == ("/robot/tf", "/tf_static")
    rclpy.shutdown()


def test_a_broadcaster_accepts_a_transform_a_list_or_an_iterable(node):
    sent = []
    node.create_subscription(TFMessage, "/tf", lambda msg: sent.append(len(msg.transforms)), 10)
    broadcaster = TransformBroadcaster(node)
    one, two = transform("a", "b"), transform("b", "c")
    for what in (one, [one, two], (each for each in (one, two))):
        broadcaster.sendTransform(what)
        rclpy.spin_once(node, timeout_sec=0.1)
    assert sent == [1, 2, 2]


def test_a_listener_stores_into_its_current_buffer_by_the_default_authority(node):
    first, second, calls = Buffer(), Buffer(node=node), []
    listener = TransformListener(first, node)
    listener.buffer = second
    future = second.wait_for_transform_async("odom", "base_link", Time(seconds=1))
    TransformBroadcaster(node).sendTransform(transform("odom", "base_link", 1.0, 4.0))
    rclpy.spin_until_future_complete(node, future, timeout_sec=1.0)
    assert future.result().transform.translation.x == 4.0
    assert (first._frameExists("odom"), second._frameExists("odom")) == (False, True)
    assert "broadcaster: 'default_authority'" in second.all_frames_as_yaml()
    second.set_transform = lambda transform, authority: calls.append((transform.child_frame_id, authority))
    TransformBroadcaster(node).sendTransform([transform("a", "b", 1.0), transform("b", "c", 1.0)])
    rclpy.spin_once(node, timeout_sec=0.1)
    assert calls == [("b", "default_authority"), ("c", "default_authority")]  # who replaces it is called


def test_an_overridden_set_transform_is_called(node):
    class Counting(Buffer):
        count = 0

        def set_transform(self, transform, authority):
            self.count += 1
            super().set_transform(transform, authority)

    buffer = Counting()
    node.listener = TransformListener(buffer, node)
    TransformBroadcaster(node).sendTransform([transform("a", "b", 1.0), transform("b", "c", 1.0)])
    rclpy.spin_once(node, timeout_sec=0.1)
    assert buffer.count == 2
    assert buffer.all_frames_as_string() == "Frame b exists with parent a.\nFrame c exists with parent b.\n"


def test_a_listener_without_references_stops_listening(node):
    import gc

    buffer = Buffer()
    TransformListener(buffer, node)
    gc.collect()
    TransformBroadcaster(node).sendTransform(transform("odom", "base_link", 1.0))
    rclpy.spin_once(node, timeout_sec=0.1)
    assert not buffer._frameExists("odom")


def test_a_static_listener_subscribes_only_to_tf_static(node):
    buffer = Buffer()
    node.listener = StaticTransformListener(buffer, node)
    assert node.count_subscribers("/tf") == 0
    assert node.count_subscribers("/tf_static") == 1


def test_a_buffer_with_a_node_serves_its_frames_below_the_namespace(node):
    buffer = Buffer(node=node)
    buffer.set_transform(transform("odom", "base_link", 1.0), "somebody")
    client = node.create_client(FrameGraph, "/robot/tf2_frames")
    future = client.call_async(FrameGraph.Request())
    rclpy.spin_until_future_complete(node, future, timeout_sec=1.0)
    assert future.result().frame_yaml == buffer.all_frames_as_yaml()


# -- types ----------------------------------------------------------------------------------


def test_an_unknown_type_and_a_bare_interface_are_refused():
    with pytest.raises(NotImplementedException) as refused:
        BufferInterface().lookup_transform("a", "b", Time())
    assert refused.value.errstr == "CanTransform or LookupTransform not implemented"
    with pytest.raises(TypeException) as refused:
        TransformRegistration().get(int)
    assert refused.value.errstr == "Type <class 'int'> is not loaded or supported"
    assert not isinstance(refused.value, TransformException)


def test_velocity_of_a_rotated_frame_has_the_fault_of_tf2():
    # Driving along y at 1 m/s, turned left by 90 degrees: tf2 turns the velocity once too often.
    from tflab.core import quaternions

    buffer = Buffer()
    for i in range(11):
        transform = TransformStamped()
        transform.header.frame_id, transform.child_frame_id = "odom", "base_link"
        transform.header.stamp = Time(seconds=1 + i / 10).to_msg()
        transform.transform.translation.y = i / 10
        turn = transform.transform.rotation
        turn.x, turn.y, turn.z, turn.w = quaternions.from_rpy(0.0, 0.0, 3.141592653589793 / 2)
        buffer.set_transform(transform, "test")
    linear, angular = buffer.lookupVelocityCore("base_link", "odom", Time(seconds=1.5), Duration(seconds=0.2))
    assert linear == pytest.approx((-1.0, 0.0, 0.0), abs=1e-6)
    assert angular == pytest.approx((0.0, 0.0, 0.0), abs=1e-6)
    true = buffer.core.lookup_velocity("base_link", "odom", 1_500_000_000, 200_000_000)
    assert true.linear == pytest.approx((0.0, 1.0, 0.0), abs=1e-6)
