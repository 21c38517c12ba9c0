"""What is on the wire?  A message as bytes (CDR), and back.  rclpy.serialization.

    serialize_message(msg) -> b"\\x00\\x01\\x00\\x00..."     deserialize_message(data, PointStamped) -> msg

Nothing here needs it to send a message; bags, and subscriptions with raw=True, do.
The bytes are made by the rosbags library.  Read `convert.py` next.
"""

from __future__ import annotations

from functools import cache
from typing import Any

from .messages.base import Message
from .messages.values import message_from_object, object_from_message

__all__ = ["deserialize_message", "serialize_message"]


def serialize_message(message: Message) -> bytes:
    """Return a message as it travels.

    Raises:
        KeyError: its type is not one of the message types that ROS 2 brings along.
    """
    store = _store()
    return bytes(store.serialize_cdr(object_from_message(message, store.types), message.ROS_TYPE))


def deserialize_message(serialized_message: bytes, message_type: type[Message]) -> Message:
    """Return the message of some bytes.

    Raises:
        KeyError: its type is not one of the message types that ROS 2 brings along.
    """
    ros_type = message_type.ROS_TYPE
    return message_from_object(ros_type, _store().deserialize_cdr(serialized_message, ros_type))


@cache
def _store() -> Any:
    from rosbags.typesys import Stores, get_typestore  # loads all of ROS's types: only for who asks

    return get_typestore(Stores.ROS2_JAZZY)
