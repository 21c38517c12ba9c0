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
import inspect
import json
import re
from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from functools import partial
from itertools import combinations as pairs_of
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np

from ..answers.alike import Likeness
from ..answers.values import Plain, from_plain, is_raised, outcome_of, outcomes_of, to_plain
from .case import AND, FORMAT, Case, ChapterCases, TaskCases, TwinWords, Variant
from .reference import Solution, in_process_ros, solution_in_notebook
from .task import Slip, Task, TaskError, read_tasks

__all__ = [
    "PUBLIC_SEED",
    "CasesError",
    "cases_json",
    "combinations",
    "make_cases",
    "read_cases",
    "read_chapter",
    "read_outline",
    "task_cases",
]

PUBLIC_SEED = "public"
MODEL = ""  # the model itself, among what it gives with slips
MOST_DRAWS = 40  # in which two mistakes meet; where one draw in four does (E8.4), no seed may be refused for it
DIGITS = 12  # of a float in a case; the last ones differ between machines
VARIANTS, THEIR_END = '\n   "variants": [', "\n   ]"  # of a task, as `cases_json` writes them


class CasesError(TaskError):
    """A task whose cases do not tell a mistake from the answer, or from another mistake."""


class LookAlikes(CasesError):
    """What was drawn does not tell two mistakes apart."""


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
        twins={twin.name: TwinWords(twin.reply, twin.misconception, twin.part, twin.partly) for twin in task.twins},
        variants=tuple(_variant(task, seed, number, solution, fewest_inputs) for number in range(count)),
        means=task.means,
        shows=task.shows,
        seen=task.seen,
        counts=task.counts,
    )


def cases_json(cases: ChapterCases | dict[str, Any]) -> str:
    """Return cases as text, the same for the same cases; each case is one line."""
    plain = cases.plain() if isinstance(cases, ChapterCases) else cases
    lines: list[str] = []

    def marked(case: dict[str, Plain]) -> str:
        lines.append(_in_a_line(case))
        return f"@case {len(lines) - 1}@"

    tasks = {
        name: task
        | {
            "variants": [
                variant | {"cases": [marked(case) for case in variant["cases"]]} for variant in task["variants"]
            ]
        }
        for name, task in plain["tasks"].items()
    }
    text = json.dumps(plain | {"tasks": tasks}, ensure_ascii=False, indent=1, sort_keys=True, allow_nan=False) + "\n"
    return re.sub(r'"@case (\d+)@"', lambda mark: lines[int(mark[1])], text)


def _in_a_line(case: dict[str, Plain]) -> str:
    """Return a case as text: keys sorted, but for those of its arguments, whose order may be part of the question."""
    write = partial(json.dumps, ensure_ascii=False, allow_nan=False, separators=(",", ":"))
    return "{" + ",".join(f'"{key}":{write(case[key], sort_keys=key != "args")}' for key in sorted(case)) + "}"


def read_cases(path: Path) -> dict[str, Any]:
    """Return the cases in a file, as JSON has them.

    Raises:
        CasesError: the file is not there, not JSON, or of another format.
    """
    return _read(path, lambda text: text)


def read_chapter(path: Path) -> ChapterCases:
    """Return the cases in a file.

    Raises:
        CasesError: the file is not there, damaged, or of another format.
    """
    return _chapter(path, read_cases(path))


def read_outline(path: Path) -> ChapterCases:
    """Return the tasks in a file without their variants, which are nearly all of it, in a fraction of the time.

    Raises:
        CasesError: the file is not there, damaged, or of another format.
    """
    return _chapter(path, _read(path, _without_variants))


def _without_variants(text: str) -> str:
    kept, at = [], 0
    while (begin := text.find(VARIANTS, at)) >= 0 and (end := text.find(THEIR_END, begin)) >= 0:
        kept.append(text[at : begin + len(VARIANTS)])
        at = end
    return "".join([*kept, text[at:]])


def _read(path: Path, prepared: Callable[[str], str]) -> dict[str, Any]:
    try:
        cases = json.loads(prepared(path.read_text(encoding="utf-8")))
    except OSError:
        raise CasesError(f"there are no cases at {path}") from None
    except ValueError as error:
        raise CasesError(f"{path} is damaged: {error}") from None
    if not isinstance(cases, dict) or cases.get("format") != FORMAT:
        raise CasesError(f"{path} was made by another version of tflab")
    return cases


def _chapter(path: Path, plain: dict[str, Any]) -> ChapterCases:
    try:
        return ChapterCases.from_plain(plain)
    except (KeyError, TypeError, ValueError, AttributeError) as error:
        raise CasesError(f"{path} is damaged: {type(error).__name__}: {error}") from None


