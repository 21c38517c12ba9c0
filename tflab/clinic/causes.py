"""List the eighteen causes, faults of a robot: each changes one thing in how the robot is launched.

    HEALTHY --no_localizer--> the same launch without a node
            --late_network--> the same nodes, and a network that takes its time
            --no_localizer--late_network--> two at once, for the night shift

A Launch is a value: which nodes, with which arguments, clocks and network.  A cause
is a function from one Launch to another, so causes compose.  In the field this is
*fault injection*, here at the level of nodes and not of messages.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from types import MappingProxyType
from typing import Any

import numpy as np

from tflab.core import StampedTransform, Transform
from tflab.robots.nodes import NODES, Driver, LaserDriver, OdometryDriver
from tflab.robots.reading_messages import laser_scan_msg
from tflab.robots.teaching import SOURCES, TeachingRobot
from tflab.ros.convert import msg_from_stamped
from tflab.ros.messages import tf2_msgs
from tflab.ros.node import Node
from tflab.ros.qos import DurabilityPolicy, QoSProfile
from tflab.ros.tf2.topics import TransformBroadcaster

__all__ = ["CAUSES", "HEALTHY", "Launch", "Numbers", "draw_numbers"]

Maker = Callable[[TeachingRobot], Node]
MOUNT = (0.20, 0.0, 0.15)  # base_T_laser_frame as the drawing has it [m]
LONG_S = 0.06  # that a scan takes which is hard to match [s]


@dataclass(frozen=True)
class Numbers:
    """What varies between two patients with the same cause.

    Attributes:
        mount_m: the mount's error along x [m].
        clock_s: how far the laser's clock is ahead, or behind [s].
        delay_s, jitter_s: of the network [s].
        rate_hz: of a slow odometry [Hz].
        parent, frame, typed: names with a mistake in them: of odom, of laser_frame, of map.
        drift: how much too large a wheel is, where nothing is wrong but that.
        seed: of all that happens by chance on the robot.
    """

    mount_m: float = -0.20
    clock_s: float = 0.40
    delay_s: float = 0.25
    jitter_s: float = 0.20
    rate_hz: float = 2.0
    parent: str = "odm"
    frame: str = "laser"
    typed: str = "Map"
    drift: float = 0.03
    seed: int = 0


def draw_numbers(rng: np.random.Generator) -> Numbers:
    """Draw the numbers of a patient."""
    return Numbers(
        mount_m=round(float(rng.uniform(0.15, 0.40) * rng.choice([-1.0, 1.0])), 2),
        clock_s=round(float(rng.uniform(0.35, 0.60)), 2),
        delay_s=round(float(rng.uniform(0.25, 0.35)), 2),
        jitter_s=round(float(rng.uniform(0.15, 0.25)), 2),
        rate_hz=float(rng.choice([2.0, 2.2, 2.5])),
        parent=str(rng.choice(["odm", "Odom", "odom_frame", "odom1", "0dom"])),
        frame=str(rng.choice(["laser", "laser_link", "lidar", "scan_frame", "Laser_frame"])),
        typed=str(rng.choice(["Map", "MAP", "map1", "world_map", "maps"])),
        drift=round(float(rng.uniform(0.03, 0.05)), 3),
        seed=int(rng.integers(1, 1_000_000)),
    )


class MountSender(Node):
    """Says where the laser is bolted on; the drawing of this robot leaves that to it.

    Args:
        translation, rotation: what it says, rotation as (x, y, z, w).
        durability: with which it says so.
    """

    def __init__(
        self,
        translation: Sequence[float] = MOUNT,
        rotation: Sequence[float] = (0.0, 0.0, 0.0, 1.0),
        durability: DurabilityPolicy = DurabilityPolicy.TRANSIENT_LOCAL,
    ) -> None:
        super().__init__("laser_mount")
        edge = StampedTransform("base_link", "laser_frame", self.get_clock().now().nanoseconds, Transform(translation))
        message = msg_from_stamped(edge)
        turn = message.transform.rotation
        turn.x, turn.y, turn.z, turn.w = rotation
        qos = QoSProfile(depth=1, durability=durability)
        self._mounts = self.create_publisher(tf2_msgs.TFMessage, "/tf_static", qos)
        self._mounts.publish(tf2_msgs.TFMessage(transforms=[message]))


class MisnamedLaser(LaserDriver):
    """Measures as it should, and writes another frame into the header."""

    def __init__(self, robot: TeachingRobot, frame: str) -> None:
        super().__init__(robot)
        self._frame = frame

    def tell(self, true_ns: int, stamp_ns: int) -> None:
        scan = replace(self.robot.laser.scan_at(true_ns), stamp_ns=stamp_ns, frame_id=self._frame)
        self._scans.publish(laser_scan_msg(scan))


class BaseLocalizer(Driver):
    """Finds the robot on the map, and publishes just that: map -> base_footprint, which has a parent already.

    One scan in three takes it longer to match, and by then the wheels have said something newer: whoever looks each
    second, or twice, now finds its edge and now theirs.

    Parameters (of ROS): tf_broadcast, as the localizer that it replaces.
    """

    def __init__(self, robot: TeachingRobot) -> None:
        super().__init__(robot, robot.sources["localization"])
        self.declare_parameter("tf_broadcast", True)
        self._broadcaster = TransformBroadcaster(self)
        self._matched = 1  # its second scan is a hard one

    def tell(self, true_ns: int, stamp_ns: int) -> None:
        self._matched += 1
        if self._matched % 3:
            self._send(true_ns, stamp_ns)
            return

        def at_last() -> None:
            self.destroy_timer(timer)
            self._send(true_ns, stamp_ns)

        timer = self.create_timer(LONG_S, at_last)

    def _send(self, true_ns: int, stamp_ns: int) -> None:
        pose = self.robot.map_to_odom_at(true_ns).transform @ self.robot.odom_to_base_at(true_ns).transform
        base = StampedTransform("map", "base_footprint", stamp_ns, pose)
        self._broadcaster.sendTransform(msg_from_stamped(base))


@dataclass(frozen=True)
class Launch:
    """How a robot is started.

    Attributes:
        nodes: what runs, by name; each function makes the node of a robot.
        ros_args: of a node, as on its command line.
        clocks_s: how far a node's clock is ahead [s].
        delay_s, jitter_s: what the network adds to /tf and /odom [s].
        odometry_hz: how often the wheels speak [Hz].
        fixed_frame: what somebody typed into RViz.
        drift: how much too large a wheel is.
    """

    nodes: Mapping[str, Maker]
    ros_args: Mapping[str, Sequence[str]] = field(default_factory=dict)
    clocks_s: Mapping[str, float] = field(default_factory=dict)
    delay_s: float = 0.0
    jitter_s: float = 0.0
    odometry_hz: float = SOURCES["odometry"].rate_hz
    fixed_frame: str = "map"
    drift: float = 0.002

    def without(self, name: str) -> Launch:
        """Return the same without a node."""
        return replace(self, nodes={node: maker for node, maker in self.nodes.items() if node != name})

    def with_node(self, name: str, maker: Maker) -> Launch:
        """Return the same with a node more, or with another in its place."""
        return replace(self, nodes={**self.nodes, name: maker})

    def with_parameter(self, node: str, parameter: str, value: Any) -> Launch:
        """Return the same with a parameter set at the start of a node."""
        text = str(value).lower() if isinstance(value, bool) else str(value)
        args = [*self.ros_args.get(node, ["--ros-args"]), "-p", f"{parameter}:={text}"]
        return replace(self, ros_args={**self.ros_args, node: args})


HEALTHY = Launch(
    MappingProxyType(
        {
            **{name: NODES[name] for name in ("robot_state_publisher", "joint_driver", "wheel_odometry")},
            **{name: NODES[name] for name in ("localization", "laser_driver", "map_server")},
            "laser_mount": lambda robot: MountSender(),
        }
    )
)


def _no_localizer(launch: Launch, numbers: Numbers) -> Launch:
    return launch.without("localization")


def _localizer_on_sim_time(launch: Launch, numbers: Numbers) -> Launch:
    return launch.with_parameter("localization", "use_sim_time", True)


def _fixed_frame_misspelt(launch: Launch, numbers: Numbers) -> Launch:
    return replace(launch, fixed_frame=numbers.typed)


def _no_odometry(launch: Launch, numbers: Numbers) -> Launch:
    return launch.without("wheel_odometry")


def _parent_misspelt(launch: Launch, numbers: Numbers) -> Launch:
    def make(robot: TeachingRobot) -> Node:
        misnamed = lambda stamp_ns: replace(robot.odometry_at(stamp_ns), frame_id=numbers.parent)  # noqa: E731
        return OdometryDriver(robot, robot.sources["odometry"], "odom", misnamed)

    return launch.with_node("wheel_odometry", make)


def _publish_tf_off(launch: Launch, numbers: Numbers) -> Launch:
    return launch.with_parameter("wheel_odometry", "publish_tf", False)


def _two_owners(launch: Launch, numbers: Numbers) -> Launch:
    return launch.with_node("ekf_filter_node", NODES["ekf_filter_node"])


def _localizer_owns_base(launch: Launch, numbers: Numbers) -> Launch:
    return launch.with_node("localization", BaseLocalizer)


def _nothing(launch: Launch, numbers: Numbers) -> Launch:
    return replace(launch, drift=numbers.drift)


def _mount_wrong(launch: Launch, numbers: Numbers) -> Launch:
    wrong = (round(MOUNT[0] + numbers.mount_m, 3), *MOUNT[1:])
    return launch.with_node("laser_mount", lambda robot: MountSender(wrong))


def _header_base_link(launch: Launch, numbers: Numbers) -> Launch:
    return launch.with_node("laser_driver", lambda robot: MisnamedLaser(robot, "base_link"))


def _laser_clock_behind(launch: Launch, numbers: Numbers) -> Launch:
    return replace(launch, clocks_s={**launch.clocks_s, "laser_driver": -numbers.clock_s})


def _laser_clock_ahead(launch: Launch, numbers: Numbers) -> Launch:
    return replace(launch, clocks_s={**launch.clocks_s, "laser_driver": numbers.clock_s})


def _transforms_late(launch: Launch, numbers: Numbers) -> Launch:
    return replace(launch, delay_s=numbers.delay_s, jitter_s=numbers.jitter_s)


def _odometry_slow(launch: Launch, numbers: Numbers) -> Launch:
    return replace(launch, odometry_hz=numbers.rate_hz)


def _zero_quaternion(launch: Launch, numbers: Numbers) -> Launch:
    return launch.with_node("laser_mount", lambda robot: MountSender(rotation=(0.0, 0.0, 0.0, 0.0)))


def _header_unknown(launch: Launch, numbers: Numbers) -> Launch:
    return launch.with_node("laser_driver", lambda robot: MisnamedLaser(robot, numbers.frame))


def _mount_volatile(launch: Launch, numbers: Numbers) -> Launch:
    return launch.with_node("laser_mount", lambda robot: MountSender(durability=DurabilityPolicy.VOLATILE))


CAUSES: dict[str, Callable[[Launch, Numbers], Launch]] = {
    "localizer not running": _no_localizer,
    "localizer waits for /clock": _localizer_on_sim_time,
    "Fixed Frame misspelt": _fixed_frame_misspelt,
    "odometry not running": _no_odometry,
    "parent misspelt": _parent_misspelt,
    "publish_tf off": _publish_tf_off,
    "two owners of one edge": _two_owners,
    "localizer owns the base": _localizer_owns_base,
    "nothing is wrong": _nothing,
    "mount wrong": _mount_wrong,
    "header says base_link": _header_base_link,
    "laser clock behind": _laser_clock_behind,
    "laser clock ahead": _laser_clock_ahead,
    "transforms late": _transforms_late,
    "odometry slow": _odometry_slow,
    "quaternion of zeros": _zero_quaternion,
    "header says another frame": _header_unknown,
    "mount volatile": _mount_volatile,
}
