"""Which build runs, and is it the one that was asked for?"""

from __future__ import annotations

import importlib
import os
import subprocess
import sys
from importlib.machinery import EXTENSION_SUFFIXES

from tflab.core import BUILD
from tflab.core.builds import COMPILED_PAGES

WHAT_RUNS = (
    "import tflab.core as c; from tflab.core import poses, cache; print(c.BUILD, poses.__file__, cache.__file__)"
)


def test_the_build_that_is_said_to_run_is_the_one_that_does() -> None:
    files = [importlib.import_module(f"tflab.core.{page}").__file__ for page in COMPILED_PAGES]
    suffixes = tuple(EXTENSION_SUFFIXES) if BUILD == "compiled" else (".py",)
    assert all(file.endswith(suffixes) for file in files), files


def test_one_word_in_the_environment_takes_the_pages_as_they_stand() -> None:
    environment = {**os.environ, "TFLAB_COMPILED": "0"}
    probe = subprocess.run(
        [sys.executable, "-c", WHAT_RUNS], env=environment, capture_output=True, text=True, check=True
    )
    build, *files = probe.stdout.split()
    assert build == "pure"
    assert [file[-3:] for file in files] == [".py", ".py"]
