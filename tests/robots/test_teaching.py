"""The teaching robot: frames, stamps, delays, and reproducibility."""

import math
from dataclasses import replace

import pytest
import yaml

from tflab.core import LATEST, Transform, seconds
from tflab.robots import teaching
from tflab.robots.model import link_poses
from tflab.robots.motion import Drive, Leg
from tflab.robots.readings import Detection, Scan
from tflab.robots.teaching import SOURCES, Source, TeachingRobot, teaching_urdf
from tflab.robots.urdf import parse_urdf


def test_mounts_are_those_of_the_lecture_and_the_chain_to_the_tool_is_whole():
    buffer = TeachingRobot().buffer(until_s=3.0)
    laser = buffer.lookup_transform("base_link", "laser_frame", LATEST)
    assert laser.transform.translation == (0.20, 0.0, 0.15)
    camera = buffer.lookup_transform("base_link", "camera_link", LATEST)
    assert camera.transform.translation == (0.10, 0.0, 0.30)
    link_T_optical = buffer.lookup_transform("camera_link", "camera_optical_frame", LATEST).transform
    assert link_T_optical.rotation == pytest.approx((-0.5, 0.5, -0.5, 0.5))
    assert link_T_optical.apply((0.0, 0.0, 2.0)) == pytest.approx((2.0, 0.0, 0.0))  # it looks along z
    assert buffer.chain("map", "tcp")[::-1] == [
        "map", "odom", "base_footprint", "base_link", "shoulder", "elbow", "wrist", "tool0", "tcp",
    ]  # fmt: skip


def test_the_stretched_arm_reaches_as_far_as_its_parts_are_long():
    # shoulder 0.10 behind; upper arm 0.25, forearm 0.20, tool 0.12, all pointing forward
    robot = TeachingRobot()
    poses = link_poses(robot.model, {"elbow_joint": 0.0, "wrist_joint": 0.0})
    straight = poses["base_link"].inverse() @ poses["tcp"]
    assert straight.translation == pytest.approx((-0.10 + 0.25 + 0.20 + 0.12, 0.0, 0.15))
    assert straight.apply((0.0, 0.0, 1.0))[0] == pytest.approx(1.0 + straight.translation[0])


def test_the_arm_keeps_within_its_limits():
    robot = TeachingRobot()
    for t in range(60):
        positions = robot.joint_positions_at(seconds(1.0 + 0.37 * t))
        for name in ("shoulder_joint", "elbow_joint", "wrist_joint"):
            limit = robot.model.joint(name).limit
            assert limit.lower <= positions[name] <= limit.upper


def test_the_estimated_pose_stays_near_the_true_pose():
    robot = TeachingRobot()
    buffer = robot.buffer(until_s=60.0)
    stamp_ns = buffer.latest_common_time_ns("map", "laser_frame")
    believed = buffer.lookup_transform("map", "laser_frame", stamp_ns).transform.translation
    truth = robot.truth_at(stamp_ns)["laser_frame"].translation
    assert math.dist(believed, truth) < 0.1
    assert believed != truth


def test_a_detection_transformed_at_its_stamp_finds_the_ball():
    robot = TeachingRobot()
    buffer = robot.buffer(until_s=6.0)
    detections = [
        r.value for r in robot.readings(until_s=5.5) if r.topic == "/detected_point" and r.value.stamp_ns > seconds(2)
    ]
    assert len(detections) > 5
    for detection in detections:
        map_T_optical = buffer.lookup_transform("map", detection.frame_id, detection.stamp_ns).transform
        assert math.dist(map_T_optical.apply(detection.point), (6.5, -1.5, 0.30)) < 0.25


def test_every_message_is_received_after_its_stamp_plus_delay():
    robot = TeachingRobot()
    for reading in robot.readings(until_s=4.0):
        if isinstance(reading.value, Detection):
            assert 0.200 <= (reading.receive_ns - reading.value.stamp_ns) / 1e9 <= 0.211
        if isinstance(reading.value, Scan):
            assert reading.receive_ns > reading.value.ray_stamps_ns[-1]


def test_streams_come_in_the_order_of_arrival_and_end_where_asked():
    robot = TeachingRobot()
    for stream in (robot.records(until_s=4.0), robot.readings(until_s=4.0)):
        heard = [item.receive_ns for item in stream]
        assert heard == sorted(heard)
        assert seconds(1.0) < heard[0] and seconds(3.8) < heard[-1] < seconds(4.0)


def test_each_edge_has_one_owner_and_mounts_alone_are_static():
    owners, records = {}, TeachingRobot().records(until_s=3.0)
    for record in records:
        owners.setdefault(record.stamped.child_frame_id, set()).add(record.publisher)
    assert all(len(names) == 1 for names in owners.values())
    assert owners["odom"] == {"/localization"}
    assert owners["base_footprint"] == {"/wheel_odometry"}
    assert owners["wrist"] == owners["laser_frame"] == {"/robot_state_publisher"}
    assert {(record.stamped.child_frame_id, record.topic) for record in records if record.is_static} == {
        (child, "/tf_static")
        for child in ("base_link", "laser_frame", "camera_link", "camera_optical_frame", "imu_link", "tool0", "tcp")
    }


def test_the_filter_drifts_less_than_the_wheels():
    robot = TeachingRobot()
    stamp_ns = seconds(60.0)
    truth = robot.drive.pose_at(stamp_ns)
    off = {}
    for name, odometry in (("wheels", robot.odometry), ("filter", robot.filtered)):
        believed = robot.drive.start.then(odometry.pose_at(stamp_ns))
        off[name] = math.dist(believed[:2], truth[:2])
    assert 0.0 < off["filter"] < off["wheels"]


