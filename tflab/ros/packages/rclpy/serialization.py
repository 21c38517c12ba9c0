"""rclpy.serialization"""

from tflab.ros.serialization import (
    deserialize_message as deserialize_message,
    serialize_message as serialize_message,
)
