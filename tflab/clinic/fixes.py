"""List the fixes: sixteen that each remove a cause, and five workarounds that at most hide a symptom.

    "set the laser's clock"    the cause is gone
    "stamp on arrival"         the error is gone; the points are still in the wrong place

A plan for each cause stands here too: the frame whose pose is wrong, the node that
has to change, and the fix.
"""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple

from tflab.text import load_yaml

__all__ = ["DIAGNOSES", "EFFECTIVE_FIXES", "WORKAROUNDS", "RepairPlan"]


class RepairPlan(NamedTuple):
    """The frame whose pose is wrong, the node that has to change, and the fix."""

    frame: str
    owner: str
    fix: str


_TABLE = load_yaml(Path(__file__).with_suffix(".yaml").read_text(encoding="utf-8"))
EFFECTIVE_FIXES: dict[str, tuple[str, ...]] = {fix: tuple(causes) for fix, causes in _TABLE["effective"].items()}
WORKAROUNDS: dict[str, str] = _TABLE["workarounds"]
_FIX_OF = {cause: fix for fix, causes in EFFECTIVE_FIXES.items() for cause in causes}
DIAGNOSES = {cause: RepairPlan(*where, _FIX_OF[cause]) for cause, where in _TABLE["where"].items()}
