"""Convert sensor readings to ROS messages.

    Scan -> sensor_msgs/LaserScan        Detection       -> geometry_msgs/PointStamped
    ImuReading -> sensor_msgs/Imu        OdometryReading -> nav_msgs/Odometry
    Room -> nav_msgs/OccupancyGrid       JointReading    -> sensor_msgs/JointState

Transforms are converted by `tflab/ros/convert.py`.
"""

from __future__ import annotations

from array import array

from tflab.ros.convert import msg_from_stamp, msg_from_transform
from tflab.ros.messages import geometry_msgs, nav_msgs, sensor_msgs, std_msgs

from .readings import Detection, ImuReading, JointReading, OdometryReading, Scan
from .sensors import Room

__all__ = ["imu_msg", "joint_state_msg", "laser_scan_msg", "occupancy_grid_msg", "odometry_msg", "point_msg"]

SECONDS_PER_NSEC = 1e-9


def occupancy_grid_msg(
    room: Room, stamp_ns: int, frame_id: str = "map", resolution_m: float = 0.05
) -> nav_msgs.OccupancyGrid:
    """Return the message of a map: 100 where a wall is, 0 where none is."""
    cells, (x, y) = room.cells(resolution_m)
    message = nav_msgs.OccupancyGrid(header=_header(stamp_ns, frame_id))
    message.info.map_load_time = message.header.stamp
    message.info.resolution = resolution_m
    message.info.height, message.info.width = cells.shape
    message.info.origin.position.x, message.info.origin.position.y = x, y
    message.info.origin.orientation.w = 1.0
    message.data = (100 * cells.ravel()).tolist()
    return message


def joint_state_msg(reading: JointReading) -> sensor_msgs.JointState:
    """Return the message of joint positions."""
    return sensor_msgs.JointState(
        header=_header(reading.stamp_ns, ""), name=list(reading.names), position=array("d", reading.positions)
    )


def odometry_msg(reading: OdometryReading) -> nav_msgs.Odometry:
    """Return the message of a wheel odometry."""
    message = nav_msgs.Odometry(
        header=_header(reading.stamp_ns, reading.frame_id), child_frame_id=reading.child_frame_id
    )
    transform = msg_from_transform(reading.pose)
    position = message.pose.pose.position
    position.x, position.y, position.z = reading.pose.translation
    message.pose.pose.orientation = transform.rotation
    message.twist.twist.linear.x = reading.speed
    message.twist.twist.angular.z = reading.yaw_rate
    return message


def laser_scan_msg(scan: Scan) -> sensor_msgs.LaserScan:
    """Return the message of a sweep."""
    return sensor_msgs.LaserScan(
        header=_header(scan.stamp_ns, scan.frame_id),
        angle_min=scan.angle_min,
        angle_max=scan.angle_min + scan.angle_increment * (len(scan.ranges) - 1),
        angle_increment=scan.angle_increment,
        time_increment=scan.time_increment_ns * SECONDS_PER_NSEC,
        scan_time=scan.time_increment_ns * len(scan.ranges) * SECONDS_PER_NSEC,
        range_min=scan.range_min,
        range_max=scan.range_max,
        ranges=array("f", scan.ranges),
    )


def point_msg(detection: Detection) -> geometry_msgs.PointStamped:
    """Return the message of a detection."""
    x, y, z = detection.point
    return geometry_msgs.PointStamped(
        header=_header(detection.stamp_ns, detection.frame_id), point=geometry_msgs.Point(x=x, y=y, z=z)
    )


def imu_msg(reading: ImuReading) -> sensor_msgs.Imu:
    """Return the message of an imu."""
    message = sensor_msgs.Imu(header=_header(reading.stamp_ns, reading.frame_id))
    turn, push, look = message.angular_velocity, message.linear_acceleration, message.orientation
    turn.x, turn.y, turn.z = reading.angular_velocity
    push.x, push.y, push.z = reading.linear_acceleration
    look.x, look.y, look.z, look.w = reading.orientation
    return message


def _header(stamp_ns: int, frame_id: str) -> std_msgs.Header:
    return std_msgs.Header(stamp=msg_from_stamp(stamp_ns), frame_id=frame_id)
