"""Define geometry_msgs.

A default Quaternion is the identity, so a default Pose or Transform is one too.
Covariances are 6x6, row by row, in the order x, y, z, and the turns about x, y, z.
"""

from .base import message

Vector3 = message(
    "geometry_msgs/msg/Vector3",
    """
    float64 x
    float64 y
    float64 z
""",
)

Point = message(
    "geometry_msgs/msg/Point",
    """
    float64 x
    float64 y
    float64 z
""",
)

Point32 = message(
    "geometry_msgs/msg/Point32",
    """
    float32 x
    float32 y
    float32 z
""",
)

Quaternion = message(
    "geometry_msgs/msg/Quaternion",
    """
    float64 x 0
    float64 y 0
    float64 z 0
    float64 w 1
""",
)

Pose = message(
    "geometry_msgs/msg/Pose",
    """
    Point position
    Quaternion orientation
""",
)

Pose2D = message(
    "geometry_msgs/msg/Pose2D",
    """
    float64 x
    float64 y
    float64 theta
""",
)

Transform = message(
    "geometry_msgs/msg/Transform",
    """
    Vector3 translation
    Quaternion rotation
""",
)

Twist = message(
    "geometry_msgs/msg/Twist",
    """
    Vector3 linear
    Vector3 angular
""",
)

Accel = message(
    "geometry_msgs/msg/Accel",
    """
    Vector3 linear
    Vector3 angular
""",
)

Wrench = message(
    "geometry_msgs/msg/Wrench",
    """
    Vector3 force
    Vector3 torque
""",
)

Polygon = message("geometry_msgs/msg/Polygon", "Point32[] points")

PoseWithCovariance = message(
    "geometry_msgs/msg/PoseWithCovariance",
    """
    Pose pose
    float64[36] covariance
""",
)

TwistWithCovariance = message(
    "geometry_msgs/msg/TwistWithCovariance",
    """
    Twist twist
    float64[36] covariance
""",
)

AccelWithCovariance = message(
    "geometry_msgs/msg/AccelWithCovariance",
    """
    Accel accel
    float64[36] covariance
""",
)

TransformStamped = message(
    "geometry_msgs/msg/TransformStamped",
    """
    std_msgs/Header header
    string child_frame_id
    Transform transform
""",
)

PointStamped = message(
    "geometry_msgs/msg/PointStamped",
    """
    std_msgs/Header header
    Point point
""",
)

Vector3Stamped = message(
    "geometry_msgs/msg/Vector3Stamped",
    """
    std_msgs/Header header
    Vector3 vector
""",
)

QuaternionStamped = message(
    "geometry_msgs/msg/QuaternionStamped",
    """
    std_msgs/Header header
    Quaternion quaternion
""",
)

PoseStamped = message(
    "geometry_msgs/msg/PoseStamped",
    """
    std_msgs/Header header
    Pose pose
""",
)

PoseArray = message(
    "geometry_msgs/msg/PoseArray",
    """
    std_msgs/Header header
    Pose[] poses
""",
)

PoseWithCovarianceStamped = message(
    "geometry_msgs/msg/PoseWithCovarianceStamped",
    """
    std_msgs/Header header
    PoseWithCovariance pose
""",
)

TwistStamped = message(
    "geometry_msgs/msg/TwistStamped",
    """
    std_msgs/Header header
    Twist twist
""",
)

TwistWithCovarianceStamped = message(
    "geometry_msgs/msg/TwistWithCovarianceStamped",
    """
    std_msgs/Header header
    TwistWithCovariance twist
""",
)

AccelStamped = message(
    "geometry_msgs/msg/AccelStamped",
    """
    std_msgs/Header header
    Accel accel
""",
)

AccelWithCovarianceStamped = message(
    "geometry_msgs/msg/AccelWithCovarianceStamped",
    """
    std_msgs/Header header
    AccelWithCovariance accel
""",
)

WrenchStamped = message(
    "geometry_msgs/msg/WrenchStamped",
    """
    std_msgs/Header header
    Wrench wrench
""",
)

PolygonStamped = message(
    "geometry_msgs/msg/PolygonStamped",
    """
    std_msgs/Header header
    Polygon polygon
""",
)

VelocityStamped = message(
    "geometry_msgs/msg/VelocityStamped",
    """
    std_msgs/Header header
    string body_frame_id
    string reference_frame_id
    Twist velocity
""",
)

Inertia = message(
    "geometry_msgs/msg/Inertia",
    """
    float64 m
    Vector3 com
    float64 ixx
    float64 ixy
    float64 ixz
    float64 iyy
    float64 iyz
    float64 izz
""",
)

InertiaStamped = message(
    "geometry_msgs/msg/InertiaStamped",
    """
    std_msgs/Header header
    Inertia inertia
""",
)

PolygonInstance = message(
    "geometry_msgs/msg/PolygonInstance",
    """
    Polygon polygon
    int64 id
""",
)

PolygonInstanceStamped = message(
    "geometry_msgs/msg/PolygonInstanceStamped",
    """
    std_msgs/Header header
    PolygonInstance polygon
""",
)
