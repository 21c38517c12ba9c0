"""Messages of nav_msgs, in process."""

from tflab.ros.messages.nav_msgs import (
    MapMetaData,
    OccupancyGrid,
    Odometry,
    Path,
)

__all__ = [
    "MapMetaData",
    "OccupancyGrid",
    "Odometry",
    "Path",
]
