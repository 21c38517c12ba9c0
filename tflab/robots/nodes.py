"""Run the teaching robot on ROS: one node for each publisher.

    joint_driver ----- /joint_states --> robot_state_publisher -- /tf, /tf_static
    wheel_odometry --- /odom, /tf (odom -> base_footprint)
    localization ----- /tf (map -> odom)
    laser_driver ----- /scan               imu_driver -- /imu
    object_detector -- /detected_point

    ekf_filter_node -- /odometry/filtered, /tf (odom -> base_footprint): not by default,
                       because two owners of one edge are one too many
    map_server ------- /map, latched: not by default, because a room has one, however many robots

    launch(graph)      the usual ones; launch(graph, only=["wheel_odometry"]) some

A driver measures at one moment and publishes at a later one.  So every timer here
speaks of the past: the stamp lies `delay_s` before the publication, and the reading
is the robot's at that true moment.  The stamp is what the node's own clock said
then, right or wrong.  The network adds what the lesson tells the graph to add.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import replace

from tflab.core import StampedTransform, seconds
from tflab.ros import client_library as rclpy
from tflab.ros.convert import msg_from_stamped
from tflab.ros.executors import ExternalShutdownException
from tflab.ros.graph import Graph, Participant, current_graph
from tflab.ros.messages import geometry_msgs, nav_msgs, sensor_msgs
from tflab.ros.node import Node
from tflab.ros.parameter import Parameter
from tflab.ros.qos import DurabilityPolicy, QoSProfile, qos_profile_sensor_data
from tflab.ros.tf2.topics import TransformBroadcaster

from .motion import Drive
from .reading_messages import (
    imu_msg,
    joint_state_msg,
    laser_scan_msg,
    occupancy_grid_msg,
    odometry_msg,
    point_msg,
)
from .readings import OdometryReading
from .state_publisher import RobotStatePublisher
from .teaching import Source, TeachingRobot

__all__ = ["NODES", "USUAL_NODES", "Driver", "launch"]

DEPTH = 10


class Driver(Node):
    """A node that tells, at its source's rate, what was true its source's delay ago."""

    def __init__(self, robot: TeachingRobot, source: Source) -> None:
        super().__init__(source.publisher, namespace=robot.prefix.strip("/"))
        self.robot = robot
        self._delay_ns = seconds(source.delay_s)
        self.create_timer(1.0 / source.rate_hz, self._tick)

    def _tick(self) -> None:
        true_ns = current_graph().now_ns - self._delay_ns
        self.tell(true_ns, self.get_clock().now().nanoseconds - self._delay_ns)

    def tell(self, true_ns: int, stamp_ns: int) -> None:
        """Publish what was measured at `true_ns` [ns], stamped with `stamp_ns` [ns]."""
        raise NotImplementedError


class JointDriver(Driver):
    """Says where the joints are."""

    def __init__(self, robot: TeachingRobot) -> None:
        super().__init__(robot, robot.sources["joints"])
        self._states = self.create_publisher(sensor_msgs.JointState, "joint_states", DEPTH)

    def tell(self, true_ns: int, stamp_ns: int) -> None:
        reading = replace(self.robot.joint_reading_at(true_ns), stamp_ns=stamp_ns)
        self._states.publish(joint_state_msg(reading))


class OdometryDriver(Driver):
    """Publishes the pose of the robot in odom, as a message and, unless disabled, as a transform.

    Parameters (of ROS): publish_tf, because odom -> base_footprint may have one owner only.
    """

    def __init__(
        self, robot: TeachingRobot, source: Source, topic: str, odometry_at: Callable[[int], OdometryReading]
    ) -> None:
        super().__init__(robot, source)
        self.declare_parameter("publish_tf", True)
        self._odometry_at = odometry_at
        self._odometry = self.create_publisher(nav_msgs.Odometry, topic, DEPTH)
        self._broadcaster = TransformBroadcaster(self)

    def tell(self, true_ns: int, stamp_ns: int) -> None:
        reading = replace(self._odometry_at(true_ns), stamp_ns=stamp_ns)
        self._odometry.publish(odometry_msg(reading))
        if self.get_parameter("publish_tf").value:
            base = StampedTransform(reading.frame_id, reading.child_frame_id, stamp_ns, reading.pose)
            self._broadcaster.sendTransform(msg_from_stamped(base))


class LocalizationDriver(Driver):
    """Says where odom is in map.

    Parameters (of ROS): tf_broadcast, as AMCL calls it.
    """

    def __init__(self, robot: TeachingRobot) -> None:
        super().__init__(robot, robot.sources["localization"])
        self.declare_parameter("tf_broadcast", True)
        self._broadcaster = TransformBroadcaster(self)

    def tell(self, true_ns: int, stamp_ns: int) -> None:
        if self.get_parameter("tf_broadcast").value:
            odom = replace(self.robot.map_to_odom_at(true_ns), stamp_ns=stamp_ns)
            self._broadcaster.sendTransform(msg_from_stamped(odom))


class LaserDriver(Driver):
    """Says what the laser saw."""

    def __init__(self, robot: TeachingRobot) -> None:
        super().__init__(robot, robot.sources["laser"])
        self._scans = self.create_publisher(sensor_msgs.LaserScan, "scan", qos_profile_sensor_data)

    def tell(self, true_ns: int, stamp_ns: int) -> None:
        self._scans.publish(laser_scan_msg(replace(self.robot.laser.scan_at(true_ns), stamp_ns=stamp_ns)))


class ObjectDetector(Driver):
    """Says where the camera saw the ball, if it did."""

    def __init__(self, robot: TeachingRobot) -> None:
        super().__init__(robot, robot.sources["camera"])
        self._points = self.create_publisher(geometry_msgs.PointStamped, "detected_point", DEPTH)

    def tell(self, true_ns: int, stamp_ns: int) -> None:
        detection = self.robot.camera.detection_at(true_ns)
        if detection is not None:
            self._points.publish(point_msg(replace(detection, stamp_ns=stamp_ns)))


class ImuDriver(Driver):
    """Says what the imu felt."""

    def __init__(self, robot: TeachingRobot) -> None:
        super().__init__(robot, robot.sources["imu"])
        self._readings = self.create_publisher(sensor_msgs.Imu, "imu", qos_profile_sensor_data)

    def tell(self, true_ns: int, stamp_ns: int) -> None:
        self._readings.publish(imu_msg(replace(self.robot.imu.reading_at(true_ns), stamp_ns=stamp_ns)))


class MapServer(Node):
    """Says once what the room looks like, to everybody who comes, however late.

    Parameters (of ROS): frame_id and topic_name, as nav2's map_server calls them.
    """

    def __init__(self, robot: TeachingRobot) -> None:
        super().__init__("map_server")
        self.declare_parameter("frame_id", "map")
        self.declare_parameter("topic_name", "map")
        topic, frame = (self.get_parameter(name).value for name in ("topic_name", "frame_id"))
        latched = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        self._maps = self.create_publisher(nav_msgs.OccupancyGrid, topic, latched)
        self._maps.publish(occupancy_grid_msg(robot.room, self.get_clock().now().nanoseconds, frame))


def state_publisher(robot: TeachingRobot) -> RobotStatePublisher:
    """Return the robot_state_publisher of a robot."""
    parameters = [Parameter("robot_description", value=robot.urdf), Parameter("frame_prefix", value=robot.prefix)]
    return RobotStatePublisher(namespace=robot.prefix.strip("/"), parameter_overrides=parameters)


def wheel_odometry(robot: TeachingRobot) -> OdometryDriver:
    """Return the node that counts the turns of the wheels."""
    return OdometryDriver(robot, robot.sources["odometry"], "odom", robot.odometry_at)


def ekf_filter_node(robot: TeachingRobot) -> OdometryDriver:
    """Return the node that makes more of wheels and imu together; it wants to own the same edge."""
    return OdometryDriver(robot, robot.sources["ekf"], "odometry/filtered", robot.filtered_at)


NODES: dict[str, Callable[[TeachingRobot], Node]] = {
    "robot_state_publisher": state_publisher,
    "joint_driver": JointDriver,
    "wheel_odometry": wheel_odometry,
    "localization": LocalizationDriver,
    "laser_driver": LaserDriver,
    "object_detector": ObjectDetector,
    "imu_driver": ImuDriver,
    "ekf_filter_node": ekf_filter_node,
    "map_server": MapServer,
}
USUAL_NODES = tuple(name for name in NODES if name not in ("ekf_filter_node", "map_server"))


def launch(
    graph: Graph | None = None, robot: TeachingRobot | None = None, only: Iterable[str] = USUAL_NODES
) -> list[Participant]:
    """Start the robot's nodes, each as a participant of its own, and return these.

    Args:
        graph: the current one if None.
        robot: one that begins to drive now if None.
        only: which nodes, by the keys of NODES; if not said, all but the ekf_filter_node and the map_server.

    Raises:
        ValueError: no such node.
    """
    graph = graph or current_graph()
    robot = robot or TeachingRobot(Drive(start_ns=graph.now_ns))
    names = list(only)
    for name in names:
        if name not in NODES:
            raise ValueError(f"the robot has no node {name!r}; it has {', '.join(NODES)}")
    return [graph.start(_run, NODES[name], robot, name=robot.prefix + name) for name in names]


def _run(make_node: Callable[[TeachingRobot], Node], robot: TeachingRobot) -> None:
    rclpy.init(args=[])
    try:
        rclpy.spin(make_node(robot))
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()
