"""Define rosgraph_msgs: the time of /clock."""

from .packages import ros_package

globals().update(ros_package(__name__))
