"""Format the given values of a task for printing, the same in both languages.

```
base_T_laser    translation (0.200, 0.000, 0.150), rotation xyzw (0.000, 0.000, 0.707, 0.707)
laser_p_corner  (2.000, 0.000, 0.000)
```
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from tflab.clinic.patient import FaultyRobot
from tflab.core import BufferCore, StampedTransform, Transform
from tflab.ros.messages.base import Message
from tflab.ros.messages.text import message_to_yaml
from tflab.ros.tf2 import buffer as tf2_buffer

__all__ = ["show", "show_all", "show_in_a_line"]

NS_PER_S = 1_000_000_000


def show_all(values: Mapping[str, Any]) -> str:
    """Return one line for each name, or a block where the value takes several."""
    width = max(map(len, values), default=0)
    lines = []
    for name, value in values.items():
        text = show(value)
        if "\n" in text:
            lines += [f"  {name}", *(f"      {line}" for line in text.splitlines())]
        else:
            lines.append(f"  {name:<{width}}  {text}")
    return "\n".join(lines)


def show(value: Any) -> str:
    """Return a value for people: fixed decimals, no negative zero, no reprs of NumPy."""
    if isinstance(value, bool | int | None):
        return str(value)
    if isinstance(value, float | np.floating):
        return _number(float(value))
    if isinstance(value, str):
        return value if "\n" in value else f'"{value}"'
    if isinstance(value, Transform):
        return f"translation {show(value.translation)}, rotation xyzw {show(value.rotation)}"
    if isinstance(value, FaultyRobot):
        return repr(value)
    if isinstance(value, StampedTransform):
        head = f"{value.frame_id} -> {value.child_frame_id} at {_seconds(value.stamp_ns)}"
        return f"{head}: {show(value.transform)}"
    if isinstance(value, BufferCore | tf2_buffer.BufferCore):
        return _buffer(_buffer_of(value))
    if isinstance(value, Message):
        return f"{value.ROS_TYPE}\n{message_to_yaml(value)}".rstrip()
    if isinstance(value, Mapping):
        return "\n".join(_named(str(key), show(inner)) for key, inner in value.items())
    if isinstance(value, np.ndarray):
        value = value.tolist()
    if isinstance(value, list | tuple):
        return _row(value)
    return str(value)


def show_in_a_line(value: Any, at_most: int = 200) -> str:
    """Return a value in one line, dicts as {"x": 1.000, "y": 2.000}, cut where it gets long."""
    if isinstance(value, Mapping):
        text = "{" + ", ".join(f"{show(key)}: {show_in_a_line(inner, at_most)}" for key, inner in value.items()) + "}"
    elif isinstance(value, list | tuple):
        left, right = "[]" if isinstance(value, list) else "()"
        text = left + ", ".join(show_in_a_line(member, at_most) for member in value) + right
    elif isinstance(value, BufferCore | tf2_buffer.BufferCore):
        text = f"buffer with {len(_buffer_of(value).frame_names())} frames"
    elif isinstance(value, Message):
        text = _message_in_a_line(value, at_most)
    elif isinstance(value, float) and round(value, 3) != value == round(value, 4):
        text = f"{value:.4f}"  # 23.0005 and 23.0 are two: such a digit was put there
    else:
        lines = show(value).splitlines() or ['""']
        text = lines[0] if len(lines) == 1 else f"{lines[0]} …"
    return text if len(text) <= at_most else text[:at_most] + " …"


def _message_in_a_line(message: Message, at_most: int) -> str:
    name = message.ROS_TYPE.rpartition("/")[2]
    if hasattr(message, "header"):
        stamp = message.header.stamp
        return f'{name} in "{message.header.frame_id}" at {_seconds(stamp.sec * NS_PER_S + stamp.nanosec)}'
    fields = (f"{key}={show_in_a_line(getattr(message, key), at_most)}" for key in message.get_fields_and_field_types())
    return f"{name}({', '.join(fields)})"


def _named(name: str, text: str) -> str:
    if "\n" not in text:
        return f"{name}: {text}"
    return "\n".join((f"{name}:", *(f"    {line}" for line in text.splitlines())))


def _row(members: list | tuple) -> str:
    texts = [show(member) for member in members]
    if sum(map(len, texts)) > 90 or any("\n" in text for text in texts):
        return "\n".join(texts)
    left, right = "[]" if isinstance(members, list) else "()"
    return left + ", ".join(texts) + right


def _buffer_of(value: BufferCore | tf2_buffer.BufferCore) -> BufferCore:
    return value if isinstance(value, BufferCore) else value.core


def _buffer(buffer: BufferCore) -> str:
    """Return one line for each edge: whose child, from when to when, how many samples."""
    lines = []
    for frame in sorted(buffer.frame_names()):
        history = buffer.history(frame)
        if not history.stamps_ns:
            continue
        edge = f"{history.parents[-1]} -> {frame}"
        if history.is_static:
            lines.append(f"{edge}  static")
        else:
            first, last = map(_seconds, (history.stamps_ns[0], history.stamps_ns[-1]))
            count = len(history.stamps_ns)
            when = f"{count} samples from {first} to {last}" if count > 1 else f"1 sample at {first}"
            lines.append(f"{edge}  {when}")
    return "\n".join(lines)


def _number(value: float) -> str:
    plain = 0.001 <= abs(value) < 1e6 or abs(value) < 1e-9  # below that it is rounding, not a value
    return f"{round(value, 3) + 0.0:.3f}" if plain else f"{value:.6g}"


def _seconds(stamp_ns: int) -> str:
    return f"{stamp_ns // NS_PER_S}.{stamp_ns % NS_PER_S:09d} s"
