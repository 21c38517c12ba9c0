"""E5.3: Which frame for which purpose?"""

from __future__ import annotations

from tflab.workbook.tasks import Choice, Parts, define_task

RIGHT = {
    "dock": "map",
    "line": "odom",
    "laser": "base_link",
    "kitchen": "map",
    "speed": "odom",
    "obstacles": "odom",
    "tray": "base_link",
    "goal": "map",
}

TASK = define_task(
    __file__,
    kind="M",
    points=4,
    answer="jobs",
    form=Parts({job: Choice(("map", "odom", "base_link"), are_frames=True) for job in RIGHT}),
)
