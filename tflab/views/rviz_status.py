"""Decide what RViz would show and report, without a picture.

    frames, displays, ask(target, source, stamp)  +  Fixed Frame
        --> Shown: the pose of each thing in the Fixed Frame, or none, and RViz's statuses

RViz transforms everything into the Fixed Frame, each message at its own stamp. What it cannot
transform it leaves out, and reports in the display's status. The texts are those of rviz2
(rviz_common, rviz_default_plugins).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from tflab.core import LATEST, Transform, TransformException

from .scene.drawing import Part

Ask = Callable[[str, str, int], Transform]  # (target_frame, source_frame, stamp_ns), or raises TransformException
SIGNS = {"Ok": "✓", "Warn": "!", "Error": "✗"}  # by level, the worst last


@dataclass(frozen=True, slots=True)
class LaserScan:
    """A scan: the distance of each ray [m], from `angle_min_rad` on, about the z axis of `frame_id`."""

    frame_id: str
    stamp_ns: int
    ranges_m: Sequence[float]
    angle_min_rad: float
    angle_increment_rad: float


@dataclass(frozen=True, slots=True)
class PointCloud2:
    """Points (x, y, z) [m] in `frame_id`."""

    frame_id: str
    stamp_ns: int
    points: Sequence[Sequence[float]]


@dataclass(frozen=True, slots=True)
class Path:
    """Points (x, y, z) [m] in `frame_id`, one after the other."""

    frame_id: str
    stamp_ns: int
    points: Sequence[Sequence[float]]


@dataclass(frozen=True, slots=True)
class MapCells:
    """The middles (x, y) [m] of a map's occupied cells in `frame_id`, and their side [m]."""

    frame_id: str
    stamp_ns: int
    cells: Sequence[Sequence[float]]
    resolution_m: float = 0.05


@dataclass(frozen=True, slots=True)
class RobotModel:
    """A robot's links, by the frame each is bolted to; RViz draws them at the latest moment."""

    links: Mapping[str, Sequence[Part]]


Message = LaserScan | PointCloud2 | Path | MapCells


@dataclass(frozen=True, slots=True)
class Display:
    """One entry of RViz's list: a robot, or the messages of a topic that are on the screen.

    Several messages stay on the screen together, as with RViz's "Decay Time".

    Attributes:
        kind: as in RViz: "RobotModel", "LaserScan", "PointCloud2", "Path" or "Map".
    """

    kind: str
    content: RobotModel | tuple[Message, ...]
    topic: str = ""


class Status(NamedTuple):
    """One line below a display: "Ok", "Warn" or "Error", what it is about, and RViz's words."""

    level: str
    name: str
    text: str


class Shown(NamedTuple):
    """What became of one display.

    Attributes:
        name: as in RViz's list.
        statuses: what it says, in order.
        display: what was to be shown; None for the TF display and the global status.
        poses: `fixed_T_frame` of each frame of TF or link of a robot that has one.
        placed: each message that can be shown, with its `fixed_T_message`.
    """

    name: str
    statuses: tuple[Status, ...]
    display: Display | None = None
    poses: Mapping[str, Transform] = {}
    placed: tuple[tuple[Message, Transform], ...] = ()

    @property
    def title(self) -> str:
        """Its name, and the topic if it has one."""
        return f"{self.name} ({self.display.topic})" if self.display and self.display.topic else self.name

    @property
    def level(self) -> str:
        return max((status.level for status in self.statuses), key=list(SIGNS).index, default="Ok")


def look_through(
    fixed_frame: str, parents: Mapping[str, str], displays: Sequence[Display], ask: Ask
) -> tuple[Shown, ...]:
    """Return what RViz would show with this Fixed Frame: the global status, TF, then each display.

    `parents` holds every known frame with its parent, "" for a root.
    """
    view = _View(fixed_frame, parents, ask)
    return (_global_status(view), _tf(view), *(_shown(view, display) for display in displays))


def statuses_as_text(shown: Sequence[Shown]) -> str:
    """Return RViz's list as lines of text."""
    lines = []
    for entry in shown:
        lines.append(f"{entry.title}: {entry.level}")
        lines += [f"  {status.name}: {status.text}" for status in entry.statuses]
    return "\n".join(lines)


@dataclass(frozen=True, slots=True)
class _View:
    """What every display needs to know."""

    fixed_frame: str
    parents: Mapping[str, str]
    ask: Ask

    def knows(self, frame: str) -> bool:
        return frame in self.parents

    def look_up(self, frame: str, stamp_ns: int) -> Transform | str:
        """Return `fixed_T_frame`, or tf's text why there is none."""
        try:
            return self.ask(self.fixed_frame, frame, stamp_ns)
        except TransformException as no:
            return str(no)


