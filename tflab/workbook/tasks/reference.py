"""Compute the right answer by running the solution's own answer cell.

    imports + given + answer cell  --run-->  the value, or the function, that the cell defines

The cell that a reader of the solution sees makes the expected values, so the two cannot
differ.  It runs in this process, which must trust the solution.
"""

from __future__ import annotations

import ast
import json
import sys
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path
from threading import RLock
from types import CodeType, ModuleType, SimpleNamespace
from typing import Any, NamedTuple

from tflab.ros import activation
from tflab.ros.messages import checks
from tflab.ros.process import use_graph

from .task import Task, TaskError, slug

__all__ = ["CodeCell", "Solution", "answer_cell_name", "given_name", "in_process_ros", "solution_in_notebook"]


_one_thread = RLock()


class CodeCell(NamedTuple):
    """A code cell: its name, and its text."""

    name: str
    source: str


class Solution:
    """The code cells of a solution, ready to answer with any given."""

    def __init__(self, stem: str, cells: Iterable[CodeCell]) -> None:
        self.stem = stem
        self._cells = {cell.name: cell.source for cell in cells}
        self._compiled: dict[str, CodeType] = {}

    def source(self, name: str) -> str:
        """Return the text of a cell."""
        return self._cells[name]

    def answer(self, task: Task, given: dict[str, Any] | None, source: str = "") -> Any:
        """Return what the task's answer cell, or `source` instead, defines for these givens: a value or a function.

        Raises:
            TaskError: there is no such cell, it raises, or it does not define the answer.
        """
        space: dict[str, Any] = {"__name__": "solution"}
        name = answer_cell_name(task.id)
        if name not in self._cells:
            raise TaskError(f'{self.stem}: {task.id} has no answer cell "{name}" in the solution')
        try:
            exec(self._code("imports", self._imports), space)
            if given is not None:
                space[given_name(task.id)] = SimpleNamespace(**given)
            exec(source or self._code(name, lambda: self._cells[name]), space)
        except Exception as error:
            raise TaskError(f'{self.stem}: the answer cell "{name}" fails: {type(error).__name__}: {error}') from error
        if task.answer not in space or space[task.answer] is ...:
            raise TaskError(f'{self.stem}: the answer cell "{name}" does not define {task.answer}')
        return space[task.answer]

    def _code(self, name: str, text: Any) -> CodeType:
        if name not in self._compiled:
            self._compiled[name] = compile(text(), f"<{self.stem}: {name}>", "exec")
        return self._compiled[name]

    def _imports(self) -> str:
        """Return every import that stands in a cell of its own right, before or between the tasks."""
        lines = []
        for name, source in self._cells.items():
            if name.endswith(("-given", "-answer", "-check")):
                continue
            plain = "\n".join(line for line in source.splitlines() if not line.lstrip().startswith(("%", "!")))
            lines += [
                ast.unparse(node) for node in ast.parse(plain).body if isinstance(node, ast.Import | ast.ImportFrom)
            ]
        return "\n".join(lines)


def answer_cell_name(task_id: str) -> str:
    """Return the name of the cell that answers: "e3-2-answer" of "E3.2"."""
    return f"{slug(task_id)}-answer"


def given_name(task_id: str) -> str:
    """Return the variable that holds what is given: "e3_2" of "E3.2"."""
    return task_id.lower().replace(".", "_")


def solution_in_notebook(path: Path) -> Solution:
    """Return the solution in a built notebook.

    Raises:
        TaskError: there is no such notebook.
    """
    try:
        notebook = json.loads(path.read_text(encoding="utf-8"))
    except FileNotFoundError:
        raise TaskError(f"there is no solution {path}; `tflab build` makes it") from None
    cells = (cell for cell in notebook["cells"] if cell["cell_type"] == "code")
    return Solution(path.stem, [CodeCell(cell["id"], "".join(cell["source"])) for cell in cells])


@contextmanager
def in_process_ros() -> Iterator[None]:
    """Let `import rclpy` and the like find tflab's own until the block ends, with message fields checked.

    The block starts with no graph.  The caller's graph, and a real ROS 2 that it imported, are back at the end.
    One thread at a time is in such a block: it changes what the whole process imports.
    """
    with _one_thread:
        was_active, were_on, graph = activation.is_active(), checks.on, use_graph(None)
        real = {} if was_active else _real_modules()
        try:
            activation.activate("in-process")
            checks.on = True
            yield
        finally:
            checks.on = were_on
            use_graph(graph)
            if not was_active:
                activation.deactivate()
                sys.modules.update(real)


def _real_modules() -> dict[str, ModuleType]:
    """Take the modules of a real ROS 2 out of `sys.modules`, and return them."""
    names = [name for name in sys.modules if name.partition(".")[0] in activation.PACKAGES]
    return {name: sys.modules.pop(name) for name in names}
