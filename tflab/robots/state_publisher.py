"""Publish the transforms of a robot model, as robot_state_publisher does.

    robot_description (parameter) ---+--> /robot_description   latched, as text
                                     |--> /tf_static           fixed joints, once
    /joint_states -------------------+--> /tf                  the joints that a message names

    ros2 run robot_state_publisher robot_state_publisher --ros-args -p robot_description:="$(cat robot.urdf)"
    ros2 run robot_state_publisher robot_state_publisher robot.urdf      up to Jazzy, with a warning

It stores only received positions: a joint that no JointState ever names has no
transform, so its link is missing from TF.  And it is in no hurry: a message whose
stamp is less than a period after the last one that it published is passed over.
Quirks are those of the real node (robot_state_publisher 3.x, in C++), and so are its
texts; what it says about a URDF that it cannot read is better here.
"""

from __future__ import annotations

import sys
from collections.abc import Sequence
from pathlib import Path

from tflab.core import StampedTransform
from tflab.ros import client_library as rclpy
from tflab.ros import distro
from tflab.ros.convert import msg_from_stamped, stamp_ns_from
from tflab.ros.executors import ExternalShutdownException
from tflab.ros.logging import get_logger
from tflab.ros.messages import geometry_msgs, rcl_interfaces, sensor_msgs, std_msgs, tf2_msgs
from tflab.ros.node import Node
from tflab.ros.parameter import Parameter
from tflab.ros.qos import DurabilityPolicy, QoSProfile, qos_profile_parameter_events, qos_profile_sensor_data

from .model import JOINT_TYPES, Joint, Robot, joint_transform
from .urdf import UrdfError, parse_urdf

__all__ = ["RobotStatePublisher", "main"]

LATCHED = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
MILLISECOND_NS = 1_000_000
FILE_GIVEN = (
    "No robot_description parameter, but command-line argument available.  Assuming argument is name of URDF file.  "
    "This backwards compatibility fallback will be removed in the future."
)


