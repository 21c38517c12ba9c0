"""Look at a graph as RViz would, and return plain values for the view in `tflab.views.rviz`.

    /tf, /tf_static      -> a buffer             -> ask(target, source, stamp)
    /scan, /points, ...  -> the newest messages  -> displays
    /robot_description   -> links                -> a RobotModel

RViz keeps a message until its transform has come.  So does a look: it takes the
newest message of each topic, and listens to the transforms for a moment longer.
What still cannot be placed then has a reason, and RViz's words for it.  What came
before the first transforms is dropped, as RViz's message filter does, if there is
something newer to show.

    view = open_rviz()             a small RViz of the current graph
    view.update(*look())           later: the same view, what there is now
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import replace
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from tflab.core import (
    NSEC_PER_SEC,
    BufferCore,
    ExtrapolationException,
    Transform,
    TransformException,
    stamp_from_sec_nanosec,
)
from tflab.ros.graph import Graph, current_graph
from tflab.ros.messages import nav_msgs, sensor_msgs, std_msgs
from tflab.ros.node import Node

from .session import CPP_AUTHORITY, result_of, spin_for, tool_node

if TYPE_CHECKING:
    from tflab.views.rviz import RViz
    from tflab.views.rviz_status import Display

__all__ = ["RVizInput", "links_to_see", "look", "open_rviz"]

PATIENCE_S = 0.2  # how long a message may wait for its transform
DESCRIPTION = "/robot_description"
OCCUPIED = 65  # of a map's cell, in per cent


class RVizInput(NamedTuple):
    """What RViz's view takes: every frame with its parent, the displays, and whom to ask."""

    parents: dict[str, str]
    displays: tuple[Display, ...]
    ask: Callable[[str, str, int], Transform]


def open_rviz(graph: Graph | None = None, fixed_frame: str = "map", seconds: float = 1.0) -> RViz:
    """Return a small RViz of a graph, the current one if None, after a look of `seconds` [s] of its time."""
    from tflab.views.rviz import RViz

    return RViz(*look(graph, seconds), fixed_frame=fixed_frame)


def look(graph: Graph | None = None, seconds: float = 1.0, decay_s: float = 0.0) -> RVizInput:
    """Listen to a graph for `seconds` [s] of its time, and return what RViz would have to show.

    Args:
        decay_s: how long a message stays on the screen, RViz's "Decay Time" [s]; 0: until the next one.

    Raises:
        ValueError: that is no time to listen for.
        RuntimeError: it was ended before it had heard anything.
    """
    graph = current_graph() if graph is None else graph
    return result_of(graph, lambda: _watch(seconds, decay_s), seconds, name="rviz2")


def _watch(seconds: float, decay_s: float) -> RVizInput:
    from tflab.ros.tf2.buffer import Buffer
    from tflab.ros.tf2.topics import TransformListener

    with tool_node("rviz", start_parameter_services=False) as node:
        buffer = Buffer()
        listener = TransformListener(buffer, node)
        listener.authority = CPP_AUTHORITY
        heard = _hear_everything(node)
        spin_for(node, seconds)
        displays = tuple(_displays(heard, decay_s))
        spin_for(node, PATIENCE_S)
        listener.unregister()
        parents = _parents(buffer.core)
        displays = tuple(_without_forerunners(display, buffer.core, parents) for display in displays)
        return RVizInput(parents, displays, _asking(buffer.core))


def _hear_everything(node: Node) -> dict[str, tuple[type, list[Any]]]:
    """Subscribe to each topic that RViz has a display for; return its type and what will come, by topic."""
    from tflab.ros.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy

    heard: dict[str, tuple[type, list[Any]]] = {}
    latched = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    lenient = QoSProfile(depth=100, reliability=ReliabilityPolicy.BEST_EFFORT)
    for topic, types in node.get_topic_names_and_types():
        message_type = SHOWN.get(types[0])
        if message_type is None or (message_type is std_msgs.String and topic != DESCRIPTION):
            continue
        is_latched = message_type in (std_msgs.String, nav_msgs.OccupancyGrid)
        messages: list[Any] = []
        heard[topic] = (message_type, messages)
        node.create_subscription(message_type, topic, messages.append, latched if is_latched else lenient)
    return heard


def _parents(core: BufferCore) -> dict[str, str]:
    tree = core.snapshot()
    return dict.fromkeys(tree.roots, "") | {frame.name: frame.parent for frame in tree.frames}


def _asking(core: BufferCore) -> Callable[[str, str, int], Transform]:
    def ask(target_frame: str, source_frame: str, stamp_ns: int) -> Transform:
        return core.lookup_transform(target_frame, source_frame, stamp_ns).transform

    return ask


