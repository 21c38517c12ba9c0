"""What does a question look like?  The exercise's own text, with other numbers, and its answer cell to fill in.

```
text        "## E3.2 · A corner seen by a turned laser ..."        in the language of the copy
given       {"base_T_laser": ..., "laser_p_corner": ...}           drawn for this number
starter     imports, `e3_2 = practice.given()`, `corner = {"base_link": ..., "map": ...}`
```
"""

from __future__ import annotations

import ast
import json
import re
from functools import lru_cache
from pathlib import Path
from typing import Any, NamedTuple

from ..answers.values import from_plain
from ..places import exercise_file, workbook_data
from ..tasks.case_types import TaskCases, Variant
from ..tasks.reference import given_name
from ..tasks.task import slug
from .deck import Askable, drawn
from .kept import Open

__all__ = ["GIVEN_CALL", "DrawnQuestion", "question_of"]

POINTS = re.compile(r" \(\d+ points?\)| \(\d+점\)")
GIVEN_CALL = "practice.given()"


class DrawnQuestion(NamedTuple):
    """A question as it is asked.

    Attributes:
        item: the task, and where it is from.
        cases: what an answer is tried on: one variant.
        text: the question, Markdown.
        imports: what the chapter's exercises import.
        starter: the answer cell, its blanks to be filled in; what is given comes from `practice.given()`.
    """

    open: Open
    item: Askable
    cases: TaskCases
    text: str
    imports: str
    starter: str

    @property
    def variant(self) -> Variant:
        """Return what was drawn."""
        return self.cases.variants[0]

    @property
    def given_name(self) -> str:
        """Return the name of the variable that holds what is given: "e3_2"."""
        return given_name(self.item.task.id)

    @property
    def given(self) -> dict[str, Any]:
        """Return the values that are given, new ones each time."""
        return {name: from_plain(value) for name, value in (self.variant.given or {}).items()}


def question_of(opened: Open, item: Askable, language: str) -> DrawnQuestion:
    """Return the question that was opened, in a language."""
    cells = _cells(workbook_data(), item.stem, language)
    name = slug(item.task.id)
    text = POINTS.sub("", cells.get(name, f"## {item.task.id} · {item.task.title.say(language)}"), count=1)
    given = cells.get(f"{name}-given", "").replace(f'task("{item.task.id}")', GIVEN_CALL)
    starter = "\n".join(filter(None, [given, cells.get(f"{name}-answer", f"{item.task.answer} = ...")]))
    cases = drawn(item.stem, item.task.id, opened.number)
    computes = cases.is_function or item.task.given is not None
    imports = _imports(workbook_data(), item.stem, language) if computes else ""
    return DrawnQuestion(opened, item, cases, text, imports, starter)


@lru_cache
def _cells(data: Path, stem: str, language: str) -> dict[str, str]:
    path = data / "exercises" / language / exercise_file(stem)
    cells = json.loads(path.read_text(encoding="utf-8"))["cells"]
    return {cell["id"]: "".join(cell["source"]) for cell in cells}


@lru_cache
def _imports(data: Path, stem: str, language: str) -> str:
    """Return the lines that import something for every task of a chapter, but for what checks and gives."""
    lines = []
    for name, source in _cells(data, stem, language).items():
        if name in ("imports", "load"):
            plain = "\n".join(line for line in source.splitlines() if not line.lstrip().startswith("%"))
            nodes = [node for node in ast.parse(plain).body if isinstance(node, ast.Import | ast.ImportFrom)]
            lines += [text for text in map(_but_for_ours, nodes) if text]
    return "\n".join(lines)


def _but_for_ours(node: ast.Import | ast.ImportFrom) -> str:
    if isinstance(node, ast.ImportFrom) and node.module == "tflab.workbook":
        node = ast.ImportFrom(node.module, [name for name in node.names if name.name == "lesson"], node.level)
        return ast.unparse(node) if node.names else ""
    return ast.unparse(node)
