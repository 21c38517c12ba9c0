"""The node files that pages print to be saved run as they are, and end with exit status 0."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest

from tflab.workbook.pages.source import Page, read_page
from tflab.workbook.paths import workbook_data

FILE = re.compile(r"```python\n(# tf_lab_py/(\w+\.py)\n.*?)```", re.DOTALL)


def files_on(page: Page, language: str) -> dict[str, str]:
    """Return the content of each file on a page in a language, by name."""
    texts = (cell.source for cell in page.cells if cell.lang == language)
    return {found[2]: found[1] for text in texts for found in FILE.finditer(text)}


PAGES = {path.stem: read_page(path) for path in sorted((workbook_data() / "notebooks" / "src").glob("*.py"))}
FILES = [(stem, name) for stem, page in PAGES.items() for name in files_on(page, "en")]


def test_both_languages_print_the_same_files() -> None:
    assert {stem: files_on(page, "en") for stem, page in PAGES.items()} == {
        stem: files_on(page, "ko") for stem, page in PAGES.items()
    }
    assert len(FILES) >= 9


@pytest.mark.proof(reads=["notebooks/src/{stem}.py"])
@pytest.mark.parametrize(("stem", "name"), FILES)
def test_a_file_to_take_home_runs_to_exit_status_0(stem: str, name: str, tmp_path: Path) -> None:
    (tmp_path / name).write_text(files_on(PAGES[stem], "en")[name], encoding="utf-8")
    command = [sys.executable, "-m", "tflab", "run", name, "--for", "2"]
    ran = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, timeout=60, check=False)
    assert ran.returncode == 0, ran.stderr
    assert "Traceback" not in ran.stderr
