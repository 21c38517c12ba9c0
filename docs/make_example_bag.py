"""Record the bag that the package brings: ten seconds of our robot, on this machine's own clock.

    .venv/bin/python docs/make_example_bag.py     writes tflab/bags/data/kitchen/

It is a recording, not a build: stamps are of the day, and what jitters is this
machine.  So it comes out differently each time, and the page and the tests that tell
its numbers have to be read again.
"""

from __future__ import annotations

import shutil
import time

from tflab.bags.info import example_bag
from tflab.bags.record import BagWriter, Recorder
from tflab.core import seconds
from tflab.robots.motion import Drive
from tflab.robots.nodes import USUAL_NODES, launch
from tflab.robots.teaching import SOURCES, TeachingRobot
from tflab.ros import client_library as rclpy
from tflab.ros.graph import Graph
from tflab.ros.node import Node

TOPICS = ("/scan", "/tf", "/tf_static")
DRIVES_BEFORE_S = 3.0  # the recorder comes later than the robot, as in life
RECORDS_S = 10.0


def record(writer: BagWriter) -> None:
    """Record the topics until stopped."""
    rclpy.init(args=[])
    node = Node("rosbag2_recorder")
    Recorder(node, writer, TOPICS.__contains__, TOPICS)
    rclpy.spin(node)


def main() -> None:
    """Drive, record, and put the bag where the package has it."""
    path = example_bag()
    shutil.rmtree(path, ignore_errors=True)
    path.parent.mkdir(exist_ok=True)
    graph = Graph(virtual=False)
    sources = {"laser": SOURCES["laser"]._replace(rate_hz=5.0)}
    robot = TeachingRobot(Drive(start_ns=graph.now_ns + seconds(1.0)), sources=sources)
    launch(graph, robot, only=[name for name in USUAL_NODES if name not in ("object_detector", "imu_driver")])
    time.sleep(DRIVES_BEFORE_S)
    with BagWriter(path) as writer:
        recorder = graph.start(record, writer)
        time.sleep(RECORDS_S)
        graph.stop(recorder)
    graph.stop()


if __name__ == "__main__":
    main()
