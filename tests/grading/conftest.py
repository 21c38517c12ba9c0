"""Fixtures of grading: a tiny chapter, released once, and the modules that make submissions.

The test folders are no packages, so those pages are loaded by their paths.
"""

from __future__ import annotations

import importlib.util
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


@pytest.fixture(scope="session")
def released(tmp_path_factory: pytest.TempPathFactory) -> tiny.Course:
    """The tiny course, released once; tests only read it."""
    from tflab.grading.release import release
    from tflab.grading.submissions.roster import Learner

    folder = tmp_path_factory.mktemp("course")
    workbook = tiny.write_tiny_workbook(folder / "workbook")
    with pytest.MonkeyPatch.context() as fixed:
        fixed.setenv("TFLAB_WORKBOOK", str(workbook))
        release(folder / "release", [tiny.STEM], [Learner("s101", "Kim Minji", "ko"), Learner("s102", "Ada Byron")])
    return tiny.Course(workbook, folder / "release")


@pytest.fixture(scope="module")
def course(released: tiny.Course) -> Iterator[tiny.Course]:
    """The released course, as the workbook that is installed; tests of other folders never see it."""
    with pytest.MonkeyPatch.context() as fixed:
        fixed.setenv("TFLAB_WORKBOOK", str(released.workbook))
        yield released
