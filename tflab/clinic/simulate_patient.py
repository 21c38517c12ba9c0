"""Simulate a patient: launch a robot with its cause, drive for twenty seconds, and run every tool on it.

    cause + numbers --launch--> graph --20 s--> checks, RViz --> texts and findings
                                      --cured--> what each fix leads to

It takes two to three seconds, and what leaves the ward is text alone: no graph, no
buffer, no name of a cause.
"""

from __future__ import annotations

import io
import os
import re
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, redirect_stderr, redirect_stdout
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any, NamedTuple

import numpy as np

from tflab.core import LATEST, NSEC_PER_SEC, TransformException, seconds, stamp_from_sec_nanosec
from tflab.doctor import examine
from tflab.doctor.report.text import text_from_report
from tflab.robots.motion import Drive
from tflab.robots.sensors import ROOM
from tflab.robots.teaching import SOURCES, TeachingRobot, teaching_urdf
from tflab.ros import client_library as rclpy
from tflab.ros.executors import ExternalShutdownException
from tflab.ros.graph import Graph, use_graph
from tflab.ros.messages import sensor_msgs
from tflab.ros.node import Node
from tflab.ros.qos import qos_profile_sensor_data
from tflab.ros.tf2.buffer import Buffer
from tflab.ros.tf2.topics import TransformListener
from tflab.tools.page import run_words, split_line
from tflab.tools.rviz import look
from tflab.tools.session import result_of, spin_for, tool_node
from tflab.views.rviz_status import look_through, statuses_as_text

from .causes import CAUSES, HEALTHY, MOUNT, Launch, Numbers
from .checks import BUDGET_MIN, CHECKS
from .findings import READERS
from .fixes import EFFECTIVE_FIXES, WORKAROUNDS
from .patient import NOTES, FaultyRobot
from .table import COMPLAINTS, DECIDING

__all__ = ["ExaminedRobot", "doctor_report", "make_patient"]

DRIVEN_S = 20.0
LOOKS = 8  # at RViz, until it shows what the operator complains of
WATCHED_S, WAITED_S = 8.0, 1.5
# No two nodes keep step on a robot: some start later than the rest [s], and tools look at a moment in between.
LATER_S = {"ekf_filter_node": 0.010, "localization": 0.058}
STEP_NS, LOOKED_AT_NS = 100_000_000, 60_000_000
LASER_IN_URDF = re.compile(r'  <link name="laser_frame">.*?</joint>\n', re.DOTALL)


class Places(NamedTuple):
    """How far the scan's points lie from the walls on the map [m], the worst scan's mean; None: nothing to place.

    Attributes:
        waited: each at its stamp, as soon as there is a transform.
        newest: with the newest transform.
        arrived: at the moment at which it was heard.
    """

    waited: float | None
    newest: float | None
    arrived: float | None


def make_patient(causes: Sequence[str], numbers: Numbers, complaint: str | None = None) -> FaultyRobot:
    """Return the patient that has these causes, one or two.

    Args:
        complaint: a key of COMPLAINTS; that of the first cause if None, "" for "it does not work".
    """
    own = next(key for key, each in COMPLAINTS.items() if causes[0] in each.suspects)
    launch = HEALTHY
    for cause in causes:
        launch = CAUSES[cause](launch, numbers)
    with ExaminedRobot(launch, numbers) as sick:
        screen = sick.screen(_shows(own))
        evidence = {key: [check.minutes, *sick.ask(key, screen)] for key, check in CHECKS.items()}
        places = sick.places()
    fixes = {fix: [minutes, _after(fix, causes, numbers, screen, evidence, places)] for fix, minutes in _prices()}
    return FaultyRobot(own if complaint is None else complaint, screen, BUDGET_MIN, evidence, fixes)


def doctor_report(causes: Sequence[str], numbers: Numbers) -> str:
    """Return what the doctor says of a robot that has these causes: a program that was told neither card nor plan."""
    launch = HEALTHY
    for cause in causes:
        launch = CAUSES[cause](launch, numbers)
    with ExaminedRobot(launch, numbers) as sick:
        return sick.report()


def _prices() -> list[tuple[str, float]]:
    return [(fix, 10.0) for fix in (*EFFECTIVE_FIXES, *WORKAROUNDS)]


# -- a robot, and what is asked of it -------------------------------------


