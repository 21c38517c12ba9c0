"""Serve an action: accept goals, publish feedback, return results.

    send_goal    goal_callback: accept?  -->  handle_accepted_callback  -->  execute_callback
    cancel_goal  cancel_callback: may it be given up?                          |  publish_feedback(...)
    get_result   answered when the goal is done   <--  succeed(), abort(), canceled(), and what it returns

Three services and two topics, under hidden names.  upstream: rclpy/action/server.py
"""

from __future__ import annotations

import inspect
import threading
import traceback
from collections.abc import Callable
from enum import Enum
from typing import Any

from tflab.core import NSEC_PER_SEC

from .action_goals import GoalEvent, action_entity_name, goal_key, is_done, may_be_cancelled, next_status
from .distro import current
from .entity import CallbackGroup, ReentrantCallbackGroup
from .messages.action_msgs import CancelGoal, GoalInfo, GoalStatus
from .messages.base import Action, Message, is_action_class
from .node_entities import check_type
from .qos import QoSProfile, qos_profile_action_status_default, qos_profile_services_default
from .task import Future
from .time import Time

__all__ = ["ActionServer", "CancelResponse", "GoalResponse", "ServerGoalHandle"]

FEEDBACK_QOS = QoSProfile(depth=10)


class GoalResponse(Enum):
    """What a goal callback may answer."""

    REJECT = 1
    ACCEPT = 2


class CancelResponse(Enum):
    """What a cancel callback may answer."""

    REJECT = 1
    ACCEPT = 2


class ServerGoalHandle:
    """A goal in the hands of its server.

    Attributes:
        request: the goal.
    """

    def __init__(self, server: ActionServer, info: GoalInfo, request: Message) -> None:
        self._server = server
        self.info = info
        self.request = request
        self.result = Future()
        self.done_ns: int | None = None
        self._status = GoalStatus.STATUS_ACCEPTED

    def __eq__(self, other: object) -> bool:
        return isinstance(other, ServerGoalHandle) and self.goal_id == other.goal_id

    __hash__ = None  # as upstream: handles are distinguished by their goal's id

    @property
    def goal_id(self) -> Message:
        """Its id, an UUID."""
        return self.info.goal_id

    @property
    def status(self) -> int:
        """How far it is: one of GoalStatus.STATUS_..."""
        return self._status

    @property
    def is_active(self) -> bool:
        """Whether it is neither done nor given up."""
        return self._status != GoalStatus.STATUS_UNKNOWN and not is_done(self._status)

    @property
    def is_cancel_requested(self) -> bool:
        """Whether somebody wishes that it be given up, and the cancel callback agreed."""
        return self._status == GoalStatus.STATUS_CANCELING

    def execute(self, execute_callback: Callable[[ServerGoalHandle], Any] | None = None) -> None:
        """Begin to work on it, with the server's callback if none is given."""
        if not self.is_cancel_requested:
            self.update(GoalEvent.EXECUTE)
        self._server.notify_execute(self, execute_callback)

    def publish_feedback(self, feedback: Message) -> None:
        """Tell how it goes.

        Raises:
            TypeError: not the action's Feedback.
        """
        self._server.publish_feedback(self, feedback)

    def succeed(self) -> None:
        """Say that it is done.

        Raises:
            RCLError: it was settled before, or never began.
        """
        self.update(GoalEvent.SUCCEED)

    def abort(self) -> None:
        """Say that it failed.

        Raises:
            RCLError: as succeed.
        """
        self.update(GoalEvent.ABORT)

    def canceled(self) -> None:
        """Say that it was given up, as somebody wished.

        Raises:
            RCLError: nobody wished it: `is_cancel_requested` is False.
        """
        self.update(GoalEvent.CANCELED)

    def destroy(self) -> None:
        """Forget it; whoever waits for its result waits in vain."""
        self._status = GoalStatus.STATUS_UNKNOWN
        self._server.forget(self)

    def update(self, event: GoalEvent) -> None:
        """Let something happen to it, and have the server tell everybody; a handle that was destroyed ignores it."""
        if self._status != GoalStatus.STATUS_UNKNOWN:
            self._status = next_status(self._status, event)
            self._server.publish_status()


def default_goal_callback(goal_request: Message) -> GoalResponse:
    """Accept all goals."""
    return GoalResponse.ACCEPT


def default_handle_accepted_callback(goal_handle: ServerGoalHandle) -> None:
    """Begin at once."""
    goal_handle.execute()


def default_cancel_callback(goal_handle: ServerGoalHandle) -> CancelResponse:
    """Give nothing up."""
    return CancelResponse.REJECT


