"""rclpy.validate_topic_name"""

from tflab.ros.names import validate_topic_name as validate_topic_name
