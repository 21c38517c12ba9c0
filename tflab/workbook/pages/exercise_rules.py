"""Check what an exercise must keep to: each task has its text, its inputs, its answer, its check.

```
## E3.2 · A corner seen by a turned laser      "e3-2", in both languages
e3_2 = task("E3.2")                            "e3-2-given", if something is given
# BEGIN SOLUTION ... # END SOLUTION            "e3-2-answer", tagged "answer"
check("E3.2", base_p_corner)                   "e3-2-check", tagged "check"
```
"""

from __future__ import annotations

import ast
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from difflib import get_close_matches
from typing import Any

import yaml

from ...text import LANGUAGES
from ..inventory.items import FORMS, imbalances, parsed, with_questions
from ..tasks.strip_solution import BlankError, blank, regions
from ..tasks.task import Task, slug
from .editions import Outputs, task_of
from .source import Page, PageFault, SourceCell

__all__ = ["exercise_faults", "form_faults", "score_faults", "untouched", "untouched_faults"]

CALLS = ("check", "hint", "solution", "task")


def exercise_faults(page: Page, tasks: Sequence[Task]) -> list[PageFault]:
    """Return what is wrong with a solution's page, given the tasks of its chapter."""
    found = [fault for task in tasks for fault in _task(page, task)]
    ids = [task.id for task in tasks]
    for cell in page.code:
        found += _cell(page, cell, ids)
    return sorted(set(found), key=lambda fault: (fault.line, fault.wrong))


def form_faults(page: Page, tasks: Sequence[Task]) -> list[PageFault]:
    """Return what is wrong with the form of the test that a page holds, if it holds one."""
    form = next((form for form, task_id in FORMS.items() if task_id in {task.id for task in tasks}), None)
    path = page.path.parents[1] / "inventory.yaml"
    if form is None or not path.is_file():
        return []
    try:
        items = parsed(path.read_text(encoding="utf-8"))
    except (KeyError, TypeError, ValueError, AttributeError, yaml.YAMLError) as error:
        wrong = f"the items of the test cannot be read: {type(error).__name__}: {error}"
        return [PageFault(f"solutions/{path.name}", 1, "", wrong, "correct it; its head says what an item holds")]
    remedy = "weigh both forms again"
    faults = [PageFault(f"solutions/{path.name}", 1, "", wrong, remedy) for wrong in imbalances(items, form)]
    source = page.path.read_text(encoding="utf-8")
    try:
        in_step = with_questions(source, items, form) == source
    except LookupError as error:
        return [*faults, page.fault(None, str(error), "add them, in this order")]
    cell = _find(page, "questions", "en")
    out_of_step = page.fault(
        cell, "the questions are not those of solutions/inventory.yaml", "run: python -m tflab.workbook.course.contents"
    )
    return faults if in_step else [*faults, out_of_step]


def score_faults(page: Page, tasks: Iterable[str], outputs: Outputs) -> list[PageFault]:
    """Return a fault for each task that its own solution, as it was run, does not pass."""
    found = []
    for task in tasks:
        check = _find(page, f"{slug(task)}-check", None)
        if check is not None:
            printed = "".join(map(_words_of, outputs.get(check.name, ())))
            if not printed.startswith(f"{task} ✓"):
                wrong = f"the solution does not pass: {' '.join(printed.split())[:300]}"
                found.append(page.fault(check, wrong, f"correct the answer, or {task} in solutions/tasks/{page.stem}"))
    return found


def untouched(page: Page) -> Page:
    """Return a solution's page as a learner's kernel gets it: its regions blanked."""
    cells = (replace(cell, source=blank(cell.source)) if cell.kind == "code" else cell for cell in page.cells)
    return replace(page, cells=tuple(cells))


def untouched_faults(page: Page, outputs: Outputs) -> list[PageFault]:
    """Return what is wrong with an exercise that was run untouched: it must reach its end, and pass nothing."""
    found = []
    for cell in page.code:
        for output in outputs.get(cell.name, ()):
            if output["output_type"] == "error" and "raises-exception" not in cell.tags:
                wrong = f"untouched, the exercise raises {output['ename']}: {output['evalue']}"
                found.append(page.fault(cell, wrong, "call nothing that is not answered yet"))
            if "check" in cell.tags and "✓" in _words_of(output):
                found.append(page.fault(cell, "untouched, the exercise passes", "take more of the answer out"))
    return found


