"""message_filters, in process: see tflab.ros.tf2.filters."""

from tflab.ros.tf2.filters import (
    ApproximateTimeSynchronizer as ApproximateTimeSynchronizer,
    Cache as Cache,
    SimpleFilter as SimpleFilter,
    Subscriber as Subscriber,
    TimeSynchronizer as TimeSynchronizer,
)
