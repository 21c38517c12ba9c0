"""Each release has the API and the behaviour of its own robots: the rows of distro.py."""

from __future__ import annotations

import importlib
import warnings
from contextlib import ExitStack, redirect_stderr
from io import StringIO

import pytest

from tflab.ros import client_library as rclpy
from tflab.ros.action_server import ActionServer
from tflab.ros.context import Context
from tflab.ros.exceptions import InvalidHandle, InvalidParameterValueException
from tflab.ros.messages import type_named
from tflab.ros.messages.geometry_msgs import TransformStamped
from tflab.ros.messages.packages import definitions
from tflab.ros.messages.tf2_msgs import TFMessage
from tflab.ros.node import Node
from tflab.ros.parameter import Parameter
from tflab.ros.qos import DurabilityPolicy, QoSProfile
from tflab.ros.tf2.buffer import Buffer
from tflab.ros.tf2.topics import StaticTransformBroadcaster, TransformListener
from tflab.ros.time import Duration, Time
from tflab.ros.timer import TimerInfo
from tflab.tools.ros2 import main

LOOKUP, FRAMES = type_named("tf2_msgs/action/LookupTransform"), type_named("tf2_msgs/srv/FrameGraph")
NO_CONTEXT = "does not support the context manager protocol"
UNDECLARED, UNSET = "Invalid access to undeclared parameter(s)", "The parameter 'b' is not initialized"
WRONG_TYPE = "Trying to set parameter 'a' to '1.5' of type 'DOUBLE', expecting type 'INTEGER'"
REFUSED = "Invalid parameter value (9) for parameter. Reason: no"
NO_INIT, MESSAGE = "rclpy.init() has not been called", "cannot create node"
UNEXPECTED, UNKNOWN = "got an unexpected keyword argument", "unrecognized arguments"


def call(function):
    """Return the result of a call, or the text of its error or warning."""
    with warnings.catch_warnings(record=True) as warned:
        warnings.simplefilter("always")
        try:
            result = function()
        except Exception as error:
            return str(error)
    return str(warned[0].message) if warned else result


def enter(thing):
    return type(ExitStack().enter_context(thing) if thing is not None else thing).__name__


def moved(child, x):
    transform = TransformStamped(child_frame_id=child)
    transform.header.frame_id, transform.transform.translation.x, transform.transform.rotation.w = "map", x, 1.0
    return transform


def wait():
    buffer = Buffer()
    buffer.set_transform_static(moved("base", 1.0), "test")
    return type(buffer.wait_for_transform_async("map", "base", Time()).result()).__name__


def change(child, x):
    SENT.child_frame_id, SENT.transform.translation.x = child, x
    return SENT


SENT = moved("", 0.0)


def resend(make=moved):
    """Return what a late listener receives of a static broadcaster that sent three times."""
    node, got = Node("late"), []
    broadcaster = StaticTransformBroadcaster(node)
    for child, x in (("lidar", 1.0), ("lidar", 2.0), ("camera", 3.0)):
        broadcaster.sendTransform(make(child, x))
    qos = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    node.create_subscription(TFMessage, "/tf_static", got.append, qos)
    rclpy.spin_once(node, timeout_sec=0.1)
    return [each.transform.translation.x for each in got[0].transforms]


def end(how="shutdown"):
    class Careful(Node):
        def destroy_node(self):
            called.append("destroy_node")
            super().destroy_node()

    called, node = [], Careful("careful")
    node.context.on_shutdown(lambda: called.append("on_shutdown"))
    getattr(node.context, how)()
    return called


def timer_info():
    def on_timer(info: TimerInfo):
        raise RuntimeError(f"{info.expected_call_time.nanoseconds} {info.actual_call_time.nanoseconds}")

    node = Node("timed")
    node.create_timer(0.5, on_timer)
    rclpy.spin_once(node, timeout_sec=1.0)


def nest_spin():
    node, executor = Node("nested"), rclpy.get_global_executor()
    executor.add_node(node)  # as in a callback, where the executor that runs it has the node
    executor.spin = lambda: None
    rclpy.spin(node)
    return node in executor.get_nodes()


def fail(function):
    """Return the arguments of the error of a call, or its result."""
    try:
        return function()
    except Exception as error:
        return error.args


def override(value):
    node = Node("n", parameter_overrides=[Parameter("a", value=value)])
    node.declare_parameter("b", Parameter.Type.INTEGER)
    return node


def has(name, attribute="__name__"):
    return hasattr(importlib.import_module(name), attribute)


def run(line):
    """Return what a command line prints before it is refused, or "begins"."""
    with redirect_stderr(StringIO()) as printed:
        main([*line.split(), "--nothing"])
    return "begins" if printed.getvalue().endswith(f"{UNKNOWN}: --nothing\n") else printed.getvalue()


