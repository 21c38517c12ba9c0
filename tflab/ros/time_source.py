"""Set the clock of a node from the parameter use_sim_time and the topic /clock.

```
use_sim_time: false   the graph's clock
use_sim_time: true    /clock (best effort, depth 1); 0 until the first message
```
"""

from __future__ import annotations

from typing import Any

from .clock import ROSClock
from .messages import rcl_interfaces, type_named
from .node_parameters import NodeParameters
from .parameter import Parameter
from .qos import QoSProfile, ReliabilityPolicy
from .time import ClockType, Time

__all__ = ["CLOCK_TOPIC", "USE_SIM_TIME_NAME", "TimeSource"]

CLOCK_TOPIC = "/clock"
USE_SIM_TIME_NAME = "use_sim_time"


class TimeSource:
    """Sets clocks to what /clock says, while that is wanted."""

    def __init__(self, *, node: Any = None) -> None:
        self._node: Any = None
        self._clock_sub: Any = None
        self._associated_clocks: list[ROSClock] = []
        self._active = False
        self._last_time = Time(clock_type=ClockType.ROS_TIME)
        if node is not None:
            self.attach_node(node)

    @property
    def ros_time_is_active(self) -> bool:
        """Whether /clock is followed."""
        return self._active

    @ros_time_is_active.setter
    def ros_time_is_active(self, enabled: bool) -> None:
        if self._active == enabled:
            return
        self._active = enabled
        for clock in self._associated_clocks:
            clock._set_ros_time_is_active(enabled)
        if enabled:
            self._subscribe()
        elif self._clock_sub is not None:
            self._node.destroy_subscription(self._clock_sub)
            self._clock_sub = None

    def attach_node(self, node: Any) -> None:
        """Follow a node's use_sim_time, declared here if it is not yet.

        Raises:
            TypeError: not a node.
        """
        if not isinstance(node, NodeParameters):
            raise TypeError("Node must be of type rclpy.node.Node")
        if self._node is not None:
            self.detach_node()
        self._node = node
        if not node.has_parameter(USE_SIM_TIME_NAME):
            node.declare_parameter(USE_SIM_TIME_NAME, False, rcl_interfaces.ParameterDescriptor(dynamic_typing=True))
        parameter = node.get_parameter(USE_SIM_TIME_NAME)
        if parameter.type_ == Parameter.Type.BOOL:
            self.ros_time_is_active = parameter.value
        elif parameter.type_ != Parameter.Type.NOT_SET:
            node.get_logger().error(
                f"Invalid type for parameter '{USE_SIM_TIME_NAME}' {parameter.type_!r} should be bool"
            )
        node.add_on_set_parameters_callback(self._on_parameters)

    def detach_node(self) -> None:
        """Follow nobody."""
        if self._clock_sub is not None:
            self._node.destroy_subscription(self._clock_sub)
            self._clock_sub = None
        self._node = None

    def _get_node(self) -> Any:
        """Return the node that is followed, None if nobody is; upstream's tests ask for it."""
        return self._node

    def attach_clock(self, clock: ROSClock) -> None:
        """Set this clock, too.

        Raises:
            ValueError: it is not a ROSClock.
        """
        if not isinstance(clock, ROSClock):
            raise ValueError("Only clocks with type ROS_TIME can be attached.")
        clock.set_ros_time_override(self._last_time)
        clock._set_ros_time_is_active(self._active)
        self._associated_clocks.append(clock)

    def clock_callback(self, msg: Any) -> None:
        """Set the clocks."""
        self._last_time = Time.from_msg(msg.clock)
        for clock in self._associated_clocks:
            clock.set_ros_time_override(self._last_time)

    def _subscribe(self) -> None:
        if self._clock_sub is None and self._node is not None:
            self._clock_sub = self._node.create_subscription(
                type_named("rosgraph_msgs/msg/Clock"),
                CLOCK_TOPIC,
                self.clock_callback,
                QoSProfile(depth=1, reliability=ReliabilityPolicy.BEST_EFFORT),
            )

    def _on_parameters(self, parameters: list[Parameter]) -> rcl_interfaces.SetParametersResult:
        for parameter in parameters:
            if parameter.name == USE_SIM_TIME_NAME and parameter.type_ != Parameter.Type.BOOL:
                reason = f"{USE_SIM_TIME_NAME} parameter set to something besides a bool"
                self._node.get_logger().error(reason)
                return rcl_interfaces.SetParametersResult(successful=False, reason=reason)
            if parameter.name == USE_SIM_TIME_NAME:
                self.ros_time_is_active = parameter.value
        return rcl_interfaces.SetParametersResult(successful=True)
