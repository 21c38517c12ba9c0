"""rclpy.topic_or_service_is_hidden"""

from tflab.ros.names import is_hidden

topic_or_service_is_hidden = is_hidden
