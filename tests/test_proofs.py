"""A proof is left out while nothing that it depends on has changed; an edit reaches the tests that import it."""

from __future__ import annotations

import importlib.util
import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
import yaml

ROOT = Path(__file__).parents[1]
FILES = yaml.safe_load(Path(__file__).with_suffix(".yaml").read_text(encoding="utf-8"))["files"]


@pytest.fixture
def project(tmp_path: Path) -> Path:
    """A project with two proofs, each of which was run in full."""
    for name, text in FILES.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text, encoding="utf-8")
    shutil.copy(ROOT / "conftest.py", tmp_path)
    shutil.copytree(ROOT / "tests" / "tracing", tmp_path / "tests" / "tracing")
    (tmp_path / "pytest.ini").write_text("[pytest]\nmarkers = proof\n browser\n", encoding="utf-8")
    assert run(tmp_path, "--all") == ["one looked at 50", "two looked at 50"]
    return tmp_path


def run(project: Path, *words: str) -> list[str]:
    """Run the tests of the project; return which proofs were run, and how many were left out."""
    command = [sys.executable, "-m", "pytest", "-sq", "-p", "no:cacheprovider", *words]
    own = {"PYTHONPATH": str(project), "PYTHONDONTWRITEBYTECODE": "1", "PYTEST_DISABLE_PLUGIN_AUTOLOAD": "1"}
    environment = os.environ | own
    done = subprocess.run(command, cwd=project, env=environment, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
    lines = (line.lstrip(".") for line in done.stdout.splitlines())
    return [line for line in lines if "looked at" in line or "proved before" in line]


def edit(project: Path, name: str, line: str = "EDITED = 1") -> None:
    path = project / name
    path.write_text(path.read_text(encoding="utf-8") + f"\n{line}\n", encoding="utf-8")


def test_a_proof_is_left_out_until_something_that_it_depends_on_is_edited(project: Path) -> None:
    assert run(project) == ["2 proved before and unchanged"]
    edit(project, "tflab/loaded.py")  # it is imported, but none of its functions ran
    assert run(project) == ["2 proved before and unchanged"]
    edit(project, "data/two.txt")  # one of the two reads it
    assert run(project) == ["two looked at 20", "1 proved before and unchanged"]


def test_comments_docstrings_and_sentences_count_only_where_a_test_reads_texts(project: Path) -> None:
    edit(project, "tflab/ran.py", "# comment")
    path = project / "tflab" / "ran.py"
    text = path.read_text(encoding="utf-8")
    path.write_text(text.replace("def ran():", 'def ran():\n    """New."""'), encoding="utf-8")
    edit(project, "tflab/said.yaml", "- en: >-\n    One more\n\n    sentence.\n  ko: 문장")
    assert run(project) == ["2 proved before and unchanged"]
    edit(project, "data/said.yaml", "- en: A sentence")  # `two` reads its texts
    assert run(project) == ["two looked at 20", "1 proved before and unchanged"]
    edit(project, "tflab/said.yaml", "- at: 4")
    assert run(project) == ["one looked at 20", "two looked at 20"]


def test_code_that_ran_a_constant_a_child_process_and_a_dependency_count(project: Path) -> None:
    for name in ("tflab/ran.py", "tflab/page.jinja", "tflab/limits.py", "tflab/child.py", "constraints.txt"):
        edit(project, name)
        assert run(project) == ["one looked at 20", "two looked at 20"]
        (project / name).write_text(FILES[name], encoding="utf-8")
    assert run(project) == ["2 proved before and unchanged"]
    assert run(project, "tests/test_all.py::test_all[one]") == ["one looked at 20"]  # a test that is named is run


def test_a_part_is_merged_and_what_fails_is_no_longer_proved(project: Path) -> None:
    store = project / "tests" / "proofs.json"
    before = store.read_text(encoding="utf-8")
    edit(project, "data/two.txt")
    assert run(project, "--all", "-k", "two") == ["two looked at 50"]
    assert run(project) == ["2 proved before and unchanged"]
    edit(project, "tflab/ran.py")
    assert run(project, "--all", "-k", "one") == ["one looked at 50"]
    assert run(project) == ["two looked at 20", "1 proved before and unchanged"]
    (project / "tflab/limits.py").write_text("MOST = 4\n", encoding="utf-8")
    with pytest.raises(AssertionError, match="assert 4 == 3"):
        run(project, "--all")
    assert json.loads(store.read_text(encoding="utf-8")) == {} != json.loads(before)


@pytest.mark.parametrize(
    ("edited", "reached", "not_reached"),
    [
        ("tflab/doctor/diagnose.py", {"doctor", "clinic"}, {"core", "robots", "views"}),
        ("tflab/core/buffer.py", {"core", "ros", "robots", "doctor", "workbook", "grading"}, set()),
        ("solutions/tasks/03_target_and_source/e3_2.py", {"workbook"}, {"core", "ros", "doctor", "grading"}),
        ("tflab/grading/guide/static/guide.css", {"grading"}, {"core", "workbook"}),
        ("pyproject.toml", {"core", "views", "grading"}, set()),
    ],
)
def test_an_edit_reaches_the_tests_that_import_it(edited: str, reached: set, not_reached: set) -> None:
    spec = importlib.util.spec_from_file_location("changed", ROOT / "tests" / "changed.py")
    changed = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(changed)
    folders = {path.parent.name for path in changed.tests_reached([edited])}
    assert reached <= folders
    assert not not_reached & folders
    assert changed.tests_reached([]) == []
