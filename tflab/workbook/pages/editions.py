"""Make the notebooks of one page: lecture or solution, English or Korean, and the exercise.

    page --run once--+--> lecture_notebook(page, "en", outputs)     notebooks/en, solutions/en
      |              +--> lecture_notebook(page, "ko", outputs)     the same code, outputs without figures
      +--blank----------> exercise_notebook(page, "en", tasks)      exercises/en: nothing run

A notebook is a plain dict in the shape of nbformat 4.5, and `text_of` writes it the
same way every time: ids are names, counts are 1 to N, nothing says when or where.

    tag "collapsed"   the code is hidden until a reader opens it, and on slides
    tag "static"      draws what the live view before it shows; only its figure is kept, as that cell's output
    cell "core-end"   ends what everybody reads; the sections after it are collapsed to their headings
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import Any

from ...text import LANGUAGES
from ..course.glossary import MARKED, UnknownTerm, expand
from ..tasks.strip_solution import blank
from ..tasks.task import slug
from .source import Page, SourceCell

__all__ = [
    "Outputs", "exercise_notebook", "lecture_notebook", "task_of", "text_of", "with_figures",
]  # fmt: skip

KERNEL = {"display_name": "Python 3", "language": "python", "name": "python3"}
PNG = "image/png"
ROLES = ("given", "answer", "check")
CORE_END = "core-end"
COLLAPSED_HEADING = "jp-MarkdownHeadingCollapsed"  # JupyterLab's name for it
UNCOMPARED = "nbval-ignore-output"  # a live view runs as a widget, and its figure is stored
Notebook = dict[str, Any]
Outputs = Mapping[str, list[dict]]  # cell name -> its outputs


def lecture_notebook(page: Page, language: str, outputs: Outputs, tasks: Mapping[str, Any] | None = None) -> Notebook:
    """Return a page as it was run; a solution's tasks are marked if it has `tasks`."""
    cells: list[dict] = []
    count = 0
    is_core = True
    for cell in page.in_language(language):
        if _is_note(cell):
            _add_note(cells, cell, language)
        if _is_note(cell) or "static" in cell.tags:
            continue
        made = _cell(cell, language)
        if not is_core and cell.kind == "markdown" and cell.source.startswith("## "):
            made["metadata"][COLLAPSED_HEADING] = True
        is_core = is_core and cell.name != CORE_END
        task = task_of(cell.name, tasks or ())
        if task:
            made["metadata"]["tflab"] = {"task": task}
        shown = outputs.get(cell.name, [])
        if cell.kind == "code" and (shown or "interactive" not in cell.tags):
            count += 1
            _add_outputs(made, shown, count, language)
        cells.append(made)
    return _notebook(page, language, cells)


def _add_outputs(made: dict, shown: list[dict], count: int, language: str) -> None:
    """Store what a code cell put out; a figure is stored with the English page only."""
    if "interactive" in made["metadata"].get("tags", ()):
        made["metadata"]["tags"].append(UNCOMPARED)
    made["execution_count"] = count
    made["outputs"] = [
        _counted(output if language == LANGUAGES[0] else _without_figure(output), count) for output in shown
    ]


def exercise_notebook(page: Page, language: str, tasks: Mapping[str, Mapping[str, Any]]) -> Notebook:
    """Return a solution's page as a learner gets it: regions blanked, nothing run.

    Args:
        tasks: by id, as in the public cases.

    Raises:
        BlankError: a region cannot be taken out.
    """
    cells = []
    for cell in page.in_language(language):
        if _is_note(cell):
            continue
        made = _cell(cell, language)
        made["metadata"]["deletable"] = False  # nothing of it goes by an accident; cells may be added anywhere
        if cell.kind == "markdown":
            made["metadata"]["editable"] = False
        else:
            made["source"] = _lines(blank(cell.source))
            task = task_of(cell.name, tasks)
            if task:
                made["metadata"] |= _task_metadata(cell.name, task, tasks[task].points)
        cells.append(made)
    return _notebook(page, language, cells)


def with_figures(page: Notebook, english: Notebook) -> Notebook:
    """Return a page in another language with the figures of the English one, which are stored once."""
    outputs = {cell["id"]: cell["outputs"] for cell in english["cells"] if cell["cell_type"] == "code"}
    for cell in page["cells"]:
        if any(PNG in output.get("data", ()) for output in outputs.get(cell["id"], ())):
            cell["outputs"] = outputs[cell["id"]]
    return page


def _without_figure(output: dict) -> dict:
    if PNG not in output.get("data", ()):
        return output
    return output | {"data": {mime: value for mime, value in output["data"].items() if mime != PNG}}


def task_of(name: str, tasks) -> str | None:
    """Return the task whose given, answer or check the cell of this name is; None for any other cell."""
    by_name = {f"{slug(task)}-{role}": task for task in tasks for role in ROLES}
    return by_name.get(name)


def text_of(notebook: Notebook) -> str:
    """Return a notebook as the text of its file, the same every time."""
    return json.dumps(notebook, sort_keys=True, indent=1, ensure_ascii=False) + "\n"


def _notebook(page: Page, language: str, cells: list[dict]) -> Notebook:
    metadata = {
        "kernelspec": KERNEL,
        "language_info": {"name": "python"},
        "tflab": {"chapter": page.stem, "language": language},
    }
    return {"cells": cells, "metadata": metadata, "nbformat": 4, "nbformat_minor": 5}


def _cell(cell: SourceCell, language: str) -> dict:
    metadata: dict[str, Any] = {"name": cell.name}
    if cell.tags:
        metadata["tags"] = list(cell.tags)
    if cell.slide != "-":
        metadata["slideshow"] = {"slide_type": cell.slide}
    if "collapsed" in cell.tags:
        metadata["jupyter"] = {"source_hidden": True}
    made = {"cell_type": cell.kind, "id": cell.name, "metadata": metadata}
    if cell.kind == "code":
        return made | {"execution_count": None, "outputs": [], "source": _lines(cell.source)}
    return made | {"source": _lines(_with_terms(cell.source, language))}


def _with_terms(text: str, language: str) -> str:
    """Return a text with its [[terms]] explained by the glossary."""
    try:
        return expand(text, language)
    except (UnknownTerm, FileNotFoundError):  # which is a fault already: see rules.py
        return MARKED.sub(lambda found: found[2] or found[1], text)


def _is_note(cell: SourceCell) -> bool:
    return cell.kind == "markdown" and cell.slide == "notes"


def _add_note(cells: list[dict], note: SourceCell, language: str) -> None:
    """Keep what the speaker says with the cell before: a reader does not see it, the deck shows it."""
    if not cells:
        return
    ours = cells[-1]["metadata"].setdefault("tflab", {})
    ours["notes"] = "\n\n".join([*([ours["notes"]] if "notes" in ours else []), _with_terms(note.source, language)])


def _task_metadata(name: str, task: str, points: float) -> dict:
    """Return what nbgrader, JupyterLab and our own grading read from a cell of a task."""
    role = name.rpartition("-")[2]
    nbgrader = {
        "cell_type": "code",
        "grade": role == "check",
        "grade_id": name,
        "locked": role != "answer",
        "schema_version": 3,
        "solution": role == "answer",
        "task": False,
    }
    if role == "check":
        nbgrader["points"] = points
    made: dict[str, Any] = {"nbgrader": nbgrader, "tflab": {"task": task}}
    if role != "answer":
        made["editable"] = False
    return made


def _counted(output: dict, count: int) -> dict:
    return output | {"execution_count": count} if output["output_type"] == "execute_result" else output


def _lines(text: str) -> list[str]:
    return text.splitlines(keepends=True)
