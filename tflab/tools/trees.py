"""Draw frame trees, lookup paths and histories of a graph or a buffer, with the node that publishes each edge.

    odom -> base_link     published by /ekf, /wheel_odometry      <- a fault, and both are named

`view_frames` and `tf2_monitor` cannot say who it was; in one process nothing gets
lost on the wire, so here we can.  On a robot, `ros2 topic info /tf --verbose`
names the nodes, though not their frames.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from tflab.core import LATEST, BufferCore, FrameSnapshot, Snapshot, Transform, TransformException
from tflab.ros.graph import Graph, current_graph
from tflab.ros.snapshot import EdgeSnapshot, snapshot
from tflab.ros.tf2.core import BufferCore as RosBuffer
from tflab.views import tree_path
from tflab.views.tree import TreePicture, draw_tree

from .session import result_of, spin_for, tool_node

__all__ = [
    "draw_buffer",
    "draw_history",
    "draw_walk",
    "edges_between",
    "frame_tree",
    "with_publishers",
]


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


if TYPE_CHECKING:
    from tflab.views.picture import Picture
    from tflab.views.timeline import TimelinePicture


def draw_buffer(buffer: BufferCore | RosBuffer, now_ns: int | None = None) -> TreePicture:
    """Draw the tree of a buffer; ages are reckoned from `now_ns` [ns]."""
    return draw_tree(_core(buffer).snapshot(), now_ns)


def draw_walk(buffer: BufferCore | RosBuffer, target_frame: str, source_frame: str) -> Picture:
    """Draw the tree of a buffer, and in it the way from `source_frame` up and down to `target_frame`.

    Raises:
        ValueError: there is no such frame.
    """
    return tree_path.draw_walk(_core(buffer).snapshot(), target_frame, source_frame)


def draw_history(
    buffer: BufferCore | RosBuffer, target_frame: str, source_frame: str, stamp_ns: int = LATEST
) -> TimelinePicture:
    """Draw what a buffer knew of the edges between two frames, and what it answers at `stamp_ns` [ns].

    Raises:
        LookupException: a frame was never named.
    """
    from tflab.views.timeline import draw_timeline, lane_from_history

    core = _core(buffer)
    for frame in (target_frame, source_frame):
        core.history(frame)
    children = edges_between(core.snapshot(), target_frame, source_frame)
    lanes = [lane_from_history(core.history(child)) for child in children]
    return draw_timeline(target_frame, source_frame, lanes, core.lookup_transform, stamp_ns)


def edges_between(tree: Snapshot, target_frame: str, source_frame: str) -> list[str]:
    """Return the child of each edge between two frames, from the target's side on.

    Frames of separate trees have no edge between; then it is every edge above either.
    """
    up_from_target, up_from_source = _way_up(tree, target_frame), _way_up(tree, source_frame)
    met = next((frame for frame in up_from_target if frame in up_from_source), None)
    target_side = _below(up_from_target, met or up_from_target[-1])
    source_side = _below(up_from_source, met or up_from_source[-1])
    return [*target_side, *reversed(source_side)]


def _below(way_up: list[str], top: str) -> list[str]:
    return way_up[: way_up.index(top)]


def _way_up(tree: Snapshot, frame: str) -> list[str]:
    """Return the frames from one up to its root; in a loop, each once."""
    parents = {edge.name: edge.parent for edge in tree.frames}
    path = [frame]
    while parents.get(path[-1]) is not None and parents[path[-1]] not in path:
        path.append(parents[path[-1]])
    return path


def _pose(core: BufferCore, fixed_frame: str, frame: str, stamp_ns: int) -> Transform | None:
    try:
        return core.lookup_transform(fixed_frame, frame, stamp_ns).transform
    except TransformException:
        return None


def _core(buffer: BufferCore | RosBuffer) -> BufferCore:
    return buffer.core if isinstance(buffer, RosBuffer) else buffer
