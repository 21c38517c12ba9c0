"""Messages of visualization_msgs, in process."""

from tflab.ros.messages.visualization_msgs import (
    Marker as Marker,
    MarkerArray as MarkerArray,
    MeshFile as MeshFile,
    UVCoordinate as UVCoordinate,
)
