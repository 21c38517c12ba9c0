"""Views of a buffer: the right edges, the right answer, whichever kind of buffer it is."""

from pathlib import Path

import pytest
import yaml

from tflab.core import BufferCore, LookupException, StampedTransform, Transform, seconds
from tflab.ros.tf2.buffer import Buffer
from tflab.tools.trees import draw_buffer, draw_history, edges_between

CASES = yaml.safe_load(Path(__file__).with_suffix(".yaml").read_text(encoding="utf-8"))


def filled(core):
    """map -> odom -> base_link -> (laser_frame, camera_link), and a tree apart."""
    for stamp_s in (1.0, 2.0, 3.0):
        core.set_transform(StampedTransform("map", "odom", seconds(stamp_s), Transform()))
        core.set_transform(StampedTransform("odom", "base_link", seconds(stamp_s), Transform((stamp_s, 0.0, 0.0))))
    for parent, child in (("base_link", "laser_frame"), ("base_link", "camera_link"), ("odm", "lost")):
        core.set_transform(StampedTransform(parent, child, 0, Transform((0.2, 0.0, 0.0))), is_static=True)
    return core


@pytest.mark.parametrize(("target", "source", "children"), CASES["edges"])
def test_the_edges_between_two_frames_begin_at_the_target(target, source, children):
    assert edges_between(filled(BufferCore()).snapshot(), target, source) == children


def test_a_loop_is_walked_once():
    core = BufferCore()
    for parent, child in (("a", "b"), ("b", "c"), ("c", "a")):
        core.set_transform(StampedTransform(parent, child, seconds(1), Transform()))
    assert edges_between(core.snapshot(), "a", "c") == ["b", "c"]


def test_the_history_has_a_lane_for_each_edge_and_the_answer():
    picture = draw_history(filled(BufferCore()), "map", "laser_frame", seconds(2.5))
    assert [lane.name for lane in picture.timeline.lanes] == [
        "map -> odom", "odom -> base_link", "base_link -> laser_frame",
    ]  # fmt: skip
    assert "translation (2.700, 0.000, 0.000) m" in picture.text  # halfway between 2 and 3 m, and 0.2 m ahead
    assert "ExtrapolationException" in draw_history(filled(BufferCore()), "map", "base_link", seconds(9)).text
    with pytest.raises(LookupException, match='"nope"'):
        draw_history(filled(BufferCore()), "map", "nope")


def test_a_buffer_of_tf2_ros_is_drawn_as_well(graph):
    buffer = Buffer()
    filled(buffer.core)
    assert draw_buffer(buffer, seconds(3)).text == draw_buffer(buffer.core, seconds(3)).text
