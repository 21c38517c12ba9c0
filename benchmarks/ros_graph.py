"""How long does 20 s of a simulated robot take?  10 nodes, 30 frames at 50 Hz, a TransformListener in each node.

    python benchmarks/ros_graph.py

The aim is less than 2 s of CPU on one core.  A chain of 30 frames is published in
one message 50 times a second; each node listens, and one looks up the whole chain
10 times a second.
"""

from __future__ import annotations

import time

from tflab.ros import activate, new_graph

activate("in-process")

import rclpy  # noqa: E402 - ours, once activated
from geometry_msgs.msg import TransformStamped  # noqa: E402
from rclpy.node import Node  # noqa: E402
from rclpy.time import Time  # noqa: E402
from tf2_ros import Buffer, TransformBroadcaster, TransformListener  # noqa: E402

SECONDS = 20.0
NODES = 10
FRAMES = 30
RATE_HZ = 50.0


def robot() -> None:
    """Publish the whole chain, again and again, and listen."""
    rclpy.init()
    node = Node("robot")
    node.listener = TransformListener(Buffer(), node)
    broadcaster = TransformBroadcaster(node)

    def tick() -> None:
        stamp = node.get_clock().now().to_msg()
        transforms = []
        for number in range(FRAMES):
            transform = TransformStamped()
            transform.header.stamp = stamp
            transform.header.frame_id = f"link{number}"
            transform.child_frame_id = f"link{number + 1}"
            transform.transform.translation.x = 0.1
            transforms.append(transform)
        broadcaster.sendTransform(transforms)

    node.create_timer(1.0 / RATE_HZ, tick)
    rclpy.spin(node)


def listener(number: int) -> None:
    """Listen; the first one also asks."""
    rclpy.init()
    node = Node(f"listener{number}")
    buffer = Buffer()
    node.listener = TransformListener(buffer, node)
    if number == 0:
        node.create_timer(0.1, lambda: buffer.can_transform("link0", f"link{FRAMES}", Time()))
    rclpy.spin(node)


def main() -> None:
    graph = new_graph()
    graph.start(robot)
    for number in range(NODES - 1):
        graph.start(listener, number)
    cpu_s = time.process_time()
    graph.run(seconds=SECONDS)
    cpu_s = time.process_time() - cpu_s
    graph.stop()
    stored = round(SECONDS * RATE_HZ) * FRAMES * NODES
    print(f"{SECONDS:g} s, {NODES} nodes, {FRAMES} frames at {RATE_HZ:g} Hz: {cpu_s:.2f} s of CPU")
    print(f"{stored} transforms stored, {cpu_s / stored * 1e6:.1f} us each, everything included")


if __name__ == "__main__":
    main()
