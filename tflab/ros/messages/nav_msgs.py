"""nav_msgs: where a robot is, was, and may go.

Read `visualization_msgs.py` next.
"""

from .base import message

Odometry = message(
    "nav_msgs/msg/Odometry",
    """
    std_msgs/Header header
    string child_frame_id
    geometry_msgs/PoseWithCovariance pose
    geometry_msgs/TwistWithCovariance twist
""",
)

Path = message(
    "nav_msgs/msg/Path",
    """
    std_msgs/Header header
    geometry_msgs/PoseStamped[] poses
""",
)

MapMetaData = message(
    "nav_msgs/msg/MapMetaData",
    """
    builtin_interfaces/Time map_load_time
    float32 resolution
    uint32 width
    uint32 height
    geometry_msgs/Pose origin
""",
)

OccupancyGrid = message(
    "nav_msgs/msg/OccupancyGrid",
    """
    std_msgs/Header header
    MapMetaData info
    int8[] data
""",
)
