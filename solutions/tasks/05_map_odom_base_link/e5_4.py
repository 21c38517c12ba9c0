"""E5.4: A robot that flickers."""

from __future__ import annotations

from tflab.workbook.tasks import Choice, Parts, define_task

TASK = define_task(
    __file__,
    kind="D",
    points=3,
    answer="finding",
    form=Parts(
        {
            "node": Choice(("/wheels", "/scan_matcher", "/robot_state_publisher")),
            "edge": Choice(("map -> odom", "map -> base_link", "odom -> base_footprint", "none")),
            "error": Choice(("LookupException", "ConnectivityException", "nothing")),
        }
    ),
)
