"""A cell that runs twice ends what it began the first time, so that nothing is there twice."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import pytest
from IPython.core.interactiveshell import InteractiveShell

from tflab.ros.graph import Graph, new_graph
from tflab.ros.process import use_graph
from tflab.workbook import rerun_cleanup

HEAD = "from tflab.ros import client_library as rclpy\nfrom tflab.ros.node import Node\n"
READER = f"{HEAD}rclpy.init()\nnode = Node('reader')"
CIRCLE = f"""{HEAD}
def main():
    rclpy.init()
    rclpy.spin(Node('circle'))
graph.start(main, name='circle')"""


@pytest.fixture
def graph() -> Iterator[Graph]:
    yield new_graph(virtual=True)
    use_graph(None)


@pytest.fixture
def run(graph: Graph) -> Callable[..., BaseException | None]:
    """Return what runs a cell by its name and text, and says what it ended with."""
    shell = InteractiveShell()
    shell.user_ns.update(graph=graph, new_graph=new_graph)
    rerun_cleanup.register(shell)
    return lambda cell, text: shell.run_cell(text, cell_id=cell).error_in_exec


def names(graph: Graph) -> list[str]:
    return [node.get_name() for node in graph.nodes]


@pytest.mark.parametrize(("text", "name"), [(READER, "reader"), (CIRCLE, "circle")])
def test_a_cell_that_runs_twice_leaves_each_node_once(run, graph, text, name) -> None:
    assert [run("a", text), run("a", text)] == [None, None]
    assert names(graph) == [name]


def test_a_corrected_cell_ends_what_it_began_before(run, graph) -> None:
    run("a", READER)
    run("a", READER.replace("reader", "listener"))
    assert names(graph) == ["listener"]


def test_what_another_cell_began_stays(run, graph) -> None:
    run("a", CIRCLE)
    assert run("b", READER) is None
    assert run("b", READER) is None
    assert names(graph) == ["circle", "reader"]


def test_what_a_cell_puts_in_the_place_of_anothers_stays(run, graph) -> None:
    run("a", CIRCLE)
    anew = f"graph.stop(next(each for each in graph.participants if each.is_running))\n{CIRCLE}"
    assert [run("b", anew), run("b", anew)] == [None, None]
    assert names(graph) == ["circle"]


def test_two_cells_that_begin_or_end_rclpy_are_told_as_on_a_robot(run) -> None:
    assert str(run("b", f"{HEAD}rclpy.shutdown()")) == "Context must be initialized before it can be shutdown"
    run("a", READER)
    assert str(run("b", READER)) == "Context.init() must only be called once"


def test_a_cell_that_ends_rclpy_may_do_so_again(run, graph) -> None:
    run("a", READER)
    stop = "node.destroy_node()\nrclpy.shutdown()"
    assert [run("b", stop), run("b", stop)] == [None, None]
    assert names(graph) == []


def test_a_cell_that_makes_a_new_world_is_left_alone(run) -> None:
    anew = (
        f"graph = new_graph()\n{READER}\nnames = [node.get_name() for node in graph.nodes]\nassert names == ['reader']"
    )
    assert [run("a", anew), run("a", anew)] == [None, None]
