"""Honest work with cells of its own, merged, split and copied ones."""

from __future__ import annotations

import copy
from collections.abc import Callable

from .recipe import Honest, Notebook, Recipe, edited, is_code, named, own_cell

__all__ = ["HELPERS"]


def _own_helper(honest: Honest) -> Notebook:
    notebook = honest.with_cell("def my_inverse(transform):\n    return (RIGHT)", honest.function_task)
    honest.cell(notebook, honest.function_task)["source"] = (
        f"def {honest.function}(transform):\n    return my_inverse(transform)"
    )
    return notebook


def _answer_in_the_next_cell(honest: Honest) -> Notebook:
    notebook = honest.fresh()
    cell = honest.cell(notebook, honest.function_task)
    answer, cell["source"] = cell["source"], "# see below"
    notebook["cells"].insert(notebook["cells"].index(cell) + 1, own_cell(answer))
    return notebook


def _last_cell(notebook: Notebook, honest: Honest) -> None:
    """Move all answers to one cell at the end, and leave nothing where they stood."""
    answers = [cell for cell in notebook["cells"] if cell["id"].endswith("-answer")]
    notebook["cells"].append(own_cell("\n\n".join("".join(cell["source"]) for cell in answers), "all-in-one"))
    for cell in answers:
        cell["source"] = "# at the end"


def merged(*names: str, into: str) -> Callable[[Notebook, Honest], None]:
    """Return an edit that merges cells into one of them, as editors do: what it was called stays."""

    def edit(notebook: Notebook, honest: Honest) -> None:
        wanted = [cell for cell in notebook["cells"] if cell["id"] in names or (not names and is_code(cell))]
        kept = next(cell for cell in wanted if cell["id"] == into)
        kept["source"] = "\n\n".join("".join(cell["source"]) for cell in wanted)
        notebook["cells"] = [cell for cell in notebook["cells"] if cell is kept or cell not in wanted]

    return edit


def copied(text: str, behind: str) -> Callable[[Notebook, Honest], None]:
    """Return an edit that copies the function's answer cell to try something in: a copy keeps its name."""

    def edit(notebook: Notebook, honest: Honest) -> None:
        copy_of = copy.deepcopy(honest.cell(notebook, honest.function_task))
        copy_of |= {"id": "copied", "source": named(text, "F", honest.function)}
        place = next(number for number, cell in enumerate(notebook["cells"]) if cell["id"] == behind)
        notebook["cells"].insert(place + 1, copy_of)

    return edit


def _split(notebook: Notebook, honest: Honest) -> None:
    """Split an answer, and try something between the halves."""
    cell = honest.cell(notebook, "E3.5")
    lines = "".join(cell["source"]).splitlines(keepends=True)
    cell["source"], rest = "".join(lines[:2]), copy.deepcopy(cell) | {"id": "half", "source": "".join(lines[2:])}
    place = notebook["cells"].index(cell) + 1
    notebook["cells"][place:place] = [own_cell("print(x, y, z)"), rest]


def _breaks_of_every_kind(notebook: Notebook, honest: Honest) -> None:
    cell = honest.cell(notebook, honest.function_task)
    cell["source"] = "# a page\x0c# a line\u2028# a paragraph\u2029# the next\x85\n" + cell["source"].replace(
        "    ", "\t"
    )


HELPERS = [
    Recipe("a helper in a cell of its own", _own_helper),
    Recipe("the answer in the next cell", _answer_in_the_next_cell),
    Recipe("an import at the top", lambda h: h.with_cell("import itertools, collections", h.value_task)),
    Recipe("a helper that fails", lambda h: h.with_cell("this_name_is_unknown", h.function_task)),
    Recipe("a helper that does not parse", lambda h: h.with_cell("def (", h.function_task)),
    Recipe("installs something", lambda h: h.with_cell("!pip install nothing-of-that-name", h.value_task)),
    Recipe("times itself", lambda h: h.with_cell("%timeit -n1 -r1 sum(range(10))", h.value_task)),
    Recipe("a plot", lambda h: h.with_cell("import matplotlib.pyplot as plt\nplt.plot([1, 2]); plt.show()", h.function_task)),
    Recipe("a shell command", lambda h: h.with_cell("!echo hello", h.value_task)),
    Recipe("another cell magic", lambda h: h.with_cell("%%bash\necho hello", h.value_task)),
    edited("given and answer merged", merged("e3-2-given", "e3-2-answer", into="e3-2-given")),
    edited("given, answer and check merged", merged("e3-2-given", "e3-2-answer", "e3-2-check", into="e3-2-given")),
    edited("answer and check merged", merged("e3-3-answer", "e3-3-check", into="e3-3-check")),
    edited("two answers merged", merged("e3-3-answer", "e3-3-check", "e3-4-answer", into="e3-3-answer")),
    edited("everything merged into the first cell", merged(into="load")),
    edited("everything merged into the last cell", merged(into="e3-7-check")),
    edited("a copy to try something in", copied("print(F({'x': 1, 'y': 2, 'yaw': 0.5}))", "e3-3-check")),
    edited("a copy that is a note", copied("# def F(transform): ...", "e3-5-check")),
    edited("a copy above that fails", copied("F(1, 2, 3)", "imports")),
    edited("an answer in two halves with a print between", _split),
    Recipe("closes what it prints to", lambda h: h.with_cell("import sys\nsys.stdout.close()", "E3.1")),
    Recipe("has no place for errors", lambda h: h.with_cell("import sys\nsys.stderr = None", "E3.1")),
    Recipe("a shell in a shell", lambda h: h.with_cell("import IPython\nIPython.embed()", "E3.1")),
    Recipe("names of builtins taken", lambda h: h.with_cell("list = [1]\nstr = 'x'\nprint = None\nlen = 3\ndict = {}\ntype = 0", "E3.1")),
    Recipe("calls without brackets", lambda h: h.with_cell("%autocall 2", "E3.1")),
    Recipe("a debugger at every error", lambda h: h.with_cell("%pdb on\n1 / 0", "E3.1")),
    Recipe("undone at the end", lambda h: h.with_cell("del calls, corner, F, compose", "E3.7", "check")),
    edited("a magic above every answer", lambda n, h: [c.update(source="%%time\n" + "".join(c["source"])) for c in n["cells"] if c["id"].endswith("-answer")]),
    edited("line breaks of every kind, and tabs", _breaks_of_every_kind),
    edited("all answers in one cell at the end", _last_cell),
    edited("nothing but answers", lambda n, h: n.update(cells=[c for c in n["cells"] if c["id"].endswith("-answer")])),
    edited("the other way round", lambda n, h: n["cells"].reverse()),
]  # fmt: skip
