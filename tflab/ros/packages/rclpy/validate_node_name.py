"""rclpy.validate_node_name"""

from tflab.ros.names import validate_node_name as validate_node_name
