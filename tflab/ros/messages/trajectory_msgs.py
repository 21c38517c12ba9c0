"""Define trajectory_msgs."""

from .base import message

JointTrajectoryPoint = message(
    "trajectory_msgs/msg/JointTrajectoryPoint",
    """
    float64[] positions
    float64[] velocities
    float64[] accelerations
    float64[] effort
    builtin_interfaces/Duration time_from_start
""",
)

JointTrajectory = message(
    "trajectory_msgs/msg/JointTrajectory",
    """
    std_msgs/Header header
    string[] joint_names
    JointTrajectoryPoint[] points
""",
)

MultiDOFJointTrajectoryPoint = message(
    "trajectory_msgs/msg/MultiDOFJointTrajectoryPoint",
    """
    geometry_msgs/Transform[] transforms
    geometry_msgs/Twist[] velocities
    geometry_msgs/Twist[] accelerations
    builtin_interfaces/Duration time_from_start
""",
)

MultiDOFJointTrajectory = message(
    "trajectory_msgs/msg/MultiDOFJointTrajectory",
    """
    std_msgs/Header header
    string[] joint_names
    MultiDOFJointTrajectoryPoint[] points
""",
)
