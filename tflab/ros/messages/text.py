"""Print messages as YAML, as `ros2 topic echo` does.

    header:
      stamp:
        sec: 1
        nanosec: 500000000
      frame_id: map
    ranges:
    - 0.5
    - '...'            (what is longer than 128 is cut, unless --full-length)

`type_hash` is the fingerprint that `ros2 topic info --verbose` shows.
"""

from __future__ import annotations

import sys
from array import array

import numpy as np
import yaml

from .base import Message
from .definition import Array, BoundedSequence, SlotType, UnboundedSequence, type_text
from .packages import type_store

__all__ = ["TRUNCATE_LENGTH", "message_to_dict", "message_to_yaml", "type_hash"]

TRUNCATE_LENGTH = 128  # of `ros2 topic echo`


def message_to_yaml(
    message: Message,
    *,
    truncate_length: int | None = None,
    no_arr: bool = False,
    no_str: bool = False,
    flow_style: bool = False,
) -> str:
    """Return the message as YAML, ending in a newline.

    Args:
        truncate_length: cut longer sequences and strings, and say '...'; None keeps all.
        no_arr: print only the type of sequences and how many values there are.
        no_str: print only the length of strings.
        flow_style: print on one line, in braces.
    """
    values = message_to_dict(message, truncate_length=truncate_length, no_arr=no_arr, no_str=no_str)
    return yaml.dump(values, allow_unicode=True, width=sys.maxsize, default_flow_style=flow_style, sort_keys=False)


def message_to_dict(
    message: Message, *, truncate_length: int | None = None, no_arr: bool = False, no_str: bool = False
) -> dict[str, object]:
    """Return the message as plain dicts, lists, strings and numbers; for the arguments see `message_to_yaml`."""

    def plain(value: object, slot_type: SlotType | None = None) -> object:
        if isinstance(value, Message):
            return {
                name: plain(getattr(value, name), slot)
                for name, slot in zip(value.get_fields_and_field_types(), value.SLOT_TYPES, strict=True)
            }
        if isinstance(value, bytes):
            value = value.decode("latin-1")
        if isinstance(value, str):
            if no_str:
                return f"<string length: <{len(value)}>>"
            return value if _fits(value) else value[:truncate_length] + "..."
        if isinstance(value, np.ndarray | array):
            value = value.tolist()
        if isinstance(value, list | tuple):
            if no_arr:
                return _sequence_summary(value, slot_type)
            shown = [plain(item) for item in value[:truncate_length]]
            return shown if _fits(value) else [*shown, "..."]
        return value.item() if isinstance(value, np.generic) else value

    def _fits(value: str | list | tuple) -> bool:
        return truncate_length is None or len(value) <= truncate_length

    return plain(message)


def type_hash(ros_type: str) -> str:
    """Return the type's RIHS01 hash (REP-2011): 'RIHS01_e369…' for 'tf2_msgs/msg/TFMessage'; "INVALID" if not known."""
    store = type_store()
    return store.hash_rihs01(ros_type) if ros_type in store.fielddefs else "INVALID"


def _sequence_summary(value: list | tuple, slot_type: Array | BoundedSequence | UnboundedSequence) -> str:
    of = type_text(slot_type.value_type).replace("/", "/msg/")
    match slot_type:
        case Array(size=size):
            return f"<array type: {of}[{size}]>"
        case BoundedSequence(maximum_size=size):
            return f"<sequence type: {of}[{size}], length: {len(value)}>"
    return f"<sequence type: {of}, length: {len(value)}>"
