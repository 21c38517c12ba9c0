"""Read a URDF into a robot model, or report what is wrong with it and where.

    robot.urdf  -->  elements with lines  -->  links, joints  -->  one tree  -->  Robot
                      (xml_lines)               numbers, names      root, no loop

Files from the field are read with patience: unknown elements and prefixes are
passed over, an axis of zeros on a joint that does not move harms nobody.  What
cannot mean anything is an error that names the file, the line and the joint.
Between the two are `Robot.notes`: odd, but readable.  URDF after 1.0 is read as the
ROS 2 release reads it.

A robot is published by `state_publisher.py`.
"""

from __future__ import annotations

import difflib
import math
import re
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from pathlib import Path

from tflab.core import Transform
from tflab.core.quaternions import Vector3, normalized
from tflab.ros import distro

from .model import (
    JOINT_TYPES,
    Box,
    Capsule,
    Cylinder,
    Geometry,
    Joint,
    Limit,
    Link,
    Material,
    Mesh,
    Mimic,
    Robot,
    Shape,
    Sphere,
    parents_first,
)
from .xml_lines import Element, XmlFault, float_from, read_xml

__all__ = ["UrdfError", "parse_urdf"]

NO_AXIS_NEEDED = ("fixed", "floating")
XACRO_EXPRESSION = re.compile(r"\$[({]")


class UrdfError(ValueError):
    """A URDF that does not describe a robot.

    Attributes:
        source: name of the file, or what stands in for it.
        line: counted from 1; 0 if it is about the whole file.
        joint: name of the joint at fault, "" if it is not about one.
    """

    def __init__(self, message: str, source: str, line: int = 0, joint: str = "") -> None:
        message = " ".join(message.splitlines())  # names may hold anything, an error is one line
        place = f"{source}:{line}" if line else source
        super().__init__(f'{place}: joint "{joint}": {message}' if joint else f"{place}: {message}")
        self.source, self.line, self.joint = source, line, joint


def parse_urdf(text: str | bytes, source: str = "robot_description") -> Robot:
    """Return the robot that a text describes; errors call it `source`.

    Raises:
        UrdfError: it describes no robot.
    """
    try:
        root = read_xml(text)
    except XmlFault as fault:
        raise UrdfError(str(fault), source, fault.line) from None
    return _Reader(source).robot(root)


