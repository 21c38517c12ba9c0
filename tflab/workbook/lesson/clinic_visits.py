"""Provide the diagnosis exercises for pages in the reader's language, and compare two orders of checks.

```
admit(patient)            the complaint, the card, twelve minutes
second_opinion(7, cause)  what the doctor says of a practice patient, beside one's own diagnosis
draw_columns("flickers")  the table of a complaint: who would answer what
draw_both_ways()          the lecture's order beside the best question next, for all eighteen
show_suspects()           whom each complaint may come from, in print
show_trolley()            the checks, and what they cost
show_findings()           what each check says of whom
```
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from tflab.clinic import practice
from tflab.clinic.checks import BUDGET_MIN, unknown_name_error
from tflab.clinic.examples import checks_as_text, findings_as_text, suspects_as_text
from tflab.clinic.panel import columns_for, suspects_table
from tflab.clinic.patient import FaultyRobot
from tflab.clinic.proof import best_check, check_steps, minutes_of, rivals_left, rivals_of
from tflab.clinic.table import COMPLAINTS, SUSPECTS, expected_kind
from tflab.clinic.visit import Visit
from tflab.clinic.visit import admit as admitted
from tflab.views.diagnosis_log import draw_minutes, draw_order
from tflab.views.fault_tables import SuspectsPicture, draw_suspects
from tflab.views.picture import Picture

from ...text import language_of_workbook

OPINIONS = {
    "en": {"first": "First your own diagnosis: name one of the suspects.", "you": "You", "doctor": "The doctor"},
    "ko": {"first": "먼저 직접 진단하고 용의자 하나를 고르십시오.", "you": "나", "doctor": "tflab doctor"},
}

# The lecture's six steps: names, tree, values, delays, message and clock, publishers and settings.
LECTURES_ORDER = (
    "rviz", "node list",
    "view_frames",
    "echo map base_footprint", "echo odom base_footprint", "echo base_link laser_frame",
    "monitor",
    "scan header", "delay /scan", "delay /odom", "use_sim_time",
    "info /tf", "info /tf_static", "publish_tf", "echo /tf_static", "hz /odom",
)  # fmt: skip


def admit(patient: FaultyRobot, helped: bool = False) -> Visit:
    """Let a patient in, in the language of this copy; where the table helps, it strikes whom a reading does not fit."""
    return admitted(patient, language_of_workbook(), helped)


def second_opinion(number: int, cause: str = "") -> None:
    """Print one's own diagnosis of a practice patient and what the doctor says of it; without the first, nothing."""
    words = OPINIONS[language_of_workbook()]
    if cause not in SUSPECTS:
        print(words["first"])
        return
    print(f"{words['you']}: {cause}\n{words['doctor']}: {practice.second_opinion(number)}")


def show_suspects() -> None:
    """Print each complaint and its suspects, in the language of this copy."""
    print(suspects_as_text(language_of_workbook()))


def show_trolley() -> None:
    """Print each check by its short name, what it costs, and what is typed."""
    print(checks_as_text(language_of_workbook()))


def show_findings(complaint: str = "") -> None:
    """Print of each check what it says when all is well, and what of whom; "" for all eighteen suspects.

    Raises:
        ValueError: there is no such complaint.
    """
    print(findings_as_text(complaint, language_of_workbook()))


def draw_columns(complaint: str, asked: Mapping[str, str] = {}) -> SuspectsPicture:
    """Draw the three suspects of a complaint, and the checks that can tell them apart; "" draws all eighteen.

    Raises:
        ValueError: there is no such complaint.
    """
    if complaint and complaint not in COMPLAINTS:
        raise unknown_name_error(complaint, "no complaint", COMPLAINTS)
    suspects = COMPLAINTS[complaint].suspects if complaint else SUSPECTS
    return draw_suspects(suspects_table(suspects, columns_for(suspects)), asked)


def draw_questions(cause: str, checks: Sequence[str]) -> Picture:
    """Draw what each check would cost, and who would be left after it, were it this cause."""
    return draw_order(check_steps(cause, checks))


def best_questions(cause: str) -> list[str]:
    """Return what is asked, were it this cause, by somebody who always asks what splits most for a minute."""
    asked: list[str] = []
    left: tuple[str, ...] = SUSPECTS
    while len(left) > 1:
        check = best_check(left)  # what was asked splits nobody any more
        asked.append(check)
        left = tuple(other for other in left if expected_kind(other, check) == expected_kind(cause, check))
    return asked


def draw_both_ways() -> Picture:
    """Draw the minutes that both ways take until one suspect is left, no complaint told, for each of eighteen."""
    orders = {
        "six steps": {cause: minutes_of(_until_clear(cause, LECTURES_ORDER)) for cause in SUSPECTS},
        "best next": {cause: minutes_of(best_questions(cause)) for cause in SUSPECTS},
    }
    return draw_minutes(orders, BUDGET_MIN)


def _until_clear(cause: str, checks: Sequence[str]) -> Sequence[str]:
    rows = rivals_left(cause, rivals_of(cause, whole=True), checks)
    return checks[: next((number for number, left in enumerate(rows, start=1) if not left), len(checks))]
