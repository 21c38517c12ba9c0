"""What is a finding told with?  Four sentences with blanks, and the commands that come up again and again.

```
title       what is wrong
evidence    what shows it
cause       why it usually happens
command     what to type on the robot next
```
"""

from __future__ import annotations

from typing import NamedTuple

__all__ = ["ECHO", "EDGE_HZ", "MONITOR", "SIM_TIME", "TOPIC_ECHO", "TOPIC_INFO", "VIEW_FRAMES", "Sentences"]

TOPIC_INFO = "ros2 topic info {topic} --verbose"
VIEW_FRAMES = "ros2 run tf2_tools view_frames"
ECHO = "ros2 run tf2_ros tf2_echo {parent} {child}"
MONITOR = "ros2 run tf2_ros tf2_monitor {parent} {child}"
# plain `hz` counts what all publishers of the topic send together
EDGE_HZ = "ros2 topic hz {topic} --filter \"any(t.child_frame_id == '{frame}' for t in m.transforms)\""
TOPIC_ECHO = "ros2 topic echo {topic} --once"
SIM_TIME = "ros2 param get /NODE use_sim_time"


class Sentences(NamedTuple):
    """What is said of one code, with blanks, or of one finding, without."""

    title: str
    evidence: str
    cause: str
    command: str
