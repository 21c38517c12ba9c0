"""Define the interfaces of turtlesim."""

from .packages import ros_package

globals().update(ros_package(__name__))
