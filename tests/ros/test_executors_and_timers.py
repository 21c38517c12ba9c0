"""Executors, callback groups, timers and futures, on virtual time."""

import asyncio
import time

import pytest

from tflab.core import seconds
from tflab.ros import client_library as rclpy
from tflab.ros.entity import MutuallyExclusiveCallbackGroup, ReentrantCallbackGroup
from tflab.ros.exceptions import ConditionReachedException, RCLError, ROSInterruptException, TimeoutException
from tflab.ros.executors import Executor, ExternalShutdownException, MultiThreadedExecutor, SingleThreadedExecutor
from tflab.ros.graph import new_graph
from tflab.ros.messages.rcl_interfaces import GetParameters
from tflab.ros.messages.std_msgs import String
from tflab.ros.node import Node
from tflab.ros.task import Future, Task


def test_spin_once_executes_one_callback(node, graph):
    done = []
    node.create_timer(0.1, lambda: done.append("a"))
    node.create_timer(0.1, lambda: done.append("b"))
    rclpy.spin_once(node, timeout_sec=1.0)
    assert done == ["a"]
    rclpy.spin_once(node, timeout_sec=1.0)
    assert done == ["a", "b"]
    assert graph.now_ns == seconds(1.1)


def test_an_executor_of_ones_own_takes_what_is_ready(node):
    class Own(Executor):
        def spin_once(self, timeout_sec=None):
            handler, entity, owner = self.wait_for_ready_callbacks(timeout_sec=timeout_sec)
            handler()
            done.append((entity is timer, owner is node, str(handler.exception()), self.can_execute(entity)))

    done = []
    timer = node.create_timer(0.1, lambda: [].pop())
    executor = Own()
    executor.add_node(node)
    executor.spin_once(timeout_sec=0.2)
    assert done == [(True, True, "pop from empty list", True)]
    for error, options in (
        (TimeoutException, {"timeout_sec": 0.05}),
        (ConditionReachedException, {"condition": object}),
    ):
        with pytest.raises(error):
            executor.wait_for_ready_callbacks(**options)


def test_waiting_for_a_future_in_a_callback_times_out_and_the_node_goes_on(node):
    done = []

    def tick():
        future = Future()
        node.create_timer(0.05, lambda: future.set_result("of this group, so later"))
        rclpy.spin_until_future_complete(node, future, timeout_sec=0.1)
        done.append(future.done())

    node.create_timer(0.2, tick)
    rclpy.spin_until_future_complete(node, Future(), timeout_sec=0.9)
    assert done[:2] == [False, False]


def test_in_a_round_timers_come_first_and_a_subscription_gives_one_message(node):
    done = []
    publisher = node.create_publisher(String, "chatter", 10)
    node.create_subscription(String, "chatter", lambda msg: done.append(msg.data), 10)
    guard = node.create_guard_condition(lambda: done.append("guard"))
    node.create_timer(0.0, lambda: done.append("timer"))
    guard.trigger()
    publisher.publish(String(data="1"))
    publisher.publish(String(data="2"))
    for _ in range(5):
        rclpy.spin_once(node, timeout_sec=0.1)
    assert done == ["timer", "1", "guard", "timer", "2"]


def test_a_full_queue_drops_its_oldest_message(node):
    heard = []
    publisher = node.create_publisher(String, "chatter", 10)
    node.create_subscription(String, "chatter", lambda msg: heard.append(msg.data), 3)
    for number in range(10):
        publisher.publish(String(data=str(number)))
    for _ in range(5):
        rclpy.spin_once(node, timeout_sec=0.01)
    assert heard == ["7", "8", "9"]


def test_publishing_copies_and_each_callback_gets_its_own(node):
    heard = []
    publisher = node.create_publisher(String, "chatter", 10)
    node.create_subscription(String, "chatter", heard.append, 10)
    node.create_subscription(String, "chatter", heard.append, 10)
    message = String(data="as published")
    publisher.publish(message)
    message.data = "changed"
    rclpy.spin_once(node, timeout_sec=0.01)
    rclpy.spin_once(node, timeout_sec=0.01)
    assert [each.data for each in heard] == ["as published"] * 2
    assert heard[0] is not heard[1]


def test_a_callback_with_two_arguments_receives_message_info(node, graph):
    heard = []
    graph.disturb("/chatter", delay=0.5)
    publisher = node.create_publisher(String, "chatter", 10)
    node.create_subscription(String, "chatter", lambda msg, info: heard.append(info), 10)
    publisher.publish(String())
    rclpy.spin_once(node, timeout_sec=1.0)
    assert (heard[0]["source_timestamp"], heard[0]["received_timestamp"]) == (seconds(1), seconds(1.5))
    assert heard[0]["publisher_gid"] == publisher.gid


