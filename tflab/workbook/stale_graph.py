"""Tell the reader when a cell runs again in another graph than before.

    In [3]  %load_ext tflab            a world
    In [5]  graph.run(seconds=0.5)     in that world
    In [9]  graph = new_graph()        another one
    In [5]  again                      graph: Since this cell ran, another one has begun a new world. …

`graph.stop()` ends a world in the same sense.  A cell that makes a world may run at
any time, and so may all below it; nothing is said of a cell that lets no time pass
and begins nothing, for it only looks at what is there; nor where cells have no ids, as
in a build.  `%load_ext tflab` sees to it.
"""

from __future__ import annotations

import re
from typing import Any, NamedTuple

from tflab.ros.process import process_here

from ..text import Text, Texts
from .paths import language_here
from .reply_card import show_reply

__all__ = ["register"]

STOPS_ALL = re.compile(r"\bgraph\.stop\(\)")
TEXTS = Texts(__file__)


class _Seen(NamedTuple):
    """What there is of the world at a moment, for what a cell does to it."""

    graph: Any
    began: frozenset[int]
    now_ns: int | None
    runs: bool


class _Begun(NamedTuple):
    """Which cell began the world there is now, or ended its programs."""

    cell: str
    said: Text


_begun = _Begun("", TEXTS["new"])
_ran_in: dict[str, str] = {}  # the cell that began the world in which a cell ran last
_before: list[_Seen] = []


def register(ipython: Any) -> None:
    """Have a shell say when a cell runs again in a world that is not its own."""
    ipython.events.register("pre_run_cell", _look)
    ipython.events.register("post_run_cell", _compare)


def _look(_info: Any) -> None:
    _before[:] = [_seen()]


def _compare(result: Any) -> None:
    global _begun
    cell = result.info.cell_id
    if not cell:
        return  # two cells may have the same text
    now = _seen()
    before = _before[0] if _before else _Seen(None, frozenset(), None, False)
    if now.graph is not before.graph:
        _begun = _Begun(cell, TEXTS["new"])
    elif before.runs and not now.runs and STOPS_ALL.search(result.info.raw_cell):
        _begun = _Begun(cell, TEXTS["over"])
    elif now.began - before.began or now.now_ns != before.now_ns:
        if _ran_in.get(cell, _begun.cell) != _begun.cell:
            show_reply("graph", Text.joined(_begun.said, TEXTS["from_above"]).say(language_here()))
            return  # until its own world is there again
    else:
        return
    _ran_in[cell] = _begun.cell


def _seen() -> _Seen:
    process = process_here()
    if process is None:
        return _Seen(None, frozenset(), None, False)
    graph = process.graph
    running = [each for each in graph.participants if each.is_running]
    began = frozenset(map(id, [*graph.nodes, *running]))
    return _Seen(graph, began, graph.now_ns if graph.driver.is_virtual else None, bool(running))
