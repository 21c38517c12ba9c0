"""Run `%ros2` in a page, on the current graph whose time advances meanwhile, and complete its line.

```
%load_ext tflab                              registers the magic
graph.start(main)                            a first cell
%ros2 run tf2_ros tf2_echo odom base_link    a second cell sees what the first one started
%rviz2 -f map                                a small RViz, after a second of listening
%turtlesim                                   the field of turtlesim, as it is now
```
"""

from __future__ import annotations

import sys
from collections.abc import Mapping, Sequence
from contextlib import redirect_stderr
from types import MappingProxyType
from typing import Any, NamedTuple

from tflab.ros.activation import PACKAGES
from tflab.ros.graph import Graph, current_graph
from tflab.ros.messages.packages import all_types
from tflab.ros.snapshot import snapshot

from . import ros2, rviz2
from .page import LineError, run_words, split_line

__all__ = ["Known", "complete", "complete_line", "known_in", "register", "ros2_line"]


def register(ipython: Any) -> None:
    """Give a notebook `%ros2`, with completion, `%rviz2` and `%turtlesim`."""
    ipython.register_magic_function(ros2_line, "line", "ros2")
    ipython.register_magic_function(rviz2_line, "line", "rviz2")
    ipython.register_magic_function(turtlesim_line, "line", "turtlesim")
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


def turtlesim_line(line: str) -> None:
    """Show the field of each turtlesim in the current graph, as it is now."""
    from tflab.robots.turtlesim import SIZE_M, TurtleSim
    from tflab.views.turtles import draw_turtles

    sims = [node for node in current_graph().nodes if isinstance(node, TurtleSim)]
    for sim in sims:
        poses = {name: (turtle.x, turtle.y, turtle.theta) for name, turtle in sim.turtles.items()}
        _show(draw_turtles(sim.canvas, sim.background, poses, SIZE_M))
    if not sims:
        print("No turtlesim runs in this graph. Start one: %ros2 run turtlesim turtlesim_node")


def _run(words: Sequence[str], seconds: float | None) -> None:
    if words[:3] == ["run", "rviz2", "rviz2"]:
        pictures = _rviz(words[3:], seconds)
    else:
        with redirect_stderr(sys.stdout):  # a terminal shows both in one; so the lines keep their order
            pictures = run_words(current_graph(), words, seconds).pictures
    _show(*pictures)


def _show(*pictures: Any) -> None:
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


FRAME_TOOLS = ("tf2_echo", "tf2_monitor")


class Known(NamedTuple):
    """What there is in a graph to be named."""

    frames: Sequence[str] = ()
    topics: Sequence[str] = ()
    nodes: Sequence[str] = ()
    parameters: Mapping[str, Sequence[str]] = MappingProxyType({})


def known_in(graph: Graph) -> Known:
    """Return what a graph has to be named."""
    seen = snapshot(graph)
    return Known(
        frames=sorted({frame for edge in seen.edges for frame in (edge.parent, edge.child)}),
        topics=[topic.name for topic in seen.topics],
        nodes=[node.name for node in seen.nodes],
        parameters={node.get_fully_qualified_name(): sorted(node.get_parameters_by_prefix("")) for node in graph.nodes},
    )


def complete(words: Sequence[str], begun: str, known: Known) -> list[str]:
    """Return what can stand after `words` (without `ros2`), of that what begins with `begun`."""
    return sorted({each for each in _possible(list(words), known) if each.startswith(begun)})


def _possible(words: list[str], known: Known) -> Sequence[str]:
    match words:
        case []:
            return list(ros2.COMMANDS)
        case ["run"]:
            return list(ros2.EXECUTABLES)
        case ["run", package]:
            return list(ros2.EXECUTABLES.get(package, {}))
        case ["run", _, tool, *arguments] if tool in FRAME_TOOLS:
            return known.frames if len(arguments) < 2 else ()
        case ["run", _, "static_transform_publisher", *_, "--frame-id" | "--child-frame-id"]:
            return known.frames
        case [command]:
            return ros2.verbs_of(command)
        case ["topic", "echo" | "hz" | "info" | "delay" | "type", *options] if _only_options(options):
            return known.topics
        case ["node", "info", *options] | ["param" | "lifecycle", _, *options] if _only_options(options):
            return known.nodes
        case ["interface", "show" | "proto", *options] if _only_options(options):
            return list(all_types())
        case ["interface", "package"]:
            return PACKAGES
        case ["param", "get" | "set", node]:
            return known.parameters.get(node, ())
    return ()


def _only_options(words: Sequence[str]) -> bool:
    return all(word.startswith("-") for word in words)
