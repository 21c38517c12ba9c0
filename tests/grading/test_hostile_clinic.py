"""Nobody names a patient's fault without examining it: chapter 12, from the release to the grades."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping, Sequence
from typing import Any

import pytest

from tflab.grading import grade, release
from tflab.workbook.paths import read_workbook

from . import hostile

STEM = "12_owners_and_diagnosis"
PROGRAM, PATIENTS = "E12.7", "E12.4"
SAMPLE = 5  # recipes
SEED = "c0de"  # of a class in which no patient has what the recipes name: by chance one in six would
pytestmark = pytest.mark.proof(
    reads=["tflab/grading/**/*.py", "tests/grading/hostile/*.*", "*/*/*12_*.ipynb", "solutions/tasks/12_*/*"]
)


@pytest.fixture(scope="module")
def frauds(sample: Callable) -> Sequence[hostile.Recipe]:
    return sample(hostile.CLINIC, SAMPLE)


@pytest.fixture(scope="module")
def marks(tmp_path_factory: pytest.TempPathFactory, frauds: Sequence[hostile.Recipe]) -> dict[str, Mapping[str, Any]]:
    """What each recipe got in each task, and an honest neighbour at either end."""
    folder = tmp_path_factory.mktemp("clinic")
    with pytest.MonkeyPatch.context() as fixed:
        fixed.setattr(release.secrets, "token_hex", lambda count: (SEED * count)[: 2 * count])
        assert release.main([str(folder / "release"), "--chapters", "12"]) == 0
    handed_out = next((folder / "release/learners").iterdir())
    notebook, seed = hostile.honest_notebook(handed_out, STEM), read_workbook(handed_out).seed
    honest = hostile.Honest(notebook, PROGRAM, "triage", PATIENTS, "patients", seed)
    made = {"a": honest.fresh()} | {f"r{number:02}": one.make(honest) for number, one in enumerate(frauds)}
    for name, notebook in (made | {"z": honest.fresh()}).items():
        path = folder / "submissions" / name / f"{STEM}.ipynb"
        path.parent.mkdir(parents=True)
        path.write_text(json.dumps(notebook), encoding="utf-8")
    words = ["--pack", str(folder / "release/instructor"), "--out", str(folder / "results"), "--jobs", "2", "--quiet"]
    assert grade.main([str(folder / "submissions"), *words]) == 0
    held = json.loads((folder / "results/results.json").read_text(encoding="utf-8"))
    return {record["learner"]: record["chapters"][STEM]["tasks"] for record in held["submissions"]}


def test_nobody_diagnoses_what_they_did_not_examine(
    marks: Mapping[str, Mapping[str, Any]], frauds: Sequence[hostile.Recipe]
) -> None:
    spoilt = {"function": PROGRAM, "value": PATIENTS}
    rows = [(one.name, marks[f"r{number:02}"][spoilt[one.spoils]]) for number, one in enumerate(frauds)]
    assert {name: row["points"] for name, row in rows if row["points"]} == {}


def test_an_examination_gets_all_points_and_so_does_what_stands_beside_a_fraud(
    marks: Mapping[str, Mapping[str, Any]], frauds: Sequence[hostile.Recipe]
) -> None:
    spoilt = {
        f"r{number:02}": {"function": PROGRAM, "value": PATIENTS}[one.spoils] for number, one in enumerate(frauds)
    }
    lost = {
        (name, task): row["points"]
        for name, tasks in marks.items()
        for task, row in tasks.items()
        if task != spoilt.get(name) and row["points"] < row["most"]
    }
    assert lost == {}
