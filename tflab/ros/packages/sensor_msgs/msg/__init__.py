"""Messages of sensor_msgs, in process."""

from tflab.ros.messages.sensor_msgs import (
    CameraInfo,
    CompressedImage,
    Image,
    Imu,
    JointState,
    LaserScan,
    PointCloud2,
    PointField,
    Range,
    RegionOfInterest,
)

__all__ = [
    "CameraInfo",
    "CompressedImage",
    "Image",
    "Imu",
    "JointState",
    "LaserScan",
    "PointCloud2",
    "PointField",
    "Range",
    "RegionOfInterest",
]
