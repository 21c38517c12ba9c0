"""rclpy.logging"""

from tflab.ros.logging import (
    LoggingSeverity as LoggingSeverity,
    RcutilsLogger as RcutilsLogger,
    _root_logger as _root_logger,
    clear_config as clear_config,
    get_logger as get_logger,
    get_logger_effective_level as get_logger_effective_level,
    get_logger_level as get_logger_level,
    get_logging_directory as get_logging_directory,
    get_logging_severity_from_string as get_logging_severity_from_string,
    set_logger_level as set_logger_level,
)
