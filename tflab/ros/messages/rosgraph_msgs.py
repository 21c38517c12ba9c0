"""rosgraph_msgs: the time that everybody follows under `use_sim_time`.

Read `rcl_interfaces.py` next.
"""

from .base import message

Clock = message("rosgraph_msgs/msg/Clock", "builtin_interfaces/Time clock")
