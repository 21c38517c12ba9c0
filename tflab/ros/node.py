"""Provide rclpy.node.Node.

    Node("point_to_map", namespace="/robot")
      |-- publishers, subscriptions, timers, services, clients, guard conditions (node_entities.py)
      |-- parameters (node_parameters.py), and the services that reach them
      |-- what it sees of the others (graph_queries.py)
      `-- clock (ROS time; follows /clock if use_sim_time), logger

The first three are mixins over one `self`: each says at its class what it borrows of Node.
"""

from __future__ import annotations

import itertools
import weakref
from typing import Any

from . import distro, graph_queries
from .clock import Clock, ROSClock
from .context import Context
from .convert import plain_names
from .entity import CallbackGroup, Entity, MutuallyExclusiveCallbackGroup
from .exceptions import NotInitializedException
from .graph import current_process
from .logging import RcutilsLogger
from .messages import rcl_interfaces
from .names import expanded, full_node_name, validate_namespace, validate_node_name, validate_topic_name
from .node_entities import NodeEntities
from .node_parameters import NodeParameters
from .parameter import Parameter
from .parameter_services import ParameterService
from .qos import (
    qos_profile_parameter_events,
    qos_profile_rosout_default,
)
from .qos_compatibility import QoSPolicyKind, qos_policy_name_from_kind
from .time import ClockType, Time
from .time_source import TimeSource
from .topic_endpoints import Publisher

__all__ = ["Node"]


