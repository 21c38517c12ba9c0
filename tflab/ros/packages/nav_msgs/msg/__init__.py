"""Messages of nav_msgs, in process."""

from tflab.ros.messages.nav_msgs import (
    GridCells as GridCells,
    MapMetaData as MapMetaData,
    OccupancyGrid as OccupancyGrid,
    Odometry as Odometry,
    Path as Path,
)
