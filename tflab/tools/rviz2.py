"""Where is RViz?  Not here: `rviz2` answers with the view that does its work in a page.

Read `ros2.py` next.
"""

from __future__ import annotations

from collections.abc import Sequence

__all__ = ["ANSWER", "main"]

ANSWER = """\
rviz2 is a window of its own, which a page does not have. In a page, tflab draws instead:
    from tflab.views import rviz      # a small RViz: Fixed Frame, TF, LaserScan, PointCloud2, RobotModel, Path
    help(rviz)
On a robot, `rviz2` opens the real one: set Fixed Frame to map or odom, then Add > TF."""


def main(arguments: Sequence[str]) -> int:
    """Say which view to open; return the exit code."""
    print(ANSWER)
    return 0
