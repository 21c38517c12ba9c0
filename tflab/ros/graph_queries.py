"""Answer the queries about the graph that every node has.

One of the three mixins that Node is made of; see node.py for the other two.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import Any

from tflab.core import NSEC_PER_SEC

from . import distro
from .arguments import Arguments, parse_arguments
from .context import Context
from .logging import LoggingSeverity, get_logger_level, set_logger_level
from .messages import rcl_interfaces
from .messages.base import ros_type_of, service
from .names import full_node_name
from .network import Network
from .qos import QoSProfile

__all__ = ["GraphQueries", "TopicEndpointInfo", "TopicEndpointTypeEnum", "endpoint_info"]


class TopicEndpointTypeEnum(IntEnum):
    """Which side of a topic."""

    INVALID = 0
    PUBLISHER = 1
    SUBSCRIPTION = 2


@dataclass(frozen=True)
class TopicEndpointInfo:
    """One publisher or subscription, as discovery sees it."""

    node_name: str
    node_namespace: str
    topic_type: str
    endpoint_type: TopicEndpointTypeEnum
    endpoint_gid: list[int]
    qos_profile: QoSProfile


def endpoint_info(endpoint: Any) -> TopicEndpointInfo:
    """Return what discovery sees of a Publisher or Subscription."""
    return TopicEndpointInfo(
        node_name=endpoint.node.get_name(),
        node_namespace=endpoint.node.get_namespace(),
        topic_type=ros_type_of(endpoint.msg_type),
        endpoint_type=TopicEndpointTypeEnum[endpoint.endpoint_type],
        endpoint_gid=list(endpoint.gid),
        qos_profile=endpoint.qos_profile,
    )


class GraphQueries:
    """The part of Node that looks around.

    Borrows of Node: `network`, where everybody is listed; `context`, for waiting; and `resolve_topic_name()` and
    `resolve_service_name()`.
    """

    network: Network
    context: Context

    def get_node_names(self) -> list[str]:
        """Return the names of all nodes, without namespaces."""
        return [name for name, _ in self.get_node_names_and_namespaces()]

    def get_fully_qualified_node_names(self) -> list[str]:
        """Return the full names of all nodes."""
        return [full_node_name(name, namespace) for name, namespace in self.get_node_names_and_namespaces()]

    def get_node_names_and_namespaces(self) -> list[tuple[str, str]]:
        """Return (name, namespace) of all nodes, in the order they came."""
        return [(node.get_name(), node.get_namespace()) for node in self.network.nodes]

    def get_topic_names_and_types(self, no_demangle: bool = False) -> list[tuple[str, list[str]]]:
        """Return (topic, types) of everything published or subscribed."""
        return self.network.topic_names_and_types()

    def get_service_names_and_types(self) -> list[tuple[str, list[str]]]:
        """Return (service, types) of everything served."""
        return self.network.service_names_and_types()

    def get_publisher_names_and_types_by_node(
        self, node_name: str, node_namespace: str, no_demangle: bool = False
    ) -> list[tuple[str, list[str]]]:
        """Return (topic, types) of what one node publishes."""
        return self.network.topic_names_and_types(_of(node_name, node_namespace, "PUBLISHER"))

    def get_subscriber_names_and_types_by_node(
        self, node_name: str, node_namespace: str, no_demangle: bool = False
    ) -> list[tuple[str, list[str]]]:
        """Return (topic, types) of the subscriptions of one node."""
        return self.network.topic_names_and_types(_of(node_name, node_namespace, "SUBSCRIPTION"))

    def get_service_names_and_types_by_node(self, node_name: str, node_namespace: str) -> list[tuple[str, list[str]]]:
        """Return (service, types) of what one node serves."""
        return self.network.service_names_and_types(_of(node_name, node_namespace))

    def get_client_names_and_types_by_node(self, node_name: str, node_namespace: str) -> list[tuple[str, list[str]]]:
        """Return (service, types) of what one node asks."""
        return self.network.service_names_and_types(_of(node_name, node_namespace), clients=True)

    def count_publishers(self, topic_name: str) -> int:
        """Return how many publish a topic."""
        return len(self.network.topic(self.resolve_topic_name(topic_name)).publishers)

    def count_subscribers(self, topic_name: str) -> int:
        """Return how many hear a topic."""
        return len(self.network.topic(self.resolve_topic_name(topic_name)).subscriptions)

    def count_services(self, service_name: str) -> int:
        """Return how many serve a service."""
        distro.require("node_waits_and_counts", AttributeError, "'Node' object has no attribute 'count_services'")
        return len(self.network.services.get(self.resolve_service_name(service_name), []))

    def count_clients(self, service_name: str) -> int:
        """Return how many ask a service."""
        distro.require("node_waits_and_counts", AttributeError, "'Node' object has no attribute 'count_clients'")
        return len(self.network.clients.get(self.resolve_service_name(service_name), []))

    def get_publishers_info_by_topic(self, topic_name: str, no_mangle: bool = False) -> list[TopicEndpointInfo]:
        """Return who publishes a topic, and how."""
        return [endpoint_info(each) for each in self.network.topic(self.resolve_topic_name(topic_name)).publishers]

    def get_subscriptions_info_by_topic(self, topic_name: str, no_mangle: bool = False) -> list[TopicEndpointInfo]:
        """Return the subscriptions of a topic, with their QoS."""
        return [endpoint_info(each) for each in self.network.topic(self.resolve_topic_name(topic_name)).subscriptions]

    def wait_for_node(self, fully_qualified_node_name: str, timeout: float) -> bool:
        """Block until a node is there, at most `timeout` [s]; return whether it is."""
        distro.require("node_waits_and_counts", AttributeError, "'Node' object has no attribute 'wait_for_node'")
        name = fully_qualified_node_name
        name = name if name.startswith("/") else f"/{name}"
        process = self.context.process
        until_ns = process.driver.steady_ns() + round(timeout * NSEC_PER_SEC)
        while name not in self.get_fully_qualified_node_names():
            if process.driver.steady_ns() >= until_ns:
                return False
            process.sleep(POLL_NS)
        return True


POLL_NS = 100_000_000  # how often wait_for_node looks


def _of(node_name: str, namespace: str, endpoint_type: str | None = None) -> Any:
    """Return the test whether an endpoint is one node's."""
    full_name = full_node_name(node_name, namespace)

    def keep(end: Any) -> bool:
        right_side = endpoint_type is None or end.endpoint_type == endpoint_type
        return right_side and end.node.get_fully_qualified_name() == full_name

    return keep


