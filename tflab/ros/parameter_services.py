"""Serve a node's parameters, and read, set and watch the parameters of other nodes.

    /node/get_parameters, set_parameters, list_parameters, ...    as `ros2 param` calls them

    client = AsyncParameterClient(node, "localization")
    future = client.set_parameters([Parameter("tf_broadcast", value=False)])
    rclpy.spin_until_future_complete(node, future)
    future.result().results[0].successful

    /parameter_events --> handler --> callback(parameter)   of one parameter of one node
                             `------> callback(event)       of every event

Callbacks run in reverse order of registration, as in rclpy.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from typing import Any

from tflab.core import NSEC_PER_SEC

from .exceptions import ParameterNotDeclaredException
from .messages import rcl_interfaces
from .parameter import Parameter, parameter_dict_from_yaml_file
from .qos import QoSProfile, qos_profile_parameter_events, qos_profile_parameters, qos_profile_services_default
from .task import Future

__all__ = [
    "AsyncParameterClient",
    "ParameterCallbackHandle",
    "ParameterEventCallbackHandle",
    "ParameterEventHandler",
    "ParameterService",
]


class ParameterService:
    """The services that every node offers."""

    def __init__(self, node: Any) -> None:
        self._node = node
        for srv_type, name, callback in (
            (rcl_interfaces.DescribeParameters, "describe_parameters", self._describe),
            (rcl_interfaces.GetParameters, "get_parameters", self._get),
            (rcl_interfaces.GetParameterTypes, "get_parameter_types", self._get_types),
            (rcl_interfaces.ListParameters, "list_parameters", self._list),
            (rcl_interfaces.SetParameters, "set_parameters", self._set),
            (rcl_interfaces.SetParametersAtomically, "set_parameters_atomically", self._set_atomically),
        ):
            node.create_service(srv_type, f"~/{name}", callback, qos_profile=qos_profile_parameters)

    def _describe(self, request: Any, response: Any) -> Any:
        try:
            response.descriptors = self._node.describe_parameters(request.names)
        except ParameterNotDeclaredException:
            response.descriptors = []
        return response

    def _get(self, request: Any, response: Any) -> Any:
        try:
            values = [self._node._parameters[name].get_parameter_value() for name in request.names]
        except KeyError:
            values = (
                []
                if not self._node._allow_undeclared_parameters
                else [self._node.get_parameter_or(name).get_parameter_value() for name in request.names]
            )
        response.values = values
        return response

    def _get_types(self, request: Any, response: Any) -> Any:
        try:
            response.types = [self._node.get_parameter_type(name).value for name in request.names]
        except ParameterNotDeclaredException:
            response.types = []
        return response

    def _list(self, request: Any, response: Any) -> Any:
        response.result = self._node.list_parameters(request.prefixes, request.depth)
        return response

    def _set(self, request: Any, response: Any) -> Any:
        for message in request.parameters:
            try:
                result = self._node.set_parameters_atomically([Parameter.from_parameter_msg(message)])
            except ParameterNotDeclaredException as error:
                result = rcl_interfaces.SetParametersResult(successful=False, reason=str(error))
            response.results.append(result)
        return response

    def _set_atomically(self, request: Any, response: Any) -> Any:
        try:
            response.result = self._node.set_parameters_atomically(
                [Parameter.from_parameter_msg(message) for message in request.parameters]
            )
        except ParameterNotDeclaredException as error:
            response.result = rcl_interfaces.SetParametersResult(successful=False, reason=str(error))
        return response


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


class ParameterCallbackHandle:
    """What add_parameter_callback returns: keep it to take the callback away again."""

    def __init__(
        self, parameter_name: str, node_name: str, callback: Callable[[rcl_interfaces.Parameter], Any]
    ) -> None:
        self.parameter_name = parameter_name
        self.node_name = node_name
        self.callback = callback


class ParameterEventCallbackHandle:
    """What add_parameter_event_callback returns: keep it to take the callback away again."""

    def __init__(self, callback: Callable[[rcl_interfaces.ParameterEvent], Any]) -> None:
        self.callback = callback


class ParameterEventHandler:
    """Calls back when parameters of any node change; whatever was announced before it was made is not heard.

    Args:
        node: whose subscription this is; somebody must spin it.
    """

    def __init__(
        self,
        node: Any,
        qos_profile: QoSProfile = qos_profile_parameter_events,
        callback_group: Any = None,
        event_callbacks: Any = None,
        qos_overriding_options: Any = None,
        raw: bool = False,
    ) -> None:
        self.node = node
        self.qos_profile = qos_profile
        self._parameter_callbacks: list[ParameterCallbackHandle] = []
        self._event_callbacks: list[ParameterEventCallbackHandle] = []
        self.parameter_event_subscription = node.create_subscription(
            rcl_interfaces.ParameterEvent,
            "/parameter_events",
            self._on_event,
            qos_profile,
            callback_group=callback_group,
            event_callbacks=event_callbacks,
            qos_overriding_options=qos_overriding_options,
            raw=raw,
        )

    def destroy(self) -> None:
        """Hear no more."""
        self.node.destroy_subscription(self.parameter_event_subscription)

    @staticmethod
    def get_parameter_from_event(
        event: rcl_interfaces.ParameterEvent, parameter_name: str, node_name: str
    ) -> rcl_interfaces.Parameter | None:
        """Return one new or changed parameter of an event of that node, None if the event is of something else."""
        if event.node != node_name:
            return None
        parameters = ParameterEventHandler.get_parameters_from_event(event)
        return next((each for each in parameters if each.name == parameter_name), None)

    @staticmethod
    def get_parameters_from_event(event: rcl_interfaces.ParameterEvent) -> Iterator[rcl_interfaces.Parameter]:
        """Yield the new and the changed parameters of an event; deleted ones are not among them."""
        yield from event.new_parameters
        yield from event.changed_parameters

    def add_parameter_callback(
        self, parameter_name: str, node_name: str, callback: Callable[[rcl_interfaces.Parameter], Any]
    ) -> ParameterCallbackHandle:
        """Have `callback(parameter)` called, with a message, when that parameter is declared or changes.

        `node_name` is relative to the namespace of this node unless it begins with a slash; "" is this node itself.
        """
        handle = ParameterCallbackHandle(parameter_name, self._resolve_path(node_name), callback)
        self._parameter_callbacks.insert(0, handle)
        return handle

    def remove_parameter_callback(self, handle: ParameterCallbackHandle) -> None:
        """Take a callback away.

        Raises:
            RuntimeError: it is not there, or not any more.
        """
        _remove(handle, self._parameter_callbacks)

    def add_parameter_event_callback(
        self, callback: Callable[[rcl_interfaces.ParameterEvent], Any]
    ) -> ParameterEventCallbackHandle:
        """Have `callback(event)` called for each event of any node."""
        handle = ParameterEventCallbackHandle(callback)
        self._event_callbacks.insert(0, handle)
        return handle

    def remove_parameter_event_callback(self, handle: ParameterEventCallbackHandle) -> None:
        """Take a callback away.

        Raises:
            RuntimeError: it is not there, or not any more.
        """
        _remove(handle, self._event_callbacks)

    def _on_event(self, event: rcl_interfaces.ParameterEvent) -> None:
        # Over copies: a callback may take itself away, where rclpy's lock would never open again.
        for handle in list(self._parameter_callbacks):
            parameter = self.get_parameter_from_event(event, handle.parameter_name, handle.node_name)
            if parameter is not None:
                handle.callback(parameter)
        for each in list(self._event_callbacks):
            each.callback(event)

    def _resolve_path(self, node_path: str | None = None) -> str:
        if not node_path:
            return self.node.get_fully_qualified_name()
        if node_path.startswith("/"):
            return node_path
        return f"{self.node.get_namespace().rstrip('/')}/{node_path}"


def _remove(handle: Any, handles: list) -> None:
    if handle not in handles:
        raise RuntimeError("Callback doesn't exist")
    handles.remove(handle)
