"""Make patients (simulated faulty robots) in parallel, and cache them on disk under a hash of their inputs.

    specs --known?--> file                       a hash of causes, numbers, and of the code that makes patients
          --new-----> simulated robot --> file

A patient depends on its causes, its numbers and the files of all packages that the
clinic may import (the tools print it, the robots drive it).  A digest of these is its
file name, as with git's objects, so a patient made before an edit is not used again.
"""

from __future__ import annotations

import hashlib
import os
from collections.abc import Sequence
from functools import lru_cache
from pathlib import Path
from typing import NamedTuple

import numpy as np

from tflab import __version__

from .causes import Numbers
from .patient import FaultyRobot
from .simulate_patient import make_patient

__all__ = ["PatientSpec", "digest_of", "files_of", "patients"]

MADE_BY = ("core", "views", "ros", "robots", "bags", "doctor", "tools", "clinic")  # all that the clinic may import
COMPILED = {".pyc", ".so", ".pyd"}  # made from the sources


class PatientSpec(NamedTuple):
    """What a patient is made from: see `make_patient`."""

    causes: tuple[str, ...]
    numbers: Numbers
    complaint: str | None = None


def patients(specs: Sequence[PatientSpec]) -> list[FaultyRobot]:
    """Return a patient for each spec, in their order; new ones are made on all cores, and kept."""
    paths = [_place(spec) for spec in specs]
    new = [(spec, path) for spec, path in zip(specs, paths, strict=True) if not path.is_file()]
    if new:
        from joblib import Parallel, delayed

        Parallel(n_jobs=min(len(new), os.cpu_count() or 1))(delayed(_make)(*pair) for pair in new)
    return [FaultyRobot.unpacked(path.read_text(encoding="ascii")) for path in paths]


def _make(spec: PatientSpec, path: Path) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    beside = path.with_suffix(f".{os.getpid()}")
    beside.write_text(make_patient(*spec).packed(), encoding="ascii")
    beside.replace(path)


def _place(spec: PatientSpec) -> Path:
    cache = Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache")
    name = hashlib.sha256(f"{_sources()} {spec!r}".encode()).hexdigest()
    return cache / "tflab" / "patients" / name[:2] / name


@lru_cache
def _sources() -> str:
    return digest_of(Path(__file__).parents[1])


def digest_of(package: Path) -> str:
    """Return a digest of all that makes patients: each file of the packages in a folder, and the versions."""
    digest = hashlib.sha256(f"{__version__} numpy {np.__version__}".encode())
    for path in files_of(package):
        held = path.read_bytes()
        digest.update(f"{path.relative_to(package).as_posix()} {len(held)}\n".encode() + held)
    return digest.hexdigest()


def files_of(package: Path) -> list[Path]:
    """Return every file of a package's folder that a patient is made from, in one order; not what tools left there."""
    files = (path for name in MADE_BY for path in (package / name).rglob("*") if path.is_file())
    return sorted(
        path
        for path in files
        if path.suffix not in COMPILED and not any(part.startswith(".") for part in path.relative_to(package).parts)
    )
