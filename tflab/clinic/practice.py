"""Draw practice patients from a seed: the same number gives the same faulty robot.

    practice_patient(7)                       of any complaint
    practice_patient(7, complaint="jumps")
    two_fault_patient(7)                      two causes, the second behind the first

The same number gives the same patient everywhere.  What was wrong is told by
`answer_of`, which reads no patient: it draws again what the number draws.  And
`second_opinion` starts that robot once more and lets the doctor listen to it.
"""

from __future__ import annotations

import numpy as np

from .causes import CAUSES, Numbers, draw_numbers
from .checks import CHECKS, unknown_name_error
from .patient import FaultyRobot
from .proof import consistent_suspects
from .simulate_patient import doctor_report, make_patient
from .table import COMPLAINTS

__all__ = ["answer_of", "practice_patient", "second_opinion", "two_fault_patient", "worked_patient"]

TRIES = 20  # of drawing a patient again
# A first cause hides a second one: until it is cured, the second cannot be seen.
TWO_FAULTS = (
    ("localizer not running", "mount wrong"),
    ("transforms late", "mount wrong"),
    ("odometry not running", "laser clock behind"),
    ("publish_tf off", "header says another frame"),
)


def practice_patient(number: int, complaint: str = "") -> FaultyRobot:
    """Return a patient to practise on; it takes two or three seconds.

    Raises:
        ValueError: there is no such complaint, or no such number.
    """
    return _clear(*_drawn(number, complaint))[0]


def two_fault_patient(number: int) -> FaultyRobot:
    """Return a patient with two causes.

    Raises:
        ValueError: there is no such number.
    """
    rng = _chance(12, number)
    return make_patient(TWO_FAULTS[int(rng.integers(len(TWO_FAULTS)))], draw_numbers(rng))


def worked_patient(cause: str, number: int = 0) -> FaultyRobot:
    """Return a patient whose cause is known, to show how it is done.

    Raises:
        ValueError: there is no such cause, or no such number.
    """
    if cause not in list(CAUSES):
        raise unknown_name_error(cause, "no cause", CAUSES)
    return make_patient([cause], draw_numbers(_chance(1, number)))


def answer_of(number: int, complaint: str = "") -> str:
    """Return the cause of `practice_patient(number, complaint)`."""
    return _drawn(number, complaint)[1][0]


def second_opinion(number: int) -> str:
    """Return what the doctor says of the robot of `practice_patient(number)`."""
    rng, causes = _drawn(number, "")
    return doctor_report(causes, _clear(rng, causes)[1])


def _clear(rng: np.random.Generator, causes: tuple[str, ...]) -> tuple[FaultyRobot, Numbers]:
    """Return a patient of one cause and its numbers; where its readings fit nobody, others are drawn."""
    for _ in range(TRIES):
        numbers = draw_numbers(rng)
        patient = make_patient(causes, numbers)
        if consistent_suspects({key: check.kind(patient.reading(key)[2]) for key, check in CHECKS.items()}) == causes:
            patient.asked = ()
            return patient, numbers
    raise ValueError(f"after {TRIES} draws no patient's readings fit {causes[0]} alone")


def _drawn(number: int, complaint: str) -> tuple[np.random.Generator, tuple[str, ...]]:
    if complaint and complaint not in COMPLAINTS:
        raise unknown_name_error(complaint, "no complaint", COMPLAINTS)
    rng = _chance(7, number)
    keys = list(COMPLAINTS)
    key = complaint or keys[int(rng.integers(len(keys)))]
    suspects = COMPLAINTS[key].suspects
    return rng, (suspects[int(rng.integers(len(suspects)))],)


def _chance(ward: int, number: int) -> np.random.Generator:
    if isinstance(number, bool) or not isinstance(number, int | np.integer) or number < 0:
        raise ValueError(f"patients have whole numbers: 0, 1, 2 and so on, not {number!r}")
    return np.random.default_rng([ward, int(number)])
