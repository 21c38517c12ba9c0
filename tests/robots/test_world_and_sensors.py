"""Readings follow from the mounting, the stamp and the room."""

import math
from pathlib import Path

import numpy as np
import pytest
import yaml

from tflab.core import Transform, seconds
from tflab.robots.motion import Drive, Leg, PlanarPose
from tflab.robots.odometry import WheelOdometry
from tflab.robots.sensors import GRAVITY_MPS2, Camera, Imu, Laser, Room, rectangle

CASES = yaml.safe_load(Path(__file__).with_suffix(".yaml").read_text(encoding="utf-8"))

BOX = Room(rectangle(-2.0, -1.0, 4.0, 3.0))
STANDING = Drive([Leg(1.0)], start=PlanarPose(0.0, 0.0, 0.0))
OPTICAL = Transform.from_rpy(-math.pi / 2, 0.0, -math.pi / 2, (0.1, 0.0, 0.5))


def ray(room: Room, origin, direction) -> float:
    return float(room.distances(np.array([origin], float), np.array([direction], float))[0])


def test_a_ray_meets_the_nearest_wall_over_it_nothing_and_downwards_the_floor():
    assert ray(BOX, (0.0, 0.0, 0.2), (1.0, 0.0, 0.0)) == 4.0
    assert ray(BOX, (0.0, 0.0, 0.2), (-1.0, 0.0, 0.0)) == 2.0
    pillar = Room((*BOX.walls, *rectangle(1.0, -0.5, 2.0, 0.5)))
    assert ray(pillar, (0.0, 0.0, 0.2), (1.0, 0.0, 0.0)) == 1.0
    assert ray(BOX, (0.0, 0.0, 3.0), (1.0, 0.0, 0.0)) == math.inf
    down = (math.sqrt(0.5), 0.0, -math.sqrt(0.5))
    assert ray(BOX, (0.0, 0.0, 0.2), down) == pytest.approx(0.2 * math.sqrt(2.0))
    assert BOX.is_in_sight((0.0, 0.0, 0.5), (3.0, 1.0, 0.5))
    assert not BOX.is_in_sight((0.0, 0.0, 0.5), (5.0, 1.0, 0.5))


def test_a_level_scan_of_a_standing_robot_is_the_floor_plan():
    laser = Laser(STANDING, BOX, Transform((0.2, 0.0, 0.25)), sigma_m=0.0)
    scan = laser.scan_at(seconds(1.0))
    ahead, left = scan.ranges[180], scan.ranges[270]  # the sweep begins behind and turns left
    assert (ahead, left) == pytest.approx((3.8, 3.0))
    assert scan.points()[270] == pytest.approx((0.0, 3.0, 0.0))
    short = Laser(STANDING, BOX, Transform((0.0, 0.0, 0.25)), range_max=3.5, sigma_m=0.0).scan_at(seconds(1.0))
    assert short.ranges[180] == math.inf and np.isnan(short.points()[180]).all()


def test_a_laser_tilted_down_sees_the_floor_instead_of_the_wall():
    tilted = Transform.from_rpy(pitch=math.radians(10.0), translation=(0.0, 0.0, 0.25))
    scan = Laser(STANDING, BOX, tilted, sigma_m=0.0).scan_at(seconds(1.0))
    assert scan.ranges[180] == pytest.approx(0.25 / math.sin(math.radians(10.0)))


def test_turning_while_sweeping_bends_the_scan_unless_each_ray_has_its_own_time():
    turning = Drive([Leg(10.0, yaw_rate_radps=1.0)], start=PlanarPose(0.0, 0.0, 0.0))
    scan = Laser(turning, BOX, Transform((0.0, 0.0, 0.2)), sigma_m=0.0).scan_at(seconds(2.0))
    points = scan.points()
    poses = turning.poses_at(scan.ray_stamps_ns)
    in_map = [PlanarPose(*pose).transform().apply(tuple(p)) for pose, p in zip(poses.tolist(), points, strict=True)]
    walls = np.array(in_map)
    on_a_wall = np.minimum.reduce(
        [abs(walls[:, 0] + 2), abs(walls[:, 0] - 4), abs(walls[:, 1] + 1), abs(walls[:, 1] - 3)]
    )
    assert on_a_wall.max() < 1e-9
    with_one_pose = np.array([PlanarPose(*poses[0]).transform().apply(tuple(p)) for p in points])
    # The last ray comes 0.1 s after the first, and the robot has turned 0.1 rad since.
    shift_m = np.linalg.norm(with_one_pose[-1] - walls[-1])
    assert shift_m == pytest.approx(0.1 * scan.ranges[-1], rel=0.01)


