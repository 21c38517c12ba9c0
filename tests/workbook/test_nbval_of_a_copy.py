"""`pytest --nbval` in a fresh copy: a page passes in either language, an exercise once it is solved."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib  # comes with pytest

import tflab
from tflab.text import LANGUAGES
from tflab.workbook.copy.lay_out import lay_out
from tflab.workbook.paths import workbook_data

STEMS = sorted(path.stem for path in (workbook_data() / "exercises" / "en").glob("*.ipynb"))
PAGE = "03_target_and_source.ipynb"  # it has an output to predict and a figure that is folded
PLUGIN = "tflab.grading.plugin"
WRONG = {"e3-4-answer": "def compose(a_pose_b, b_pose_c):\n    return b_pose_c\n"}


def nbval(path: Path, option: str) -> str:
    """Run nbval on a notebook of a copy, in a process of its own; return what it printed."""
    kept = ("TFLAB_RAN",)  # conftest.py collects there which files ran
    variables = {
        name: value for name, value in os.environ.items() if name in kept or not name.startswith(("TFLAB_", "PYTEST_"))
    }
    search = os.pathsep.join([str(Path(tflab.__file__).parents[1]), os.environ.get("PYTHONPATH", "")])
    done = subprocess.run(
        [sys.executable, "-m", "pytest", option, "-q", "-p", "no:cacheprovider", path.name],
        cwd=path.parent, env=variables | {"PYTHONPATH": search},
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
    )  # fmt: skip
    return done.stdout


def with_answers(copy: Path, stem: str, other: dict[str, str]) -> Path:
    """Put the solution's answer cells, or others, into an exercise of a copy."""
    path = copy / "exercises" / "en" / f"{stem}.ipynb"
    solution = workbook_data() / "solutions" / "en" / f"{stem[1:]}.ipynb"
    solved = {cell["id"]: cell for cell in json.loads(solution.read_text(encoding="utf-8"))["cells"]}
    notebook = json.loads(path.read_text(encoding="utf-8"))
    for cell in notebook["cells"]:
        if "answer" in cell["metadata"].get("tags", ()):
            cell["source"] = other.get(cell["id"], solved[cell["id"]]["source"])
    path.write_text(json.dumps(notebook), encoding="utf-8")
    return path


@pytest.mark.parametrize(("language", "option"), [*((each, "--nbval") for each in LANGUAGES), ("en", "--nbval-lax")])
def test_nbval_passes_on_a_page_of_a_fresh_copy(tmp_path: Path, language: str, option: str) -> None:
    copy = lay_out(tmp_path / "copy", language)
    printed = nbval(copy / "notebooks" / language / PAGE, option)
    assert " passed" in printed and "failed" not in printed and "error" not in printed, printed


def test_nbval_fails_on_a_page_whose_stored_output_is_another(tmp_path: Path) -> None:
    page = lay_out(tmp_path / "copy", "ko") / "notebooks" / "ko" / "91_practice.ipynb"
    text = page.read_text(encoding="utf-8")
    assert "virtual time" in text
    page.write_text(text.replace("virtual time", "wall time"), encoding="utf-8")
    assert "1 failed" in nbval(page, "--nbval")


@pytest.fixture
def copy(tmp_path: Path) -> Path:
    """A learner's copy."""
    return lay_out(tmp_path / "copy", "en")


@pytest.mark.parametrize("option", ["--nbval", "--nbval-lax"])
def test_a_wrong_answer_fails_its_own_check_cell_with_the_reply(copy: Path, option: str) -> None:
    printed = nbval(with_answers(copy, "E03_target_and_source", WRONG), option)
    assert "1 failed" in printed
    assert "E3.4 ✗ 0/" in printed


@pytest.mark.proof(reads=["exercises/en/*.ipynb", "solutions/en/*.ipynb"])
def test_blank_exercises_fail_and_solved_ones_pass(copy: Path, sample) -> None:
    for stem in sample(STEMS, 1):
        path = copy / "exercises" / "en" / f"{stem}.ipynb"
        checks = path.read_text(encoding="utf-8").count('"check"')
        assert f"{checks} failed" in nbval(path, "--nbval"), stem
        printed = nbval(with_answers(copy, stem, {}), "--nbval")
        assert re.search(r"^\d+ passed", printed, re.MULTILINE), printed


def test_pytest_finds_the_plugin_and_pays_nothing_for_it() -> None:
    project = tomllib.loads((Path(__file__).parents[2] / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    assert project["entry-points"]["pytest11"] == {PLUGIN: PLUGIN}
    code = f"import sys, {PLUGIN}; print(*sys.modules)"
    loaded = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout.split()
    assert not {"numpy", "nbval", "IPython", "nbformat", "matplotlib"} & set(loaded)
