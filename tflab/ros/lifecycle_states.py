"""Define the states and transitions of a managed node.

    unconfigured --configure--> [configuring] --success--> inactive --activate--> [activating] --> active
          ^       <--cleanup--  [cleaningup]                         <--deactivate--  [deactivating]
          `-- success -- [errorprocessing] <-- error, from any state on the way; failure there: finalized
    shutdown, from any of the three: [shuttingdown] --> finalized

A state on the way (a transition state) is left by what its callback returned.
"""

from __future__ import annotations

from enum import IntEnum
from typing import NamedTuple

from .exceptions import RCLError
from .logging import get_logger
from .messages.lifecycle_msgs import State, Transition

__all__ = ["STATES", "TRANSITIONS", "LifecycleState", "LifecycleTransition", "StateMachine", "TransitionCallbackReturn"]


class LifecycleState(NamedTuple):
    """A state, as callbacks receive it."""

    label: str
    state_id: int


class TransitionCallbackReturn(IntEnum):
    """What the callback of a transition returns."""

    SUCCESS = Transition.TRANSITION_CALLBACK_SUCCESS
    FAILURE = Transition.TRANSITION_CALLBACK_FAILURE
    ERROR = Transition.TRANSITION_CALLBACK_ERROR

    def to_label(self) -> str:
        """Return the label of the transition that it makes."""
        return f"transition_{self.name.lower()}"


class LifecycleTransition(NamedTuple):
    """A transition: what it is called, and from which state to which."""

    transition_id: int
    label: str
    start: LifecycleState
    goal: LifecycleState


def _states() -> tuple[LifecycleState, ...]:
    names = [name for name in vars(State) if name.startswith(("PRIMARY_STATE_", "TRANSITION_STATE_"))]
    return tuple(LifecycleState(name.rpartition("_")[2].lower(), getattr(State, name)) for name in names)


STATES = _states()
_STATE = {state.label: state for state in STATES}


def _steps(label: str, starts: tuple[str, ...], during: str, ends: tuple[str, str]) -> tuple[LifecycleTransition, ...]:
    """Return a transition and the three ways in which it can end: `ends` of success and of failure, and error."""
    verb = label.upper()
    begin = [
        (f"{start.upper()}_{verb}" if len(starts) > 1 else verb, label, _STATE[start], _STATE[during])
        for start in starts
    ]
    goals = zip(("SUCCESS", "FAILURE", "ERROR"), (*ends, "errorprocessing"), strict=True)
    end = [(f"ON_{verb}_{word}", f"transition_{word.lower()}", _STATE[during], _STATE[goal]) for word, goal in goals]
    return tuple(
        LifecycleTransition(getattr(Transition, f"TRANSITION_{name}"), *rest) for name, *rest in (*begin, *end)
    )


TRANSITIONS = (
    *_steps("configure", ("unconfigured",), "configuring", ("inactive", "unconfigured")),
    *_steps("cleanup", ("inactive",), "cleaningup", ("unconfigured", "inactive")),
    *_steps("activate", ("inactive",), "activating", ("active", "inactive")),
    *_steps("deactivate", ("active",), "deactivating", ("inactive", "active")),
    *_steps("shutdown", ("unconfigured", "inactive", "active"), "shuttingdown", ("finalized", "finalized")),
    *(
        LifecycleTransition(number, f"transition_{word}", _STATE["errorprocessing"], _STATE[goal])
        for number, word, goal in (
            (Transition.TRANSITION_ON_ERROR_SUCCESS, "success", "unconfigured"),
            (Transition.TRANSITION_ON_ERROR_FAILURE, "failure", "finalized"),
            (Transition.TRANSITION_ON_ERROR_ERROR, "error", "finalized"),
        )
    ),
)


class StateMachine:
    """Where one node is."""

    def __init__(self) -> None:
        self.state = _STATE["unconfigured"]

    @property
    def current_state(self) -> tuple[int, str]:
        """The state as rclpy's lower half says it: (id, label)."""
        return self.state.state_id, self.state.label

    @property
    def available_transitions(self) -> tuple[LifecycleTransition, ...]:
        """What can be done in this state."""
        return tuple(step for step in TRANSITIONS if step.start == self.state)

    def find(self, wanted: int | str) -> LifecycleTransition:
        """Return the transition of that id or label from this state.

        Raises:
            RCLError: there is none; rcl's warning is in the log.
        """
        for step in self.available_transitions:
            if wanted in (step.transition_id, step.label):
                return step
        get_logger("rcl_lifecycle").warning(
            f"No transition matching {wanted} found for current state {self.state.label}"
        )
        raise RCLError(
            "Failed to trigger lifecycle state machine transition: Transition is not registered., at "
            "./src/rcl_lifecycle.c:355"
        )