class Node(graph_queries.GraphQueries, NodeEntities, NodeParameters):
    """A node.

    Args:
        node_name: unique in its namespace, one should think; it is not checked, as in ROS 2.
        context: the process's default one if None.
        cli_args: `--ros-args` for this node alone.
        namespace: put before its name and its relative topics.
        use_global_arguments: whether the arguments of rclpy.init() apply to it.
        enable_rosout: whether its log lines go to /rosout, too.
        start_parameter_services: whether its parameters can be reached from outside.
        parameter_overrides: values that win over the defaults of declare_parameter.
        allow_undeclared_parameters: whether any name can be set.
        automatically_declare_parameters_from_overrides: declare those of parameter_overrides at once.

    Raises:
        NotInitializedException: rclpy.init() has not been called.
        InvalidNodeNameException, InvalidNamespaceException: a malformed name.
    """

    def __init__(
        self,
        node_name: str,
        *,
        context: Context | None = None,
        cli_args: list[str] | None = None,
        namespace: str | None = None,
        use_global_arguments: bool = True,
        enable_rosout: bool = True,
        start_parameter_services: bool = True,
        parameter_overrides: list[Parameter] | None = None,
        allow_undeclared_parameters: bool = False,
        automatically_declare_parameters_from_overrides: bool = False,
        enable_logger_service: bool = False,
    ) -> None:
        if context is None:
            context = current_process().default_context
        if context is None or not context.ok():
            raise NotInitializedException("cannot create node")
        self._context = context
        self._arguments = graph_queries.arguments_of(context, cli_args, use_global_arguments)
        self._set_names(node_name, namespace or "")
        self.network = context.process.graph.network
        self.pending: dict[Entity, None] = {}
        self._init_entities()
        self._ranks = itertools.count()
        self._executor: weakref.ref | None = None
        self._is_destroyed = False
        self._default_callback_group = MutuallyExclusiveCallbackGroup()
        self._clock = ROSClock()
        self._time_source: TimeSource | None = None  # a node whose making fails is taken away, too
        context.process.graph.add_node(self)
        context.track_node(self)

        self._rosout: Publisher | None = None
        self._parameter_event_publisher: Publisher | None = None
        name, process = self.get_fully_qualified_name().strip("/").replace("/", "."), context.process
        self._logger = RcutilsLogger(name, lambda: process.driver.now_ns() + self._clock.offset_ns, self._publish_log)
        overrides = self._arguments.parameters_of(self.get_fully_qualified_name())
        overrides = {name: Parameter(name, value=value) for name, value in overrides.items()}
        overrides |= {each.name: each for each in parameter_overrides or ()}
        self._init_parameters(overrides, allow_undeclared_parameters)
        if enable_rosout:
            self._rosout = self.create_publisher(rcl_interfaces.Log, "/rosout", qos_profile_rosout_default)
        self._parameter_event_publisher = self.create_publisher(
            rcl_interfaces.ParameterEvent, "/parameter_events", qos_profile_parameter_events
        )
        if automatically_declare_parameters_from_overrides:
            for parameter in overrides.values():
                self.declare_parameter(
                    parameter.name, parameter.value, rcl_interfaces.ParameterDescriptor(dynamic_typing=True)
                )
        self._time_source = TimeSource(node=self)
        self._time_source.attach_clock(self._clock)
        if start_parameter_services:
            self._parameter_service = ParameterService(self)
            graph_queries.add_type_description_service(self)
        if enable_logger_service:
            graph_queries.add_logger_services(self)

    def _set_names(self, name: str, namespace: str) -> None:
        name, namespace = plain_names(name, namespace)
        validate_node_name(name)
        if not namespace.startswith("/"):
            namespace = f"/{namespace}"
        validate_namespace(namespace)
        self._name = self._arguments.remapped(name, "__node")
        self._name = name if self._name == "__node" else self._name
        remapped = self._arguments.remapped(name, "__ns")
        self._namespace = namespace if remapped == "__ns" else remapped
        validate_node_name(self._name)
        validate_namespace(self._namespace)

    # -- who it is --------------------------------------------------------------------

    def get_name(self) -> str:
        """Return its name, without namespace."""
        return self._name

    def get_namespace(self) -> str:
        """Return its namespace, "/" for the root."""
        return self._namespace

    def get_fully_qualified_name(self) -> str:
        """Return "/namespace/name"."""
        return full_node_name(self._name, self._namespace)

    def get_logger(self) -> RcutilsLogger:
        """Return its logger."""
        return self._logger

    def policy_name(self, policy: str) -> str:
        """Return what a policy of QoS is called in its log; rclpy and rclcpp differ."""
        return qos_policy_name_from_kind(QoSPolicyKind[policy])

    def get_clock(self) -> Clock:
        """Return its clock: ROS time."""
        return self._clock

    @property
    def context(self) -> Context:
        """The context it lives in."""
        return self._context

    @property
    def default_callback_group(self) -> CallbackGroup:
        """The group of its callbacks that are not put in another."""
        return self._default_callback_group

    @property
    def handle(self) -> Node:
        """What rclpy's lower layer knows it by."""
        return self

    @property
    def executor(self) -> Any:
        """The executor that runs its callbacks, None if nobody does."""
        return self._executor() if self._executor is not None else None

    @executor.setter
    def executor(self, new: Any) -> None:
        old = self.executor
        if old is new:
            return
        self._executor = None if new is None else weakref.ref(new)
        if old is not None:
            old.remove_node(self)
        if new is not None and self not in new.get_nodes():
            new.add_node(self)

    # -- its end ---------------------------------------------------------------------------

    def destroy_node(self) -> None:
        """Leave the graph with everything; harmless the second time."""
        self.leave_graph()

    def leave_graph(self) -> None:
        """Do what destroy_node() does, also where that is overridden."""
        if self._is_destroyed:
            return
        self._is_destroyed = True
        executor = self.executor
        if executor is not None:
            executor.remove_node(self)
        if self._time_source is not None:
            self._time_source.detach_node()
        self._parameter_event_publisher = None
        self._rosout = None
        self._destroy_entities()
        self._context.untrack_node(self)
        self._context.process.graph.remove_node(self)

    def __enter__(self) -> Node:
        text = f"'{type(self).__name__}' object does not support the context manager protocol"
        distro.require("init_is_context", TypeError, text)
        return self

    def __exit__(self, *exc: object) -> None:
        self.destroy_node()

    # -- names ------------------------------------------------------------------------------

    def resolve_topic_name(self, topic: str, *, only_expand: bool = False) -> str:
        """Return the absolute, remapped name of a topic as this node means it."""
        return self._topic_named(topic, only_expand=only_expand)

    def resolve_service_name(self, service: str, *, only_expand: bool = False) -> str:
        """Return the absolute, remapped name of a service as this node means it."""
        return self._topic_named(service, is_service=True, only_expand=only_expand)

    def next_rank(self) -> int:
        """Return the next entity's place in the order of creation."""
        return next(self._ranks)

    # -- inside -------------------------------------------------------------------------------

    def _topic_named(self, name: str, is_service: bool = False, only_expand: bool = False) -> str:
        validate_topic_name(name, is_service=is_service)
        full = expanded(name, self._name, self._namespace)
        if only_expand:
            return full
        return self._arguments.remapped(self._name, full, lambda each: expanded(each, self._name, self._namespace))

    def _publish_log(
        self, stamp_ns: int, severity: int, name: str, message: str, file: str, function: str, line: int
    ) -> None:
        if self._rosout is not None and self.context.ok():
            stamp = Time(nanoseconds=max(0, stamp_ns), clock_type=ClockType.ROS_TIME).to_msg()
            log = rcl_interfaces.Log(
                stamp=stamp, level=int(severity), name=name, msg=message, file=file, function=function, line=line
            )
            self._rosout.publish(log)
