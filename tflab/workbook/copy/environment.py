"""Does this machine have what the pages need?  One line for each thing, and what to do where it is missing.

    Python 3.10 or later      ✓
    numbers and figures       ✓
    widgets and 3D            ✗  ipywidgets is missing: pip install "tflab"

Where all is well it prints the same everywhere.  Whether the browser shows 3D, only
eyes can tell: the start page draws something.  Read `lab.py` next.
"""

from __future__ import annotations

import importlib.util
import os
import sys
from collections.abc import Iterator
from pathlib import Path

from ..places import MARK, workbook_root

__all__ = ["check_environment", "missing"]

NEEDED = {  # what it is for, and what of tflab brings it
    "numbers and figures": ("tflab", ("numpy", "matplotlib", "PIL", "yaml")),
    "widgets and 3D": ("tflab", ("ipywidgets", "anywidget", "meshcat")),
    "notebooks": ("tflab[lab]", ("jupyterlab", "ipykernel")),
    "recordings": ("tflab[bags]", ("rosbags",)),
}
LEAST_PYTHON = (3, 10)
OUR_PYTHON = f"Python {'.'.join(map(str, LEAST_PYTHON))} or later"


def check_environment() -> None:
    """Print what is there and what is missing."""
    faults = dict(missing())
    for what in (OUR_PYTHON, *NEEDED, "a place to keep your progress"):
        print(f"{what:<32}{'✗  ' + faults[what] if what in faults else '✓'}")


def missing() -> Iterator[tuple[str, str]]:
    """Yield what is not as the pages need it, and what to do."""
    if sys.version_info < LEAST_PYTHON:
        found = ".".join(str(part) for part in sys.version_info[:2])
        yield OUR_PYTHON, f"this is Python {found}: install a later one, and tflab in it"
    for what, (brought_by, names) in NEEDED.items():
        absent = [name for name in names if importlib.util.find_spec(name) is None]
        if absent:
            yield what, f'{" and ".join(absent)} is missing: pip install "{brought_by}"'
    folder = workbook_root()
    if (Path(folder) / MARK).is_file() and not os.access(folder, os.W_OK):
        yield "a place to keep your progress", f"{folder} cannot be written to: copy it elsewhere, and open it there"
