"""Simulate the patients that chapter 12 stores: `make patients`, after a change that makes them print something else.

A patient takes about three seconds, so a learner's `check` must not simulate any.  Stored are some patients of each
cause, from which E12.2 and E12.4 draw, and those that the public seed gives to E12.7.  Hidden patients are simulated
when grading begins.
"""

from __future__ import annotations

import json
import lzma
from typing import Any

from tflab.clinic.archive import PatientSpec, patients
from tflab.clinic.causes import draw_numbers
from tflab.clinic.patient import FaultyRobot, rows_of
from tflab.clinic.table import SUSPECTS
from tflab.workbook.paths import TASKS, workbook_data
from tflab.workbook.tasks import Draws
from tflab.workbook.tasks.catalog import tasks_of
from tflab.workbook.tasks.generate_cases import PUBLIC_SEED, draws_for

STEM = "12_owners_and_diagnosis"
OF_EACH_CAUSE = 4


def main() -> None:
    """Write the patients."""
    shared = tasks_of(workbook_data(), STEM)["E12.7"].inputs.__globals__["draw_one_of_each"].__globals__  # draws.py
    by_spec: dict[str, list[Any]] = {}

    def made(specs: list[PatientSpec]) -> list[FaultyRobot]:
        found = patients(specs)
        names = map(shared["spec_name"], specs)
        by_spec.update(zip(names, map(rows_of, found), strict=True))
        return found

    shared["draw_one_of_each"](draws_for(PUBLIC_SEED, "E12.7", 0), made)
    text = json.dumps({"by cause": _by_cause(shared["cause_of"]), "by spec": by_spec}, ensure_ascii=False)
    path = workbook_data() / TASKS / STEM / "patients.json.xz"
    path.write_bytes(lzma.compress(text.encode(), preset=9))
    print(f"{path.name}: {path.stat().st_size:,} bytes")


def _by_cause(cause_of: Any) -> dict[str, list[list[Any]]]:
    """Return for each cause some patients whose readings fit it and no other."""
    rng, found = Draws(12), {cause: [] for cause in SUSPECTS}
    while missing := [cause for cause in SUSPECTS for _ in range(OF_EACH_CAUSE - len(found[cause]))]:
        made = patients([PatientSpec((cause,), draw_numbers(rng)) for cause in missing])
        for cause, patient in zip(missing, made, strict=True):
            if cause_of(patient) == cause:
                found[cause].append(rows_of(patient))
    return found


if __name__ == "__main__":
    main()
