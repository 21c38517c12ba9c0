"""Define rcl_interfaces: parameters and logs."""

from .packages import ros_package

globals().update(ros_package(__name__))
