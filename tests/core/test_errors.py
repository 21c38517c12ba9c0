"""What exceptions tell beyond tf2's text."""

from __future__ import annotations

import pickle

import pytest

from tflab.core import (
    BufferCore,
    ConnectivityException,
    ExtrapolationException,
    InvalidArgumentException,
    LookupException,
    StampedTransform,
    Transform,
    TransformException,
    seconds,
)


@pytest.fixture
def buffer() -> BufferCore:
    #  map --(static)--> odom --(1 s, 2 s)--> base_link        island --(static)--> palm
    buffer = BufferCore()
    buffer.set_transform(StampedTransform("map", "odom", 0, Transform()), is_static=True)
    buffer.set_transform(StampedTransform("odom", "base_link", seconds(1), Transform((1, 0, 0))))
    buffer.set_transform(StampedTransform("odom", "base_link", seconds(2), Transform((2, 0, 0))))
    buffer.set_transform(StampedTransform("island", "palm", 0, Transform()), is_static=True)
    return buffer


def error_of(buffer: BufferCore, *question) -> TransformException:
    with pytest.raises(TransformException) as raised:
        buffer.lookup_transform(*question)
    return raised.value


def test_an_unknown_name_suggests_the_one_that_was_meant_or_lists_those_that_are_known(buffer: BufferCore) -> None:
    error = error_of(buffer, "map", "base_lnk", 0)
    assert isinstance(error, LookupException)
    assert str(error) == '"base_lnk" passed to lookupTransform argument source_frame does not exist. '
    assert error.frame == "base_lnk"
    assert "base_link" in error.hint
    hint = error_of(buffer, "map", "zebra", 0).hint
    assert 'Who publishes "zebra"' in hint and "map" in hint


def test_two_trees_are_named_by_their_roots_and_a_leading_slash_is_an_invalid_argument(buffer: BufferCore) -> None:
    error = error_of(buffer, "palm", "base_link", 0)
    assert isinstance(error, ConnectivityException)
    assert (error.target_root, error.source_root) == ("island", "map")
    error = error_of(buffer, "/map", "base_link", 0)
    assert isinstance(error, InvalidArgumentException)
    assert "'map', not '/map'" in error.hint


@pytest.mark.parametrize(
    ("stamp_ns", "direction", "bound_ns", "word"),
    [(seconds(3), "future", seconds(2), "wait"), (seconds(0.5), "past", seconds(1), "clock")],
)
def test_an_extrapolation_names_the_edge_and_the_distance(buffer, stamp_ns, direction, bound_ns, word) -> None:
    error = error_of(buffer, "map", "base_link", stamp_ns)
    assert isinstance(error, ExtrapolationException)
    assert (error.direction, error.parent, error.frame) == (direction, "odom", "base_link")
    assert (error.requested_ns, error.bound_ns) == (stamp_ns, bound_ns)
    assert word in error.hint


def test_exceptions_can_be_pickled_and_have_tf2s_names(buffer: BufferCore) -> None:
    error = error_of(buffer, "map", "base_link", seconds(3))
    copy = pickle.loads(pickle.dumps(error))
    assert (type(copy), str(copy), vars(copy)) == (type(error), str(error), vars(error))
    assert repr(LookupException) == "<class 'tf2.LookupException'>"
