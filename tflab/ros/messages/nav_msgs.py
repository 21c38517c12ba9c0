"""Define nav_msgs."""

from .base import message, service

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

GridCells = message(
    "nav_msgs/msg/GridCells",
    """
    std_msgs/Header header
    float32 cell_width
    float32 cell_height
    geometry_msgs/Point[] cells
""",
)

GetMap = service("nav_msgs/srv/GetMap", response="OccupancyGrid map")

GetPlan = service(
    "nav_msgs/srv/GetPlan",
    request="""
        geometry_msgs/PoseStamped start
        geometry_msgs/PoseStamped goal
        float32 tolerance
    """,
    response="Path plan",
)

SetMap = service(
    "nav_msgs/srv/SetMap",
    request="""
        OccupancyGrid map
        geometry_msgs/PoseWithCovarianceStamped initial_pose
    """,
    response="bool success",
)

LoadMap = service(
    "nav_msgs/srv/LoadMap",
    request="string map_url",
    response="""
        uint8 RESULT_SUCCESS=0
        uint8 RESULT_MAP_DOES_NOT_EXIST=1
        uint8 RESULT_INVALID_MAP_DATA=2
        uint8 RESULT_INVALID_MAP_METADATA=3
        uint8 RESULT_UNDEFINED_FAILURE=255
        OccupancyGrid map
        uint8 result
    """,
)
