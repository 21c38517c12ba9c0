"""Examine a recording, a graph, a buffer or a robot.

    from tflab.doctor import examine
    report = examine(buffer)

A graph is listened to for some seconds, as view_frames does, and its nodes are examined too.
`tflab doctor --live 10` listens to a robot through rclpy, on a machine with ROS 2, in a sourced terminal: images and
clouds stay bytes, only their headers are read.
"""

from __future__ import annotations

import importlib
from dataclasses import replace
from os import PathLike

from tflab.bags.listen import ReceivedRecords, recording_from_graph, subscribe_to_all
from tflab.bags.recording import Recording
from tflab.core import BufferCore
from tflab.ros.graph import Graph
from tflab.ros.snapshot import snapshot

from .checks.clocks import mixed_time_sources
from .diagnose import diagnose_buffer, diagnose_recording, worst_first
from .findings import Finding, Report

__all__ = ["NoRos", "examine", "recording_from_ros"]


def examine(patient: Recording | Graph | BufferCore, seconds: float = 5.0) -> Report:
    """Return what is wrong with the transforms of a recording, a graph or a buffer.

    Args:
        patient: a Buffer of tf2_ros may stand for its BufferCore.
        seconds: how long to listen to a graph [s].

    Raises:
        TypeError: it is something else.
    """
    if isinstance(patient, Recording):
        return diagnose_recording(patient)
    if isinstance(patient, Graph):
        return _diagnose_graph(patient, seconds)
    core = getattr(patient, "core", patient)
    if isinstance(core, BufferCore):
        return diagnose_buffer(core)
    remedy = "; tflab.bags.reader.read_bag(path) makes a Recording" if isinstance(patient, str | PathLike) else ""
    raise TypeError(
        f"the doctor looks at a Recording, a Graph or a BufferCore, not at {type(patient).__name__}{remedy}"
    )


def _diagnose_graph(graph: Graph, seconds: float) -> Report:
    nodes = snapshot(graph)
    report = diagnose_recording(recording_from_graph(graph, seconds))
    findings = [*report.findings, *mixed_time_sources(nodes)]
    if not any(node.clock_offset_ns for node in nodes.nodes):
        findings = [_blame_network(finding) for finding in findings]
    made = (*report.checks_made, "time sources of the nodes")
    return replace(report, findings=worst_first(findings), checks_made=made)


def _blame_network(finding: Finding) -> Finding:
    """Return what a finding means where all clocks are known to agree: what is late alike is late by the network."""
    is_late = finding.code == "clock-offset" and finding.facts["way"].en == "after"
    return replace(finding, code="all-late") if is_late else finding


NODE_NAME = "tflab_doctor"
DISCOVERY_S = 1.0
TURN_S = 0.1


class NoRos(RuntimeError):
    """There is no ROS 2 to listen to; the text is one line that says what to do."""


def recording_from_ros(seconds: float) -> Recording:
    """Listen for `seconds`, and return every transform and every header that was heard.

    Raises:
        NoRos: rclpy cannot be imported.
    """
    try:
        rclpy = importlib.import_module("rclpy")
    except ImportError as error:
        raise NoRos(
            f"--live needs rclpy ({error}): source /opt/ros/<distro>/setup.bash, or record a bag "
            f"(ros2 bag record -a -d {seconds:.0f}) and name it"
        ) from None
    rclpy.init()
    try:
        node = rclpy.create_node(NODE_NAME)
        received = ReceivedRecords()
        _spin(rclpy, node, DISCOVERY_S)
        subscribe_to_all(node, received, _message_class, raw_headers=True)
        _spin(rclpy, node, seconds)
        node.destroy_node()
    finally:
        rclpy.try_shutdown()
    return received.recording("live")


def _spin(rclpy, node, seconds: float) -> None:
    clock = importlib.import_module("rclpy.clock")
    steady = clock.Clock(clock_type=clock.ClockType.STEADY_TIME)
    end_ns = steady.now().nanoseconds + round(seconds * 1e9)
    while rclpy.ok() and steady.now().nanoseconds < end_ns:
        rclpy.spin_once(node, timeout_sec=TURN_S)


def _message_class(ros_type: str) -> type | None:
    """Return the class of a type such as sensor_msgs/msg/LaserScan, None if it is not installed here."""
    package, _, name = ros_type.partition("/msg/")
    try:
        return getattr(importlib.import_module(f"{package}.msg"), name, None)
    except ImportError:
        return None
