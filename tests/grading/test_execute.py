"""What hangs, dies or floods costs its own points only. A runner in this process replaces the kernel."""

from __future__ import annotations

import json
from collections.abc import Callable, Sequence
from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import pytest

from tflab.grading.judging.execute import SHORTLY, Execution, execute
from tflab.grading.judging.job import CellOutcome, HandedIn, Job, NotRun, Run, RunCell, RunCells
from tflab.grading.judging.plan import BRIEFLY, MergedNotebook, plan
from tflab.grading.judging.submission import grade_submission, merge_records
from tflab.grading.kernels import probe_answer as inside
from tflab.grading.kernels.limits import Limits
from tflab.workbook.answers.forms import Number
from tflab.workbook.answers.values import raised, to_plain

SHORT = Limits(cell_s=1.0, notebook_s=6.0)
TASKS = {
    "E1.1": {"answer": "a", "is_function": False, "given": {"b": 2}, "cases": [{"args": None}]},
    "E1.2": {"answer": "f", "is_function": True, "given": None, "cases": [{"args": [1]}, {"args": [2]}, {"args": [3]}]},
    "E1.3": {"answer": "c", "is_function": False, "given": None, "cases": [{"args": None}]},
}


def pieces(**sources: str) -> MergedNotebook:
    """Return a merge_submission of three answers, with own cells where a name says so."""
    made = [RunCell("ours", "load", "loaded = True")]
    for number, task in ((1, "E1.1"), (2, "E1.2"), (3, "E1.3")):
        slug = f"e1_{number}"
        if f"own_{slug}" in sources:
            made.append(RunCell("own", f"{slug}-given+1", sources[f"own_{slug}"], task))
        made.append(RunCell("answer", f"{slug}-answer", sources.get(slug, "a = c = 1\ndef f(x): return x"), task))
        made.append(RunCell("probe", f"{slug}-check", task=task))
        if f"after_{slug}" in sources:
            made.append(RunCell("own", f"{slug}-check+1", sources[f"after_{slug}"], task))
            made.append(RunCell("probe", f"{slug}-check-again", task=task))
    return MergedNotebook(tuple(made), tuple(TASKS))


class Stop(BaseException):
    """What a cell of these tests raises where a real one would hang, die or shout."""


class Here:
    """Runs cells in this process; HANG, DIE and SHOUT in a cell stop the run."""

    def __init__(self) -> None:
        self.runs: list[list[str]] = []

    def __call__(self, cells: Sequence[RunCell], limits: Limits) -> Run:
        self.runs.append([cell.name for cell in cells])
        space: dict[str, Any] = {"hang": self._stop("timed out"), "die": self._stop("kernel died")}
        space["shout"] = self._stop("output limit")
        outcomes, stopped = [], None
        for cell in cells:
            value = trouble = None
            try:
                if cell.probe is None:
                    exec(cell.source, space)
                else:
                    value = self._probed(cell, space)
            except Stop as stop:
                stopped = trouble = str(stop)
            except Exception as error:
                trouble = f"error: {type(error).__name__}: {error}"
            outcomes.append(CellOutcome(value, trouble))
            if stopped:
                break
        return Run(outcomes, 0.1, stopped)

    def _stop(self, why: str) -> Callable[[], None]:
        def stop() -> None:
            raise Stop(why)

        return stop

    def _probed(self, cell: RunCell, space: dict[str, Any]) -> list:
        said: list[Any] = []
        keep = inside._send
        inside._send = lambda _, plain: said.append(plain)
        try:
            exec(cell.source, space)
        finally:
            inside._send = keep
        return said[0]


