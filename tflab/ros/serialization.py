"""Serialize and deserialize messages (CDR), as rclpy.serialization does.

    serialize_message(msg) -> b"\\x00\\x01\\x00\\x00..."     deserialize_message(data, PointStamped) -> msg

Nothing here needs it to send a message; bags, and subscriptions with raw=True, do.
The bytes are made by the rosbags library.
"""

from __future__ import annotations

from .messages.base import Message
from .messages.packages import type_store
from .messages.values import message_from_object, object_from_message

__all__ = ["deserialize_message", "serialize_message"]


def serialize_message(message: Message) -> bytes:
    """Return a message as it travels.

    Raises:
        KeyError: its type is neither one that ROS 2 brings along nor defined here.
    """
    store = type_store()
    return bytes(store.serialize_cdr(object_from_message(message, store.types), message.ROS_TYPE))


def deserialize_message(serialized_message: bytes, message_type: type[Message]) -> Message:
    """Return the message of some bytes.

    Raises:
        KeyError: its type is neither one that ROS 2 brings along nor defined here.
    """
    ros_type = message_type.ROS_TYPE
    return message_from_object(ros_type, type_store().deserialize_cdr(serialized_message, ros_type))