def arguments_of(context: Context, cli_args: list[str] | None, use_global: bool) -> Arguments:
    """Return what the command line says to a node: its own arguments first, then the context's."""
    own = parse_arguments(cli_args or ())
    if not use_global:
        return own
    return Arguments(own.remaps + context.arguments.remaps, context.arguments.parameters + own.parameters)


# -- services that every node has besides those for parameters --------------------

# The answer of a real one describes the type's source; nobody here reads that.
GetTypeDescription = service(
    "type_description_interfaces/srv/GetTypeDescription",
    request="""
        string type_name
        string type_hash
        bool include_type_sources
    """,
    response="""
        bool successful
        string failure_reason
    """,
)


def add_type_description_service(node: Any) -> None:
    """Let a node serve ~/get_type_description, where the distribution has it."""
    if not distro.current().has_type_description:
        return

    def answer(request: Any, response: Any) -> Any:
        response.failure_reason = f"Type '{request.type_name}' is not described in this process"
        return response

    node.create_service(GetTypeDescription, "~/get_type_description", answer)


def add_logger_services(node: Any) -> None:
    """Let a node serve ~/get_logger_levels and ~/set_logger_levels."""

    def get_levels(request: Any, response: Any) -> Any:
        response.levels = [
            rcl_interfaces.LoggerLevel(name=name, level=int(get_logger_level(name))) for name in request.names
        ]
        return response

    def set_levels(request: Any, response: Any) -> Any:
        for wanted in request.levels:
            known = wanted.level in list(LoggingSeverity)
            if known:
                set_logger_level(wanted.name, wanted.level)
            response.results.append(
                rcl_interfaces.SetLoggerLevelsResult(successful=known, reason="" if known else "Invalid logger level")
            )
        return response

    node.create_service(rcl_interfaces.GetLoggerLevels, "~/get_logger_levels", get_levels)
    node.create_service(rcl_interfaces.SetLoggerLevels, "~/set_logger_levels", set_levels)
