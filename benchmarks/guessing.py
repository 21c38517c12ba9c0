"""What does an answer earn that understands nothing?  A table by task: constants, echoes, replays, majorities.

    python benchmarks/guessing.py [--pack DIR/instructor] [--chapters 03,12] [--learners 60] [--seeds 3]

Each strategy is judged as a submission is, on what each of so many learners would be asked; none of
them looks at what it is asked beyond handing it back.  The table has the best strategy's mean share
of the points.  A function's is to be at most 5 %; a choice's is its chance.  Without a pack so many
are made, each from a seed of its own.  Chapters are looked at side by side, one for each processor.
"""

from __future__ import annotations

import argparse
import json
import math
import random
import secrets
import sys
from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import replace
from functools import partial
from itertools import product
from pathlib import Path
from statistics import mean
from typing import Any, NamedTuple

from tflab.grading.judging.cells import Master
from tflab.grading.judging.draw import asks_of
from tflab.grading.judging.pack import Pack, questions_asked, read_pack
from tflab.grading.judging.task_score import by_case, score_task
from tflab.grading.submissions.roster import Learner
from tflab.workbook.answers.forms import Choice, Form, Parts, form_from_plain
from tflab.workbook.answers.values import Plain, is_raised
from tflab.workbook.paths import Workbook, chapters, workbook_data
from tflab.workbook.tasks.case_types import TaskCases
from tflab.workbook.tasks.catalog import assigned_cases
from tflab.workbook.tasks.credit import asked_alike, credited, guessed_of, negated, probes_of, share_beyond

MOST = 0.05  # of a function's points
TIMES = 40  # that an answer is drawn by chance
DICE_BY_INPUT = 8  # dice that show the same for the same input: no second run tells them from a function that knows
MOST_CONSTANTS = 100  # of choices that are combined in every way
DICE = random.Random(0)
NOTHING: tuple[Plain, ...] = (0.0, "", [], {"dict": {}}, [0.0, 0.0, 0.0], [0.0, 0.0, 0.0, 1.0], True, None)
IDENTITY = {"Transform": [[0.0, 0.0, 0.0], [0.0, 0.0, 0.0, 1.0]]}
RAISED = ("ValueError", "LookupException", "ExtrapolationException", "ConnectivityException",
          "InvalidArgumentException", "TimeoutException")  # fmt: skip

Outcomes = dict[int, Plain]
Text = Mapping[tuple[str, ...], Sequence[Plain]]  # by the options that they are among


class Row(NamedTuple):
    """What the best strategy earns in one task: the mean share of its points, and what an option gives by chance."""

    task: str
    is_function: bool
    points: float
    share: float
    strategy: str
    chance: float


def main(words: Sequence[str] | None = None) -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--pack", type=Path, metavar="DIR")
    parser.add_argument("--chapters", default="", metavar="03,12")
    parser.add_argument("--learners", type=int, default=60)
    parser.add_argument("--seeds", type=int, default=1)
    options = parser.parse_args(words)
    numbers = options.chapters.split(",") if options.chapters else None
    stems = [stem for stem in chapters() if numbers is None or stem[:2] in numbers]
    pack = read_pack(options.pack) if options.pack else None
    stems = [stem for stem in stems if pack is None or stem in pack.chapters]
    print("| task | | points | best without understanding | by chance |\n|---|---|---|---|---|")
    rows = []
    with ProcessPoolExecutor() as processes:
        look = partial(of_chapter, pack=pack, learners=options.learners, seeds=options.seeds)
        for found in processes.map(look, stems):
            for row in found:
                what = "function" if row.is_function else "value"
                best = f"{row.share:.1%} {row.strategy}"
                print(f"| {row.task} | {what} | {row.points:g} | {best} | {row.chance:.1%} |", flush=True)
            rows += found
    above = [row.task for row in rows if is_above(row)]
    print(f"above: {', '.join(above) or 'none'}")
    return 1 if above else 0


def of_chapter(stem: str, *, pack: Pack | None, learners: int, seeds: int = 1) -> list[Row]:
    """Return what the best strategy earns in each task of a chapter."""
    packs = [pack] if pack else [pack_of([stem]) for _ in range(seeds)]
    names = [f"s{number}" for number in range(learners)]
    packs = [replace(one, roster={name: Learner(name) for name in names}) for one in packs]
    asked = [one.for_learner(name)[stem]["tasks"] for one in packs for name in names]
    rows = []
    for task_id, task in asked[0].items():
        who = [tasks[task_id] for tasks in asked]
        shown = shown_in(assigned_cases(workbook_data(), stem, task_id, Workbook()))
        rows.append(of_task(task_id, who if task["is_function"] else once_each(who), shown))
    return rows


