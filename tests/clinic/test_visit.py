"""A visit costs minutes, keeps a list of suspects, and repairs nothing on a suspicion."""

from itertools import product

import pytest

from tflab.clinic.causes import Numbers
from tflab.clinic.checks import CHECKS
from tflab.clinic.examples import EXAMPLES
from tflab.clinic.patient import NOTES, FaultyRobot, translate_output
from tflab.clinic.practice import answer_of, practice_patient, second_opinion, two_fault_patient, worked_patient
from tflab.clinic.proof import consistent_suspects, shortest_proof
from tflab.clinic.simulate_patient import doctor_report
from tflab.clinic.table import COMPLAINTS, SENSOR_BROKEN, SUSPECTS, expected_kind
from tflab.clinic.visit import TEXTS, Visit, admit
from tflab.text import LANGUAGES


@pytest.fixture
def visit(ahead, capsys):
    visit = admit(ahead)
    capsys.readouterr()
    return visit


def test_at_the_door_one_hears_the_complaint_the_screen_the_card_and_the_budget(ahead, capsys):
    admit(ahead)
    printed = capsys.readouterr().out
    assert "The scan flickers" in printed and "extrapolation into the future" in printed
    assert TEXTS["card"].en in printed and "You have 12 minutes." in printed
    assert "Transform OK" not in printed  # what is Ok is folded


def test_each_question_takes_its_minutes_also_when_it_was_asked_before(visit, capsys):
    visit.ask("ros2 topic delay /scan", because="laser clock ahead")
    printed = capsys.readouterr().out
    assert printed.startswith("$ ros2 topic delay /scan\naverage delay: -0.")
    assert "1 min; 11 of 12 left." in printed and "asked this before" not in printed
    visit.ask("delay /scan", because="I forgot")
    assert "You made this check before" in capsys.readouterr().out and visit.minutes == 2
    visit.ask("tape measure")
    assert "17 min; the time is up, 5 minutes over." in capsys.readouterr().out
    assert [asked.check for asked in visit.log] == ["delay /scan", "delay /scan", "tape measure"]
    assert visit.log[0].because == "laser clock ahead"


def test_suspects_are_struck_by_oneself_unless_the_table_helps(visit, ahead, capsys):
    visit.take("delay /scan")
    assert len(visit.suspects) == 3
    visit.rule_out("odometry slow")
    assert visit.suspects == ("laser clock ahead", "transforms late")
    helped = admit(ahead, helped=True)
    helped.take("delay /scan")
    assert helped.suspects == ("laser clock ahead",)


def test_no_fix_is_tried_on_a_suspicion(visit, capsys):
    def refusal(cause):
        visit.say(cause, fix="set the laser's clock")
        said = capsys.readouterr().out
        visit.try_fix()
        tried = capsys.readouterr().out
        assert said == tried or said.startswith("Your results prove")
        return tried

    visit.try_fix()
    assert capsys.readouterr().out.startswith("First make a diagnosis")
    assert refusal("laser clock ahead").startswith("You have made no check yet")
    visit.take("hz /scan")
    assert 'fit "laser clock ahead", and 2 more. What would `ros2 topic hz /odom` print' in refusal("laser clock ahead")
    visit.take("hz /odom")
    assert "as on the card. First show a result that differs from it: `ros2 topic delay /scan`" in refusal(
        "laser clock ahead"
    )
    visit.take("delay /scan")
    assert 'If "transforms late" were the cause, `ros2 topic hz /odom` would not print' in refusal("transforms late")
    assert "RViz: all Ok" in refusal("laser clock ahead")


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("truth", SUSPECTS)
def test_a_wrong_diagnosis_is_told_a_check_and_not_the_cause(truth, language, capsys):
    own = next(key for key, each in COMPLAINTS.items() if truth in each.suspects)
    finding = {key: EXAMPLES[key][expected_kind(truth, key)] for key in CHECKS}
    evidence = {key: (check.minutes, finding[key], finding[key]) for key, check in CHECKS.items()}
    after = ([], ["hz /scan"], shortest_proof(truth), list(CHECKS))
    others = [each for each in (*SUSPECTS, SENSOR_BROKEN) if each != truth]
    for complaint, asked, wrong in product((own, ""), after, others):
        visit = Visit(FaultyRobot(complaint, "", 12.0, evidence, {}), language)
        for check in asked:
            visit.take(check)
        visit.say(wrong)
        said = capsys.readouterr().out
        assert [check for check in CHECKS.values() if f"`{check.instruction(language)}`" in said], said
        assert truth not in said and TEXTS["noted"].say(language) not in said


