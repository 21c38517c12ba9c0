"""What does the first cell of a page do?  `%load_ext tflab`: this ROS 2, on virtual time, with field checks."""

from __future__ import annotations

from typing import Any

from . import activation, distro
from .graph import Graph, new_graph
from .logging import write_to_stdout
from .messages import set_field_checks

__all__ = ["load_in_notebook"]


def load_in_notebook(ipython: Any) -> Graph:
    """Activate the in-process modules, make the kernel's current graph, and say so in one line.

    Raises:
        ImportError: a real ROS 2 module was imported before.
    """
    activation.activate("in-process")
    set_field_checks(True)
    write_to_stdout(True)  # in pages a log line is an output like any other
    graph = new_graph(virtual=True)
    ipython.push({"graph": graph})
    print(f"tflab: in-process ROS 2 ({distro.current().name}), virtual time, message fields checked.")
    return graph