def test_an_exception_in_a_callback_comes_out_of_spin_whatever_the_thread(node, graph, capsys):
    def main():
        rclpy.init()
        clumsy = Node("clumsy")
        clumsy.create_timer(0.5, lambda: 1 / 0)
        executor = MultiThreadedExecutor(2)
        executor.add_node(clumsy)
        executor.spin()

    node.create_timer(0.1, lambda: 1 / 0)
    with pytest.raises(ZeroDivisionError):
        rclpy.spin(node)
    participant = graph.start(main)
    graph.run(seconds=2)
    assert isinstance(participant.exception, ZeroDivisionError)
    capsys.readouterr()


def test_after_ctrl_c_nothing_can_be_published(node):
    publisher = node.create_publisher(String, "chatter", 1)
    rclpy.get_default_context().signalled()
    node.get_logger().info("a log line is written all the same")
    with pytest.raises(RCLError, match="Failed to publish: publisher's context is invalid, at "):
        publisher.publish(String())


def test_init_works_again_after_shutdown_which_ends_spin(node):
    node.create_timer(0.1, rclpy.shutdown)
    rclpy.spin(node)
    assert not rclpy.ok()
    with pytest.raises(RuntimeError, match="Context must be initialized before it can be shutdown"):
        rclpy.shutdown()
    rclpy.init()
    with pytest.raises(RuntimeError, match=r"Context.init\(\) must only be called once"):
        rclpy.init()
    rclpy.get_default_context().shutdown()
    with pytest.raises(RCLError, match="failed to shutdown: rcl_shutdown already called on the given context, at "):
        rclpy.shutdown()


def test_spinning_after_an_external_shutdown_raises(node):
    executor = SingleThreadedExecutor()
    executor.add_node(node)
    rclpy.get_default_context().try_shutdown()
    with pytest.raises(ExternalShutdownException):
        executor.spin_once(timeout_sec=1.0)


# -- timers -----------------------------------------------------------------------


def test_missed_calls_are_skipped_not_replayed(node, graph):
    calls = []

    def slow():
        calls.append(graph.now_ns)
        if len(calls) == 1:
            time.sleep(0.35)

    node.create_timer(0.1, slow)
    for _ in range(3):
        rclpy.spin_once(node, timeout_sec=1.0)
    # Due at 1.1 (until 1.45); that of 1.2 is late; 1.3 and 1.4 are skipped.
    assert calls == [seconds(1.1), seconds(1.45), seconds(1.5)]


def test_a_canceled_timer_does_not_run_until_reset(node, graph):
    calls = []
    assert node.create_timer(0.5, lambda: None, autostart=False).is_canceled()
    timer = node.create_timer(0.5, lambda: calls.append(graph.now_ns))
    timer.cancel()
    assert timer.is_canceled() and timer.time_until_next_call() is None
    rclpy.spin_once(node, timeout_sec=1.0)
    assert calls == []
    timer.reset()
    assert timer.time_until_next_call() == seconds(0.5)
    for _ in range(2):
        rclpy.spin_once(node, timeout_sec=1.0)
    assert calls == [seconds(2.5), seconds(3.0)]


def test_a_new_period_counts_from_the_next_call_on(node, graph):
    calls = []
    timer = node.create_timer(0.5, lambda: calls.append(graph.now_ns))
    timer.timer_period_ns = seconds(0.1)
    for _ in range(2):
        rclpy.spin_once(node, timeout_sec=1.0)
    assert calls == [seconds(1.5), seconds(1.6)]


def test_a_rate_sleeps_while_another_thread_spins(graph):
    import threading

    ticks = []

    def main():
        rclpy.init()
        node = Node("worker")
        threading.Thread(target=rclpy.spin, args=(node,), daemon=True).start()
        rate = node.create_rate(4)
        for _ in range(3):
            rate.sleep()
            ticks.append(graph.now_ns)

    graph.start(main)
    graph.run(seconds=2)
    assert ticks == [seconds(1.25), seconds(1.5), seconds(1.75)]


def test_a_rate_raises_after_shutdown_and_must_be_positive(node):
    rate = node.create_rate(1)
    rclpy.shutdown()
    with pytest.raises(ROSInterruptException):
        rate.sleep()
    rclpy.init()
    with pytest.raises(ValueError, match="frequency must be > 0"):
        Node("other").create_rate(0)


# -- groups and threads -------------------------------------------------------------


