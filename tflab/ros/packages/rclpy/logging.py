"""rclpy.logging"""

from tflab.ros.logging import (
    LoggingSeverity,
    get_logger,
    get_logger_effective_level,
    get_logger_level,
    set_logger_level,
)

__all__ = [
    "LoggingSeverity",
    "get_logger",
    "get_logger_effective_level",
    "get_logger_level",
    "set_logger_level",
]
