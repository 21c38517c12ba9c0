"""Tricks with what stands in the notebook around the cells."""

from __future__ import annotations

import copy
from collections.abc import Callable

from .recipe import WRONG, Honest, Notebook, edited, named, own_cell

__all__ = ["NOTEBOOKS"]


def _metadata(**held: object) -> Callable[[Notebook, Honest], None]:
    return lambda notebook, honest: notebook["metadata"].update(held)


def _each_cell(change: Callable[[dict], object]) -> Callable[[Notebook, Honest], None]:
    return lambda notebook, honest: [change(cell) for cell in notebook["cells"]] and None


def _swapped(notebook: Notebook, honest: Honest) -> None:
    """Let two answers have each other's ids."""
    one, other = honest.cell(notebook, honest.function_task), honest.cell(notebook, honest.value_task)
    one["id"], other["id"] = other["id"], one["id"]
    for cell in (one, other):
        cell["metadata"] = {}


def _doubled(notebook: Notebook, honest: Honest) -> None:
    """A wrong answer, and a right one with the id of the check."""
    check = honest.cell(notebook, honest.function_task, "check")
    answer = honest.cell(notebook, honest.function_task)
    check["source"], answer["source"] = "print('ok')", named(WRONG, "F", honest.function)


def _all_one_id(notebook: Notebook, honest: Honest) -> None:
    for cell in notebook["cells"]:
        cell["id"] = "e3-3-check"
        cell["metadata"].pop("name", None)


def _wrong_in(place: Callable[[dict, str], None]) -> Callable[[Notebook, Honest], None]:
    """Return an edit that leaves a wrong answer in the source, and puts a right one where no source is."""

    def edit(notebook: Notebook, honest: Honest) -> None:
        cell = honest.cell(notebook, honest.function_task)
        held = "".join(cell["source"])
        cell["source"] = named(WRONG, "F", honest.function)
        place(cell, held)

    return edit


NOTEBOOKS = [
    edited("a kernel that is a command", _metadata(kernelspec={"name": "sh", "argv": ["/bin/sh", "-c", "touch /tmp/was-here-spec"], "language": "python"})),
    edited("a kernel that is a path", _metadata(kernelspec={"name": "../../../../tmp/evil", "display_name": "x" * 10**6})),
    edited("a kernelspec that is a list", _metadata(kernelspec=[1, 2], language_info="python")),
    edited("papermill, jupytext and widgets in the metadata", _metadata(papermill={"parameters": {"invert": 1}}, jupytext={"text_representation": {"extension": ".py"}}, widgets={"application/vnd.jupyter.widget-state+json": {"state": {}}})),
    edited("a format of the future", lambda n, h: n.update(nbformat=4, nbformat_minor=99)),
    edited("a format that is a text", lambda n, h: n.update(nbformat_minor="5")),
    edited("every cell skipped, hidden, trusted and raising by its tags", _each_cell(lambda c: c["metadata"].update(tags=["skip-execution", "raises-exception", "nbval-skip", "remove-cell"], trusted=True, init_cell=True))),
    edited("every cell locked for nbgrader, with a hidden test", _each_cell(lambda c: c["metadata"].update(nbgrader={"grade": True, "locked": True, "points": 99, "solution": False, "schema_version": 3, "grade_id": "x"}))),
    edited("execution counts of every kind", _each_cell(lambda c: c.update(execution_count=-(10**30)) if c["cell_type"] == "code" else None)),
    edited("outputs that are no outputs", _each_cell(lambda c: c.update(outputs=[None, 3, {"output_type": []}, {"output_type": "display_data", "data": {"text/html": ["<script>"] * 9}}]) if c["cell_type"] == "code" else None)),
    edited("ten megabytes of a picture in an attachment", lambda n, h: n["cells"].insert(0, {"cell_type": "markdown", "id": "pic", "metadata": {}, "source": "![x](attachment:x.png)", "attachments": {"x.png": {"image/png": "A" * 10_000_000}}})),
    edited("attachments that are code", lambda n, h: n["cells"].insert(0, {"cell_type": "raw", "id": "raw", "metadata": {"format": "text/x-python"}, "source": "def invert(t): return None", "attachments": [1]})),
    edited("a cell of no known type", lambda n, h: n["cells"].append({"cell_type": "heading", "id": "x", "metadata": {}, "source": "x", "level": 9})),
    edited("sources that hold numbers", lambda n, h: n["cells"].append({**own_cell(""), "source": [1, None, ["x"], {"y": 1}]})),
    edited("a thousand keys beside the cells", lambda n, h: n.update({f"key{number}": [number] * 20 for number in range(1000)})),
    edited("ids of every letter", lambda n, h: n["cells"].extend(own_cell("pass", identity) for identity in ("", " ", "é" * 64, "e3-3-answer ", "E3-3-ANSWER", "e3‑3‑answer", "../x", "e3-3-answer\n"))),
    edited("cells doubled, as they are", lambda n, h: n["cells"].extend(copy.deepcopy(n["cells"]))),
    edited("the ids of two answers swapped", _swapped, "", "any"),
    edited("one id for all cells", _all_one_id, "", "any"),
    edited("the check is an answer", _doubled, "function", "others"),
    edited("a right answer in the outputs", _wrong_in(lambda c, held: c.update(outputs=[{"output_type": "execute_result", "execution_count": 1, "metadata": {}, "data": {"text/plain": held}}])), "function", "others"),
    edited("a right answer in the metadata", _wrong_in(lambda c, held: c["metadata"].update(source=held, nbgrader={"source": held})), "function", "others"),
    edited("a right answer in an attachment", _wrong_in(lambda c, held: c.update(attachments={"a.py": {"text/x-python": held}})), "function", "others"),
    edited("a right answer in a cell of text", _wrong_in(lambda c, held: c.update(cell_type="markdown", source=held)), "function", "others"),
    edited("a right answer in a raw cell", _wrong_in(lambda c, held: c.update(cell_type="raw", source=held)), "function", "others"),
]  # fmt: skip
