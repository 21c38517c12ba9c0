"""rclpy.expand_topic_name"""

from tflab.ros.names import expand_topic_name

__all__ = [
    "expand_topic_name",
]
