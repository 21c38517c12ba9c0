"""What does a sensor say?  A laser, a camera and an imu, each in its own frame and at its own moment.

    stamp_ns ---> true pose then ---> mounted here ---> what it sees, in its own axes
                  (motion)            (URDF)            (world)

A laser sweeps: every ray has its own time, and a robot that turns while it sweeps
bends the walls.  A camera's detection is written in the optical frame: z forward,
x right, y down (REP-103).  An imu feels the turn and the pull of the ground.

Noise is drawn from the seed and the stamp, so a moment always looks the same.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from tflab.core import NSEC_PER_SEC, Transform, seconds
from tflab.core.quaternions import Vector3

from .chance import chance
from .motion import Drive
from .readings import Detection, ImuReading, Scan
from .world import Room

__all__ = ["GRAVITY_MPS2", "Camera", "Imu", "Laser"]

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
        stamps_ns = stamp_ns + time_increment_ns * np.arange(self.rays)
        rays = np.stack([np.cos(angles), np.sin(angles), np.zeros(self.rays)], axis=1)
        mount = self.mount.matrix()
        x, y, yaw = self.drive.poses_at(stamps_ns).T
        directions = _turned(rays @ mount[:3, :3].T, yaw)
        eyes = _turned(np.tile(mount[:3, 3], (self.rays, 1)), yaw) + np.stack([x, y, np.zeros(self.rays)], axis=1)
        noise = chance(self.seed, "laser", stamp_ns).standard_normal(self.rays)
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
        noise = chance(self.seed, "camera", stamp_ns).standard_normal(3) * self.sigma_m
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
        noise = chance(self.seed, "imu", stamp_ns).standard_normal(6)
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
