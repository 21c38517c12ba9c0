"""rclpy.impl.rcutils_logger"""

from tflab.ros.logging import RcutilsLogger

__all__ = [
    "RcutilsLogger",
]
