"""Define lifecycle_msgs: states of a managed node, and services to change them."""

from .packages import ros_package

globals().update(ros_package(__name__))
