"""Define example_interfaces, the types of ROS 2's tutorials."""

from .packages import ros_package

globals().update(ros_package(__name__))
