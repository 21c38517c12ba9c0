"""rclpy.executors"""

from tflab.ros.executors import (
    Executor as Executor,
    ExternalShutdownException as ExternalShutdownException,
    MultiThreadedExecutor as MultiThreadedExecutor,
    ShutdownException as ShutdownException,
    SingleThreadedExecutor as SingleThreadedExecutor,
    TimeoutException as TimeoutException,
)
