"""rclpy.validate_full_topic_name"""

from tflab.ros.names import validate_full_topic_name as validate_full_topic_name
