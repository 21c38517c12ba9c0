"""rclpy.event_handler"""

from tflab.ros.event_handler import (
    EventHandler as EventHandler,
    PublisherEventCallbacks as PublisherEventCallbacks,
    QoSRequestedIncompatibleQoSInfo as QoSRequestedIncompatibleQoSInfo,
    SubscriptionEventCallbacks as SubscriptionEventCallbacks,
    UnsupportedEventTypeError as UnsupportedEventTypeError,
)

QoSOfferedIncompatibleQoSInfo = QoSRequestedIncompatibleQoSInfo
