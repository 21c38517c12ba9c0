"""Compute the poses of links from joint positions (forward kinematics).

    root_T_tool = root_T_shoulder @ shoulder_T_elbow @ elbow_T_tool

    parent_T_child = origin @ movement(position)      one joint
                     bolted   along or about the axis

A walk down the tree multiplies dominoes.  A joint that mimics another takes its
position from it; a joint that nobody mentions stands at zero.  Limits are not
enforced: a robot that is outside of them must still be drawn where it is.

The field calls this forward kinematics; KDL does it inside robot_state_publisher.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from tflab.core import Transform, quaternions
from tflab.core.quaternions import Quaternion, Vector3

from .model import JOINT_TYPES, Joint, Robot

__all__ = ["all_positions", "joint_transform", "link_poses", "link_transform"]

Position = float | Sequence[float]

NUMBERS_OF = {
    "floating": "seven numbers: x, y, z, qx, qy, qz, qw",
    "planar": "three numbers: x, y [m] and a turn [rad]",
}


def link_poses(robot: Robot, positions: Mapping[str, Position] | None = None) -> dict[str, Transform]:
    """Return `root_T_link` of every link, parents first, for joint positions by name [rad or m].

    Args:
        positions: one number for a revolute, continuous or prismatic joint; (x, y, turn)
            for a planar one; (x, y, z, qx, qy, qz, qw) for a floating one.

    Raises:
        ValueError: a joint that the robot has not got, or a position that does not fit it.
    """
    complete = all_positions(robot, positions or {})
    poses = {robot.root: Transform()}
    for joint in robot.joints:
        poses[joint.child] = poses[joint.parent] @ joint_transform(joint, complete.get(joint.name))
    return poses


def link_transform(
    robot: Robot, target_link: str, source_link: str, positions: Mapping[str, Position] | None = None
) -> Transform:
    """Return `target_T_source` between two links of the robot.

    Raises:
        KeyError: there is no such link.
        ValueError: as for link_poses.
    """
    target, source = robot.link(target_link).name, robot.link(source_link).name
    poses = link_poses(robot, positions)
    return poses[target].inverse() @ poses[source]


def all_positions(robot: Robot, positions: Mapping[str, Position]) -> dict[str, Position]:
    """Return `positions` with those of mimic joints added; one that was given stays as given.

    Raises:
        ValueError: a joint that the robot has not got.
    """
    joints = {joint.name: joint for joint in robot.joints}
    for name in positions:
        if name not in joints:
            raise ValueError(f"robot {robot.name!r} has no joint {name!r}; it has {', '.join(sorted(joints))}")
    complete = dict(positions)
    for joint in robot.joints:
        chain = [joint]
        while chain[-1].name not in complete and chain[-1].mimic is not None:
            chain.append(joints[chain[-1].mimic.joint])
        for follower, leader in zip(reversed(chain[:-1]), reversed(chain[1:]), strict=False):
            mimic = follower.mimic
            complete[follower.name] = mimic.multiplier * complete.get(leader.name, 0.0) + mimic.offset
    return complete


def joint_transform(joint: Joint, position: Position | None = None) -> Transform:
    """Return `parent_T_child` of one joint; None stands for its zero position.

    Raises:
        ValueError: the position does not fit the type of the joint.
    """
    if joint.type == "fixed" or position is None:
        return joint.origin
    return joint.origin @ _movement(joint, _numbers(joint, position))


def _movement(joint: Joint, numbers: tuple[float, ...]) -> Transform:
    x, y, z = joint.axis
    match joint.type:
        case "revolute" | "continuous":
            return Transform(rotation=quaternions.from_axis_angle(joint.axis, numbers[0]))
        case "prismatic":
            return Transform((x * numbers[0], y * numbers[0], z * numbers[0]))
        case "planar":
            return _planar(joint.axis, *numbers)
        case _:  # floating
            return Transform(numbers[:3], quaternions.normalized(numbers[3:]))


def _planar(axis: Vector3, x: float, y: float, turn: float) -> Transform:
    """Slide in the plane square to `axis`, and turn about it.

    URDF does not say which way x and y point in that plane; we tip the x-y plane
    over by the shortest way, so that for the usual axis 0 0 1 they are x and y.
    """
    tip = Transform(rotation=_shortest_turn_of_z_to(axis))
    return tip @ Transform.from_rpy(yaw=turn, translation=(x, y, 0.0)) @ tip.inverse()


def _shortest_turn_of_z_to(axis: Vector3) -> Quaternion:
    x, y, z = axis
    if z < -1.0 + 1e-12:
        return (1.0, 0.0, 0.0, 0.0)  # half a turn about x
    return quaternions.normalized((-y, x, 0.0, 1.0 + z))


def _numbers(joint: Joint, position: Position) -> tuple[float, ...]:
    count = JOINT_TYPES[joint.type]
    try:
        numbers = tuple(map(float, position)) if isinstance(position, Sequence) else (float(position),)
    except (TypeError, ValueError):
        numbers = ()
    if len(numbers) != count:
        wanted = NUMBERS_OF.get(joint.type, "one number")
        raise ValueError(f"joint {joint.name!r} is {joint.type} and takes {wanted}, not {position!r}")
    return numbers
