"""How `check` explains a wrong answer: one mistake, two, one in each part, or none that is known."""

from __future__ import annotations

import math

import pytest

from tflab.core import Transform
from tflab.ros.messages import geometry_msgs
from tflab.workbook.answers.forms import (
    Angle,
    Choice,
    Command,
    Message,
    Name,
    Number,
    Parts,
    Pose,
    Sequence,
    Set,
    Tree,
    Urdf,
    Vector,
)
from tflab.workbook.answers.values import outcome_of, raised, to_plain
from tflab.workbook.diagnosis.failure import Failure
from tflab.workbook.diagnosis.verdict import judge_outcomes
from tflab.workbook.tasks import Text
from tflab.workbook.tasks.case_types import Case, Feedback

from .small_chapter import StoredPairs, bare

PARTS = Parts({"a": Number("m"), "b": Number("m"), "c": Number("m")})


def words(text, **more):
    return Feedback(Text(text, text), "", **more)


def judged(form, expected, by_mistake, answer, said=None):
    """Return the verdict on one value, where `by_mistake` gives the value of each mistake and of each two."""
    plain = {name: to_plain(value) for name, value in by_mistake.items()}
    case = Case(None, to_plain(expected), {name: value for name, value in plain.items() if " + " not in name})
    task, variant = bare(form, case)
    known = said or {name: words(name) for name in case.wrong}
    pairs = StoredPairs({name: [value] for name, value in plain.items()})
    return judge_outcomes(task._replace(feedback=known, pairs=pairs), variant, [to_plain(answer)])


def test_an_inverse_of_which_only_the_translation_was_negated_is_not_taken_for_the_inverse():
    there = Transform.from_rpy(0.1, 0.2, 0.7, translation=(1.0, 2.0, 3.0))
    half = Transform((-1.0, -2.0, -3.0), there.rotation)
    assert list(judged(Pose(), there.inverse(), {}, half).mistakes) == ["not turned back"]
    assert list(judged(Pose(), there.inverse(), {}, there).mistakes) == ["inverse transform"]
    beside = Transform((-1.0, -2.0, -3.3), there.rotation)
    assert list(judged(Pose(), there.inverse(), {}, beside).mistakes) == ["inverse rotation"]
    assert judged(Pose(), there.inverse(), {}, beside).said.en.startswith('"rotation": this is the inverse rotation')


def test_one_mistake_comes_before_two_and_two_are_named_in_the_order_of_the_work():
    verdict = judged(Number("m"), 1.0, {"late": 2.0, "far": 3.0, "late + far": 7.25}, 7.25)
    assert list(verdict.mistakes) == ["late", "far"]
    assert verdict.said.en == "Two mistakes together give this answer. First: late Then: far"
    assert list(judged(Number("m"), 1.0, {"late": 2.0, "far": 3.0, "late + far": 2.0}, 2.0).mistakes) == ["late"]
    assert list(judged(Number("m"), 1.0, {"backwards": -1.0}, -1.0).mistakes) == ["backwards"]  # and not "sign"
    assert list(judged(Number("m"), 1.0, {"late": 2.512}, 2512.0).mistakes) == ["late", "unit mm"]


@pytest.mark.parametrize(
    ("answer", "mistakes"),
    [(2.5, ["late"]), (1000.0, ["unit mm"]), (-1.0, ["sign"]), (3.5, []), (2500.0, []), (2.0, []), (5.0, [])],
)
def test_a_number_of_two_digits_shows_one_exact_mistake_at_most(answer, mistakes):
    form, by_mistake = Number("m", tolerance=0.05), {"late": 2.5, "far": 3.52, "far + late": 5.0}
    assert list(judged(form, 1.0, by_mistake, answer).mistakes) == mistakes


@pytest.mark.parametrize(("answer", "mistakes"), [(5.2, ["rounded"]), (5.1, []), (5.0, []), (5.19, [])])
def test_a_number_is_called_rounded_only_if_the_right_one_rounds_to_it(answer, mistakes):
    assert list(judged(Number("s"), 5.1957, {}, answer).mistakes) == mistakes


