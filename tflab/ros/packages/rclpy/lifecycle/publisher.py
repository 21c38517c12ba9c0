"""rclpy.lifecycle.publisher"""

from tflab.ros.lifecycle import LifecyclePublisher as LifecyclePublisher
