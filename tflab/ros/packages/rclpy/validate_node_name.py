"""rclpy.validate_node_name"""

from tflab.ros.names import validate_node_name

__all__ = [
    "validate_node_name",
]
