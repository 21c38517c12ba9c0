"""Services of example_interfaces, in process."""

from tflab.ros.messages.example_interfaces import (
    AddTwoInts as AddTwoInts,
    SetBool as SetBool,
    Trigger as Trigger,
)
