"""Define action_msgs: goals, their status, and cancellation."""

from .packages import ros_package

globals().update(ros_package(__name__))
