"""A learner who runs nbval on a fresh copy sees every page pass, in either language."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

import tflab
from tflab.text import LANGUAGES
from tflab.workbook.copy.lay_out import lay_out
from tflab.workbook.paths import workbook_data

STEMS = sorted(path.stem for path in (workbook_data() / "notebooks" / "en").glob("*.ipynb"))


def nbval(copy: Path, page: str, option: str) -> tuple[int, str]:
    """Run nbval on a page in a copy, in a process of its own; return its status and what it printed."""
    kept = ("TFLAB_RAN",)  # conftest.py collects there which files ran
    variables = {
        name: value for name, value in os.environ.items() if name in kept or not name.startswith(("TFLAB_", "PYTEST_"))
    }
    path = os.pathsep.join([str(Path(tflab.__file__).parents[1]), os.environ.get("PYTHONPATH", "")])
    done = subprocess.run(
        [sys.executable, "-m", "pytest", option, "-q", "-p", "no:cacheprovider", page],
        cwd=copy, env=variables | {"PYTHONPATH": path},
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
    )  # fmt: skip
    return done.returncode, done.stdout


@pytest.mark.proof(reads=["notebooks/*/*.ipynb"])
@pytest.mark.parametrize("language", LANGUAGES)
def test_nbval_passes_on_each_page_of_a_fresh_copy(tmp_path: Path, language: str, sample) -> None:
    copy = lay_out(tmp_path / "copy", language)
    stems = sample([stem for stem in STEMS if stem != "90_glossary"], 1)  # the glossary has no code
    for stem, option in [*((stem, "--nbval") for stem in stems), (stems[0], "--nbval-lax")]:
        status, printed = nbval(copy, f"notebooks/{language}/{stem}.ipynb", option)
        assert status == 0 and " passed" in printed, printed


def test_nbval_fails_on_a_page_whose_stored_output_is_another(tmp_path: Path) -> None:
    copy = lay_out(tmp_path / "copy", "ko")
    page = copy / "notebooks" / "ko" / "91_practice.ipynb"
    text = page.read_text(encoding="utf-8")
    assert "virtual time" in text
    page.write_text(text.replace("virtual time", "wall time"), encoding="utf-8")
    status, printed = nbval(copy, "notebooks/ko/91_practice.ipynb", "--nbval")
    assert status == 1 and "1 failed" in printed
