"""Define the workbook's robot: two wheels, four sensors and an arm.

    map --localization--> odom --wheel_odometry--> base_footprint --robot_state_publisher--> base_link
                                                                     laser_frame, camera_link, imu_link,
                                                                     wheels, shoulder ... tool0 -> tcp

A TeachingRobot is a pure simulation: ask it for a moment, and it answers from that
moment alone, with no clock, no thread and no ROS.  Three ways to use it:

    robot.buffer(until_s=20.0)     a BufferCore, as a listener would have filled it
    robot.records(until_s=20.0)    every transform as it arrived, for bags and the doctor
    robot.readings(until_s=20.0)   what the sensors said meanwhile

`nodes.py` runs the same robot on ROS, one node for each source.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator, Mapping
from dataclasses import replace
from importlib.resources import files
from typing import NamedTuple

from tflab.core import NSEC_PER_SEC, BufferCore, StampedTransform, Transform, seconds
from tflab.core.quaternions import Vector3
from tflab.core.transforms import TransformRecord

from .model import Robot, joint_transform, link_poses
from .motion import Drive
from .odometry import Localizer, WheelOdometry
from .readings import JointReading, OdometryReading, Reading
from .seeded_rng import seeded_rng
from .sensors import BALL, ROOM, Camera, Imu, Laser, Room
from .urdf import parse_urdf

__all__ = ["SOURCES", "Source", "TeachingRobot", "teaching_urdf"]


class Source(NamedTuple):
    """One node that speaks: how often [Hz], and how long after its stamp it is heard.

    Attributes:
        delay_s: processing, the same for every message [s].
        jitter_s: the network adds between nothing and this [s].
    """

    publisher: str
    rate_hz: float
    delay_s: float
    jitter_s: float


SOURCES: dict[str, Source] = {
    "odometry": Source("wheel_odometry", 20.0, 0.004, 0.002),
    "localization": Source("localization", 10.0, 0.010, 0.004),
    "joints": Source("joint_driver", 20.0, 0.002, 0.001),
    "robot_state": Source("robot_state_publisher", 20.0, 0.004, 0.002),
    "laser": Source("laser_driver", 10.0, 0.105, 0.004),  # a sweep takes 0.1 s
    "camera": Source("object_detector", 5.0, 0.200, 0.010),  # finding things takes time
    "imu": Source("imu_driver", 50.0, 0.002, 0.001),
    "ekf": Source("ekf_filter_node", 30.0, 0.008, 0.002),  # only where a lesson asks for it
}


def teaching_urdf() -> str:
    """Return the robot's URDF, as /robot_description holds it."""
    return (files("tflab.robots") / "data" / "tf_lab_robot.urdf").read_text(encoding="utf-8")