@pytest.mark.parametrize(
    ("tell", "error"),
    [
        (lambda visit: visit.ask("delay /scn"), '"delay /scn" is not on the trolley; did you mean "delay /scan"[?]'),
        (lambda visit: visit.ask("DELAY /Scan"), 'did you mean "delay /scan"[?] There is rviz, node list'),
        (lambda visit: visit.ask("ros2 topic delay /scam"), 'did you mean "ros2 topic delay /scan"[?]'),
        (lambda visit: visit.ask(["delay /scan"]), 'did you mean "delay /scan"[?]'),
        (lambda visit: visit.ask(None), '"None" is not on the trolley; there is rviz'),
        (
            lambda visit: visit.ask("delay /scan", "hz /scan"),
            'one check at a time: first "delay /scan", then "hz /scan"',
        ),
        (lambda visit: visit.say("gremlins"), '"gremlins" is no suspect; there is localizer not running'),
        (lambda visit: visit.say("laser clock ahead", fix="hope"), '"hope" is no fix; there is start localization'),
        (lambda visit: visit.say("Laser clock ahead"), 'did you mean "laser clock ahead"[?] There is localizer not'),
        (lambda visit: visit.say({"laser clock ahead"}), 'is no suspect; did you mean "laser clock ahead"[?]'),
        (
            lambda visit: visit.say("laser clock ahead", frame="laser"),
            '"laser" is no frame; did you mean "laser_frame"',
        ),
        (
            lambda visit: visit.say("laser clock ahead", owner="Laser driver"),
            'is no owner; did you mean "laser_driver"[?]',
        ),
        (lambda visit: visit.say("laser clock ahead", fix="Set the laser's clock"), 'mean "set the laser\'s clock"[?]'),
        (lambda visit: visit.try_fix("Timeout of 1s"), 'did you mean "timeout of 1 s"[?]'),
        (lambda visit: visit.rule_out("odometry slo"), 'did you mean "odometry slow"[?]'),
    ],
)
def test_what_is_misspelt_is_refused_with_what_is_near_and_costs_nothing(visit, tell, error):
    visit.take("hz /scan")
    with pytest.raises(ValueError, match=error):
        tell(visit)
    assert (visit.minutes, len(visit.suspects), visit.diagnosis, visit.tried) == (1, 3, {}, [])


@pytest.mark.parametrize("typed", ["%ros2 topic info /tf -v", "$ ros2 topic info /tf --verbose", "`topic info /tf -v`"])
def test_a_command_may_be_asked_as_it_is_typed_on_a_page_or_in_a_shell(visit, typed):
    visit.take(typed)
    assert visit.log[-1].check == "info /tf"


def test_the_sensor_may_be_named_and_its_messages_speak_for_it(visit, capsys):
    visit.say("sensor broken")
    assert capsys.readouterr().out.startswith("You have made no check yet")  # and not that it was struck before
    visit.take("hz /scan")
    visit.say("sensor broken", fix="new sensor")
    assert (
        'If "sensor broken" were the cause, `ros2 topic hz /scan` would not print: 10.0 Hz' in capsys.readouterr().out
    )


def test_a_fix_may_be_named_when_it_is_tried(visit, capsys):
    visit.take("delay /scan")
    visit.try_fix("set the laser's clock")
    assert capsys.readouterr().out.startswith("First make a diagnosis")
    visit.say("laser clock ahead")
    visit.try_fix()
    assert capsys.readouterr().out.count("Now choose a fix: `fixes()` prints the list") == 2
    assert len(visit.tried) == 0
    visit.fixes()
    fixes = capsys.readouterr().out.splitlines()
    assert "set the laser's clock" in fixes and "stamp on arrival" in fixes and len(fixes) == 21
    visit.try_fix("set the laser's clock")
    assert "RViz: all Ok" in capsys.readouterr().out


