"""rclpy.impl.logging_severity"""

from tflab.ros.logging import LoggingSeverity as LoggingSeverity
