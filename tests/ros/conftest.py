"""Provide a fresh graph on virtual time, and a node on it."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from tflab import ros
from tflab.ros.client_library import init, try_shutdown
from tflab.ros.logging import clear_config, show_engine_refusals
from tflab.ros.node import Node
from tflab.ros.process import use_graph

LECTURE = Path(__file__).parent / "lecture"


@pytest.fixture
def graph() -> Iterator[ros.Graph]:
    """Return the current graph: virtual time, 1 s."""
    graph = ros.new_graph()
    yield graph
    graph.stop()
    use_graph(None)
    clear_config()
    show_engine_refusals(False)


@pytest.fixture
def activated(graph: ros.Graph) -> Iterator[ros.Graph]:
    """Return the same; `import rclpy` finds the in-process modules."""
    ros.activate("in-process")
    yield graph
    ros.deactivate()


@pytest.fixture
def node(graph: ros.Graph) -> Iterator[Node]:
    """Return a node of the name "node", between init and shutdown."""
    init()
    yield Node("node")
    try_shutdown()
