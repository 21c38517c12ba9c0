"""Points of a PointCloud2, in process: see tflab.ros.tf2.clouds."""

from tflab.ros.tf2.clouds import (
    create_cloud as create_cloud,
    create_cloud_xyz32 as create_cloud_xyz32,
    dtype_from_fields as dtype_from_fields,
    read_points as read_points,
    read_points_list as read_points_list,
    read_points_numpy as read_points_numpy,
)
