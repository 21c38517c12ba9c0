"""A proof as an answer: checks that prove a diagnosis, judged beside it."""

from tflab.clinic.proof import find_flaw
from tflab.clinic.table import COMPLAINTS, SUSPECTS
from tflab.workbook.answers.forms import Choice, DiscriminatingCheck, Parts, Proof, form_from_plain
from tflab.workbook.answers.values import to_plain
from tflab.workbook.diagnosis.verdict import judge_outcomes
from tflab.workbook.tasks.case_types import Case

from .small_chapter import bare

FORM = Proof()
EXPECTED = {"tuple": ["laser clock ahead", ["delay /scan"]]}


def test_any_list_that_proves_the_true_suspect_is_right_and_guesses_are_none():
    for checks in (["delay /scan"], ["ros2 topic delay /scan"], ["hz /odom", "delay /scan"], EXPECTED):
        assert FORM.judge(checks, EXPECTED) == [True], checks
    everything = ["node list", "view_frames", "monitor", "delay /scan", "delay /odom", "hz /odom"]
    for checks in ([], everything, ["tape measure", "delay /scan"], ["laser clock ahead"], "delay /scan", None, [1]):
        assert FORM.judge(checks, EXPECTED) == [False], checks
    assert FORM.judge(["odometry slow", ["hz /odom"]], EXPECTED) == [False]  # it proves another suspect


def test_what_is_said_of_a_list_depends_on_the_cause_beside_it():
    said = FORM.remark(["hz /scan"], {"a cause": "laser clock ahead"})
    assert said.en.startswith("your checks give the same results for “laser clock ahead” and “transforms late”")
    assert FORM.remark(["hz /scan"], {"a cause": "gremlins"}).en.startswith("no check on the trolley proves the cause")
    assert "The rest, 4 min, adds nothing" in FORM.remark(["delay /scan", "monitor"], {"c": "laser clock ahead"}).en
    assert FORM.remark([], {"c": "laser clock ahead"}).en.startswith("without a check")
    assert (
        "these checks gave other results on this patient" in FORM.remark(["delay /scan"], {"c": "laser clock ahead"}).en
    )


ONE = Parts({"a cause": Choice((*SUSPECTS, "sensor broken")), "a checks": FORM})
PROVED = {"a cause": "laser clock ahead", "a checks": ("laser clock ahead", ["delay /scan"])}


def judged(cause, checks):
    answer = {"a cause": cause, "a checks": checks}
    return ONE.judge(to_plain(answer), to_plain(PROVED))


def test_beside_a_cause_a_list_proves_that_one_or_nothing():
    assert judged("laser clock ahead", ["delay /scan"]) == [True, True]
    assert judged("Laser clock ahead.", ["ros2 topic delay /scan"]) == [True, True]
    for cause in ("odometry slow", "sensor broken", "", None, 3):
        assert judged(cause, ["delay /scan"]) == [False, False], cause
    for odd in (True, float("nan"), 10**400, None, ["delay /scan"], "x-ray"):
        assert judged("laser clock ahead", ["delay /scan", odd]) == [True, False], odd


def test_a_list_that_proves_two_of_three_suspects_earns_nothing_without_a_name():
    both = ["hz /odom"]
    proved = [suspect for suspect in COMPLAINTS["flickers"].suspects if find_flaw(both, suspect) is None]
    assert proved == ["transforms late", "odometry slow"]
    for guess in (*proved, "laser clock ahead", "sensor broken", None):
        bound = FORM.beside(both, {"a cause": guess})
        right = [suspect for suspect in proved if FORM.judge(bound, {"tuple": [suspect, both]}) == [True]]
        assert right == ([guess] if guess in proved else [])


def test_what_is_said_of_checks_is_of_the_patient_whose_they_are():
    cause = Choice(("localizer waits for /clock", "odometry slow", "sensor broken"))
    form = Parts({"a cause": cause, "a checks": FORM, "c cause": cause, "c checks": FORM})
    right = {
        "a cause": "localizer waits for /clock", "a checks": ["use_sim_time"],
        "c cause": "odometry slow", "c checks": ["hz /odom"],
    }  # fmt: skip
    task, variant = bare(form, Case(None, to_plain(right), {}))
    said = judge_outcomes(task, variant, [to_plain(right | {"c checks": ["tape measure", "hz /odom"]})])
    assert "16 of 12 minutes" in str(said)
    said = judge_outcomes(task, variant, [to_plain(right | {"c checks": ["delay /scan"]})])
    assert "“odometry slow” and “transforms late”" in str(said)
    said = judge_outcomes(task, variant, [to_plain(right | {"c cause": "sensor broken", "c checks": ["delay /scan"]})])
    assert "localizer" not in str(said)


def test_any_cheap_check_that_two_suspects_answer_differently_tells_them_apart():
    options = ("hz /odom", "hz /scan", "scan header", "monitor", "tape measure", "no check")
    form = DiscriminatingCheck(options, ("odometry slow", "scan slow"))
    assert [form.judge(check, "hz /odom") for check in options] == [[True], [True], [False], [False], [False], [False]]
    said = {check: form.remark(check, {}) for check in options}
    assert said["scan header"].en == "It gives the same result for both of these."
    assert said["monitor"].en == "It would distinguish these two, but it takes 4 minutes, and 2 are allowed."
    assert said["hz /odom"] is said["tape measure"] is said["no check"] is None
    for each in (form, Proof(whole=True)):
        assert form_from_plain(each.plain()) == each