def test_each_part_may_have_a_mistake_of_its_own():
    right = {"a": 1.0, "b": 2.0, "c": 3.0}
    by_mistake = {"first": right | {"a": 5.0}, "last": right | {"c": 7.0}}
    verdict = judged(PARTS, right, by_mistake, {"a": 5.0, "b": -2.0, "c": 7.0})
    assert verdict.said.en == '"a": first "b": the size is right, the sign is not. "c": last'


def test_two_mistakes_that_cancel_in_a_part_are_not_named_if_it_is_wrong_as_well():
    right = {"a": 1.2, "b": 2.3, "c": 3.4}
    cancelled = right | {"a": 7.135}
    by_mistake = {"back": cancelled | {"b": 9.642}, "far": right | {"b": 8.513}, "back + far": cancelled}
    assert list(judged(PARTS, right, by_mistake, cancelled).mistakes) == ["back", "far"]
    assert not judged(PARTS, right, by_mistake, cancelled | {"b": 4.7}).mistakes


def test_two_beliefs_each_held_in_some_parts_are_both_named():
    form = Parts({name: Choice(("cable", "clock", "mount", "wait")) for name in ("first", "second", "third", "fourth")})
    right = {"first": "clock", "second": "mount", "third": "clock", "fourth": "mount"}
    by_mistake = {"sensor first": dict.fromkeys(right, "cable"), "waiting cures": dict.fromkeys(right, "wait")}
    said = {name: words(name, partly=True) for name in by_mistake}
    verdict = judged(form, right, by_mistake, right | {"first": "wait", "second": "cable", "fourth": "cable"}, said)
    assert (list(verdict.mistakes), verdict.passed) == (["waiting cures", "sensor first"], 1)
    assert verdict.said.en == '"first": waiting cures "second", "fourth": sensor first'


RIGHT = {"a": 1.0, "b": 2.0, "c": 3.0}
LATE = RIGHT | {"a": 5.0, "b": 6.0}


@pytest.mark.parametrize(
    ("late", "more", "answer", "mistakes", "said", "passed"),
    [
        (LATE, {"part": "a"}, LATE, ["late"], "late", 2),  # b only follows, which costs nothing
        (LATE, {"part": "a"}, LATE | {"b": 6.5}, ["late"], "late", 1),
        (LATE, {"part": "a"}, RIGHT | {"a": 5.0}, ["late"], '"a": late', 2),
        (LATE, {}, RIGHT | {"a": 5.0}, [], "", 2),  # only a part of it shows
        (LATE, {"partly": True}, RIGHT | {"a": 5.0}, ["late"], "late", 2),
        (LATE, {}, RIGHT | {"b": 6.0}, [], "", 2),
        (LATE | {"b": 0.0}, {"part": "a"}, RIGHT | {"b": 0.0}, ["zero"], "", 2),
    ],
)
def test_a_mistake_is_named_by_its_part_and_what_only_follows_from_it_costs_nothing(
    late, more, answer, mistakes, said, passed
):
    verdict = judged(PARTS, RIGHT, {"late": late}, answer, {"late": words("late", **more)})
    assert (list(verdict.mistakes), verdict.passed) == (mistakes, passed)
    assert not said or said in verdict.said.en


def test_words_that_are_confused_in_lists_are_named():
    form = Sequence(Choice(("sim", "wall", "off")))
    asked = [(["sim", "off"], ["sim", "sim"]), (["off", "wall"], ["sim", "wall"])]
    assert list(judged_function(form, asked).mistakes) == ["sim for off"]


def test_an_option_says_what_it_would_mean_and_then_what_there_is_to_see():
    form = Parts({"a": Choice(("clock", "mount")), "b": Choice(("clock", "mount"))})
    task, variant = bare(form, Case(None, to_plain({"a": "clock", "b": "mount"}), {}))
    goes = Text("It goes.", "사라집니다.")
    for more in ({"shows": {"a": goes}}, {"seen": {"clock": goes}}):  # of the part, and of the option that is right
        task = task._replace(means={"mount": Text("It would stay.", "남습니다.")}, shows={}, seen={})._replace(**more)
        for answer in ("mount", "Mount."):
            verdict = judge_outcomes(task, variant, [to_plain({"a": answer, "b": "mount"})])
            assert verdict.said.en == '"a": It would stay. It goes.'


