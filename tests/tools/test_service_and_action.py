"""`ros2 service` and `ros2 action`: what they print, to the letter."""

from pathlib import Path

import pytest
import yaml

from tflab.ros import client_library as rclpy
from tflab.ros.action_client import ActionClient
from tflab.ros.action_server import ActionServer, GoalResponse
from tflab.ros.messages import type_named
from tflab.ros.node import Node
from tflab.ros.time import Duration

from .robot import spin

CASES = yaml.safe_load(Path(__file__).with_suffix(".yaml").read_text(encoding="utf-8"))

AddTwoInts = type_named("example_interfaces/srv/AddTwoInts")
Fibonacci = type_named("example_interfaces/action/Fibonacci")


@pytest.fixture
def calculator(terminal):
    def add(request, response):
        response.sum = request.a + request.b
        return response

    def main():
        rclpy.init()
        node = Node("calculator")
        node.create_service(AddTwoInts, "add_two_ints", add)
        spin(node)

    terminal.graph.start(main)
    return terminal


def test_a_service_is_called_and_its_answer_printed(calculator):
    line = 'ros2 service call /add_two_ints example_interfaces/srv/AddTwoInts "{a: 2, b: 3}"'
    assert calculator.type(line) == CASES["answer"]


def test_services_are_listed_with_their_types(calculator):
    assert "/add_two_ints\n" in calculator.type("ros2 service list")
    assert "/add_two_ints [example_interfaces/srv/AddTwoInts]\n" in calculator.type("ros2 service list -t")
    assert calculator.type("ros2 service type /add_two_ints") == "example_interfaces/srv/AddTwoInts\n"
    assert int(calculator.type("ros2 service list -c")) == len(calculator.type("ros2 service list").splitlines())
    assert (calculator.type("ros2 service type /nonsense"), calculator.exit_code) == ("", 1)


@pytest.mark.parametrize(("words", "text"), CASES["faulty_calls"])
def test_what_is_wrong_with_a_call_is_said(calculator, words, text):
    assert calculator.type(f"ros2 service call {words}") == ""
    assert calculator.error.startswith(text)
    assert calculator.exit_code == 1


@pytest.fixture
def fibonacci(terminal):
    def execute(handle):
        feedback = Fibonacci.Feedback(sequence=[0, 1])
        while len(feedback.sequence) <= handle.request.order:
            feedback.sequence.append(feedback.sequence[-1] + feedback.sequence[-2])
            handle.publish_feedback(feedback)
            nodes[0].get_clock().sleep_for(Duration(seconds=0.5))
        handle.succeed()
        return Fibonacci.Result(sequence=feedback.sequence)

    def accept(goal):
        return GoalResponse.ACCEPT if goal.order >= 0 else GoalResponse.REJECT

    nodes = []

    def main():
        rclpy.init()
        nodes.append(Node("fibonacci_server"))
        ActionServer(nodes[0], Fibonacci, "fibonacci", execute, goal_callback=accept)
        spin(nodes[0])

    def asker():
        rclpy.init()
        node = Node("asker")
        ActionClient(node, Fibonacci, "fibonacci")
        spin(node)

    terminal.graph.start(main)
    terminal.graph.start(asker)
    return terminal


def test_actions_are_listed_and_who_serves_them_is_said(fibonacci):
    assert fibonacci.type("ros2 action list") == "/fibonacci\n"
    assert fibonacci.type("ros2 action list -t") == "/fibonacci [example_interfaces/action/Fibonacci]\n"
    assert fibonacci.type("ros2 action list -c") == "1\n"
    assert fibonacci.type("ros2 action info /fibonacci -t") == CASES["action_info"]
    assert fibonacci.type("ros2 action info /fibonacci -c").endswith("Action clients: 1\nAction servers: 1\n")


def test_a_goal_is_sent_and_how_it_goes_and_ends_is_printed(fibonacci):
    line = 'ros2 action send_goal /fibonacci example_interfaces/action/Fibonacci "{order: 2}" --feedback'
    printed = fibonacci.type(line)
    before, _, rest = printed.partition("Goal accepted with ID: ")
    goal_id, _, after = rest.partition("\n")
    assert before == "Waiting for an action server to become available...\nSending goal:\n     order: 2\n\n"
    assert len(bytes.fromhex(goal_id)) == 16
    assert after == CASES["goal"]
    printed = fibonacci.type('ros2 action send_goal /fibonacci example_interfaces/action/Fibonacci "{order: -1}"')
    assert printed.endswith("Goal was rejected.\n")


@pytest.mark.parametrize(("words", "text"), CASES["faulty_goals"])
def test_what_is_wrong_with_a_goal_is_said(fibonacci, words, text):
    assert fibonacci.type(f"ros2 action send_goal /fibonacci {words}") == ""
    assert fibonacci.error.startswith(text)
    assert fibonacci.exit_code == 1
