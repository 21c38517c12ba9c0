"""What do tests of the graph need?  A fresh graph on virtual time, and nothing left behind."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from tflab import ros
from tflab.ros.logging import clear_config, show_engine_refusals
from tflab.ros.process import use_graph

LECTURE = Path(__file__).parent / "lecture"


@pytest.fixture
def graph() -> Iterator[ros.Graph]:
    """The current graph: virtual time, 1 s."""
    graph = ros.new_graph()
    yield graph
    graph.stop()
    use_graph(None)
    clear_config()
    show_engine_refusals(False)


@pytest.fixture
def activated(graph: ros.Graph) -> Iterator[ros.Graph]:
    """The same, and `import rclpy` finds us."""
    ros.activate("in-process")
    yield graph
    ros.deactivate()
