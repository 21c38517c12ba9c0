"""The robot on ROS publishes what the pure simulation computes, with its stamps and delays."""

import math

import pytest

from tflab.core import LATEST, seconds
from tflab.robots.nodes import USUAL_NODES, launch
from tflab.robots.teaching import TeachingRobot
from tflab.ros import client_library as rclpy
from tflab.ros.convert import stamp_ns_from
from tflab.ros.messages import geometry_msgs, nav_msgs, sensor_msgs, tf2_msgs
from tflab.ros.node import Node
from tflab.ros.parameter import Parameter
from tflab.ros.qos import DurabilityPolicy, QoSProfile, qos_profile_sensor_data
from tflab.ros.tf2.buffer import Buffer
from tflab.ros.tf2.topics import TransformListener


class Audience:
    """Somebody who hears everything the robot says for a while."""

    def __init__(self, graph, for_s: float, topics: dict[str, type]) -> None:
        rclpy.init(args=[])
        node = Node("audience")
        self.heard = {topic: [] for topic in topics}
        for topic, kind in topics.items():
            node.create_subscription(kind, topic, self._keeper(topic, graph), qos_profile_sensor_data)
        self.buffer = Buffer()
        listener = TransformListener(self.buffer, node)
        rclpy.spin_until_future_complete(node, rclpy.Future(), timeout_sec=for_s)
        listener.unregister()

    def _keeper(self, topic, graph):
        return lambda message: self.heard[topic].append((graph.now_ns, message))


def test_every_edge_is_the_simulations_at_its_stamp(graph):
    launch(graph)
    core = Audience(graph, 3.0, {}).buffer.core
    robot = TeachingRobot()
    for child, truth_at in (("odom", robot.map_to_odom_at), ("base_footprint", robot.odom_to_base_at)):
        history = core.history(child)
        assert len(history.stamps_ns) > 25
        for stamp_ns, transform in zip(history.stamps_ns, history.transforms, strict=True):
            expected = truth_at(stamp_ns)
            assert history.parents[0] == expected.frame_id
            assert transform.translation == pytest.approx(expected.transform.translation)
    wrist = core.lookup_transform("elbow", "wrist", LATEST)
    expected = next(each for each in robot.joints_at(wrist.stamp_ns) if each.child_frame_id == "wrist")
    assert wrist.transform.rotation == pytest.approx(expected.transform.rotation)
    assert core.lookup_transform("base_link", "laser_frame", LATEST).transform.translation == (0.20, 0.0, 0.15)


def test_messages_have_the_delay_of_their_source_and_the_truth_at_their_stamp(graph):
    launch(graph)
    robot = TeachingRobot()
    heard = Audience(
        graph, 3.0,
        {"/scan": sensor_msgs.LaserScan, "/detected_point": geometry_msgs.PointStamped, "/imu": sensor_msgs.Imu},
    ).heard  # fmt: skip
    for topic, source in (("/scan", "laser"), ("/detected_point", "camera"), ("/imu", "imu")):
        assert len(heard[topic]) >= 5
        for now_ns, message in heard[topic]:
            assert now_ns - stamp_ns_from(message.header.stamp) == seconds(robot.sources[source].delay_s)
    _, scan = heard["/scan"][-1]
    expected = robot.laser.scan_at(stamp_ns_from(scan.header.stamp))
    assert list(scan.ranges) == pytest.approx(expected.ranges, rel=1e-6)
    assert scan.header.frame_id == "laser_frame"
    assert scan.angle_max == pytest.approx(math.pi - 2 * math.pi / 360)
    assert scan.scan_time == pytest.approx(0.1, rel=1e-4)
    _, point = heard["/detected_point"][-1]
    detection = robot.camera.detection_at(stamp_ns_from(point.header.stamp))
    assert (point.point.x, point.point.y, point.point.z) == detection.point
    _, felt = heard["/imu"][-1]
    assert felt.linear_acceleration.z == robot.imu.reading_at(stamp_ns_from(felt.header.stamp)).linear_acceleration[2]


