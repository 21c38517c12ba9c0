"""Send goals to an action server, follow them and cancel them.

    send_goal_async(goal, feedback_callback)  -->  a handle: accepted?
    handle.get_result_async()                 -->  status and result, when it is done
    handle.cancel_goal_async()                -->  whether it will be given up

upstream: rclpy/action/client.py
"""

from __future__ import annotations

import itertools
import weakref
from collections.abc import Callable
from typing import Any

from .action_goals import action_entity_name, goal_key, is_done
from .action_server import FEEDBACK_QOS
from .entity import CallbackGroup, Kind
from .messages import type_named
from .messages.action_msgs import GoalInfo, GoalStatus
from .messages.base import Action, Message, is_action_class
from .node_entities import check_type
from .qos import QoSProfile, qos_profile_action_status_default, qos_profile_services_default
from .task import Future

__all__ = ["ActionClient", "ClientGoalHandle"]

UUID = type_named("unique_identifier_msgs/msg/UUID")
_goal_numbers = itertools.count(1)  # upstream: random; here two runs print the same


class ClientGoalHandle:
    """A goal in the hands of its client.

    Attributes:
        goal_id: its id.
        stamp: when the server accepted it.
        accepted: whether it works on it.
        status: how far it is, as last heard: one of GoalStatus.STATUS_...
    """

    def __init__(self, client: ActionClient, goal_id: Message, response: Message) -> None:
        self._client = client
        self.goal_id = goal_id
        self.stamp = response.stamp
        self.accepted = response.accepted
        self.status = GoalStatus.STATUS_UNKNOWN

    def __eq__(self, other: object) -> bool:
        return isinstance(other, ClientGoalHandle) and self.goal_id == other.goal_id

    def __hash__(self) -> int:
        return hash(goal_key(self.goal_id))

    def __repr__(self) -> str:
        return f"ClientGoalHandle <id={self.goal_id.uuid}, accepted={self.accepted}, status={self.status}>"

    def get_result_async(self) -> Future:
        """Return a Future of what the server answers in the end: `status` and `result`."""
        return self._client.ask_for_result(self.goal_id)

    def get_result(self) -> Message:
        """Return it, and block until it has come; another thread must spin the node."""
        return self._client.wait_for(self.get_result_async())

    def cancel_goal_async(self) -> Future:
        """Wish that it be given up; return a Future of the answer, whose `goals_canceling` names it if it will be."""
        return self._client.ask_to_cancel(self.goal_id)

    def cancel_goal(self) -> Message:
        """Return that answer, and block until it has come; another thread must spin the node."""
        return self._client.wait_for(self.cancel_goal_async())


