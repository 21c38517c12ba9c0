"""Define a robot model of links, joints and shapes, and compute link poses from joint positions.

    base_link ---[ joint: origin, axis, type ]---> arm_link
     (parent)                                       (child)

    parent_T_child = origin @ movement(position)           one joint
    root_T_tool = root_T_shoulder @ shoulder_T_elbow @ elbow_T_tool

A link is a rigid part and a frame. A joint gives the pose of its child in its parent:
the fixed origin, then the movement along or about the axis. Every link but the root is
the child of one joint. A joint that mimics another takes its position from it; a joint
without a position is at zero. Limits are not enforced.

The format is URDF (http://wiki.ros.org/urdf/XML); the computation is called forward
kinematics. All values are frozen.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

from tflab.core import Transform, quaternions
from tflab.core.quaternions import Quaternion, Vector3

__all__ = [
    "JOINT_TYPES",
    "Box",
    "Capsule",
    "Cylinder",
    "Geometry",
    "Joint",
    "Limit",
    "Link",
    "Material",
    "Mesh",
    "Mimic",
    "Robot",
    "Shape",
    "Sphere",
    "all_positions",
    "joint_transform",
    "link_poses",
    "parents_first",
]


# How many numbers describe a joint of each type.
JOINT_TYPES = {"revolute": 1, "continuous": 1, "prismatic": 1, "fixed": 0, "floating": 7, "planar": 3}

AT_PARENT = Transform()


@dataclass(frozen=True, slots=True)
class Box:
    """A box around its origin: full lengths [m] along x, y, z."""

    size: Vector3


@dataclass(frozen=True, slots=True)
class Cylinder:
    """A cylinder around its origin, its axis along z [m]."""

    radius: float
    length: float


@dataclass(frozen=True, slots=True)
class Capsule:
    """A cylinder with a hemisphere at each end; `length` is the cylinder's [m]."""

    radius: float
    length: float


@dataclass(frozen=True, slots=True)
class Sphere:
    """A sphere around its origin [m]."""

    radius: float


@dataclass(frozen=True, slots=True)
class Mesh:
    """A shape in another file, which is named here and not loaded."""

    filename: str
    scale: Vector3 = (1.0, 1.0, 1.0)


Geometry = Box | Capsule | Cylinder | Sphere | Mesh


@dataclass(frozen=True, slots=True)
class Material:
    """A colour (red, green, blue, alpha, each in [0, 1]) or the name of a picture, or only a name."""

    name: str
    rgba: tuple[float, float, float, float] | None = None
    texture: str = ""


@dataclass(frozen=True, slots=True)
class Shape:
    """Something to draw, or to bump into, on a link.

    Attributes:
        origin: `link_T_shape`.
        material: None for a collision shape, or if the file names none.
    """

    geometry: Geometry
    origin: Transform
    material: Material | None = None
    name: str = ""


@dataclass(frozen=True, slots=True)
class Link:
    """A rigid part, and the frame that is bolted to it."""

    name: str
    visuals: tuple[Shape, ...] = ()
    collisions: tuple[Shape, ...] = ()
    has_inertia: bool = False
    line: int = 0


@dataclass(frozen=True, slots=True)
class Limit:
    """How far [rad or m], how hard [Nm or N] and how fast [rad/s or m/s] a joint may move."""

    lower: float = 0.0
    upper: float = 0.0
    effort: float = 0.0
    velocity: float = 0.0


@dataclass(frozen=True, slots=True)
class Mimic:
    """This joint follows another: position = multiplier * other + offset."""

    joint: str
    multiplier: float = 1.0
    offset: float = 0.0


@dataclass(frozen=True, slots=True)
class Joint:
    """Where a child link is in its parent link.

    Attributes:
        type: a key of JOINT_TYPES.
        origin: `parent_T_child` at position zero.
        axis: unit vector in the child's axes at position zero: what a revolute joint
            turns about, a prismatic one slides along, a planar one is square to.
        line: where the file says so, counted from 1.
    """

    name: str
    type: str
    parent: str
    child: str
    origin: Transform = AT_PARENT
    axis: Vector3 = (1.0, 0.0, 0.0)
    limit: Limit | None = None
    mimic: Mimic | None = None
    line: int = 0


@dataclass(frozen=True, slots=True)
class Robot:
    """A tree of links.

    Attributes:
        links: in the order of the file.
        joints: parents before their children, otherwise in the order of the file.
        root: name of the link that is nobody's child.
        notes: what was odd about the file but not wrong; one sentence each.
    """

    name: str
    links: tuple[Link, ...]
    joints: tuple[Joint, ...]
    root: str
    materials: tuple[Material, ...] = ()
    notes: tuple[str, ...] = ()

    def link(self, name: str) -> Link:
        """Return the link of that name, or raise KeyError naming those that exist."""
        return _named(self.links, name, f"robot {self.name!r} has no link")

    def joint(self, name: str) -> Joint:
        """Return the joint of that name, or raise KeyError naming those that exist."""
        return _named(self.joints, name, f"robot {self.name!r} has no joint")

    def chain(self, link: str) -> tuple[Joint, ...]:
        """Return the joints on the way from the root to `link`."""
        self.link(link)
        joint_to = {joint.child: joint for joint in self.joints}
        upwards = []
        while link in joint_to:
            upwards.append(joint_to[link])
            link = joint_to[link].parent
        return tuple(reversed(upwards))

    @property
    def moving_joints(self) -> tuple[Joint, ...]:
        """The joints that a JointState can move: one number each, mimics included."""
        return tuple(joint for joint in self.joints if JOINT_TYPES[joint.type] == 1)


def _named(things: tuple, name: str, complaint: str):
    for thing in things:
        if thing.name == name:
            return thing
    raise KeyError(f"{complaint} {name!r}; it has {', '.join(sorted(thing.name for thing in things))}")


Position = float | Sequence[float]

NUMBERS_OF = {
    "floating": "seven numbers: x, y, z, qx, qy, qz, qw",
    "planar": "three numbers: x, y [m] and a turn [rad]",
}


def parents_first(root: str, joints: Iterable[Joint]) -> tuple[Joint, ...]:
    """Return the joints in the order in which a walk down from the root meets them."""
    below: dict[str, list[Joint]] = {}
    for joint in joints:
        below.setdefault(joint.parent, []).append(joint)
    ordered: list[Joint] = []
    waiting = list(reversed(below.get(root, [])))
    while waiting:
        joint = waiting.pop()
        ordered.append(joint)
        waiting.extend(reversed(below.get(joint.child, [])))
    return tuple(ordered)


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
