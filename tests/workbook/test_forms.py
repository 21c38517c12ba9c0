"""When two answers are the same, for each form of an answer."""

from __future__ import annotations

import math
from decimal import Decimal
from fractions import Fraction
from itertools import product
from pathlib import Path

import numpy as np
import pytest
import yaml

from tflab.core import BufferCore, StampedTransform, Transform
from tflab.ros.convert import msg_from_stamped
from tflab.ros.messages import geometry_msgs, std_msgs
from tflab.workbook.answers.forms import (
    Angle,
    Choice,
    Command,
    Message,
    Name,
    Number,
    Pair,
    Parts,
    Pose,
    Quaternion,
    Sequence,
    Set,
    Tree,
    Urdf,
    Vector,
    form_from_plain,
)
from tflab.workbook.answers.values import to_plain

CASES = yaml.safe_load(Path(__file__).with_suffix(".yaml").read_text(encoding="utf-8"))

LEFT = Transform.from_rpy(yaw=math.pi / 2, translation=(1.0, 0.0, 0.0))
STAMPED = StampedTransform("map", "base", 7, LEFT)


def message_of(stamped: StampedTransform) -> geometry_msgs.TransformStamped:
    return msg_from_stamped(stamped)


def buffer_of(stamped: StampedTransform) -> BufferCore:
    buffer = BufferCore()
    buffer.set_transform(stamped, "test")
    return buffer


def point(frame: str) -> geometry_msgs.PointStamped:
    return geometry_msgs.PointStamped(
        header=std_msgs.Header(frame_id=frame), point=geometry_msgs.Point(x=1.0, y=2.0, z=3.0)
    )


