"""Provide services and their clients.

A call blocks until the answer has come, so somebody else must spin the client's
node meanwhile; `call_async` returns a Future instead.

    service.configure_introspection(node.get_clock(), qos, ServiceIntrospectionState.CONTENTS)

publishes an event on the topic `<service>/_service_event` at each request and response.
"""

from __future__ import annotations

import inspect
import threading
from collections import deque
from collections.abc import Callable, Coroutine
from enum import IntEnum
from functools import cached_property
from typing import Any

from tflab.core import NSEC_PER_SEC

from .distro import current
from .entity import Entity, Kind
from .messages import copy_message, type_named
from .network import PUBLISHER_KIND
from .qos import QoSProfile
from .task import Future

__all__ = ["Client", "Service", "ServiceIntrospectionState"]

POLL_NS = 100_000_000  # how often wait_for_service looks


ServiceEventInfo = type_named("service_msgs/msg/ServiceEventInfo")


class ServiceIntrospectionState(IntEnum):
    """What the events of a service or client hold."""

    OFF = 0
    METADATA = 1
    CONTENTS = 2


class _Introspected(Entity):
    """What a service and a client share: events about their requests and responses."""

    srv_type: Any
    srv_name: str
    _events: Any = None

    def configure_introspection(
        self, clock: Any, service_event_qos_profile: QoSProfile, introspection_state: ServiceIntrospectionState
    ) -> None:
        """Publish an event of each request and response from now on, with its contents or without, or none."""
        self.node.destroy_publisher(self._events)
        self._events, self._clock, self._state = None, clock, introspection_state
        if introspection_state != ServiceIntrospectionState.OFF:
            topic = f"{self.srv_name}/_service_event"
            self._events = self.node.create_publisher(self.srv_type.Event, topic, service_event_qos_profile)

    def _note(self, what: str, message: Any, client: Client, number: int) -> None:
        """Publish the event `what`, if somebody wants it: REQUEST_SENT, REQUEST_RECEIVED, RESPONSE_SENT, ..."""
        if self._events is None:
            return
        info = ServiceEventInfo(event_type=getattr(ServiceEventInfo, what), sequence_number=number)
        info.stamp, info.client_gid = self._clock.now().to_msg(), list(client.gid)
        contents = (
            {what.partition("_")[0].lower(): [message]} if self._state == ServiceIntrospectionState.CONTENTS else {}
        )
        self._events.publish(self.srv_type.Event(info=info, **contents))


class Service(_Introspected):
    """Answers requests: `callback(request, response)` returns the response."""

    kind = Kind.SERVICE

    def __init__(
        self,
        node: Any,
        srv_type: type,
        srv_name: str,
        callback: Callable[[Any, Any], Any],
        qos_profile: QoSProfile,
        callback_group: Any,
    ) -> None:
        super().__init__(node, callback_group)
        self.srv_type = srv_type
        self.srv_name = srv_name
        self.service_name = srv_name
        self.callback = callback
        self.qos_profile = qos_profile
        self._requests: deque[tuple[Any, Client, int]] = deque()
        node.network.services.setdefault(srv_name, []).append(self)

    def put(self, request: Any, client: Client, number: int) -> None:
        """Receive a request."""
        self._requests.append((request, client, number))
        self.mark_ready()

    def is_pending(self) -> bool:
        return bool(self._requests)

    def take(self) -> Callable[[], Any]:
        question = self._requests.popleft()
        return lambda: self._answer(*question)

    def _answer(self, request: Any, client: Client, number: int) -> Coroutine | None:
        self._note("REQUEST_RECEIVED", request, client, number)
        response = self.callback(request, self.srv_type.Response())
        if inspect.iscoroutine(response):
            return self._answer_later(response, client, number)
        self._send(response, client, number)
        return None

    async def _answer_later(self, response: Coroutine, client: Client, number: int) -> None:
        self._send(await response, client, number)

    def _send(self, response: Any, client: Client, number: int) -> None:
        if not isinstance(response, self.srv_type.Response):
            raise TypeError(f"Expected {self.srv_type.Response}, got {type(response)}")
        self._note("RESPONSE_SENT", response, client, number)
        client.put(copy_message(response), number)

    def destroy(self) -> None:
        """Answer no more."""
        if not self.is_destroyed:
            self.node.network.services[self.srv_name].remove(self)
        super().destroy()