@pytest.mark.parametrize("number", [-1, 7.5, "7", None, True])
def test_patients_go_by_whole_numbers(number):
    for make in (practice_patient, two_fault_patient, answer_of):
        with pytest.raises(ValueError, match="patients have whole numbers: 0, 1, 2 and so on, not"):
            make(number)
    with pytest.raises(ValueError, match=r'"clock ahead" is no cause; did you mean "laser clock ahead"\?'):
        worked_patient("clock ahead")
    with pytest.raises(TypeError, match="a patient is needed, such as practice_patient"):
        admit("a robot")


@pytest.mark.proof
def test_a_practice_patient_is_the_same_wherever_it_is_made():
    assert practice_patient(5).packed() == practice_patient(5).packed()
    assert answer_of(5, "jumps") in ("two owners of one edge", "localizer owns the base", "nothing is wrong")
    with pytest.raises(ValueError, match='"tired" is no complaint; there is no map'):
        practice_patient(5, "tired")


@pytest.mark.proof
def test_the_doctor_has_a_word_on_fourteen_robots_and_not_on_those_that_somebody_may_have_wanted_so(sample):
    wanted = {"Fixed Frame misspelt", "mount wrong", "header says base_link", "nothing is wrong"}
    for cause in sample(SUSPECTS, 4):
        line = doctor_report([cause], Numbers()).splitlines()[0]
        assert (line == "graph: nothing is wrong") == (cause in wanted), cause


def test_a_practice_patient_fits_its_cause_and_no_other_also_where_the_first_numbers_do_not():
    assert answer_of(6, "flickers") == "odometry slow"  # with the first numbers drawn RViz never speaks of the future
    visit = Visit(practice_patient(6, "flickers"))
    for check in CHECKS:
        visit.take(check)
    assert consistent_suspects(visit.found) == ("odometry slow",) and "into the future" in visit.patient.screen
    assert answer_of(7) == "localizer not running"
    assert 'Messages are in the frame "map", which nobody publishes' in second_opinion(7)


def test_who_asks_pays_and_a_fresh_copy_has_paid_nothing(ahead):
    patient = FaultyRobot.unpacked(ahead.packed())
    assert patient.ask("delay /scan").startswith("-0.")
    patient.ask("view_frames")
    assert (patient.asked, patient.minutes) == (("delay /scan", "view_frames"), 4)
    assert FaultyRobot.unpacked(patient.packed()).asked == ()
    assert patient.verdict("laser clock ahead", "laser_frame") == {
        "cause": "laser clock ahead",
        "frame": "laser_frame",
        "proof": ["laser clock ahead", ["delay /scan", "view_frames"]],
    }


# -- in Korean -----------------------------------------------------------------


def test_commands_are_the_same_in_korean_and_what_is_done_by_hand_is_translated():
    by_hand = {check.key for check in CHECKS.values() if check.instruction("ko") != check.command}
    assert by_hand == {check.key for check in CHECKS.values() if not check.command.startswith("ros2 ")}


def test_notes_are_translated_and_what_a_tool_printed_is_not():
    text = "RViz: all Ok\nScan on the map: up to 0.47 m beside the walls\n$ ros2 topic delay /scan\n  average delay: 1"
    assert translate_output(text) == text
    assert translate_output(text, "ko").splitlines() == [
        "RViz: 모두 Ok", "지도 위의 스캔: 벽에서 최대 0.47 m 벗어남", "$ ros2 topic delay /scan", "  average delay: 1",
    ]  # fmt: skip
    for note in NOTES.values():
        blanks = dict.fromkeys(("distance", "ahead", "side", "up"), "0.20")
        assert translate_output(note.en.format(**blanks), "ko") == note.ko.format(**blanks)