def point(frame, x):
    message = geometry_msgs.PointStamped()
    message.header.frame_id, message.point.x = frame, x
    return message


def test_a_mistake_is_named_though_the_labels_of_its_message_were_put_right_by_hand():
    form = Message("geometry_msgs/msg/PointStamped", ("header.frame_id", "point"))
    asked = [(point("map", x), point("map", 7.3 * x)) for x in (1.0, 2.0)]
    by_mistake = {"left": [point("odom", 7.3 * x) for x in (1.0, 2.0)]}
    assert list(judged_function(form, asked, by_mistake).mistakes) == ["left"]


@pytest.mark.parametrize(
    ("form", "answer", "got"),
    [
        (Sequence(Sequence(Name())), ["map", "odom"], "list of 2, holding str"),
        (Sequence(Sequence(Name())), [["map", 3]], "list of 1, holding list of 2, holding int"),
        (Tree(), {"odom": "map", "base": 3}, "dict, holding int"),
    ],
)
def test_where_a_list_or_a_dict_is_right_and_a_member_is_of_the_wrong_kind_it_is_the_member_that_is_named(
    form, answer, got
):
    right = FIVE if isinstance(form, Tree) else [["map", "odom"]]
    assert judged(form, right, {}, answer).detail["got"] == got


FIVE = {"odom": "map", "base": "odom", "laser": "base", "camera": "base", "imu": "base"}
LAMP = {"odom": "map", "base": "odom", "lamp": "base"}


def posed(yaw, z=0.0):
    return Transform.from_rpy(yaw=yaw, translation=(1.0, 2.0, z))


@pytest.mark.parametrize(
    ("form", "right", "answer", "said"),
    [
        (Vector(3), (1.0, 2.0, 3.0), (1.0, 2.5, 2.0), "x: right; y: too large; z: too small"),
        (Pose(), posed(0.8), posed(0.8, 9.0), "translation: x, y: right; z: too large. Rotation: right"),
        (Pose(), posed(0.8), posed(0.803), "translation: x, y, z: right. Rotation: off by at most 1°"),
        (Pose(), posed(0.8), posed(0.8 + math.pi / 2), "translation: x, y, z: right. Rotation: off by at most 90°"),
        (Pose(), posed(0.8), posed(2.372), "translation: x, y, z: right. Rotation: off by more than 90°"),
        (Angle(), 0.5, 0.1, "rotated too far to the right, by at most 45°"),
        (Tree(), FIVE, FIVE | {"odom": "laser"}, 'wrong as a child, or below the wrong parent: "odom"'),
        (Tree(), FIVE, LAMP, 'wrong as a child, or below the wrong parent: "lamp"; children that are missing: 2'),
        (Set(Name()), {"map", "odom"}, set(), "members that are missing: 2"),
        (Set(Name()), {"map", "odom"}, {"odom", "lamp"}, "members that do not belong: 1; members that are missing: 1"),
    ],
)
def test_where_nothing_fits_it_is_said_what_is_certain_and_not_the_answer(form, right, answer, said):
    assert judged(form, right, {}, answer).detail["certain"].en == said


def test_of_a_tree_what_stood_in_the_givens_shows_nothing():
    broken = [("map", "odom"), ("odm", "base"), ("base", "laser")]
    task, variant = bare(Tree(), Case(None, to_plain({"odom": "map", "base": "odom", "laser": "base"}), {}))
    variant = variant._replace(given={"edges": to_plain(broken)})
    handed_back = judge_outcomes(task, variant, [to_plain(broken)])
    assert (handed_back.passed, handed_back.of) == (0, 3)
    assert judge_outcomes(task, variant, [to_plain({"base": "odom"})]).passed == 1
    assert judge_outcomes(task, variant, [variant.cases[0].expected]).passed == 3