WAY = Choice(("up", "down"))
ECHO = "ros2 run tf2_ros tf2_echo map base_link"
STATIC = "ros2 run tf2_ros static_transform_publisher"
HEAD = CASES["head"]
WHOLE = f"""<?xml version="1.0"?>
<robot name="r"><link name="lens"/><link name="head"/><link name="base_link"/>{HEAD}</robot>"""
NODS = Urdf(("head", "lens"), joint="nod", settings=(0.0, 0.4))
SAME = [
    (NODS, WHOLE, HEAD),
    (NODS, WHOLE.replace("</robot>", '<link name="w"/><joint name="b" type="fixed"><parent link="w"/>'
     '<child link="base_link"/></joint></robot>'), HEAD), (NODS, HEAD.replace("1.5708", "1.570796"), HEAD),
    (NODS, HEAD.replace('rpy="0 0 1.5708"', 'rpy="0 0 7.853981"'), HEAD),
    (NODS, HEAD.replace("revolute", "continuous").replace("0 1 0", "0 2.0 0"), HEAD),
    (Number(), 1.0, 1.0004), (Number(tolerance=0), 5, 5), (Number(), np.float64(2.0), 2),
    (Number(), np.array(2.0), 2.0), (Number(), np.array([2.0]), 2.0), (Number(), Decimal("2.0"), Fraction(2, 1)),
    (Vector(3), np.array([[1.0], [2.0], [3.0]]), (1, 2, 3)), (Vector(3), np.array([[1.0, 2.0, 3.0]]), (1, 2, 3)),
    (Angle(), math.pi, -math.pi), (Angle(), 0.1 + 4 * math.pi, 0.1),
    (Vector(3), np.array([1.0, 2.0, 3.0]), (1, 2, 3)), (Vector(3, frame="map"), point("map"), (1.0, 2.0, 3.0)),
    (Vector(3), {"x": 1, "y": 2, "z": 3}, (1, 2, 3)), (Vector(2), [1, 2], (1, 2)),
    (Quaternion(), (0, 0, -1, 0), (0, 0, 1, 0)), (Quaternion(), geometry_msgs.Quaternion(w=1.0), (0, 0, 0, 1)),
    (Pose(), LEFT.matrix(), LEFT), (Pose(), message_of(STAMPED), LEFT),
    (Pose(frames=True), message_of(STAMPED), STAMPED),
    (Pose(), Transform(LEFT.translation, tuple(-q for q in LEFT.rotation)), LEFT),
    (Choice(("no frame", "past")), " No-frame. ", "no frame"), (Choice(("True", "False")), True, True),
    (Choice(("the map's origin, level", "no")), "The maps origin level", "the map's origin, level"),
    (Choice(("use_sim_time", "a longer timeout")), "A longer-timeout.", "a longer timeout"),
    (Choice(("node_a", "node_b")), "node b", "node_b"), (Choice(("node_a", "node_b")), "Node B", "node_b"),
    (Choice(("node_a", "node_b")), " Node_B ", "node_b"), (Choice(("base_link", "map")), "Map", "map"),
    (Choice(("Odom", "odom")), "odom ", "odom"),
    (Choice(("invalid argument", "lookup")), "LookupException", "lookup"),
    (Choice(("invalid argument", "lookup")), "InvalidArgumentException", "invalid argument"),
    (Choice(("LookupException", "nothing")), "lookup", "LookupException"),
    (Choice(("view_frames", "topic hz", "RViz")), " View_frames", "view_frames"),
    (Choice(("view_frames", "topic hz", "RViz")), "rviz", "RViz"), (Choice(("node_a", "none")), "None", "none"),
    (Set(Name(topic=True)), ["tf", "/tf_static"], ["/tf_static", "/tf"]),
    (Sequence(Name()), ["map", "odom"], ("map", "odom")), (Sequence(Quaternion()), [(0, 0, 0, -1)], [(0, 0, 0, 1)]),
    (Name(), "odom", "odom"), (Pair(Name(), Number()), ["map", 1.0004], ("map", 1.0)),
    (Sequence(Pair(Name(), WAY)), [("laser", "up"), ["map", "down "]], [("laser", "up"), ("map", "down")]),
    (Set(Name()), {"odom", "map"}, ["map", "odom"]), (Set(Name()), ("odom", "map", "odom"), {"map", "odom"}),
    (Set(Name()), {"odom": 1, "map": 2}.keys(), {"map", "odom"}), (Set(Name()), [], set()),
    (Set(Pair(Name(), Name())), {("a", "b"), ("c", "d")}, [("c", "d"), ("a", "b")]),
    (Tree(), [STAMPED], {"base": "map"}), (Tree(), buffer_of(STAMPED), {"base": "map"}),
    (Tree(), [STAMPED, STAMPED], {"base": "map"}),
    (Tree(), {"odom": "map", "base": "odom"}, {"base": "odom", "odom": "map"}), (Tree(), {}, {}),
    (Command(), f"$ {ECHO}", ECHO), (Command(), "ros2 topic echo --once tf", "ros2 topic echo /tf --once"),
    (Command(), f"{STATIC} --yaw 3.14159265 --frame-id a --child-frame-id b",
     f"{STATIC} --frame-id a --child-frame-id 'b' --x 0.0 --qz 1 --qw 0"),
    (Command(), f"{STATIC} --frame-id a --child-frame-id b --ros-args -r __node:=mount",
     f"{STATIC} --frame-id a --child-frame-id b"),
    (Command(), "ros2 bag record /tf_static /tf", "ros2 bag record /tf /tf_static"),
    (Command(), "ros2 bag record --topics /tf_static /tf", "ros2 bag record /tf /tf_static"),
    (Command(), f"{ECHO} --ros-args --param use_sim_time:=True", f"{ECHO} --ros-args -p use_sim_time:=true"),
]  # fmt: skip
DIFFERENT = [
    (NODS, HEAD.replace("0.1 0 0.3", "10 0 30"), HEAD), (NODS, HEAD.replace("0 1 0", "0 -1 0"), HEAD),
    (NODS, HEAD.replace("revolute", "fixed"), HEAD), (NODS, HEAD.replace('"nod"', '"other"'), HEAD),
    (NODS, HEAD.replace('child link="head"', 'child link="haed"'), HEAD), (NODS, HEAD + "</joint>", HEAD),
    (NODS, 3, HEAD),
    (NODS, HEAD + " " * 20_000, HEAD),
    (NODS, '<!DOCTYPE r [<!ENTITY a "aa">]>' + WHOLE.partition("?>")[2], HEAD),
    (Number(), 1.0, 1.002), (Number(), True, 1.0), (Number(), "1.0", 1.0), (Number(), math.nan, 1.0),
    (Number(), [1.0], 1.0),
    (Number(), np.array([1.0, 1.0]), 1.0), (Vector(3), np.eye(3), (1, 0, 0)), (Vector(3), [[1], [2], [3]], (1, 2, 3)),
    (Angle(), 0.0, math.pi), (Vector(3), (1, 2), (1, 2, 3)), (Vector(3, frame="map"), point("odom"), (1, 2, 3)),
    (Vector(3), (1, 2, math.inf), (1, 2, 3)), (Vector(3), (1, True, 3), (1, 1, 3)), (Vector(3), None, (1, 2, 3)),
    (Quaternion(), (1, 0, 0, 0), (0, 0, 0, 1)), (Pose(), LEFT.inverse(), LEFT), (Pose(frames=True), LEFT, STAMPED),
    (Pose(frames=True), StampedTransform("base", "map", 7, LEFT), STAMPED),
    (Pose(stamp=True), StampedTransform("map", "base", 8, LEFT), STAMPED),
    (Choice(("Odom", "odom")), "Odom", "odom"), (Choice(("Odom", "odom")), "ODOM", "odom"),
    (Choice(("node_a", "node_b")), "node_", "node_b"), (Sequence(Name()), ["map"], ["map", "odom"]),
    (Name(), "Odom", "odom"), (Name(), "odom ", "odom"), (Name(), None, "odom"), (Name(), ["odom"], "odom"),
    (Pair(Name(), Number()), ("map", 1.0, 2.0), ("map", 1.0)), (Pair(Name(), Number()), "map", ("map", 1.0)),
    (Sequence(Pair(Name(), WAY)), [("map", "down"), ("laser", "up")], [("laser", "up"), ("map", "down")]),
    (Sequence(Name()), {"map"}, ["map"]), (Set(Name()), {"map"}, {"map", "odom"}), (Set(Name()), {"map"}, set()),
    (Set(Name()), {"map", "odom", "base"}, {"map", "odom"}), (Set(Name()), [], {"map"}), (Set(Name()), "map", {"map"}),
    (Set(Name()), ["map", 3], {"map"}),
    (Tree(), {"map": "base"}, {"base": "map"}), (Tree(), {"base": "map", "odom": "map"}, {"base": "map"}),
    (Tree(), [("map", "base")], {"base": "map"}), (Tree(), {"base": None}, {"base": "map"}),
    (Tree(), {}, {"base": "map"}), (Tree(), ["map", "base"], {"base": "map"}),
    (Command(), "ros2 run tf2_ros tf2_echo base_link map", ECHO),
    (Command(), "ros2 topic echo /tf", "ros2 topic echo /tf --once"),
    (Command(), f"{STATIC} --frame-id b --child-frame-id a", f"{STATIC} --frame-id a --child-frame-id b"),
    (Command(), f"{STATIC} --frame-id a --child-frame-id b --ros-args -r /tf_static:=/x",
     f"{STATIC} --frame-id a --child-frame-id b"),
    (Command(), f"{ECHO} -p use_sim_time:=true", f"{ECHO} --ros-args -p use_sim_time:=true"),
    (Command(), "ros2 'run", ECHO), (Command(), 3, ECHO),
]  # fmt: skip


