"""Define visualization_msgs."""

from .packages import ros_package

globals().update(ros_package(__name__))
