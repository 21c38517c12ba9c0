"""rclpy.context"""

from tflab.ros.context import Context

__all__ = [
    "Context",
]
