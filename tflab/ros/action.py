"""What takes longer than a question and an answer?  Actions: a goal, and later its result.

    client -- send_goal --> server     accepted or not
    client -- get_result -> server     ... answered when the goal is done

Two services of a hidden name each, as far as tf2's BufferClient needs them: there
is no feedback, and a goal cannot be cancelled.  Read `callback_groups.py` next.
"""

from __future__ import annotations

import inspect
import itertools
import traceback
from collections.abc import Callable
from enum import Enum, IntEnum
from typing import Any

from .callback_groups import CallbackGroup, ReentrantCallbackGroup
from .messages.base import Action, Message
from .messages.unique_identifier_msgs import UUID
from .task import Future

__all__ = ["ActionClient", "ActionServer", "ClientGoalHandle", "GoalResponse", "GoalStatus", "ServerGoalHandle"]

_goal_numbers = itertools.count(1)


class GoalStatus(IntEnum):
    """How far a goal is; the numbers are those of action_msgs/GoalStatus."""

    UNKNOWN = 0
    ACCEPTED = 1
    EXECUTING = 2
    SUCCEEDED = 4
    ABORTED = 6


class GoalResponse(Enum):
    """What a goal callback may answer."""

    REJECT = 1
    ACCEPT = 2


# -- the server ---------------------------------------------------------------------


class ServerGoalHandle:
    """A goal in the hands of its server.

    Attributes:
        request: the goal.
        goal_id: its id.
        status: how far it is.
        result: a Future of the result.
    """

    def __init__(self, request: Message, goal_id: Message) -> None:
        self.request = request
        self.goal_id = goal_id
        self.status = GoalStatus.ACCEPTED
        self.result = Future()

    @property
    def is_active(self) -> bool:
        """Whether it is neither done nor given up."""
        return self.status in (GoalStatus.ACCEPTED, GoalStatus.EXECUTING)

    def succeed(self) -> None:
        """Say that it is done."""
        self.status = GoalStatus.SUCCEEDED

    def abort(self) -> None:
        """Say that it is given up."""
        self.status = GoalStatus.ABORTED


class ActionServer:
    """Works on goals.

    Args:
        execute_callback: plain or async; takes a ServerGoalHandle, settles it, and returns the result.
        goal_callback: takes a goal and returns a GoalResponse.
    """

    def __init__(
        self,
        node: Any,
        action_type: type[Action],
        action_name: str,
        execute_callback: Callable[[ServerGoalHandle], Any],
        *,
        callback_group: CallbackGroup | None = None,
        goal_callback: Callable[[Message], GoalResponse] = lambda goal: GoalResponse.ACCEPT,
    ) -> None:
        self._node = node
        self._action_type = action_type
        self._execute_callback = execute_callback
        self._goal_callback = goal_callback
        self._goals: dict[bytes, ServerGoalHandle] = {}
        group = callback_group or ReentrantCallbackGroup()  # results are waited for in the services' callbacks
        self._services = [
            node.create_service(service_type, _service_name(action_name, what), callback, callback_group=group)
            for service_type, what, callback in (
                (action_type.SendGoalService, "send_goal", self._on_goal),
                (action_type.GetResultService, "get_result", self._on_result_wanted),
            )
        ]

    def destroy(self) -> None:
        """Work no more."""
        for service in self._services:
            self._node.destroy_service(service)

    def _on_goal(self, request: Message, response: Message) -> Message:
        response.stamp = self._node.get_clock().now().to_msg()
        response.accepted = self._goal_callback(request.goal) is GoalResponse.ACCEPT
        if response.accepted:
            handle = ServerGoalHandle(request.goal, request.goal_id)
            self._goals[request.goal_id.uuid.tobytes()] = handle
            self._node.executor.create_task(self._execute, handle)
        return response

    async def _execute(self, handle: ServerGoalHandle) -> None:
        handle.status = GoalStatus.EXECUTING
        try:
            result = self._execute_callback(handle)
            if inspect.iscoroutine(result):
                result = await result
        except Exception as error:
            self._node.get_logger().error(f"Error raised in execute callback: {error}")
            traceback.print_exc()
            result = self._action_type.Result()
        if handle.is_active:
            self._node.get_logger().warning(f"Goal state not set, assuming aborted. Goal ID: {handle.goal_id.uuid}")
            handle.abort()
        handle.result.set_result(result)

    async def _on_result_wanted(self, request: Message, response: Message) -> Message:
        handle = self._goals.get(request.goal_id.uuid.tobytes())
        if handle is not None:
            response.result = await handle.result
            response.status = int(handle.status)
            self._goals.pop(request.goal_id.uuid.tobytes(), None)
        return response


# -- the client ---------------------------------------------------------------------


class ClientGoalHandle:
    """A goal in the hands of its client.

    Attributes:
        goal_id: its id.
        stamp: when the server answered.
        accepted: whether it works on it.
    """

    def __init__(self, client: ActionClient, goal_id: Message, response: Message) -> None:
        self._client = client
        self.goal_id = goal_id
        self.stamp = response.stamp
        self.accepted = response.accepted

    def get_result_async(self) -> Future:
        """Return a Future of what the server answers in the end: `status` and `result`."""
        return self._client.ask_for_result(self.goal_id)


class ActionClient:
    """Sends goals."""

    def __init__(
        self,
        node: Any,
        action_type: type[Action],
        action_name: str,
        *,
        callback_group: CallbackGroup | None = None,
    ) -> None:
        self._node = node
        self._action_type = action_type
        group = callback_group or ReentrantCallbackGroup()
        self._goals, self._results = (
            node.create_client(service_type, _service_name(action_name, what), callback_group=group)
            for service_type, what in (
                (action_type.SendGoalService, "send_goal"),
                (action_type.GetResultService, "get_result"),
            )
        )

    def send_goal_async(self, goal: Message) -> Future:
        """Send a goal; return a Future of its ClientGoalHandle, which says whether it was accepted.

        Raises:
            TypeError: not a goal of this action.
        """
        if not isinstance(goal, self._action_type.Goal):
            raise TypeError(f"Expected {self._action_type.Goal}, got {type(goal)}")
        goal_id = UUID(uuid=list(next(_goal_numbers).to_bytes(16, "big")))
        sent = Future()

        def on_answer(answer: Future) -> None:
            sent.set_result(ClientGoalHandle(self, goal_id, answer.result()))

        request = self._action_type.SendGoalService.Request(goal_id=goal_id, goal=goal)
        self._goals.call_async(request).add_done_callback(on_answer)
        return sent

    def ask_for_result(self, goal_id: Message) -> Future:
        """Return a Future of the answer to one goal; see ClientGoalHandle.get_result_async."""
        return self._results.call_async(self._action_type.GetResultService.Request(goal_id=goal_id))

    def server_is_ready(self) -> bool:
        """Return whether there is a server."""
        return self._goals.service_is_ready() and self._results.service_is_ready()

    def wait_for_server(self, timeout_sec: float | None = None) -> bool:
        """Block until there is a server, at most `timeout_sec` [s]; return whether there is one."""
        return self._goals.wait_for_service(timeout_sec) and self._results.wait_for_service(timeout_sec)

    def destroy(self) -> None:
        """Send no more."""
        for client in (self._goals, self._results):
            self._node.destroy_client(client)


def _service_name(action_name: str, what: str) -> str:
    return f"{action_name}/_action/{what}"
