"""What `check` replies to whole answers of chapters 1 to 4: what is wrong with them, and nothing untrue."""

from __future__ import annotations

import math
from functools import partial

import pytest

from tflab.core import ConnectivityException, Transform
from tflab.ros.time import Time
from tflab.workbook.diagnosis.mistake import Mistake

from .whole_answers import mistakes_of, verdict_on

# -- chapter 1 ------------------------------------------------------------------------


def reader(age_s, *, is_old=lambda age, limit: age > limit, is_ahead=lambda age: age < 0):
    """Return a reader that takes this for the age; it looks at all that it is asked to."""

    def judge(message, now, max_age_s):
        stamp = message.header.stamp
        if not message.header.frame_id:
            return "no frame"
        if stamp.sec == 0 and stamp.nanosec == 0:
            return "no stamp"
        age = age_s(stamp, now)
        return "from the future" if is_ahead(age) else "too old" if is_old(age, max_age_s) else "use it"

    return judge


def exact(stamp, now):
    return (now.nanoseconds - Time.from_msg(stamp).nanoseconds) / 1e9


@pytest.mark.parametrize(
    ("judge", "mistakes"),
    [
        (reader(exact, is_old=lambda age, limit: round(age - limit, 10) > 0), []),
        (reader(lambda stamp, now: now.nanoseconds // 10**9 - stamp.sec, is_old=lambda age, limit: age >= limit),
         ["whole seconds", "already at the bound"]),
        (reader(exact, is_old=lambda age, limit: False), ["no look back"]),
    ],
)  # fmt: skip
def test_a_reader_is_told_what_its_verdicts_show(judge, mistakes):
    assert mistakes_of("E1.3", judge) == mistakes


def on_arrival(given, age_s):
    return {"age_s": age_s, "ahead_m": given.ahead_m - given.speed_mps * age_s}


@pytest.mark.parametrize(
    ("age", "mistake"),
    [
        (lambda s, a: abs(a[1] - s[1]) / 1e9, "nanosec alone, without sign"),
        (lambda s, a: a[0] - s[0] + (s[1] - a[1]) / 1e9, "without borrowing"),
    ],
)
def test_an_age_is_told_by_what_went_into_it(age, mistake):
    verdict = verdict_on("E1.4", lambda given: on_arrival(given, age(given.stamp, given.arrived)))
    assert list(verdict.mistakes) == [mistake]
    assert "below zero" not in verdict.said.en or mistake != "nanosec alone, without sign"


# -- chapter 2 ------------------------------------------------------------------------


SIGNS = {"angular_z_turning_left": "positive", "pitch_nose_down": "positive", "y_right_in_base_link": "negative",
         "x_right_in_optical_frame": "positive", "y_above_in_optical_frame": "negative"}  # fmt: skip


@pytest.mark.parametrize(
    ("turned", "mistakes"),
    [
        (("angular_z_turning_left", "y_right_in_base_link"), ["left hand"]),
        (("angular_z_turning_left", "y_above_in_optical_frame"), ["compass", "y up in the picture"]),
    ],
)
def test_signs_that_come_of_one_thought_are_told_it_together(turned, mistakes):
    other = {"positive": "negative", "negative": "positive"}
    signs = {name: other[sign] if name in turned else sign for name, sign in SIGNS.items()}
    assert mistakes_of("E2.1", lambda given: signs) == mistakes


@pytest.mark.parametrize(
    ("places", "mistakes"),
    [
        (lambda x, y, z: (x, z, y), ["places and signs"]),
        (lambda x, y, z: (math.sqrt(z * z - x * x - y * y), -x, -y), ["depth of a ray"]),
        (lambda x, y, z: (z, -x, -y), []),
    ],
)
def test_numbers_of_the_picture_in_other_places_are_told_by_their_places(places, mistakes):
    assert mistakes_of("E2.2", lambda given: places(*given.optical_p_part)) == mistakes


def about_z(z, w):
    return (0.0, 0.0, z, w)


@pytest.mark.parametrize(
    ("of_yaw", "mistakes"),
    [
        (lambda yaw: about_z(math.sqrt((1 - math.cos(yaw)) / 2), math.sqrt((1 + math.cos(yaw)) / 2)),
         ["no sign at all"]),
        (lambda yaw: about_z(abs(math.sin(yaw / 2)), math.cos(yaw / 2)), ["never to the right"]),
        (lambda yaw: about_z(math.sin(yaw / 2), math.cos(yaw / 2)) if yaw else (0.0,) * 4, ["zeros for no turn"]),
    ],
)  # fmt: skip
def test_a_quaternion_of_a_yaw_is_told_what_became_of_its_signs_and_halves(of_yaw, mistakes):
    assert mistakes_of("E2.3", of_yaw) == mistakes


def customs(
    *,
    is_first=lambda q: max(abs(q[0]), abs(q[1])) > 0.1,
    length=lambda q: math.hypot(*q),
    zero=1e-6,
    off=0.01,
    finite=all,
):
    """Return a judge of quaternions that asks the four questions in their order."""

    def judge(q):
        if not finite(map(math.isfinite, q)):
            return "nan"
        if length(q) < zero:
            return "zero"
        if abs(length(q) - 1.0) > off:
            return "not unit"
        return "w first" if is_first(q) else "ok"

    return judge


def scaled_first(q):
    length = math.hypot(*q)
    return customs()([part / length for part in q] if 1e-6 <= length < math.inf else q)


@pytest.mark.parametrize(
    ("judge", "mistakes"),
    [
        (customs(), []),
        (customs(is_first=lambda q: abs(q[0]) > abs(q[3])), ["x over w"]),
        (customs(is_first=lambda q: max(abs(q[0]), abs(q[1])) > abs(q[3])), ["x or y over w"]),
        (scaled_first, ["scaled first"]),
        (customs(is_first=lambda q: max(abs(q[0]), abs(q[1])) >= 0.1), ["at the bound"]),
        (customs(off=math.inf, is_first=lambda q: False), ["nan and zero alone"]),
        (customs(is_first=lambda q: abs(q[0] and q[1]) > 0.1), ["x and y in Python"]),
        (lambda q: customs()(q) if all(map(math.isfinite, q[:3])) else "nan", []),
    ],
)
def test_an_officer_is_told_which_question_is_another(judge, mistakes):
    assert mistakes_of("E2.4", judge) == mistakes


def test_a_verdict_that_is_never_returned_is_told_by_its_name():
    verdict = verdict_on("E2.4", lambda q: None if customs()(q) == "ok" else customs()(q))
    assert verdict.mistake is Mistake.SOMETIMES_NOTHING
    assert 'The branch for "ok" has no `return`' in verdict.detail["certain"].en


def test_a_verdict_that_is_raised_is_told_to_be_returned():
    def judge(q):
        if customs()(q) == "nan":
            raise ValueError("nan")
        return customs()(q)

    assert '`return "nan"`' in verdict_on("E2.4", judge).detail["tip"].en


def test_a_bound_of_one_call_is_not_told_of_all():
    def by_parts(yaw):
        half = yaw / 2 if yaw > 0 else 0.7 * yaw / 2 + 0.1
        return about_z(math.sin(half), math.cos(half))

    verdict = verdict_on("E2.3", by_parts)
    assert verdict.said is None and verdict.detail["certain"].en.startswith("in the call below: off by at most")


def test_the_angles_of_the_right_turn_are_no_quaternion():
    def angles(given):
        pitch, yaw = Transform.from_rpy(pitch=given.then_pitch_rad), Transform.from_rpy(yaw=given.first_yaw_rad)
        return (pitch @ yaw).rpy()

    assert mistakes_of("E2.5", lambda given: (*angles(given), 1.0)) == ["angles for a quaternion"]
    three = verdict_on("E2.5", angles)
    assert three.mistake is Mistake.SHAPE and "from `.rpy()`" in three.detail["tip"].en
    for row, said in (
        ([[0.0, 0.0, 0.0, 1.0]] * 2, "several rows of numbers"),
        ([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], "That is a matrix"),
        ([0.0, 0.0, 0.0, 1.0] * 2, "`+` between two lists"),
    ):
        assert said in verdict_on("E2.5", lambda given, row=row: row).detail["tip"].en


# -- chapters 3 and 4 -----------------------------------------------------------------


@pytest.mark.parametrize("same", ["base_link", "map"])
def test_a_pair_of_the_same_name_twice_is_not_called_the_wrong_way_round(same):
    calls = {"a": ["map", "laser_frame"], "b": [same, same], "c": ["base_link", "camera_link"],
             "d": ["laser_frame", "base_link"]}  # fmt: skip
    assert mistakes_of("E3.1", lambda given: calls) == [f"b[{int(same == 'base_link')}]: {same}"]


@pytest.mark.parametrize(
    ("node", "said"),
    [
        (" Node_B ", None),
        (["node_b", "node_c"], "Give exactly one of them"),
    ],
)
def test_a_node_is_read_as_it_is_meant_and_one_alone_is_asked_for(node, said):
    answer = {
        "node": node,
        "robot": "drives to another place",
        "hidden_while": "it stands on the map's origin, not turned",
    }
    verdict = verdict_on("E3.7", lambda given: answer)
    assert (verdict.detail["tip"].en if said else verdict.mistake) == said


def test_a_first_pose_that_is_not_turned_still_has_its_step():
    def joined(one, two):
        if one["yaw"] == 0.0:
            return two
        c, s = math.cos(one["yaw"]), math.sin(one["yaw"])
        x, y = one["x"] + c * two["x"] - s * two["y"], one["y"] + s * two["x"] + c * two["y"]
        return {"x": x, "y": y, "yaw": one["yaw"] + two["yaw"]}

    assert verdict_on("E3.4", joined).mistake is not None


def test_a_path_that_was_reversed_is_told_apart_from_one_that_goes_up_to_the_root():
    def climbed(parent_of, frame):
        return [frame, *climbed(parent_of, parent_of[frame])] if frame in parent_of else [frame]

    def path(parent_of, target, source, *, to_the_root=False):
        up, down = climbed(parent_of, source), climbed(parent_of, target)
        if up[-1] != down[-1]:
            raise ConnectivityException("two trees")
        top = next(frame for frame in up if frame in down)
        rest = up[:-1] if to_the_root and target != source else up[: up.index(top)]
        return [(frame, "up") for frame in rest] + [(frame, "down") for frame in reversed(down[: down.index(top)])]

    assert mistakes_of("E4.3", path) == []
    assert mistakes_of("E4.3", lambda *asked: path(*asked)[::-1]) == ["reversed"]
    assert mistakes_of("E4.3", partial(path, to_the_root=True)) == ["up to the root"]


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("no stmp", "x"), 'The nearest of them is "no stamp". Not among them either: "e": "x"'),
    ],
)
def test_every_word_that_is_none_to_choose_from_is_named(words, said):
    answer = dict.fromkeys("abdf", "usable") | dict(zip("ce", words, strict=True))
    verdict = verdict_on("E1.2", lambda given: answer)
    assert (verdict.detail["part"], verdict.detail["tip"].en) == ("c", said)
