"""Nothing that a learner holds tells a cause at a glance: not a patient, nor a visit, nor what a task gives."""

from __future__ import annotations

import io
import json
import pickle
from contextlib import redirect_stdout

import pytest

from tflab.clinic.patient import FaultyRobot
from tflab.clinic.practice import worked_patient
from tflab.clinic.table import SUSPECTS
from tflab.clinic.visit import admit
from tflab.workbook.paths import Workbook, workbook_data
from tflab.workbook.tasks.catalog import assigned_cases


@pytest.fixture(scope="module")
def patient():
    return worked_patient("mount wrong")


def named_in(text):
    return [suspect for suspect in SUSPECTS if suspect in text]


def test_no_name_of_a_cause_stands_in_a_patient(patient):
    held = [repr(patient), str(vars(patient)), " ".join(dir(patient)), str(pickle.dumps(patient)), patient.packed()]
    assert [named_in(text) for text in held] == [[]] * 5


def test_what_a_fix_leads_to_and_what_a_check_says_is_not_to_be_had_from_a_patient_by_looking_at_it(patient):
    # the one fix that changes what is seen is the cure, so a list of all that is seen after fixes would be the answer
    assert {name for name in dir(patient) if not name.startswith("_")} == {
        "ask", "asked", "budget_min", "complaint", "fixes", "minutes", "packed", "reading", "screen", "unpacked",
        "verdict",
    }  # fmt: skip
    assert "Translation" not in str(vars(patient)) and "beside the walls\n" not in str(vars(patient))


def test_a_patient_without_a_complaint_shows_no_screen_that_nobody_paid_for(patient):
    silent = FaultyRobot("", patient.screen, 12.0, {"rviz": (1.0, patient.screen, "all Ok")}, {})
    assert silent.screen == "" and silent.ask("rviz") == "all Ok" and silent.minutes == 1


def test_a_visit_names_all_suspects_of_the_complaint_and_none_before_the_others(patient):
    with redirect_stdout(io.StringIO()) as printed:
        visit = admit(patient)
    three = ["mount wrong", "header says base_link", "laser clock behind"]
    assert named_in(printed.getvalue()) == three and named_in(str(vars(visit))) == three
    assert visit.diagnosis == {} and visit.log == []


def test_a_task_gives_its_patients_without_their_causes():
    (variant,) = assigned_cases(workbook_data(), "12_owners_and_diagnosis", "E12.4", Workbook()).variants
    assert named_in(json.dumps(variant.cases[0].expected)) != []
    assert named_in(json.dumps(variant.given)) == []
