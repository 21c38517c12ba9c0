"""rclpy.impl.logging_severity"""

from tflab.ros.logging import LoggingSeverity

__all__ = [
    "LoggingSeverity",
]