class ExaminedRobot:
    """A launched robot; each question takes some of its time."""

    def __init__(self, launch: Launch, numbers: Numbers) -> None:
        self._graph, self._fixed_frame, self._others = _launched(launch, numbers), launch.fixed_frame, [*launch.nodes]

    def screen(self, wanted: Callable[[str], bool] = lambda text: True) -> str:
        """Return RViz's list, at a moment at which it shows what is wanted, if there is one."""
        texts = []
        for _ in range(LOOKS):
            with redirect_stdout(io.StringIO()), redirect_stderr(io.StringIO()):
                texts.append(statuses_as_text(look_through(self._fixed_frame, *look(self._graph, 0.97))))
            if wanted(texts[-1]):
                return texts[-1]
        return texts[0]

    def ask(self, key: str, screen: str = "") -> tuple[str, str]:
        """Return what a check prints, and its finding."""
        check = CHECKS[key]
        if key == "rviz":
            text = screen
        elif key == "tape measure":
            ahead, side, up = (f"{distance_m:.3f}" for distance_m in MOUNT)
            text = NOTES["tape"].en.format(ahead=ahead, side=side, up=up)
        elif key == "other cable":
            text = NOTES["cable"].en
        else:
            text = self._run(check.command, check.seconds)
        return text, READERS[check.reader](text)

    def _run(self, command: str, span_s: float | None) -> str:
        printed = io.StringIO()
        self._graph.run(seconds=(LOOKED_AT_NS - self._graph.now_ns) % STEP_NS / NSEC_PER_SEC)
        _, words = split_line(command)
        with redirect_stdout(printed), redirect_stderr(printed), _in_a_folder_of_its_own():
            run_words(self._graph, words, span_s)
        return _in_its_own_terminal(printed.getvalue(), self._others).rstrip("\n")

    def report(self) -> str:
        """Return what the doctor says of the robot, having listened for a while."""
        with redirect_stdout(io.StringIO()), redirect_stderr(io.StringIO()):
            return text_from_report(examine(self._graph, WATCHED_S))

    def places(self) -> Places:
        """Return where the scan's points would be, asked in three ways."""
        with redirect_stdout(io.StringIO()), redirect_stderr(io.StringIO()):
            return result_of(self._graph, _watch_scans, WATCHED_S + WAITED_S, name="watcher")

    def __enter__(self) -> ExaminedRobot:
        return self

    def __exit__(self, *fault: object) -> None:
        self._graph.stop()


@contextmanager
def _in_a_folder_of_its_own() -> Iterator[None]:
    """Let a tool write its files (`view_frames` has two) where nobody keeps any."""
    before = Path.cwd()
    with TemporaryDirectory() as folder:
        os.chdir(folder)
        try:
            yield
        finally:
            os.chdir(before)


def _in_its_own_terminal(text: str, others: Sequence[str]) -> str:
    """Return what a tool printed without the log lines of the robot's nodes: those stand in the launch's terminal."""
    theirs = re.compile(rf"\[\w+\] \[[\d.]+\] \[(?:{'|'.join(others)})\]: ")
    return "".join(line for line in text.splitlines(keepends=True) if not theirs.match(line))


def _launched(launch: Launch, numbers: Numbers) -> Graph:
    """Return a graph of its own, on which a robot has driven for a while; the current one stays current."""
    before = use_graph(None)
    graph = Graph()
    use_graph(graph)
    try:
        graph.run(seconds=1.0)
        source = SOURCES["odometry"]._replace(rate_hz=launch.odometry_hz)
        urdf = LASER_IN_URDF.sub("", teaching_urdf(), count=1)
        drive = Drive(start_ns=graph.now_ns)
        robot = TeachingRobot(drive, urdf=urdf, sources={"odometry": source}, bias=launch.drift, seed=numbers.seed)
        for node, offset_s in launch.clocks_s.items():
            graph.set_clock_offset(node, offset_s)
        if launch.delay_s:
            for topic in ("/tf", "/odom"):
                graph.disturb(topic, delay=launch.delay_s, jitter=launch.jitter_s, seed=numbers.seed)
        with redirect_stdout(io.StringIO()), redirect_stderr(io.StringIO()):
            begun_ns = graph.now_ns
            for name in sorted(launch.nodes, key=lambda name: LATER_S.get(name, 0.0)):
                later_ns = begun_ns + seconds(LATER_S.get(name, 0.0)) - graph.now_ns
                graph.run(seconds=later_ns / NSEC_PER_SEC)
                graph.start(_spin, launch.nodes[name], robot, launch.ros_args.get(name, []), name=name)
            graph.run(seconds=DRIVEN_S)
    finally:
        use_graph(before)
    return graph


def _spin(make: Callable[[TeachingRobot], Node], robot: TeachingRobot, ros_args: Sequence[str]) -> None:
    rclpy.init(args=list(ros_args))
    try:
        rclpy.spin(make(robot))
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


def _shows(complaint: str) -> Callable[[str], bool]:
    """Return whether a screen of RViz shows a complaint that comes and goes."""
    if complaint == "flickers":
        return lambda text: "into the future" in text
    if complaint == "jumps":
        return lambda text: "No transform" in text
    return lambda text: True


