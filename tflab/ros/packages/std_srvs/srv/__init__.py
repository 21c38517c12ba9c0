"""Services of std_srvs, in process."""

from tflab.ros.messages.std_srvs import (
    Empty as Empty,
    SetBool as SetBool,
    Trigger as Trigger,
)