def _without_forerunners(display: Display, core: BufferCore, parents: dict[str, str]) -> Display:
    """Return a display without the messages that are older than the transforms heard; the newest stays in any case."""
    if not isinstance(display.content, tuple):
        return display
    placed = tuple(message for message in display.content if not _is_forerunner(message, core, parents))
    return replace(display, content=placed or display.content[-1:])


def _is_forerunner(message: Any, core: BufferCore, parents: dict[str, str]) -> bool:
    root = message.frame_id
    for _ in parents:  # no further than there are frames: a loop has no root
        root = parents.get(root) or root
    try:
        core.lookup_transform(root, message.frame_id, message.stamp_ns)
    except ExtrapolationException as fault:
        return fault.direction == "past"
    except TransformException:
        return False
    return False


# -- messages as values ---------------------------------------------------


def _displays(heard: dict[str, tuple[type, list[Any]]], decay_s: float) -> Iterator[Display]:
    for topic, (message_type, messages) in sorted(heard.items()):
        try:
            yield _display(topic, message_type, messages, decay_s)
        except (ValueError, AssertionError) as fault:  # no URDF, a cloud without x, y, z, a map of another size
            print(f"{topic} cannot be shown: {fault}")


def _display(topic: str, message_type: type, messages: list[Any], decay_s: float) -> Display:
    from tflab.views.rviz_status import Display, RobotModel

    if topic == DESCRIPTION:
        links = links_to_see(messages[-1].data) if messages else {}
        return Display("RobotModel", RobotModel(links), topic)
    values = [_value(message) for message in messages]
    newest_ns = max((value.stamp_ns for value in values), default=0)
    shown = tuple(value for value in values if newest_ns - value.stamp_ns <= decay_s * NSEC_PER_SEC)
    kind = "Map" if message_type is nav_msgs.OccupancyGrid else message_type.__name__
    return Display(kind, shown if decay_s else shown[-1:], topic)


def _value(message: Any) -> Any:
    """Return a message as the view's value of the same name."""
    from tflab.views.rviz_status import LaserScan, MapCells, Path, PointCloud2

    stamp = message.header.stamp
    head = (message.header.frame_id, stamp_from_sec_nanosec(stamp.sec, stamp.nanosec))
    match message:
        case sensor_msgs.LaserScan():
            ranges = np.array(message.ranges, dtype=float)
            ranges[(ranges < message.range_min) | (ranges > message.range_max)] = math.inf  # RViz leaves them out
            return LaserScan(*head, ranges, message.angle_min, message.angle_increment)
        case sensor_msgs.PointCloud2():
            from tflab.ros.tf2.clouds import read_points_numpy

            return PointCloud2(*head, read_points_numpy(message, ["x", "y", "z"], skip_nans=True))
        case nav_msgs.Path():
            return Path(*head, [(at.x, at.y, at.z) for at in (each.pose.position for each in message.poses)])
    return MapCells(*head, _occupied(message), message.info.resolution)


def _occupied(grid: nav_msgs.OccupancyGrid) -> np.ndarray:
    """Return the middles of the occupied cells, shape (n, 2) [m]."""
    info = grid.info
    cells = np.array(grid.data, dtype=np.int8).reshape(info.height, info.width)
    rows, columns = np.nonzero(cells >= OCCUPIED)
    origin = info.origin.position
    return np.column_stack((columns + 0.5, rows + 0.5)) * info.resolution + (origin.x, origin.y)


def links_to_see(urdf: str) -> dict[str, tuple[Any, ...]]:
    """Return what is to be seen of each link; a mesh, whose file is not read, is left out."""
    from tflab.robots.urdf import parse_urdf

    return {
        link.name: tuple(part for shape in link.visuals if (part := _part(shape)) is not None)
        for link in parse_urdf(urdf).links
    }


def _part(shape: Any) -> Any:
    from tflab.robots.model import Box, Capsule, Cylinder, Sphere
    from tflab.views.scene.drawing import Part

    colour = {"rgba": shape.material.rgba} if shape.material is not None and shape.material.rgba else {}
    match shape.geometry:
        case Box(size):
            return Part("box", size, shape.origin, **colour)
        case Cylinder(radius, length) | Capsule(radius, length):
            return Part("cylinder", (radius, length), shape.origin, **colour)
        case Sphere(radius):
            return Part("sphere", (radius,), shape.origin, **colour)
    return None


SHOWN = {
    each.ROS_TYPE: each
    for each in (
        sensor_msgs.LaserScan, sensor_msgs.PointCloud2, nav_msgs.Path, nav_msgs.OccupancyGrid, std_msgs.String,
    )
}  # fmt: skip