class RobotStatePublisher(Node):
    """The node; `file` has the URDF if robot_description is empty.

    Parameters (of ROS): robot_description, publish_frequency [Hz], frame_prefix, ignore_timestamp.

    Raises:
        RuntimeError: robot_description is empty or no robot, or publish_frequency is out of range.
    """

    def __init__(self, file: str = "", **options: object) -> None:
        super().__init__("robot_state_publisher", **options)
        self._static: dict[str, geometry_msgs.TransformStamped] = {}
        self._published_ns: dict[str, int] = {}
        self._last_callback_ns = 0

        urdf = self.declare_parameter("robot_description", "").value
        if not urdf and file and distro.current().reads_urdf_file:
            self.get_logger().warning(FILE_GIVEN)
            try:
                urdf = Path(file).read_text(encoding="utf-8", errors="replace")
            except OSError as error:
                raise RuntimeError(f"Failed to open URDF file: {file}: {error.strerror}") from None
            self.set_parameters([Parameter("robot_description", value=urdf)])
        if not urdf:
            raise RuntimeError("robot_description parameter must not be empty")
        self._description_publisher = self.create_publisher(std_msgs.String, "robot_description", LATCHED)
        self._robot = self._robot_from(urdf)
        self._publish_description(urdf)
        if not _is_possible(self.declare_parameter("publish_frequency", 20.0).value):
            raise RuntimeError("publish_frequency must be between 0 (exclusive) and 1000")
        self.declare_parameter("frame_prefix", "")
        self.declare_parameter("ignore_timestamp", False)
        self.add_on_set_parameters_callback(self._check_new_parameters)
        self.create_subscription(
            rcl_interfaces.ParameterEvent, "/parameter_events", self._on_parameter_event, qos_profile_parameter_events
        )

        self._tf = self.create_publisher(tf2_msgs.TFMessage, "/tf", QoSProfile(depth=100))
        self._tf_static = self.create_publisher(tf2_msgs.TFMessage, "/tf_static", LATCHED)
        self.create_subscription(sensor_msgs.JointState, "joint_states", self.on_joint_state, qos_profile_sensor_data)
        self._publish_fixed()

    # -- joint states -------------------------------------------------------

    def on_joint_state(self, state: sensor_msgs.JointState) -> None:
        """Publish the transforms of the joints that a message names, if it is time for them."""
        names = list(state.name)
        if len(names) != len(state.position):
            self._refuse(names, state.position)
            return
        now_ns = self.get_clock().now().nanoseconds
        if now_ns < self._last_callback_ns:
            self.get_logger().warning("Moved backwards in time, re-publishing joint transforms!")
            self._published_ns.clear()
        self._last_callback_ns = now_ns
        stamp_ns = stamp_ns_from(state.header.stamp)
        # A joint never published counts as published at time zero.  So the first message comes
        # through at once, unless its stamp is itself within a period of zero.
        oldest_ns = min([self._published_ns.get(name, 0) for name in names], default=now_ns)
        is_due = stamp_ns >= min(oldest_ns, now_ns) + self._period_ns()
        if is_due or self.get_parameter("ignore_timestamp").value:
            positions: dict[str, float] = {}
            for name, position in zip(names, state.position, strict=True):
                positions.setdefault(name, position)  # named twice, the first counts
            self._publish_moving(positions, stamp_ns)
            self._published_ns |= dict.fromkeys(names, stamp_ns)

    def _refuse(self, names: list[str], positions: Sequence[float]) -> None:
        if len(positions):
            self.get_logger().error("Robot state publisher ignored an invalid JointState message")
            return
        self.get_logger().warning(
            f'Robot state publisher ignored a JointState message about joint(s) "{names[0]}"(,...) '
            "whose position member was empty."
        )

    def _publish_moving(self, positions: dict[str, float], stamp_ns: int) -> None:
        """Publish every named joint that moves, and those that mimic one of them, by the alphabet."""
        joints = sorted(self._robot.joints, key=lambda joint: joint.name)
        for joint in joints:
            if joint.mimic is not None and joint.mimic.joint in positions:
                followed = positions[joint.mimic.joint]
                positions.setdefault(joint.name, followed * joint.mimic.multiplier + joint.mimic.offset)
        moving = [joint for joint in joints if JOINT_TYPES[joint.type] == 1 and joint.name in positions]
        transforms = [self._message(joint, positions[joint.name], stamp_ns) for joint in moving]
        self._tf.publish(tf2_msgs.TFMessage(transforms=transforms))

    # -- fixed joints -------------------------------------------------------

    def _publish_fixed(self) -> None:
        """Publish the fixed joints, and the planar ones, which count as fixed; floating ones are left out.

        Like the broadcaster of C++, it sends again what it ever sent, with the newest value.
        """
        stamp_ns = self.get_clock().now().nanoseconds
        for joint in sorted(self._robot.joints, key=lambda joint: joint.name):
            if joint.type in ("fixed", "planar"):
                message = self._message(joint, None, stamp_ns)
                self._static[message.child_frame_id] = message
        self._tf_static.publish(tf2_msgs.TFMessage(transforms=list(self._static.values())))

    def _message(self, joint: Joint, position: float | None, stamp_ns: int) -> geometry_msgs.TransformStamped:
        prefix = self.get_parameter("frame_prefix").value
        transform = joint_transform(joint, position)
        return msg_from_stamped(StampedTransform(prefix + joint.parent, prefix + joint.child, stamp_ns, transform))

    # -- the description and the parameters ---------------------------------

    def _robot_from(self, urdf: str) -> Robot:
        """Return the robot, with the warnings of KDL, which the real node is built on."""
        try:
            robot = parse_urdf(urdf)
        except UrdfError as error:
            self.get_logger().error(str(error))
            raise RuntimeError("Unable to initialize urdf::model from robot description") from None
        for note in robot.notes:
            if "quat_xyzw" in note:
                self.get_logger().warning(note)
        kdl = get_logger("kdl_parser")
        if robot.link(robot.root).has_inertia:
            kdl.warning(
                f"The root link {robot.root} has an inertia specified in the URDF, but KDL does not support a root "
                "link with an inertia.  As a workaround, you can add an extra dummy link to your URDF."
            )
        for joint in robot.joints:
            if joint.type in ("planar", "floating"):
                kdl.warning(f"Converting unknown joint type of joint '{joint.name}' into a fixed joint")
        return robot

    def _publish_description(self, urdf: str) -> None:
        self._description_publisher.publish(std_msgs.String(data=urdf))
        self.get_logger().info("Robot initialized")

    def _check_new_parameters(self, parameters: list[Parameter]) -> rcl_interfaces.SetParametersResult:
        """Refuse parameters that the node could not work with."""
        reason = ""
        for parameter in parameters:
            if parameter.name == "robot_description" and not parameter.value:
                reason = "Empty URDF is not allowed"
            elif parameter.name == "robot_description":
                reason = self._fault_in(parameter.value)
            elif parameter.name == "publish_frequency" and not _is_possible(parameter.value):
                reason = "publish_frequency must be between 0.0 (exclusive) and 1000.0"
            if reason:
                break
        return rcl_interfaces.SetParametersResult(successful=not reason, reason=reason)

    def _fault_in(self, urdf: str) -> str:
        try:
            self._robot_from(urdf)
        except RuntimeError as error:
            self.get_logger().warning(str(error))
            return str(error)
        return ""

    def _on_parameter_event(self, event: rcl_interfaces.ParameterEvent) -> None:
        """Become another robot, if this node was given a new description."""
        names = [each.name for each in event.changed_parameters]
        if event.node == self.get_fully_qualified_name() and "robot_description" in names:
            urdf = self.get_parameter("robot_description").value
            self._robot = self._robot_from(urdf)
            self._publish_description(urdf)
            self._publish_fixed()

    def _period_ns(self) -> int:
        """Return the shortest time between two stamps, in whole milliseconds as the real node has it."""
        return int(1000.0 / self.get_parameter("publish_frequency").value) * MILLISECOND_NS


def main(args: Sequence[str] = ()) -> int:
    """Run the node until it is interrupted; its `--ros-args` are those of the process, and `args` the rest: a file.

    Return the exit code.
    """
    rclpy.init()
    try:
        rclpy.spin(RobotStatePublisher(*args[:1]))
    except RuntimeError as error:
        # The last words of a C++ program whose exception nobody catches, and the code of SIGABRT.
        last_words = f"terminate called after throwing an instance of 'std::runtime_error'\n  what():  {error}"
        print(last_words, file=sys.stderr)
        return -6
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()
    return 0


def _is_possible(publish_frequency: float) -> bool:
    return 0.0 < publish_frequency <= 1000.0
