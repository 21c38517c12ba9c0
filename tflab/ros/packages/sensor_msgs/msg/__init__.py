"""Messages of sensor_msgs, in process."""

from tflab.ros.messages.sensor_msgs import (
    CameraInfo as CameraInfo,
    CompressedImage as CompressedImage,
    Image as Image,
    Imu as Imu,
    JointState as JointState,
    LaserScan as LaserScan,
    PointCloud2 as PointCloud2,
    PointField as PointField,
    Range as Range,
    RegionOfInterest as RegionOfInterest,
)
