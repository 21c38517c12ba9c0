"""Our readers of a TFMessage see what rosbags wrote, with any names and numbers."""

import struct

import pytest
from hypothesis import given
from hypothesis import strategies as st
from rosbags.typesys import Stores, get_typestore

from tflab.bags.wire import (
    MalformedMessage,
    clock_in,
    header_in,
    names_of_single,
    single_in_cdr,
    transforms_in_cdr,
    transforms_in_ros1,
)

from .making_bags import ros1_store, tf_message

STORE2 = get_typestore(Stores.ROS2_HUMBLE)
STORE1 = ros1_store()
TYPE = "tf2_msgs/msg/TFMessage"

names = st.text(st.characters(codec="utf-8", exclude_characters="\0"), max_size=12)
numbers = st.tuples(*[st.floats(width=64, allow_nan=False)] * 7)
stamps = st.integers(0, 2**31 * 10**9 - 1)
rows = st.lists(st.tuples(stamps, names, names, numbers), max_size=4)


def decoded(transforms):
    return [
        (stamp, parent.decode(), child.decode(), struct.unpack("<7d", data))
        for stamp, parent, child, data in transforms
    ]


@given(rows)
def test_cdr_of_either_byte_order_is_read_as_rosbags_wrote_it(rows):
    for little_endian in (True, False):
        data = bytes(STORE2.serialize_cdr(tf_message(STORE2, rows), TYPE, little_endian=little_endian))
        assert decoded(transforms_in_cdr(data)) == rows


@given(rows)
def test_ros1_is_read_as_rosbags_wrote_it(rows):
    data = bytes(STORE1.serialize_ros1(tf_message(STORE1, rows, has_seq=True), TYPE))
    assert decoded(transforms_in_ros1(data)) == rows


@given(stamps, names, names, numbers)
def test_the_short_way_for_one_transform_agrees_with_the_long_one(stamp_ns, parent, child, pose):
    data = bytes(STORE2.serialize_cdr(tf_message(STORE2, [(stamp_ns, parent, child, pose)]), TYPE))
    assert names_of_single(data) is not None
    stamp, numbers_bytes = single_in_cdr(data)
    assert (stamp, struct.unpack("<7d", numbers_bytes)) == (stamp_ns, pose)


def test_messages_of_two_transforms_do_not_take_the_short_way():
    row = (1, "a", "b", (0.0,) * 7)
    assert names_of_single(bytes(STORE2.serialize_cdr(tf_message(STORE2, [row, row]), TYPE))) is None


@given(st.binary(max_size=120))
def test_any_other_bytes_are_refused_and_nothing_else_happens(data):
    for read in (transforms_in_cdr, transforms_in_ros1):
        try:
            list(read(data))
        except (MalformedMessage, struct.error):
            continue


def test_a_header_and_a_clock_are_read_in_both_encodings():
    cdr = b"\0\1\0\0" + struct.pack("<iII", 7, 8, 4) + b"map\0"
    assert header_in(cdr, is_ros1=False) == (7_000_000_008, b"map")
    assert clock_in(cdr, is_ros1=False) == 7_000_000_008
    ros1 = struct.pack("<IIII", 99, 7, 8, 3) + b"map"
    assert header_in(ros1, is_ros1=True) == (7_000_000_008, b"map")
    assert clock_in(ros1[4:], is_ros1=True) == 7_000_000_008


def test_an_encoding_that_is_not_plain_cdr_is_refused():
    with pytest.raises(MalformedMessage):
        header_in(b"\0\3\0\0" + bytes(20), is_ros1=False)
