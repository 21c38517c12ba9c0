"""A visit becomes rows: the door, what was asked, and what was tried."""

import pytest

from tflab.clinic.patient import SickRobot
from tflab.clinic.practice import worked_patient
from tflab.clinic.steps import steps_of
from tflab.clinic.visit import Visit


@pytest.fixture(scope="module")
def ahead():
    return worked_patient("laser clock ahead")


def test_each_question_and_each_fix_is_a_row_and_the_readings_strike(ahead, capsys):
    visit = Visit(ahead, "ko")
    visit.take("node list")
    visit.take("delay /scan")
    for fix in ("timeout of 1 s", "set the laser's clock"):
        visit.say("laser clock ahead", fix=fix)
        visit.try_fix()
    door, nodes, delay, plaster, cure = steps_of(visit)
    assert (door.said, len(door.left)) == ("extrapolation into the future", 3)
    assert (nodes.name, nodes.said, len(nodes.left)) == ("node list", "as on the card", 3)
    assert delay.said.startswith("-0.") and delay.beside == "card: 0.105 s, std dev 0.000 s"
    assert delay.left == plaster.left == cure.left == ("laser clock ahead",)
    assert plaster.is_fix and plaster.said.startswith("RViz all Ok, scan up to 0.")
    assert plaster.beside == f"delay /scan: {delay.said}" and cure.beside == "delay /scan: 0.105 s, std dev 0.000 s"
    far, near = (float(step.said.split("up to ")[1].split(" m")[0]) for step in (plaster, cure))
    assert far > 3 * near


def test_a_fix_that_was_refused_is_no_row(ahead, capsys):
    visit = Visit(ahead)
    visit.say("laser clock ahead", fix="set the laser's clock")
    visit.try_fix()
    assert len(steps_of(visit)) == 1


def test_one_who_does_not_complain_has_nothing_at_the_door_and_eighteen_suspects():
    silent = SickRobot("", "", 12.0, {"use_sim_time": (1.0, "Boolean value is: True", "True")}, {})
    visit = Visit(silent)
    visit.take("use_sim_time")
    door, asked = steps_of(visit)
    assert (door.name, door.said, len(door.left)) == ("it does not work", "", 18)
    assert asked.left == ("localizer waits for /clock",)
