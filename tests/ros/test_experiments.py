"""Two owners of one frame, as in section 23 of the lecture; tests/tools/test_lecture_commands.py has the rest of it."""

import pytest

from tflab.core import seconds
from tflab.ros import client_library as rclpy
from tflab.ros import snapshot
from tflab.ros.messages.geometry_msgs import TransformStamped
from tflab.ros.node import Node
from tflab.ros.tf2.buffer import Buffer
from tflab.ros.tf2.topics import TransformBroadcaster, TransformListener
from tflab.ros.time import Time


@pytest.fixture
def listen(graph):
    """Let a listener hear for a while [s]; return its buffer."""

    def listen_for(duration_s):
        node = Node("listener")
        buffer = Buffer()
        node.listener = TransformListener(buffer, node)
        until_ns = graph.now_ns + seconds(duration_s)
        while graph.now_ns < until_ns:
            rclpy.spin_once(node, timeout_sec=(until_ns - graph.now_ns) / 1e9)
        return buffer

    rclpy.init()
    yield listen_for
    rclpy.shutdown()


def test_c_samples_of_two_dynamic_publishers_are_interpolated(graph, listen):
    def owner(x, begins_after_s):
        def main():
            rclpy.init()
            node = Node(f"owner_{x:g}")
            broadcaster = TransformBroadcaster(node)

            def send():
                transform = TransformStamped(child_frame_id="base_link")
                transform.header.stamp = node.get_clock().now().to_msg()
                transform.header.frame_id = "odom"
                transform.transform.translation.x = x
                broadcaster.sendTransform(transform)

            def begin():
                first.cancel()
                node.create_timer(0.1, send)

            first = node.create_timer(begins_after_s, begin)
            rclpy.spin(node)

        return main

    # "1" at 1.2, 1.3, 1.4 ... s; "3" at 1.25, 1.35, 1.45 ... s
    graph.start(owner(1.0, 0.1))
    graph.start(owner(3.0, 0.15))
    buffer = listen(1.0)

    def x_at(at_s):
        stamp = Time(nanoseconds=seconds(at_s))
        return buffer.lookup_transform("odom", "base_link", stamp).transform.translation.x

    assert [x_at(1.4), x_at(1.45), x_at(1.5)] == [1.0, 3.0, 1.0]
    assert x_at(1.425) == pytest.approx(2.0)  # nobody ever said that
    assert x_at(1.4625) == pytest.approx(2.5)
    # What tf2 cannot tell, the graph can: who they are.
    owners = [edge.node for edge in snapshot(graph).edges if (edge.parent, edge.child) == ("odom", "base_link")]
    assert owners == ["/owner_1", "/owner_3"]
