"""rclpy.impl.rcutils_logger"""

from tflab.ros.logging import RcutilsLogger as RcutilsLogger
