"""sensor_msgs: what a robot's sensors say, each in the frame of its header.

Read `nav_msgs.py` next.
"""

from .base import message

LaserScan = message(
    "sensor_msgs/msg/LaserScan",
    """
    std_msgs/Header header
    float32 angle_min
    float32 angle_max
    float32 angle_increment
    float32 time_increment
    float32 scan_time
    float32 range_min
    float32 range_max
    float32[] ranges
    float32[] intensities
""",
)

PointField = message(
    "sensor_msgs/msg/PointField",
    """
    uint8 INT8=1
    uint8 UINT8=2
    uint8 INT16=3
    uint8 UINT16=4
    uint8 INT32=5
    uint8 UINT32=6
    uint8 FLOAT32=7
    uint8 FLOAT64=8
    string name
    uint32 offset
    uint8 datatype
    uint32 count
""",
)

PointCloud2 = message(
    "sensor_msgs/msg/PointCloud2",
    """
    std_msgs/Header header
    uint32 height
    uint32 width
    PointField[] fields
    bool is_bigendian
    uint32 point_step
    uint32 row_step
    uint8[] data
    bool is_dense
""",
)

JointState = message(
    "sensor_msgs/msg/JointState",
    """
    std_msgs/Header header
    string[] name
    float64[] position
    float64[] velocity
    float64[] effort
""",
)

Imu = message(
    "sensor_msgs/msg/Imu",
    """
    std_msgs/Header header
    geometry_msgs/Quaternion orientation
    float64[9] orientation_covariance
    geometry_msgs/Vector3 angular_velocity
    float64[9] angular_velocity_covariance
    geometry_msgs/Vector3 linear_acceleration
    float64[9] linear_acceleration_covariance
""",
)

Image = message(
    "sensor_msgs/msg/Image",
    """
    std_msgs/Header header
    uint32 height
    uint32 width
    string encoding
    uint8 is_bigendian
    uint32 step
    uint8[] data
""",
)

CompressedImage = message(
    "sensor_msgs/msg/CompressedImage",
    """
    std_msgs/Header header
    string format
    uint8[] data
""",
)

RegionOfInterest = message(
    "sensor_msgs/msg/RegionOfInterest",
    """
    uint32 x_offset
    uint32 y_offset
    uint32 height
    uint32 width
    bool do_rectify
""",
)

CameraInfo = message(
    "sensor_msgs/msg/CameraInfo",
    """
    std_msgs/Header header
    uint32 height
    uint32 width
    string distortion_model
    float64[] d
    float64[9] k
    float64[9] r
    float64[12] p
    uint32 binning_x
    uint32 binning_y
    RegionOfInterest roi
""",
)

Range = message(
    "sensor_msgs/msg/Range",
    """
    uint8 ULTRASOUND=0
    uint8 INFRARED=1
    std_msgs/Header header
    uint8 radiation_type
    float32 field_of_view
    float32 min_range
    float32 max_range
    float32 range
    float32 variance
""",
)
