"""tf2_geometry_msgs, in process: importing it registers its types with `Buffer.transform()`."""

from .tf2_geometry_msgs import (
    PointStamped as PointStamped,
    PolygonStamped as PolygonStamped,
    Pose as Pose,
    PoseStamped as PoseStamped,
    PoseWithCovarianceStamped as PoseWithCovarianceStamped,
    TransformStamped as TransformStamped,
    Vector3Stamped as Vector3Stamped,
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