@pytest.fixture(autouse=True)
def quiet_prepare(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(inside, "prepare", lambda givens_json: json.loads(givens_json))


def tried(here: RunCells, done: MergedNotebook, **options: Any) -> Execution:
    return execute(done, TASKS, here, SHORT, **{"wanted": list(TASKS)} | options)


def kinds(made: Execution, task: str) -> list[str]:
    return [remark.kind for remark in made.trouble.get(task, [])]


def test_all_answers_are_heard_in_one_run() -> None:
    here = Here()
    made = tried(
        here, pieces(e1_1="a = object()", e1_2="def f(x):\n    if x == 2: raise LookupError('no')\n    return x")
    )
    assert made.outcomes["E1.1"] == {0: to_plain(object())}
    assert made.outcomes["E1.2"] == {0: 1, 1: raised(LookupError("no")), 2: 3, 3: 1}
    assert made.outcomes["E1.3"] == {0: 1}
    assert len(here.runs) == 1
    assert not made.set_aside and not made.trouble


@pytest.mark.parametrize(
    ("answer", "kind"),
    [("hang()", "timed out"), ("die()", "died"), ("shout()", "flood"), ("def f(x):\n    hang()", "timed out")],
)
def test_an_answer_that_stops_the_run_is_set_aside_and_the_others_run_without_it(answer: str, kind: str) -> None:
    made = tried(Here(), pieces(e1_2=answer))
    assert made.set_aside == ["E1.2"]
    assert kinds(made, "E1.2") == [kind]
    assert made.outcomes["E1.1"] == made.outcomes["E1.3"] == {0: 1}


def test_looked_at_closely_only_the_case_that_hangs_is_lost() -> None:
    made = tried(Here(), pieces(e1_2="def f(x):\n    return hang() if x == 2 else x"), wanted=["E1.2"], closely=True)
    assert made.outcomes["E1.2"] == {0: 1, 2: 3, 3: 1}
    assert kinds(made, "E1.2") == ["timed out twice"]


def test_tried_alone_each_task_has_three_times_the_time_and_what_is_left_then_is_asked_briefly() -> None:
    here, heard = Here(), []

    def run(cells: Sequence[RunCell], limits: Limits) -> Run:
        asked = [(cell.task, cell.part, cell.shared) for cell in cells if cell.probe]
        heard.append((limits.cell_s, {task: part for task, part, _ in asked}))
        assert len({shared for _, _, shared in asked}) == len({task for task, _, _ in asked})
        return here(cells, limits)

    execute(pieces(e1_2="def f(x):\n    hang()"), TASKS, run, SHORT, wanted=["E1.2", "E1.3"], closely=True)
    assert heard == [(3.0, {"E1.2": 1.0, "E1.3": 1.0}), (3.0, {"E1.2": BRIEFLY, "E1.3": 1.0}), (3.0, {"E1.3": 1.0})]


def test_every_answer_may_hang_and_it_ends() -> None:
    here = Here()
    made = tried(here, pieces(e1_1="hang()", e1_2="hang()", e1_3="hang()"))
    assert sorted(made.set_aside) == list(TASKS)
    assert len(here.runs) == 3


def test_an_own_cell_that_hangs_is_left_out_and_all_is_tried_again_alone() -> None:
    made = tried(Here(), pieces(own_e1_2="hang()"))
    assert made.outcomes["E1.2"] and made.outcomes["E1.3"]
    assert made.set_aside == list(TASKS)
    assert [remark.kind for remark in made.remarks] == ["left out"]


def test_an_answer_that_raises_names_a_known_error_and_no_more() -> None:
    own = "raise type('hidden_3_14', (Exception,), {})()"
    made = tried(Here(), pieces(e1_1="secret = 5\nraise ValueError(f'hidden {secret}')", e1_3=own))
    (remark,) = made.trouble["E1.1"]
    assert (remark.kind, remark.words["error"]) == ("raised", "ValueError")
    assert made.trouble["E1.3"][0].words["error"].say("en") == "an error of its own"


def test_an_answer_behind_the_check_is_heard_there_if_there_was_none_before() -> None:
    for before, outcome, remarks in (("...", 6, [("elsewhere", "E1.3")]), ("5", 5, [])):
        made = tried(Here(), pieces(e1_3=f"c = {before}", after_e1_3="c = 6"))
        assert made.outcomes["E1.3"] == {0: outcome}
        assert [(remark.kind, remark.task) for remark in made.remarks] == remarks


def test_our_own_cells_failing_is_not_the_learners_fault() -> None:
    with pytest.raises(NotRun):
        tried(Here(), MergedNotebook((RunCell("ours", "load", "die()"), *pieces().cells[1:]), tuple(TASKS)))


def test_a_kernel_that_dies_in_our_cell_was_killed_by_what_ran_before_it() -> None:
    (load, *others), here = pieces(e1_1="a = 1\nspoilt = True").cells, Here()
    dies_late = RunCell("ours", "scene", "if 'spoilt' in globals(): die()")
    made = tried(here, MergedNotebook((load, *others[:2], dies_late, *others[2:]), tuple(TASKS)))
    assert kinds(made, "E1.1") == ["died"]
    assert made.set_aside == ["E1.1"]
    assert kinds(made, "E1.2") == kinds(made, "E1.3") == []
    assert made.outcomes["E1.3"] == {0: 1}
    assert len(here.runs) == 2


def test_a_plan_has_the_cells_that_are_needed_probes_of_other_names_each_time_and_no_expected_value() -> None:
    assert [cell.name for cell in plan(pieces(), TASKS, ["E1.1"]).cells] == ["ours", "e1_1-answer", "e1_1-check"]
    tasks = {
        task: {**held, "cases": [{**case, "expected": "SECRET"} for case in held["cases"]]}
        for task, held in TASKS.items()
    }
    one, other = (plan(pieces(), tasks, list(tasks)) for _ in range(2))
    assert "SECRET" not in str(one)
    assert not set(one.asked) & set(other.asked)


def test_a_machine_too_busy_even_for_our_cells_costs_nobody() -> None:
    task = {"form": Number().plain(), "points": 2, "feedback": {}, "kind": "N", "title": {"en": "", "ko": ""}}
    task |= {"hints": [], "misconceptions": [], "means": {}, "shows": {}}
    task |= {"cases": [{"args": None, "expected": 1, "wrong": {}}]}
    tasks = {"E1.1": {**TASKS["E1.1"], **task}}
    master = [["e1-1-answer", "a = ...", "E1.1", "answer"], ["e1-1-check", "check", "E1.1", "check"]]
    cells = [{"id": "e1-1-answer", "cell_type": "code", "source": "a = 1"}]
    job = Job(
        "s1", "", "en", "r", "v", (HandedIn("a.ipynb", json.dumps({"cells": cells}).encode()),),
        {"01_x": {"master": master, "tasks": tasks}}, Limits(cell_s=1, notebook_s=6),
    )  # fmt: skip
    busy = Here()

    def slow_at_first(cells: Sequence[RunCell], limits: Limits) -> Run:
        if limits.cell_s > 1:
            return busy(cells, limits)
        return SimpleNamespace(outcomes=[SimpleNamespace(value=None, trouble=None)], seconds=1.0, stopped="timed out")

    first = grade_submission(job, slow_at_first)
    assert (first["points"], first["set_aside"]) == (0.0, {"01_x": ["E1.1"]})
    both = merge_records(first, grade_submission(replace(job, only=first["set_aside"]), slow_at_first))
    assert both["points"] == 2.0
    assert "not_run" not in both


def test_own_cells_that_do_not_end_cost_little_after_the_second_and_no_answer() -> None:
    here = Here()
    shares = []

    def watched(cells: Sequence[RunCell], limits: Limits) -> Run:
        shares.extend({cell.part for cell in cells if cell.kind == "own"})
        return here(cells, limits)

    many = pieces()
    helpers = [RunCell("own", f"e1_1-given+{n}", "hang()", "E1.1") for n in range(15)]
    done = MergedNotebook((*many.cells[:1], *helpers, *many.cells[1:]), many.answered)
    made = tried(watched, done)
    assert made.outcomes["E1.1"] == {0: 1} and made.outcomes["E1.3"] == {0: 1}
    assert shares[:2] == [1.0, 1.0] and set(shares[2:]) == {SHORTLY}
