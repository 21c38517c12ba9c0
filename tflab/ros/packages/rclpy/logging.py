"""rclpy.logging"""

from tflab.ros.logging import (
    LoggingSeverity as LoggingSeverity,
    get_logger as get_logger,
    get_logger_effective_level as get_logger_effective_level,
    get_logger_level as get_logger_level,
    set_logger_level as set_logger_level,
)
