"""Notebooks that say something else than what was handed out: checks, givens, names, stamps, outputs."""

from __future__ import annotations

import copy

from .recipe import WRONG, Honest, Notebook, edited, named, own_cell

__all__ = ["TAMPERING"]


def _all_points(notebook: Notebook, honest: Honest) -> None:
    for cell in notebook["cells"]:
        cell["metadata"].setdefault("nbgrader", {})["points"] = 1000


def _forged_outputs(notebook: Notebook, honest: Honest) -> None:
    honest.cell(notebook, honest.function_task)["source"] = named(WRONG, "F", honest.function)
    check = honest.cell(notebook, honest.function_task, "check")
    check["outputs"] = [{"name": "stdout", "output_type": "stream", "text": f"{honest.function_task} ✓ 6/6\n"}]


def _changed_check(notebook: Notebook, honest: Honest) -> None:
    honest.cell(notebook, honest.function_task)["source"] = named(WRONG, "F", honest.function)
    honest.cell(notebook, honest.function_task, "check")["source"] = f"print('{honest.function_task} ✓ 6/6')"


def _changed_given(notebook: Notebook, honest: Honest) -> None:
    name = honest.value_task.lower().replace(".", "_")
    honest.cell(notebook, honest.value_task, "given")["source"] = (
        f"from types import SimpleNamespace\n{name} = SimpleNamespace(easy={{'base_link': (1.0, 2.0, 3.0), 'map': (3.0, 2.0, 1.0)}})"
    )
    honest.cell(notebook, honest.value_task)["source"] = f"{honest.value} = {name}.easy"


def _two_different(notebook: Notebook, honest: Honest) -> None:
    second = copy.deepcopy(honest.cell(notebook, honest.function_task))
    second["source"] = named(WRONG, "F", honest.function)
    notebook["cells"].append(second)


def _wrong_places(notebook: Notebook, honest: Honest) -> None:
    cell = honest.cell(notebook, honest.value_task)
    cell["source"] = honest.cell(notebook, honest.function_task)["source"]


def _stub(notebook: Notebook, honest: Honest) -> None:
    honest.cell(notebook, honest.value_task)["source"] = f"{honest.value} = ..."


TAMPERING = [
    edited("a thousand points for each cell", _all_points),
    edited("outputs that say passed", _forged_outputs, "function", "others"),
    edited("a check that always passes", _changed_check, "function", "others"),
    edited("a given that suits the answer", _changed_given, "value", "others"),
    edited("two different cells of one name", _two_different, "function", "others"),
    edited("one answer in another's place", _wrong_places, "value", "others"),
    edited("an answer left out", _stub, "value", "others"),
    edited("a stamp of another learner", lambda n, h: n["metadata"].setdefault("tflab", {}).update(learner="somebody")),
    edited("checks removed", lambda n, h: n.update(cells=[c for c in n["cells"] if not c["id"].endswith("-check")])),
    edited("givens removed", lambda n, h: n.update(cells=[c for c in n["cells"] if not c["id"].endswith("-given")])),
    edited("a check of a task that does not exist", lambda n, h: n["cells"].append(own_cell('check("E3.99", 1)'))),
    edited("a name that leads out", lambda n, h: [c["metadata"].update(name="../../" + c["id"]) for c in n["cells"]]),
    edited("a stamp of code", lambda n, h: n["metadata"].setdefault("tflab", {}).update(learner="<script>alert(1)</script>", release="{0.__class__}", chapter="../../etc")),
    edited("an id that is a list", lambda n, h: n["cells"].append({"id": ["e3-3-answer"], "cell_type": "code", "metadata": {"name": ["e3-3-answer"]}, "source": "1/0"})),
    edited("a thousand cells of its own", lambda n, h: n["cells"].extend(own_cell(f"x{i} = {i}", f"own{i}") for i in range(1000))),
]  # fmt: skip
