"""Actions: goals, feedback, cancellation and results."""

import pytest

from tflab.ros import client_library as rclpy
from tflab.ros.action_client import ActionClient
from tflab.ros.action_goals import GoalEvent, next_status
from tflab.ros.action_server import ActionServer, CancelResponse, GoalResponse
from tflab.ros.entity import ReentrantCallbackGroup
from tflab.ros.exceptions import NoTypeSupportImportedException, RCLError
from tflab.ros.executors import MultiThreadedExecutor
from tflab.ros.messages import type_named
from tflab.ros.messages.action_msgs import CancelGoal, GoalInfo, GoalStatus
from tflab.ros.node import Node
from tflab.ros.time import Duration

AddTwoInts = type_named("example_interfaces/srv/AddTwoInts")
Fibonacci = type_named("example_interfaces/action/Fibonacci")


def count_up(pause_s=1.0):
    """Return an execute callback as the tutorials have it: one number a `pause_s` [s], feedback after each."""

    def execute(handle):
        node = handle._server._node
        feedback = Fibonacci.Feedback(sequence=[0, 1])
        for index in range(1, handle.request.order):
            if handle.is_cancel_requested:
                handle.canceled()
                return Fibonacci.Result(sequence=feedback.sequence)
            feedback.sequence.append(feedback.sequence[index] + feedback.sequence[index - 1])
            handle.publish_feedback(feedback)
            node.get_clock().sleep_for(Duration(seconds=pause_s))
        handle.succeed()
        return Fibonacci.Result(sequence=feedback.sequence)

    return execute


def server(execute=None, threads=None, **options):
    """A main function that serves /fibonacci."""

    def main():
        rclpy.init()
        node = Node("fibonacci_server")
        ActionServer(node, Fibonacci, "fibonacci", execute or count_up(), **options)
        executor = MultiThreadedExecutor() if threads else None
        rclpy.spin(node, executor=executor)

    return main


def client(script):
    """A main function that runs `script(node, client, wait)`; `wait(future)` spins until it is done."""

    def main():
        rclpy.init()
        node = Node("fibonacci_client")
        action_client = ActionClient(node, Fibonacci, "fibonacci")
        assert action_client.wait_for_server(timeout_sec=1.0)

        def wait(future, timeout_sec=None):
            rclpy.spin_until_future_complete(node, future, timeout_sec=timeout_sec)
            return future.result()

        script(node, action_client, wait)
        rclpy.spin(node)

    return main


def run(graph, script, seconds=30, **options):
    graph.start(server(**options))
    graph.start(client(script))
    graph.run(seconds=seconds)


def test_feedback_arrives_while_the_goal_is_worked_on_and_the_result_at_the_end(graph):
    seen = []

    def script(node, action_client, wait):
        def on_feedback(message):
            seen.append((round(node.get_clock().now().nanoseconds / 1e9), list(message.feedback.sequence)))

        handle = wait(action_client.send_goal_async(Fibonacci.Goal(order=4), feedback_callback=on_feedback))
        assert handle.accepted
        answer = wait(handle.get_result_async())
        seen.append((answer.status, list(answer.result.sequence), handle.status))

    run(graph, script)
    assert seen == [
        (1, [0, 1, 1]),
        (2, [0, 1, 1, 2]),
        (3, [0, 1, 1, 2, 3]),
        (GoalStatus.STATUS_SUCCEEDED, [0, 1, 1, 2, 3], GoalStatus.STATUS_SUCCEEDED),
    ]


def test_feedback_goes_to_the_client_of_its_goal_and_async_callbacks_do(graph):
    seen = {"one": [], "two": []}

    async def execute(handle):
        for _ in range(handle.request.order):
            handle.publish_feedback(Fibonacci.Feedback())
        handle.succeed()
        return Fibonacci.Result(sequence=[handle.request.order])

    async def accept(goal):
        return GoalResponse.ACCEPT

    def script(node, action_client, wait):
        handles = [
            wait(action_client.send_goal_async(Fibonacci.Goal(order=order), feedback_callback=seen[name].append))
            for name, order in (("one", 2), ("two", 4))
        ]
        assert [list(wait(handle.get_result_async()).result.sequence) for handle in handles] == [[2], [4]]

    run(graph, script, execute=execute, goal_callback=accept)
    assert [len(seen["one"]), len(seen["two"])] == [2, 4]


