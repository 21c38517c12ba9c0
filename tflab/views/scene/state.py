"""Store a 3D scene as the shortest list of meshcat commands that rebuilds it, and describe it in text.

    set_transform  robot   (1, 0, 0)      \\
    set_transform  robot   (2, 0, 0)       >   set_object     robot   box
    set_object     robot   box            /    set_transform  robot   (2, 0, 0)

Each command has a subject, such as "the transform of robot"; only the last command on a subject
counts. A browser that opens the page later, or has no kernel, replays this list. Commands are
dictionaries, as meshcat's `lower()` makes them, packed with MessagePack.

For `describe`, the `draw_...` functions set two properties: `frame` on a frame, with its parent,
and `words` on anything else.
"""

from __future__ import annotations

import struct
from collections.abc import Iterable, Mapping
from math import degrees
from typing import Any, NamedTuple

import numpy as np

from tflab.core import Transform

from .. import style

AT_THE_END = ("set_animation", "sweep")  # they refer to objects, which must be there first
ID_KEYS = ("uuid", "geometry", "material", "map", "image")
LASTING = ("frame", "labels", "words")  # properties that nothing but their own word changes


class StoredCommand(NamedTuple):
    """The last word on one subject: as it was said, and as bytes."""

    command: Mapping[str, Any]
    packed: bytes


class SceneState:
    """A scene as the last word on each of its subjects.

    Attributes:
        count: how many commands it has heard so far.
    """

    def __init__(self) -> None:
        self.count = 0
        self._words: dict[tuple[str, str, str], StoredCommand] = {}

    def apply(self, command: Mapping[str, Any], packed: bytes) -> None:
        """Hear one command, of plain values, together with its packed form."""
        self.count += 1
        kind, path = command["type"], "/" + command.get("path", "").strip("/")
        if kind == "delete":
            self._forget(path)
            if path.split("/")[1] == "meshcat":
                return  # it was ours, so not to mention it is enough; lights and the like are the viewer's
        subject = (kind, path, command.get("property", ""))
        self._words.pop(subject, None)  # so that it goes to the end
        self._words[subject] = StoredCommand(command, packed)

    def is_redundant(self, command: Mapping[str, Any]) -> bool:
        """Return whether saying an object or a label once more would change nothing.

        A colour is no part of an object but was painted on it, so a painted object
        may not be the one that was said.
        """
        kind, path = command["type"], "/" + command.get("path", "").strip("/")
        if kind != "set_object" and command.get("property") not in LASTING:
            return False
        word = self._words.get((kind, path, command.get("property", "")))
        return word is not None and word.command == command and not self._is_painted(path)

    def packed(self) -> bytes:
        """Return the scene for the viewer."""
        first = [word.packed for (kind, _, _), word in self._words.items() if kind not in AT_THE_END]
        last = [word.packed for (kind, _, _), word in self._words.items() if kind in AT_THE_END]
        return joined(self.count, first + last)

    def properties(self, key: str) -> dict[str, Any]:
        """Return the value of the property `key` of each path that has it, in the order they were set."""
        return {path: word.command["value"] for (kind, path, name), word in self._words.items() if name == key}

    def pose(self, path: str) -> Transform:
        """Return where `path` is in the scene.

        Raises:
            ValueError: something above it is scaled or sheared, so that it has no pose.
        """
        matrix = np.eye(4)
        names = path.strip("/").split("/")
        for i in range(len(names)):
            word = self._words.get(("set_transform", "/" + "/".join(names[: i + 1]), ""))
            if word is not None:
                matrix = matrix @ np.reshape(word.command["matrix"], (4, 4)).T  # three.js writes columns
        return Transform.from_matrix(matrix)

    def _is_painted(self, path: str) -> bool:
        painted = self.properties("color")
        return any((path + "/").startswith(above + "/") for above in painted)

    def _forget(self, path: str) -> None:
        below = path.rstrip("/") + "/"
        self._words = {
            subject: word for subject, word in self._words.items() if not (subject[1] + "/").startswith(below)
        }


def joined(count: int, commands: Iterable[bytes]) -> bytes:
    """Return packed commands as one: `count` of them, then each after its length (u32, little-endian)."""
    return struct.pack("<I", count) + b"".join(struct.pack("<I", len(each)) + each for each in commands)


def plain(value: Any) -> Any:
    """Return `value` with every NumPy array and number in it as a list or number of Python's."""
    if isinstance(value, dict):
        return {key: plain(item) for key, item in value.items()}
    if isinstance(value, (list, tuple)):
        return [plain(item) for item in value]
    if isinstance(value, (np.ndarray, np.generic)):
        return value.tolist()
    return value


def with_stable_ids(command: Any, path: str) -> Any:
    """Return a command whose ids come from its `path`, so that the same scene gives the same bytes.

    meshcat gives each geometry and material a new random id, only to refer from one
    part of the same command to another.
    """
    ids: dict[str, str] = {}

    def renamed(value: Any, key: str = "") -> Any:
        if isinstance(value, dict):
            return {name: renamed(item, name) for name, item in value.items()}
        if isinstance(value, list):
            return [renamed(item) for item in value]
        if key in ID_KEYS and isinstance(value, str):
            return ids.setdefault(value, f"{path}#{len(ids)}")
        return value

    return renamed(command)


def pack(command: Mapping[str, Any]) -> bytes:
    """Return a command of plain values as MessagePack."""
    import umsgpack  # comes with meshcat

    return umsgpack.packb(command)


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
