"""A proof as an answer: judged without knowing the diagnosis, sealed like any other."""

from tflab.workbook.answers import sealed
from tflab.workbook.answers.forms import Proof, form_from_plain

FORM = Proof()
EXPECTED = {"tuple": ["laser clock ahead", ["delay /scan"]]}


def test_any_list_that_proves_the_true_suspect_is_right():
    for checks in (["delay /scan"], ["ros2 topic delay /scan"], ["hz /odom", "delay /scan"], EXPECTED):
        assert FORM.judge(checks if isinstance(checks, list | dict) else [checks], EXPECTED) in ([True],), checks


def test_guesses_shotguns_and_echoes_are_no_proof():
    everything = ["node list", "view_frames", "monitor", "delay /scan", "delay /odom", "hz /odom"]
    for checks in ([], everything, ["tape measure", "delay /scan"], ["laser clock ahead"], "delay /scan", None, [1]):
        assert FORM.judge(checks, EXPECTED) == [False], checks


def test_whoever_claims_another_suspect_proves_that_one():
    assert FORM.judge(["odometry slow", ["hz /odom"]], EXPECTED) == [False]


def test_a_sealed_proof_tells_no_suspect():
    kept = sealed.seal(FORM, EXPECTED, "salt")
    assert "laser" not in str(kept)
    assert sealed.judge(FORM, ["delay /scan"], kept) == [True]
    assert sealed.judge(FORM, ["hz /odom"], kept) == [False]


def test_what_is_said_of_a_list_depends_on_the_cause_beside_it():
    said = FORM.remark(["hz /scan"], {"a cause": "laser clock ahead"})
    assert said.en.startswith("your checks say the same for “laser clock ahead” and “transforms late”")
    assert FORM.remark(["hz /scan"], {"a cause": "gremlins"}) is None
    assert "the other 4 min tell nothing" in FORM.remark(["delay /scan", "monitor"], {"c": "laser clock ahead"}).en
    assert FORM.remark(["delay /scan"], {"c": "laser clock ahead"}) is None


def test_the_form_comes_back_from_json():
    assert form_from_plain(Proof(whole=True).plain()) == Proof(whole=True)
