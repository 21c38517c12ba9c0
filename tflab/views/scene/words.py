"""What is in the scene, in words?  For a screen reader, a terminal, and a figure's alternative text.

    3D scene: 2 frames, 1 other thing
      map         frame
      base_link   frame in map: x 1.000 m, y 0.000 m, z 0.000 m; roll 0.0 deg, pitch 0.0 deg, yaw 90.0 deg
      scan        laser scan, 181 points

`draw_...` functions leave the words at what they draw: the property `frame` says
"this is a frame", with its parent, and the property `words` says what else it is.
"""

from __future__ import annotations

from math import degrees

from tflab.core import Transform

from .. import style
from .state import SceneState

__all__ = ["describe", "pose_in_words"]


def describe(state: SceneState) -> str:
    """Return the frames with their parents and poses, then everything else that has a name."""
    frames = state.properties("frame")
    things = state.properties("words")
    path_of = {frame["name"]: path for path, frame in frames.items()}
    lines = [(frame["name"], _frame_in_words(state, path, frame, path_of)) for path, frame in frames.items()]
    lines += [(path.removeprefix("/meshcat/"), words) for path, words in things.items()]
    width = max((len(name) for name, _ in lines), default=0)
    head = f"3D scene: {_counted(len(frames), 'frame')}, {_counted(len(things), 'other thing')}"
    return "\n".join([head] + [f"  {name:<{width}}  {words}" for name, words in lines])


def pose_in_words(pose: Transform) -> str:
    """Return a pose as a person reads it: metres, degrees about the fixed axes."""
    x, y, z = (style.fmt(value, "") for value in pose.translation)
    roll, pitch, yaw = (style.fmt(degrees(angle), "", 1) for angle in pose.rpy())
    return f"x {x} m, y {y} m, z {z} m; roll {roll} deg, pitch {pitch} deg, yaw {yaw} deg"


def _frame_in_words(state: SceneState, path: str, frame: dict, path_of: dict[str, str]) -> str:
    kind = "ghost frame" if frame["ghost"] else "frame"
    scene_T_frame = state.pose(path)
    parent = frame["parent"]
    if parent in path_of:
        return f"{kind} in {parent}: {pose_in_words(state.pose(path_of[parent]).inverse() @ scene_T_frame)}"
    if scene_T_frame == Transform():
        return kind
    return f"{kind} at {pose_in_words(scene_T_frame)}"


def _counted(count: int, what: str) -> str:
    return f"{count} {what}" if count == 1 else f"{count} {what}s"
