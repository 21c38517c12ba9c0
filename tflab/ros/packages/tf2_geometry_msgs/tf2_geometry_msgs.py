"""tf2_geometry_msgs' one module: see tflab.ros.tf2.geometry."""

from tf2_ros import ConvertRegistration, TransformRegistration

from tflab.ros.messages.geometry_msgs import (
    PointStamped as PointStamped,
    PolygonStamped as PolygonStamped,
    Pose as Pose,
    PoseStamped as PoseStamped,
    PoseWithCovarianceStamped as PoseWithCovarianceStamped,
    TransformStamped as TransformStamped,
    Vector3Stamped as Vector3Stamped,
)
from tflab.ros.tf2.geometry import (
    TRANSFORMS,
    _build_affine as _build_affine,
    _decompose_affine as _decompose_affine,
    _get_mat_from_quat as _get_mat_from_quat,
    _get_quat_from_mat as _get_quat_from_mat,
    _transform_to_affine as _transform_to_affine,
    do_transform_point as do_transform_point,
    do_transform_polygon_stamped as do_transform_polygon_stamped,
    do_transform_pose as do_transform_pose,
    do_transform_pose_stamped as do_transform_pose_stamped,
    do_transform_pose_with_covariance_stamped as do_transform_pose_with_covariance_stamped,
    do_transform_vector3 as do_transform_vector3,
    from_msg_msg as from_msg_msg,
    to_msg_msg as to_msg_msg,
    transform_covariance as transform_covariance,
)

for _message_type, _do_transform in TRANSFORMS.items():
    TransformRegistration().add(_message_type, _do_transform)

# The others have no conversions, upstream too: `new_type=` fails for them.
for _message_type in (Vector3Stamped, PoseStamped, PointStamped):
    ConvertRegistration().add_to_msg(_message_type, to_msg_msg)
    ConvertRegistration().add_from_msg(_message_type, from_msg_msg)