class TeachingRobot:
    """The robot of the workbook.

    Args:
        drive: where it goes; laps around a pillar if None.
        room: what its laser sees.
        ball: what its camera looks for, in map [m].
        sources: how its nodes speak, by the keys of SOURCES; those left out are as in SOURCES.
        urdf: the drawing, which TF repeats; ours if None.  Its root should be `base_footprint`.
        screws: `parent_T_link` of links that are truly bolted on otherwise than the drawing says: sensors measure
            there, and TF does not know.  A sensor that the drawing leaves out sits where ours has it.
        prefix: goes before every frame that is not shared, and before topics and nodes: "robot1/".
        shared: frames without the prefix; with "odom" among them, two robots fight for one frame.
        bias, slip: errors of the wheels; see WheelOdometry.
        correction_period_s: time between two corrections of the localiser [s].
        seed: of everything that happens by chance.
    """

    def __init__(
        self,
        drive: Drive | None = None,
        *,
        room: Room = ROOM,
        ball: Vector3 = BALL,
        sources: Mapping[str, Source] | None = None,
        urdf: str | None = None,
        screws: Mapping[str, Transform] | None = None,
        prefix: str = "",
        shared: Collection[str] = ("map",),
        bias: float = 0.002,
        slip: float = 0.003,
        correction_period_s: float = 2.0,
        seed: int = 0,
    ) -> None:
        self.urdf = teaching_urdf() if urdf is None else urdf
        self.model = parse_urdf(self.urdf, source="tf_lab_robot.urdf" if urdf is None else "the robot's URDF")
        self.built = _bolted(self.model, screws or {})
        self.drive, self.room = drive or Drive(), room
        for frame in shared:
            if frame not in ("map", "odom"):
                raise ValueError(f"{frame!r} is a part of the robot; what robots can share is map and odom")
        self.prefix, self.shared, self.seed = prefix, frozenset(shared), seed
        for key in sources or {}:
            if key not in SOURCES:
                raise ValueError(f"no source {key!r}; the robot has {', '.join(SOURCES)}")
        self.sources = {**SOURCES, **(sources or {})}
        self.odometry = WheelOdometry(self.drive, bias, slip, seed)
        # With an imu that knows the turns, no wheel is too large any more; chance remains, in part.
        self.filtered = WheelOdometry(self.drive, 0.0, slip / 3.0, seed + 1)
        self.localizer = Localizer(self.drive, self.odometry, correction_period_s, seed=seed)
        usual = {} if urdf is None else link_poses(parse_urdf(teaching_urdf()))
        mounts = {**usual, **link_poses(self.built)}
        self.laser = Laser(self.drive, room, mounts["laser_frame"], self.frame("laser_frame"), seed=seed)
        self.camera = Camera(
            self.drive, room, mounts["camera_optical_frame"], ball, self.frame("camera_optical_frame"), seed=seed
        )
        self.imu = Imu(self.drive, mounts["imu_link"], self.frame("imu_link"), seed=seed)

    def frame(self, name: str) -> str:
        """Return the full name of a frame: with the prefix, unless it is shared."""
        return name if name in self.shared else self.prefix + name

    # -- one moment ---------------------------------------------------------

    def joint_positions_at(self, stamp_ns: int) -> dict[str, float]:
        """Return where the joints are [rad]; the arm waves, and keeps within its limits."""
        elapsed_s = (stamp_ns - self.drive.start_ns) / NSEC_PER_SEC
        left, right = self.odometry.wheel_angles_at(stamp_ns)
        return {
            "shoulder_joint": 0.6 * math.sin(2.0 * math.pi * elapsed_s / 8.0),
            "elbow_joint": -0.5 + 0.4 * math.sin(2.0 * math.pi * elapsed_s / 6.0),
            "wrist_joint": 0.3 * math.sin(2.0 * math.pi * elapsed_s / 4.0),
            "left_wheel_joint": left,
            "right_wheel_joint": right,
        }

    def truth_at(self, stamp_ns: int) -> dict[str, Transform]:
        """Return where every link truly is, screws and all: `map_T_link`, by its name in the URDF."""
        map_T_base = self.drive.pose_at(stamp_ns).transform()
        drawn = {joint.name for joint in self.built.moving_joints}
        positions = {name: at for name, at in self.joint_positions_at(stamp_ns).items() if name in drawn}
        poses = link_poses(self.built, positions)
        return {link: map_T_base @ base_T_link for link, base_T_link in poses.items()}

    def map_to_odom_at(self, stamp_ns: int) -> StampedTransform:
        """Return what the localiser publishes."""
        pose = self.localizer.map_T_odom_at(stamp_ns).transform()
        return StampedTransform(self.frame("map"), self.frame("odom"), stamp_ns, pose)

    def odom_to_base_at(self, stamp_ns: int) -> StampedTransform:
        """Return what the wheel odometry publishes."""
        pose = self.odometry.pose_at(stamp_ns).transform()
        return StampedTransform(self.frame("odom"), self.frame("base_footprint"), stamp_ns, pose)

    def joints_at(self, stamp_ns: int) -> list[StampedTransform]:
        """Return what robot_state_publisher makes of the joint positions, in the order of joint names."""
        positions = self.joint_positions_at(stamp_ns)
        moving = sorted(self.model.moving_joints, key=lambda joint: joint.name)
        return [self._joint(joint, positions[joint.name], stamp_ns) for joint in moving if joint.name in positions]

    def mounts(self, stamp_ns: int) -> list[StampedTransform]:
        """Return the static transforms: the fixed joints, in the order of joint names."""
        fixed = sorted((j for j in self.model.joints if j.type == "fixed"), key=lambda joint: joint.name)
        return [self._joint(joint, None, stamp_ns) for joint in fixed]

    def odometry_at(self, stamp_ns: int) -> OdometryReading:
        """Return the wheel odometry as a message has it."""
        return self._odometry_reading(self.odometry, stamp_ns)

    def filtered_at(self, stamp_ns: int) -> OdometryReading:
        """Return what a filter makes of wheels and imu together: it drifts, too, but less, and elsewhere."""
        return self._odometry_reading(self.filtered, stamp_ns)

    def _odometry_reading(self, wheels: WheelOdometry, stamp_ns: int) -> OdometryReading:
        pose = wheels.pose_at(stamp_ns).transform()
        return OdometryReading(
            stamp_ns, self.frame("odom"), self.frame("base_footprint"), pose, *wheels.twist_at(stamp_ns)
        )

    def joint_reading_at(self, stamp_ns: int) -> JointReading:
        """Return the joint positions as a message has them."""
        positions = self.joint_positions_at(stamp_ns)
        return JointReading(stamp_ns, tuple(positions), tuple(positions.values()))

    def _joint(self, joint, position: float | None, stamp_ns: int) -> StampedTransform:
        transform = joint_transform(joint, position)
        return StampedTransform(self.frame(joint.parent), self.frame(joint.child), stamp_ns, transform)

    # -- a stretch of time --------------------------------------------------

    def records(self, until_s: float) -> list[TransformRecord]:
        """Return every transform heard before `until_s` [s], in the order of arrival.  The clock begins at 1 s."""
        start_ns = self.drive.start_ns
        source = self.sources["robot_state"]
        heard_ns = start_ns + seconds(source.delay_s)
        topic, owner = self._topic("tf_static"), self._node(source)
        records = [TransformRecord(topic, heard_ns, owner, mount, True) for mount in self.mounts(start_ns)]
        tellers = {
            "localization": lambda stamp_ns: [self.map_to_odom_at(stamp_ns)],
            "odometry": lambda stamp_ns: [self.odom_to_base_at(stamp_ns)],
            "robot_state": self.joints_at,
        }
        for key, tell in tellers.items():
            owner = self._node(self.sources[key])
            for stamp_ns, heard_ns in self._times(key, until_s):
                records += [TransformRecord(self._topic("tf"), heard_ns, owner, t, False) for t in tell(stamp_ns)]
        records.sort(key=_heard)
        return records

    def readings(self, until_s: float) -> list[Reading]:
        """Return every sensor message heard before `until_s` [s], in the order of arrival."""
        tellers = {
            "joints": ("joint_states", self.joint_reading_at),
            "odometry": ("odom", self.odometry_at),
            "laser": ("scan", self.laser.scan_at),
            "camera": ("detected_point", self.camera.detection_at),
            "imu": ("imu", self.imu.reading_at),
        }
        readings = []
        for key, (topic, tell) in tellers.items():
            topic, owner = self._topic(topic), self._node(self.sources[key])
            for stamp_ns, heard_ns in self._times(key, until_s):
                value = tell(stamp_ns)
                if value is not None:
                    readings.append(Reading(topic, heard_ns, owner, value))
        readings.sort(key=_heard)
        return readings

    def buffer(self, until_s: float, cache_time_s: float = 10.0) -> BufferCore:
        """Return a buffer that has heard everything before `until_s` [s]; authorities are the publishers."""
        buffer = BufferCore(seconds(cache_time_s))
        for record in self.records(until_s):
            buffer.set_transform(record.stamped, record.publisher, record.is_static)
        return buffer

    def _times(self, key: str, until_s: float) -> Iterator[tuple[int, int]]:
        """Yield (stamp_ns, receive_ns) of each message of a source that is heard before `until_s`."""
        source = self.sources[key]
        period_ns, until_ns = seconds(1.0 / source.rate_hz), seconds(until_s)
        rng = seeded_rng(self.seed, key)
        stamp_ns = self.drive.start_ns
        while True:
            heard_ns = stamp_ns + seconds(source.delay_s + source.jitter_s * rng.random())
            if heard_ns >= until_ns:
                return
            yield stamp_ns, heard_ns
            stamp_ns += period_ns

    def _topic(self, name: str) -> str:
        # TF topics are global: every robot's frames are in one tree.
        return f"/{name}" if name in ("tf", "tf_static") else f"/{self.prefix}{name}"

    def _node(self, source: Source) -> str:
        return f"/{self.prefix}{source.publisher}"


def _bolted(drawing: Robot, screws: Mapping[str, Transform]) -> Robot:
    """Return a robot as it is built: as its drawing, but for these links.

    Raises:
        ValueError: the drawing has no such link below another.
    """
    children = {joint.child for joint in drawing.joints}
    for link in screws:
        if link not in children:
            raise ValueError(f"nothing is bolted on as {link!r}; there is {', '.join(sorted(children))}")
    joints = (replace(joint, origin=screws.get(joint.child, joint.origin)) for joint in drawing.joints)
    return replace(drawing, joints=tuple(joints))


def _heard(thing: TransformRecord | Reading) -> int:
    return thing.receive_ns
