"""Check that this machine has what the pages need.

    ✓  Python 3.10 or later
    ✓  numbers and figures
    ✗  widgets and 3D: ipywidgets is missing: pip install "tflab[views]"

Where all is well it prints the same everywhere, in the language of the copy.  Whether the
browser shows 3D, only eyes can tell: the start page draws something.
"""

from __future__ import annotations

import importlib.util
import os
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

from ...text import Text, Texts
from ..paths import MARK, language_here, workbook_root

__all__ = ["check_environment", "missing"]


class Requirement(NamedTuple):
    """What the pages need: what it is for, and what of tflab brings which modules."""

    what: Text
    brought_by: str
    modules: tuple[str, ...]


NEEDED = (
    Requirement(Text("numbers and figures", "숫자와 그림"), "tflab[views]", ("numpy", "matplotlib", "PIL", "yaml")),
    Requirement(Text("widgets and 3D", "위젯과 3D"), "tflab[views]", ("ipywidgets", "anywidget", "meshcat")),
    Requirement(Text("notebooks", "노트북"), "tflab[lab]", ("jupyterlab", "ipykernel")),
    Requirement(Text("recordings", "bag 파일"), "tflab[bags]", ("rosbags",)),
)
LEAST_PYTHON = (3, 10)
LEAST = ".".join(map(str, LEAST_PYTHON))
OUR_PYTHON = Text(f"Python {LEAST} or later", f"Python {LEAST} 이상")
TEXTS = Texts(__file__)


def check_environment() -> None:
    """Print what is there and what is missing."""
    language = language_here()
    faults = dict(missing())
    for what in (OUR_PYTHON, *(need.what for need in NEEDED), TEXTS["a_place"]):
        name = what.say(language)
        print(f"✗  {name}: {faults[what].say(language)}" if what in faults else f"✓  {name}")


def missing() -> Iterator[tuple[Text, Text]]:
    """Yield what is not as the pages need it, and what to do."""
    if sys.version_info < LEAST_PYTHON:
        yield OUR_PYTHON, TEXTS["old_python"].filled(found=".".join(str(part) for part in sys.version_info[:2]))
    for what, brought_by, modules in NEEDED:
        absent = [name for name in modules if importlib.util.find_spec(name) is None]
        if absent:
            yield what, TEXTS["absent"].filled(names=", ".join(absent), brought_by=brought_by)
    folder = workbook_root()
    if (Path(folder) / MARK).is_file() and not os.access(folder, os.W_OK):
        yield TEXTS["a_place"], TEXTS["locked"].filled(folder=folder)
