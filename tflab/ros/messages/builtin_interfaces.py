"""Define builtin_interfaces: Time and Duration."""

from .packages import ros_package

globals().update(ros_package(__name__))
