"""The tree of a graph names its real publishers."""

from tools_robot import fixed, moving

from tflab.core import FrameSnapshot, Snapshot, Transform
from tflab.ros.snapshot import EdgeSnapshot
from tflab.tools.trees import frame_tree, with_publishers


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
    frame = FrameSnapshot("base_link", "map", False, ("default_authority",), ("map",), 2, 1.0, 1, 2, Transform())
    edges = [EdgeSnapshot("map", "base_link", "/tf", "/gps", 9), EdgeSnapshot("odom", "base_link", "/tf", "/ekf", 9)]
    (known,) = with_publishers(Snapshot(("map",), (frame,)), edges).frames
    assert (known.authorities, known.parents) == (("/ekf", "/gps"), ("map", "odom"))
