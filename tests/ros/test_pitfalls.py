"""Known pitfalls of ROS 2 occur here, too: waiting, clocks, late joiners, bad quaternions."""

import time

import pytest

from tflab.core import ExtrapolationException, LookupException, seconds
from tflab.ros import client_library as rclpy
from tflab.ros.executors import MultiThreadedExecutor, SingleThreadedExecutor
from tflab.ros.messages import type_named
from tflab.ros.messages.geometry_msgs import Quaternion, TransformStamped
from tflab.ros.messages.std_msgs import String
from tflab.ros.node import Node
from tflab.ros.parameter import Parameter
from tflab.ros.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy
from tflab.ros.tf2.buffer import Buffer
from tflab.ros.tf2.topics import StaticTransformBroadcaster, TransformBroadcaster, TransformListener
from tflab.ros.time import Duration, Time


def transform(parent, child, stamp_ns=0, x=0.0):
    message = TransformStamped(child_frame_id=child)
    message.header.frame_id = parent
    message.header.stamp = Time(nanoseconds=stamp_ns).to_msg()
    message.transform.translation.x = x
    return message


def moving(graph, period_s=0.05, name="moving"):
    """A main function: odom -> base_link, x = seconds since the graph's start."""

    def main():
        rclpy.init()
        node = Node(name)
        broadcaster = TransformBroadcaster(node)
        node.create_timer(
            period_s,
            lambda: broadcaster.sendTransform(
                transform("odom", "base_link", node.get_clock().now().nanoseconds, graph.now_ns / 1e9 - 1.0)
            ),
        )
        rclpy.spin(node)

    return main


def ask_now(graph, node, buffer, outcome):
    """Ask for this very moment, wait up to 0.2 s, and note the answer and how long it took [ns]."""
    began_ns = graph.now_ns
    try:
        found = buffer.lookup_transform("odom", "base_link", node.get_clock().now(), timeout=Duration(seconds=0.2))
        outcome.append(round(found.transform.translation.x, 9))
    except ExtrapolationException as error:
        outcome.append(error.direction)
    outcome.append(graph.now_ns - began_ns)


def asker(graph, outcome, executor_type):
    """A main function: 0.99 s after its start, a callback asks."""

    def main():
        rclpy.init()
        node = Node("asker")
        buffer = Buffer(node=node)
        node.listener = TransformListener(buffer, node)

        def ask():
            timer.cancel()
            ask_now(graph, node, buffer, outcome)

        timer = node.create_timer(0.99, ask)
        executor = executor_type()
        executor.add_node(node)
        executor.spin()

    return main


# -- waiting for a transform -----------------------------------------------------------


@pytest.mark.parametrize(
    ("executor", "expected"),
    [
        (SingleThreadedExecutor, ["future", seconds(0.2)]),
        # Asked at 1.99 s; the sample of 2.00 s is there at the first look after it.
        (MultiThreadedExecutor, [0.99, seconds(0.02)]),
    ],
)
def test_transforms_arrive_while_a_callback_waits_only_with_many_threads(graph, executor, expected):
    outcome = []
    graph.start(moving(graph))
    graph.start(asker(graph, outcome, executor))
    graph.run(seconds=2)
    assert outcome == expected


def test_a_listener_with_spin_thread_serves_a_waiting_lookup(graph):
    outcome = []

    def main():
        rclpy.init()
        node = Node("asker")
        buffer = Buffer(node=node)
        node.listener = TransformListener(buffer, node, spin_thread=True)
        time.sleep(0.99)
        ask_now(graph, node, buffer, outcome)

    graph.start(moving(graph))
    graph.start(main)
    graph.run(seconds=2)
    assert outcome == [0.99, seconds(0.02)]


# -- simulated time ---------------------------------------------------------------------


def test_use_sim_time_without_clock_stays_at_zero_and_timers_never_run(graph):
    calls = []

    def main():
        rclpy.init(args=["node", "--ros-args", "-p", "use_sim_time:=true"])
        node = Node("waiting_for_clock")
        calls.append(node.get_clock().now().nanoseconds)
        node.create_timer(0.1, lambda: calls.append(node.get_clock().now().nanoseconds))
        rclpy.spin(node)

    graph.start(main)
    graph.run(seconds=5)
    assert calls == [0]