def test_a_function_that_changes_its_argument_is_told_so_and_its_result_is_explained():
    cases = [Case([[1.0, 2.5]], 2.5, {"first": 1.0}), Case([[3.0, 4.5]], 4.5, {"first": 3.0})]
    task, variant = bare(Number("s"), *cases, is_function=True)
    task = task._replace(feedback={"first": words("first")})
    popped, first = (
        judge_outcomes(task, variant, [outcome_of(lambda stamps, n=n: stamps.pop(n), case.args) for case in cases])
        for n in (-1, 0)
    )
    assert (popped.failure, popped.detail["changed"]) == (Failure.INPUT_CHANGED, 1)
    assert list(first.mistakes) == ["first", "input changed"]


def judged_function(form, asked, by_mistake=None):
    """Return the verdict on a function, where `asked` is a list of (expected, outcome)."""
    gives = {name: [to_plain(value) for value in row] for name, row in (by_mistake or {}).items()}
    single = {name: row for name, row in gives.items() if " + " not in name}
    cases = [
        Case([place], to_plain(want), {name: row[place] for name, row in single.items()})
        for place, (want, _) in enumerate(asked)
    ]
    task, variant = bare(form, *cases, is_function=True)
    task = task._replace(feedback={name: words(name) for name in single}, pairs=StoredPairs(gives))
    return judge_outcomes(task, variant, [to_plain(outcome) for _, outcome in asked])


def test_a_place_that_is_right_in_one_call_was_not_left_at_zero():
    asked = [((1,), (0.3, 0.0, 0.6)), ((2,), (1.0, 0.0, 2.0)), ((3,), (1.5, 0.0, 0.5))]
    cut = [(0.0, 0.0, 0.0), (1.0, 0.0, 2.0), (1.0, 0.0, 0.0)]
    task, variant = bare(Vector(3, "m"), *(Case(to_plain(list(args)), to_plain(want), {}) for args, want in asked))
    assert list(judge_outcomes(task, variant, [to_plain(each) for each in cut]).mistakes) == ["rounded"]


def test_nothing_is_a_unit_of_what_is_as_good_as_zero():
    assert judged(Number("s", 0.005), 6.45, {"time zero": 0.0}, 6.565).mistakes == {}


def test_two_parts_that_changed_places_are_told_so():
    verdict = judged(PARTS, {"a": 1.0, "b": 2.5, "c": 3.0}, {}, {"a": 2.5, "b": 1.0, "c": 3.0})
    assert list(verdict.mistakes) == ["a and b changed places"]


def test_what_was_given_is_named_where_it_comes_back():
    case = Case(None, to_plain((1.0, 2.0, 3.0)), {})
    task, variant = bare(Vector(3), case)
    given = variant._replace(given={"p_laser": [4.0, 5.0, 6.0]})
    assert list(judge_outcomes(task, given, [[4.0, 5.0, 6.0]]).mistakes) == ["given p_laser"]
    assert judge_outcomes(task, given, [[4.0, 5.0, 6.5]]).mistakes == {}


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ((1.0, -2.0, 3.0), "y has the wrong sign. The rest is right."),
        ((1.0, 3.0, 2.0), "y and z are swapped."),
        ((2.0, 3.0, 1.0), "these are the right numbers, but in the wrong order."),
        ((1.0, 3.0, -2.0), "x is right. The other two have the right sizes, but the wrong order or signs."),
        ((3.0, -1.0, 2.0), "the sizes of the numbers are right, but their order or their signs are not."),
    ],
)
def test_which_numbers_of_a_point_have_it_is_told_where_it_is_sure(given, said):
    assert judged(Vector(3), (1.0, 2.0, 3.0), {}, given).said.en == said


def test_of_calls_it_is_told_only_where_it_is_the_same_number_in_all_that_are_wrong():
    first = ((1.0, 2.0, 3.0), (1.0, -2.0, 3.0))
    said = [
        judged_function(Vector(3), [first, other]).said.en
        for other in (
            ((4.0, 5.0, 6.0), (4.0, -5.0, 6.0)),
            ((4.0, 5.0, 6.0), (4.0, 5.0, -6.0)),
            ((4.0, 5.0, 6.0), (4.0, 5.0, 6.0)),
        )
    ]
    assert said[0] == "y has the wrong sign. The rest is right."
    assert said[1] == "one of the numbers has the wrong sign."
    assert said[2].startswith("In some calls, not in all: y has the wrong sign. The rest is right.")


