"""What becomes of a robot that was only written down?  It is launched as the answer says, and RViz looks at it.

    {"tree": {...}, "moving": "/tf", "mounts": "/tf_static", ...}  -->  a node for each owner  -->  RViz: all Ok, or not

The edges above the base move, the rest is bolted on.  A frame that hangs nowhere, two
parents, two switches on: RViz shows of each what a real one would.

Read `waiting.py` next.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from typing import Any

from tflab.core import StampedTransform, Transform
from tflab.ros import client_library as rclpy
from tflab.ros.convert import msg_from_stamped
from tflab.ros.executors import ExternalShutdownException
from tflab.ros.graph import new_graph
from tflab.ros.messages import sensor_msgs
from tflab.ros.node import Node
from tflab.ros.tf2.broadcaster import StaticTransformBroadcaster, TransformBroadcaster
from tflab.tools.rviz import look
from tflab.views.rviz import RViz
from tflab.views.rviz_status import statuses_as_text

__all__ = ["launch_answer"]

RATE_HZ = 20.0
HEIGHTS_M = {"base_link": 0.1, "optical_frame": 0.0}


class Teller(Node):
    """Sends edges, again and again on /tf or once on /tf_static, and a scan in the frame of a sensor, if any."""

    def __init__(
        self, name: str, edges: Mapping[str, str], is_static: bool, sensor: str = "", slant: float = 0.0
    ) -> None:
        super().__init__(name)
        self._edges, self._slant = dict(edges), slant
        self._broadcaster = (StaticTransformBroadcaster if is_static else TransformBroadcaster)(self)
        self._scans = self.create_publisher(sensor_msgs.LaserScan, "/scan", 10) if sensor else None
        self._sensor = sensor
        self.tell()
        if not is_static or sensor:
            self.create_timer(1.0 / RATE_HZ, self.tell)

    def tell(self) -> None:
        """Send every edge as it is now."""
        now_ns = self.get_clock().now().nanoseconds
        moments = [
            StampedTransform(parent, child, now_ns, self._pose(child, now_ns)) for child, parent in self._edges.items()
        ]
        self._broadcaster.sendTransform([msg_from_stamped(moment) for moment in moments])
        if self._scans is not None:
            scan = sensor_msgs.LaserScan(angle_increment=0.1, ranges=[1.0] * 10, range_max=5.0)
            scan.header.frame_id, scan.header.stamp = self._sensor, self.get_clock().now().to_msg()
            self._scans.publish(scan)

    def _pose(self, child: str, now_ns: int) -> Transform:
        if isinstance(self._broadcaster, TransformBroadcaster):
            turn = 0.1 * now_ns * 1e-9 + self._slant
            return Transform.from_rpy(yaw=turn, translation=(math.sin(turn), 0.0, 0.0))
        rest = child.rpartition("/")[2]
        if rest.endswith("optical_frame"):
            return Transform.from_rpy(roll=-math.pi / 2.0, yaw=-math.pi / 2.0)
        return Transform((0.1, 0.0, HEIGHTS_M.get(rest, 0.2)))


def launch_answer(answer: Any, specification: Any) -> RViz | None:
    """Launch a robot as an answer describes it, print what RViz says of it, and return the small RViz.

    Args:
        answer: as E12.5 asks for it.
        specification: what `task("E12.5")` gave: the robot's name and its sensor.
    """
    if not isinstance(answer, Mapping) or not isinstance(answer.get("tree"), Mapping):
        print("E12.5: no robot yet")
        return None
    sensor_frame = f"{specification.robot}/{specification.sensor}_optical_frame"
    tree = {str(child): str(parent) for child, parent in answer["tree"].items()}
    moving = {child: parent for child, parent in tree.items() if child.rpartition("/")[2] in ("odom", "base_footprint")}
    bolted = {child: parent for child, parent in tree.items() if child not in moving}
    graph = new_graph()
    graph.start(lambda: _spin(lambda: Teller("localization_and_odometry", moving, False)), name="moving")
    if all(str(answer.get(switch)) == "True" for switch in ("wheel_odometry publish_tf", "ekf publish_tf")):
        feet = {child: parent for child, parent in moving.items() if child.endswith("base_footprint")}
        graph.start(lambda: _spin(lambda: Teller("second_owner", feet, False, slant=0.3)), name="second")
    is_static = answer.get("mounts") == "/tf_static"
    graph.start(lambda: _spin(lambda: Teller("robot_state_publisher", bolted, is_static, sensor_frame)), name="mounts")
    graph.run(seconds=2.0)
    view = RViz(*look(graph))
    graph.stop()
    print(statuses_as_text(view.shown))
    return view


def _spin(make: Callable[[], Node]) -> None:
    rclpy.init()
    try:
        rclpy.spin(make())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()