def clock_player(stamps_s):
    """A main function that publishes /clock every 0.1 s, with these times [s]."""

    def main():
        rclpy.init()
        node = Node("player")
        publisher = node.create_publisher(type_named("rosgraph_msgs/msg/Clock"), "/clock", 10)
        times = iter(stamps_s)

        def tick():
            at_s = next(times, None)
            if at_s is not None:
                publisher.publish(publisher.msg_type(clock=Time(nanoseconds=seconds(at_s)).to_msg()))

        node.create_timer(0.1, tick)
        rclpy.spin(node)

    return main


def test_with_clock_a_node_and_its_timers_follow_it(graph):
    calls = []

    def main():
        rclpy.init(args=["node", "--ros-args", "-p", "use_sim_time:=true"])
        node = Node("follower")
        node.create_timer(10.0, lambda: calls.append((graph.now_ns, node.get_clock().now().nanoseconds)))
        rclpy.spin(node)

    graph.start(main)
    graph.start(clock_player([103.0, 105.0, 110.0, 115.0, 120.0]))
    graph.run(seconds=1)
    # The first message is a jump from 0 to 103 s, past the first call; what was missed is skipped.
    assert calls == [(seconds(1.1), seconds(103)), (seconds(1.3), seconds(110)), (seconds(1.5), seconds(120))]


def listening_to_a_jump(graph, with_node, buffers, back_to_s):
    def main():
        rclpy.init(args=["node", "--ros-args", "-p", "use_sim_time:=true"])
        node = Node("listener")
        buffer = Buffer(node=node) if with_node else Buffer()
        buffers.append(buffer)
        rclpy.spin(node)

    graph.start(main)
    graph.start(clock_player([100.0, 101.0, back_to_s]))
    graph.run(seconds=0.25)
    buffers[0].set_transform(transform("odom", "base_link", seconds(101)), "test")
    graph.run(seconds=1)
    return buffers[0].can_transform("odom", "base_link", Time())


@pytest.mark.parametrize(("back_to_s", "is_noticed"), [(50.0, True), (100.5, False)])
def test_a_buffer_with_a_node_forgets_everything_when_time_jumps_back_a_second(graph, capsys, back_to_s, is_noticed):
    assert listening_to_a_jump(graph, True, [], back_to_s) != is_noticed
    warning = "[WARN] [1.300000000] [tf2_buffer]: Detected jump back in time. Clearing tf buffer."
    assert (warning in capsys.readouterr().err) == is_noticed


def test_a_buffer_without_a_node_does_not_clear_and_then_refuses_what_is_too_old(graph, capsys):
    buffers = []
    assert listening_to_a_jump(graph, False, buffers, back_to_s=50.0)
    buffers[0].set_transform(transform("odom", "base_link", seconds(50)), "default_authority")
    assert (
        "[WARN] [2.250000000] []: TF_OLD_DATA ignoring data from the past for frame base_link at time 50.000000 "
        "according to authority default_authority\n"
        "Possible reasons are listed at http://wiki.ros.org/tf/Errors%20explained\n"
    ) in capsys.readouterr().err


def test_use_sim_time_can_be_set_while_running_and_clears_the_buffer(node, capsys):
    buffer = Buffer(node=node)
    buffer.set_transform(transform("odom", "base_link", seconds(1)), "test")
    results = node.set_parameters([Parameter("use_sim_time", Parameter.Type.BOOL, True)])
    assert results[0].successful
    assert node.get_clock().now().nanoseconds == 0
    assert not buffer.can_transform("odom", "base_link", Time())
    assert capsys.readouterr().err.count("Detected jump back in time. Clearing tf buffer.") == 1


# -- late joiners -------------------------------------------------------------------------


def hear_late(graph, static_qos):
    """Return whether a listener that comes after a static transform was published knows it."""

    def bolted():
        rclpy.init()
        node = Node("bolted")
        StaticTransformBroadcaster(node).sendTransform(transform("base_link", "laser"))
        rclpy.spin(node)

    graph.start(bolted)
    graph.run(seconds=1)
    rclpy.init()
    node = Node("late")
    buffer = Buffer()
    node.listener = TransformListener(buffer, node, static_qos=static_qos)
    rclpy.spin_once(node, timeout_sec=0.1)
    found = buffer.can_transform("base_link", "laser", Time())
    rclpy.shutdown()
    return found


