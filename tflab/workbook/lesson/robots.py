"""Start robots with faults, and nodes that record what happens to them.

    start_robot()                our robot, with a map server
    start_robot("mount")         the model has the laser 0.20 m behind base_link; it is mounted 0.20 m ahead
    start_robot("header")        the driver writes base_link into the scan's header
    start_robot("clock")         the laser's computer is 0.3 s slow
    draw_rviz()                  what RViz shows of it, as a figure
    run_node(Node, seconds)      a node that goes on running and can be inspected
    GapWatcher                   how far ahead of TF each scan is
    WaitingNode, on_robot_c      when its callback is busy, and when transforms are stored
    ages_of_decisions(queue)     how old data gets in a queue
    walls_seen, show_clock_error where scans end up when a clock is wrong

RViz lists no error for any of these robots: every transform can be computed.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterable
from dataclasses import replace

import numpy as np

from tflab.core import NSEC_PER_SEC, Transform, seconds
from tflab.robots.motion import Drive
from tflab.robots.nodes import USUAL_NODES, launch
from tflab.robots.sensors import ROOM
from tflab.robots.teaching import TeachingRobot, teaching_urdf
from tflab.ros import client_library as rclpy
from tflab.ros.graph import Graph, current_graph, new_graph
from tflab.ros.messages import sensor_msgs
from tflab.ros.node import Node
from tflab.ros.qos import qos_profile_sensor_data
from tflab.ros.tf2.buffer import Buffer
from tflab.ros.tf2.topics import TransformListener
from tflab.ros.time import Time
from tflab.tools.rviz import look
from tflab.views.ages import Curve
from tflab.views.busy_chart import Work, draw_work
from tflab.views.picture import Picture
from tflab.views.rviz_figure import draw_shown
from tflab.views.rviz_status import look_through
from tflab.views.scene import Scene, draw_frame, draw_scan

from .scenes import GRID_CELLS, draw_walls

BUILT = Transform((0.20, 0.0, 0.15))  # where the laser is bolted on
DRAWN, WRONG = 'xyz="0.20 0.0 0.15"', 'xyz="-0.20 0.0 0.15"'


ROBOTS = ("healthy", "mount", "header", "clock")


def start_robot(name: str = "healthy", also: Iterable[str] = ()) -> Graph:
    """Start a robot in a new graph, a map server beside it; its clock stands at 1 s.

    Args:
        name: which of ROBOTS.
        also: further nodes, by the keys of NODES.

    Raises:
        ValueError: there is no such robot.
    """
    if name not in ROBOTS:
        raise ValueError(f"there is no robot {name!r}; there is {', '.join(ROBOTS)}")
    graph = new_graph()
    drive = Drive(start_ns=graph.now_ns)
    robot = TeachingRobot(drive)
    if name == "mount":
        robot = TeachingRobot(drive, urdf=teaching_urdf().replace(DRAWN, WRONG), screws={"laser_frame": BUILT})
    if name == "header":
        robot.laser = replace(robot.laser, frame_id="base_link")
    launch(graph, robot, only=(*USUAL_NODES, "map_server", *also))
    if name == "clock":
        graph.set_clock_offset("laser_driver", -0.3)
    return graph


def stop_node(name: str) -> None:
    """Stop one node of the current graph, as Ctrl-C in its terminal does; one that was stopped stays so.

    Raises:
        ValueError: no such node has been started.
    """
    graph = current_graph()
    running = {each.name: each for each in graph.participants if each.is_running}
    if name not in running and any(each.name == name for each in graph.participants):
        return  # a cell that runs again
    if name not in running:
        raise ValueError(f"no node {name!r} runs; there is {', '.join(sorted(running))}")
    graph.stop(running[name])


def draw_rviz(until_s: float | None = None, fixed_frame: str = "map", decay_s: float = 1.0) -> Picture:
    """Return what RViz shows of the current graph after a look of 4 s, on paper, the room's walls beneath.

    Args:
        until_s: when the look is over [s of the graph's time]; 4 s from now if None.
        decay_s: how long scans stay on the screen, RViz's Decay Time [s].
    """
    graph = current_graph()
    if until_s is not None:
        graph.run(seconds=max(0.0, (seconds(until_s - 4.0) - graph.now_ns) / 1e9))
    shown = look_through(fixed_frame, *look(graph, seconds=4.0, decay_s=decay_s))
    return draw_shown(shown, ROOM.walls if fixed_frame == "map" else (), fixed_frame)


EVERY_RAY = 6  # of a scan's: enough to see the walls


def run_node(make_node: Callable[[], Node], for_s: float, make_executor: Callable | None = None) -> Node:
    """Start a node in the current graph, let `for_s` [s] pass, and return it; it goes on living."""
    made: list[Node] = []

    def main() -> None:
        rclpy.init(args=[])
        made.append(make_node())
        rclpy.spin(made[0], executor=make_executor() if make_executor else None)

    graph = current_graph()
    graph.start(main)
    graph.run(seconds=for_s)
    return made[0]


class GapWatcher(Node):
    """Note for each scan its gap: its stamp minus the newest moment that TF can answer."""

    def __init__(self) -> None:
        super().__init__("gap_watcher")
        self.buffer = Buffer()
        self.listener = TransformListener(self.buffer, self)
        self.gaps: list[tuple[float, float]] = []  # when, and how much [s]
        self.create_subscription(sensor_msgs.LaserScan, "scan", self.on_scan, qos_profile_sensor_data)

    def on_scan(self, scan: sensor_msgs.LaserScan) -> None:
        newest = self.buffer.get_latest_common_time("map", scan.header.frame_id)
        gap_ns = Time.from_msg(scan.header.stamp).nanoseconds - newest.nanoseconds
        self.gaps.append((self.get_clock().now().nanoseconds / NSEC_PER_SEC, gap_ns / NSEC_PER_SEC))

    def curve(self, name: str, until_s: float) -> Curve:
        """Return the gaps up to `until_s` [s], to be drawn under a name."""
        times_s, gaps_s = zip(*(seen for seen in self.gaps if seen[0] <= until_s), strict=True)
        return Curve(name, times_s, gaps_s)


class NotingBuffer(Buffer):
    """A buffer that notes when it stored each transform of the odometry."""

    def __init__(self) -> None:
        super().__init__()
        self.stored_ns: list[int] = []

    def set_transform(self, transform, authority) -> None:
        if transform.child_frame_id == "base_footprint":  # one edge will do
            self.stored_ns.append(current_graph().now_ns)
        super().set_transform(transform, authority)


class WaitingNode(Node):
    """A node with a buffer, and `on_scan` to be written; it notes when that is busy.

    Attributes:
        answers, failures: what `on_scan` came to, and how often to nothing; for it to fill.
        busy: from when until when it ran [ns].
    """

    def __init__(self) -> None:
        super().__init__("waiting_node")
        self.buffer, self.answers, self.failures, self.busy = NotingBuffer(), [], 0, []
        self.listener = TransformListener(self.buffer, self)
        self.create_subscription(sensor_msgs.LaserScan, "scan", self._on_scan, qos_profile_sensor_data)

    def _on_scan(self, scan: sensor_msgs.LaserScan) -> None:
        began_ns = current_graph().now_ns
        self.on_scan(scan)
        self.busy.append((began_ns, current_graph().now_ns))

    def on_scan(self, scan: sensor_msgs.LaserScan) -> None:
        raise NotImplementedError("a waiting node says what it does with a scan")


def on_robot_c(make_node: Callable[[], Node], make_executor: Callable | None = None, delay_s: float = 0.0) -> Node:
    """Run a node for three seconds on a robot with nothing wrong but transforms that take `delay_s` [s] longer."""
    graph = new_graph()
    graph.disturb("/tf", delay=delay_s)
    launch(graph)
    return run_node(make_node, 3.0, make_executor)


def draw_lanes(node: WaitingNode, start_s: float = 1.0, end_s: float = 3.0) -> Picture:
    """Draw when transforms are sent, when the node's callback is busy, and when transforms are stored."""
    sent_ns = tuple(range(seconds(start_s), seconds(end_s), seconds(0.05)))  # odometry, 20 times a second
    rows = (
        Work("/tf sent", moments_ns=sent_ns),
        Work("on_scan", tuple(node.busy)),
        Work("/tf stored", moments_ns=tuple(node.buffer.stored_ns)),
    )
    return draw_work(rows, seconds(start_s), seconds(end_s))


def ages_of_decisions(name: str, queue: deque[int], until_ms: int = 12_000) -> Curve:
    """Return how old data is when it is decided on: a scan every 100 ms, a decision takes 150, the oldest first."""
    now_ms, next_scan_ms = 0, 0
    times_s, ages_s = [], []
    while now_ms < until_ms:
        while next_scan_ms <= now_ms:  # what has come meanwhile
            queue.append(next_scan_ms)
            next_scan_ms += 100
        stamp_ms = queue.popleft()
        now_ms += 150
        times_s.append(now_ms / 1000)
        ages_s.append((now_ms - stamp_ms) / 1000)
    return Curve(name, tuple(times_s), tuple(ages_s))


def walls_seen(
    buffer: Buffer, placed: Iterable[tuple[sensor_msgs.LaserScan, Time]], clock_error_s: float = 0.0
) -> np.ndarray:
    """Return the points of scans on the map, each placed where the laser was `clock_error_s` before its stamp."""
    clouds = []
    for scan, stamp in placed:
        stamp_ns = stamp.nanoseconds - seconds(clock_error_s)
        map_T_laser = buffer.core.lookup_transform("map", "laser_frame", stamp_ns).transform
        angles = scan.angle_min + scan.angle_increment * np.arange(len(scan.ranges))
        reach_m = np.where(np.isfinite(scan.ranges), scan.ranges, np.nan)
        laser_p = np.column_stack([reach_m * np.cos(angles), reach_m * np.sin(angles), np.zeros(len(reach_m))])
        clouds.append(map_T_laser.apply(laser_p[::EVERY_RAY]))
    return np.vstack(clouds)


def show_clock_error(at_s: float = 8.8) -> Scene:
    """Return a scene of one scan in the bend, to be moved by the error of the laser's clock."""
    robot = TeachingRobot(Drive(start_ns=seconds(1.0)))
    stamp_ns = seconds(at_s)
    scan = robot.laser.scan_at(stamp_ns)
    scene = Scene(grid_cells=GRID_CELLS)
    scene.look(eye=(3.0, -8.0, 9.0), target=(3.0, 0.0, 0.0))
    draw_walls(scene)

    def draw(clock_error_s: float) -> None:
        pose = robot.truth_at(stamp_ns + seconds(clock_error_s))["laser_frame"]
        draw_frame(scene, "laser_frame", pose, length_m=0.6)
        draw_scan(scene, "scan", pose, scan.ranges, scan.angle_min, scan.angle_increment)

    scene.sweep("clock error", [0.0, 0.1, 0.2, 0.3, 0.4, 0.5], draw, unit="s")
    return scene
