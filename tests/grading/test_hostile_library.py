"""The library of hostile and broken work gains nothing, harms nobody and costs no honest point.

`make test-all` tries the whole of it behind each wall. `make test` tries one of each kind, when something has changed.
"""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import psutil
import pytest

from tflab.grading import release
from tflab.grading.kernels.kernel_pool import KernelError, Kernels
from tflab.grading.kernels.limits import Limits
from tflab.grading.kernels.sandbox import LEVELS, Sandbox
from tflab.workbook.paths import read_workbook

from . import hostile

STEM = "03_target_and_source"
SEEDS = dict(zip(LEVELS, ("5a17", "c0de", "0b5e"), strict=True))  # drawn once: what is luck is the same luck each time
GRADE = """
import sys
from tflab.cli import main
from tflab.grading.kernels import kernel_pool
kernel_pool.LEVELS = (sys.argv.pop(1),)
sys.exit(main())
"""
SAID = {"limits": {"a pool of processes"}}  # what a wall says itself that it costs
SAMPLE = {"limits": 10, "bubblewrap": 3}  # recipes; else one of each kind
SECONDS = "1"  # of a cell: what does not end is tried once more with three times as long
pytestmark = pytest.mark.proof(
    reads=["tflab/grading/**/*.py", "tests/grading/hostile/*.*", "*/*/*03_*.ipynb", "solutions/tasks/03_*/*"]
)


def is_there(wall: str) -> bool:
    """Return whether this machine has a wall."""
    kernels = Kernels(Sandbox(wall), ahead=0)
    try:
        kernels.take(Limits()).close()
    except (KernelError, OSError):
        return False
    finally:
        kernels.close()
    return True


@pytest.fixture(scope="module", params=LEVELS)
def library(
    request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory, sample: Callable
) -> Iterator[dict[str, Any]]:
    """One batch of all recipes behind one wall, between two honest neighbours; its files lie in a folder of its own."""
    wall = request.param
    if not is_there(wall):
        pytest.skip(f"no {wall} on this machine")
    recipes = [recipe for kind in hostile.KINDS for recipe in sample(kind, 1)]
    recipes = sample(recipes, SAMPLE.get(wall, len(recipes)))
    folder = tmp_path_factory.mktemp("library")
    with pytest.MonkeyPatch.context() as fixed:
        fixed.setattr(release.secrets, "token_hex", lambda count: (SEEDS[wall] * count)[: 2 * count])
        assert release.main([str(folder / "release"), "--chapters", "03"]) == 0
    handed_out = next((folder / "release/learners").iterdir())
    seed = read_workbook(handed_out).seed
    honest = hostile.Honest(hostile.honest_notebook(handed_out, STEM), "E3.3", "invert", "E3.2", "corner", seed)
    made: dict[str, Any] = {"a-neighbour": honest.fresh(), "z-neighbour": honest.fresh()}
    for number, recipe in enumerate(recipes):
        made[f"r{number:03}"] = recipe.make(honest)
    for name, notebook in made.items():
        path = folder / "submissions" / name / f"{STEM}.ipynb"
        path.parent.mkdir(parents=True)
        path.write_bytes(notebook if isinstance(notebook, bytes) else json.dumps(notebook).encode())
    own = Path(tempfile.mkdtemp(prefix="library-"))  # short: sockets lie in it; others use /tmp meanwhile
    words = [sys.executable, "-c", GRADE, wall, "grade", str(folder / "submissions"), "--quiet", "--seconds", SECONDS]
    words += ["--jobs", "2", "--pack", str(folder / "release/instructor"), "--out", str(folder / "results")]
    ran = subprocess.run(words, capture_output=True, text=True, timeout=3000, env=os.environ | {"TMPDIR": str(own)})
    assert ran.returncode == 0, ran.stderr
    held = json.loads((folder / "results/results.json").read_text(encoding="utf-8"))
    records = {record["learner"]: record for record in held["submissions"]}
    yield {"wall": wall, "recipes": recipes, "records": records, "own": own, "folder": folder}
    shutil.rmtree(own)


def tasks(record: dict[str, Any]) -> dict[str, dict[str, Any]]:
    return record["chapters"][STEM]["tasks"]


def undeserved_or_lost(record: dict[str, Any], recipe: hostile.Recipe) -> list[str]:
    """Return what is not as the recipe says."""
    spoilt = {"function": "E3.3", "value": "E3.2", "mistake": "E3.3", "": ""}[recipe.spoils]
    rows = tasks(record)
    undeserved = bool(spoilt) and recipe.spoils != "mistake" and rows[spoilt]["points"]
    found = [f"{spoilt}: {rows[spoilt]['points']} points for {recipe.name}"] if undeserved else []
    if recipe.keeps in ("all", "others"):
        lost = [task for task, row in rows.items() if task != spoilt and row["points"] < row["most"]]
        found += [f"{recipe.name}: lost {', '.join(lost)}"] if lost else []
    if recipe.keeps == "none" and record["points"]:
        found.append(f"{recipe.name}: {record['points']} points for nothing")
    return found


def test_nothing_gains_a_point_or_costs_an_honest_one(library: dict[str, Any]) -> None:
    found = [
        line
        for number, recipe in enumerate(library["recipes"])
        if recipe.name not in SAID.get(library["wall"], ())
        for line in undeserved_or_lost(library["records"][f"r{number:03}"], recipe)
    ]
    assert not found, "\n".join(found)


def test_neighbours_keep_all_points(library: dict[str, Any]) -> None:
    for name in ("a-neighbour", "z-neighbour"):
        assert library["records"][name]["points"] == library["records"][name]["most"] > 0


def test_nothing_fails_in_the_grader_itself(library: dict[str, Any]) -> None:
    failed = {
        library["recipes"][int(name[1:])].name: record["remarks"]
        for name, record in library["records"].items()
        if record.get("not_run")
    }
    assert failed == {}


def test_nothing_is_left_behind(library: dict[str, Any]) -> None:
    assert [path.name for path in library["own"].iterdir()] == []
    assert [path.name for path in Path("/tmp").glob("was-here*")] == []
    kernels = [
        process
        for process in psutil.process_iter(["cmdline", "environ"])
        if str(library["folder"]) in " ".join(process.info["cmdline"] or ())
    ]
    assert kernels == []


def test_no_page_for_learners_shows_what_was_asked(library: dict[str, Any]) -> None:
    pages = list((library["folder"] / "results/feedback").glob("*.html"))
    assert len(pages) == len(library["records"])
    asked = ["asked_", "'yaw':", "&#x27;yaw", "&#39;yaw"]
    assert [page.name for page in pages if any(word in page.read_text(encoding="utf-8") for word in asked)] == []
