"""rclpy.event_handler"""

from tflab.ros.event_handler import (
    PublisherEventCallbacks as PublisherEventCallbacks,
    SubscriptionEventCallbacks as SubscriptionEventCallbacks,
)
