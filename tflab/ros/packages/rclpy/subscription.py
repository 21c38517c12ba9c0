"""rclpy.subscription"""

from tflab.ros.subscription import Subscription

__all__ = [
    "Subscription",
]
