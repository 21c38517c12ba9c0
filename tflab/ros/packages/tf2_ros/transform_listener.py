"""tf2_ros.transform_listener"""

from tflab.ros.tf2.listener import (
    DEFAULT_STATIC_TF_TOPIC as DEFAULT_STATIC_TF_TOPIC,
    DEFAULT_TF_TOPIC as DEFAULT_TF_TOPIC,
    TransformListener as TransformListener,
)
