"""How does our robot's arm move?  Its chain of joints, of its URDF or of another, for the picture and the panel.

```
draw_joints({"elbow_joint": -0.6})     the arm as it stands then, and its dominoes
joints_panel()                         the same, with a slider for each joint
```
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

from tflab.robots.kinematics import joint_transform
from tflab.robots.model import JOINT_TYPES, Joint
from tflab.robots.teaching import teaching_urdf
from tflab.robots.urdf import parse_urdf
from tflab.views import panels, transform_chain
from tflab.views.panels import Panel, Travel
from tflab.views.transform_chain import JointsPicture, Step

from ..paths import read_workbook, workbook_root

__all__ = ["draw_joints", "joint_in_file", "joints_panel", "steps_of"]


def joint_in_file(urdf: str, name: str) -> str:
    """Return the lines of a URDF that say what a joint is.

    Raises:
        KeyError: there is no such joint.
    """
    joint = parse_urdf(urdf).joint(name)
    lines = urdf.splitlines()[joint.line - 1 :]
    end = next((number for number, line in enumerate(lines) if "</joint>" in line), len(lines) - 1)
    indent = min(len(line) - len(line.lstrip()) for line in lines[: end + 1] if line.strip())
    return "\n".join(line[indent:] for line in lines[: end + 1])


def steps_of(
    positions: Mapping[str, float] | None = None, tip: str = "tcp", base: str = "base_link", urdf: str | None = None
) -> list[Step]:
    """Return the joints from `base` to `tip`, as they stand at these positions [rad or m]; who is not named, at zero.

    Raises:
        KeyError: the robot has no such link, or no such joint.
        ValueError: `base` is not on the way from the root to `tip`.
    """
    urdf = teaching_urdf() if urdf is None else urdf
    robot = parse_urdf(urdf)
    for name in positions or {}:
        robot.joint(name)
    chain = robot.chain(tip)
    parents = [joint.parent for joint in chain]
    if robot.link(base).name not in parents:
        raise ValueError(f'"{base}" is not above "{tip}"; above it are {", ".join(parents)}')
    return [_step(joint, positions or {}, urdf) for joint in chain[parents.index(base) :]]


def draw_joints(
    positions: Mapping[str, float] | None = None,
    touched: str = "",
    ghosts: Mapping[str, Sequence[float]] | None = None,
    tip: str = "tcp",
    base: str = "base_link",
    urdf: str | None = None,
) -> JointsPicture:
    """Draw the arm at these joint positions [rad or m], its dominoes, and the lines of the file of `touched`.

    Args:
        ghosts: wrong places of the tip in `base` (x, y, z) [m], by their name.
    """
    return transform_chain.draw_joints(steps_of(positions, tip, base, urdf), touched, ghosts)


def joints_panel(
    positions: Mapping[str, float] | None = None, tip: str = "tcp", base: str = "base_link", urdf: str | None = None
) -> Panel:
    """Return a panel that moves each joint between `base` and `tip`, first standing at `positions` [rad or m].

    It speaks the language of this copy.
    """
    urdf = teaching_urdf() if urdf is None else urdf
    robot = parse_urdf(urdf)
    moving = [step.joint for step in steps_of(positions, tip, base, urdf) if step.position is not None]
    travels = [_travel(robot.joint(name), (positions or {}).get(name, 0.0)) for name in moving]
    language = read_workbook(workbook_root()).language
    return panels.joints_panel(lambda at: steps_of(at, tip, base, urdf), travels, language)


def _step(joint: Joint, positions: Mapping[str, float], urdf: str) -> Step:
    moves = JOINT_TYPES[joint.type] == 1
    position = positions.get(joint.name, 0.0) if moves else None
    where = joint_transform(joint, position)
    return Step(joint.name, joint.parent, joint.child, where, position, _unit(joint), joint_in_file(urdf, joint.name))


def _travel(joint: Joint, start: float) -> Travel:
    low, high = (joint.limit.lower, joint.limit.upper) if joint.limit else (-math.pi, math.pi)
    return Travel(joint.name, low, high, start, _unit(joint))


def _unit(joint: Joint) -> str:
    return "m" if joint.type == "prismatic" else "rad"
