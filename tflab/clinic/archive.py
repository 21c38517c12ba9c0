"""How are many patients made without making them twice?  On all cores, and kept on disk by what they were made from.

    admissions --known?--> file           a hash of causes, numbers, and of the code that makes patients
               --new-----> ward --> file

A patient follows from its causes, its numbers and this room's pages, so those are its
name: content-addressed, as git's objects are.  Where the tools or the robot changed
what they print, delete the folder; the ward's tests never look into it.

Read `visit.py` next.
"""

from __future__ import annotations

import hashlib
import os
from collections.abc import Sequence
from functools import lru_cache
from pathlib import Path
from typing import NamedTuple

from tflab import __version__

from .causes import Numbers
from .patient import SickRobot
from .ward import make_patient

__all__ = ["Admission", "patients"]

MADE_BY = ("causes", "cures", "findings", "patient", "table", "trolley", "ward")  # pages of this room


class Admission(NamedTuple):
    """What a patient is made from: see `make_patient`."""

    causes: tuple[str, ...]
    numbers: Numbers
    complaint: str | None = None


def patients(admissions: Sequence[Admission]) -> list[SickRobot]:
    """Return a patient for each admission, in their order; new ones are made on all cores, and kept."""
    from joblib import Parallel, delayed

    paths = [_place(admission) for admission in admissions]
    new = [(admission, path) for admission, path in zip(admissions, paths, strict=True) if not path.is_file()]
    Parallel(n_jobs=min(len(new), os.cpu_count() or 1) or 1)(delayed(_make)(*pair) for pair in new)
    return [SickRobot.unpacked(path.read_text(encoding="ascii")) for path in paths]


def _make(admission: Admission, path: Path) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    beside = path.with_suffix(f".{os.getpid()}")
    beside.write_text(make_patient(*admission).packed(), encoding="ascii")
    beside.replace(path)


def _place(admission: Admission) -> Path:
    cache = Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache")
    name = hashlib.sha256(f"{_sources()} {admission!r}".encode()).hexdigest()
    return cache / "tflab" / "patients" / name[:2] / name


@lru_cache
def _sources() -> str:
    """Return a digest of the code that makes patients."""
    digest = hashlib.sha256(__version__.encode())
    for page in MADE_BY:
        digest.update(Path(__file__).with_name(f"{page}.py").read_bytes())
    return digest.hexdigest()
