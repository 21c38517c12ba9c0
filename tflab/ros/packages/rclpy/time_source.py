"""rclpy.time_source"""

from tflab.ros.time_source import CLOCK_TOPIC, USE_SIM_TIME_NAME, TimeSource

__all__ = [
    "CLOCK_TOPIC",
    "USE_SIM_TIME_NAME",
    "TimeSource",
]
