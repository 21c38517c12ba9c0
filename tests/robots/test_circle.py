"""The lecture's circle slides sideways; the corrected circle drives forward."""

import pytest

from tflab.core import LATEST, seconds
from tflab.robots import circle
from tflab.ros import client_library as rclpy
from tflab.ros.graph import new_graph
from tflab.ros.node import Node
from tflab.ros.tf2.buffer import Buffer
from tflab.ros.tf2.topics import TransformListener


@pytest.mark.parametrize(
    ("heading", "forward_left_up"), [(circle.SIDEWAYS, (0.0, 0.2, 0.0)), (circle.FORWARD, (0.2, 0.0, 0.0))]
)
def test_the_velocity_in_body_axes_tells_the_two_apart(heading, forward_left_up):
    assert circle.body_velocity(heading) == pytest.approx(forward_left_up)
    for theta in (0.0, 0.5, 2.0):  # on the same circle
        assert circle.pose(theta, heading).translation == circle.pose(theta, circle.FORWARD).translation
    # tf2's own velocity, over half a second around 4 s, seen in the robot's axes
    measured = circle.buffer(until_s=5.0, heading=heading).lookup_velocity(
        "base_link", "odom", seconds(4.0), seconds(0.5), reference_frame="base_link"
    )
    assert measured.linear == pytest.approx(forward_left_up, abs=2e-3)
    assert measured.angular == pytest.approx((0.0, 0.0, 0.2), abs=1e-6)


@pytest.mark.parametrize(("main", "heading"), [(circle.main, circle.SIDEWAYS), (circle.main_forward, circle.FORWARD)])
def test_the_node_publishes_what_the_pure_circle_has(main, heading):
    graph = new_graph()
    rclpy.init(args=[])
    node = Node("listener")
    heard = Buffer()
    listener = TransformListener(heard, node)
    participant = graph.start(main, [])
    rclpy.spin_until_future_complete(node, rclpy.Future(), timeout_sec=2.0)
    graph.stop()
    assert not participant.is_running
    expected = circle.buffer(until_s=3.0, heading=heading).lookup_transform("odom", "base_link", LATEST)
    actual = heard.core.lookup_transform("odom", "base_link", LATEST)
    assert actual.stamp_ns == expected.stamp_ns == seconds(3.0)
    assert actual.transform.translation == pytest.approx(expected.transform.translation)
    assert actual.transform.rotation == pytest.approx(expected.transform.rotation)
    listener.unregister()
    rclpy.try_shutdown()
