"""Define the states of an action's goal and the transitions between them.

    ACCEPTED --execute--> EXECUTING --succeed--> SUCCEEDED
        |                     |------abort-----> ABORTED
        +------cancel_goal----+
                 v
             CANCELING --canceled--> CANCELED        (or succeed, or abort: it was too late)

A *state machine*: what has no arrow is refused.  upstream: rcl_action/goal_state_machine.c
"""

from __future__ import annotations

from enum import IntEnum
from typing import Any

from .exceptions import RCLError
from .messages.action_msgs import GoalStatus
from .messages.base import Message

__all__ = [
    "GoalEvent",
    "action_entity_name",
    "get_action_client_names_and_types_by_node",
    "get_action_names_and_types",
    "get_action_server_names_and_types_by_node",
    "goal_key",
    "is_done",
    "may_be_cancelled",
    "next_status",
    "status_name",
]

Named = list[tuple[str, list[str]]]


class GoalEvent(IntEnum):
    """What can happen to a goal."""

    EXECUTE = 1
    CANCEL_GOAL = 2
    SUCCEED = 3
    ABORT = 4
    CANCELED = 5


_NEXT = {
    (GoalStatus.STATUS_ACCEPTED, GoalEvent.EXECUTE): GoalStatus.STATUS_EXECUTING,
    (GoalStatus.STATUS_ACCEPTED, GoalEvent.CANCEL_GOAL): GoalStatus.STATUS_CANCELING,
    (GoalStatus.STATUS_EXECUTING, GoalEvent.CANCEL_GOAL): GoalStatus.STATUS_CANCELING,
    (GoalStatus.STATUS_EXECUTING, GoalEvent.SUCCEED): GoalStatus.STATUS_SUCCEEDED,
    (GoalStatus.STATUS_EXECUTING, GoalEvent.ABORT): GoalStatus.STATUS_ABORTED,
    (GoalStatus.STATUS_CANCELING, GoalEvent.SUCCEED): GoalStatus.STATUS_SUCCEEDED,
    (GoalStatus.STATUS_CANCELING, GoalEvent.ABORT): GoalStatus.STATUS_ABORTED,
    (GoalStatus.STATUS_CANCELING, GoalEvent.CANCELED): GoalStatus.STATUS_CANCELED,
}

_NAMES = {
    value: name.removeprefix("STATUS_")
    for name, value in sorted(vars(GoalStatus).items())
    if name.startswith("STATUS_")
}


def next_status(status: int, event: GoalEvent) -> int:
    """Return the status, one of GoalStatus.STATUS_..., that a goal has after an event.

    Raises:
        RCLError: there is no such step, with rcl's text.
    """
    if (status, event) not in _NEXT:
        raise RCLError(
            "Failed to update goal state: goal_handle attempted invalid transition "
            f"from state {status_name(status)} with event {event.name}"
        )
    return _NEXT[status, event]


def may_be_cancelled(status: int) -> bool:
    """Return whether a goal can still be given up, and nobody has wished it before."""
    return (status, GoalEvent.CANCEL_GOAL) in _NEXT


def is_done(status: int) -> bool:
    """Return whether nothing can happen to a goal any more."""
    return all(state != status for state, _ in _NEXT)


def status_name(status: int) -> str:
    """Return how a status is called: 'SUCCEEDED'."""
    return _NAMES[status]


def goal_key(goal_id: Message) -> bytes:
    """Return what a goal is kept under: the bytes of its id, an UUID."""
    return goal_id.uuid.tobytes()


def action_entity_name(action_name: str, what: str) -> str:
    """Return the hidden name of a service or topic of an action: '/fibonacci/_action/feedback'."""
    return f"{action_name}/_action/{what}"


def get_action_names_and_types(node: Any) -> Named:
    """Return (action, types) of every action in the graph; any node can look."""
    return _actions_among(node.get_topic_names_and_types())


def get_action_server_names_and_types_by_node(node: Any, remote_node_name: str, remote_node_namespace: str) -> Named:
    """Return (action, types) of what one node serves; any other node can look."""
    return _actions_among(node.get_publisher_names_and_types_by_node(remote_node_name, remote_node_namespace))


def get_action_client_names_and_types_by_node(node: Any, remote_node_name: str, remote_node_namespace: str) -> Named:
    """Return (action, types) of what one node has clients of; any other node can look."""
    return _actions_among(node.get_subscriber_names_and_types_by_node(remote_node_name, remote_node_namespace))


def _actions_among(topics: Named) -> Named:
    """Return (action, types) of those whose feedback is among some topics, as upstream finds them."""
    feedback = action_entity_name("", "feedback")
    return [
        (name.removesuffix(feedback), [each.removesuffix("_FeedbackMessage") for each in types])
        for name, types in topics
        if name.endswith(feedback)
    ]
