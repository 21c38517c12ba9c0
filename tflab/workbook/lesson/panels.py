"""Make the panels of the pages in the language of the learner's copy.

```
draw_joints({"elbow_joint": -0.6})     the arm at these positions, and its chain of transforms
joints_panel()                         the same, with a slider for each joint
```

A panel that looks something up does so in a fresh buffer each time.
"""

from __future__ import annotations

import logging
import math
from collections.abc import Mapping, Sequence

from tflab.core import LATEST, BufferCore, StampedTransform, Transform, TransformException
from tflab.robots.model import JOINT_TYPES, Joint, joint_transform
from tflab.robots.teaching import teaching_urdf
from tflab.robots.urdf import parse_urdf
from tflab.views import panels, transform_chain
from tflab.views.clocks import Play
from tflab.views.late_joiner import Sender
from tflab.views.motion_error import Bend, Sight
from tflab.views.panels import Panel, SentencePanel, Travel
from tflab.views.style import fmt_all
from tflab.views.timeline import Ask, Lane
from tflab.views.transform_chain import JointsPicture, Step

from ..paths import read_workbook, workbook_root

__all__ = [
    "cameras_panel",
    "clocks_panel",
    "draw_joints",
    "joins_panel",
    "joint_in_file",
    "joints_panel",
    "latency_panel",
    "mount_panel",
    "rate_panel",
    "rotation_panel",
    "rulers_panel",
    "sentence_panel",
    "steps_of",
    "timeline_panel",
    "tree_panel",
]


def rulers_panel() -> Panel:
    """Return a panel that moves a robot and a thing, and says in which frame the thing's numbers stay the same."""
    return panels.rulers_panel(language=_language())


def rotation_panel(roll_rad: float = 0.0, pitch_rad: float = 0.0, yaw_rad: float = 0.0) -> Panel:
    """Return a panel that turns a robot by roll, pitch and yaw [rad]."""
    return panels.rotation_panel(roll_rad, pitch_rad, yaw_rad, _language())


def cameras_panel(forward_m: float = 2.0, left_m: float = 0.0, up_m: float = 0.0) -> Panel:
    """Return a panel that moves a point in front of a camera, in the body frame and in the optical one."""
    return panels.cameras_panel(forward_m, left_m, up_m, _language())


def mount_panel() -> Panel:
    """Return a panel that turns a laser on its robot, and shows a corner and two wrong answers."""
    return panels.mount_panel(language=_language())


def sentence_panel(poses: Mapping[str, Transform], target_frame: str, source_frame: str) -> SentencePanel:
    """Return a panel in which a question can be chosen in any of its forms."""
    return panels.sentence_panel(poses, target_frame, source_frame, _language())


def tree_panel(parent_of: Mapping[str, str], target_frame: str, source_frame: str) -> Panel:
    """Return a panel in which a frame can be given another parent, and tf2 be asked."""
    return panels.tree_panel(parent_of, target_frame, source_frame, _answer, language=_language())


def joins_panel(senders: Sequence[Sender], join_s: float, until_s: float) -> Panel:
    """Return a panel in which a listener can join earlier or later, and ask for what is stored or not."""
    return panels.joins_panel(senders, join_s, until_s, language=_language())


def latency_panel(sight: Sight | None = None) -> Panel:
    """Return a panel in which a robot's motion and its delay can be changed."""
    return panels.latency_panel(sight, _language())


def timeline_panel(
    target_frame: str, source_frame: str, lanes: Sequence[Lane], ask: Ask, stamp_ns: int | None = None
) -> Panel:
    """Return a panel whose query can be dragged past either end of the buffer."""
    return panels.timeline_panel(target_frame, source_frame, lanes, ask, stamp_ns, _language())


def clocks_panel(play: Play | None = None, played_s: float = 9.0) -> Panel:
    """Return a panel of two nodes' clocks while a bag is played."""
    return panels.clocks_panel(play, played_s, _language())


def rate_panel(bend: Bend | None = None) -> Panel:
    """Return a panel that shows what TF's straight line misses of a bend."""
    return panels.rate_panel(bend, _language())


def _language() -> str:
    """Return the language of this copy."""
    return read_workbook(workbook_root()).language


def _answer(edges: Sequence[tuple[str, str]], target_frame: str, source_frame: str) -> tuple[bool, str]:
    """Return what tf2 logs and says: of static edges (parent, child), each a step of 1 m along x, and a question."""
    buffer, log = BufferCore(), _Lines()
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
    call = f"lookup_transform('{target_frame}', '{source_frame}', Time())"
    try:
        found = buffer.lookup_transform(target_frame, source_frame, LATEST)
    except TransformException as error:
        return False, "\n".join([*log.lines, call, f"{type(error).__name__}: {error}".rstrip()])
    return not log.lines, "\n".join([*log.lines, call, f"translation {fmt_all(found.transform.translation, digits=1)}"])


class _Lines(logging.Handler):
    """Keeps what is logged."""

    def __init__(self) -> None:
        super().__init__()
        self.lines: list[str] = []

    def emit(self, record: logging.LogRecord) -> None:
        self.lines.append(record.getMessage())


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