def test_each_part_of_what_a_function_gives_is_explained_by_itself():
    form = Parts({"x": Number("m"), "yaw": Angle()})
    asked = [({"x": x, "yaw": x / 2}, {"x": x, "yaw": math.degrees(x / 2)}) for x in (1.0, 2.0, 3.0)]
    verdict = judged_function(form, asked)
    assert (verdict.failure, verdict.detail["part"], verdict.passed) == (Failure.UNIT, "yaw", 3)


@pytest.mark.parametrize(
    ("said", "name"),
    [
        (["ok", "future", "future", "future"], "future for past"),
        (["ok", "past", "future", "future"], "past and future swapped"),
    ],
)
def test_words_that_a_function_confuses_are_named(said, name):
    form = Choice(("ok", "past", "future"))
    asked = ["ok", "future", "past", "past"]
    mistakes = judged_function(form, list(zip(asked, said, strict=True))).mistakes
    assert [set(mistake.replace(" and ", " ").split()) for mistake in mistakes] == [
        set(name.replace(" and ", " ").split())
    ]


# -- near, and not it -------------------------------------------------------------------------


def test_a_mistake_is_not_named_by_a_tolerance_that_is_wide_beside_it():
    form = Number("mm", 0.5)
    assert list(judged(form, 400.0, {"cosine": 0.2163}, 0.2163).mistakes) == ["cosine"]
    assert "cosine" not in judged(form, 400.0, {"cosine": 0.2163}, 0.0208).mistakes
    pair = {"late": 80.0, "far": 90.0, "late + far": 101.5}
    assert list(judged(form, 400.0, pair, 101.5).mistakes) == ["late", "far"]
    assert not judged(Number("mm", 5.0), 400.0, pair, 103.0).mistakes


def test_an_answer_of_one_other_part_is_named_and_one_of_several_is_chance():
    form = Parts({"a": Name(), "b": Name(), "c": Name()})
    assert list(
        judged(form, {"a": "lidar", "b": "imu", "c": "none"}, {}, {"a": "none", "b": "imu", "c": "none"}).mistakes
    ) == ["c under a"]
    assert not judged(
        form, {"a": "lidar", "b": "none", "c": "none"}, {}, {"a": "none", "b": "none", "c": "none"}
    ).mistakes


