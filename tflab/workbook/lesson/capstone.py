"""Launch a robot as an answer to E12.5 describes it, beside the teaching robot, and print what it shows.

    {"tree": {...}, "ekf publish_tf": True, ...}  -->  a node for each owner  -->  RViz, who sends what, a bag

Each node sends what the answer gives it: a localiser the edges below map, wheels and filter the footprint if
their switch is on, the owner of the mounts the rest, and a camera driver its own edges once more if its
switch is on.  What is not written is not launched.  Nothing is judged here.
"""

from __future__ import annotations

import io
import math
from collections import Counter
from collections.abc import Callable, Iterable, Mapping
from contextlib import redirect_stderr, redirect_stdout
from typing import Any

from tflab.core import BufferCore, StampedTransform, Transform, TransformException
from tflab.robots.motion import Drive
from tflab.robots.nodes import launch
from tflab.robots.teaching import TeachingRobot
from tflab.ros import client_library as rclpy
from tflab.ros.convert import msg_from_stamped, stamped_from_msg
from tflab.ros.executors import ExternalShutdownException
from tflab.ros.graph import Graph, new_graph
from tflab.ros.messages import sensor_msgs, std_msgs, tf2_msgs
from tflab.ros.node import Node
from tflab.ros.qos import DurabilityPolicy, QoSProfile
from tflab.ros.snapshot import snapshot
from tflab.ros.tf2.clouds import create_cloud_xyz32
from tflab.ros.tf2.topics import StaticTransformBroadcaster, TransformBroadcaster
from tflab.tools.rviz import look
from tflab.views.rviz import RViz
from tflab.views.rviz_status import statuses_as_text

from ...text import Texts, language_of_workbook
from .scenes import wall_cloud

RATE_HZ, CLOUD_HZ = 20.0, 5.0
LAUNCHED_S, SETTLED_NS = 3.0, 300_000_000
FIRST_ROBOT = ("robot_state_publisher", "joint_driver", "wheel_odometry", "localization", "map_server")
TOPICS = ("/tf", "/tf_static")
SWITCHES = WHEELS, EKF, CAMERA = "wheel_odometry publish_tf", "ekf publish_tf", "camera_driver publish_tf"
OPTICAL = Transform.from_rpy(roll=-math.pi / 2.0, yaw=-math.pi / 2.0)
TEXTS = Texts(__file__)


class EdgeOwner(Node):
    """Sends its edges: again and again on /tf, once on /tf_static.

    Args:
        edges: child -> parent.
        slant: how far its opinion of a turn is from that of others [rad].
    """

    def __init__(self, name: str, namespace: str, edges: Mapping[str, str], topic: str, slant: float = 0.0) -> None:
        super().__init__(name, namespace=namespace)
        self._edges, self._slant = dict(edges), slant
        self._broadcaster = (StaticTransformBroadcaster if topic == "/tf_static" else TransformBroadcaster)(self)
        self.tell()
        if topic != "/tf_static":
            self.create_timer(1.0 / RATE_HZ, self.tell)

    def tell(self) -> None:
        """Send every edge as it is now."""
        now_ns = self.get_clock().now().nanoseconds
        edges = [
            StampedTransform(parent, child, now_ns, self._pose(child, now_ns)) for child, parent in self._edges.items()
        ]
        self._broadcaster.sendTransform([msg_from_stamped(edge) for edge in edges])

    def _pose(self, child: str, now_ns: int) -> Transform:
        turn = 0.5 * now_ns * 1e-9 + self._slant
        if _is(child, "odom"):
            return Transform((2.0, -1.0, 0.0))
        if _is(child, "base_footprint"):
            return Transform.from_rpy(yaw=turn, translation=(math.sin(turn), -math.cos(turn), 0.0))
        return OPTICAL if child.endswith("optical_frame") else Transform((0.1, 0.0, 0.2))


class CloudDriver(Node):
    """Publishes what its camera sees, in the optical frame."""

    def __init__(self, namespace: str, frame: str) -> None:
        super().__init__("camera_driver", namespace=namespace)
        self._frame = frame
        self._clouds = self.create_publisher(sensor_msgs.PointCloud2, "points", 10)
        self.create_timer(1.0 / CLOUD_HZ, self.tell)

    def tell(self) -> None:
        """Publish a cloud with the stamp of now."""
        header = std_msgs.Header(stamp=self.get_clock().now().to_msg(), frame_id=self._frame)
        self._clouds.publish(create_cloud_xyz32(header, wall_cloud()))


