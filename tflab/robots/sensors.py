"""Simulate a laser, a camera and an IMU in a room, each in its own frame and with its own stamps.

       y
     3 +--------------------+
       |            [crate] |        ray: origin + distance * direction
       |      []            |        wall: a segment of the floor plan, 2 m high
       |    pillar      o   |
    -3 +--------------ball--+ x      coordinates in `map`
      -2                    8

    stamp_ns --> true pose (motion) --> pose of the sensor (URDF) --> reading in the sensor's frame

Walls are upright on a floor at z = 0. A level laser measures a floor plan; a tilted
one measures the floor where a wall is expected. Each ray of a sweep has its own time,
so a robot that rotates during the sweep bends the walls. A detection of the camera is
in the optical frame: z forward, x right, y down (REP-103).

Noise is drawn from the seed and the stamp: the same stamp gives the same reading.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from tflab.core import NSEC_PER_SEC, Transform, seconds
from tflab.core.quaternions import Vector3

from .motion import Drive
from .readings import Detection, ImuReading, Scan
from .seeded_rng import seeded_rng

__all__ = ["BALL", "GRAVITY_MPS2", "ROOM", "Camera", "Imu", "Laser", "Room", "rectangle"]


Point2 = tuple[float, float]
Wall = tuple[Point2, Point2]

PARALLEL = 1e-12  # below this, a ray runs along a wall and does not hit it


def rectangle(x_min: float, y_min: float, x_max: float, y_max: float) -> tuple[Wall, ...]:
    """Return four walls around a rectangle [m]."""
    corners = ((x_min, y_min), (x_max, y_min), (x_max, y_max), (x_min, y_max))
    return tuple(zip(corners, (*corners[1:], corners[0]), strict=True))


@dataclass(frozen=True, slots=True)
class Room:
    """Walls on a floor.

    Attributes:
        walls: each from a point (x, y) to another [m].
        height: of all walls [m]; there is no ceiling.
    """

    walls: tuple[Wall, ...]
    height: float = 2.0

    def distances(self, origins: np.ndarray, directions: np.ndarray) -> np.ndarray:
        """Return how far each ray goes before it meets a wall or the floor; inf if it meets nothing.

        Args:
            origins: shape (N, 3) [m], above the floor.
            directions: shape (N, 3), of length one.

        Returns:
            shape (N,) [m].
        """
        begin, end = np.array(self.walls)[:, 0], np.array(self.walls)[:, 1]
        along = end - begin  # shape (M, 2)
        dx, dy = directions[:, 0:1], directions[:, 1:2]  # shape (N, 1), against M walls
        to_x, to_y = begin[:, 0] - origins[:, 0:1], begin[:, 1] - origins[:, 1:2]
        # origin + distance * direction = begin + share * along, solved by Cramer's rule
        determinant = dx * along[:, 1] - dy * along[:, 0]
        with np.errstate(divide="ignore", invalid="ignore"):
            distance = (to_x * along[:, 1] - to_y * along[:, 0]) / determinant
            share = (to_x * dy - to_y * dx) / determinant
            floor = np.where(directions[:, 2] < 0.0, -origins[:, 2] / directions[:, 2], np.inf)
            height = origins[:, 2:3] + distance * directions[:, 2:3]
        is_hit = (np.abs(determinant) > PARALLEL) & (distance > 0.0) & (share >= 0.0) & (share <= 1.0)
        is_hit &= (height >= 0.0) & (height <= self.height)
        nearest = np.where(is_hit, distance, np.inf).min(axis=1)
        return np.minimum(nearest, floor)

    def cells(self, resolution_m: float = 0.05) -> tuple[np.ndarray, tuple[float, float]]:
        """Return the floor plan as a grid of cells, row by row from the lower left corner: true where a wall is.

        Returns:
            shape (height, width), and where its corner is: (x, y) [m].
        """
        ends = np.array(self.walls)  # shape (M, 2, 2)
        corner = ends.min(axis=(0, 1)) - 1.5 * resolution_m  # walls lie in the middle of cells, with one more around
        width, height = np.ceil((ends.max(axis=(0, 1)) - corner) / resolution_m - 1e-6).astype(int) + 1
        grid = np.zeros((height, width), dtype=bool)
        for begin, end in ends:
            steps = int(np.ceil(np.abs(end - begin).max() / resolution_m * 2)) + 1
            columns, rows = ((np.linspace(begin, end, steps) - corner) // resolution_m).astype(int).T
            grid[rows, columns] = True
        return grid, (float(corner[0]), float(corner[1]))

    def is_in_sight(self, eye: Sequence[float], point: Sequence[float]) -> bool:
        """Return whether nothing stands between two points [m]."""
        way = np.subtract(point, eye)
        length = float(np.linalg.norm(way))
        if length == 0.0:
            return True
        return float(self.distances(np.array([eye], dtype=float), np.array([way / length]))[0]) >= length


ROOM = Room(
    walls=(
        *rectangle(-2.0, -3.0, 8.0, 3.0),
        *rectangle(2.3, -0.2, 2.7, 0.2),  # the pillar that the lap goes around
        *rectangle(6.0, 1.6, 6.8, 2.2),  # a crate
    )
)
BALL: Vector3 = (6.5, -1.5, 0.30)  # what the camera looks for, in map [m]


GRAVITY_MPS2 = 9.81


@dataclass(frozen=True, slots=True)
class Laser:
    """A laser that turns to the left, once around in each sweep.

    Attributes:
        mount: `base_footprint_T_laser_frame`.
        sweep_s: duration of a sweep [s].
        sigma_m: standard deviation of a range [m].
    """

    drive: Drive
    room: Room
    mount: Transform
    frame_id: str = "laser_frame"
    rays: int = 360
    sweep_s: float = 0.1
    range_min: float = 0.1
    range_max: float = 12.0
    sigma_m: float = 0.005
    seed: int = 0

    def scan_at(self, stamp_ns: int) -> Scan:
        """Return the sweep that begins at `stamp_ns` [ns], straight behind the robot."""
        increment = 2.0 * math.pi / self.rays
        time_increment_ns = seconds(self.sweep_s) // self.rays
        angles = -math.pi + increment * np.arange(self.rays)
        stamps_ns = stamp_ns + time_increment_ns * np.arange(self.rays, dtype=np.int64)
        rays = np.stack([np.cos(angles), np.sin(angles), np.zeros(self.rays)], axis=1)
        mount = self.mount.matrix()
        x, y, yaw = self.drive.poses_at(stamps_ns).T
        directions = _turned(rays @ mount[:3, :3].T, yaw)
        eyes = _turned(np.tile(mount[:3, 3], (self.rays, 1)), yaw) + np.stack([x, y, np.zeros(self.rays)], axis=1)
        noise = seeded_rng(self.seed, "laser", stamp_ns).standard_normal(self.rays)
        ranges = self.room.distances(eyes, directions) + self.sigma_m * noise
        ranges[(ranges < self.range_min) | (ranges > self.range_max)] = np.inf
        return Scan(
            stamp_ns, self.frame_id, -math.pi, increment, time_increment_ns, self.range_min, self.range_max,
            tuple(ranges.tolist()),
        )  # fmt: skip


@dataclass(frozen=True, slots=True)
class Camera:
    """A camera that finds one object, if it is in the picture and nothing hides it.

    Attributes:
        mount: `base_footprint_T_camera_optical_frame`.
        map_p_object: where the object truly is [m].
        half_view_rad: how far from the middle of the picture it may be.
        sigma_m: standard deviation of each coordinate of the detection [m].
    """

    drive: Drive
    room: Room
    mount: Transform
    map_p_object: Vector3
    frame_id: str = "camera_optical_frame"
    half_view_rad: float = math.radians(35.0)
    range_max: float = 6.0
    sigma_m: float = 0.005
    seed: int = 0

    def detection_at(self, stamp_ns: int) -> Detection | None:
        """Return what the picture taken at `stamp_ns` [ns] shows, or None."""
        map_T_optical = self.drive.pose_at(stamp_ns).transform() @ self.mount
        x, y, z = map_T_optical.inverse().apply(self.map_p_object)
        off_middle = math.atan2(math.hypot(x, y), z)
        if off_middle > self.half_view_rad or math.hypot(x, y, z) > self.range_max:
            return None
        if not self.room.is_in_sight(map_T_optical.translation, self.map_p_object):
            return None
        noise = seeded_rng(self.seed, "camera", stamp_ns).standard_normal(3) * self.sigma_m
        return Detection(stamp_ns, self.frame_id, tuple((np.array([x, y, z]) + noise).tolist()))


@dataclass(frozen=True, slots=True)
class Imu:
    """An imu; `mount` is `base_footprint_T_imu_link`, which may well be upside down."""

    drive: Drive
    mount: Transform
    frame_id: str = "imu_link"
    gyro_bias_radps: float = 0.001
    sigma_radps: float = 0.002
    sigma_mps2: float = 0.02
    seed: int = 0

    def reading_at(self, stamp_ns: int) -> ImuReading:
        """Return what is felt at `stamp_ns` [ns]."""
        speed, yaw_rate = self.drive.twist_at(stamp_ns)
        elapsed_s = (stamp_ns - self.drive.start_ns) / NSEC_PER_SEC
        turned = self.drive.pose_at(stamp_ns).yaw - self.drive.start.yaw + self.gyro_bias_radps * elapsed_s
        noise = seeded_rng(self.seed, "imu", stamp_ns).standard_normal(6)
        imu_R_base = Transform(rotation=self.mount.rotation).inverse()
        # Driving an arc pulls inwards: the speed times the yaw rate, to the left when turning left.
        turn_rate = np.array(imu_R_base.apply((0.0, 0.0, yaw_rate + self.gyro_bias_radps)))
        pull = np.array(imu_R_base.apply((0.0, speed * yaw_rate, GRAVITY_MPS2)))
        return ImuReading(
            stamp_ns,
            self.frame_id,
            (Transform.from_rpy(yaw=turned) @ Transform(rotation=self.mount.rotation)).rotation,
            tuple((turn_rate + self.sigma_radps * noise[:3]).tolist()),
            tuple((pull + self.sigma_mps2 * noise[3:]).tolist()),
        )


def _turned(vectors: np.ndarray, yaw: np.ndarray) -> np.ndarray:
    """Turn each row of `vectors`, shape (N, 3), by its own yaw [rad], shape (N,)."""
    c, s = np.cos(yaw), np.sin(yaw)
    x, y, z = vectors.T
    return np.stack([c * x - s * y, s * x + c * y, z], axis=1)
