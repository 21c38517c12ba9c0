"""Fixtures of grading: a tiny chapter, released once."""

from __future__ import annotations

import sys
from collections.abc import Iterator

import pytest

from . import tiny

if sys.platform != "linux":  # grading is on Linux, and says so; its tests could not even be read elsewhere
    collect_ignore_glob = ["test_*.py"]


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
