"""rclpy.event_handler"""

from tflab.ros.event_handler import PublisherEventCallbacks, SubscriptionEventCallbacks

__all__ = [
    "PublisherEventCallbacks",
    "SubscriptionEventCallbacks",
]
