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
    def questions(client):
        assert client.can_transform("map", "base_link", Time(seconds=2)) is True
        assert client.can_transform("map", "nowhere", Time()) is False  # which does not raise
        full = client.lookup_transform_full("base_link", Time(seconds=3), "base_link", Time(seconds=1), "map")
        return client.lookup_transform("map", "base_link", Time(seconds=2)), full

    graph.start(server())
    found, moved = answer_to(graph, questions)
    assert (found.header.frame_id, found.child_frame_id, found.transform.translation.x) == ("map", "base_link", 2.0)
    assert moved.transform.translation.x == -2.0  # where it was 2 s ago: 2 m behind


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


async def think_forever(handle):
    await Future()


@pytest.mark.parametrize(
    ("main", "text"),
    [
        (None, "The BufferServer is not ready."),
        (server(think_forever), "did not come back in the specified time. Something is likely wrong with the server."),
        (server(goal_callback=lambda goal: GoalResponse.REJECT), "did not come back with accepted status"),
    ],
    ids=["none", "slow", "rejects"],
)
def test_without_an_answer_of_the_server_a_timeout_is_raised(graph, main, text):
    if main:
        graph.start(main)
    answer = answer_to(
        graph, lambda client: client.lookup_transform("map", "base_link", Time(), timeout=Duration(seconds=0.2))
    )
    assert type(answer) is TimeoutException
    assert text in str(answer)


def test_a_time_must_be_a_time_and_a_message_is_deprecated(graph):
    graph.start(server())
    assert isinstance(answer_to(graph, lambda client: client.lookup_transform("map", "base_link", 2.0)), TypeError)
    with pytest.warns(UserWarning, match="deprecated"):
        result = answer_to(graph, lambda client: client.lookup_transform("map", "base_link", Time(seconds=2).to_msg()))
    assert result.transform.translation.x == 2.0


# The action itself ----------------------------------------------------------------


def test_a_goal_that_is_aborted_has_a_result_and_one_without_an_end_counts_as_aborted(graph, capsys):
    def give_up(handle):
        if not handle.request.target_frame:
            raise RuntimeError("out of order")
        handle.abort()
        return LookupTransform.Result(error=TF2Error(error_string=f"no {handle.request.target_frame}"))

    answers = []

    def main():
        rclpy.init()
        node = Node("client")
        client = ActionClient(node, LookupTransform, "tf2_buffer_server")
        assert client.wait_for_server(timeout_sec=1.0)
        with pytest.raises(TypeError):
            client.send_goal_async(TransformStamped())
        for frame in ("map", ""):
            handle = spin_for(node, client.send_goal_async(LookupTransform.Goal(target_frame=frame)))
            answers.append(spin_for(node, handle.get_result_async()))
        rclpy.spin(node)

    def spin_for(node, future):
        rclpy.spin_until_future_complete(node, future)
        return future.result()

    graph.start(server(give_up))
    graph.start(main)
    graph.run(seconds=2)
    assert [answer.status for answer in answers] == [GoalStatus.STATUS_ABORTED] * 2
    assert [answer.result.error.error_string for answer in answers] == ["no map", ""]
    printed = capsys.readouterr().err
    assert "[tf_buffer.action_server]: Error raised in execute callback: out of order" in printed
    assert "Goal state not set, assuming aborted" in printed
