"""rosgraph_msgs: the time that everybody follows under `use_sim_time`."""

from .base import message

Clock = message("rosgraph_msgs/msg/Clock", "builtin_interfaces/Time clock")
