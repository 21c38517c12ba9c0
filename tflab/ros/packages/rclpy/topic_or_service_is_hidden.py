"""rclpy.topic_or_service_is_hidden"""

from tflab.ros.names import is_hidden as topic_or_service_is_hidden

__all__ = ["topic_or_service_is_hidden"]
