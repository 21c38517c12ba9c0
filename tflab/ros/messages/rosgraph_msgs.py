"""Define rosgraph_msgs: the time of /clock."""

from .base import message

Clock = message("rosgraph_msgs/msg/Clock", "builtin_interfaces/Time clock")
