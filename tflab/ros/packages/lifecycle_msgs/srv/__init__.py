"""Services of lifecycle_msgs, in process."""

from tflab.ros.messages.lifecycle_msgs import (
    ChangeState as ChangeState,
    GetAvailableStates as GetAvailableStates,
    GetAvailableTransitions as GetAvailableTransitions,
    GetState as GetState,
)