class Client(_Introspected):
    """Asks one service."""

    kind = Kind.CLIENT

    def __init__(self, node: Any, srv_type: type, srv_name: str, qos_profile: QoSProfile, callback_group: Any) -> None:
        super().__init__(node, callback_group)
        self.srv_type = srv_type
        self.srv_name = srv_name
        self.service_name = srv_name
        self.qos_profile = qos_profile
        self._count = 0
        self._futures: dict[int, Future] = {}
        self._responses: deque[tuple[Any, int]] = deque()
        self._lock = threading.Lock()
        node.network.clients.setdefault(srv_name, []).append(self)

    @cached_property
    def gid(self) -> bytes:
        """Its identity in the graph, 16 bytes."""
        return self.node.network.new_gid(self.node.context, PUBLISHER_KIND)  # of what writes its requests

    def call_async(self, request: Any) -> Future:
        """Ask, and return a Future of the answer.

        Raises:
            TypeError: not a request of the service's type.
        """
        if not isinstance(request, self.srv_type.Request):
            raise TypeError(f"Expected {self.srv_type.Request}, got {type(request)}")
        future = Future()
        with self._lock:
            self._count += 1
            self._futures[self._count] = future
        self._note("REQUEST_SENT", request, self, self._count)
        for service in self._servers()[:1]:
            service.put(copy_message(request), self, self._count)
        future.add_done_callback(self.remove_pending_request)
        return future

    def call(self, request: Any, timeout_sec: float | None = None) -> Any:
        """Ask, block, and return the answer; see distro.py for an answer that does not come in time [s]."""
        future = self.call_async(request)
        duration_ns = None if timeout_sec is None else round(timeout_sec * NSEC_PER_SEC)
        is_done = self.node.context.process.wait_for(future, duration_ns)
        if not is_done and current().call_raises_timeout:
            raise TimeoutError
        return future.result() if is_done else None

    def put(self, response: Any, number: int) -> None:
        """Receive an answer."""
        self._responses.append((response, number))
        self.mark_ready()

    def is_pending(self) -> bool:
        return bool(self._responses)

    def take(self) -> Callable[[], None]:
        answer = self._responses.popleft()
        return lambda: self._hand_over(*answer)

    def _hand_over(self, response: Any, number: int) -> None:
        self._note("RESPONSE_RECEIVED", response, self, number)
        future = self._futures.pop(number, None)
        if future is not None and not future.done():
            future.set_result(response)

    def remove_pending_request(self, future: Future) -> None:
        """Wait no more for the answer to one request."""
        with self._lock:
            self._futures = {number: each for number, each in self._futures.items() if each is not future}

    def service_is_ready(self) -> bool:
        """Return whether somebody answers."""
        return bool(self._servers())

    def wait_for_service(self, timeout_sec: float | None = None) -> bool:
        """Block until somebody answers, at most `timeout_sec` [s]; return whether somebody does."""
        process, context = self.node.context.process, self.node.context
        until_ns = None if timeout_sec is None else process.driver.steady_ns() + round(timeout_sec * NSEC_PER_SEC)
        while context.ok() and not self.service_is_ready():
            if until_ns is not None and process.driver.steady_ns() >= until_ns:
                return False
            process.sleep(POLL_NS)
        return self.service_is_ready()

    def destroy(self) -> None:
        """Ask no more."""
        if not self.is_destroyed:
            self.node.network.clients[self.srv_name].remove(self)
        super().destroy()

    def _servers(self) -> list[Service]:
        services = self.node.network.services.get(self.srv_name, [])
        return [service for service in services if service.srv_type is self.srv_type]
