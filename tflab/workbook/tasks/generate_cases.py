"""Compute the cases of a task: inputs, right answers, and what each known mistake gives.

    generators + a seed     -->  given, arguments
    the solution            -->  expected           Case(args, expected, {"swapped": ...})
    each mistake            -->  its wrong answer

Nothing is stored.  `check` computes the cases of a task when it is asked about it, with
the public seed or with the seed of a class.  Grading computes hidden cases with a secret
seed.  Inputs with which a mistake gives the right answer, or two mistakes give the same
answer, are drawn again.
"""

from __future__ import annotations

import hashlib
from collections.abc import Iterator, Sequence
from contextlib import suppress
from functools import partial
from typing import Any

from ..answers.equal_answers import EqualAnswers
from ..answers.values import Plain, from_plain, is_raised, outcome_of, to_plain
from .case_types import Case, Feedback, TaskCases, Variant, as_kept, rounded, values_of
from .draws import Draws
from .pairs import PairSearch
from .reference import Solution
from .task import Task, TaskError, WrongStep

__all__ = ["PUBLIC_SEED", "CasesError", "draws_for", "make_variant", "outline_of", "task_cases"]

PUBLIC_SEED = "public"
NO_MISTAKE = ""  # the name of the model itself among the mistakes
NO_SUCH_KEY = {"raises": "KeyError", "text": ""}  # what a model gives for an alternative that it does not have
MOST_DRAWS = 40  # until two mistakes give different answers; in E8.4 one draw in four fails


class CasesError(TaskError):
    """A task in whose cases a mistake gives the right answer, or the same as another mistake."""


class EqualAnswersError(CasesError):
    """With the values of this draw, two mistakes give the same answer."""


def outline_of(task: Task) -> TaskCases:
    """Return a task as `check` and grading know it, without any variant."""
    return TaskCases(
        kind=task.kind,
        points=task.points,
        answer=task.answer,
        is_function=task.inputs is not None,
        title=task.title,
        form=task.form,
        hints=task.hints,
        misconceptions=task.misconceptions,
        feedback={
            each.name: Feedback(each.reply, each.misconception, each.part, each.partly) for each in task.mistakes
        },
        variants=(),
        means=task.means,
        shows=task.shows,
        seen=task.seen,
        counts=task.counts,
        pairs=PairSearch(lambda: task),
    )


def task_cases(
    task: Task, seed: str | bytes, solution: Solution, variants: int | None = None, fewest_inputs: int = 1
) -> TaskCases:
    """Return a task with its variants, all of them or the first few; to be called inside `in_process_ros()`."""
    numbers = range(variants or task.variants)
    made = tuple(make_variant(task, seed, number, solution, fewest_inputs) for number in numbers)
    return outline_of(task)._replace(variants=made)


def make_variant(task: Task, seed: str | bytes, number: int, solution: Solution, fewest_inputs: int = 1) -> Variant:
    """Return one variant of a task; to be called inside `in_process_ros()`.

    Numbers with which two mistakes give the same answer are drawn again.

    Raises:
        TaskError: the solution does not answer the task.
        CasesError: no draw tells the mistakes apart.
    """
    for draw in range(MOST_DRAWS):
        rng = draws_for(seed, task.id, number, *([draw] if draw else []))
        with suppress(EqualAnswersError):
            return _drawn(task, rng, number, solution, fewest_inputs)
    return _drawn(task, draws_for(seed, task.id, number), number, solution, fewest_inputs)  # raises, and says why


def _drawn(task: Task, rng: Draws, number: int, solution: Solution, fewest_inputs: int) -> Variant:
    given = rounded(to_plain(task.given(rng))["dict"]) if task.given else None
    held = {name: from_plain(value) for name, value in given.items()} if given is not None else {}
    answer = solution.answer(task, held if given is not None else None)
    if task.inputs is None:
        cases = [Case(None, rounded(to_plain(answer)), {})]
    else:
        cases = [_function_case(task, answer, args) for args in _inputs(task, rng, fewest_inputs)]
    answers = _each_mistake(task)
    cases = [case._replace(wrong=values_of(answers, case, held)) for case in cases]
    _refuse_unknown_alternatives(task, cases)
    _refuse_look_alikes(task, number, cases)
    return Variant(given, tuple(case._replace(wrong=_without_model(case.wrong)) for case in cases))


def _each_mistake(task: Task) -> dict[str, Any]:
    """Return the answer, or the function that gives it, of each mistake and of the model without a mistake."""
    right = {NO_MISTAKE: task.model} if task.model else {}
    return right | {
        mistake.name: partial(task.model, **mistake.at) if isinstance(mistake, WrongStep) else mistake.answer
        for mistake in task.mistakes
    }


def _without_model(wrong: dict[str, Plain]) -> dict[str, Plain]:
    return {name: value for name, value in wrong.items() if name != NO_MISTAKE}


def _inputs(task: Task, rng: Draws, fewest: int) -> Iterator[list[Plain]]:
    count = 0
    while count < fewest:
        drawn = task.inputs(rng)
        if not drawn:
            raise CasesError(f"{task.id}: the generator gave no inputs")
        for args in drawn:
            count += 1
            yield [rounded(to_plain(arg)) for arg in args]


def _function_case(task: Task, function: Any, args: list[Plain]) -> Case:
    if not callable(function):
        raise TaskError(f"{task.id} has inputs, so {task.answer} should be a function, and it is {function!r}")
    return Case(args, as_kept(outcome_of(function, args)), {})


def _refuse_unknown_alternatives(task: Task, cases: Sequence[Case]) -> None:
    for step in task.mistakes:
        if isinstance(step, WrongStep) and any(case.wrong[step.name] == NO_SUCH_KEY != case.expected for case in cases):
            raise TaskError(f'{task.id}: "{step.name}" raises a KeyError: has the model the alternative {step.at}?')


def _refuse_look_alikes(task: Task, variant: int, cases: Sequence[Case]) -> None:
    for case in cases:
        if not is_raised(case.expected) and task.form.probes(case.expected) is None:
            raise CasesError(f"{task.id}: the solution's answer is not {task.form.wanted().en}: {case.expected!r}")
    if task.model and not all(task.form.alike(case.wrong[NO_MISTAKE], case.expected) for case in cases):
        raise CasesError(f"{task.id}, variant {variant}: the model without a mistake is not the solution")
    names = ["", *(mistake.name for mistake in task.mistakes)]  # "" is the right answer
    equal_answers = EqualAnswers(task.form, [[_of(case, name) for case in cases] for name in names])
    for number, name in enumerate(names):
        for other in range(number + 1, len(names)):
            if equal_answers.has_equal([number], other):
                said = f'the mistakes "{name}" and "{names[other]}" give the same answer'
                said = said if name else f'the mistake "{names[other]}" gives the right answer'
                raise EqualAnswersError(
                    f"{task.id}, variant {variant}: {said}; draw from inputs that tell them apart, or delete one"
                )


def _of(case: Case, name: str) -> Plain:
    return case.wrong[name] if name else case.expected


def draws_for(seed: str | bytes, *what: object) -> Draws:
    """Return the source of numbers of a task's variant: for a seed, the task's id and the variant's number."""
    text = seed if isinstance(seed, bytes) else seed.encode()
    digest = hashlib.sha256(b"\0".join([text, *(str(word).encode() for word in what)])).digest()
    return Draws(int.from_bytes(digest, "big"))
