"""rclpy.node"""

from tflab.ros.node import Node
from tflab.ros.parameter import Parameter

__all__ = [
    "Node",
    "Parameter",
]
