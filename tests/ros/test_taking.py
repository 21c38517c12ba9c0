"""An executor takes what is ready before it calls back, so that nothing is handled twice."""

import pytest

from tflab.ros import client_library as rclpy
from tflab.ros.entity import ReentrantCallbackGroup
from tflab.ros.executors import MultiThreadedExecutor, SingleThreadedExecutor
from tflab.ros.graph import new_graph
from tflab.ros.messages.std_msgs import String
from tflab.ros.node import Node


@pytest.mark.parametrize("executor_class", [SingleThreadedExecutor, MultiThreadedExecutor])
def test_each_tick_and_each_message_is_handled_once_even_in_a_reentrant_group(executor_class):
    ticks, heard = [], []

    def main():
        rclpy.init()
        node, group = Node("n"), ReentrantCallbackGroup()
        publisher = node.create_publisher(String, "chatter", 10)
        node.create_subscription(String, "chatter", heard.append, 10, callback_group=group)

        def tick():
            ticks.append(1)
            publisher.publish(String())

        node.create_timer(0.5, tick, callback_group=group)
        executor = executor_class()
        executor.add_node(node)
        executor.spin()

    graph = new_graph()
    graph.start(main)
    graph.run(seconds=2.2)
    graph.stop()
    assert (len(ticks), len(heard)) == (4, 4)
