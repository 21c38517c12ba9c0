"""The tree of a graph names its real publishers."""

import pytest

from tflab.core import FrameSnapshot, Snapshot, Transform
from tflab.robots.nodes import launch
from tflab.ros.snapshot import EdgeSnapshot
from tflab.tools.rviz import look
from tflab.tools.session import result_of
from tflab.tools.trees import frame_tree, with_publishers

from .robot import fixed, moving


def test_who_publishes_each_edge(graph):
    graph.start(moving(name="ekf"))
    graph.start(fixed(name="robot_state_publisher"))
    assert str(frame_tree(graph)) == (
        "odom\n"
        "└─ base_link       D  20.2 Hz  0.050 s  /ekf\n"
        "   └─ laser_frame  S                    /robot_state_publisher"
    )


def test_a_second_owner_is_a_fault_with_both_names(graph):
    graph.start(moving(name="ekf"))
    graph.start(moving(name="wheel_odometry", rate_hz=16.0))
    (fault,) = frame_tree(graph).faults
    assert fault.text.startswith("odom -> base_link has 2 publishers: /ekf, /wheel_odometry.")


def test_a_publisher_that_has_fallen_silent_is_no_owner(graph):
    first = graph.start(moving(name="ekf"))
    graph.start(moving(name="wheel_odometry"))
    graph.run(seconds=1)
    graph.stop(first)
    assert frame_tree(graph).faults == ()


def test_afterwards_the_graph_is_as_before_but_later(graph):
    frame_tree(graph, seconds=2.0)
    assert graph.nodes == []
    assert graph.now_ns == 3_000_000_000


def test_two_parents_from_two_publishers_are_both_known():
    heard = (("map", "default_authority"),)
    frame = FrameSnapshot("base_link", "map", False, heard, 2, 1.0, 1, 2, Transform())
    edges = [EdgeSnapshot("map", "base_link", "/tf", "/gps", 9), EdgeSnapshot("odom", "base_link", "/tf", "/ekf", 9)]
    (known,) = with_publishers(Snapshot(("map",), (frame,)), edges).frames
    assert known.owners == (("map", "/gps"), ("odom", "/ekf"))


def test_who_publishes_another_parent_is_not_made_an_owner_of_this_edge(graph):
    launch(graph)
    graph.start(moving("map", "base_footprint", name="eager_localizer"))
    (fault,) = frame_tree(graph).faults
    assert fault.text == (
        "base_footprint has 2 parents: map (from /eager_localizer), odom (from /wheel_odometry). "
        "It jumps from one to the other."
    )


@pytest.mark.parametrize("seconds", [-1, "x", float("nan")])
@pytest.mark.parametrize("view", [frame_tree, look])
def test_a_time_to_look_must_be_one(graph, view, seconds):
    with pytest.raises(ValueError, match="how long to look is a time in seconds, 0 or more"):
        view(graph, seconds=seconds)
    assert graph.participants == []


def test_a_look_that_fails_says_why(graph, capsys):
    def broken():
        raise KeyError("mine")

    with pytest.raises(RuntimeError, match='"peek" was ended before it had seen anything'):
        result_of(graph, broken, 1.0, name="peek")
    assert capsys.readouterr().err.endswith("KeyError: 'mine'\n")