class ActionClient:
    """Sends goals.

    Args:
        callback_group: the node's own if None.

    Raises:
        NoTypeSupportImportedException: not the class of an action.
        InvalidTopicNameException: a malformed name.
    """

    def __init__(
        self,
        node: Any,
        action_type: type[Action],
        action_name: str,
        *,
        callback_group: CallbackGroup | None = None,
        goal_service_qos_profile: QoSProfile = qos_profile_services_default,
        result_service_qos_profile: QoSProfile = qos_profile_services_default,
        cancel_service_qos_profile: QoSProfile = qos_profile_services_default,
        feedback_sub_qos_profile: QoSProfile = FEEDBACK_QOS,
        status_sub_qos_profile: QoSProfile = qos_profile_action_status_default,
    ) -> None:
        check_type(action_type, is_action_class, "an action")
        self._node = node
        self._action_type = action_type
        carried = action_type.Impl
        self._goals, self._results, self._cancels = (
            node.create_client(
                service_type, action_entity_name(action_name, what), qos_profile=qos, callback_group=callback_group
            )
            for service_type, what, qos in (
                (carried.SendGoalService, "send_goal", goal_service_qos_profile),
                (carried.GetResultService, "get_result", result_service_qos_profile),
                (carried.CancelGoalService, "cancel_goal", cancel_service_qos_profile),
            )
        )
        self._feedback, self._status = (
            node.create_subscription(
                message_type, action_entity_name(action_name, what), callback, qos, callback_group=callback_group
            )
            for message_type, what, callback, qos in (
                (carried.FeedbackMessage, "feedback", self._on_feedback, feedback_sub_qos_profile),
                (carried.GoalStatusMessage, "status", self._on_status, status_sub_qos_profile),
            )
        )
        self._feedback.rank = (Kind.CLIENT, self._feedback.rank[1])  # its turn: after the answer to the goal
        self._feedback_callbacks: dict[bytes, Callable[[Message], Any]] = {}
        self._handles: weakref.WeakValueDictionary[bytes, ClientGoalHandle] = weakref.WeakValueDictionary()

    def send_goal_async(
        self, goal: Message, feedback_callback: Callable[[Message], Any] | None = None, goal_uuid: Message | None = None
    ) -> Future:
        """Send a goal; return a Future of its ClientGoalHandle, which says whether it was accepted.

        Args:
            feedback_callback: called with each message of feedback of this goal; what it tells is in `.feedback`.
            goal_uuid: its id; a new one if None.

        Raises:
            TypeError: not a goal of this action.
        """
        if not isinstance(goal, self._action_type.Goal):
            raise TypeError(f"Expected {self._action_type.Goal}, got {type(goal)}")
        goal_id = goal_uuid or UUID(uuid=list(next(_goal_numbers).to_bytes(16, "big")))
        if feedback_callback is not None:
            self._feedback_callbacks[goal_key(goal_id)] = feedback_callback
        sent = Future()

        def on_answer(answer: Future) -> None:
            handle = ClientGoalHandle(self, goal_id, answer.result())
            if handle.accepted:
                self._handles[goal_key(goal_id)] = handle
            else:
                self._feedback_callbacks.pop(goal_key(goal_id), None)
            sent.set_result(handle)

        request = self._action_type.Impl.SendGoalService.Request(goal_id=goal_id, goal=goal)
        self._goals.call_async(request).add_done_callback(on_answer)
        return sent

    def send_goal(self, goal: Message, **options: Any) -> Message | None:
        """Send a goal, block until it is done, and return `status` and `result`, or None if it was rejected.

        Another thread must spin the node.  Takes what send_goal_async takes.
        """
        handle = self.wait_for(self.send_goal_async(goal, **options))
        return handle.get_result() if handle.accepted else None

    def ask_for_result(self, goal_id: Message) -> Future:
        """See ClientGoalHandle.get_result_async."""
        answer = self._results.call_async(self._action_type.Impl.GetResultService.Request(goal_id=goal_id))
        answer.add_done_callback(lambda _: self._feedback_callbacks.pop(goal_key(goal_id), None))
        return answer

    def ask_to_cancel(self, goal_id: Message) -> Future:
        """See ClientGoalHandle.cancel_goal_async."""
        request = self._action_type.Impl.CancelGoalService.Request(goal_info=GoalInfo(goal_id=goal_id))
        return self._cancels.call_async(request)

    def wait_for(self, future: Future) -> Any:
        """Block until a Future of this client is done, and return its result; another thread must spin the node."""
        self._node.context.process.wait_for(future)
        return future.result()

    def server_is_ready(self) -> bool:
        """Return whether there is a server."""
        return all(client.service_is_ready() for client in self._clients())

    def wait_for_server(self, timeout_sec: float | None = None) -> bool:
        """Block until there is a server, at most `timeout_sec` [s]; return whether there is one."""
        return all(client.wait_for_service(timeout_sec) for client in self._clients())

    def destroy(self) -> None:
        """Send no more."""
        for client in self._clients():
            self._node.destroy_client(client)
        for subscription in (self._feedback, self._status):
            self._node.destroy_subscription(subscription)

    def _clients(self) -> tuple[Any, ...]:
        return self._goals, self._results, self._cancels

    def _on_feedback(self, message: Message) -> Any:
        callback = self._feedback_callbacks.get(goal_key(message.goal_id))
        return None if callback is None else callback(message)

    def _on_status(self, message: Message) -> None:
        for each in message.status_list:
            handle = self._handles.get(goal_key(each.goal_info.goal_id))
            if handle is not None:
                handle.status = each.status
                if is_done(each.status):
                    del self._handles[goal_key(each.goal_info.goal_id)]
