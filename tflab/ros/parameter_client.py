"""How does a node read and set the parameters of another?  A client for each of its parameter services.

```
client = AsyncParameterClient(node, "localization")     a name as this node means it
future = client.set_parameters([Parameter("tf_broadcast", value=False)])
rclpy.spin_until_future_complete(node, future)
future.result().results[0].successful
```
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Any

from tflab.core import NSEC_PER_SEC

from .messages import rcl_interfaces
from .parameter import Parameter, parameter_dict_from_yaml_file
from .qos import QoSProfile, qos_profile_parameter_events, qos_profile_services_default
from .task import Future

__all__ = ["AsyncParameterClient"]

POLL_S = 0.25  # how often wait_for_services looks
Done = Callable[[Future], Any]


class AsyncParameterClient:
    """Asks the parameter services of one node; every question returns a Future of the service's response.

    Args:
        node: who asks; somebody must spin it.
        remote_node_name: whose parameters; relative to the namespace of `node` unless it begins with a slash.
    """

    def __init__(
        self,
        node: Any,
        remote_node_name: str,
        qos_profile: QoSProfile = qos_profile_services_default,
        callback_group: Any = None,
    ) -> None:
        self.node = node
        self.remote_node_name = remote_node_name

        def client(srv_type: type, name: str) -> Any:
            service = f"{remote_node_name}/{name}"
            return node.create_client(srv_type, service, qos_profile=qos_profile, callback_group=callback_group)

        self._get_parameter_client = client(rcl_interfaces.GetParameters, "get_parameters")
        self._list_parameter_client = client(rcl_interfaces.ListParameters, "list_parameters")
        self._set_parameter_client = client(rcl_interfaces.SetParameters, "set_parameters")
        self._get_parameter_types_client = client(rcl_interfaces.GetParameterTypes, "get_parameter_types")
        self._describe_parameters_client = client(rcl_interfaces.DescribeParameters, "describe_parameters")
        self._set_parameters_atomically_client = client(
            rcl_interfaces.SetParametersAtomically, "set_parameters_atomically"
        )

    def services_are_ready(self) -> bool:
        """Return whether all six services of the other node are there."""
        clients = (
            self._list_parameter_client,
            self._set_parameter_client,
            self._get_parameter_client,
            self._get_parameter_types_client,
            self._describe_parameters_client,
            self._set_parameters_atomically_client,
        )
        return all(client.service_is_ready() for client in clients)

    def wait_for_services(self, timeout_sec: float | None = None) -> bool:
        """Block until they are there, at most `timeout_sec` [s], in steps of 0.25 s; return whether they are."""
        left_s = math.inf if timeout_sec is None else timeout_sec
        while not self.services_are_ready() and left_s > 0.0:
            self.node.context.process.sleep(round(POLL_S * NSEC_PER_SEC))
            left_s -= POLL_S
        return self.services_are_ready()

    def list_parameters(
        self, prefixes: list[str] | None = None, depth: int | None = None, callback: Done | None = None
    ) -> Future:
        """Ask for the names, of all parameters or of those below the prefixes."""
        request = rcl_interfaces.ListParameters.Request(prefixes=prefixes or [], depth=depth or 0)
        return _asked(self._list_parameter_client, request, callback)

    def get_parameters(self, names: list[str], callback: Done | None = None) -> Future:
        """Ask for the values of some parameters."""
        return _asked(self._get_parameter_client, rcl_interfaces.GetParameters.Request(names=names), callback)

    def get_parameter_types(self, names: list[str], callback: Done | None = None) -> Future:
        """Ask for the types of some parameters."""
        return _asked(self._get_parameter_types_client, rcl_interfaces.GetParameterTypes.Request(names=names), callback)

    def describe_parameters(self, names: list[str], callback: Done | None = None) -> Future:
        """Ask for the descriptors of some parameters."""
        request = rcl_interfaces.DescribeParameters.Request(names=names)
        return _asked(self._describe_parameters_client, request, callback)

    def set_parameters(
        self, parameters: Sequence[Parameter | rcl_interfaces.Parameter], callback: Done | None = None
    ) -> Future:
        """Have parameters set, each by itself: one may be refused and the next one not."""
        request = rcl_interfaces.SetParameters.Request(parameters=_messages(parameters))
        return _asked(self._set_parameter_client, request, callback)

    def set_parameters_atomically(
        self, parameters: Sequence[Parameter | rcl_interfaces.Parameter], callback: Done | None = None
    ) -> Future:
        """Have parameters set, all or none."""
        request = rcl_interfaces.SetParametersAtomically.Request(parameters=_messages(parameters))
        return _asked(self._set_parameters_atomically_client, request, callback)

    def delete_parameters(self, names: list[str], callback: Done | None = None) -> Future:
        """Have parameters undeclared; only those with dynamic typing can be."""
        return self.set_parameters([Parameter(name) for name in names], callback)

    def load_parameter_file(
        self, parameter_file: str, use_wildcard: bool = False, callback: Done | None = None
    ) -> Future:
        """Have what is in a YAML file set, each by itself; `use_wildcard` takes "/**" as well."""
        return self.set_parameters(_read(parameter_file, use_wildcard), callback)

    def load_parameter_file_atomically(
        self, parameter_file: str, use_wildcard: bool = False, callback: Done | None = None
    ) -> Future:
        """Have what is in a YAML file set, all or none."""
        return self.set_parameters_atomically(_read(parameter_file, use_wildcard), callback)

    def on_parameter_event(
        self, callback: Callable[..., Any], qos_profile: QoSProfile = qos_profile_parameter_events, **options: Any
    ) -> Any:
        """Return a subscription to what any node says of its parameters; `options` are create_subscription's."""
        return self.node.create_subscription(
            rcl_interfaces.ParameterEvent, "/parameter_events", callback, qos_profile, **options
        )


def _asked(client: Any, request: Any, callback: Done | None) -> Future:
    future = client.call_async(request)
    if callback is not None:
        future.add_done_callback(callback)
    return future


def _messages(parameters: Sequence[Parameter | rcl_interfaces.Parameter]) -> list[rcl_interfaces.Parameter]:
    return [each.to_parameter_msg() if isinstance(each, Parameter) else each for each in parameters]


def _read(parameter_file: str, use_wildcard: bool) -> list[rcl_interfaces.Parameter]:
    return list(parameter_dict_from_yaml_file(parameter_file, use_wildcard).values())
