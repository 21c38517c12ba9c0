"""tf2_sensor_msgs, in process: importing it registers PointCloud2 with `Buffer.transform()`."""

from .tf2_sensor_msgs import (
    do_transform_cloud as do_transform_cloud,
    from_msg_msg as from_msg_msg,
    to_msg_msg as to_msg_msg,
    transform_points as transform_points,
)