class BagRecorder(Node):
    """Keeps the transforms of some topics, and the stamp of every picture.

    Attributes:
        buffer: what could be asked tomorrow.
        stamps_ns: of the pictures.
    """

    def __init__(self, topics: Iterable[str], points: str) -> None:
        super().__init__("rosbag2_recorder")
        self.buffer, self.stamps_ns = BufferCore(), []
        latched = QoSProfile(depth=100, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        for topic, qos in (("/tf", QoSProfile(depth=100)), ("/tf_static", latched)):
            if topic in topics:
                keep = lambda message, topic=topic: self._keep(message, topic)  # noqa: E731
                self.create_subscription(tf2_msgs.TFMessage, topic, keep, qos)
        self.create_subscription(sensor_msgs.PointCloud2, points, self._note, 10)

    def _keep(self, message: tf2_msgs.TFMessage, topic: str) -> None:
        for transform in message.transforms:
            self.buffer.set_transform(stamped_from_msg(transform), "bag", is_static=topic == "/tf_static")

    def _note(self, cloud: sensor_msgs.PointCloud2) -> None:
        self.stamps_ns.append(cloud.header.stamp.sec * 10**9 + cloud.header.stamp.nanosec)


def launch_answer(answer: Any, specification: Any) -> RViz | None:
    """Launch a robot as an answer describes it, print what there is to see of it, and return the small RViz.

    The graph is the current one afterwards, and goes on: `draw_rviz` and the tools may ask it.

    Args:
        answer: as E12.5 asks for it.
        specification: what `task("E12.5")` gave: the robot's name and its sensor.

    Raises:
        TypeError: the specification is something else.
    """
    if not (hasattr(specification, "robot") and hasattr(specification, "sensor")):
        raise TypeError(
            'the second argument is the specification, as in launch_answer(robot, e12_5): e12_5 = task("E12.5")'
        )
    language = language_of_workbook()
    words = {key: text.say(language) for key, text in TEXTS.items()}
    tree = _written(answer)
    if not tree:
        print(words["nothing"])
        return None
    name, sensor = str(specification.robot), f"{specification.robot}/{specification.sensor}_optical_frame"
    topics, graph, recorders = _topics(answer.get("bag")), new_graph(), []
    with redirect_stdout(io.StringIO()), redirect_stderr(io.StringIO()):
        launch(graph, TeachingRobot(Drive(start_ns=graph.now_ns)), only=FIRST_ROBOT)
        graph.start(lambda: _spin(lambda: recorders.append(BagRecorder(topics, f"/{name}/points")) or recorders[0]))
        for maker in _owners(answer, tree, name, str(specification.sensor)):
            graph.start(_spin, maker)
        graph.start(lambda: _spin(lambda: CloudDriver(name, sensor)))
        graph.run(seconds=LAUNCHED_S)
        senders = _senders(graph, tree)
        seen = look(graph)
    view = RViz(*seen)
    print("RViz", *_troubles(statuses_as_text(view.shown)), "", sep="\n")
    print(words["who"].format(seconds=LAUNCHED_S), *_rows(senders, tree, words), "", sep="\n")
    print(*_places(recorders[0], sensor, topics, words), sep="\n")
    return view


def _written(answer: Any) -> dict[str, str]:
    """Return the edges that are written, child -> parent: not a blank, and not a child of many."""
    tree = answer.get("tree") if isinstance(answer, Mapping) else None
    edges = tree.items() if isinstance(tree, Mapping) else ()
    return {child: parent for child, parent in edges if isinstance(child, str) and isinstance(parent, str)}


def _shares(tree: Mapping[str, str], sensor: str) -> tuple[dict[str, str], ...]:
    """Divide the edges of a tree: below map, the footprint's, what is bolted on, and of that the camera's.

    A footprint below map is the localiser's, and the wheels go on with theirs below odom.
    """
    feet = [child for child in tree if _is(child, "base_footprint")]
    below_map = {child: parent for child, parent in tree.items() if parent == "map" or _is(child, "odom")}
    odoms = [child for child in below_map if _is(child, "odom")]
    footprint = {child: (*odoms, "map")[0] if tree[child] == "map" else tree[child] for child in feet}
    bolted = {child: parent for child, parent in tree.items() if child not in below_map and child not in feet}
    camera = {child: parent for child, parent in bolted.items() if child.rpartition("/")[2].startswith(f"{sensor}_")}
    return below_map, footprint, bolted, camera


def _owners(answer: Mapping[str, Any], tree: Mapping[str, str], name: str, sensor: str) -> list[Callable[[], Node]]:
    """Return a maker of each node that the answer has, with the edges that it sends."""
    below_map, footprint, bolted, camera = _shares(tree, sensor)
    moving, mounts, owner = str(answer.get("moving")), str(answer.get("mounts")), answer.get("mounts owner")
    is_on = {switch: str(answer.get(switch)) == "True" for switch in SWITCHES}
    sent = [
        ("localization", below_map, moving, 0.0),
        ("wheel_odometry", footprint if is_on[WHEELS] else {}, moving, 0.0),
        ("ekf_filter_node", footprint if is_on[EKF] else {}, moving, 0.3),
        (str(owner), bolted if isinstance(owner, str) else {}, mounts, 0.0),
        ("camera_driver", camera if is_on[CAMERA] else {}, mounts, 0.0),
    ]
    return [lambda one=one: EdgeOwner(one[0], name, *one[1:]) for one in sent if one[1] and one[2] in TOPICS]


def _topics(bag: Any) -> list[str]:
    """Return the topics to record, whatever they were written in."""
    if isinstance(bag, str):
        return [bag]
    return sorted(map(str, bag)) if isinstance(bag, set | list | tuple | frozenset) else []


def _is(frame: str, name: str) -> bool:
    return frame.rpartition("/")[2] == name


def _spin(make: Callable[[], Node]) -> None:
    rclpy.init()
    try:
        rclpy.spin(make())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


# -- what there is to see -------------------------------------------------


def _troubles(screen: str) -> list[str]:
    """Return the lines of RViz's list without the frames that are all right."""
    return [f"  {line}" for line in screen.splitlines() if not line.endswith((": Transform OK", ": OK"))]


def _senders(graph: Graph, tree: Mapping[str, str]) -> list[tuple[str, str, str, str]]:
    """Return parent, child, node, and topic with rate, of every edge that is sent to a frame of the tree."""
    return [
        (edge.parent, edge.child, edge.node, edge.topic
         if edge.topic == "/tf_static" else f"{edge.topic} {edge.count / LAUNCHED_S:.0f} Hz")
        for edge in snapshot(graph).edges if edge.child in tree
    ]  # fmt: skip


def _rows(senders: list[tuple[str, str, str, str]], tree: Mapping[str, str], words: Mapping[str, str]) -> list[str]:
    sent = {(parent, child) for parent, child, *_ in senders}
    rows = senders + [
        (parent, child, words["nobody"], "! 0") for child, parent in tree.items() if (parent, child) not in sent
    ]
    owners, parents = Counter(row[:2] for row in senders), Counter(child for _, child in sent)
    table = []
    for parent, child, node, how in sorted(rows, key=lambda row: (list(tree).index(row[1]), row)):
        faults = [words["owners"].format(count=owners[parent, child])] if owners[parent, child] > 1 else []
        faults += [words["parents"].format(count=parents[child])] if parents[child] > 1 else []
        table.append((f"{parent} -> {child}", node, how, "  ".join(faults)))
    widths = [max(len(row[column]) for row in table) for column in range(4)]
    return [
        "  " + "  ".join(f"{cell:<{width}}" for cell, width in zip(row, widths, strict=True)).rstrip() for row in table
    ]


def _places(recorder: BagRecorder, sensor: str, topics: list[str], words: Mapping[str, str]) -> list[str]:
    """Return whether the sensor moved, and how many of its pictures a bag of these topics can place."""
    begun = recorder.stamps_ns[0] + SETTLED_NS
    stamps_ns = [stamp for stamp in recorder.stamps_ns if begun <= stamp <= recorder.stamps_ns[-1] - SETTLED_NS]
    at = []
    for stamp_ns in stamps_ns:
        try:
            at.append(recorder.buffer.lookup_transform("map", sensor, stamp_ns).transform.translation)
        except TransformException:
            continue
    moved_m = math.dist(at[0], at[-1]) if at else 0.0
    said = [words["moved" if moved_m > 0.01 else "still"].format(frame=sensor, metres=moved_m)] if at else []
    named = ", ".join(topics) or words["no_bag"]
    return [*said, words["bag"].format(topics=named, placed=len(at), count=len(stamps_ns))]
