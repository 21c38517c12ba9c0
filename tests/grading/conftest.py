"""What do tests of grading need?  A tiny chapter handed out once, and the pages next door that make submissions.

The test folders are no packages, so those pages are loaded by their paths.
"""

from __future__ import annotations

import importlib.util
import os
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

if sys.platform != "linux":  # grading is on Linux, and says so; its tests could not even be read elsewhere
    collect_ignore_glob = ["test_*.py"]

for _name, _page in (("tiny", "tiny.py"), ("hostile", "hostile/__init__.py")):
    if _name not in sys.modules:
        _spec = importlib.util.spec_from_file_location(_name, Path(__file__).parent / _page)
        sys.modules[_name] = importlib.util.module_from_spec(_spec)
        _spec.loader.exec_module(sys.modules[_name])

import tiny  # noqa: E402


@pytest.fixture(scope="module")
def course(tmp_path_factory: pytest.TempPathFactory) -> Iterator[tiny.Course]:
    """The tiny course, released; tests only read it, and tests of other folders never see it."""
    from tflab.grading.release import release
    from tflab.grading.submissions.roster import Learner

    folder = tmp_path_factory.mktemp("course")
    workbook = tiny.write_tiny_workbook(folder / "workbook")
    before = os.environ.get("TFLAB_WORKBOOK")
    os.environ["TFLAB_WORKBOOK"] = str(workbook)
    try:
        release(folder / "release", [tiny.STEM], [Learner("s101", "Kim Minji", "ko"), Learner("s102", "Ada Byron")])
        yield tiny.Course(workbook, folder / "release")
    finally:
        os.environ.pop("TFLAB_WORKBOOK")
        if before is not None:
            os.environ["TFLAB_WORKBOOK"] = before
