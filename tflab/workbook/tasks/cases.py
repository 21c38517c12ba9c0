"""On what is an answer tried?  Cases: what is given, what is expected, and what each mistake would give.

    generators + a seed     -->  given, arguments
    the solution            -->  expected           Case(args, expected, {"swapped": ...})
    each twin               -->  its wrong answer

One function makes them all: with the public seed the cases that ship with the
exercises, with a secret one those that grading uses.  A case in which a mistake
gives the right answer, or in which two mistakes look alike, is no case: it is an
error here, before any learner sees it.  A test-data generator with an oracle and
its mutants, the field would say.  Read `evidence.py` next.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Iterator, Sequence
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np

from ..answers.values import Plain, from_plain, is_raised, outcome_of, to_plain
from .case import FORMAT, Case, ChapterCases, TaskCases, TwinWords, Variant
from .reference import Solution, in_process_ros, solution_in_notebook
from .task import Task, TaskError, Twin, read_tasks

__all__ = ["PUBLIC_SEED", "CasesError", "cases_json", "make_cases", "read_cases", "read_chapter", "task_cases"]

PUBLIC_SEED = "public"
DIGITS = 12  # of a float in a case; the last ones differ between machines


class CasesError(TaskError):
    """A task whose cases do not tell a mistake from the answer, or from another mistake."""


def make_cases(
    stem: str,
    seed: str | bytes,
    *,
    solutions: Path,
    solution: Solution | None = None,
    variants: int | None = None,
    fewest_inputs: int = 1,
) -> ChapterCases:
    """Return the cases of a chapter for a seed.

    Args:
        solutions: the folder that holds `tasks/` and, built, `en/`.
        solution: what answers; the built notebook's cells if None.
        variants: how many of each task; as many as the task says if None.
        fewest_inputs: how many argument lists a function gets at least; the generator is asked again until there are.

    Raises:
        TaskError: the task file is no good, or the solution does not answer a task.
        CasesError: a twin coincides with the answer, or with another twin.
    """
    tasks = read_tasks(solutions / "tasks" / stem)
    solution = solution or solution_in_notebook(solutions / "en" / f"{stem}.ipynb")
    with in_process_ros():
        made = {task.id: task_cases(task, seed, solution, variants, fewest_inputs) for task in tasks}
    return ChapterCases(stem, made)


def task_cases(
    task: Task, seed: str | bytes, solution: Solution, variants: int | None = None, fewest_inputs: int = 1
) -> TaskCases:
    """Return one task's cases, its words beside them; to be called inside `in_process_ros()`."""
    count = variants or task.variants
    return TaskCases(
        kind=task.kind,
        points=task.points,
        answer=task.answer,
        is_function=task.inputs is not None,
        title=task.title,
        form=task.form,
        hints=task.hints,
        cures=task.cures,
        twins={twin.name: TwinWords(twin.reply, twin.misconception) for twin in task.twins},
        variants=tuple(_variant(task, seed, number, solution, fewest_inputs) for number in range(count)),
    )


def cases_json(cases: ChapterCases | dict[str, Any]) -> str:
    """Return cases as text, the same for the same cases."""
    plain = cases.plain() if isinstance(cases, ChapterCases) else cases
    return json.dumps(plain, ensure_ascii=False, indent=1, sort_keys=True, allow_nan=False) + "\n"


def read_cases(path: Path) -> dict[str, Any]:
    """Return the cases in a file, as JSON has them.

    Raises:
        CasesError: the file is not there, not JSON, or of another format.
    """
    try:
        cases = json.loads(path.read_text(encoding="utf-8"))
    except OSError:
        raise CasesError(f"there are no cases at {path}") from None
    except ValueError as error:
        raise CasesError(f"{path} is damaged: {error}") from None
    if not isinstance(cases, dict) or cases.get("format") != FORMAT:
        raise CasesError(f"{path} was made by another version of tflab")
    return cases


