"""Messages of trajectory_msgs, in process."""

from tflab.ros.messages.trajectory_msgs import (
    JointTrajectory as JointTrajectory,
    JointTrajectoryPoint as JointTrajectoryPoint,
    MultiDOFJointTrajectory as MultiDOFJointTrajectory,
    MultiDOFJointTrajectoryPoint as MultiDOFJointTrajectoryPoint,
)
