"""The graph: virtual time, isolated participants, reproducible delay and loss."""

import contextlib
import itertools
import os
import signal
import threading
import time

import pytest

from tflab.core import seconds
from tflab.ros import client_library as rclpy
from tflab.ros import snapshot, virtual
from tflab.ros.messages.std_msgs import String
from tflab.ros.node import Node
from tflab.ros.qos import QoSProfile, ReliabilityPolicy
from tflab.ros.time import ClockType, Duration


def talker(period_s=1.0, topic="chatter", name="talker"):
    """A main function that publishes "1", "2", ... every `period_s` [s]."""

    def main():
        rclpy.init()
        node = Node(name)
        publisher = node.create_publisher(String, topic, 10)
        count = iter(range(1, 1_000_000))
        node.create_timer(period_s, lambda: publisher.publish(String(data=str(next(count)))))
        rclpy.spin(node)

    return main


def recorder(heard, topic="chatter", name="recorder", qos=10):
    """A main function that notes (time [ns], text) of what it hears."""

    def main():
        rclpy.init()
        node = Node(name)
        node.create_subscription(
            String, topic, lambda msg: heard.append((node.get_clock().now().nanoseconds, msg.data)), qos
        )
        rclpy.spin(node)

    return main


def test_time_begins_at_one_second_and_advances_only_in_run(graph):
    heard = []
    graph.start(talker())
    graph.start(recorder(heard, qos=QoSProfile(depth=1, reliability=ReliabilityPolicy.BEST_EFFORT)))
    assert graph.now_ns == seconds(1)
    time.sleep(0.01)  # the notebook's own sleep is real
    assert graph.now_ns == seconds(1)
    graph.run(seconds=1.25)
    assert graph.now_ns == seconds(2.25)
    graph.run(seconds=1.75)
    assert heard == [(seconds(2), "1"), (seconds(3), "2"), (seconds(4), "3")]


def test_sleeping_inside_a_participant_passes_virtual_time(graph):
    seen = []

    def sleeper():
        seen.append(graph.now_ns)
        time.sleep(3600.0)
        seen.append(graph.now_ns)

    participants = [graph.start(sleeper) for _ in range(2)]
    assert [each.name for each in participants] == ["sleeper", "sleeper_2"]
    assert seen == [seconds(1)] * 2  # they have run up to their first wait
    participants[1].stop()
    assert [each.is_running for each in participants] == [True, False]
    graph.run(seconds=3600)
    assert seen == [seconds(1), seconds(1), seconds(3601)]


def test_each_participant_has_a_context_and_an_executor_of_its_own(graph):
    contexts, executors = [], []

    def main():
        rclpy.init()
        contexts.append(rclpy.get_default_context())
        executors.append(rclpy.get_global_executor())

    graph.start(main)
    graph.start(main)
    rclpy.init()  # the notebook's own
    contexts.append(rclpy.get_default_context())
    executors.append(rclpy.get_global_executor())
    rclpy.shutdown()
    assert len(set(map(id, contexts))) == 3
    assert len(set(map(id, executors))) == 3


def test_nodes_and_publishers_of_an_ended_participant_leave_the_graph(graph):
    def forgetful():
        rclpy.init()
        node = Node("forgetful")
        node.create_publisher(String, "chatter", 10)
        time.sleep(1.0)  # and then it ends, without destroying anything

    participant = graph.start(forgetful)
    assert [node.get_name() for node in graph.nodes] == ["forgetful"]
    graph.run(seconds=1)
    assert not participant.is_running
    assert graph.nodes == []
    assert graph.network.topics["/chatter"].publishers == []


def test_an_exception_is_reported_by_name_and_others_continue(graph, capsys):
    heard = []

    def clumsy():
        rclpy.init()
        node = Node("clumsy")
        node.create_timer(1.5, lambda: 1 / 0)
        rclpy.spin(node)

    participant = graph.start(clumsy)
    graph.start(talker())
    graph.start(recorder(heard))
    graph.run(seconds=3)
    assert len(heard) == 3
    assert isinstance(participant.exception, ZeroDivisionError)
    report = capsys.readouterr().err
    assert report.startswith('participant "clumsy" ended with an exception:\nTraceback (most recent call last):')
    assert report.rstrip().endswith("ZeroDivisionError: division by zero")


def test_an_endless_loop_is_stopped_and_located_and_others_continue(graph, capsys):
    graph.driver.patience_s = 0.2
    heard = []

    def busy():
        while True:
            pass

    def stubborn():
        while True:
            try:
                while True:
                    pass
            except Exception:
                pass

    participant = graph.start(busy)
    graph.start(stubborn)
    graph.start(talker())
    graph.start(recorder(heard))
    graph.run(seconds=2)
    report = capsys.readouterr().err
    assert 'participant "busy" ended with an exception:\nEndless loop: it kept busy for 0.2 s of real time' in report
    assert "test_graph.py:" in report and "in busy" in report
    assert 'participant "stubborn"' in report
    assert not participant.is_running
    assert len(heard) == 2


