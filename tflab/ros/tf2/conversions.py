"""Register the message types that `Buffer.transform()` can transform, as ROS's packages do when they are imported."""

from __future__ import annotations

from ..messages.geometry_msgs import PointStamped, PoseStamped, Vector3Stamped
from ..messages.sensor_msgs import PointCloud2
from . import clouds, geometry
from .interface import ConvertRegistration, TransformRegistration

__all__ = ["register_geometry_types", "register_point_clouds"]


def register_geometry_types() -> None:
    """Register what `import tf2_geometry_msgs` registers."""
    for message_type, transform in geometry.TRANSFORMS.items():
        TransformRegistration().add(message_type, transform)
    # The others have no conversions, upstream too: `new_type=` fails for them.
    for message_type in (Vector3Stamped, PoseStamped, PointStamped):
        ConvertRegistration().add_to_msg(message_type, geometry.to_msg_msg)
        ConvertRegistration().add_from_msg(message_type, geometry.from_msg_msg)


def register_point_clouds() -> None:
    """Register what `import tf2_sensor_msgs` registers."""
    TransformRegistration().add(PointCloud2, clouds.do_transform_cloud)
    ConvertRegistration().add_to_msg(PointCloud2, clouds.to_msg_msg)
    ConvertRegistration().add_from_msg(PointCloud2, clouds.from_msg_msg)
