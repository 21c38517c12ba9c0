"""Explain, when `rviz2` is typed in a shell, that there is no window, and name `%rviz2` for pages."""

from __future__ import annotations

import argparse
from collections.abc import Sequence

__all__ = ["ANSWER", "main", "parser"]

ANSWER = """\
rviz2 is a window of its own, which a shell does not have. In a page, tflab draws instead:
    %rviz2 -f map
or, to keep the view and show it something new later:
    from tflab.tools.rviz import look, open_rviz
    view = open_rviz(fixed_frame="map")
    view.update(*look())
On a robot, `rviz2` opens the real one: set Fixed Frame to map or odom, then Add > TF."""


def parser() -> argparse.ArgumentParser:
    """Return the options of rviz2 that make sense here, with its help texts."""
    options = argparse.ArgumentParser(prog="rviz2")
    options.add_argument(
        "-f", "--fixed-frame", metavar="FRAME", default="map", help="Set the fixed frame (default: map)"
    )
    return options


def main(arguments: Sequence[str]) -> int:
    """Say which view to open; return the exit code."""
    parser().parse_args(arguments)
    print(ANSWER)
    return 0
