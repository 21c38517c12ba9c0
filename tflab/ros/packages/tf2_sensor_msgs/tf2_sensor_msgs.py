"""tf2_sensor_msgs' one module: see tflab.ros.tf2.clouds."""

from tf2_ros import ConvertRegistration, TransformRegistration

from tflab.ros.messages.sensor_msgs import PointCloud2
from tflab.ros.tf2.clouds import (
    do_transform_cloud as do_transform_cloud,
    from_msg_msg as from_msg_msg,
    to_msg_msg as to_msg_msg,
    transform_points as transform_points,
)

TransformRegistration().add(PointCloud2, do_transform_cloud)
ConvertRegistration().add_to_msg(PointCloud2, to_msg_msg)
ConvertRegistration().add_from_msg(PointCloud2, from_msg_msg)
