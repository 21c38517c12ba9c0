"""List the differences between ROS 2 releases that a learner meets.

    TFLAB_ROS_DISTRO=humble | jazzy | lyrical        (jazzy if unset; rolling is the newest)

The rest of the surface is that of geometry2 0.39.1 and rclpy 8.0, whatever the release.
"""

from __future__ import annotations

import os
from types import SimpleNamespace

__all__ = ["DEFAULT", "Distro", "checks_fields", "current", "has_name", "require"]

VARIABLE = "TFLAB_ROS_DISTRO"
DEFAULT = "jazzy"
RELEASES = ("humble", "jazzy", "lyrical")  # those with long-term support, oldest first

# What differs: its value on Humble, Jazzy and Lyrical, and where that is known from ("branches": upstream's sources).
_ROWS = {
    # StaticTransformBroadcaster (Python), called again, publishes the last call only; all, with the first value of each
    # child; or all, with the newest value of each child.
    "static_resend": ("forgets", "keeps", "replaces"),  # ros2/geometry2#631, #634, #820 (0.45.0)
    "wait_for_transform_gives_it": (False, True, True),  # not True: ros2/geometry2#664 (0.36.2)
    "buffer_clears_at_jump_back": (False, True, True),  # the Python one: ros2/geometry2#608
    "listener_takes_topics": (False, False, True),  # and view_frames: ros2/geometry2#709 (0.39.1)
    "names_quaternion_order": (False, False, True),  # tf2_echo's "in Quaternion (xyzw)": ros2/geometry2#718 (0.39.2)
    "compares_any_type": (False, True, True),  # Time == 5 is False, not a TypeError: ros2/rclpy#1007
    "init_is_context": (False, False, True),  # `with rclpy.init():`, `with Node(...)`: ros2/rclpy#1298 (7.2)
    "shutdown_destroys_nodes": (False, False, True),  # by their destroy_node(): ros2/rclpy#1298 (7.2)
    "context_is_context": (False, True, True),  # `with Context():` begins it: branches, rclpy/context.py
    "context_entry_warns": (False, False, True),  # init() is to be called before: branches, rclpy/context.py
    "errors_join_names": (False, True, True),  # of parameters, to one text: ros2/rclpy#1241
    "actions_have_loggers": (False, True, True),  # "node.action_server": branches, rclpy/action/server.py
    "call_raises_timeout": (False, False, True),  # Client.call(), not None: ros2/rclpy#1271
    "timer_takes_autostart": (False, True, True),  # branches, rclpy/node.py
    "timer_passes_info": (False, False, True),  # TimerInfo: branches, rclpy/timer.py
    "spin_keeps_node": (False, False, True),  # in a callback, with the executor that runs it: ros2/rclpy#1446
    "node_waits_and_counts": (False, True, True),  # wait_for_node, count_clients, …: branches, rclpy/node.py
    "node_has_set_callbacks": (False, True, True),  # before and after set_parameters: branches, rclpy/node.py
    "always_checks_fields": (True, False, False),  # of messages: branches, rosidl_generator_py
    "policy_suffix": ("_QOS_POLICY", "", ""),  # in the warning about incompatible QoS: branches, rclpy/qos.py
    "has_type_hash": (False, True, True),  # `ros2 topic info --verbose`: branches, rclpy/topic_endpoint_info.py
    "has_type_description": (False, True, True),  # service of every node: branches, rclpy/type_description_service.py
    "default_bag_storage": ("sqlite3", "mcap", "mcap"),  # branches, rosbag2_storage
    "record_takes_names": (True, True, False),  # `ros2 bag record /tf`: ros2/rosbag2#2328, #2418
    "record_takes_topics": (False, True, True),  # `ros2 bag record --topics /tf`: ros2/rosbag2#1632
    "play_takes_storage": (True, True, False),  # `ros2 bag play BAG -s mcap`: ros2/rosbag2#2328
    "play_takes_input": (False, True, True),  # `ros2 bag play -i BAG mcap`: ros2/rosbag2#1848 (0.26.6)
    "reads_urdf_file": (True, True, False),  # robot_state_publisher robot.urdf: ros/robot_state_publisher#233
    "turtlesim_messages": ("turtlesim", "turtlesim", "turtlesim_msgs"),  # their package: ros/ros_tutorials#169
    "urdf_minor": (0, 0, 2),  # URDF 1.0 to 1.urdf_minor: ros/urdfdom#235, #238 (5.1 reads 1.1), #212 (6.0 reads 1.2)
}


class Distro(SimpleNamespace):
    """A release: its name, and its column of the table."""


_TABLE = {
    name: Distro(name=name, **{row: values[column] for row, values in _ROWS.items()})
    for column, name in enumerate(RELEASES)
}

# Modules, and names in modules, that only these releases have.
_NEW_IN_JAZZY = "clock_type event_handler parameter_client parameter_event_handler service_introspection"
_NAMES = {
    **{f"rclpy.{module}": ("jazzy", "lyrical") for module in _NEW_IN_JAZZY.split()},  # branches
    "rclpy.qos_event": ("humble", "jazzy"),  # ros2/rclpy#1058, #1456
    "rclpy.timer.TimerInfo": ("lyrical",),  # branches, rclpy/timer.py
    "tf2_ros.DEFAULT_STATIC_TF_TOPIC": ("lyrical",),  # ros2/geometry2#709 (0.39.1)
    "tf2_ros.DEFAULT_TF_TOPIC": ("lyrical",),
    "tf2_ros.StaticTransformListener": ("lyrical",),  # ros2/geometry2#719 (0.39.2)
    "tf2_ros.static_transform_listener": ("lyrical",),
    "tf2_ros.transform_listener.DEFAULT_STATIC_TF_TOPIC": ("lyrical",),
    "tf2_ros.transform_listener.DEFAULT_TF_TOPIC": ("lyrical",),
}


def current() -> Distro:
    """Return the release that TFLAB_ROS_DISTRO names.

    Raises:
        ValueError: the variable names another one.
    """
    name = os.environ.get(VARIABLE) or DEFAULT
    if name not in (*RELEASES, "rolling"):
        raise ValueError(f"{VARIABLE}={name!r} is not known: it is one of {', '.join(RELEASES)}, rolling.")
    return _TABLE[RELEASES[-1] if name == "rolling" else name]


def checks_fields() -> bool:
    """Return whether messages check the types of their fields in this release and environment."""
    return current().always_checks_fields or os.environ.get("ROS_PYTHON_CHECK_FIELDS") == "1"


def has_name(name: str) -> bool:
    """Return whether this release has a module, or a name in one: "tf2_ros.StaticTransformListener"."""
    return current().name in _NAMES.get(name, RELEASES)


def require(row: str, error: type[Exception], text: str) -> None:
    """Raise an error as Python does on a robot, if a row of the table is false in this release."""
    if not getattr(current(), row):
        others = " and ".join(name for name in RELEASES if getattr(_TABLE[name], row))
        raise error(f"{text} (ROS 2 {current().name}; it is in {others})")
