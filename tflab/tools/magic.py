"""What does `%ros2` do in a page?  It runs the tool on the current graph, and time passes meanwhile.

    %load_ext tflab                              registers the magic
    graph.start(main)                            a first cell
    %ros2 run tf2_ros tf2_echo odom base_link    a second cell sees what the first one started

Read `shell.py` next: the same in a shell.
"""

from __future__ import annotations

from typing import Any

from tflab.ros.graph import current_graph

from .completion import complete, known_in
from .page import PageError, run_words, split_line

__all__ = ["complete_line", "register", "ros2_line"]


def register(ipython: Any) -> None:
    """Give a notebook `%ros2` and `%rviz2`, with completion."""
    ipython.register_magic_function(ros2_line, "line", "ros2")
    ipython.register_magic_function(lambda line: ros2_line(f"rviz2 {line}"), "line", "rviz2")
    for prefix in ("%ros2", "ros2"):  # with automagic the percent sign may be left out
        ipython.set_hook("complete_command", lambda shell, event: complete_line(event.line), str_key=prefix)


def ros2_line(line: str) -> None:
    """Run what stands after `%ros2`, and show the pictures it has."""
    try:
        seconds, words = split_line(line)
    except PageError as fault:
        print(fault)
        return
    outcome = run_words(current_graph(), words, seconds)
    if outcome.pictures:
        from IPython.display import display

        display(*outcome.pictures)


def complete_line(line: str) -> list[str]:
    """Return what can stand at the end of a line that begins with `%ros2`."""
    words = line.split()[1:]
    begun = "" if line.endswith(" ") or not words else words.pop()
    while words[:1] == ["--for"]:
        words = words[2:]
    return complete(words, begun, known_in(current_graph()))
