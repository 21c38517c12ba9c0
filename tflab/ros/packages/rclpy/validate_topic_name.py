"""rclpy.validate_topic_name"""

from tflab.ros.names import validate_topic_name

__all__ = [
    "validate_topic_name",
]