def test_a_wrong_clock_changes_the_stamps_and_not_what_is_true(graph):
    graph.set_clock_offset("wheel_odometry", 5.0)
    launch(graph, only=["wheel_odometry"])
    ((now_ns, message), *_) = Audience(graph, 1.0, {"/odom": nav_msgs.Odometry}).heard["/odom"]
    assert stamp_ns_from(message.header.stamp) - now_ns == seconds(5.0) - seconds(0.004)
    truth = TeachingRobot().odometry_at(now_ns - seconds(0.004))
    assert message.pose.pose.position.x == truth.pose.translation[0]


def test_filter_and_odometry_are_two_owners_unless_one_does_not_publish_tf(graph):
    launch(graph, only=["wheel_odometry", "ekf_filter_node"])
    graph.run(seconds=5.0)
    rclpy.init(args=[])
    node = Node("audience")
    stamps = []
    node.create_subscription(
        tf2_msgs.TFMessage, "/tf", lambda m: stamps.extend(stamp_ns_from(t.header.stamp) for t in m.transforms), 100
    )
    rclpy.spin_until_future_complete(node, rclpy.Future(), timeout_sec=1.01)
    assert len(stamps) == 20 + 30
    robot = TeachingRobot()
    wheels, fused = robot.odometry_at(stamps[0]).pose, robot.filtered_at(stamps[0]).pose
    assert math.dist(wheels.translation, fused.translation) > 0.01
    (ekf,) = (each for each in graph.nodes if each.get_name() == "ekf_filter_node")
    ekf.set_parameters([Parameter("publish_tf", value=False)])
    stamps.clear()
    rclpy.spin_until_future_complete(node, rclpy.Future(), timeout_sec=1.0)
    assert len(stamps) == 20


def test_a_prefix_separates_two_robots_on_one_graph(graph):
    names = ["robot_state_publisher", "wheel_odometry", "localization"]
    launch(graph, TeachingRobot(prefix="robot1/"), only=names)
    launch(graph, TeachingRobot(prefix="robot2/"), only=names)
    assert {node.get_fully_qualified_name() for node in graph.nodes} == {
        f"/robot{n}/{name}" for n in (1, 2) for name in names
    }
    core = Audience(graph, 1.0, {}).buffer.core
    assert core.can_transform("robot1/laser_frame", "robot2/camera_link", LATEST)


def test_the_robot_begins_to_drive_when_it_is_launched(graph):
    graph.run(seconds=100.0)
    launch(graph, only=["wheel_odometry"])
    heard = Audience(graph, 3.0, {"/odom": nav_msgs.Odometry}).heard["/odom"]
    assert len(heard) == 60
    assert heard[0][1].pose.pose.position.x == 0.0
    assert heard[-1][1].twist.twist.linear.x == pytest.approx(0.5, abs=0.05)


def test_an_unknown_node_is_refused_before_anything_starts_and_participants_end_when_they_are_stopped(graph):
    with pytest.raises(ValueError, match="the robot has no node 'lidar'; it has robot_state_publisher, joint_driver"):
        launch(graph, only=["imu_driver", "lidar"])
    assert graph.participants == []
    participants = launch(graph)
    assert [each.name for each in participants] == list(USUAL_NODES)
    (localizer,) = (each for each in graph.nodes if each.get_name() == "localization")
    localizer.set_parameters([Parameter("tf_broadcast", value=False)])
    assert not Audience(graph, 1.0, {}).buffer.core.frame_exists("map")
    graph.stop()
    assert not any(each.is_running for each in participants)


def test_a_map_server_publishes_the_map_to_late_subscribers(graph):
    launch(graph, only=["map_server"])
    graph.run(seconds=5.0)
    rclpy.init(args=[])
    node, heard = Node("late"), []
    latched = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    node.create_subscription(nav_msgs.OccupancyGrid, "/map", heard.append, latched)
    rclpy.spin_once(node, timeout_sec=1.0)
    (grid,) = heard
    assert (grid.header.frame_id, stamp_ns_from(grid.header.stamp)) == ("map", seconds(1.0))
    assert len(grid.data) == grid.info.width * grid.info.height
    column = math.floor((8.0 - grid.info.origin.position.x) / grid.info.resolution)  # the wall at x = 8 m
    row = math.floor((0.0 - grid.info.origin.position.y) / grid.info.resolution)
    assert grid.data[row * grid.info.width + column] == 100
    assert grid.data[row * grid.info.width + column - 5] == 0
    assert "map_server" not in USUAL_NODES