def _global_status(view: _View) -> Shown:
    if view.knows(view.fixed_frame):
        status = Status("Ok", "Fixed Frame", "OK")
    elif view.parents:
        status = Status("Error", "Fixed Frame", f"Frame [{view.fixed_frame}] does not exist")
    else:
        text = f"No tf data.  Actual error: Frame [{view.fixed_frame}] does not exist"
        status = Status("Warn", "Fixed Frame", text)
    return Shown("Global Status", (status,))


def _tf(view: _View) -> Shown:
    poses, statuses = _poses_of(view, sorted(view.parents), "Warn", f"frame [{view.fixed_frame}]")
    return Shown("TF", statuses, poses=poses)


def _shown(view: _View, display: Display) -> Shown:
    if isinstance(display.content, RobotModel):
        return _robot(view, display, display.content)
    return _messages(view, display, display.content)


def _robot(view: _View, display: Display, robot: RobotModel) -> Shown:
    poses, statuses = _poses_of(view, robot.links, "Error", f"[{view.fixed_frame}]")
    return Shown(display.kind, (Status("Ok", "URDF", "URDF parsed OK"), *statuses), display, poses)


def _poses_of(
    view: _View, frames: Iterable[str], level: str, target: str
) -> tuple[dict[str, Transform], tuple[Status, ...]]:
    """Return the latest pose of each frame that has one, and a status of each; `level` where there is none."""
    found = {frame: view.look_up(frame, LATEST) for frame in frames}
    poses = {frame: pose for frame, pose in found.items() if isinstance(pose, Transform)}
    statuses = (
        Status("Ok", frame, "Transform OK")
        if frame in poses
        else Status(level, frame, f"No transform from [{frame}] to {target}")
        for frame in found
    )
    return poses, tuple(statuses)


def _messages(view: _View, display: Display, messages: tuple[Message, ...]) -> Shown:
    if not messages:
        return Shown(display.kind, (Status("Warn", "Topic", "No messages received"),), display)
    answers = [(message, view.look_up(message.frame_id, message.stamp_ns)) for message in messages]
    placed = tuple((message, pose) for message, pose in answers if isinstance(pose, Transform))
    refused = [(message, text) for message, text in answers if isinstance(text, str)]
    statuses = [Status("Ok", "Topic", f"{len(messages)} messages received")]
    if display.kind in ("LaserScan", "PointCloud2"):
        points = sum(len(points_of(message)) for message, _ in placed)
        statuses.append(Status("Ok", "Points", f"Showing [{points}] points from [{len(placed)}] messages"))
    if refused:
        message, text = refused[-1]
        statuses.append(Status("Error", "Transform", _why_not(view, message, text)))
    else:
        statuses.append(Status("Ok", "Transform", "Ok"))
    return Shown(display.kind, tuple(statuses), display, placed=placed)


def _why_not(view: _View, message: Message, tf_error: str) -> str:
    if isinstance(message, (MapCells, Path)):
        return f"Could not transform from [{message.frame_id}] to [{view.fixed_frame}]"
    if not view.knows(view.fixed_frame):
        return f"For frame [{message.frame_id}]: Fixed Frame [{view.fixed_frame}] does not exist"
    if not view.knows(message.frame_id):
        return f"For frame [{message.frame_id}]: Frame [{message.frame_id}] does not exist"
    return f"No transform to fixed frame [{view.fixed_frame}]. TF error: [{tf_error}]"


def points_of(message: Message) -> np.ndarray:
    """Return what a message shows, in its own frame, shape (n, 3) [m]; rays that hit nothing are left out."""
    if isinstance(message, LaserScan):
        ranges = np.asarray(message.ranges_m, dtype=float)
        angles = message.angle_min_rad + message.angle_increment_rad * np.arange(len(ranges))
        hit = np.isfinite(ranges)
        x, y = ranges[hit] * np.cos(angles[hit]), ranges[hit] * np.sin(angles[hit])
        return np.column_stack([x, y, np.zeros(len(x))])
    if isinstance(message, MapCells):
        cells = np.asarray(message.cells, dtype=float).reshape(-1, 2)
        return np.column_stack([cells, np.zeros(len(cells))])
    return np.asarray(message.points, dtype=float).reshape(-1, 3)
