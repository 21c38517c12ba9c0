"""A chapter of three tasks in a folder of its own, a class that is handed it, and what one may hand in."""

from __future__ import annotations

import json
import zipfile
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

import yaml

from tflab.workbook.pages.editions import exercise_notebook, lecture_notebook, text_of
from tflab.workbook.pages.source import read_page
from tflab.workbook.paths import read_workbook
from tflab.workbook.tasks.case_types import TaskCases
from tflab.workbook.tasks.catalog import assigned_cases
from tflab.workbook.tasks.generate_cases import outline_of
from tflab.workbook.tasks.task import read_tasks

from ..workbook.making_pages import write_tasks

STEM = "03_tiny"

SOURCE, TASKS = yaml.safe_load(Path(__file__).with_suffix(".yaml").read_text(encoding="utf-8")).values()
RIGHT = {
    "e3-1-answer": "total = e3_1.a + e3_1.b",
    "e3-2-answer": "def length(x, y):\n    return math.hypot(x, y)",
    "e3-3-answer": 'frames = {"target": "map", "source": "laser_frame"}',
}


@dataclass(frozen=True)
class Course:
    """A tiny workbook, and a release of it to two learners: s101 (Korean) and s102."""

    workbook: Path
    release: Path

    @property
    def pack(self) -> Path:
        """The instructor's folder."""
        return self.release / "instructor"

    def exercise(self, learner: str = "s102") -> dict:
        """Return the exercise as a learner got it."""
        return exercise(self.copy_of(learner), "ko" if learner == "s101" else "en")

    def copy_of(self, learner: str) -> Path:
        """The folder that a learner got."""
        return self.release / "learners" / learner

    def assigned(self, learner: str, task_id: str) -> TaskCases:
        """Return a task as `check` compares a learner's answer with it."""
        return assigned_cases(self.workbook, STEM, task_id, read_workbook(self.copy_of(learner)))


def write_tiny_workbook(root: Path, page_source: str = SOURCE, tasks: str = TASKS) -> Path:
    """Write the chapter as `tflab build` would, without running it; return the root."""
    source = root / "solutions" / "src" / f"{STEM}.py"
    source.parent.mkdir(parents=True, exist_ok=True)
    source.write_text(page_source, encoding="utf-8")
    write_tasks(root / "solutions" / "tasks" / STEM, tasks)
    page = read_page(source)
    outlined = {task.id: outline_of(task) for task in read_tasks(root / "solutions" / "tasks" / STEM)}
    files = {}
    for language in ("en", "ko"):
        files[f"solutions/{language}/{STEM}.ipynb"] = text_of(lecture_notebook(page, language, {}))
        files[f"exercises/{language}/E{STEM}.ipynb"] = text_of(exercise_notebook(page, language, outlined))
    for name, text in files.items():
        (root / name).parent.mkdir(parents=True, exist_ok=True)
        (root / name).write_text(text, encoding="utf-8")
    (root / "notebooks" / "en").mkdir(parents=True, exist_ok=True)
    (root / "notebooks" / "ko").mkdir(parents=True, exist_ok=True)
    return root


def exercise(root: Path, language: str = "en") -> dict:
    """Return the exercise notebook below a folder, the workbook's or a learner's."""
    return json.loads((root / "exercises" / language / f"E{STEM}.ipynb").read_text(encoding="utf-8"))


def answered(notebook: dict, answers: Mapping[str, str] = RIGHT) -> dict:
    """Return a copy of a notebook with the sources of some of its cells replaced."""
    made = json.loads(json.dumps(notebook))
    for cell in made["cells"]:
        if cell["id"] in answers:
            cell["source"] = answers[cell["id"]]
    return made


def own_cell(source: str, identity: str = "mine", kind: str = "code") -> dict:
    """Return a cell that a learner added."""
    return {"cell_type": kind, "id": identity, "metadata": {}, "source": source, "outputs": [], "execution_count": 1}


def index_of(notebook: dict, identity: str) -> int:
    """Return where a cell is."""
    return next(number for number, cell in enumerate(notebook["cells"]) if cell["id"] == identity)


def files_below(folder: Path) -> dict[str, bytes]:
    """Return every file of a folder by its path; of a zip archive the files in it."""
    found = {}
    for path in sorted(path for path in folder.rglob("*") if path.is_file()):
        name = path.relative_to(folder).as_posix()
        if path.suffix == ".zip":
            with zipfile.ZipFile(path) as archive:
                found |= {f"{name}/{inner}": archive.read(inner) for inner in archive.namelist()}
        else:
            found[name] = path.read_bytes()
    return found


def change_record(copy: Path, name: str, content: bytes) -> None:
    """Write something else for a file in a copy's record of what was handed out."""
    path = copy / ".tflab" / "pristine.zip"
    with zipfile.ZipFile(path) as archive:
        files = {inner: archive.read(inner) for inner in archive.namelist()}
    assert name in files
    with zipfile.ZipFile(path, "w") as archive:
        for inner, held in (files | {name: content}).items():
            archive.writestr(inner, held)


def hand_in(folder: Path, learner: str, notebook: dict | bytes | str, name: str = f"{STEM}.ipynb") -> Path:
    """Write a notebook as a learner's submission."""
    path = folder / learner / name
    path.parent.mkdir(parents=True, exist_ok=True)
    data = json.dumps(notebook) if isinstance(notebook, dict) else notebook
    path.write_bytes(data if isinstance(data, bytes) else data.encode("utf-8"))
    return path
