"""tf2_ros.transform_broadcaster"""

from tflab.ros.tf2.broadcaster import TransformBroadcaster as TransformBroadcaster
