"""`ros2 interface` and `ros2 lifecycle`: what they print, to the letter."""

from pathlib import Path

import pytest
import yaml

from tflab.ros import client_library as rclpy
from tflab.ros.lifecycle import LifecycleNode, TransitionCallbackReturn
from tflab.ros.messages.packages import define

from .robot import spin

CASES = yaml.safe_load(Path(__file__).with_suffix(".yaml").read_text(encoding="utf-8"))

STAMPED = CASES["stamped"]


def test_a_message_is_shown_with_what_is_in_it(terminal):
    assert terminal.type("ros2 interface show geometry_msgs/msg/TransformStamped") == STAMPED
    assert terminal.type("ros2 interface show geometry_msgs/TransformStamped --no-comments") == STAMPED
    shown = terminal.type("ros2 interface show tf2_msgs/msg/TFMessage").splitlines()
    assert shown[:2] == ["geometry_msgs/TransformStamped[] transforms", "\tstd_msgs/Header header"]
    assert len(shown) == 1 + len(STAMPED.splitlines())  # a list is opened once


def test_services_and_actions_have_lines_between_their_parts(terminal):
    assert (
        terminal.type("ros2 interface show example_interfaces/srv/AddTwoInts") == "int64 a\nint64 b\n---\nint64 sum\n"
    )
    fibonacci = "int32 order\n---\nint32[] sequence\n---\nint32[] sequence\n"
    assert terminal.type("ros2 interface show example_interfaces/action/Fibonacci") == fibonacci


def test_comments_of_ones_own_are_shown_outside_everywhere_or_nowhere(terminal):
    define("shown_msgs", {"In.msg": "int32 a  # inside", "Out.msg": "# what it is\n\nIn found  # and this"})
    show = "ros2 interface show shown_msgs/msg/Out"
    assert terminal.type(show) == "# what it is\n\nIn found  # and this\n\tint32 a\n"
    assert terminal.type(show + " --all-comments") == "# what it is\n\nIn found  # and this\n\tint32 a  # inside\n"
    assert terminal.type(show + " --no-comments") == "In found\n\tint32 a\n"


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("geometry_msgs", "Invalid name 'geometry_msgs'. Expected three parts separated by '/'"),
        ("nope_msgs/msg/Point", "Unknown package 'nope_msgs'"),
        ("tf2_msgs/msg/TFMessages", "Could not find the interface 'tf2_msgs/msg/TFMessages'"),
    ],
)
def test_what_is_not_there_is_said(terminal, name, said):
    for verb in ("show", "proto"):
        assert terminal.type(f"ros2 interface {verb} {name}") == ""
        assert terminal.exit_code == 1
        assert said in terminal.error


def test_a_prototype_is_what_one_types_to_publish(terminal):
    vector = "x: 0.0\ny: 0.0\nz: 0.0\n"
    assert terminal.type("ros2 interface proto geometry_msgs/msg/Vector3") == f'"{vector}"\n'
    assert terminal.type("ros2 interface proto geometry_msgs/msg/Vector3 --no-quotes") == f"{vector}\n"


def test_types_and_packages_are_listed_by_kind(terminal):
    listed = terminal.type("ros2 interface list").splitlines()
    assert listed[0] == "Messages:" and "    geometry_msgs/msg/TransformStamped" in listed
    assert listed.index("Services:") < listed.index("    tf2_msgs/srv/FrameGraph") < listed.index("Actions:")
    only = terminal.type("ros2 interface list -a").splitlines()
    assert only[0] == "Actions:" and {line.split("/")[1] for line in only[1:]} == {"action"}
    assert {"    example_interfaces/action/Fibonacci", "    tf2_msgs/action/LookupTransform"} <= set(only)
    packages = terminal.type("ros2 interface packages -a").split()
    assert {"example_interfaces", "tf2_msgs"} <= set(packages) and "geometry_msgs" not in packages
    assert "tf2_msgs/msg/TFMessage\n" in terminal.type("ros2 interface package tf2_msgs")


@pytest.fixture
def camera(terminal):
    class Camera(LifecycleNode):
        def on_activate(self, state):
            return TransitionCallbackReturn.FAILURE

    def main():
        rclpy.init()
        spin(Camera("camera"))

    terminal.graph.start(main)
    return terminal


def test_managed_nodes_are_found_and_moved_by_label_or_number(camera):
    assert camera.type("ros2 lifecycle nodes") == "/camera\n"
    assert camera.type("ros2 lifecycle nodes -c") == "1\n"
    assert camera.type("ros2 lifecycle get") == "/camera: unconfigured [1]\n"
    assert camera.type("ros2 lifecycle set /camera configure") == "Transitioning successful\n"
    assert camera.type("ros2 lifecycle get camera") == "inactive [2]\n"
    assert camera.type("ros2 lifecycle set /camera 2") == "Transitioning successful\n"
    assert camera.type("ros2 lifecycle get /camera") == "unconfigured [1]\n"
    for verb in ("get /nobody", "list /nobody", "set /nobody configure"):
        assert camera.type(f"ros2 lifecycle {verb}") == ""
        assert camera.error.strip() == "Node not found" and camera.exit_code == 1


def test_a_transition_that_fails_or_is_not_there_is_said(camera):
    assert camera.type("ros2 lifecycle set /camera activate") == ""
    assert "Unknown transition requested, available ones are:\n- configure [1]\n- shutdown [5]" in camera.error
    camera.type("ros2 lifecycle set /camera configure")
    camera.type("ros2 lifecycle set /camera activate")
    assert camera.error.strip() == "Transitioning failed"


def test_what_can_be_done_now_is_listed_with_where_it_leads(camera):
    assert camera.type("ros2 lifecycle list /camera") == (
        "- configure [1]\n\tStart: unconfigured\n\tGoal: configuring\n"
        "- shutdown [5]\n\tStart: unconfigured\n\tGoal: shuttingdown\n"
    )
    assert camera.type("ros2 lifecycle list /camera -a").count("Start:") > 10
