"""A cell that runs again in another world than its own says so, and what to run first."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import pytest
from IPython.core.interactiveshell import InteractiveShell

from tflab.ros.process import use_graph
from tflab.workbook import rerun_cleanup, stale_graph

LOAD = "from tflab.ros.graph import new_graph\ngraph = new_graph(virtual=True)"
RUN = "graph.run(seconds=0.5)"
LOOK = "graph.now_ns"
START = """
from tflab.ros import client_library as rclpy
from tflab.ros.node import Node
def main():
    rclpy.init()
    rclpy.spin(Node('circle'))
graph.start(main, name='circle')"""
CELLS = {"load": LOAD, "start": START, "run": RUN, "look": LOOK, "stop": "graph.stop()", "anew": LOAD, "more": RUN}


@pytest.fixture
def said(monkeypatch: pytest.MonkeyPatch) -> Iterator[Callable[..., list[str]]]:
    """Return what runs cells by their names, and returns those of which something was said, and what."""
    monkeypatch.setattr(stale_graph, "_begun", stale_graph._Begun("", stale_graph.TEXTS["new"]))
    monkeypatch.setattr(stale_graph, "_ran_in", {})
    heard: list[str] = []
    monkeypatch.setattr(stale_graph, "show_reply", lambda _head, text: heard.append(text))
    shell = InteractiveShell()
    rerun_cleanup.register(shell)
    stale_graph.register(shell)

    def run(*cells: str, no_ids: bool = False) -> list[str]:
        told = []
        for cell in cells:
            heard.clear()
            assert shell.run_cell(CELLS[cell], cell_id=None if no_ids else cell).error_in_exec is None
            told += [f"{cell}: {text}" for text in heard]
        return told

    yield run
    use_graph(None)


ALL = tuple(CELLS)


def test_a_page_may_run_from_its_start_again_and_again(said) -> None:
    assert said(*ALL, *ALL, *ALL) == []
    assert said("look", "stop", "anew") == []  # of a cell that only looks
    assert said("load", "run", "anew", "more", no_ids=True) == []


@pytest.mark.parametrize("below", [("start", "run"), ("run", "look", "run")])
def test_a_cell_may_run_again_as_long_as_its_world_is_there(said, below) -> None:
    assert said("load", "start", "run", *below) == []
    assert said("stop", "anew", "more", "more", "load", "start", *below) == []


def test_a_cell_above_a_new_world_says_what_to_run_until_that_has_been_run(said) -> None:
    said(*ALL)
    for _ in range(2):
        (told,) = said("run")
        assert told.startswith("run: After this cell ran, another cell started a new graph.")
        assert "Run All Above Selected Cell" in told
    assert said("load", "start", "run") == []
    assert len(said("more")) == 1  # and now that one's is gone


def test_a_cell_above_a_stop_says_that_its_programs_have_ended(said) -> None:
    said("load", "start", "run", "stop")
    (told,) = said("run")
    assert told.startswith("run: After this cell ran, `graph.stop()` ended all nodes of its graph.")