def cancelling(answers, after_s=2.5):
    """A script that sends a long goal, and calls it off after a while."""

    def script(node, action_client, wait):
        handle = wait(action_client.send_goal_async(Fibonacci.Goal(order=10)))
        result = handle.get_result_async()
        wait(result, timeout_sec=after_s)
        answers.append(wait(handle.cancel_goal_async()))
        answers.append(wait(result))
        answers.append(handle)

    return script


def test_a_goal_is_canceled_if_the_server_accepts_and_has_a_second_thread(graph):
    answers = []
    run(
        graph,
        cancelling(answers),
        threads=True,
        callback_group=ReentrantCallbackGroup(),
        cancel_callback=lambda handle: CancelResponse.ACCEPT,
    )
    answer, result, handle = answers
    assert [info.goal_id for info in answer.goals_canceling] == [handle.goal_id]
    assert (result.status, list(result.result.sequence)) == (GoalStatus.STATUS_CANCELED, [0, 1, 1, 2, 3])


def test_a_goal_is_not_canceled_without_a_cancel_callback_or_by_a_request_that_comes_too_late(graph):
    answers = []
    run(graph, cancelling(answers), cancel_callback=lambda handle: CancelResponse.ACCEPT)  # in one thread
    answer, result, _ = answers
    assert answer.return_code == CancelGoal.Response.ERROR_GOAL_TERMINATED
    assert (list(answer.goals_canceling), result.status) == ([], GoalStatus.STATUS_SUCCEEDED)
    graph.stop()
    answers.clear()
    run(graph, cancelling(answers), threads=True)
    assert (list(answers[0].goals_canceling), answers[1].status) == ([], GoalStatus.STATUS_SUCCEEDED)


def test_cancel_without_an_id_means_all_with_a_time_those_accepted_until_then(graph):
    answers = []

    def script(node, action_client, wait):
        cancel = node.create_client(CancelGoal, "fibonacci/_action/cancel_goal")
        sent = []
        for _ in range(3):
            sent.append(wait(action_client.send_goal_async(Fibonacci.Goal(order=30))))
            node.get_clock().sleep_for(Duration(seconds=1.0))
        first, second, third = sent
        unknown = GoalInfo()
        unknown.goal_id.uuid[0] = 9
        answer = wait(cancel.call_async(CancelGoal.Request(goal_info=unknown)))
        assert answer.return_code == CancelGoal.Response.ERROR_UNKNOWN_GOAL_ID
        for info in (GoalInfo(stamp=first.stamp), GoalInfo(goal_id=second.goal_id), GoalInfo()):
            answer = wait(cancel.call_async(CancelGoal.Request(goal_info=info)))
            answers.append([each.goal_id for each in answer.goals_canceling])
        answers.append([first.goal_id, second.goal_id, third.goal_id])

    run(graph, script, threads=True, cancel_callback=lambda handle: CancelResponse.ACCEPT, seconds=60)
    *cancelled, ids = answers
    assert cancelled == [[ids[0]], [ids[1]], [ids[2]]]  # who was called off before is not again


@pytest.mark.parametrize(
    ("response", "logged"),
    [(GoalResponse.REJECT, ""), (True, "Goal request callback did not return a GoalResponse type. Rejecting goal.")],
)
def test_a_rejected_goal_is_not_worked_on(graph, capsys, response, logged):
    answers = []
    run(
        graph,
        lambda node, c, wait: answers.append(wait(c.send_goal_async(Fibonacci.Goal(order=-1))).accepted),
        execute=lambda handle: answers.append("executed"),
        goal_callback=lambda goal: response,
    )
    assert answers == [False]
    assert logged in capsys.readouterr().err


