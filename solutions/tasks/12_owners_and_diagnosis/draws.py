"""Draw patients and the values of each cause for several tasks of chapter 12."""

from __future__ import annotations

import hashlib
import json
import lzma
from functools import lru_cache
from pathlib import Path

from tflab.clinic.archive import PatientSpec, patients
from tflab.clinic.causes import draw_numbers
from tflab.clinic.checks import CHECKS
from tflab.clinic.fixes import EFFECTIVE_FIXES, WORKAROUNDS
from tflab.clinic.patient import FaultyRobot
from tflab.clinic.proof import consistent_suspects
from tflab.clinic.table import COMPLAINTS, SUSPECTS

CAUSES = (*SUSPECTS, "sensor broken")
FRAMES = ("map", "odom", "base_footprint", "laser_frame", "all that move", "none")
OWNERS = (
    "localization",
    "wheel_odometry",
    "ekf_filter_node",
    "laser_mount",
    "laser_driver",
    "rviz",
    "network",
    "nobody",
)
FIXES = (*EFFECTIVE_FIXES, *WORKAROUNDS)
TRIES = 8  # of drawing a patient again

STORED = Path(__file__).with_name("patients.json.xz")  # `make patients` writes it


def draw_patients(rng, groups):
    """Draw a stored patient of one of the complaints in each group."""
    drawn = []
    for complaints in groups:
        suspects = COMPLAINTS[complaints[int(rng.integers(len(complaints)))]].suspects
        drawn.append(draw_stored_patient(rng, suspects[int(rng.integers(len(suspects)))]))
    return drawn


def draw_stored_patient(rng, cause):
    """Draw one of the stored patients with a cause."""
    rows = _stored()["by cause"][cause]
    return FaultyRobot(*rows[int(rng.integers(len(rows)))])


def draw_one_of_each(rng, made=None):
    """Return a patient of each cause, in any order, who all say the same.

    Args:
        made: returns the patients of some specs; those of the public seed are stored, others are simulated.
    """
    made = made or load_or_simulate
    causes = [SUSPECTS[place] for place in rng.permutation(len(SUSPECTS))]
    found = made([PatientSpec((cause,), draw_numbers(rng), "") for cause in causes])
    for _ in range(TRIES):
        unclear = [place for place, patient in enumerate(found) if cause_of(patient) != causes[place]]
        if not unclear:
            return found
        others = made([PatientSpec((causes[place],), draw_numbers(rng), "") for place in unclear])
        for place, patient in zip(unclear, others, strict=True):
            found[place] = patient
    unclear_causes = ", ".join(causes[place] for place in unclear)
    raise ValueError(f"after {TRIES} draws no patient's readings fit its cause alone: {unclear_causes}")


def load_or_simulate(specs):
    """Return the patients of some specs from the store, or simulate them."""
    stored = _stored()["by spec"]
    names = [spec_name(spec) for spec in specs]
    new = [spec for spec, name in zip(specs, names, strict=True) if name not in stored]
    simulated = iter(patients(new))
    return [FaultyRobot(*stored[name]) if name in stored else next(simulated) for name in names]


def spec_name(spec):
    """Return the name under which a patient is stored."""
    return hashlib.sha256(repr(tuple(spec)).encode()).hexdigest()[:16]


@lru_cache
def _stored():
    if not STORED.exists():  # `make patients` is about to write it
        return {"by cause": {}, "by spec": {}}
    return json.loads(lzma.decompress(STORED.read_bytes()))


def cause_of(patient):
    """Return the one suspect that all readings of a patient fit, None if there is none."""
    found = {key: check.kind(patient.reading(key)[2]) for key, check in CHECKS.items()}
    patient.asked = ()
    return next(iter(consistent_suspects(found)), None)


def everything():
    return list(CHECKS)