def read_chapter(path: Path) -> ChapterCases:
    """Return the cases in a file.

    Raises:
        CasesError: the file is not there, damaged, or of another format.
    """
    plain = read_cases(path)
    try:
        return ChapterCases.from_plain(plain)
    except (KeyError, TypeError, ValueError, AttributeError) as error:
        raise CasesError(f"{path} is damaged: {type(error).__name__}: {error}") from None


def _variant(task: Task, seed: str | bytes, number: int, solution: Solution, fewest_inputs: int) -> Variant:
    rng = _rng(seed, task.id, number)
    given = _rounded(to_plain(task.given(rng))["dict"]) if task.given else None
    held = {name: from_plain(value) for name, value in given.items()} if given is not None else {}
    answer = solution.answer(task, held if given is not None else None)
    if task.inputs is None:
        wrong = {twin.name: _rounded(to_plain(_twin_value(twin, held))) for twin in task.twins}
        cases = (Case(None, _rounded(to_plain(answer)), wrong),)
    else:
        cases = tuple(_function_case(task, answer, args) for args in _inputs(task, rng, fewest_inputs))
    _refuse_look_alikes(task, number, cases)
    return Variant(given, cases)


def _inputs(task: Task, rng: np.random.Generator, fewest: int) -> Iterator[list[Plain]]:
    count = 0
    while count < fewest:
        drawn = task.inputs(rng)
        if not drawn:
            raise CasesError(f"{task.id}: the generator gave no inputs")
        for args in drawn:
            count += 1
            yield [_rounded(to_plain(arg)) for arg in args]


def _function_case(task: Task, function: Any, args: list[Plain]) -> Case:
    if not callable(function):
        raise TaskError(f"{task.id} has inputs, so {task.answer} should be a function, and it is {function!r}")
    twins = {twin.name: _outcome(twin.answer, args) for twin in task.twins}
    return Case(args, _outcome(function, args), twins)


def _outcome(function: Any, args: list[Plain]) -> Plain:
    """Return what a function gives, rounded; of what it raises only the class."""
    outcome = outcome_of(function, args)
    return outcome | {"text": ""} if is_raised(outcome) else _rounded(outcome)


def _twin_value(twin: Twin, given: dict[str, Any]) -> Any:
    return twin.answer(SimpleNamespace(**given)) if callable(twin.answer) else twin.answer


def _refuse_look_alikes(task: Task, variant: int, cases: Sequence[Case]) -> None:
    for case in cases:
        if not is_raised(case.expected) and task.form.probes(case.expected) is None:
            raise CasesError(f"{task.id}: the solution's answer is not {task.form.wanted().en}: {case.expected!r}")
    names = ["", *(twin.name for twin in task.twins)]  # "" is the right answer
    for number, name in enumerate(names):
        for other in names[number + 1 :]:
            if all(task.form.alike(_of(case, name), _of(case, other)) for case in cases):
                both = (
                    f'the twins "{name}" and "{other}" coincide' if name else f'the twin "{other}" is the right answer'
                )
                raise CasesError(f"{task.id}, variant {variant}: {both}; draw from inputs that tell them apart")


def _of(case: Case, name: str) -> Plain:
    return case.twins[name] if name else case.expected


def _rng(seed: str | bytes, *what: object) -> np.random.Generator:
    text = seed if isinstance(seed, bytes) else seed.encode()
    digest = hashlib.sha256(b"\0".join([text, *(str(word).encode() for word in what)])).digest()
    return np.random.default_rng(int.from_bytes(digest, "big"))


def _rounded(plain: Plain) -> Plain:
    """Return JSON with its floats rounded, and no negative zero."""
    if isinstance(plain, float):
        return round(plain, DIGITS) + 0.0
    if isinstance(plain, list):
        return [_rounded(member) for member in plain]
    if isinstance(plain, dict):
        return {key: _rounded(value) for key, value in plain.items()}
    return plain
