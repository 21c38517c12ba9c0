"""Define sensor readings: values with the stamp of their measurement.

    measured at stamp_ns --- processing, network ---> heard at receive_ns
                             (never zero)

The number that matters is the first: where the robot was when the light came in,
not when the computer had finished with it.  These are the counterparts in the engine of
ROS messages; `reading_messages.py` converts them.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from tflab.core import Transform
from tflab.core.quaternions import Quaternion, Vector3

__all__ = ["Detection", "ImuReading", "JointReading", "OdometryReading", "Reading", "Scan"]


@dataclass(frozen=True, slots=True)
class Scan:
    """One sweep of a laser: sensor_msgs/LaserScan.

    Attributes:
        stamp_ns: of the first ray [ns].
        ranges: one for each ray [m]; inf where nothing was hit.
        time_increment_ns: from one ray to the next [ns].
    """

    stamp_ns: int
    frame_id: str
    angle_min: float
    angle_increment: float
    time_increment_ns: int
    range_min: float
    range_max: float
    ranges: tuple[float, ...]

    @property
    def angles(self) -> np.ndarray:
        """Return the direction of each ray about z [rad], shape (N,)."""
        return self.angle_min + self.angle_increment * np.arange(len(self.ranges))

    @property
    def ray_stamps_ns(self) -> np.ndarray:
        """Return when each ray was measured [ns], shape (N,)."""
        return self.stamp_ns + self.time_increment_ns * np.arange(len(self.ranges), dtype=np.int64)

    def points(self) -> np.ndarray:
        """Return where each ray ended, in the laser's axes at that ray's moment [m], shape (N, 3); NaN for inf."""
        ranges = np.where(np.isfinite(self.ranges), self.ranges, np.nan)
        return np.stack([ranges * np.cos(self.angles), ranges * np.sin(self.angles), 0.0 * ranges], axis=1)


@dataclass(frozen=True, slots=True)
class Detection:
    """An object that a camera found: geometry_msgs/PointStamped; `point` [m] in `frame_id`."""

    stamp_ns: int
    frame_id: str
    point: Vector3


@dataclass(frozen=True, slots=True)
class ImuReading:
    """What an imu feels: sensor_msgs/Imu, in the axes of `frame_id`.

    Attributes:
        orientation: (x, y, z, w), from where the robot looked when it was switched on.
        angular_velocity: [rad/s].
        linear_acceleration: [m/s^2]; at rest it points up, away from the pull of the ground.
    """

    stamp_ns: int
    frame_id: str
    orientation: Quaternion
    angular_velocity: Vector3
    linear_acceleration: Vector3


@dataclass(frozen=True, slots=True)
class OdometryReading:
    """Pose and speed by the wheels: nav_msgs/Odometry.

    Attributes:
        pose: `odom_T_base_footprint`.
        speed: forward [m/s].
        yaw_rate: [rad/s].
    """

    stamp_ns: int
    frame_id: str
    child_frame_id: str
    pose: Transform
    speed: float
    yaw_rate: float


@dataclass(frozen=True, slots=True)
class JointReading:
    """Where the joints are [rad or m]: sensor_msgs/JointState; `names` and `positions` go in pairs."""

    stamp_ns: int
    names: tuple[str, ...]
    positions: tuple[float, ...]


class Reading(NamedTuple):
    """One message of a sensor as it arrived.

    Attributes:
        topic: "/scan".
        receive_ns: when it was heard [ns].
        publisher: full name of the node, "/laser_driver".
        value: one of the classes above.
    """

    topic: str
    receive_ns: int
    publisher: str
    value: Scan | Detection | ImuReading | OdometryReading | JointReading