@pytest.mark.parametrize(
    ("form", "right", "wrong", "name"),
    [
        (Vector(3), (1.0, 2.0, 3.0), (1.0, 2.0, 0.0), "left at zero"),
        (Vector(3), (1.234, 2.345, 3.456), (1.2, 2.3, 3.4), "rounded"),
        (Set(Name()), {"a", "b"}, ["a", "a", "b"], None),
        (Number("m"), 2.5, 0.0, "zero"),
        (Sequence(Name()), ["a", "c", "b"], ["b", "a", "c"], "another order"),
        (Sequence(Number()), [9.0, 10.0, 11.0], [10.0, 9.0, 11.0], "unsorted"),
        (Sequence(Number()), [10.0, 9.0, 11.0], [9.0, 10.0, 11.0], "another order"),
        (Tree(), FIVE, [(parent, child) for child, parent in FIVE.items()], None),
        (Tree(), FIVE, [("map", "odom")], "tree: not whole"),
        (Tree(), FIVE, FIVE | {"{robot}/lamp": "map"}, "nothing filled in"),
        (Sequence(Name()), ["a", "b"], ["a", "{b}"], "nothing filled in"),
        (Set(Name(), once=True), {"a", "b"}, ["a", "a", "b"], "members twice"),
        (Sequence(Name()), ["a", "b", "a"], ["a", "b"], "members once"),
        (Sequence(Name()), ["b", "a", "b"], ["a", "b"], "members once, in another order"),
        (Sequence(Name()), ["a", "b"], ["a", "c", "b"], "members too many"),
        (Tree(), {"odom": "map", "base": "odom"}, {"map": "odom", "odom": "base"}, "parent for child"),
        (Tree(), FIVE, FIVE | {"laser": ["base"]}, "tree: a list for a name"),
        (Tree(), FIVE, FIVE | {"map": None}, "tree: None for a name"),
        (Tree(), FIVE, FIVE | {"laser": "odom"}, "tree: too high"),
        (Tree(), FIVE, FIVE | {"laser": "camera"}, "tree: too low"),
        (Tree(), FIVE, FIVE | {"laser": "imu", "camera": "odom", "imu": "base"}, None),
        (Tree(), {"r/odom": "map"}, {"r/odom": "world"}, "tree: other names"),
        (Tree(), {"r/odom": "map"}, {"r_odom": "map"}, "other separator"),
        (Set(Name()), {"/tf", "/tf_static"}, {"tf", "tf_static"}, "no slash in front"),
        (Command(), "ros2 topic hz /tf", "rostopic hz /tf", "line: ROS 1"),
        (Command(), "ros2 topic hz /tf", "topic hz /tf", "line: no ros2"),
        (Command(), "ros2 topic hz /tf", "ros2 hz topic /tf", "line: words exchanged"),
        (Command(), "ros2 topic hz /tf", "ros2 topic delay /tf", "line: other command"),
        (Command(), "ros2 topic hz /tf", "ros2 topic hz /tf_static", "line: other names"),
        (Command(), "ros2 topic hz /tf", "ros2 topic hz", "line: too few names"),
        (Command(), "ros2 topic hz /tf", "ros2 topic hz /tf /odom", "line: too many names"),
        (Command(), "ros2 topic hz /tf", "ros2 topic hz /tf --once", "line: option too many"),
        (Command(), "ros2 topic echo /tf --once", "ros2 topic echo /tf", "line: option missing"),
        (Command(), "ros2 topic echo /tf --once", "ros2 topic echo /tf -once", "line: hyphens"),
        (Command(), "ros2 topic echo /tf --once", "ros2 topic echo /tf --csv", "line: other options"),
        (Command(), "ros2 run tf2_ros tf2_echo a b", "ros2 tf2_echo a b", "line: no run"),
        (Command(), "ros2 run tf2_ros tf2_echo a b", "ros2 run tf2_ros tf2_echo /a b", "line: slash in front"),
        (Command(), "ros2 run tf2_ros tf2_echo a b", "ros2 run tf2_tools tf2_echo a b", "line: other package"),
        (Command(), "ros2 run tf2_ros tf2_echo a b", "ros2 run tf2_ros tf2_echo a, b", "line: commas"),
        (Command(), "ros2 run tf2_ros tf2_echo a b", "ros2 run tf2_ros tf2_echo b a", "line: order of names"),
    ],
)
def test_what_shows_only_beside_the_right_answer_is_named(form, right, wrong, name):
    assert next(iter(judged(form, right, {}, wrong).mistakes), None) == name


@pytest.mark.parametrize(
    ("form", "right", "wrong", "told"),
    [
        (Tree(), {"odom": "map", "base": "odom"}, {"base": "odom"}, 'these have no parent: "odom"'),
        (Tree(), {"odom": "map"}, {"odom": "world"}, 'Not asked for: "world"'),
        (Command(), "ros2 topic hz /tf", "ros2 topic hz /odom", "Not asked for: `/odom`"),
        (Command(), "ros2 run tf2_ros tf2_echo a b", "ros2 run tf2_tools view_frames", "`view_frames` draws the tree"),
    ],
)
def test_where_it_shows_is_told_by_what_stands_in_the_answer(form, right, wrong, told):
    assert told in judged(form, right, {}, wrong).said.en


def test_a_dict_may_hold_what_nobody_asked_for_unless_it_stands_alone():
    two, more = {"a": Number("m"), "b": Number("m")}, {"a": 1.0, "b": 2.0, "z": 3.0}
    assert judged(Parts(two), {"a": 1.0, "b": 2.0}, {}, more).failure is None
    verdict = judged(Parts(two, alone=True), {"a": 1.0, "b": 2.0}, {}, more)
    assert (verdict.failure, verdict.detail["parts"]) == (Failure.MORE_PARTS, ["z"])


