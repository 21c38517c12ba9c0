"""Define a robot model: links, joints and shapes.

    base_link ---[ joint: origin, axis, type ]---> arm_link
     (parent)                                       (child)

A link is a rigid part and at the same time a frame.  A joint says where its child
is in its parent: first the origin, which never changes, then the movement along or
about the axis.  Every link but one, the root, is the child of exactly one joint.

The field calls this URDF (http://wiki.ros.org/urdf/XML).  All values are frozen.
"""

from __future__ import annotations

from dataclasses import dataclass

from tflab.core import Transform
from tflab.core.quaternions import Vector3

__all__ = [
    "JOINT_TYPES",
    "Box",
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
class Sphere:
    """A sphere around its origin [m]."""

    radius: float


@dataclass(frozen=True, slots=True)
class Mesh:
    """A shape in another file, which is named here and not loaded."""

    filename: str
    scale: Vector3 = (1.0, 1.0, 1.0)


Geometry = Box | Cylinder | Sphere | Mesh


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
