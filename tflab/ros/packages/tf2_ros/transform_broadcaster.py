"""tf2_ros.transform_broadcaster"""

from tflab.ros.tf2_broadcaster import TransformBroadcaster

__all__ = [
    "TransformBroadcaster",
]
