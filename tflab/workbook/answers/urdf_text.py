"""Compare two URDFs: the same if each link has the same parent, mounting and kind of motion.

    <joint name="head" type="revolute"> ... </joint>      the joints alone, or the whole <robot>
        --> for each link that is asked for:  root, parent, kind of joint, parent_T_link at every setting

Which order, which spaces, how many digits and which names of links' shapes do not
matter.  Each link has credit of its own, because it is looked at from its parent.
A text that is no robot is told why, in the words of the reader of URDFs.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache
from itertools import product

from tflab.core import Transform
from tflab.robots.model import Joint, Robot, joint_transform
from tflab.robots.urdf import UrdfError, parse_urdf

from ...text import Text
from .form import Form, Mark, Probe, Row
from .values import Plain

__all__ = ["Urdf"]

LONGEST = 20_000  # characters
SOURCE = "your URDF"
KINDS = {"revolute": "turns", "continuous": "turns", "prismatic": "slides"}
DECLARED = re.compile(r"""<link\s+name\s*=\s*["']([^"']*)["']""")


@dataclass(frozen=True)
class Urdf(Form):
    """A robot, as the text of a URDF, or as its joints alone.

    Attributes:
        links: those that are asked for, each with credit of its own.
        root: the link on which all of them hang, at some distance.
        joint: the joint that is moved.
        settings: where it is looked at [rad or m].
    """

    links: tuple[str, ...]
    root: str = "base_link"
    joint: str = ""
    settings: tuple[float, ...] = (0.0,)
    tolerance_m: float = 1e-3
    tolerance_rad: float = 1e-3

    def probes(self, plain: Plain) -> list[Probe] | None:
        if not isinstance(plain, str) or self.fault(plain):
            return None
        return _probes(self, plain)

    def wanted(self) -> Text:
        names = ", ".join(self.links)
        return Text(en=f"a URDF as a str, with {names}", ko=f"URDF 문자열({names} 포함)")

    def fault(self, plain: Plain) -> str:
        """Return why a text is no robot, or "" if it is one, or no text at all."""
        if not isinstance(plain, str):
            return ""
        if len(plain) > LONGEST:
            return f"{len(plain)} characters; {LONGEST} are enough for this robot"
        read = _robot(self.whole(plain))
        return str(read) if isinstance(read, UrdfError) else ""

    def whole(self, text: str) -> str:
        """Return the text as a whole robot; joints alone get the links that they need, and keep their lines."""
        text = text.strip("\n")
        if "<robot" in text:
            return text.strip()
        declared = set(DECLARED.findall(text))
        links = "".join(f'<link name="{link}"/>' for link in (self.root, *self.links) if link not in declared)
        return f'<robot name="answer">{text}{links}</robot>'

    def link(self, robot: Robot, joint_to: Mapping[str, Joint], link: str) -> Probe:
        """Return the equal ways to write where a link is: each rotation has two signs."""
        joint = joint_to.get(link)
        above = {joint.parent for joint in robot.chain(link)} if joint else set()
        root = self.root if self.root in above else robot.root  # a link above the root changes nothing
        head: Row = (Mark(f"root {root}"), Mark(_hangs(joint)))
        if joint is None:
            return [head]
        positions = self.settings if joint.name == self.joint else (0.0,) * len(self.settings)
        if joint.type == "fixed":
            positions = (None,) * len(self.settings)
        poses = [self._pose(joint_transform(joint, position)) for position in positions]
        return [head + tuple(mark for row in rows for mark in row) for rows in product(*poses)]

    def _pose(self, pose: Transform) -> list[Row]:
        place = tuple(Mark(number, self.tolerance_m) for number in pose.translation)
        return [
            place + tuple(Mark(sign * number, self.tolerance_rad / 2.0) for number in pose.rotation)
            for sign in (1.0, -1.0)
        ]

    def names(self) -> tuple[str, ...]:
        return self.links


@lru_cache(maxsize=2000)  # hundreds of mistakes are compared with each other when a task is built
def _robot(text: str) -> Robot | UrdfError:
    try:
        return parse_urdf(text, SOURCE)
    except UrdfError as error:
        return error


@lru_cache(maxsize=2000)
def _probes(form: Urdf, text: str) -> list[Probe]:
    robot = _robot(form.whole(text))
    joint_to = {joint.child: joint for joint in robot.joints}
    return [form.link(robot, joint_to, link) for link in form.links]


def _hangs(joint: Joint | None) -> str:
    return "on nothing" if joint is None else f"{KINDS.get(joint.type, joint.type)} on {joint.parent}"