@pytest.mark.parametrize(("form", "answer", "expected"), SAME)
def test_equal_answers_are_the_same(form, answer, expected):
    assert form.same(to_plain(answer), to_plain(expected))


@pytest.mark.parametrize(("form", "answer", "expected"), DIFFERENT)
def test_different_answers_are_not(form, answer, expected):
    assert not form.same(to_plain(answer), to_plain(expected))


def test_a_form_comes_back_from_json_and_an_unknown_one_is_refused():
    within = (Sequence(Pair(Name(), WAY)), Set(Pair(Name(), Number("m"))), Parts({"tree": Tree(), "at": Name()}))
    for form in (*{type(form).__name__: form for form, _, _ in SAME}.values(), *within):
        assert form_from_plain(form.plain()) == form
    with pytest.raises(ValueError, match="Vector"):
        form_from_plain({"form": "Colour"})


def test_parts_have_credit_of_their_own_and_come_back():
    form = Parts({"target": Choice(("map", "odom")), "x": Number()})
    expected = to_plain({"target": "map", "x": 1.0})
    assert form.judge(to_plain({"target": "odom", "x": 1.0}), expected) == [False, True]
    assert form.judge(to_plain({"x": 1.0}), expected) == [False, True]
    assert form.judge(to_plain("map"), expected) == [False, False]