def test_a_late_listener_receives_static_transforms_if_it_is_transient_local(graph):
    assert hear_late(graph, static_qos=None)
    assert not hear_late(graph, static_qos=10)


def test_latched_messages_are_lost_with_their_publisher(graph):
    def short_lived():
        rclpy.init()
        node = Node("short_lived")
        StaticTransformBroadcaster(node).sendTransform(transform("base_link", "laser"))

    graph.start(short_lived)
    rclpy.init()
    node = Node("late")
    buffer = Buffer()
    node.listener = TransformListener(buffer, node)
    rclpy.spin_once(node, timeout_sec=0.1)
    assert not buffer.can_transform("base_link", "laser", Time())
    rclpy.shutdown()


def test_a_repeated_stamp_replaces_without_a_warning(graph, capsys):
    buffer = Buffer()
    for x in (1.0, 2.0):
        buffer.set_transform(transform("odom", "base_link", seconds(1), x), "somebody")
    assert buffer.lookup_transform("odom", "base_link", Time()).transform.translation.x == 2.0
    assert capsys.readouterr().err == ""


# -- quality of service -----------------------------------------------------------------


@pytest.mark.parametrize(
    ("distro", "offered", "requested", "policy"),
    [
        ("jazzy", {"reliability": ReliabilityPolicy.BEST_EFFORT}, {}, "RELIABILITY"),
        ("jazzy", {}, {"durability": DurabilityPolicy.TRANSIENT_LOCAL}, "DURABILITY"),
        ("humble", {}, {"durability": DurabilityPolicy.TRANSIENT_LOCAL}, "DURABILITY_QOS_POLICY"),
    ],
)
def test_incompatible_qos_is_logged_by_both_nodes(graph, capsys, monkeypatch, distro, offered, requested, policy):
    monkeypatch.setenv("TFLAB_ROS_DISTRO", distro)
    rclpy.init()
    talker, listener = Node("talker"), Node("listener")
    publisher = talker.create_publisher(String, "/t", QoSProfile(depth=1, **offered))
    received = []
    listener.create_subscription(String, "/t", received.append, QoSProfile(depth=10, **requested))
    publisher.publish(String())
    rclpy.spin_once(listener, timeout_sec=0.1)
    assert received == []
    assert capsys.readouterr().err == (
        "[WARN] [1.000000000] [listener]: New publisher discovered on topic '/t', offering incompatible QoS. "
        f"No messages will be received from it. Last incompatible policy: {policy}\n"
        "[WARN] [1.000000000] [talker]: New subscription discovered on topic '/t', requesting incompatible QoS. "
        f"No messages will be sent to it. Last incompatible policy: {policy}\n"
    )
    rclpy.shutdown()


# -- bad data -----------------------------------------------------------------------------


def test_a_zero_quaternion_travels_and_each_listener_refuses_it_in_its_log(graph, capsys):
    def hearer(number):
        def main():
            rclpy.init()
            node = Node(f"hearer{number}")
            node.listener = TransformListener(Buffer(), node)
            rclpy.spin(node)

        return main

    graph.start(hearer(1))
    graph.start(hearer(2))
    rclpy.init()
    node = Node("careless")
    message = transform("base_link", "laser")
    message.transform.rotation = Quaternion(x=0.0, y=0.0, z=0.0, w=0.0)
    StaticTransformBroadcaster(node).sendTransform(message)
    assert capsys.readouterr().err == ""
    graph.run(seconds=0.1)
    lines = capsys.readouterr().err.splitlines()
    refusals = [line for line in lines if "TF_DENORMALIZED_QUATERNION" in line]
    assert len(refusals) == 2
    assert refusals[0].startswith(
        '[ERROR] [1.000000000] []: TF_DENORMALIZED_QUATERNION: Ignoring transform for child_frame_id "laser" from '
        'authority "default_authority" because of an invalid quaternion in the transform ('
    )
    rclpy.shutdown()


def test_a_lookup_right_after_the_start_fails_because_nothing_has_arrived(graph):
    graph.start(moving(graph))
    graph.run(seconds=1)
    rclpy.init()
    node = Node("impatient")
    buffer = Buffer()
    node.listener = TransformListener(buffer, node)
    with pytest.raises(LookupException, match='"odom" passed to lookupTransform argument target_frame does not exist'):
        buffer.lookup_transform("odom", "base_link", Time())
    rclpy.shutdown()