def run_two_sleepy_timers(graph, groups, executor_type):
    """Return when two callbacks, due together and 0.3 s long, began."""
    began = []

    def main():
        rclpy.init()
        node = Node("sleepy")
        for group in groups:

            def callback():
                began.append(graph.now_ns)
                time.sleep(0.3)

            node.create_timer(0.5, callback, callback_group=group)
        executor = executor_type()
        executor.add_node(node)
        executor.spin()

    graph.start(main)
    graph.run(seconds=0.9)
    return began[:2]


@pytest.mark.parametrize(
    ("group", "executor", "second_s"),
    [
        (ReentrantCallbackGroup, SingleThreadedExecutor, 1.8),
        (ReentrantCallbackGroup, MultiThreadedExecutor, 1.5),
        (MutuallyExclusiveCallbackGroup, MultiThreadedExecutor, 1.8),
    ],
)
def test_only_callbacks_of_a_reentrant_group_run_together_in_many_threads(graph, group, executor, second_s):
    assert run_two_sleepy_timers(graph, [group()] * 2, executor) == [seconds(1.5), seconds(second_s)]


# -- futures, tasks, coroutines -------------------------------------------------------


def test_a_future_without_an_executor_calls_back_at_once_and_prints_a_lost_exception(capsys):
    future, done = Future(), []
    future.add_done_callback(lambda each: done.append(each.result()))
    assert future.result() is None and not future.done()
    future.set_result(3)
    future.add_done_callback(lambda each: done.append(each.result() + 1))
    assert done == [3, 4]
    future = Future()
    future.set_exception(ValueError("lost"))
    del future
    assert capsys.readouterr().err == "The following exception was never retrieved: lost\n"


def test_a_task_is_executed_by_the_next_round_and_a_coroutine_when_its_future_is_done(node, graph):
    executor = rclpy.get_global_executor()
    task = executor.create_task(lambda a, b: a + b, 1, b=2)
    executor.spin_until_future_complete(task)
    assert task.result() == 3
    future = Future()

    async def wait():
        return await future

    task = Task(wait)
    task()
    assert not task.done()
    rclpy.spin_until_future_complete(node, future, timeout_sec=0.5)
    assert graph.now_ns == seconds(1.5)
    future.set_result(5)
    task()
    assert task.result() == 5


def test_a_coroutine_callback_is_carried_on_when_its_future_is_done(node):
    future, done = Future(), []

    async def on_timer():
        done.append(await future)

    node.create_timer(0.5, on_timer)
    node.create_timer(1.2, lambda: future.set_result("here"), callback_group=ReentrantCallbackGroup())
    rclpy.spin_once(node, timeout_sec=1.0)
    assert done == []
    for _ in range(4):
        rclpy.spin_once(node, timeout_sec=0.5)
    assert done[0] == "here"


def test_a_coroutine_that_gives_way_without_a_future_goes_on_in_the_next_round(node, graph):
    done = []

    async def on_timer():
        await asyncio.sleep(0)
        done.append(graph.now_ns)

    node.create_timer(0.5, on_timer)
    rclpy.spin_until_future_complete(node, Future(), timeout_sec=1.2)
    assert done == [seconds(1.5), seconds(2.0)]


# -- services -------------------------------------------------------------------------


def test_a_service_answers_a_future(node, graph):
    def server():
        rclpy.init()
        rclpy.spin(Node("server"))

    graph.start(server)
    client = node.create_client(GetParameters, "/server/get_parameters")
    assert client.wait_for_service(timeout_sec=1.0)
    future = client.call_async(GetParameters.Request(names=["use_sim_time"]))
    rclpy.spin_until_future_complete(node, future, timeout_sec=1.0)
    assert [(value.type, value.bool_value) for value in future.result().values] == [(1, False)]
    before_ns = graph.now_ns
    client = node.create_client(GetParameters, "/nobody/get_parameters")
    assert not client.wait_for_service(timeout_sec=0.5)
    assert graph.now_ns == before_ns + seconds(0.5)
    with pytest.raises(TypeError, match="Expected <class"):
        client.call_async(String())


@pytest.mark.parametrize("executor_class", [SingleThreadedExecutor, MultiThreadedExecutor])
def test_each_tick_and_each_message_is_handled_once_even_in_a_reentrant_group(executor_class):
    ticks, heard = [], []

    def main():
        rclpy.init()
        node, group = Node("n"), ReentrantCallbackGroup()
        publisher = node.create_publisher(String, "chatter", 10)
        node.create_subscription(String, "chatter", heard.append, 10, callback_group=group)

        def tick():
            ticks.append(1)
            publisher.publish(String())

        node.create_timer(0.5, tick, callback_group=group)
        executor = executor_class()
        executor.add_node(node)
        executor.spin()

    graph = new_graph()
    graph.start(main)
    graph.run(seconds=2.2)
    graph.stop()
    assert (len(ticks), len(heard)) == (4, 4)
