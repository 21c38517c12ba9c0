"""`ros2 node` and `ros2 param`: what they print, to the letter."""

from pathlib import Path

import pytest
import yaml

from tflab.ros import client_library as rclpy
from tflab.ros.action_client import ActionClient
from tflab.ros.action_server import ActionServer
from tflab.ros.messages import type_named
from tflab.ros.node import Node
from tflab.tools.node import duplicates_warning
from tflab.tools.param import python_value

from .robot import moving, spin

CASES = yaml.safe_load(Path(__file__).with_suffix(".yaml").read_text(encoding="utf-8"))

Fibonacci = type_named("example_interfaces/action/Fibonacci")


def node_with(**values):
    def main():
        rclpy.init()
        node = Node("node", namespace="/robot")
        for name, value in values.items():
            node.declare_parameter(name, value)
        spin(node)

    return main


def test_node_info(terminal):
    terminal.graph.start(moving(name="driver"))
    assert terminal.type("ros2 node info /driver") == CASES["node_info"]


def test_hidden_nodes_are_listed_only_on_request(terminal):
    assert terminal.type("ros2 node list") == ""
    assert terminal.type("ros2 node list -a").startswith("/_ros2cli_")
    assert terminal.type("ros2 node list -c") == "0\n"


def test_two_nodes_of_one_name_are_warned_of(terminal):
    for _ in range(2):
        terminal.graph.start(moving(name="talker"))
    assert terminal.type("ros2 node list") == "/talker\n/talker\n"
    assert terminal.error == (
        "WARNING: Be aware that there are nodes in the graph that share an exact name, "
        "which can have unintended side effects.\n"
    )
    assert duplicates_warning(["/a", "/b"]) == ""


@pytest.mark.parametrize(("value", "text"), CASES["values"])
def test_get_names_the_type(terminal, value, text):
    terminal.graph.start(node_with(x=value))
    assert terminal.type("ros2 param get /robot/node x") == f"{text}\n"
    assert terminal.type("ros2 param get robot/node x --hide-type") == text.partition(": ")[2] + "\n"


def test_what_is_not_declared_or_of_another_type_is_refused(terminal):
    terminal.graph.start(node_with(x=0.5))
    for line, error in CASES["refused"]:
        terminal.type(f"ros2 param {line}")
        assert terminal.error == f"{error}\n"
        assert terminal.exit_code == (0 if line.startswith("set") else 1)  # as ros2 has it


def test_list_of_one_node_and_of_all(terminal):
    terminal.graph.start(node_with(b=1, a=2))
    assert terminal.type("ros2 param list /robot/node") == "  a\n  b\n  use_sim_time\n"
    assert terminal.type("ros2 param list") == "/robot/node:\n  a\n  b\n  use_sim_time\n"
    assert terminal.type("ros2 param set /robot/node use_sim_time True") == "Set parameter successful\n"


@pytest.mark.parametrize(
    ("text", "value"),
    [("1", 1), ("1.0", 1.0), ("'1.0'", "1.0"), ("no", False), ("[1, 2]", [1, 2]), ("[1, a]", "[1, a]"), ("", ""),
     ("{a: 1}", "{a: 1}"), ("[", "["), ("2024-01-01", "2024-01-01"), ("[]", "[]")],
)  # fmt: skip
def test_a_value_is_what_yaml_makes_of_it(text, value):
    found = python_value(text)
    assert (found, type(found)) == (value, type(value))


def test_a_node_that_does_not_spin_does_not_answer_and_the_line_still_ends(terminal):
    def main():
        rclpy.init()
        Node("busy").create_timer(1e6, lambda: None)
        terminal.graph.participants[0].sleep(10**15)

    terminal.graph.start(main)
    out = terminal.type("ros2 param get /busy use_sim_time")
    assert out.startswith("`ros2 param get /busy use_sim_time` did not end within 60 s of the graph's time")


def test_node_info_names_the_actions_and_hides_what_they_are_made_of(terminal):
    def main():
        rclpy.init()
        node = Node("fibonacci_server")
        ActionServer(node, Fibonacci, "fibonacci", print)
        ActionClient(node, Fibonacci, "dock/fibonacci")
        spin(node)

    terminal.graph.start(main)
    printed = terminal.type("ros2 node info /fibonacci_server")
    assert printed.endswith(CASES["actions_of_a_node"])
    assert "_action" not in printed
    assert "/fibonacci/_action/status" in terminal.type("ros2 node info /fibonacci_server --include-hidden")
