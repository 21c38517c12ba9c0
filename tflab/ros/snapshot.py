"""Describe the nodes, topics and transform publishers of a graph as plain values.

Unlike anything on a robot, this knows the publisher of every transform: in one
process nothing gets lost on the wire.  `BufferCore.snapshot` shows a buffer.
"""

from __future__ import annotations

from typing import NamedTuple

from .graph import Graph
from .graph_queries import TopicEndpointInfo, endpoint_info

__all__ = ["EdgeSnapshot", "GraphSnapshot", "NodeSnapshot", "TopicSnapshot", "snapshot"]


class NodeSnapshot(NamedTuple):
    """A node.

    Attributes:
        name: "/namespace/name".
        participant: the process it lives in; "main" for the notebook or script.
        publishes, subscribes, serves: names, sorted.
        follows_clock: whether its time comes from /clock.
        clock_offset_ns: how far its clock is set wrong [ns].
    """

    name: str
    participant: str
    publishes: tuple[str, ...]
    subscribes: tuple[str, ...]
    serves: tuple[str, ...]
    follows_clock: bool
    clock_offset_ns: int


class TopicSnapshot(NamedTuple):
    """A topic, and who is at its ends, in the order they came."""

    name: str
    types: tuple[str, ...]
    publishers: tuple[TopicEndpointInfo, ...]
    subscriptions: tuple[TopicEndpointInfo, ...]


class EdgeSnapshot(NamedTuple):
    """One transform that somebody publishes.

    Attributes:
        parent, child: its frames.
        topic: "/tf" or "/tf_static", as a rule.
        node: who publishes it.
        count: how often so far.
    """

    parent: str
    child: str
    topic: str
    node: str
    count: int


class GraphSnapshot(NamedTuple):
    """A graph at one moment; each part sorted by name."""

    now_ns: int
    nodes: tuple[NodeSnapshot, ...]
    topics: tuple[TopicSnapshot, ...]
    edges: tuple[EdgeSnapshot, ...]


def snapshot(graph: Graph) -> GraphSnapshot:
    """Return what there is to see of a graph now."""
    nodes = [
        NodeSnapshot(
            name=node.get_fully_qualified_name(),
            participant=node.context.process.name,
            publishes=tuple(sorted({each.topic_name for each in node.publishers})),
            subscribes=tuple(sorted({each.topic_name for each in node.subscriptions})),
            serves=tuple(sorted({each.srv_name for each in node.services})),
            follows_clock=node.get_clock().is_simulated,
            clock_offset_ns=node.get_clock().offset_ns,
        )
        for node in graph.nodes
    ]
    topics, edges = [], []
    for name, types in graph.network.topic_names_and_types():
        topic = graph.network.topics[name]
        topics.append(
            TopicSnapshot(
                name,
                tuple(types),
                tuple(map(endpoint_info, topic.publishers)),
                tuple(map(endpoint_info, topic.subscriptions)),
            )
        )
        for publisher in topic.publishers:
            for (parent, child), count in publisher.edges.items():
                edges.append(EdgeSnapshot(parent, child, name, publisher.node.get_fully_qualified_name(), count))
    return GraphSnapshot(graph.now_ns, tuple(sorted(nodes)), tuple(topics), tuple(sorted(edges)))
