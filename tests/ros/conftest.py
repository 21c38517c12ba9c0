"""Modules of ROS 2 that `import rclpy` finds, and a node on a graph."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from tflab import ros
from tflab.ros.client_library import init, try_shutdown
from tflab.ros.node import Node

LECTURE = Path(__file__).parent / "lecture"


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
