"""Describe a task: what it asks, how its answer is judged, and the known mistakes.

    Task(id="E3.2", kind="N", points=3, answer="base_p_corner", form=Vector(3, frame="base_link"), ...)

The right answer is what the solution's own answer cell gives, so it is not stored here.
A WrongAnswer is the answer that one mistake gives.  A WrongStep is an alternative at one
step of the work; two at different steps combine.  What varies comes from `given` (values
that the learner is shown) and `inputs` (arguments for a function).  Both are drawn with a
seed: a public one for the variants, a secret one for hidden cases.

A chapter is a folder in `solutions/tasks/`.  `e3_2.py` and `e3_2.yaml` define one TASK
(`definition.py`); `draws.py` holds what several tasks draw.
"""

from __future__ import annotations

import hashlib
import importlib
import re
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from types import ModuleType
from typing import Any

from ...text import Text
from ..answers.forms import Form, Parts
from .draws import Draws

__all__ = [
    "KINDS",
    "PARTICIPATION",
    "Task",
    "TaskError",
    "WrongAnswer",
    "WrongStep",
    "chapter_of",
    "read_task",
    "read_tasks",
    "slug",
    "task_file",
    "variant_of",
]

KINDS = {
    "N": "a number",
    "F": "a function",
    "T": "a tree",
    "D": "a diagnosis",
    "O": "an owner table",
    "M": "a choice",
    "C": "a command or a message",
}
PARTICIPATION = "taking part"  # what counts where no answer is right or wrong
TASK_ID = re.compile(r"E(\d{1,2})\.(\d{1,2})")


class TaskError(Exception):
    """A task is defined wrongly; the text names the task and the fault."""


@dataclass(frozen=True)
class WrongAnswer:
    """The answer that one mistake gives; it is not combined with others.

    Attributes:
        name: in a word or two, "swapped".
        answer: a function of what was given (values) or of the arguments (functions), or the value itself.
        reply: the feedback; never the right answer.
        misconception: "M1" ... "M15", if it is one of the course's.
        part, partly: as of a WrongStep.
    """

    name: str
    answer: Callable[..., Any] | Any
    reply: Text
    misconception: str = ""
    part: str = ""
    partly: bool = False


@dataclass(frozen=True)
class WrongStep:
    """A wrong alternative at one step of the work; two of them at different steps combine.

    Attributes:
        name: in a word or two, "jitter forgotten".
        at: the steps and their alternatives: keyword arguments of the task's `model`, {"jitter": 0.0}.
        reply: the feedback; never the right answer, and nothing about other steps.
        misconception: "M1" ... "M15", if it is one of the course's.
        part: of an answer in parts, the one in which it is made; errors that follow from it cost nothing.
        partly: whether it can be made in some parts only, and the reply is true of each.
    """

    name: str
    at: dict[str, Any]
    reply: Text
    misconception: str = ""
    part: str = ""
    partly: bool = False


@dataclass(frozen=True)
class Task:
    """One exercise.

    Attributes:
        id: "E3.2": chapter 3, second task.
        kind: a letter of KINDS.
        points: what it is worth.
        title: of the task.
        answer: the name that the answer cell defines.
        form: of the value, or of the function's result.
        hints: three, coarse to fine; none for a task of participation.
        given: draws what the learner is shown: rng -> {name: value}; None if nothing varies.
        inputs: draws arguments: rng -> list of tuples; if set, the answer is a function.
        variants: the number of public variants.
        mistakes: the known ones; the first that fits explains an answer.
        model: computes the answer by steps, keyword arguments in the order of the work; the defaults are right.
        means, shows: of choices, feedback on an option, and a hint for a part.
        seen: a hint for a part by its right option, where parts differ between learners.
        equivalent: mutants of the solution that are right, and why (tests/workbook/mutants.py).
        misconceptions: codes of those that it looks for.
        is_costly: whether a case takes seconds to compute, so that tests draw few.
        counts: PARTICIPATION if points are for answering all parts, whatever the answers; else "".
    """

    id: str
    kind: str
    points: int
    title: Text
    answer: str
    form: Form
    hints: tuple[Text, ...]
    given: Callable[[Draws], dict[str, Any]] | None = None
    inputs: Callable[[Draws], list[tuple]] | None = None
    variants: int = 1
    mistakes: tuple[WrongAnswer | WrongStep, ...] = ()
    model: Callable[..., Any] | None = None
    means: dict[str, Text] = field(default_factory=dict)
    shows: dict[str, Text] = field(default_factory=dict)
    seen: dict[str, Text] = field(default_factory=dict)
    equivalent: dict[str, str] = field(default_factory=dict)
    misconceptions: tuple[str, ...] = ()
    is_costly: bool = False
    counts: str = ""

    def __post_init__(self) -> None:
        if not TASK_ID.fullmatch(self.id):
            raise TaskError(f'"{self.id}" is no task id; it should look like "E3.2"')
        if self.kind not in KINDS:
            raise TaskError(f'{self.id}: there is no kind "{self.kind}"; there is {", ".join(KINDS)}')
        if self.counts:
            self._refuse_help()
        elif len(self.hints) != 3:
            raise TaskError(f"{self.id}: three hints, coarse to fine, not {len(self.hints)}")
        if self.points < 1 or self.variants < 1 or not self.answer.isidentifier():
            raise TaskError(f"{self.id}: points and variants count from 1, and `answer` is a name")

    def _refuse_help(self) -> None:
        """Raise TaskError if a task of participation has hints, mistakes or no parts."""
        if self.counts != PARTICIPATION:
            raise TaskError(f'{self.id}: what counts is being right, "", or "{PARTICIPATION}", not "{self.counts}"')
        if self.hints or self.mistakes or not isinstance(self.form, Parts):
            raise TaskError(f"{self.id}: where taking part counts, the answer is Parts, without hints or mistakes")


