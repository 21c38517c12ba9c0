"""Who really publishes each edge?  The tree of a graph, with names that ROS 2 itself does not know.

    odom -> base_link     published by /ekf, /wheel_odometry      <- a fault, and both are named

`view_frames` and `tf2_monitor` cannot say who it was; in one process nothing gets
lost on the wire, so here we can.  On a robot, `ros2 topic info /tf --verbose`
names the nodes, though not their frames.
"""

from __future__ import annotations

from collections.abc import Sequence

from tflab.core import FrameSnapshot, Snapshot
from tflab.ros.graph import Graph, current_graph
from tflab.ros.snapshot import EdgeSnapshot, snapshot
from tflab.views.tree import TreePicture, draw_tree

from .session import result_of, spin_for, tool_node

__all__ = ["frame_tree", "with_publishers"]


def frame_tree(graph: Graph | None = None, seconds: float = 5.0) -> TreePicture:
    """Listen for `seconds` [s] of a graph's time, the current one's if None, and draw its tree with its publishers.

    Raises:
        ValueError: that is no time to listen for.
        RuntimeError: it was ended before it had heard anything.
    """
    graph = current_graph() if graph is None else graph
    before = {edge[:4]: edge.count for edge in snapshot(graph).edges}
    heard = result_of(graph, lambda: _listen(seconds), seconds, name="frame_tree")
    now = snapshot(graph)
    active = [edge for edge in now.edges if edge.topic == "/tf_static" or edge.count > before.get(edge[:4], 0)]
    return draw_tree(with_publishers(heard, active), now.now_ns)


def with_publishers(tree: Snapshot, edges: Sequence[EdgeSnapshot]) -> Snapshot:
    """Return a tree whose owners are the nodes that publish `edges`, each of the edge that it does publish."""
    return Snapshot(tree.roots, tuple(_with_publishers(frame, edges) for frame in tree.frames))


def _with_publishers(frame: FrameSnapshot, edges: Sequence[EdgeSnapshot]) -> FrameSnapshot:
    known = {(edge.parent, edge.node) for edge in edges if edge.child == frame.name}
    parents = {parent for parent, _ in known}
    heard = {(parent, owner) for parent, owner in frame.owners if parent not in parents}
    return frame._replace(owners=tuple(sorted(known | heard)))


def _listen(seconds: float) -> Snapshot:
    from tflab.ros.tf2.buffer import Buffer
    from tflab.ros.tf2.topics import TransformListener

    with tool_node("frame_tree", start_parameter_services=False) as node:
        buffer = Buffer()
        listener = TransformListener(buffer, node)
        spin_for(node, seconds)
        listener.unregister()
        return buffer.core.snapshot()