ROWS = [  # a call, and what comes of it on Humble, Jazzy and Lyrical: the result, or a part of the error or warning
    (lambda: Time(nanoseconds=5) == 5, "Can't compare time", False, False),
    (lambda: Duration(nanoseconds=5) != 5, "Can't compare duration", True, True),
    (wait, "bool", "TransformStamped", "TransformStamped"),
    (resend, [3.0], [1.0, 3.0], [2.0, 3.0]),
    (lambda: resend(change), [3.0], [3.0, 3.0], [3.0, 3.0]),
    (lambda: enter(rclpy.init(context=Context(), args=[])), "NoneType", "NoneType", "InitContextManager"),
    (lambda: enter(Node("with")), NO_CONTEXT, NO_CONTEXT, "Node"),
    (lambda: enter(Context()), NO_CONTEXT, "Context", "this usage is deprecated"),
    (end, ["on_shutdown"], ["on_shutdown"], ["destroy_node", "on_shutdown"]),
    (lambda: end("signalled"), [], [], []),  # Ctrl-C
    (lambda: Node("n").create_timer(1.0, None, autostart=False).is_canceled(), UNEXPECTED, True, True),
    (timer_info, "1 required positional argument", "1 required positional argument", "1500000000 1500000000"),
    (lambda: TransformListener(Buffer(), Node("n"), tf_topic="/t").tf_sub.topic_name, UNEXPECTED, UNEXPECTED, "/t"),
    (lambda: hasattr(Buffer(node=Node("n")), "_jump_handle"), False, True, True),
    (lambda: Node("n").wait_for_node("n", 0.0), "'Node' object has no attribute 'wait_for_node'", True, True),
    (lambda: Node("n").add_post_set_parameters_callback(print), "has no attribute", None, None),
    (lambda: fail(lambda: Node("n").get_parameter("a")), (UNDECLARED, "a"), *[(f"{UNDECLARED}: a",)] * 2),
    (lambda: fail(lambda: override(1.5).declare_parameter("a", 1)), (WRONG_TYPE,), *[(f"{WRONG_TYPE}: a",)] * 2),
    (lambda: fail(lambda: override(1.5).get_parameter("b")), (UNSET,), *[(f"{UNSET}: b",)] * 2),
    (lambda: InvalidParameterValueException("a", 9, "no").args, (REFUSED, "a"), *[(f"{REFUSED}: a",)] * 2),
    (lambda: fail(lambda: Node("n", context=Context())), (NO_INIT, MESSAGE), *[(f"{NO_INIT}. msg:{MESSAGE}",)] * 2),
    (lambda: ActionServer(Node("n"), LOOKUP, "a", print)._logger.name, "n", ".action_server", ".action_server"),
    (lambda: [each.__name__ for each in InvalidHandle.__bases__], *[["RuntimeError"]] * 3),
    (lambda: fail(lambda: Node("n").create_client(FRAMES, "s").call(FRAMES.Request(), 0.1)), None, None, ()),
    (nest_spin, False, False, True),
    (lambda: has("rclpy.event_handler"), "No module named 'rclpy.event_handler'", True, True),
    (lambda: has("rclpy.qos_event"), True, "import 'event_handler' instead", "No module named"),
    (lambda: has("tf2_ros", "StaticTransformListener"), False, False, True),
    (lambda: has("tf2_ros.StaticTransformListener"), "cannot import name", "cannot import name", "No module"),
    (lambda: "turtlesim_msgs" in definitions.__wrapped__(), False, False, True),
    (lambda: "turtlesim" in definitions.__wrapped__(), True, True, False),
    (lambda: run("bag record /tf /scan"), "begins", "begins", f"{UNKNOWN}: /tf /scan --nothing"),
    (lambda: run("bag record --topics /tf"), f"{UNKNOWN}: --topics", "begins", "begins"),
    (lambda: run("bag record /tf --topics /scan"), UNKNOWN, "not allowed with argument", UNKNOWN),
    (lambda: run("bag play lap -s mcap"), "begins", "begins", f"{UNKNOWN}: -s mcap"),
    (lambda: run("bag play -i lap mcap"), f"{UNKNOWN}: -i", "begins", "begins"),
    (lambda: run("bag play lap -i lap"), f"{UNKNOWN}: -i", "not allowed with", "not allowed with"),
    (lambda: run("run tf2_tools view_frames --tf_topic /t"), "--tf_topic", "--tf_topic", "begins"),
]


@pytest.mark.parametrize(("release", "column"), [("humble", 1), ("jazzy", 2), ("lyrical", 3), ("rolling", 3)])
@pytest.mark.parametrize("row", ROWS)
def test_a_call_has_the_result_or_the_error_of_the_release(activated, monkeypatch, row, release, column):
    monkeypatch.setenv("TFLAB_ROS_DISTRO", release)
    rclpy.init()
    result, expected = call(row[0]), row[column]
    assert expected in result if isinstance(expected, str) else result == expected