def once_each(who: Sequence[Mapping[str, Any]]) -> list[Mapping[str, Any]]:
    """Return each variant of a task once."""
    return list({json.dumps([task["given"], task["cases"]]): task for task in who}.values())


def is_above(row: Row) -> bool:
    """Return whether a function gives more than it may for nothing; of a value, options are its chance."""
    return row.is_function and row.share > MOST


def pack_of(stems: Sequence[str]) -> Pack:
    """Return a pack of these chapters, as a release would make it, without notebooks."""
    seed = secrets.token_hex(32)
    masters = {stem: Master(stem, ()) for stem in stems}
    return Pack("guessing", seed, questions=questions_asked(stems, seed), masters=masters)


def of_task(task_id: str, asked: Sequence[Mapping[str, Any]], shown: Sequence[Plain]) -> Row:
    """Return what the best strategy earns in a task, on the mean of all who are asked, or of its variants."""
    first = asked[0]
    form, is_function, points = form_from_plain(first["form"]), first["is_function"], float(first["points"])
    earned: list[dict[str, list[float]]] = []
    rights = [] if is_function else [task["cases"][0]["expected"] for task in asked]
    words = {} if is_function else frequent_words(form, rights)
    for number, task in enumerate(asked):
        often = None if is_function else usual_answer(form, rights, number)
        share = shares_of(task) if is_function else partial(share_of, task_id, task, form)
        earned.append({})
        for name, outcomes in by_function(task, shown) if is_function else by_value(task, form, words, often):
            earned[-1].setdefault(name, []).append(share(outcomes))
    shares = {name: mean(mean(row[name]) for row in earned) for name in set.intersection(*map(set, earned))}
    best = max(shares, key=lambda name: shares[name])
    by_chance = 0.0 if is_function else mean(chance(form, right) for right in rights)
    return Row(task_id, is_function, points, shares[best], best, by_chance)


def share_of(task_id: str, task: Mapping[str, Any], form: Form, outcomes: Outcomes) -> float:
    """Return which share of its points a task gives for outcomes; where nothing fits, nothing, at once."""
    asks = asks_of(task)
    fits = any(any(form.judge(outcomes[place], task["cases"][case]["expected"])) for place, case in enumerate(asks))
    return score_task(task_id, task, outcomes).points / float(task["points"]) if fits else 0.0


def shares_of(task: Mapping[str, Any]) -> Callable[[Outcomes], float]:
    """Return the function that gives a task's share of points for outcomes, as `score_task` does, without reasons."""
    held = TaskCases.of_a_learner(dict(task))
    form, cases, asks = held.form, held.variants[0].cases, asks_of(task)
    of, guessed = probes_of(form, cases), guessed_of(form, cases, task.get("known") or [False] * len(cases))

    def share(outcomes: Outcomes) -> float:
        got, _ = by_case(held, asks, outcomes)
        rights = [form.judge(outcome, case.expected) for outcome, case in zip(got, cases, strict=True)]
        if not any(map(any, rights)):
            return 0.0
        return share_beyond(sum(map(sum, credited(form, cases, got, rights))), of, guessed)

    return share


def shown_in(task: TaskCases) -> list[Plain]:
    """Return the results that a learner was shown, in their order."""
    return [case.expected for case in task.variants[0].cases]


def by_function(task: Mapping[str, Any], shown: Sequence[Plain]) -> Iterator[tuple[str, Outcomes]]:
    """Yield what a function gives that does not look at what it is asked, by the name of the strategy."""
    asks = asks_of(task)
    args = [task["cases"][case]["args"] for case in asks]
    frequent = [shown[number] for number in most_frequent(shown)]
    for number, constant in enumerate([*NOTHING, IDENTITY, *frequent]):
        yield f"always constant {number}", dict.fromkeys(range(len(asks)), constant)
    for error in RAISED:
        yield f"raises {error}", {place: {"raises": error, "text": ""} for place in range(len(asks))}
    for place in range(min(map(len, args))):
        yield f"hands back argument {place}", {number: row[place] for number, row in enumerate(args)}
        yield f"minus argument {place}", {number: negated(row[place]) for number, row in enumerate(args)}
        turned = {number: row[place] if number % 3 else negated(row[place]) for number, row in enumerate(args)}
        yield f"minus argument {place} now and then", turned
        for constant in (0.0, *frequent[:2]):
            mixed = {number: row[place] if number % 2 else constant for number, row in enumerate(args)}
            yield f"hands back argument {place}, or {kind(constant)}, in turn", mixed
    if shown:
        yield "replays what was shown", {number: shown[number % len(shown)] for number in range(len(asks))}
    for number in range(DICE_BY_INPUT if len(frequent) < len(shown) else 0):
        dice = [random.Random(f"{number} {row}") for row in args]
        yield "dice by the input, of all results shown", {n: one.choice(frequent) for n, one in enumerate(dice)}
        yield "dice by the input, by how frequent they are", {n: one.choice(shown) for n, one in enumerate(dice)}
    for one, other in product(frequent[:4], repeat=2):
        if one is not other:
            yield f"{kind(one)} and {kind(other)} in turn", {n: other if n % 2 else one for n in range(len(asks))}
            yield f"{kind(one)}, but once {kind(other)}", {n: other if n == 1 else one for n in range(len(asks))}