@dataclass(slots=True)
class _Reader:
    """Reads one file; knows its name for errors, and collects what was odd."""

    source: str
    notes: list[str] = field(default_factory=list)
    materials: dict[str, Material] = field(default_factory=dict)
    minor: int = 0  # the file is URDF 1.minor

    # -- the whole ----------------------------------------------------------

    def robot(self, root: Element) -> Robot:
        if root.tag != "robot":
            raise self.error(f"a URDF begins with <robot>, this file with <{root.tag}>{_foreign(root.tag)}", root)
        self.refuse_xacro(root)
        self.minor = self.minor_version(root)
        name = self.text(root, "name", "a <robot>")
        for element in root.all("material"):
            material = self.material(element)
            self.materials[material.name] = material
        links = self.unique([self.link(element) for element in root.all("link")], "link")
        joints = self.unique([self.joint(element) for element in root.all("joint")], "joint")
        if not links:
            raise self.error(f'robot "{name}" has no <link>', root)
        self.check_links_exist(joints, links)
        joint_to = self.joints_by_child(joints)
        top = self.only_root(links, joint_to)
        self.check_mimics(joints)
        return Robot(
            name, tuple(links.values()), parents_first(top, joints.values()), top,
            tuple(self.materials.values()), tuple(self.notes),
        )  # fmt: skip

    def minor_version(self, root: Element) -> int:
        """Return the digits after "1." of the file's version, or raise about one that the release does not read."""
        version, newest = root.attributes.get("version", "1.0"), distro.current().urdf_minor
        major, _, minor = version.partition(".")
        if major != "1" or not minor.isdecimal() or int(minor) > newest:
            known = f"{'versions 1.0 to' if newest else 'version'} 1.{newest} {'are' if newest else 'is'}"
            refusal = f"Invalid 'version' specified; only {known} currently supported"
            raise self.error(f'{refusal} in ROS 2 {distro.current().name}, not "{version}"', root)
        return int(minor)

    def refuse_xacro(self, root: Element) -> None:
        """Raise if macros were left in: they would become frames with names such as `${prefix}base_link`."""
        name = Path(self.source).name
        advice = f"this is xacro, not yet URDF. Expand it first: xacro {name} > expanded.urdf"
        for child in root.children:
            for element in child.walk() if child.tag in ("link", "joint", "material") else (child,):
                if element.tag.startswith("xacro:"):
                    raise self.error(f"<{element.tag}>: {advice}", element)
                for value in element.attributes.values():
                    if XACRO_EXPRESSION.search(value):
                        raise self.error(f'"{value}": {advice}', element)

    def unique(self, things: Iterable[Link] | Iterable[Joint], what: str) -> dict:
        """Return things by name, or raise about the second of a name."""
        by_name: dict = {}
        for thing in things:
            first = by_name.setdefault(thing.name, thing)
            if first is not thing:
                joint = thing.name if what == "joint" else ""
                raise UrdfError(
                    f'a second {what} of the name "{thing.name}"; the first is in line {first.line}. '
                    "Every name may be used once",
                    self.source, thing.line, joint,
                )  # fmt: skip
        return by_name

    # -- the tree -----------------------------------------------------------

    def check_links_exist(self, joints: dict[str, Joint], links: dict[str, Link]) -> None:
        for joint in joints.values():
            for role, link in (("parent", joint.parent), ("child", joint.child)):
                if link not in links:
                    raise self.joint_error(f'its {role} link "{link}" does not exist{_closest(link, links)}', joint)
            if joint.parent == joint.child:
                raise self.joint_error(f'joins link "{joint.parent}" to itself', joint)

    def joints_by_child(self, joints: dict[str, Joint]) -> dict[str, Joint]:
        by_child: dict[str, Joint] = {}
        for joint in joints.values():
            other = by_child.setdefault(joint.child, joint)
            if other is not joint:
                raise self.joint_error(
                    f'link "{joint.child}" already is the child of joint "{other.name}" (line {other.line}): '
                    "a link has one parent",
                    joint,
                )
        return by_child

    def only_root(self, links: dict[str, Link], joint_to: dict[str, Joint]) -> str:
        """Return the one link without a parent, or raise: none, several, or a separate loop."""
        self.refuse_loops(links, joint_to)
        roots = [link for link in links.values() if link.name not in joint_to]
        if len(roots) > 1:
            named = ", ".join(f'"{link.name}" (line {link.line})' for link in roots)
            raise UrdfError(
                f"{len(roots)} root links: {named}. All but one of them must be the child of a joint",
                self.source, roots[1].line,
            )  # fmt: skip
        return roots[0].name

    def refuse_loops(self, links: dict[str, Link], joint_to: dict[str, Joint]) -> None:
        """Raise if the way up from some link comes back to where it was."""
        cleared: set[str] = set()
        for link in links:
            way: dict[str, None] = {}
            while link in joint_to and link not in cleared:
                if link in way:
                    upwards = list(way)[list(way).index(link) :]
                    loop = " -> ".join([link, *reversed(upwards)])
                    raise self.joint_error(f"closes a loop of links: {loop}. A robot is a tree", joint_to[link])
                way[link] = None
                link = joint_to[link].parent
            cleared.update(way)

    def check_mimics(self, joints: dict[str, Joint]) -> None:
        for joint in joints.values():
            followed = [joint.name]
            while (mimic := joints[followed[-1]].mimic) is not None:
                if mimic.joint not in joints:
                    raise self.joint_error(
                        f'mimics joint "{mimic.joint}", which does not exist{_closest(mimic.joint, joints)}',
                        joints[followed[-1]],
                    )
                if JOINT_TYPES[joints[mimic.joint].type] > 1:
                    raise self.joint_error(
                        f'mimics joint "{mimic.joint}", which is {joints[mimic.joint].type} and has no single position',
                        joints[followed[-1]],
                    )
                if mimic.joint in followed:
                    raise self.joint_error(
                        f"mimics itself: {' -> '.join([*followed, mimic.joint])}", joints[followed[-1]]
                    )
                followed.append(mimic.joint)

    # -- the parts ----------------------------------------------------------

    def link(self, element: Element) -> Link:
        name = self.text(element, "name", "a <link>")
        return Link(
            name,
            tuple(self.shape(child, with_material=True) for child in element.all("visual")),
            tuple(self.shape(child, with_material=False) for child in element.all("collision")),
            element.first("inertial") is not None,
            element.line,
        )

    def joint(self, element: Element) -> Joint:
        name = self.text(element, "name", "a <joint>")
        kind = self.text(element, "type", f'joint "{name}"', name)
        if kind not in JOINT_TYPES:
            raise self.error(f'type "{kind}" is none of {", ".join(JOINT_TYPES)}', element, name)
        limit, mimic = element.first("limit"), element.first("mimic")
        if kind in ("revolute", "prismatic") and limit is None:
            self.notes.append(
                f'line {element.line}: joint "{name}" is {kind} and has no <limit>; ROS refuses such a file'
            )
        return Joint(
            name,
            kind,
            self.end_of(element, "parent", name),
            self.end_of(element, "child", name),
            self.origin(element, name),
            self.axis(element, kind, name),
            self.limit(limit, name) if limit is not None else None,
            self.mimic(mimic, name) if mimic is not None else None,
            element.line,
        )

    def end_of(self, element: Element, role: str, joint: str) -> str:
        end = element.first(role)
        if end is None:
            raise self.error(f'has no <{role} link="..."/>', element, joint)
        return self.text(end, "link", f'the <{role}> of joint "{joint}"', joint)

    def origin(self, element: Element, joint: str = "") -> Transform:
        origin = element.first("origin")
        if origin is None:
            return Transform()
        xyz = self.numbers(origin, "xyz", 3, (0.0, 0.0, 0.0), joint)
        if "quat_xyzw" in origin.attributes and self.minor:
            if "rpy" in origin.attributes or not any(rotation := self.numbers(origin, "quat_xyzw", 4, None, joint)):
                raise self.error("needs either rpy or quat_xyzw, and a quaternion has a length", origin, joint)
            return Transform(xyz, normalized(rotation))
        if "quat_xyzw" in origin.attributes:
            self.notes.append(
                f"line {origin.line}: quat_xyzw is ignored: it requires URDF version 1.1, this file is 1.0"
            )
        return Transform.from_rpy(*self.numbers(origin, "rpy", 3, (0.0, 0.0, 0.0), joint), xyz)

    def axis(self, element: Element, kind: str, joint: str) -> Vector3:
        """Return the unit axis; (1, 0, 0) if none is written, as the URDF rules say."""
        written = element.first("axis")
        if written is None:
            return (1.0, 0.0, 0.0)
        axis = self.numbers(written, "xyz", 3, (1.0, 0.0, 0.0), joint)
        length = math.hypot(*axis)
        if length > 0.0:
            return tuple(part / length for part in axis)
        if kind in NO_AXIS_NEEDED:
            return (0.0, 0.0, 0.0)
        raise self.error(f"axis 0 0 0 has no direction, and a {kind} joint needs one, such as 0 0 1", written, joint)

    def limit(self, element: Element, joint: str) -> Limit:
        lower, upper, effort, velocity = (
            self.number(element, key, 0.0, joint, may_be_infinite=True)
            for key in ("lower", "upper", "effort", "velocity")
        )
        if lower > upper:
            self.notes.append(f'line {element.line}: joint "{joint}" has lower limit {lower:g} above upper {upper:g}')
        return Limit(lower, upper, effort, velocity)

    def mimic(self, element: Element, joint: str) -> Mimic:
        followed = self.text(element, "joint", f'the <mimic> of joint "{joint}"', joint)
        multiplier = self.number(element, "multiplier", 1.0, joint)
        return Mimic(followed, multiplier, self.number(element, "offset", 0.0, joint))

    def shape(self, element: Element, with_material: bool) -> Shape:
        geometry = element.first("geometry")
        if geometry is None or not geometry.children:
            raise self.error(f"a <{element.tag}> without <geometry>: box, cylinder, sphere or mesh", element)
        material = element.first("material") if with_material else None
        return Shape(
            self.geometry(geometry.children[0]),
            self.origin(element),
            self.material_of(material) if material is not None else None,
            element.attributes.get("name", ""),
        )

    def geometry(self, element: Element) -> Geometry:
        readers: dict[str, Callable[[Element], Geometry]] = {
            "box": lambda e: Box(self.numbers(e, "size", 3)),
            "cylinder": lambda e: Cylinder(self.number(e, "radius"), self.number(e, "length")),
            "sphere": lambda e: Sphere(self.number(e, "radius")),
            "capsule": lambda e: Capsule(self.number(e, "radius"), self.number(e, "length")),
            "mesh": lambda e: Mesh(self.text(e, "filename", "a <mesh>"), self.numbers(e, "scale", 3, (1.0, 1.0, 1.0))),
        }
        known = [tag for tag in readers if self.minor or tag != "capsule"]
        if element.tag not in known:
            raise self.error(f"unknown geometry <{element.tag}>; URDF 1.{self.minor} has {', '.join(known)}", element)
        return readers[element.tag](element)

    def material(self, element: Element) -> Material:
        color, texture = element.first("color"), element.first("texture")
        return Material(
            element.attributes.get("name", ""),
            self.numbers(color, "rgba", 4) if color is not None else None,
            self.text(texture, "filename", "a <texture>") if texture is not None else "",
        )

    def material_of(self, element: Element) -> Material:
        """Return a visual's material; one that only has a name is looked up among the robot's."""
        material = self.material(element)
        if material.rgba is not None or material.texture:
            return material
        if material.name not in self.materials:
            self.notes.append(f'line {element.line}: material "{material.name}" has no colour here and is not defined')
        return self.materials.get(material.name, material)

    # -- words and numbers --------------------------------------------------

    def text(self, element: Element, key: str, what: str, joint: str = "") -> str:
        value = element.attributes.get(key, "")
        if not value:
            raise self.error(f'{what} needs a {key}="..."', element, joint)
        return value

    def number(
        self, element: Element, key: str, default: float | None = None, joint: str = "", may_be_infinite: bool = False
    ) -> float:
        fallback = None if default is None else (default,)
        return self.numbers(element, key, 1, fallback, joint, may_be_infinite)[0]

    def numbers(
        self, element: Element, key: str, count: int, default: tuple[float, ...] | None = None, joint: str = "",
        may_be_infinite: bool = False,
    ) -> tuple[float, ...]:  # fmt: skip
        """Return the `count` numbers of an attribute, separated by spaces."""
        written = element.attributes.get(key)
        if written is None:
            if default is None:
                raise self.error(f'<{element.tag}> needs a {key}="..."', element, joint)
            return default
        values = tuple(map(float_from, written.split()))
        if len(values) != count or None in values or not (may_be_infinite or all(map(math.isfinite, values))):
            wanted = "one number" if count == 1 else f"{count} numbers with spaces between"
            raise self.error(f'bad number: <{element.tag}> {key}="{written}" should be {wanted}', element, joint)
        return values

    def error(self, message: str, element: Element, joint: str = "") -> UrdfError:
        return UrdfError(message, self.source, element.line, joint)

    def joint_error(self, message: str, joint: Joint) -> UrdfError:
        return UrdfError(message, self.source, joint.line, joint.name)


def _foreign(tag: str) -> str:
    return ". That is SDF, Gazebo's own format" if tag == "sdf" else ""


def _closest(name: str, known: Iterable[str]) -> str:
    close = difflib.get_close_matches(name, list(known), n=1)
    return f'. Did you mean "{close[0]}"?' if close else ""
