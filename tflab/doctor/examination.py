"""Where does one knock?  `examine(recording | graph | buffer)`, and a report comes out.

    from tflab.doctor import examine
    print(examine(buffer))

A graph is listened to for some seconds, as view_frames does, and asked for its
nodes.
"""

from __future__ import annotations

from dataclasses import replace
from os import PathLike

from tflab.bags.listen import recording_from_graph
from tflab.bags.recording import Recording
from tflab.core import BufferCore
from tflab.ros.graph import Graph
from tflab.ros.snapshot import snapshot

from .checks.time_sources import mixed_time_sources
from .diagnose import diagnose_buffer, diagnose_recording, worst_first
from .findings import Finding, Report

__all__ = ["examine"]


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
        findings = [_of_the_network(finding) for finding in findings]
    made = (*report.checks_made, "time sources of the nodes")
    return replace(report, findings=worst_first(findings), checks_made=made)


def _of_the_network(finding: Finding) -> Finding:
    """Return what a finding means where all clocks are known to agree: what is late alike is late by the network."""
    is_late = finding.code == "clock-offset" and finding.facts["way"].en == "after"
    return replace(finding, code="all-late") if is_late else finding
