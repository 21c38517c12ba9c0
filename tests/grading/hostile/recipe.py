"""Make submissions that are hostile, broken, or odd but right, from honest work."""

from __future__ import annotations

import copy
import json
import re
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import yaml

from tflab.workbook.paths import workbook_data

Notebook = dict[str, Any]


@dataclass(frozen=True)
class Honest:
    """An honest notebook, and the names of what can be attacked in it.

    Attributes:
        notebook: every task answered rightly.
        function_task, function: a task whose answer is a function that turns a pose round, and its name.
        value_task, value: a task whose answer is a dict of points, and its name.
        seed: of the learners' numbers, which everybody can read in their copy.
    """

    notebook: Notebook
    function_task: str
    function: str
    value_task: str
    value: str
    seed: str

    def fresh(self) -> Notebook:
        """Return a copy to spoil."""
        return copy.deepcopy(self.notebook)

    def cell(self, notebook: Notebook, task: str, role: str = "answer") -> dict[str, Any]:
        """Return a task's cell in a notebook."""
        name = f"{task.lower().replace('.', '-')}-{role}"
        return next(cell for cell in notebook["cells"] if cell["id"] == name)

    def with_function(self, body: str) -> Notebook:
        """Return the notebook with the function's answer cell replaced; `F` is the function's name."""
        notebook = self.fresh()
        self.cell(notebook, self.function_task)["source"] = self.seeded(named(body, "F", self.function))
        return notebook

    def with_value(self, body: str) -> Notebook:
        """Return the notebook with the value's answer cell replaced; `V` is the value's name."""
        notebook = self.fresh()
        self.cell(notebook, self.value_task)["source"] = self.seeded(named(body, "V", self.value))
        return notebook

    def seeded(self, body: str) -> str:
        """Return a recipe's code with the seed in place of SEED."""
        return re.sub(r"\bSEED\b", repr(self.seed), body)

    def with_cell(self, source: str, before: str, role: str = "answer") -> Notebook:
        """Return the notebook with a cell of the learner's own put before a task's cell."""
        notebook = self.fresh()
        place = notebook["cells"].index(self.cell(notebook, before, role))
        notebook["cells"].insert(place, own_cell(named(source, "F", self.function)))
        return notebook


def honest_notebook(folder: Path, stem: str) -> Notebook:
    """Return an exercise as it was handed out, with the solution's answers in it."""
    solution = json.loads((workbook_data() / f"solutions/en/{stem}.ipynb").read_text(encoding="utf-8"))
    answers = {cell["id"]: cell["source"] for cell in solution["cells"] if cell["id"].endswith("-answer")}
    notebook = json.loads((folder / f"exercises/en/E{stem}.ipynb").read_text(encoding="utf-8"))
    for cell in notebook["cells"]:
        cell["source"] = "".join(answers.get(cell["id"], cell["source"]))
    return notebook


@dataclass(frozen=True)
class Recipe:
    """How to make one submission: see the top of this page."""

    name: str
    make: Callable[[Honest], Notebook | bytes]
    spoils: str = ""
    keeps: str = "all"


RIGHT = """{
        'x': -(math.cos(transform['yaw']) * transform['x'] + math.sin(transform['yaw']) * transform['y']),
        'y': math.sin(transform['yaw']) * transform['x'] - math.cos(transform['yaw']) * transform['y'],
        'yaw': -transform['yaw'],
    }"""


def named(body: str, letter: str, name: str) -> str:
    """Return a recipe's code with the answer's real name in place of its letter, and what is right in place of RIGHT."""
    return re.sub(rf"\b{letter}\b", name, body).replace("RIGHT", RIGHT)


def own_cell(source: str, name: str = "my-own") -> dict[str, Any]:
    """Return a code cell as JupyterLab would add it."""
    return {
        "cell_type": "code", "execution_count": None, "id": name, "metadata": {}, "outputs": [], "source": source,
    }  # fmt: skip


def as_bytes(notebook: Notebook) -> bytes:
    """Return a notebook as a file has it."""
    return json.dumps(notebook, ensure_ascii=False).encode()


def function(name: str, body: str, keeps: str = "others") -> Recipe:
    """Return an attack that stands where a function should."""
    return Recipe(name, lambda honest: honest.with_function(body), "function", keeps)


