"""rclpy.task"""

from tflab.ros.task import (
    Future as Future,
    Task as Task,
)