def test_polling_without_a_timeout_advances_time_by_a_millisecond(graph):
    heard = []

    def poller():
        rclpy.init()
        node = Node("poller")
        node.create_subscription(String, "chatter", lambda msg: heard.append(msg.data), 10)
        while rclpy.ok():
            rclpy.spin_once(node, timeout_sec=0)

    graph.start(talker(0.1))
    graph.start(poller)
    graph.run(seconds=0.35)
    assert heard == ["1", "2", "3"]


def test_two_nodes_that_answer_each_other_at_once_do_not_stop_time(graph):
    def echo(hears, says):
        def main():
            rclpy.init()
            node = Node(f"echo_{hears}")
            publisher = node.create_publisher(String, says, 10)
            node.create_subscription(String, hears, publisher.publish, 10)
            publisher.publish(String())
            rclpy.spin(node)

        return main

    graph.start(echo("ping", "pong"))
    graph.start(echo("pong", "ping"))
    graph.run(seconds=0.002)
    assert graph.now_ns == seconds(1.002)


def test_stop_interrupts_spin_and_sleep_and_runs_their_cleanup(graph):
    seen = []

    def spinner():
        rclpy.init()
        node = Node("spinner")
        try:
            rclpy.spin(node)
        except KeyboardInterrupt:
            time.sleep(0.5)
            seen.append(("spinner", rclpy.ok()))
        rclpy.shutdown()

    def sleeper():
        try:
            time.sleep(100)
        finally:
            seen.append("sleeper")

    graph.start(spinner)
    graph.start(sleeper)
    graph.stop()
    assert sorted(map(str, seen)) == ["('spinner', True)", "sleeper"]
    assert [each.is_running for each in graph.participants] == [False, False]


def test_a_participant_that_ignores_ctrl_c_is_ended(graph, capsys):
    def stubborn():
        while True:
            with contextlib.suppress(KeyboardInterrupt):
                time.sleep(1)

    participant = graph.start(stubborn)
    graph.stop()
    assert not participant.is_running
    assert capsys.readouterr().err == ('participant "stubborn" went on after it was interrupted, and was ended.\n')


def test_spinning_in_the_cell_advances_time(graph):
    graph.start(talker())
    rclpy.init()
    heard = []
    node = Node("cell")
    node.create_subscription(String, "chatter", lambda msg: heard.append(msg.data), 10)
    rclpy.spin_once(node, timeout_sec=5.0)
    assert (heard, graph.now_ns) == (["1"], seconds(2))
    rclpy.spin_once(node, timeout_sec=0.25)
    assert (heard, graph.now_ns) == (["1"], seconds(2.25))
    rclpy.shutdown()


def test_what_a_graph_cannot_do_raises_with_a_remedy(node, graph, capsys):
    def meddler():
        graph.run(seconds=1)

    def main():
        pass

    with pytest.raises(RuntimeError, match="this would wait for ever: nobody in the graph has anything left to do"):
        rclpy.spin_once(node)
    with pytest.raises(TypeError, match="takes a function, not None: pass main itself, without calling it"):
        graph.start(main())
    assert graph.participants == []
    participant = graph.start(meddler)
    assert isinstance(participant.exception, RuntimeError)
    assert "only the thread that made the graph can let time pass" in capsys.readouterr().err


def test_threads_of_a_participant_take_turns_with_everybody_else(graph):
    seen = []

    def main():
        def worker():
            time.sleep(0.5)
            seen.append(("worker", graph.now_ns))

        thread = threading.Thread(target=worker)
        thread.start()
        thread.join()
        seen.append(("main", graph.now_ns))

    graph.start(main)
    graph.run(seconds=1)
    assert seen == [("worker", seconds(1.5)), ("main", seconds(1.5))]


@pytest.mark.filterwarnings("ignore::pytest.PytestUnhandledThreadExceptionWarning")  # as in rclpy
def test_a_thread_that_spins_may_be_started_from_the_cell(graph):
    rclpy.init()
    node = Node("cell")
    ticks = []
    node.create_timer(0.1, lambda: ticks.append(graph.now_ns))
    threading.Thread(target=rclpy.spin, args=(node,), daemon=True).start()
    graph.run(seconds=0.35)
    assert ticks == [seconds(1.1), seconds(1.2), seconds(1.3)]
    rclpy.shutdown()
    graph.run(seconds=0.1)


