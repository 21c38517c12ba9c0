"""Which clock?  The four kinds of rclpy."""

from __future__ import annotations

from enum import IntEnum

__all__ = ["ClockType"]


class ClockType(IntEnum):
    """Where a time comes from; times of different kinds cannot be compared."""

    UNINITIALIZED = 0
    ROS_TIME = 1  # the system's clock, or /clock where use_sim_time is set
    SYSTEM_TIME = 2
    STEADY_TIME = 3
