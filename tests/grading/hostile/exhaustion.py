"""Attacks on time and memory: what does not end, what shouts, what takes all there is."""

from __future__ import annotations

import copy
from collections.abc import Callable

from .recipe import Honest, Notebook, edited, function, own_cell, recipes, value

__all__ = ["EXHAUSTION"]


def _in_two_answers(text: str) -> Callable[[Notebook, Honest], None]:
    """Return an edit that makes the grader itself parse a text."""

    def edit(notebook: Notebook, honest: Honest) -> None:
        cell = honest.cell(notebook, honest.function_task)
        cell["source"] = text
        notebook["cells"] += [copy.deepcopy(cell) | {"id": "two", "source": text + "\n#"}, own_cell(text)]

    return edit


BOMBS = {"members of members": "x" + ".a" * 90_000, "a long sum": "+".join("1" * 90_000), "signs": "-" * 150_000 + "1",
         "brackets": "(" * 90_000 + ")" * 90_000, "lambdas": "lambda:" * 25_000 + "0"}  # fmt: skip


EXHAUSTION = [
    *recipes("exhaustion"),
    value("a cell of four megabytes", "V = 1\n" + "# " + "x" * (4 << 20)),
    value("twenty thousand statements", "V = 1\n" + "x = 1\n" * 20_000, keeps="any"),
    function("a script that eats what it is given", "%%script --no-raise-error cat\n" + "x" * 100_000),
    *(edited(f"the grader parses {name}", _in_two_answers(text), "function", "others") for name, text in BOMBS.items()),
]  # fmt: skip
