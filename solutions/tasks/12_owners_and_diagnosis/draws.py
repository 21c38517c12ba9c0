"""Draw patients and the values of each cause for several tasks of chapter 12."""

from __future__ import annotations

import hashlib
import json
import lzma
from functools import lru_cache
from pathlib import Path

from tflab.clinic.archive import Admission, patients
from tflab.clinic.causes import draw_numbers
from tflab.clinic.cures import CURES, PLASTERS
from tflab.clinic.patient import SickRobot
from tflab.clinic.proof import fitting
from tflab.clinic.table import COMPLAINTS, SUSPECTS
from tflab.clinic.trolley import TROLLEY

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
FIXES = (*CURES, *PLASTERS)
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
    return SickRobot(*rows[int(rng.integers(len(rows)))])


def draw_one_of_each(rng, made=None):
    """Return a patient of each cause, in any order, who all say the same.

    Args:
        made: returns the patients of some admissions; those of the public seed are stored, others are simulated.
    """
    made = made or load_or_simulate
    causes = [SUSPECTS[place] for place in rng.permutation(len(SUSPECTS))]
    found = made([Admission((cause,), draw_numbers(rng), "") for cause in causes])
    for _ in range(TRIES):
        unclear = [place for place, patient in enumerate(found) if cause_of(patient) != causes[place]]
        if not unclear:
            return found
        others = made([Admission((causes[place],), draw_numbers(rng), "") for place in unclear])
        for place, patient in zip(unclear, others, strict=True):
            found[place] = patient
    unclear_causes = ", ".join(causes[place] for place in unclear)
    raise ValueError(f"after {TRIES} draws no patient's readings fit its cause alone: {unclear_causes}")


def load_or_simulate(admissions):
    """Return the patients of some admissions from the store, or simulate them."""
    stored = _stored()["by admission"]
    names = [admission_name(admission) for admission in admissions]
    new = [admission for admission, name in zip(admissions, names, strict=True) if name not in stored]
    simulated = iter(patients(new))
    return [SickRobot(*stored[name]) if name in stored else next(simulated) for name in names]


def admission_name(admission):
    """Return the name under which a patient is stored."""
    return hashlib.sha256(repr(admission).encode()).hexdigest()[:16]


@lru_cache
def _stored():
    if not STORED.exists():  # `make patients` is about to write it
        return {"by cause": {}, "by admission": {}}
    return json.loads(lzma.decompress(STORED.read_bytes()))


def cause_of(patient):
    """Return the one suspect that all readings of a patient fit, None if there is none."""
    found = {key: check.kind(patient.reading(key)[2]) for key, check in TROLLEY.items()}
    patient.asked = ()
    return next(iter(fitting(found)), None)


def everything():
    return list(TROLLEY)
