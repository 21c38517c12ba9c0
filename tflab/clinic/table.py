"""State what each check shows for each of eighteen suspects (possible causes), three for each of six complaints.

    complaint   "Frame [map] does not exist"
    suspects    localizer not running   localizer waits for /clock   Fixed Frame misspelt
    node list   without localization    as on the card               as on the card         tells one from two
    publish_tf  True                    True                         True                   tells nothing

A complaint is what an operator sees, a suspect what may be behind it.  The table
is general knowledge about robots and says nothing of any patient; diagnosis from
such a table is called a *fault dictionary*.  The ward's test runs all eighteen and
holds the table to what they said.
"""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple

from tflab.text import load_yaml

from .checks import CHECKS

__all__ = ["COMPLAINTS", "DECIDING", "SENSOR_BROKEN", "SUSPECTS", "Complaint", "expected_kind"]


class Complaint(NamedTuple):
    """What an operator says, in English and in Korean, and who may be behind it."""

    en: str
    ko: str
    suspects: tuple[str, ...]


_TABLE = load_yaml(Path(__file__).with_suffix(".yaml").read_text(encoding="utf-8"))
COMPLAINTS = {
    key: Complaint(each["en"], each["ko"], tuple(each["suspects"])) for key, each in _TABLE["complaints"].items()
}
SUSPECTS = tuple(suspect for complaint in COMPLAINTS.values() for suspect in complaint.suspects)
SENSOR_BROKEN = "sensor broken"  # whom everybody suspects, and nobody in the clinic has
DECIDING: dict[str, str] = _TABLE["deciding"]  # which check shows whether the suspect is gone


def expected_kind(suspect: str, check: str) -> str:
    """Return what kind of finding a suspect would give to a check."""
    return _TABLE["columns"][suspect].get(check, CHECKS[check].usual)
