"""tf2_ros.static_transform_broadcaster"""

from tflab.ros.tf2_broadcaster import StaticTransformBroadcaster

__all__ = [
    "StaticTransformBroadcaster",
]
