"""BufferClient looks transforms up in the buffer of another node, by an action."""

import threading

import pytest

from tflab.core import (
    ConnectivityException,
    ExtrapolationException,
    InvalidArgumentException,
    LookupException,
    TimeoutException,
    TransformException,
)
from tflab.ros import client_library as rclpy
from tflab.ros.action_client import ActionClient
from tflab.ros.action_server import ActionServer, GoalResponse
from tflab.ros.messages.action_msgs import GoalStatus
from tflab.ros.messages.geometry_msgs import TransformStamped
from tflab.ros.messages.tf2_msgs import LookupTransform, TF2Error
from tflab.ros.node import Node
from tflab.ros.task import Future
from tflab.ros.tf2.buffer import Buffer
from tflab.ros.tf2.client import BufferClient
from tflab.ros.time import Duration, Time

NUMBERS = {
    LookupException: TF2Error.LOOKUP_ERROR,
    ConnectivityException: TF2Error.CONNECTIVITY_ERROR,
    ExtrapolationException: TF2Error.EXTRAPOLATION_ERROR,
    InvalidArgumentException: TF2Error.INVALID_ARGUMENT_ERROR,
}


def known_buffer():
    """map --(x = sec, at 1 s and 3 s)--> base_link;  island --> palm"""
    buffer = Buffer()
    for parent, child in (("map", "base_link"), ("island", "palm")):
        for sec in (1, 3):
            transform = TransformStamped(child_frame_id=child)
            transform.header.frame_id = parent
            transform.header.stamp.sec = sec
            transform.transform.translation.x = float(sec)
            buffer.set_transform(transform, "test")
    return buffer


def server(execute=None, **options):
    """A main function: answers from known_buffer(), or as `execute` does."""

    def main():
        rclpy.init()
        node = Node("tf_buffer")
        buffer = known_buffer()

        def answer(handle):
            goal, result = handle.request, LookupTransform.Result()
            try:
                if goal.advanced:
                    result.transform = buffer.lookup_transform_full(
                        goal.target_frame, goal.target_time, goal.source_frame, goal.source_time, goal.fixed_frame
                    )
                else:
                    result.transform = buffer.lookup_transform(goal.target_frame, goal.source_frame, goal.source_time)
            except TransformException as error:
                result.error = TF2Error(error=NUMBERS[type(error)], error_string=str(error))
            handle.succeed()
            return result

        ActionServer(node, LookupTransform, "tf2_buffer_server", execute or answer, **options)
        rclpy.spin(node)

    return main


def asking(question):
    """A main function that puts `question(client)` to the server, and the list that the answer, or error, gets into."""
    answers = []

    def main():
        rclpy.init()
        node = Node("asker")
        client = BufferClient(node, "tf2_buffer_server", timeout_padding=Duration(seconds=0.5))
        spinner = threading.Thread(target=rclpy.spin, args=(node,), daemon=True)
        spinner.start()
        try:
            answers.append(question(client))
        except Exception as error:
            answers.append(error)
        client.destroy()
        rclpy.spin_once(Node("idle"), timeout_sec=100.0)

    return main, answers


def answer_to(graph, question):
    main, answers = asking(question)
    graph.start(main)
    graph.run(seconds=2)
    (answer,) = answers
    return answer


def test_a_lookup_is_answered_by_the_other_buffer(graph):
    graph.start(server())
    result = answer_to(graph, lambda client: client.lookup_transform("map", "base_link", Time(seconds=2)))
    assert (result.header.frame_id, result.child_frame_id, result.transform.translation.x) == ("map", "base_link", 2.0)


def test_lookups_with_two_times_are_forwarded(graph):
    graph.start(server())
    result = answer_to(
        graph,
        lambda client: client.lookup_transform_full("base_link", Time(seconds=3), "base_link", Time(seconds=1), "map"),
    )
    assert result.transform.translation.x == -2.0  # where it was 2 s ago: 2 m behind