def _variant(task: Task, seed: str | bytes, number: int, solution: Solution, fewest_inputs: int) -> Variant:
    """Return a variant; where numbers were drawn with which two mistakes meet, others are drawn."""
    for draw in range(MOST_DRAWS):
        rng = _rng(seed, task.id, number, *([draw] if draw else []))
        with suppress(LookAlikes):
            return _drawn(task, rng, number, solution, fewest_inputs)
    return _drawn(task, _rng(seed, task.id, number), number, solution, fewest_inputs)  # say what cannot be told apart


def _drawn(task: Task, rng: np.random.Generator, number: int, solution: Solution, fewest_inputs: int) -> Variant:
    given = _rounded(to_plain(task.given(rng))["dict"]) if task.given else None
    held = {name: from_plain(value) for name, value in given.items()} if given is not None else {}
    answer = solution.answer(task, held if given is not None else None)
    if task.inputs is None:
        cases = [Case(None, _rounded(to_plain(answer)), {})]
    else:
        cases = [_function_case(task, answer, args) for args in _inputs(task, rng, fewest_inputs)]
    cases = _with_twins(cases, held, _each_mistake(task))
    _refuse_look_alikes(task, number, cases)  # before the pairs, which are many
    return Variant(given, _distinct(task, _with_twins(cases, held, _each_pair(task))))


def combinations(task: Task) -> list[tuple[Slip, Slip]]:
    """Return the pairs of slips that can be made together: at different steps, the earlier step first."""
    steps = list(inspect.signature(task.model).parameters) if task.model else []
    slips = [twin for twin in task.twins if isinstance(twin, Slip)]
    slips.sort(key=lambda slip: min(map(steps.index, slip.at)))
    return [(first, then) for first, then in pairs_of(slips, 2) if not set(first.at) & set(then.at)]


def _each_mistake(task: Task) -> dict[str, Any]:
    """Return what answers as each mistake does, and as the model does without one."""
    right = {MODEL: task.model} if task.model else {}
    return right | {
        twin.name: partial(task.model, **twin.at) if isinstance(twin, Slip) else twin.answer for twin in task.twins
    }


def _each_pair(task: Task) -> dict[str, Any]:
    """Return what answers as each two mistakes do that can be made together."""
    model: Any = task.model  # which has steps, where there are pairs
    return {first.name + AND + then.name: partial(model, **first.at, **then.at) for first, then in combinations(task)}


def _with_twins(cases: Sequence[Case], held: dict[str, Any], answers: dict[str, Any]) -> list[Case]:
    """Return the cases with what these answers give, beside what they had."""
    return [case._replace(twins=case.twins | _given_by(answers, case, held)) for case in cases]


def _given_by(answers: dict[str, Any], case: Case, held: dict[str, Any]) -> dict[str, Plain]:
    if case.args is None:
        return {name: _value(answer, held) for name, answer in answers.items()}
    outcomes = outcomes_of(answers.values(), case.args)
    return {name: _as_kept(outcome) for name, outcome in zip(answers, outcomes, strict=True)}


def _value(give: Any, held: dict[str, Any]) -> Plain:
    return _rounded(to_plain(give(SimpleNamespace(**held)) if callable(give) else give))


def _distinct(task: Task, cases: Sequence[Case]) -> tuple[Case, ...]:
    """Return the cases without the combinations that look like something simpler, or like an earlier one."""
    names = ["", *(twin.name for twin in task.twins), *(key for key in cases[0].twins if AND in key)]
    likeness = Likeness(task.form, [[_of(case, name) for case in cases] for name in names])
    kept = list(range(1 + len(task.twins)))
    for number in range(len(kept), len(names)):
        if not likeness.any_of(kept, number):
            kept.append(number)
    distinct = {names[number] for number in kept[1:]}
    return tuple(case._replace(twins={key: case.twins[key] for key in case.twins if key in distinct}) for case in cases)


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
    return Case(args, _as_kept(outcome_of(function, args)), {})


def _as_kept(outcome: Plain) -> Plain:
    """Return an outcome rounded; of what was raised only the class."""
    return outcome | {"text": ""} if is_raised(outcome) else _rounded(outcome)


def _refuse_look_alikes(task: Task, variant: int, cases: Sequence[Case]) -> None:
    for case in cases:
        if not is_raised(case.expected) and task.form.probes(case.expected) is None:
            raise CasesError(f"{task.id}: the solution's answer is not {task.form.wanted().en}: {case.expected!r}")
    if task.model and not all(task.form.alike(case.twins[MODEL], case.expected) for case in cases):
        raise CasesError(f"{task.id}, variant {variant}: the model without a slip is not the solution")
    names = ["", *(twin.name for twin in task.twins)]  # "" is the right answer
    likeness = Likeness(task.form, [[_of(case, name) for case in cases] for name in names])
    for number, name in enumerate(names):
        for other in range(number + 1, len(names)):
            if likeness.any_of([number], other):
                said = f'the twins "{name}" and "{names[other]}" coincide'
                said = said if name else f'the twin "{names[other]}" is the right answer'
                raise LookAlikes(f"{task.id}, variant {variant}: {said}; draw from inputs that tell them apart")


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