# -- refusals, and members of lists -----------------------------------------------------------

REFUSED = raised(LookupError("no"))


@pytest.mark.parametrize(
    ("instead", "name"),
    [
        (None, "error swallowed"),
        (0.0, "error swallowed"),
        ({"object": "LookupError, returned and not raised"}, "exception returned"),
    ],
)
def test_an_error_that_was_swallowed_is_called_so(instead, name):
    cases = (Case([1], 1.0, {}), Case([2], 2.0, {}), Case([3], REFUSED, {}), Case([4], REFUSED, {}))
    task, variant = bare(Number("m"), *cases, is_function=True)
    assert list(judge_outcomes(task, variant, [1.0, 2.0, instead, instead]).mistakes) == [name]
    assert judge_outcomes(task, variant, [1.0, 2.0, REFUSED, REFUSED]).failure is None
    both = judge_outcomes(task, variant, [-1.0, -2.0, instead, instead])
    assert list(both.mistakes) == ["sign", name]
    each_another = judge_outcomes(task, variant, [1.0, 2.0, 3.0, 4.0])
    assert each_another.failure is Failure.NO_REFUSAL


def test_what_all_messages_of_a_list_have_wrong_is_said_of_the_field():
    form = Sequence(Message("geometry_msgs/msg/PointStamped", ("header.frame_id", "point")))
    asked = [([point("map", 1.0), point("odom", 2.0)], [point("/map", 1.0), point("/odom", 2.0)])]
    asked += [([point("map", 3.0)], [point("/map", 3.0)])]
    verdict = judged_function(form, asked)
    assert list(verdict.mistakes) == ["slash in front"]
    assert verdict.said.en.startswith('"header.frame_id": ')


def robot(origin='xyz="0.2 -0.1 0.4" rpy="0 0 -0.6"', axis="0 1 0", kind="revolute", parent="base_link"):
    return (
        f'<joint name="nod" type="{kind}"><parent link="{parent}"/><child link="head"/>'
        f'<origin {origin}/><axis xyz="{axis}"/></joint>'
        '<joint name="lens_joint" type="fixed"><parent link="base_link"/><child link="lens"/></joint>'
    )


def test_words_that_two_mistakes_would_give_in_different_calls_are_confused_words():
    form = Choice(("wait", "check", "drop"))
    asked = [("wait", "check"), ("check", "wait"), ("wait", "check"), ("drop", "drop")]
    by_mistake = {
        "never waits": ["check", "check", "check", "drop"],
        "always waits": ["wait", "wait", "wait", "drop"],
    }
    assert list(judged_function(form, asked, by_mistake).mistakes) == ["wait and check swapped"]


@pytest.mark.parametrize(
    ("wrong", "said"),
    [
        ({"origin": 'xyz="0.2 0.1 0.4" rpy="0 0 -0.6"'}, '"head": its position in its parent: y has the wrong sign'),
        ({"origin": 'xyz="0.2 -0.1 0.4" rpy="0 0 0.6"'}, '"head": its rotation in its parent: this is the inverse'),
        ({"axis": "-1 0 0"}, '"head": at 0 its pose is right. When the joint moves, it rotates about its own -x axis'),
        ({"kind": "fixed"}, '"head": its joint is fixed'),
        ({"kind": "prismatic"}, '"head": its joint slides'),
        ({"parent": "lens"}, '"head": its parent is lens'),
        (
            {"origin": 'xyz="0.2 -0.1 0.4" rpy="0 1.5707963 0"'},
            '"head": its rotation in its parent: off by more than 90°. Its axes '
            "x, y, z now point along -z, y, x of its parent",
        ),
    ],
)
def test_of_a_robot_each_link_is_told_what_is_wrong_with_it(wrong, said):
    form = Urdf(("head", "lens"), joint="nod", settings=(0.0, 0.4))
    assert judged(form, robot(), {}, robot(**wrong)).said.en.startswith(said)
    assert judged(form, robot(), {}, robot()).failure is None
