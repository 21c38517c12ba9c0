"""Messages of rosgraph_msgs, in process."""

from tflab.ros.messages.rosgraph_msgs import Clock as Clock