def test_jitter_keeps_the_order_and_loss_loses_its_share_and_a_delay_is_exact(graph):
    heard, again = [], []
    graph.disturb("/chatter", delay=0.01, jitter=0.3, loss=0.25, seed=7)
    graph.disturb("/again", delay=0.01, jitter=0.3, loss=0.25, seed=7)
    for topic, list_ in (("chatter", heard), ("again", again)):
        graph.start(recorder(list_, topic, f"recorder_{topic}", qos=1000))
        graph.start(talker(0.05, topic, f"talker_{topic}"))
    graph.run(seconds=20)
    numbers = [int(text) for _, text in heard]
    assert numbers == sorted(numbers)
    assert 250 < len(numbers) < 350  # of 400
    assert heard != again  # another topic, another trouble

    graph.disturb("/chatter", delay=0.02)
    graph.run(seconds=0.5)
    del heard[:]
    graph.run(seconds=1)
    assert [(ns - seconds(0.02)) % seconds(0.05) for ns, _ in heard] == [0] * 20


@pytest.mark.parametrize(
    ("attempt", "text"),
    [
        (lambda graph: graph.run(seconds=-1), "time cannot run back: seconds=-1"),
        (lambda graph: graph.disturb("/tf", jitter=-0.1), "delay and jitter must not be negative"),
        (lambda graph: graph.disturb("/tf", loss=1.5), "loss is between 0 and 1"),
        (lambda graph: graph.disturb("tf", delay=1), 'absolute name: "/tf", not "tf"'),
        (lambda graph: graph.set_clock_offset("n", -2.0), r"would show -1.000 s.*graph\.run\(seconds=1\)"),
    ],
)
def test_impossible_arguments_are_refused(graph, attempt, text):
    with pytest.raises(ValueError, match=text):
        attempt(graph)


def test_the_clock_of_one_node_can_be_wrong(graph, capsys):
    rclpy.init()
    right, wrong = Node("right"), Node("wrong")
    graph.set_clock_offset("wrong", -0.4)
    graph.set_clock_offset("/late/comer", 2.0)
    late = Node("comer", namespace="late")
    assert right.get_clock().now().nanoseconds == seconds(1)
    assert wrong.get_clock().now().nanoseconds == seconds(0.6)
    assert late.get_clock().now().nanoseconds == seconds(3)
    wrong.get_logger().info("what time is it?")
    assert capsys.readouterr().err == "[INFO] [0.600000000] [wrong]: what time is it?\n"
    assert right.get_clock().clock_type == ClockType.ROS_TIME
    assert right.get_clock().sleep_for(Duration(seconds=1.5))
    assert graph.now_ns == seconds(2.5)
    graph.set_clock_offset("wrong", -2.0)  # not before zero any more
    rclpy.shutdown()


def test_a_snapshot_knows_who_publishes_what(graph):
    from tflab.ros.messages.geometry_msgs import TransformStamped
    from tflab.ros.tf2.topics import TransformBroadcaster

    def robot():
        rclpy.init()
        node = Node("robot", namespace="/a")
        message = TransformStamped(child_frame_id="base_link")
        message.header.frame_id = "odom"
        TransformBroadcaster(node).sendTransform(message)
        rclpy.spin(node)

    graph.start(robot)
    seen = snapshot(graph)
    assert [(node.name, node.participant) for node in seen.nodes] == [("/a/robot", "robot")]
    assert [tuple(edge) for edge in seen.edges] == [("odom", "base_link", "/tf", "/a/robot", 1)]
    assert [topic.name for topic in seen.topics] == ["/parameter_events", "/rosout", "/tf"]


def press_stop_after(seconds_real):
    """Send what the stop button of a notebook sends."""
    timer = threading.Timer(seconds_real, lambda: os.kill(os.getpid(), signal.SIGINT))
    timer.daemon = True
    timer.start()


def test_the_stop_button_stops_all_participants(graph):
    tidied = []

    def slow():
        try:
            while True:
                time.sleep(0.001)
                sum(range(10_000_000))  # it has the turn nearly all the time
        finally:
            tidied.append("slow")

    participants = [graph.start(talker()), graph.start(slow)]
    press_stop_after(0.3)
    with pytest.raises(KeyboardInterrupt):
        graph.run(seconds=1e9)
    assert [each.is_running for each in participants] == [False, False]
    assert tidied == ["slow"]


def test_an_endless_spin_in_the_cell_passes_time_as_fast_as_it_really_does(node, graph):
    ticks = []
    node.create_timer(0.05, lambda: ticks.append(graph.now_ns))
    press_stop_after(0.5)
    with pytest.raises(KeyboardInterrupt):
        rclpy.spin(node)
    assert rclpy.ok()
    assert 1 <= len(ticks) <= 1000  # at full speed it would be ten thousands


def test_a_participant_with_little_cpu_time_is_not_reported_as_endless_loop(graph, monkeypatch):
    computed_s = itertools.count(0.0, 0.001)  # a hundredth of what passes: others have the processor
    monkeypatch.setattr(virtual, "cpu_s_of", lambda thread: next(computed_s))
    graph.driver.patience_s = 0.3
    ended = []

    def main():
        for _ in range(6):
            time.monotonic_ns()
            threading.Event().wait(0.1)  # not the graph's: it keeps its turn
        ended.append(True)

    graph.start(main)
    assert ended == [True]
    assert graph.participants[0].exception is None
