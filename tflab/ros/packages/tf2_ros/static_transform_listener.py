"""tf2_ros.static_transform_listener"""

from tflab.ros.tf2.listener import (
    DEFAULT_STATIC_TF_TOPIC as DEFAULT_STATIC_TF_TOPIC,
    StaticTransformListener as StaticTransformListener,
)
