"""rclpy.time_source"""

from tflab.ros.time_source import (
    CLOCK_TOPIC as CLOCK_TOPIC,
    USE_SIM_TIME_NAME as USE_SIM_TIME_NAME,
    TimeSource as TimeSource,
)
