"""End the nodes that a cell's last run started, before the cell runs again.

    In [5]:  rclpy.init(); node = Node('reader')     /reader is there
    In [9]:  the same cell, again                    the old /reader goes, rclpy ends, and both begin anew

On a robot one stops a program before one starts it again, and nobody can stop a cell
that has run.  So the cell's own nodes, participants and contexts are ended before it
runs; what other cells began stays, and so does what took the place of theirs.  A
cell that ended rclpy may end it once more.

`%load_ext tflab` sees to it.
"""

from __future__ import annotations

import weakref
from collections.abc import Set
from typing import Any, NamedTuple

from tflab.ros import client_library
from tflab.ros.process import process_here
from tflab.views.rerun import cell_key

__all__ = ["register"]


class _There(NamedTuple):
    """What there is in a graph, of the page's own process."""

    graph: Any
    contexts: list[Any]
    nodes: list[Any]
    participants: list[Any]


class _Began(NamedTuple):
    """What a cell began in its last run, as weak references; whether it ended a context of another cell."""

    graph: weakref.ref
    contexts: list[weakref.ref]
    nodes: list[weakref.ref]
    participants: list[weakref.ref]
    has_ended: bool


_began: dict[str, _Began] = {}
_before: list[_There] = []


def register(ipython: Any) -> None:
    """Let each cell of a shell begin anew when it runs again."""
    ipython.events.register("pre_run_cell", _begin_anew)
    ipython.events.register("post_run_cell", _remember)


def _begin_anew(info: Any) -> None:
    last, process = _began.pop(cell_key(info), None), process_here()
    if last is not None and process is not None and last.graph() is process.graph:
        _end(last, process)
    _before[:] = [_there()]


def _end(last: _Began, process: Any) -> None:
    for participant in _alive(last.participants):
        if participant.is_running:
            process.graph.stop(participant)
    for node in _alive(last.nodes):
        node.destroy_node()
    for context in _alive(last.contexts):
        client_library.try_shutdown(context=None if context is process.default_context else context)
    if last.has_ended and not client_library.ok():
        client_library.init()  # so that it can be ended once more


def _remember(result: Any) -> None:
    before, now = (_before or [_there()])[0], _there()
    if now.graph is None or now.graph is not before.graph:
        return  # a new world: whoever makes one ends the old one
    _began[cell_key(result.info)] = _Began(
        weakref.ref(now.graph),
        _new(now.contexts, before.contexts),
        _new(now.nodes, before.nodes, set(map(_name, before.nodes))),
        _new(now.participants, before.participants, set(map(_name, before.participants))),
        any(context not in now.contexts for context in before.contexts),
    )


def _there() -> _There:
    process = process_here()
    if process is None:
        return _There(None, [], [], [])
    graph = process.graph
    nodes = [node for node in graph.nodes if node.context.process is process]
    return _There(graph, list(process.contexts), nodes, [each for each in graph.participants if each.is_running])


def _new(now: list[Any], before: list[Any], replaced: Set[str] = frozenset()) -> list[weakref.ref]:
    """Return what is there now and was not before; what has the name of one that was there took its place."""
    known = set(map(id, before))
    return [weakref.ref(each) for each in now if id(each) not in known and _name(each) not in replaced]


def _name(each: Any) -> str:
    return each.get_name() if hasattr(each, "get_name") else getattr(each, "name", "")


def _alive(references: list[weakref.ref]) -> list[Any]:
    return [each for reference in references if (each := reference()) is not None]
