"""What does `%ros2` do in a page?  It runs the tool on the current graph, and time passes meanwhile.

```
%load_ext tflab                              registers the magic
graph.start(main)                            a first cell
%ros2 run tf2_ros tf2_echo odom base_link    a second cell sees what the first one started
%rviz2 -f map                                a small RViz, after a second of listening
```
"""

from __future__ import annotations

import sys
from collections.abc import Sequence
from contextlib import redirect_stderr
from typing import Any

from tflab.ros.graph import current_graph

from . import rviz2
from .completion import complete, known_in
from .page import LineError, run_words, split_line

__all__ = ["complete_line", "register", "ros2_line"]


def register(ipython: Any) -> None:
    """Give a notebook `%ros2` and `%rviz2`, with completion."""
    ipython.register_magic_function(ros2_line, "line", "ros2")
    ipython.register_magic_function(rviz2_line, "line", "rviz2")
    for prefix in ("%ros2", "ros2"):  # with automagic the percent sign may be left out
        ipython.set_hook("complete_command", lambda shell, event: complete_line(event.line), str_key=prefix)


def ros2_line(line: str) -> None:
    """Run what stands after `%ros2`, and show the pictures it has."""
    try:
        seconds, words = split_line(line)
    except LineError as fault:
        print(fault)
        return
    _run(words, seconds)


def rviz2_line(line: str) -> None:
    """Show a small RViz of the current graph; `line` is what stands after `%rviz2`."""
    try:
        seconds, arguments = split_line(line)
    except LineError as fault:
        print(fault)
        return
    _run(["run", "rviz2", "rviz2", *arguments], seconds)


def _run(words: Sequence[str], seconds: float | None) -> None:
    if words[:3] == ["run", "rviz2", "rviz2"]:
        pictures = _rviz(words[3:], seconds)
    else:
        with redirect_stderr(sys.stdout):  # a terminal shows both in one; so the lines keep their order
            pictures = run_words(current_graph(), words, seconds).pictures
    if pictures:
        from IPython.display import display

        display(*pictures)


def _rviz(arguments: Sequence[str], seconds: float | None) -> tuple[Any, ...]:
    """Return a small RViz of the current graph; nothing if the arguments are wrong, which has been said then."""
    from .rviz import open_rviz

    try:
        options = rviz2.parser().parse_args(arguments)
    except SystemExit:
        return ()
    return (open_rviz(current_graph(), options.fixed_frame, 1.0 if seconds is None else seconds),)


def complete_line(line: str) -> list[str]:
    """Return what can stand at the end of a line that begins with `%ros2`."""
    words = line.split()[1:]
    begun = "" if line.endswith(" ") or not words else words.pop()
    while words[:1] == ["--for"]:
        words = words[2:]
    return complete(words, begun, known_in(current_graph()))
