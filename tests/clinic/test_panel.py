"""The panel is the same visit: a question costs its minutes, and the table fills."""

from tflab.clinic.panel import clinic_panel, columns_for
from tflab.clinic.practice import worked_patient
from tflab.clinic.table import COMPLAINTS


def test_a_panel_asks_what_is_chosen_and_the_table_follows():
    panel = clinic_panel(worked_patient("laser clock ahead"))
    panel._check.value = "delay /scan"
    panel.ask()
    assert panel.visit.minutes == 1
    assert panel.text.startswith("1 min; 11 of 12 left. Your suspects: laser clock ahead\n1 of 3 suspects left")
    assert "-0." in panel._readings.value
    panel.close()


def test_the_columns_are_the_checks_that_can_tell_the_suspects_apart():
    columns = columns_for(COMPLAINTS["flickers"].suspects)
    assert "delay /scan" in columns and "hz /scan" not in columns and "tape measure" not in columns
