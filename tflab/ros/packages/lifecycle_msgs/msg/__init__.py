"""Messages of lifecycle_msgs, in process."""

from tflab.ros.messages.lifecycle_msgs import (
    State as State,
    Transition as Transition,
    TransitionDescription as TransitionDescription,
    TransitionEvent as TransitionEvent,
)
