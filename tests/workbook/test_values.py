"""Answers as plain JSON, and back."""

from __future__ import annotations

import json
import math
from collections import deque
from dataclasses import dataclass
from enum import Enum
from itertools import count

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tflab.core import BufferCore, StampedTransform, Transform
from tflab.ros.messages import geometry_msgs, sensor_msgs
from tflab.ros.tf2.buffer import Buffer
from tflab.ros.time import Duration, Time
from tflab.workbook.answers.values import from_plain, is_unanswered, raised, to_plain

TURNED = Transform((1.0, 2.0, 3.0), (0.0, 0.0, 0.6, 0.8))


def filled(buffer):
    buffer.set_transform(StampedTransform("map", "odom", 1_000_000_000, TURNED), "slam")
    buffer.set_transform(StampedTransform("map", "odom", 2_000_000_000, Transform()), "slam")
    buffer.set_transform(StampedTransform("odom", "laser", 0, TURNED), "urdf", is_static=True)
    return buffer


VALUES = [
    None, True, 3, 2.5, "map", [1, [2.0]], (1, (2, "x")), {"map": (1, 2)}, math.inf, ..., TURNED,
    StampedTransform("map", "odom", 1_700_000_000_123_456_789, TURNED),
    geometry_msgs.PointStamped(point=geometry_msgs.Point(x=1.0, y=-2.0, z=0.5)),
    sensor_msgs.PointCloud2(data=b"abc", width=3), Time(nanoseconds=5), Duration(nanoseconds=-7),
    filled(BufferCore(5_000_000_000)),
]  # fmt: skip


@pytest.mark.parametrize("value", VALUES, ids=lambda value: type(value).__name__)
def test_a_value_comes_back_from_json_as_it_was(value):
    plain = to_plain(value)
    back = from_plain(json.loads(json.dumps(plain, allow_nan=False)))
    assert to_plain(back) == plain
    assert type(back) is type(value)
    assert math.isnan(from_plain(to_plain(math.nan)))


json_like = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.text(),
    lambda inner: st.lists(inner) | st.tuples(inner, inner) | st.dictionaries(st.text(), inner),
    max_leaves=20,
)


@given(json_like)
def test_whatever_is_made_of_lists_tuples_and_dicts_comes_back(value):
    plain = to_plain(value)
    assert to_plain(from_plain(json.loads(json.dumps(plain, allow_nan=False)))) == plain


def test_a_buffer_of_messages_answers_as_before():
    core = filled(BufferCore())
    copy = from_plain({"Buffer": to_plain(core)["BufferCore"]})
    assert isinstance(copy, Buffer)
    assert copy.core.lookup_transform("map", "laser", 1_500_000_000) == core.lookup_transform(
        "map", "laser", 1_500_000_000
    )


def test_two_readings_share_nothing():
    plain = to_plain(geometry_msgs.Point())
    one, other = from_plain(plain), from_plain(plain)
    one.x = 5.0
    assert other.x == 0.0


def test_an_object_of_unknown_class_is_named_and_not_touched():
    class Surprise:
        def __getattr__(self, name):
            raise RuntimeError("touched")

        def __eq__(self, other):
            return True

    assert to_plain(Surprise()) == {"object": "Surprise"}
    assert to_plain([Surprise()]) == [{"object": "Surprise"}]
    assert to_plain(Place) == {"object": "type"}  # a class is not what its members are
    assert to_plain(np.eye(2)) == {"array": [[1.0, 0.0], [0.0, 1.0]]}


def test_what_names_no_value_is_not_read():
    for plain in ({"object": "Surprise"}, {"raises": "KeyError"}, {"os": "system"}, {}):
        with pytest.raises(ValueError, match="unknown kind"):
            from_plain(plain)


def test_unanswered_is_the_dots_or_your_turn():
    assert is_unanswered(to_plain(...))
    assert is_unanswered(raised(NotImplementedError("your turn")))
    assert not is_unanswered(raised(NotImplementedError("later")))
    assert not is_unanswered(to_plain(None))
    assert is_unanswered(to_plain({"a": ..., "b": ...}))
    assert not is_unanswered(to_plain({"a": ..., "b": "past"}))
    assert not is_unanswered(to_plain({}))


class Frame(str, Enum):  # as most still write it; it prints as Frame.MAP
    MAP = "map"


@dataclass(frozen=True, slots=True)
class Place:
    x: float
    y: object


@pytest.mark.parametrize(
    ("value", "same"),
    [
        (Frame.MAP, "map"),
        (deque([1.0, 2.0], maxlen=2), [1.0, 2.0]),
        (np.float64(0.5), 0.5),
        (np.bool_(True), True),
        ({Frame.MAP: np.str_("odom")}, {"map": "odom"}),
        (np.array(["map", "odom"]), ["map", "odom"]),
        (np.array([1.0, None], dtype=object), [1.0, None]),
        (np.array({"x": 1}, dtype=object), {"x": 1}),
        (Place(1.0, Place(2, [3])), {"x": 1.0, "y": {"x": 2, "y": [3]}}),
        (map(float, "12"), [1.0, 2.0]),
        ((n for n in (1, 2)), [1, 2]),
    ],
)
def test_what_says_the_same_is_the_same(value, same):
    assert to_plain(value) == to_plain(same)


def test_what_does_not_end_is_refused():
    endless: list = []
    endless.append(endless)
    for value, why in ((endless, "too deep"), (count(), "too long"), (range(10**15), "too long")):
        with pytest.raises(ValueError, match=why):
            to_plain(value)
