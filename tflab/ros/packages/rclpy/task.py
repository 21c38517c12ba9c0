"""rclpy.task"""

from tflab.ros.task import Future, Task

__all__ = [
    "Future",
    "Task",
]