def test_a_message_has_credit_for_each_field():
    fields = ("header.frame_id", "child_frame_id", "transform.translation.x", "transform.rotation")
    form = Message("geometry_msgs/msg/TransformStamped", fields)
    swapped = message_of(StampedTransform("base", "map", 7, LEFT))
    assert form.judge(to_plain(swapped), to_plain(message_of(STAMPED))) == [False, False, True, True]
    assert form.judge(to_plain(LEFT), to_plain(message_of(STAMPED))) == [False] * 4
    assert form_from_plain(form.plain()) == form


def test_an_outcome_that_should_be_an_error_is_judged_by_its_class():
    expected = {"raises": "LookupException", "text": "of the solution"}
    assert Number().same({"raises": "LookupException", "text": "another"}, expected)
    assert not Number().same({"raises": "TypeError", "text": ""}, expected)
    assert not Number().same(1.0, expected)


FIVE = {"odom": "map", "base": "odom", "laser": "base", "camera": "base", "imu": "base"}


@pytest.mark.parametrize(
    ("form", "answer", "expected", "right"),
    [
        (Tree(), FIVE | {"laser": "odom"}, FIVE, 4),
        (Tree(), {"odom": "map", "base": "odom"}, FIVE, 2),
        (Tree(), FIVE | {"lamp": "base"}, FIVE, 4),  # one too many takes one back
        (Tree(), {parent: child for child, parent in FIVE.items()}, FIVE, 0),
        (Set(Name()), {"a", "b", "c", "d"}, {"a", "b"}, 0),
        (Set(Name()), {"a", "b", "c"}, {"a", "b"}, 1),
        (Set(Name()), {"a", "c"}, {"a", "b"}, 1),
    ],
)
def test_each_edge_and_each_member_has_credit_and_one_too_many_costs_one(form, answer, expected, right):
    assert sum(form.judge(to_plain(answer), to_plain(expected))) == right


MADE_UP = [
    {"message": []}, {"message": [1, 2]}, {"dict": 3}, {"Buffer": {}}, [[[]]], {"tuple": {}}, {"Transform": [1, 2]},
    {"BufferCore": {"samples": 3}}, {"StampedTransform": [1]}, {"array": {"x": 1}}, 10**40, {"raises": []}, {},
    {"set": 3}, {"set": [{}]}, {"dict": {"a": []}},
]  # fmt: skip


@pytest.mark.parametrize(("form", "answer", "expected"), SAME[::3])
def test_made_up_json_is_merely_wrong(form, answer, expected):
    for hostile in MADE_UP:
        assert not any(form.judge(hostile, to_plain(expected))), hostile
    if isinstance(form, Name | Command):
        assert form.judge(f"{expected}\ud800", expected) == [False]  # half of a pair of a letter