def by_value(task: Mapping[str, Any], form: Form, words: Text, often: Plain = None) -> Iterator[tuple[str, Outcomes]]:
    """Yield answers to a value task that were not worked out: nothing, what was given, one option everywhere."""
    if often is not None:
        yield "in each part what is most often right", {0: often}
    for number, constant in enumerate([*NOTHING, IDENTITY]):
        yield f"constant {number}", {0: constant}
    for name, held in (task["given"] or {}).items():
        yield f"given {name}", {0: held}
        if isinstance(form, Parts):
            yield f"given {name} everywhere", {0: {"dict": dict.fromkeys(form.parts, held)}}
    if isinstance(form, Parts):
        for number, constant in enumerate([*NOTHING, IDENTITY]):
            yield f"constant {number} everywhere", {0: {"dict": dict.fromkeys(form.parts, constant)}}
        for _ in range(TIMES):
            yield "options at random", {0: {"dict": at_random(form.parts)}}
            yield "options at random, by how frequent they are", {0: {"dict": at_random(form.parts, words)}}
        longest = max((len(part.options) for part in form.parts.values() if isinstance(part, Choice)), default=0)
        for number in range(longest):
            row = {name: option(part, number) for name, part in form.parts.items()}
            yield f"option {number + 1} everywhere", {0: {"dict": row}}
        for row in every_constant(form) if often is not None else ():
            yield f"always {', '.join(map(str, row.values()))}", {0: {"dict": row}}
    elif isinstance(form, Choice):
        for word in form.options:
            yield "an option", {0: word}


def every_constant(form: Parts) -> Iterator[dict[str, Plain]]:
    """Yield all ways to choose an option of each part, if these are few; 0 for what is no choice."""
    options = [part.options if isinstance(part, Choice) else (0.0,) for part in form.parts.values()]
    if 1 < math.prod(map(len, options)) <= MOST_CONSTANTS:
        for chosen in product(*options):
            yield dict(zip(form.parts, chosen, strict=True))


def usual_answer(form: Form, expected: Sequence[Plain], own: int) -> Plain:
    """Return what is right most often in each part, of all variants but one's own; None if all are alike.

    Of six variants without a number in common, one's own is as frequent as each other: it would be right in a sixth.
    """
    others = [plain for number, plain in enumerate(expected) if number != own]
    if not others or not isinstance(form, Parts) or all(form.alike(plain, expected[0]) for plain in expected):
        return None
    columns = {name: [plain["dict"][name] for plain in others] for name in form.parts}
    return {"dict": {name: column[most_frequent(column)[0]] for name, column in columns.items()}}


def frequent_words(form: Form, expected: Sequence[Plain]) -> Text:
    """Return the right words of all parts that are asked alike, as often as they are right in all variants."""
    parts = form.parts if isinstance(form, Parts) else {}
    alike = {parts[names[0]].options: names for names in asked_alike(parts)}
    return {options: [plain["dict"][name] for plain in expected for name in names] for options, names in alike.items()}


def at_random(parts: Mapping[str, Form], words: Text | None = None) -> dict[str, Plain]:
    """Return an option of each part, drawn from all of them, or from `words` if it is among these."""
    options = {name: part.options for name, part in parts.items() if isinstance(part, Choice)}
    drawn = {name: DICE.choice((words or {}).get(row, row)) for name, row in options.items()}
    return dict.fromkeys(parts, 0.0) | drawn


def option(part: Form, number: int) -> Plain:
    return part.options[min(number, len(part.options) - 1)] if isinstance(part, Choice) and part.options else 0.0


def most_frequent(shown: Sequence[Plain]) -> list[int]:
    """Return the places of the results that were shown, the most frequent first, each once."""
    names = [repr(plain) for plain in shown]
    return [names.index(name) for name, _ in Counter(names).most_common()]


def kind(plain: Plain) -> str:
    if isinstance(plain, str | float):
        return str(plain)
    return str(plain["raises"]) if is_raised(plain) else "a value"


def chance(form: Form, expected: Plain) -> float:
    """Return which share of the points options give by chance; of anything else nothing."""
    if isinstance(form, Parts):
        return mean(chance(part, expected["dict"][name]) for name, part in form.parts.items())
    fits = [form.same(word, expected) for word in form.options] if isinstance(form, Choice) else []
    return mean(fits) if fits else 0.0


if __name__ == "__main__":
    sys.exit(main())