@pytest.mark.parametrize(
    ("question", "error", "text"),
    [
        (("map", "nowhere", Time()), LookupException, '"nowhere" passed to lookupTransform argument source_frame does'),
        (("map", "palm", Time()), ConnectivityException, "not part of the same tree.Tf has two or more unconnected"),
        (("map", "base_link", Time(seconds=9)), ExtrapolationException, "into the future.  Requested time 9.000000"),
        (("", "base_link", Time()), InvalidArgumentException, "in tf2 frame_ids cannot be empty"),
    ],
)
def test_exceptions_of_the_server_are_raised_at_the_client_with_their_text(graph, question, error, text):
    graph.start(server())
    answer = answer_to(graph, lambda client: client.lookup_transform(*question))
    assert type(answer) is error
    assert text in str(answer)


def test_can_transform_does_not_raise(graph):
    graph.start(server())
    assert answer_to(graph, lambda client: client.can_transform("map", "base_link", Time(seconds=2))) is True
    assert answer_to(graph, lambda client: client.can_transform("map", "nowhere", Time())) is False


def test_without_a_server_it_raises_at_once(graph):
    answer = answer_to(graph, lambda client: client.lookup_transform("map", "base_link", Time()))
    assert type(answer) is TimeoutException
    assert str(answer) == "The BufferServer is not ready."


def test_a_slow_server_raises_a_timeout(graph):
    async def think_forever(handle):
        await Future()

    graph.start(server(think_forever))
    answer = answer_to(
        graph, lambda client: client.lookup_transform("map", "base_link", Time(), timeout=Duration(seconds=0.2))
    )
    assert type(answer) is TimeoutException
    assert "did not come back in the specified time. Something is likely wrong with the server." in str(answer)


def test_a_rejected_goal_is_a_timeout_exception_too(graph):
    graph.start(server(goal_callback=lambda goal: GoalResponse.REJECT))
    answer = answer_to(graph, lambda client: client.lookup_transform("map", "base_link", Time()))
    assert type(answer) is TimeoutException
    assert "did not come back with accepted status" in str(answer)


def test_a_time_must_be_a_time_and_a_message_is_deprecated(graph):
    graph.start(server())
    assert isinstance(answer_to(graph, lambda client: client.lookup_transform("map", "base_link", 2.0)), TypeError)
    with pytest.warns(UserWarning, match="deprecated"):
        result = answer_to(graph, lambda client: client.lookup_transform("map", "base_link", Time(seconds=2).to_msg()))
    assert result.transform.translation.x == 2.0


# The action itself ----------------------------------------------------------------


def result_status(graph, execute):
    """Return status and result of one goal, sent and waited for by one node with callbacks alone."""
    answers = []

    def main():
        rclpy.init()
        node = Node("client")
        client = ActionClient(node, LookupTransform, "tf2_buffer_server")
        assert client.wait_for_server(timeout_sec=1.0)
        handle = spin_for(node, client.send_goal_async(LookupTransform.Goal(target_frame="map")))
        answers.append(spin_for(node, handle.get_result_async()))
        rclpy.spin(node)

    def spin_for(node, future):
        rclpy.spin_until_future_complete(node, future)
        return future.result()

    graph.start(server(execute))
    graph.start(main)
    graph.run(seconds=2)
    return answers[0].status, answers[0].result


def test_a_goal_that_is_aborted_still_has_a_result(graph):
    def give_up(handle):
        handle.abort()
        return LookupTransform.Result(error=TF2Error(error_string=f"no {handle.request.target_frame}"))

    status, result = result_status(graph, give_up)
    assert (status, result.error.error_string) == (GoalStatus.STATUS_ABORTED, "no map")


def test_a_goal_without_an_end_counts_as_aborted_and_its_exception_is_logged(graph, capsys):
    def broken(handle):
        raise RuntimeError("out of order")

    status, result = result_status(graph, broken)
    assert (status, result) == (GoalStatus.STATUS_ABORTED, LookupTransform.Result())
    printed = capsys.readouterr().err
    assert "[tf_buffer]: Error raised in execute callback: out of order" in printed
    assert "Goal state not set, assuming aborted" in printed


def test_an_object_that_is_not_a_goal_is_refused(graph):
    rclpy.init(args=[])
    client = ActionClient(Node("client"), LookupTransform, "tf2_buffer_server")
    with pytest.raises(TypeError):
        client.send_goal_async(TransformStamped())
    assert not client.server_is_ready()
    rclpy.shutdown()