def test_two_robots_with_prefixes_share_the_map():
    buffer = TeachingRobot(prefix="robot1/").buffer(until_s=3.0)
    for record in TeachingRobot(prefix="robot2/", seed=1).records(until_s=3.0):
        buffer.set_transform(record.stamped, record.publisher, record.is_static)
    assert buffer.can_transform("robot1/laser_frame", "robot2/tcp", LATEST)
    assert buffer.parent_of("robot1/odom") == buffer.parent_of("robot2/odom") == "map"


def test_a_source_can_be_slowed_down():
    slow = TeachingRobot(sources={"odometry": Source("wheel_odometry", 1.0, 0.3, 0.0)})
    stamps = slow.buffer(until_s=5.0).history("base_footprint").stamps_ns
    assert stamps == (seconds(1), seconds(2), seconds(3), seconds(4))
    with pytest.raises(ValueError, match="no source 'odom'; the robot has odometry, localization"):
        TeachingRobot(sources={"odom": SOURCES["odometry"]})


def test_the_same_seed_gives_the_same_stream_and_another_seed_another():
    first, again, other = (TeachingRobot(seed=seed).records(until_s=5.0) for seed in (3, 3, 4))
    assert first == again
    assert first != other


def test_the_urdf_survives_a_command_line_where_parameters_are_yaml():
    # As on a robot, a ": " or " #" in -p robot_description:="$(cat tf_lab_robot.urdf)" would break it.
    on_one_line = parse_urdf(yaml.safe_load(teaching_urdf())).joint("base_to_laser")
    assert replace(on_one_line, line=0) == replace(TeachingRobot().model.joint("base_to_laser"), line=0)


def test_adding_a_source_does_not_change_the_other_sources(monkeypatch):
    before = TeachingRobot().records(until_s=3.0), TeachingRobot().readings(until_s=3.0)
    monkeypatch.setattr(teaching, "SOURCES", {"sonar": Source("sonar_driver", 5.0, 0.010, 0.002), **SOURCES})
    assert (TeachingRobot().records(until_s=3.0), TeachingRobot().readings(until_s=3.0)) == before


def test_sensors_with_one_stamp_have_independent_noise():
    robot = TeachingRobot()
    laser, imu = robot.laser.scan_at(seconds(2.0)), robot.imu.reading_at(seconds(2.0))
    quiet = replace(robot.laser, sigma_m=0.0).scan_at(seconds(2.0))
    still = replace(robot.imu, sigma_radps=0.0).reading_at(seconds(2.0))
    of_laser = (laser.ranges[0] - quiet.ranges[0]) / robot.laser.sigma_m
    of_imu = (imu.angular_velocity[0] - still.angular_velocity[0]) / robot.imu.sigma_radps
    assert of_laser != pytest.approx(of_imu)


def test_a_misplaced_sensor_measures_from_there_while_tf_follows_the_urdf():
    turned = Transform.from_rpy(yaw=math.pi / 2, translation=(0.20, 0.0, 0.15))
    robot, usual = TeachingRobot(screws={"laser_frame": turned}), TeachingRobot()
    assert robot.records(until_s=3.0) == usual.records(until_s=3.0)
    scan, drawn = (each.laser.scan_at(seconds(1.0)).ranges for each in (robot, usual))
    ahead_now, ahead_drawn = scan[180], drawn[180]  # a sweep begins straight behind
    assert ahead_drawn != pytest.approx(ahead_now, abs=0.1)
    assert ahead_now == pytest.approx(drawn[270], abs=0.05)  # what is to the left, both times while standing still
    assert robot.truth_at(seconds(1.0))["laser_frame"].rpy()[2] == pytest.approx(math.pi / 2)
    with pytest.raises(ValueError, match="nothing is bolted on as 'lazer'; there is base_link, camera_link"):
        TeachingRobot(screws={"lazer": Transform()})


def test_tf_follows_the_urdf_in_which_parts_may_be_missing_and_the_drive():
    box = '<robot name="box"><link name="base_footprint"/></robot>'
    robot = TeachingRobot(Drive([Leg(5.0, speed_mps=1.0)]), urdf=box)
    assert robot.laser.mount == TeachingRobot().laser.mount
    assert {record.stamped.child_frame_id for record in robot.records(until_s=3.0)} == {"odom", "base_footprint"}
    assert set(robot.truth_at(seconds(2.0))) == {"base_footprint"}
    x0, x2 = (robot.truth_at(seconds(at_s))["base_footprint"].translation[0] for at_s in (1.0, 3.0))
    assert x2 == pytest.approx(x0 + 2.0)
    urdf = teaching_urdf().replace('<origin xyz="0.20 0.0 0.15"', '<origin xyz="0.25 0.0 0.15"')
    laser = TeachingRobot(urdf=urdf).buffer(until_s=3.0).lookup_transform("base_link", "laser_frame", LATEST).transform
    assert laser.translation == (0.25, 0.0, 0.15)


def test_shared_frames_can_be_chosen():
    robot = TeachingRobot(prefix="robot1/", shared=("map", "odom"))
    assert [robot.frame(name) for name in ("map", "odom", "base_link")] == ["map", "odom", "robot1/base_link"]
    alone = TeachingRobot(prefix="robot1/", shared=())
    assert alone.map_to_odom_at(seconds(2.0)).frame_id == "robot1/map"
    with pytest.raises(ValueError, match="'base_link' is a part of the robot; what robots can share is map and odom"):
        TeachingRobot(shared=("base_link",))