def value(name: str, body: str, keeps: str = "others") -> Recipe:
    """Return an attack that stands where three numbers should."""
    return Recipe(name, lambda honest: honest.with_value(body), "value", keeps)


def edited(name: str, edit: Callable[[Notebook, Honest], Any], spoils: str = "", keeps: str = "all") -> Recipe:
    """Return a recipe that changes a notebook in place."""

    def make(honest: Honest) -> Notebook:
        notebook = honest.fresh()
        edit(notebook, honest)
        return notebook

    return Recipe(name, make, spoils, keeps)


# Computes the cases of a task, with the numbers that this class was given.
CASES = """
from tflab.workbook.paths import Workbook, chapters, workbook_data
from tflab.workbook.tasks.catalog import assigned_cases
def cases_of(task, seed=SEED):
    stem = next(stem for stem in chapters() if task.startswith(f'E{int(stem[:2])}.'))
    return assigned_cases(workbook_data(), stem, task, Workbook(seed=seed)).variants[0].cases
"""

WRONG = "def F(transform):\n    return None\n"


def raw(name: str, make: Callable[[Honest], bytes], keeps: str = "none") -> Recipe:
    """Return a recipe of bytes."""
    return Recipe(name, make, "", keeps)


def right(name: str, body: str) -> Recipe:
    """Return a right answer, oddly written, where a function should stand."""
    return Recipe(name, lambda honest: honest.with_function(body))


WIRE = (
    WRONG
    + """
import json, struct
wire = get_ipython().kernel.session.wire
parent = get_ipython().kernel.get_parent()['header']['msg_id']
PROBE = 'application/vnd.tflab.probe+json'
def raw(body):
    wire.end.setblocking(True)
    wire.end.sendall(struct.pack('!I', len(body)) + body)
def say(kind, content, to=parent):
    raw(json.dumps({'channel': 'iopub', 'msg_type': kind, 'parent_header': {'msg_id': to}, 'content': content}).encode())
"""
)


def answered(name: str, task: str, body: str) -> Recipe:
    """Return a right answer to another task, oddly written."""

    def make(honest: Honest) -> Notebook:
        notebook = honest.fresh()
        honest.cell(notebook, task)["source"] = body
        return notebook

    return Recipe(name, make)


def cell(name: str, body: str, before: str) -> Recipe:
    """Return honest work with a cell of the learner's own before a task's answer."""
    return Recipe(name, lambda honest: honest.with_cell(body, before))


MAKERS = {"function": function, "value": value, "right": right, "answered": answered, "cell": cell}
PIECES = {"WRONG": WRONG, "CASES": CASES, "WIRE": WIRE}


def page(name: str) -> dict[str, Any]:
    """Return a page of the library: recipes, and tables of code that they are made from."""
    return yaml.safe_load(Path(__file__).with_name(f"{name}.yaml").read_text(encoding="utf-8"))


def recipes(name: str) -> list[Recipe]:
    """Return the recipes of a page; `each` makes one of every row of a table."""
    held = page(name)
    pieces = PIECES | held.get("pieces", {})
    return [
        _made(row, pieces, {"name": entry, "code": code} if isinstance(code, str) else {"name": entry, **code})
        for row in held["recipes"]
        for entry, code in (held[row["each"]].items() if "each" in row else [("", "")])
        if entry in row.get("only", [entry])
    ]


def _made(row: dict[str, Any], pieces: dict[str, str], entry: dict[str, str]) -> Recipe:
    """Return the recipe of a row, with what a table has in place of <name>, <code> and the like."""

    def filled(text: str) -> str:
        return re.sub(r"<(\w+)>", lambda mark: repr(entry["code"]) if mark[1] == "repr" else entry[mark[1]], text)

    (kind,) = row.keys() & MAKERS.keys()
    code = filled(row["code"]) if "each" in row else row["code"]
    body = "".join([*(pieces[one] for one in row.get("begin", ())), code, *(pieces[one] for one in row.get("end", ()))])
    options = {key: row[key] for key in ("keeps", "before") if key in row}
    if kind == "answered":
        return answered(row[kind], row["task"], body)
    return MAKERS[kind](filled(row[kind]) if "each" in row else row[kind], body, **options)


def is_code(cell: dict[str, Any]) -> bool:
    return cell["cell_type"] == "code"
