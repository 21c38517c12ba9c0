"""What does a robot say right now?  Some seconds of it, heard through rclpy.

    tflab doctor --live 10      on a machine with ROS 2, in a sourced terminal

The listener is an ordinary node.  Where nobody but one publishes a topic, its
transforms have an owner with a name; where there are several, some versions of
rclpy say who sent a message, and otherwise the values must tell.  Images and clouds
stay bytes: only their headers are read.
"""

from __future__ import annotations

import importlib

from tflab.bags.listen import Heard, subscribe_to_all
from tflab.bags.recording import Recording

__all__ = ["NoRos", "recording_from_ros"]

NODE_NAME = "tflab_doctor"
DISCOVERY_S = 1.0
TURN_S = 0.1


class NoRos(RuntimeError):
    """There is no ROS 2 to listen to; the text is one line that says what to do."""


def recording_from_ros(seconds: float) -> Recording:
    """Listen for `seconds`, and return every transform and every header that was heard.

    Raises:
        NoRos: rclpy cannot be imported.
    """
    try:
        rclpy = importlib.import_module("rclpy")
    except ImportError as error:
        raise NoRos(
            f"--live needs rclpy ({error}): source /opt/ros/<distro>/setup.bash, or record a bag "
            f"(ros2 bag record -a -d {seconds:.0f}) and name it"
        ) from None
    rclpy.init()
    try:
        node = rclpy.create_node(NODE_NAME)
        heard = Heard()
        _spin(rclpy, node, DISCOVERY_S)
        subscribe_to_all(node, heard, _message_class, raw_headers=True)
        _spin(rclpy, node, seconds)
        node.destroy_node()
    finally:
        rclpy.try_shutdown()
    return heard.recording("live")


def _spin(rclpy, node, seconds: float) -> None:
    clock = importlib.import_module("rclpy.clock")
    steady = clock.Clock(clock_type=clock.ClockType.STEADY_TIME)
    end_ns = steady.now().nanoseconds + round(seconds * 1e9)
    while rclpy.ok() and steady.now().nanoseconds < end_ns:
        rclpy.spin_once(node, timeout_sec=TURN_S)


def _message_class(ros_type: str) -> type | None:
    """Return the class of a type such as sensor_msgs/msg/LaserScan, None if it is not installed here."""
    package, _, name = ros_type.partition("/msg/")
    try:
        return getattr(importlib.import_module(f"{package}.msg"), name, None)
    except ImportError:
        return None
