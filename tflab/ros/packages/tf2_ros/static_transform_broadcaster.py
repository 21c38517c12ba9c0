"""tf2_ros.static_transform_broadcaster"""

from tflab.ros.tf2.broadcaster import StaticTransformBroadcaster as StaticTransformBroadcaster
