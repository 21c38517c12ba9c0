"""rclpy.validate_namespace"""

from tflab.ros.names import validate_namespace as validate_namespace
