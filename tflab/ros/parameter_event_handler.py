"""How does a node hear that a parameter has changed?  One subscription to /parameter_events, and callbacks behind it.

    /parameter_events --> handler --> callback(parameter)   of one parameter of one node
                             `------> callback(event)       of every event

What was added last is called first, as in rclpy.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

from .messages import rcl_interfaces
from .qos import QoSProfile, qos_profile_parameter_events

__all__ = ["ParameterCallbackHandle", "ParameterEventCallbackHandle", "ParameterEventHandler"]


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