def test_an_accepted_goal_may_be_kept_and_begun_later(graph):
    """The queue of one: as upstream's example, which works on one goal after the other."""
    order, waiting = [], []

    def keep(handle):
        waiting.append(handle)
        if len(waiting) == 2:
            for each in reversed(waiting):
                each.execute()

    def execute(handle):
        order.append(handle.request.order)
        handle.succeed()
        return Fibonacci.Result()

    def script(node, action_client, wait):
        handles = [wait(action_client.send_goal_async(Fibonacci.Goal(order=n))) for n in (1, 2)]
        for handle in handles:
            wait(handle.get_result_async())

    run(graph, script, execute=execute, handle_accepted_callback=keep)
    assert order == [2, 1]


def test_invalid_goal_transitions_raise_with_rcl_s_text(graph):
    errors = []

    def execute(handle):
        for call in (handle.canceled, handle.execute):
            try:
                call()
            except RCLError as error:
                errors.append(str(error))
        with pytest.raises(TypeError):
            handle.publish_feedback(Fibonacci.Result())
        handle.succeed()
        return Fibonacci.Result()

    run(graph, lambda node, c, wait: wait(c.send_goal_async(Fibonacci.Goal())), execute=execute)
    text = "Failed to update goal state: goal_handle attempted invalid transition from state EXECUTING with event "
    assert errors == [f"{text}CANCELED", f"{text}EXECUTE"]
    for status in (GoalStatus.STATUS_SUCCEEDED, GoalStatus.STATUS_CANCELED, GoalStatus.STATUS_ABORTED):
        for event in GoalEvent:
            with pytest.raises(RCLError):
                next_status(status, event)


def test_a_result_is_kept_for_a_while_and_then_forgotten(graph):
    answers = []

    def script(node, action_client, wait):
        handle = wait(action_client.send_goal_async(Fibonacci.Goal(order=2)))
        for pause_s in (0.0, 3.0, 10.0):
            node.get_clock().sleep_for(Duration(seconds=pause_s))
            answers.append(wait(handle.get_result_async()).status)

    run(graph, script, result_timeout=5)
    assert answers == [GoalStatus.STATUS_SUCCEEDED, GoalStatus.STATUS_SUCCEEDED, GoalStatus.STATUS_UNKNOWN]


def test_an_action_is_three_services_and_two_topics_under_hidden_names(graph):
    graph.start(server())
    graph.run(seconds=1)
    rclpy.init(args=[])
    node = Node("onlooker")
    services = {name: types for name, types in node.get_service_names_and_types() if "_action" in name}
    topics = {name: types for name, types in node.get_topic_names_and_types() if "_action" in name}
    rclpy.shutdown()
    assert services == {
        "/fibonacci/_action/send_goal": ["example_interfaces/action/Fibonacci_SendGoal"],
        "/fibonacci/_action/get_result": ["example_interfaces/action/Fibonacci_GetResult"],
        "/fibonacci/_action/cancel_goal": ["action_msgs/srv/CancelGoal"],
    }
    assert topics == {
        "/fibonacci/_action/feedback": ["example_interfaces/action/Fibonacci_FeedbackMessage"],
        "/fibonacci/_action/status": ["action_msgs/msg/GoalStatusArray"],
    }


def test_a_message_or_a_service_is_no_action():
    rclpy.init(args=[])
    node = Node("server")
    for wrong in (AddTwoInts, GoalStatus, "example_interfaces/action/Fibonacci"):
        with pytest.raises(NoTypeSupportImportedException, match="Expected an action type"):
            ActionServer(node, wrong, "fibonacci", print)
        with pytest.raises(NoTypeSupportImportedException, match="Expected an action type"):
            ActionClient(node, wrong, "fibonacci")
    with pytest.raises(TypeError, match="Failed to register goal execution callback: not callable"):
        ActionServer(node, Fibonacci, "fibonacci", None)
    rclpy.shutdown()
