"""Every file and every outcome ends in a record: notebooks and answers with pieces replaced by anything."""

from __future__ import annotations

import copy
import json
import random
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from typing import Any

import pytest

from tflab.grading.judging.job import CellOutcome, HandedIn, Job, Run, RunCell
from tflab.grading.judging.pack import Pack, read_pack
from tflab.grading.judging.submission import grade_submission, merge_records
from tflab.grading.kernels.limits import Limits
from tflab.grading.reports.class_page import class_page
from tflab.grading.reports.feedback import feedback_page
from tflab.grading.reports.gradebook import grades_csv

from . import tiny

ANYTHING = (
    None, True, 0, -1, 1e308, float("nan"), "", "e3-2-answer", "E3.2", "\ud800", "\x00", "x" * 300, [], {}, [[]],
    {"a": 1}, ["answer"], {"task": "E3.2"}, {"name": "e3-3-answer"}, 10**50,
)  # fmt: skip
KINDS = ("raises", "dict", "tuple", "message", "array", "Transform", "float", "object", "text", "unanswered", "sealed")
ENDS = ("timed out", "kernel died", "memory limit", "output limit", "unreadable output")


def places(page: Any, path: tuple = ()) -> Iterator[tuple]:
    """Yield the way to each piece of a notebook."""
    inside = page.items() if isinstance(page, dict) else enumerate(page) if isinstance(page, list) else ()
    for key, piece in inside:
        yield (*path, key)
        yield from places(piece, (*path, key))


def spoilt(notebook: dict, dice: random.Random) -> bytes:
    made = copy.deepcopy(notebook)
    for way in dice.sample(list(places(made)), dice.choice((0, 1, 2, 5, 20))):
        piece = made
        try:
            for key in way[:-1]:
                piece = piece[key]
            piece[way[-1]] = copy.deepcopy(dice.choice(ANYTHING))
        except (TypeError, KeyError, IndexError):  # it is in a piece that has been replaced already
            continue
    data = bytearray(json.dumps(made).encode("utf-8"))
    for _ in range(dice.choice((0, 0, 5))):
        data[dice.randrange(len(data))] = dice.randrange(256)
    return bytes(data)


def outcome(dice: random.Random) -> Any:
    one = dice.choice(ANYTHING)
    return dice.choice((one, [one] * dice.randrange(10), {dice.choice(KINDS): one}, [{dice.choice(KINDS): one}] * 9))


@pytest.fixture(scope="module")
def pack(course: tiny.Course) -> Pack:
    return read_pack(course.pack)


@pytest.mark.proof(reads=["tests/grading/tiny.*"])
def test_whatever_is_handed_in_and_whatever_comes_out_there_is_a_record(
    course: tiny.Course, pack: Pack, sample: Callable
) -> None:
    for seed in sample(range(60), 10):
        try_anything(course, pack, seed)


def try_anything(course: tiny.Course, pack: Pack, seed: int) -> None:
    dice = random.Random(seed)

    def run(cells: Sequence[RunCell], limits: Limits) -> Run:
        outcomes, stopped = [], None
        for number, cell in enumerate(cells):
            outcomes.append(CellOutcome(outcome(dice), dice.choice((None, "error: X: y", "wrong"))))
            if number and cell.kind != "ours" and dice.random() < 0.05:
                stopped = dice.choice(ENDS)
                break
        return Run(outcomes, 0.01, stopped)

    data = spoilt(tiny.answered(course.exercise()), dice)
    job = Job(
        "s102", "Ada", dice.choice(("en", "ko")), pack.release, pack.version, (HandedIn("a.ipynb", data),),
        pack.for_learner("s102"), Limits(), has_roster=True,
    )  # fmt: skip
    record = grade_submission(job, run)
    if record["set_aside"]:
        record = merge_records(record, grade_submission(replace(job, only=record["set_aside"]), run))
    assert (record["most"], record["points"]) == (8.0, 0.0), seed
    json.dumps(record, allow_nan=False).encode("utf-8")
    for level in ("score", "named", "full"):
        assert feedback_page(record, pack.titles, level).encode("utf-8")
    assert grades_csv([record]).encode("utf-8")
    if seed % 20 == 0:
        assert class_page([record]).encode("utf-8")


def test_a_slow_notebook_is_not_run_again_for_each_of_its_tasks(course: tiny.Course, pack: Pack) -> None:
    runs = []

    def run(cells: Sequence[RunCell], limits: Limits) -> Run:
        runs.append(limits)
        nothing = [CellOutcome(None, "no answer came") for _ in cells]
        return Run(nothing, 0.9 * limits.notebook_s)

    data = json.dumps(tiny.answered(course.exercise())).encode()
    file = HandedIn("a.ipynb", data)
    job = Job("s102", "", "en", pack.release, pack.version, (file,), pack.for_learner("s102"), Limits())
    grade_submission(job, run)
    assert len(runs) == 3
