"""Describe the tree as tf2's tools do: as a list, as YAML, as a Graphviz drawing.

    Frame base_link exists with parent odom.

These are the texts that tf2's own tools print and that `view_frames` draws from,
to the letter, their spelling mistake included.  Rates are n / span, not
(n - 1) / span, and a single sample or a static transform counts 10000 Hz:
that is how tf2 reckons.

tf2: BufferCore::allFramesAsString, allFramesAsYAML, _allFramesAsDot.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from .stamps import NSEC_PER_SEC, format_stamp
from .tree import FrameTree

__all__ = ["EdgeSummary", "all_frames_as_dot", "all_frames_as_string", "all_frames_as_yaml", "edges"]

SHORTEST_SPAN_NS = 100_000


class EdgeSummary(NamedTuple):
    """One child with data, and what can be said of its history at a glance."""

    parent: str
    child: str
    authority: str
    rate_hz: float
    oldest_ns: int
    newest_ns: int

    @property
    def span_ns(self) -> int:
        return self.newest_ns - self.oldest_ns


def edges(tree: FrameTree) -> Iterator[EdgeSummary]:
    """Yield every edge with data, in the order in which the children were first named."""
    for number, cache in enumerate(tree.caches):
        if number == 0 or cache is None or len(cache) == 0:
            continue
        span_ns = max(cache.newest_ns - cache.oldest_ns, SHORTEST_SPAN_NS)
        yield EdgeSummary(
            parent=tree.names[cache.newest_parent],
            child=tree.names[number],
            authority=tree.authorities.get(number, "no recorded authority"),
            rate_hz=len(cache) * NSEC_PER_SEC / span_ns,
            oldest_ns=cache.oldest_ns,
            newest_ns=cache.newest_ns,
        )


def all_frames_as_string(tree: FrameTree) -> str:
    """Return one line for each frame that has, or had, a parent."""
    return "".join(
        f"Frame {tree.names[number]} exists with parent {tree.names[cache.newest_parent]}.\n"
        for number, cache in enumerate(tree.caches)
        if number != 0 and cache is not None
    )


def all_frames_as_yaml(tree: FrameTree, now_ns: int = 0) -> str:
    """Return what the service `tf2_frames` answers; with `now_ns`, also how old each edge is."""
    if len(tree.names) == 1:
        return "[]"
    blocks = []
    for edge in edges(tree):
        delay = f"  transform_delay: {format_stamp(now_ns - edge.newest_ns, 3)}\n" if now_ns else ""
        blocks.append(
            f"{edge.child}: \n"
            f"  parent: '{edge.parent}'\n"
            f"  broadcaster: '{edge.authority}'\n"
            f"  rate: {edge.rate_hz:.3f}\n"
            f"  most_recent_transform: {format_stamp(edge.newest_ns)}\n"
            f"  oldest_transform: {format_stamp(edge.oldest_ns)}\n"
            f"{delay}"
            f"  buffer_length: {format_stamp(edge.span_ns, 3)}\n"
        )
    return "".join(blocks)


def all_frames_as_dot(tree: FrameTree, now_ns: int = 0) -> str:
    """Return the tree in Graphviz's language; with `now_ns`, also how old each edge is."""
    lines = ["digraph G {"]
    if len(tree.names) == 1:
        return 'digraph G {\n"no tf data recieved"}'
    for edge in edges(tree):
        age = f"( {format_stamp(now_ns - edge.newest_ns, 3)} sec old)" if now_ns else ""
        lines.append(
            f'"{edge.parent}" -> "{edge.child}"[label="'
            f"Broadcaster: {edge.authority}\\n"
            f"Average rate: {edge.rate_hz:.3f} Hz\\n"
            f"Most recent transform: {format_stamp(edge.newest_ns)} {age}\\n"
            f'Buffer length: {format_stamp(edge.span_ns, 3)} sec\\n"];'
        )
    recorded = f'"Recorded at time: {format_stamp(now_ns)}"[ shape=plaintext ] ;\n ' if now_ns else ""
    for number, cache in enumerate(tree.caches):
        is_root = number != 0 and cache is None
        was_emptied = number != 0 and cache is not None and len(cache) == 0
        if was_emptied or (is_root and now_ns):
            lines.append(
                "edge [style=invis];\n"
                ' subgraph cluster_legend { style=bold; color=black; label ="view_frames Result";\n'
                f'{recorded}}}->"{tree.names[number]}";'
            )
    return "\n".join(lines) + "\n}"