class ActionServer:
    """Works on goals.

    Args:
        execute_callback: plain or async; takes a ServerGoalHandle, settles it, and returns the result.
        callback_group: the node's own if None.  While a callback that blocks is at work, a cancel request is heard
            only if another thread can run: a MultiThreadedExecutor.
        goal_callback: takes a goal and returns a GoalResponse.
        handle_accepted_callback: takes a ServerGoalHandle; it may keep it, and call its `execute` later.
        cancel_callback: takes a ServerGoalHandle and returns a CancelResponse; without one nothing is given up.
        result_timeout: how long a result is kept after its goal is done [s].

    Raises:
        NoTypeSupportImportedException: not the class of an action.
        InvalidTopicNameException: a malformed name.
    """

    def __init__(
        self,
        node: Any,
        action_type: type[Action],
        action_name: str,
        execute_callback: Callable[[ServerGoalHandle], Any],
        *,
        callback_group: CallbackGroup | None = None,
        goal_callback: Callable[[Message], Any] = default_goal_callback,
        handle_accepted_callback: Callable[[ServerGoalHandle], Any] = default_handle_accepted_callback,
        cancel_callback: Callable[[ServerGoalHandle], Any] = default_cancel_callback,
        goal_service_qos_profile: QoSProfile = qos_profile_services_default,
        result_service_qos_profile: QoSProfile = qos_profile_services_default,
        cancel_service_qos_profile: QoSProfile = qos_profile_services_default,
        feedback_pub_qos_profile: QoSProfile = FEEDBACK_QOS,
        status_pub_qos_profile: QoSProfile = qos_profile_action_status_default,
        result_timeout: float = 10,
    ) -> None:
        check_type(action_type, is_action_class, "an action")
        self._node, logger = node, node.get_logger()
        self._logger = logger.get_child("action_server") if current().actions_have_loggers else logger
        self._action_type = action_type
        self._result_timeout_ns = round(result_timeout * NSEC_PER_SEC)
        self._goals: dict[bytes, ServerGoalHandle] = {}
        self._lock = threading.Lock()  # callbacks may run in several threads
        self.register_execute_callback(execute_callback)
        self.register_goal_callback(goal_callback)
        self.register_handle_accepted_callback(handle_accepted_callback)
        self.register_cancel_callback(cancel_callback)
        carried = action_type.Impl
        waiting = ReentrantCallbackGroup()  # results are waited for in the service's callback
        self._services = [
            node.create_service(
                service_type, action_entity_name(action_name, what), callback, qos_profile=qos, callback_group=group
            )
            for service_type, what, callback, qos, group in (
                (carried.SendGoalService, "send_goal", self._on_goal, goal_service_qos_profile, callback_group),
                (carried.CancelGoalService, "cancel_goal", self._on_cancel, cancel_service_qos_profile, callback_group),
                (carried.GetResultService, "get_result", self._on_result_wanted, result_service_qos_profile, waiting),
            )
        ]
        self._feedback, self._status = (
            node.create_publisher(message_type, action_entity_name(action_name, what), qos)
            for message_type, what, qos in (
                (carried.FeedbackMessage, "feedback", feedback_pub_qos_profile),
                (carried.GoalStatusMessage, "status", status_pub_qos_profile),
            )
        )

    @property
    def action_type(self) -> type[Action]:
        """Which action."""
        return self._action_type

    def register_goal_callback(self, goal_callback: Callable[[Message], Any] | None) -> None:
        """Have another callback asked whether a goal is accepted; None: all are."""
        self._goal_callback = goal_callback or default_goal_callback

    def register_handle_accepted_callback(self, callback: Callable[[ServerGoalHandle], Any] | None) -> None:
        """Have another callback take the goals that were accepted; None: each is begun at once."""
        self._handle_accepted_callback = callback or default_handle_accepted_callback

    def register_cancel_callback(self, cancel_callback: Callable[[ServerGoalHandle], Any] | None) -> None:
        """Have another callback asked whether a goal may be given up; None: none may."""
        self._cancel_callback = cancel_callback or default_cancel_callback

    def register_execute_callback(self, execute_callback: Callable[[ServerGoalHandle], Any]) -> None:
        """Have another callback work on goals.

        Raises:
            TypeError: it cannot be called.
        """
        if not callable(execute_callback):
            raise TypeError("Failed to register goal execution callback: not callable")
        self._execute_callback = execute_callback

    def notify_execute(
        self, goal_handle: ServerGoalHandle, execute_callback: Callable[[ServerGoalHandle], Any] | None
    ) -> None:
        """Put the work on a goal among the executor's tasks; see ServerGoalHandle.execute."""
        self._node.executor.create_task(self._execute, goal_handle, execute_callback or self._execute_callback)

    def publish_feedback(self, goal_handle: ServerGoalHandle, feedback: Message) -> None:
        """See ServerGoalHandle.publish_feedback."""
        if not isinstance(feedback, self._action_type.Feedback):
            raise TypeError(f"Expected {self._action_type.Feedback}, got {type(feedback)}")
        if goal_handle.status != GoalStatus.STATUS_UNKNOWN:
            message = self._action_type.Impl.FeedbackMessage(goal_id=goal_handle.goal_id, feedback=feedback)
            self._feedback.publish(message)

    def publish_status(self) -> None:
        """Tell everybody how far each goal is."""
        goals = [GoalStatus(goal_info=goal.info, status=goal.status) for goal in self._known()]
        self._status.publish(self._action_type.Impl.GoalStatusMessage(status_list=goals))

    def forget(self, goal_handle: ServerGoalHandle) -> None:
        """See ServerGoalHandle.destroy."""
        with self._lock:
            self._goals.pop(goal_key(goal_handle.goal_id), None)

    def destroy(self) -> None:
        """Work no more."""
        for service in self._services:
            self._node.destroy_service(service)
        for publisher in (self._feedback, self._status):
            self._node.destroy_publisher(publisher)
        self._goals.clear()

    # -- what comes in ------------------------------------------------------------------

    async def _on_goal(self, request: Message, response: Message) -> Message:
        self._forget_old_results()
        if goal_key(request.goal_id) in self._goals:
            return response
        answer = await _settled(self._goal_callback(request.goal))
        if not isinstance(answer, GoalResponse):
            self._logger.warning("Goal request callback did not return a GoalResponse type. Rejecting goal.")
        elif answer is GoalResponse.ACCEPT:
            response.accepted = True
            response.stamp = self._node.get_clock().now().to_msg()
            handle = ServerGoalHandle(self, GoalInfo(goal_id=request.goal_id, stamp=response.stamp), request.goal)
            with self._lock:
                self._goals[goal_key(request.goal_id)] = handle
            self._node.executor.create_task(self._handle_accepted_callback, handle)  # after the answer is sent
        return response

    async def _execute(self, handle: ServerGoalHandle, callback: Callable[[ServerGoalHandle], Any]) -> None:
        try:
            result = await _settled(callback(handle))
        except Exception as error:
            self._logger.error(f"Error raised in execute callback: {error}")
            traceback.print_exc()
            result = self._action_type.Result()
        if handle.is_active:
            self._logger.warning(f"Goal state not set, assuming aborted. Goal ID: {handle.goal_id.uuid}")
            handle.abort()
        handle.done_ns = self._node.get_clock().now().nanoseconds
        handle.result.set_result(result)

    async def _on_cancel(self, request: Message, response: Message) -> Message:
        wanted, response.return_code = self._wanted(request.goal_info)
        for handle in wanted:
            if await _settled(self._cancel_callback(handle)) is CancelResponse.ACCEPT:
                handle.update(GoalEvent.CANCEL_GOAL)
                response.goals_canceling = [*response.goals_canceling, handle.info]
        return response

    def _wanted(self, info: GoalInfo) -> tuple[list[ServerGoalHandle], int]:
        """Return which goals somebody wishes given up, and why there is none.

        An id alone: that one; a time alone: those accepted until then; both: either; neither: all.
        """
        key, until_ns = goal_key(info.goal_id), Time.from_msg(info.stamp).nanoseconds
        one = any(key)
        refusal = CancelGoal.Response
        if one and not until_ns:
            if key not in self._goals:
                return [], refusal.ERROR_UNKNOWN_GOAL_ID
            if not may_be_cancelled(self._goals[key].status):
                return [], refusal.ERROR_GOAL_TERMINATED
        wanted = [
            goal
            for goal in self._known()
            if may_be_cancelled(goal.status)
            and (
                not (one or until_ns)
                or goal_key(goal.goal_id) == key
                or Time.from_msg(goal.info.stamp).nanoseconds <= until_ns
            )
        ]
        return wanted, refusal.ERROR_NONE

    async def _on_result_wanted(self, request: Message, response: Message) -> Message:
        self._forget_old_results()
        handle = self._goals.get(goal_key(request.goal_id))
        if handle is not None:
            response.result = await handle.result
            response.status = handle.status
        return response

    def _forget_old_results(self) -> None:
        now_ns = self._node.get_clock().now().nanoseconds
        for goal in self._known():
            if goal.done_ns is not None and now_ns - goal.done_ns > self._result_timeout_ns:
                self.forget(goal)

    def _known(self) -> list[ServerGoalHandle]:
        with self._lock:
            return list(self._goals.values())


async def _settled(answer: Any) -> Any:
    """Return what a callback returned, plain or async."""
    return await answer if inspect.iscoroutine(answer) else answer
