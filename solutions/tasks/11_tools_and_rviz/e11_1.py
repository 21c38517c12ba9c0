"""E11.1: Which tool for which question?"""

from __future__ import annotations

from tflab.workbook.tasks import Choice, Parts, define_task

TOOLS = (
    "view_frames", "tf2_echo", "tf2_monitor", "topic hz", "topic delay", "topic info --verbose", "RViz",
    "no ROS 2 tool",
)  # fmt: skip

RIGHT = {
    "trees": "view_frames",
    "edge rate": "view_frames",
    "height": "tf2_echo",
    "chain": "tf2_monitor",
    "scan": "topic delay",
    "on tf": "topic info --verbose",
    "sender": "no ROS 2 tool",
    "wall": "RViz",
}

TASK = define_task(__file__, kind="M", points=3, answer="tools", form=Parts({part: Choice(TOOLS) for part in RIGHT}))
