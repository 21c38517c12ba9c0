"""rclpy.clock_type"""

from tflab.ros.clock_type import ClockType as ClockType