def test_a_reading_at_one_stamp_is_always_the_same():
    laser = Laser(STANDING, BOX, Transform((0.0, 0.0, 0.25)), seed=5)
    assert laser.scan_at(seconds(1.0)) == laser.scan_at(seconds(1.0))
    assert laser.scan_at(seconds(1.0)).ranges != laser.scan_at(seconds(1.1)).ranges


def test_nanoseconds_do_not_overflow_where_numpy_counts_in_32_bits(monkeypatch):
    def shown() -> tuple:
        drive = Drive([Leg(10.0, 1.0, 0.1)])
        scan = Laser(drive, BOX, Transform((0.2, 0.0, 0.25)), sweep_s=8.0).scan_at(seconds(1.0))
        return WheelOdometry(drive).pose_at(seconds(9.0)), scan.ranges, scan.ray_stamps_ns.tolist()

    plain, arange = shown(), np.arange  # 32 bits are the default on Windows before NumPy 2
    monkeypatch.setattr(np, "arange", lambda *ends, dtype=np.int32: arange(*ends, dtype=dtype))
    assert shown() == plain


def test_a_detection_is_written_in_optical_axes():
    # 2.1 m ahead of the camera, 0.4 m to its left, 0.2 m below it: x right, y down, z forward.
    camera = Camera(STANDING, BOX, OPTICAL, (2.2, 0.4, 0.3), sigma_m=0.0)
    detection = camera.detection_at(seconds(1.0))
    assert detection.frame_id == "camera_optical_frame"
    assert detection.point == pytest.approx((-0.4, 0.2, 2.1))


@pytest.mark.parametrize("ball", [(-1.0, 0.0, 0.5), (0.5, 2.0, 0.5), (4.5, 0.0, 0.5)])
def test_a_hidden_ball_is_not_detected(ball):
    assert Camera(STANDING, BOX, OPTICAL, ball).detection_at(seconds(1.0)) is None


def test_an_imu_at_rest_feels_the_ground_push_up_and_upside_down_the_opposite():
    quiet = {"gyro_bias_radps": 0.0, "sigma_radps": 0.0, "sigma_mps2": 0.0}
    level = Imu(STANDING, Transform(), **quiet).reading_at(seconds(1.5))
    assert level.linear_acceleration == pytest.approx((0.0, 0.0, GRAVITY_MPS2))
    flipped = Imu(STANDING, Transform.from_rpy(roll=math.pi), **quiet).reading_at(seconds(1.5))
    assert flipped.linear_acceleration == pytest.approx((0.0, 0.0, -GRAVITY_MPS2))


def test_an_imu_in_a_left_turn_feels_the_turn_and_a_pull_to_the_left():
    arc = Drive([Leg(10.0, speed_mps=2.0, yaw_rate_radps=0.5)], start=PlanarPose(0.0, 0.0, 1.0))
    quiet = {"gyro_bias_radps": 0.0, "sigma_radps": 0.0, "sigma_mps2": 0.0}
    reading = Imu(arc, Transform(), **quiet).reading_at(seconds(3.0))
    assert reading.angular_velocity == pytest.approx((0.0, 0.0, 0.5))
    assert reading.linear_acceleration == pytest.approx((0.0, 1.0, GRAVITY_MPS2))
    assert Transform(rotation=reading.orientation).rpy()[2] == pytest.approx(1.0)  # 2 s at 0.5 rad/s, from zero


def test_a_floor_plan_in_cells_has_walls_where_the_walls_are():
    cells, (x, y) = BOX.cells(resolution_m=0.5)
    assert (x, y) == (-2.75, -1.75)
    drawn = "\n".join("".join("#" if cell else "." for cell in row) for row in cells[::-1])
    assert drawn == CASES["floor"]