# -- where the points are -------------------------------------------------


def _watch_scans() -> Places:
    with tool_node("watcher", start_parameter_services=False) as node:
        buffer = Buffer()
        listener = TransformListener(buffer, node)
        heard: list[tuple[Any, int, float | None]] = []

        def on_scan(scan: sensor_msgs.LaserScan) -> None:
            heard.append((scan, node.get_clock().now().nanoseconds, _off(buffer, scan, LATEST)))

        spin_for(node, 1.0)
        node.create_subscription(sensor_msgs.LaserScan, "/scan", on_scan, qos_profile_sensor_data)
        spin_for(node, WATCHED_S)
        scans = list(heard)
        spin_for(node, WAITED_S)
        stamps = [scan.header.stamp for scan, *_ in scans]
        waited = [
            _off(buffer, scan, stamp_from_sec_nanosec(stamp.sec, stamp.nanosec))
            for (scan, *_), stamp in zip(scans, stamps, strict=True)
        ]
        arrived = [_off(buffer, scan, heard_ns) for scan, heard_ns, _ in scans]
        listener.unregister()
        return Places(_worst(waited), _worst([newest for *_, newest in scans]), _worst(arrived))


def _off(buffer: Buffer, scan: sensor_msgs.LaserScan, stamp_ns: int) -> float | None:
    """Return the mean distance of a scan's points from the nearest wall [m], placed at a moment; None: nowhere."""
    try:
        map_T_laser = buffer.core.lookup_transform("map", scan.header.frame_id, stamp_ns).transform
    except TransformException:
        return None
    ranges = np.array(scan.ranges)
    angles = scan.angle_min + scan.angle_increment * np.arange(len(ranges))
    seen = (ranges >= scan.range_min) & (ranges <= scan.range_max)
    laser_p = np.column_stack([ranges * np.cos(angles), ranges * np.sin(angles), np.zeros_like(ranges)])[seen]
    return float(_from_walls(np.asarray(map_T_laser.apply(laser_p))[:, :2]).mean())


def _from_walls(points: np.ndarray) -> np.ndarray:
    """Return how far each point, shape (N, 2), is from the nearest wall [m]."""
    begin, end = np.array(ROOM.walls)[:, 0], np.array(ROOM.walls)[:, 1]
    along = end - begin
    to = points[:, None, :] - begin[None]
    share = np.clip((to * along).sum(axis=2) / (along * along).sum(axis=1), 0.0, 1.0)
    return np.linalg.norm(to - share[..., None] * along, axis=2).min(axis=1)


def _worst(distances: Sequence[float | None]) -> float | None:
    known = [distance for distance in distances if distance is not None]
    return max(known) if len(known) > len(distances) // 2 else None


# -- after a fix ----------------------------------------------------------


def _after(
    fix: str, causes: Sequence[str], numbers: Numbers, screen: str, evidence: dict[str, list], places: Places
) -> str:
    """Return what RViz, the walls and the deciding reading say after a fix."""
    cured = [cause for cause in causes if cause in EFFECTIVE_FIXES.get(fix, ())]
    decisive = DECIDING[(cured or list(causes))[0]]
    if not cured:
        way = WORKAROUNDS.get(fix, "waited")
        calm = way != "waited" or fix == "timeout of 1 s"
        placed = getattr(places, way)
        shown = _calmed(screen) if calm else screen
        return _describe(shown, placed, decisive, evidence[decisive][1])
    launch = HEALTHY
    for cause in causes:
        launch = launch if cause in cured and cause != "nothing is wrong" else CAUSES[cause](launch, numbers)
    with ExaminedRobot(launch, numbers) as well:
        shown = well.screen()
        reading, placed = well.ask(decisive, shown)[0], well.places().waited
    return _describe(shown, placed, decisive, reading)


def _calmed(screen: str) -> str:
    """Return RViz's list as it is when no scan asks for what is not there yet."""
    head, scan, rest = screen.partition("LaserScan")
    if "into the future" not in rest:
        return screen
    rest = re.sub(r"Transform: .*into the future.*", "Transform: Ok", rest.replace(": Error", ": Ok", 1))
    return head + scan + rest.replace("[0] points from [0]", "[360] points from [1]")


def _describe(screen: str, placed: float | None, key: str, reading: str) -> str:
    troubles = [line for line in screen.splitlines() if re.search(r": (Error|Warn)|No transform|does not exist", line)]
    rviz = "\n".join(["RViz:", *(f"  {line}" for line in troubles[:6])]) if troubles else NOTES["all ok"].en
    off = NOTES["not placed"].en if placed is None else NOTES["off the walls"].en.format(distance=f"{placed:.2f}")
    return f"{rviz}\n{off}\n$ {CHECKS[key].command}\n{reading}"
