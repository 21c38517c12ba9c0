"""What can be typed next?  Commands, verbs and programs, and what the graph has: frames, topics, nodes.

```
%ros2 to|                              topic
%ros2 topic echo /t|                   /tf  /tf_static
%ros2 run tf2_ros tf2_echo map ba|     base_link
```
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from types import MappingProxyType
from typing import NamedTuple

from tflab.ros.activation import PACKAGES
from tflab.ros.graph import Graph
from tflab.ros.messages.base import all_types
from tflab.ros.snapshot import snapshot

from . import ros2

__all__ = ["Known", "complete", "known_in"]

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
