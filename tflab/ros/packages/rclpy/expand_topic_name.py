"""rclpy.expand_topic_name"""

from tflab.ros.names import expand_topic_name as expand_topic_name