def chapter_of(task_id: str) -> int:
    """Return the chapter's number: 3 of "E3.2".

    Raises:
        TaskError: not a task id.
    """
    match = TASK_ID.fullmatch(task_id) if isinstance(task_id, str) else None
    if match is None:
        raise TaskError(f'{task_id!r} is no task id; it should look like "E3.2"')
    return int(match[1])


def slug(task_id: str) -> str:
    """Return a task's id as cells are named after it: "e3-2" for "E3.2"."""
    return task_id.lower().replace(".", "-")


def variant_of(learner_id: str | None, task_id: str, count: int) -> int:
    """Return which of `count` variants is a learner's, spread evenly by their id; 0 without one."""
    if not learner_id or count < 2:
        return 0
    digest = hashlib.sha256(f"{learner_id}\0{task_id}".encode()).digest()
    return int.from_bytes(digest[:8], "big") % count


def task_file(folder: Path, task_id: str) -> Path:
    """Return the file of a task in its chapter's folder: `e3_2.py` of "E3.2"."""
    return folder / f"{task_id.lower().replace('.', '_')}.py"


def read_tasks(folder: Path) -> tuple[Task, ...]:
    """Return the tasks in a chapter's folder, in order.

    Raises:
        TaskError: there are none, one cannot be read, or its id is not the one that its file is named after.
    """
    paths = sorted(folder.glob("e*_*.py"), key=lambda path: [int(part) for part in re.findall(r"\d+", path.stem)])
    if not paths:
        raise TaskError(f"there are no tasks in {folder}, such as e{folder.name[:2].lstrip('0') or 0}_1.py")
    with _as_package(folder) as package:
        tasks = tuple(_read_task(path, package) for path in paths)
    foreign = [task.id for task in tasks if chapter_of(task.id) != int(folder.name[:2])]
    if foreign:
        raise TaskError(f"{folder.name}: {', '.join(foreign)} belongs to another chapter")
    return tasks


def read_task(folder: Path, task_id: str) -> Task:
    """Return one task of a chapter's folder; the other files are not run.

    Raises:
        TaskError: it is not there, or cannot be read.
    """
    path = task_file(folder, task_id)
    if not path.is_file():
        raise TaskError(f"there is no {path.name} in {folder}")
    with _as_package(folder) as package:
        return _read_task(path, package)


@contextmanager
def _as_package(folder: Path) -> Iterator[str]:
    """Let the files of a folder import each other (`from .draws import ...`), as they are now; yield its name."""
    name = f"tflab_tasks_{folder.name}"
    package = ModuleType(name)
    package.__path__ = [str(folder)]
    wrote_bytecode, sys.dont_write_bytecode = sys.dont_write_bytecode, True  # it may be of the text a moment ago
    sys.modules[name] = package
    importlib.invalidate_caches()
    try:
        yield name
    finally:
        sys.dont_write_bytecode = wrote_bytecode
        for held in [held for held in sys.modules if held == name or held.startswith(f"{name}.")]:
            del sys.modules[held]


def _read_task(path: Path, package: str) -> Task:
    try:
        task = getattr(importlib.import_module(f"{package}.{path.stem}"), "TASK", None)
    except TaskError:
        raise
    except Exception as error:
        raise TaskError(f"{path.name} cannot be run: {type(error).__name__}: {error}") from error
    if not isinstance(task, Task):
        raise TaskError(f"{path.name} should hold TASK, a Task")
    if task_file(path.parent, task.id) != path:
        raise TaskError(f"{path.name} holds {task.id}; it should be called {task_file(path.parent, task.id).name}")
    return task