def _task(page: Page, task: Task) -> Iterator[PageFault]:
    """Find what a task lacks: each of its four cells, and their order."""
    name = slug(task.id)
    text = _find(page, name, "en")
    cells = [_find(page, f"{name}-{role}", None) for role in ("given", "answer", "check")]
    given, answer, check = cells
    yield from _text(page, task)
    yield from _given(page, task, text, given)
    yield from _answer(page, task, text, answer)
    yield from _check(page, task, text, check)
    in_order = [cell.line for cell in (text, *cells) if cell is not None]
    if in_order != sorted(in_order):
        yield page.fault(text, f"the cells of {task.id} are not in order", "text, given, answer, check")


def _text(page: Page, task: Task) -> Iterator[PageFault]:
    name = slug(task.id)
    for language in LANGUAGES:
        text = _find(page, name, language)
        if text is not None and task.id not in text.source.partition("\n")[0]:
            yield page.fault(text, f"its heading does not name {task.id}", f'write "## {task.id} · ..."')
    if _find(page, name, "en") is None:
        yield page.fault(None, f"{task.id} has no text", f'write one named "{name}" in both languages')


def _given(page: Page, task: Task, text: SourceCell | None, given: SourceCell | None) -> Iterator[PageFault]:
    name = slug(task.id)
    if task.given is not None and given is None:
        remedy = f'add a cell "{name}-given": {name.replace("-", "_")} = task(...)'
        yield page.fault(text, f"{task.id} has no given", remedy)
    if given is not None and ("task", task.id) not in _calls(given):
        yield page.fault(given, "it does not call for its task", f'write ... = task("{task.id}")')


def _answer(page: Page, task: Task, text: SourceCell | None, answer: SourceCell | None) -> Iterator[PageFault]:
    if answer is None:
        remedy = f'add a code cell "{slug(task.id)}-answer" tags=["answer"]'
        yield page.fault(text, f"{task.id} has no answer", remedy)
    elif "answer" not in answer.tags:
        yield page.fault(answer, "it is not tagged", 'add tags=["answer"]')


def _check(page: Page, task: Task, text: SourceCell | None, check: SourceCell | None) -> Iterator[PageFault]:
    if check is None:
        remedy = f'add a code cell "{slug(task.id)}-check" tags=["check"]'
        yield page.fault(text, f"{task.id} has no check", remedy)
        return
    if "check" not in check.tags:
        yield page.fault(check, "it is not tagged", 'add tags=["check"]')
    call = f'check("{task.id}", {task.answer})'
    if check.source.strip() != call:
        yield page.fault(check, "it does not hold the check alone", f"write {call}")


def _cell(page: Page, cell: SourceCell, ids: Sequence[str]) -> Iterator[PageFault]:
    """Find regions that cannot be blanked, and tasks that nobody knows."""
    answers = "answer" in cell.tags
    if (answers or "check" in cell.tags) and task_of(cell.name, ids) is None:
        yield page.fault(
            cell, "it is of no task", f"there is {', '.join(ids)}; name it after one, as {slug(ids[0])}-answer"
        )
    try:
        marked = regions(cell.source)
        if answers and not marked:
            yield page.fault(cell, "nothing is marked as the solution", "add # BEGIN SOLUTION and # END SOLUTION")
        if marked and not answers:
            yield page.fault(cell, "a solution stands in a cell that is no answer", 'add tags=["answer"]')
        blank(cell.source)
    except BlankError as error:
        yield page.fault(cell, error.wrong, error.remedy)
    for call, asked in _calls(cell):
        if call in ("hint", "solution"):
            yield page.fault(cell, f"{call} prints in one language", "let the learner type it; name it in the text")
        if asked not in ids:
            close = get_close_matches(asked, ids, n=1)
            remedy = f"there is {', '.join(ids)}" + (f'. Did you mean "{close[0]}"?' if close else "")
            yield page.fault(cell, f'{call} names the task "{asked}", which is not in solutions/tasks', remedy)


def _words_of(output: Mapping[str, Any]) -> str:
    """Return what an output says: what was printed, or the words of what was shown."""
    return "".join(output.get("text") or output.get("data", {}).get("text/plain", ()))


def _find(page: Page, name: str, language: str | None) -> SourceCell | None:
    return next((cell for cell in page.cells if (cell.name, cell.lang) == (name, language)), None)


def _calls(cell: SourceCell) -> list[tuple[str, str]]:
    """Return the calls of task, check, hint and solution in a cell: what, and which task."""
    try:
        tree = ast.parse(cell.source)
    except SyntaxError:  # magics
        return []
    return [
        (node.func.id, node.args[0].value)
        for node in ast.walk(tree)
        if isinstance(node, ast.Call)
        and isinstance(node.func, ast.Name)
        and node.func.id in CALLS
        and node.args
        and isinstance(node.args[0], ast.Constant)
        and isinstance(node.args[0].value, str)
    ]