def test_a_message_in_a_message_is_the_same_in_whichever_order_its_fields_were_written() -> None:
    form = Message("geometry_msgs/msg/PointStamped", fields=("header.stamp",))

    def point(stamp: dict) -> dict:
        header = {"stamp": {"message": ["builtin_interfaces/msg/Time", stamp]}, "frame_id": "map"}
        fields = {"header": {"message": ["std_msgs/msg/Header", header]}}
        return {"message": ["geometry_msgs/msg/PointStamped", fields]}

    assert form.same(point({"sec": 4, "nanosec": 5}), point({"nanosec": 5, "sec": 4}))
    assert not form.same(point({"sec": 4, "nanosec": 5}), point({"nanosec": 6, "sec": 4}))


SHAPES = (
    None, True, 0, 1.5, "map", [], [None], {"tuple": []}, {"tuple": [1.0, None]}, {"dict": {}}, {"dict": {"a": None}},
    {"dict": {"a": 1.0, "b": "x"}}, {"dict": {"b": {"dict": {"a": 1.0}}}}, {"array": [[1.0], [2.0]]}, {"float": "nan"},
    {"raises": "ValueError", "text": ""}, {"unanswered": True}, {"object": "Thing"}, {"message": ["x/msg/Y", {}]},
    {"Transform": [[0.0, 0.0, 0.0], [0.0, 0.0, 0.0, 1.0]]}, {"Transform": [[0.0], None]}, {"BufferCore": {}},
)  # fmt: skip
NESTED = (Number(), Angle(), Vector(), Quaternion(), Pose(), Choice(("map",)), Name(), Set(Name()), Tree(), Command(),
          Pair(Name(), Number()))  # fmt: skip


@pytest.mark.parametrize("form", NESTED, ids=lambda form: repr(form)[:60])
def test_whether_two_answers_are_alike_can_be_asked_of_any_two_whatever_each_is(form):
    for each in (form, Sequence(form), Parts({"a": form, "b": Number()})):
        for one, other in product(SHAPES, SHAPES):
            assert each.alike(one, other) in (True, False)


def test_parts_that_cannot_be_read_are_alike_only_if_they_are_the_same():
    form = Parts({"x": Number(), "y": Number()})
    first, second = {"dict": {"x": 1.0, "y": None}}, {"dict": {"x": 2.0, "y": 2.0}}
    assert not form.alike(second, first) and not form.alike(first, second)
    assert form.alike(first, dict(first))


def test_each_link_of_a_robot_has_credit_of_its_own_because_it_is_looked_at_from_its_parent():
    assert NODS.judge(HEAD.replace("0.1 0 0.3", "0.3 0 0.1"), HEAD) == [False, True]
    assert NODS.judge(HEAD.replace("-1.5708 0 -1.5708", "0 0 0"), HEAD) == [True, False]
    upside_down = HEAD.replace("base_link", "x").replace('child link="head"', 'child link="base_link"')
    assert NODS.judge(upside_down.replace('"x"', '"head"'), HEAD) == [False, False]


def test_a_text_that_is_no_robot_is_told_why_with_the_line_that_the_learner_sees():
    assert NODS.fault(HEAD.replace('child link="lens"', 'child link="lense"')).startswith(
        'your URDF:6: joint "eye": its child link "lense" does not exist. Did you mean "lens"?'
    )
    assert "entit" in NODS.fault('<!DOCTYPE r [<!ENTITY a "aa">]><robot name="&a;"/>').lower()
    assert NODS.fault(" " * 20_001) == "20001 characters; 20000 are enough for this robot"
    assert NODS.fault(HEAD) == ""


def test_a_line_longer_than_anybody_types_is_no_command() -> None:
    assert Command().read("ros2 topic echo /tf " + "x " * 1_900) is not None
    assert Command().read("ros2 topic echo /tf " + "x " * 2_000) is None
