"""Define tf2_msgs: the messages of /tf and /tf_static, and the action LookupTransform."""

from .packages import ros_package

globals().update(ros_package(__name__))
