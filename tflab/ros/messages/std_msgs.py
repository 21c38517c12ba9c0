"""Define std_msgs: single values and the header."""

from .packages import ros_package

globals().update(ros_package(__name__))
