"""The panel is the same visit: a question costs its minutes, the table fills, and a fix is tried on a proof."""

import re

from tflab.clinic.checks import CHECKS
from tflab.clinic.panel import LABELS, clinic_panel, columns_for
from tflab.clinic.table import COMPLAINTS


def test_a_panel_asks_what_is_chosen_and_the_table_and_the_clock_follow(ahead):
    panel = clinic_panel(ahead)
    panel._check.value = "delay /scan"
    panel.ask()
    assert panel.visit.minutes == 1 and panel._clock.value == 11
    assert panel.text.startswith("1 min; 11 of 12 left. Your suspects: laser clock ahead\n1 of 3 suspects left")
    assert panel.text.endswith("1. delay /scan: 1 min, 1 in all, 1 left  one suspect left")
    assert "-0." in panel._readings.value and panel._order.layout.display == "block"
    assert panel._readings.value.count("11 of 12 left") == 1
    panel._check.value = "tape measure"
    panel.ask()
    assert (panel._clock.value, panel._clock.bar_style) == (0, "danger")
    panel.close()


def test_a_panel_tries_a_fix_on_a_proof_and_not_on_a_suspicion(ahead):
    panel = clinic_panel(ahead)
    panel.try_fix()
    assert "First make a diagnosis" in panel._readings.value
    panel._cause.value, panel._fix.value = "laser clock ahead", "set the laser's clock"
    panel.try_fix()
    assert "is a guess" in panel._readings.value and not panel.visit.tried
    panel._check.value = "delay /scan"
    panel.ask()
    panel.try_fix()
    assert "RViz: all Ok" in panel._readings.value and len(panel.visit.tried) == 1
    panel.close()


def test_in_korean_only_names_and_what_is_typed_are_english(ahead, tmp_path, monkeypatch):
    (tmp_path / "workbook.json").write_text('{"language": "ko"}', encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    panel = clinic_panel(ahead)
    assert LABELS["ko"].keys() == LABELS["en"].keys() and panel.widget.children[-3].description == "글로 보기"
    done = [label for label, _ in panel._check.options if not label.startswith("ros2 ")]
    assert len(done) == 3 and not re.search(r"[A-Za-z]{5}", " ".join(done).replace("RViz", ""))
    assert all(label.endswith("분)") for label, _ in panel._check.options)
    panel.close()


def test_on_an_exported_page_it_shows_what_each_check_would_say(ahead):
    panel = clinic_panel(ahead)
    _, film = panel.film().children
    assert len(film.texts) == len(CHECKS)
    at = film.texts.index("ros2 topic delay /scan (1 min)")
    assert "average delay: -0." in film.words[at] and "1 of 3 suspects left" in film.words[at]
    assert panel.visit.log == []
    panel.close()


def test_the_columns_are_the_checks_that_can_tell_the_suspects_apart():
    columns = columns_for(COMPLAINTS["flickers"].suspects)
    assert "delay /scan" in columns and "hz /scan" not in columns and "tape measure" not in columns
