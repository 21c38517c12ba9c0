"""What a page says of a bag: what was heard when, and how much of it the bag itself can place."""

import numpy as np
import pytest

from tflab.bags.recording import Connection, Headers, Recording, Transforms, recording_from_records
from tflab.core import StampedTransform, Transform, seconds
from tflab.core.transforms import TransformRecord
from tflab.ros.node import Node
from tflab.workbook import lesson


def edge(topic, parent, child, stamp_s, is_static=False):
    stamped = StampedTransform(parent, child, seconds(stamp_s), Transform())
    return TransformRecord(topic, seconds(stamp_s), "", stamped, is_static)


def bag(records, *topics):
    """A recording of transforms, with topics of (name, frame, stamps [s]), each heard 0.5 s after its stamp."""
    made = recording_from_records(records)
    headers = tuple(
        Headers(
            name, "", np.array([seconds(s + 0.5) for s in stamps]), np.array([seconds(s) for s in stamps]),
            np.zeros(len(stamps), dtype=int), (frame,),
        )
        for name, frame, stamps in topics
    )  # fmt: skip
    return Recording(
        "bag", (Connection("/tf", "", "", (), 3),), made.transforms, headers, begin_ns=made.begin_ns, end_ns=made.end_ns
    )


DRIVE = [edge("/tf", "map", "base", t) for t in (1.0, 2.0, 3.0)]
MOUNT = edge("/tf_static", "base", "laser", 1.0, is_static=True)


def test_a_message_is_placed_where_the_bag_has_its_transform_at_its_stamp():
    (scan,) = lesson.place_messages(bag([MOUNT, *DRIVE], ("/scan", "laser", (0.9, 1.5, 2.5))))
    assert (scan.placed, scan.count, scan.target) == (2, 3, "map")
    assert "into the past" in scan.first_no and str(scan).startswith("/scan  laser -> map: 2 of 3, first no: ")


def test_each_robot_is_asked_about_its_own_frames_and_messages_without_a_frame_are_left_out():
    rows = lesson.place_messages(bag([MOUNT, *DRIVE], ("/joints", "", (1.5,)), ("/scan", "/laser", (1.5,))))
    assert [(row.topic, row.frame, row.placed) for row in rows] == [("/scan", "laser", 1)]  # without ROS 1's slash
    records = [edge("/a/tf", "map", "a_base", t) for t in (1.0, 2.0)] + [edge("/b/tf", "map", "b_base", 1.0)]
    rows = lesson.place_messages(bag(records, ("/a/scan", "a_base", (1.5,)), ("/b/scan", "b_base", (1.0,))))
    assert [(row.topic, row.placed) for row in rows] == [("/a/scan", 1), ("/b/scan", 1)]


@pytest.mark.parametrize("records", [[], [MOUNT, *DRIVE]])
def test_what_was_heard_is_drawn_from_the_first_message_on(records):
    words = lesson.draw_heard(bag(records, ("/scan", "laser", (1.5,)))).text
    assert "/scan" in words and words.startswith("from -0.075 s to 3.000 s")
    assert ("/tf_static" in words) == bool(records)


def test_a_recording_with_nothing_that_has_a_stamp_is_drawn_too():
    empty = Transforms(*(np.zeros(0, dtype=int) for _ in range(4)), np.zeros((0, 7)), ())
    assert "nothing with a stamp" in lesson.draw_heard(Recording("empty", (), empty)).text


def test_what_is_left_out_counts_as_never_recorded():
    whole = bag([MOUNT, *DRIVE], ("/scan", "laser", (1.5, 2.5)))
    assert [row.placed for row in lesson.place_messages(whole, "map")] == [2]
    assert [row.placed for row in lesson.place_messages(bag([], ("/scan", "laser", (1.5,))))] == [0]
    (no_mounts,) = lesson.place_messages(whole, "map", leave_out=("/tf_static",))
    assert (no_mounts.placed, no_mounts.first_no[:7]) == (0, '"laser"')
    (no_motions,) = lesson.place_messages(whole, "map", leave_out=("/tf",))
    assert (no_motions.placed, no_motions.first_no[:5]) == (0, '"map"')


def test_a_replayed_bag_is_heard_the_next_day_by_a_node_that_lives_on(capsys):
    assert "nothing is wrong" in lesson.doctor(lesson.read_bag(lesson.example_bag(), show_progress=False))
    beside = ["localization"]
    made = lesson.replay(lambda: Node("listener"), lesson.example_bag(), "--clock", for_s=2.0, beside=beside)
    graph = lesson.current_graph()
    assert graph.now_ns == seconds(1.0 + 86400.0 + 2.0)
    assert made in graph.nodes
    assert {"rosbag2_player", "localization"} <= {node.get_name() for node in graph.nodes}
    assert capsys.readouterr().out == ""  # the player's own words would fill a page
    graph.stop()
