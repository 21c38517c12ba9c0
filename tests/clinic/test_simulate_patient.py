"""What every tool says of a sick robot is what the table says of its cause."""

import numpy as np
import pytest

from tflab.clinic.causes import CAUSES, HEALTHY, Numbers, draw_numbers
from tflab.clinic.checks import CHECKS
from tflab.clinic.fixes import EFFECTIVE_FIXES
from tflab.clinic.patient import result_of_fix
from tflab.clinic.proof import consistent_suspects
from tflab.clinic.simulate_patient import ExaminedRobot, make_patient
from tflab.clinic.table import COMPLAINTS, SUSPECTS

pytestmark = pytest.mark.proof  # a robot for each cause


def found_in(patient):
    return {key: check.kind(patient.ask(key)) for key, check in CHECKS.items()}


@pytest.fixture(scope="module")
def patients(sample):
    chosen = {"laser clock ahead", "mount volatile", *sample(CAUSES, 3)}
    return {
        cause: make_patient([cause], draw_numbers(np.random.default_rng([3, i])))
        for i, cause in enumerate(CAUSES)
        if cause in chosen
    }


def test_the_causes_are_the_suspects():
    assert tuple(CAUSES) == SUSPECTS
    assert sorted(cause for causes in EFFECTIVE_FIXES.values() for cause in causes) == sorted(SUSPECTS)


def test_a_patients_findings_fit_its_cause_and_no_other_and_do_not_name_it(patients):
    for cause, patient in patients.items():
        assert consistent_suspects(found_in(patient)) == (cause,)
        texts = [patient.screen, *(patient.reading(key)[1] for key in CHECKS)]
        assert not [suspect for suspect in SUSPECTS for text in texts if suspect in text]


def test_every_reading_of_a_healthy_robot_is_as_on_the_card_and_leaves_no_file(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    with ExaminedRobot(HEALTHY, Numbers()) as well:
        screen = well.screen()
        kinds = {key: check.kind(well.ask(key, screen)[1]) for key, check in CHECKS.items()}
    assert kinds == {key: check.usual for key, check in CHECKS.items()}
    assert list(tmp_path.iterdir()) == []


def test_a_tools_terminal_shows_no_log_of_the_robots_nodes(patients):
    text = patients["mount volatile"].reading("echo base_link laser_frame")[1]
    assert "[transform_listener_impl_55" in text  # the listener's own warning stands in its terminal
    assert "[laser_mount]" not in text  # the mount's stands where the mount was launched


def test_the_right_fix_makes_the_robot_well_and_others_do_not(patients):
    for cause, patient in patients.items():
        cure = next(fix for fix, causes in EFFECTIVE_FIXES.items() if cause in causes)
        well = result_of_fix(patient, cure)[1]
        assert "RViz: all Ok" in well or cause in ("localizer owns the base", "nothing is wrong")
        if cause not in ("two owners of one edge", "nothing is wrong"):
            assert result_of_fix(patient, "new sensor")[1] != well


def test_the_screen_shows_what_the_operator_complains_of(patients):
    said = {
        "no map": "Fixed Frame: Frame [",
        "no robot": "No transform from [base_footprint]",
        "flickers": "extrapolation into the future",
        "no scan": "For frame [",
    }
    for cause, patient in patients.items():
        complaint = next(key for key, each in COMPLAINTS.items() if cause in each.suspects)
        assert patient.complaint == complaint
        assert said.get(complaint, "") in patient.screen


def test_the_same_numbers_make_the_same_patient(patients):
    again = make_patient(
        ["laser clock ahead"], draw_numbers(np.random.default_rng([3, SUSPECTS.index("laser clock ahead")]))
    )
    assert again.packed() == patients["laser clock ahead"].packed()


def test_two_causes_show_the_first_one_first():
    patient = make_patient(["localizer not running", "mount wrong"], Numbers())
    assert patient.complaint == "no map"
    after = result_of_fix(patient, "start localization")[1]
    assert "RViz: all Ok" in after and float(after.split("up to ")[1].split(" m")[0]) > 0.12
