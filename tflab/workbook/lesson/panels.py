"""Make the panels that need a robot's model or a buffer.

```
draw_joints({"elbow_joint": -0.6})     the arm at these positions, and its chain of transforms
joints_panel()                         the same, with a slider for each joint
tree_panel(parent_of, "map", "tip")    a tree whose frames can be moved, and tf2's answer
```

A panel that looks something up does so in a fresh buffer each time.
"""

from __future__ import annotations

import logging
import math
from collections.abc import Mapping, Sequence
from logging.handlers import QueueHandler
from queue import SimpleQueue

from tflab.core import LATEST, BufferCore, StampedTransform, Transform, TransformException
from tflab.robots.model import JOINT_TYPES, Joint, joint_transform
from tflab.robots.teaching import teaching_urdf
from tflab.robots.urdf import parse_urdf
from tflab.views import panels, transform_chain
from tflab.views.panels import Panel, Travel
from tflab.views.style import fmt_all
from tflab.views.transform_chain import JointsPicture, Step


def tree_panel(parent_of: Mapping[str, str], target_frame: str, source_frame: str) -> Panel:
    """Return a panel in which a frame can be given another parent, and tf2 be asked."""
    return panels.tree_panel(parent_of, target_frame, source_frame, _answer)


def _answer(edges: Sequence[tuple[str, str]], target_frame: str, source_frame: str) -> tuple[bool, str]:
    """Return what tf2 logs and says: of static edges (parent, child), each a step of 1 m along x, and a question."""
    buffer, logged = BufferCore(), SimpleQueue()
    log = QueueHandler(logged)
    logger = logging.getLogger("tflab.tf2")
    was_propagated, logger.propagate = logger.propagate, False
    logger.addHandler(log)
    try:
        for parent, child in edges:
            step = Transform(translation=(1.0, 0.0, 0.0))
            buffer.set_transform(StampedTransform(parent, child, 1, step), "node", is_static=True)
    finally:
        logger.removeHandler(log)
        logger.propagate = was_propagated
    lines = [logged.get().getMessage() for _ in range(logged.qsize())]
    call = f"lookup_transform('{target_frame}', '{source_frame}', Time())"
    try:
        found = buffer.lookup_transform(target_frame, source_frame, LATEST)
    except TransformException as error:
        return False, "\n".join([*lines, call, f"{type(error).__name__}: {error}".rstrip()])
    return not lines, "\n".join([*lines, call, f"translation {fmt_all(found.transform.translation, digits=1)}"])


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


def steps_of(positions: Mapping[str, float] | None = None) -> list[Step]:
    """Return the joints from base_link to the tip of the arm, at these positions [rad or m]; who is not named, at zero.

    Raises:
        KeyError: the robot has no such joint.
    """
    urdf = teaching_urdf()
    robot = parse_urdf(urdf)
    for name in positions or {}:
        robot.joint(name)
    chain = robot.chain("tcp")
    parents = [joint.parent for joint in chain]
    return [_step(joint, positions or {}, urdf) for joint in chain[parents.index("base_link") :]]


def draw_joints(
    positions: Mapping[str, float] | None = None,
    touched: str = "",
    ghosts: Mapping[str, Sequence[float]] | None = None,
) -> JointsPicture:
    """Draw the arm at these joint positions [rad or m], its dominoes, and the lines of the file of `touched`.

    Args:
        ghosts: wrong places of the tip in `base` (x, y, z) [m], by their name.
    """
    return transform_chain.draw_joints(steps_of(positions), touched, ghosts)


def joints_panel() -> Panel:
    """Return a panel that moves each joint of the arm."""
    robot = parse_urdf(teaching_urdf())
    travels = [_travel(robot.joint(step.joint)) for step in steps_of() if step.position is not None]
    return panels.joints_panel(steps_of, travels)


def _step(joint: Joint, positions: Mapping[str, float], urdf: str) -> Step:
    moves = JOINT_TYPES[joint.type] == 1
    position = positions.get(joint.name, 0.0) if moves else None
    where = joint_transform(joint, position)
    return Step(joint.name, joint.parent, joint.child, where, position, _unit(joint), joint_in_file(urdf, joint.name))


def _travel(joint: Joint) -> Travel:
    low, high = (joint.limit.lower, joint.limit.upper) if joint.limit else (-math.pi, math.pi)
    return Travel(joint.name, low, high, unit=_unit(joint))


def _unit(joint: Joint) -> str:
    return "m" if joint.type == "prismatic" else "rad"
