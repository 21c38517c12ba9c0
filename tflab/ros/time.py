"""Provide rclpy's Time, Duration and ClockType.

    Time(seconds=1, nanoseconds=5)   Time.from_msg(header.stamp)   node.get_clock().now()
    Duration(seconds=0.2)            Duration(nanoseconds=-5)

Times of different clocks cannot be compared: `Time()` is SYSTEM_TIME, a node's clock
and `from_msg` give ROS_TIME. As in rclpy, a float of seconds is truncated, and a
Duration is a signed number of nanoseconds in 64 bits.
"""

from __future__ import annotations

import math
from enum import IntEnum
from functools import total_ordering
from typing import Any

from tflab.core import NSEC_PER_SEC

from . import distro
from .messages import builtin_interfaces

__all__ = ["ClockType", "Duration", "Infinite", "Time"]


class ClockType(IntEnum):
    """Where a time comes from; times of different kinds cannot be compared."""

    UNINITIALIZED = 0
    ROS_TIME = 1  # the system's clock, or /clock where use_sim_time is set
    SYSTEM_TIME = 2
    STEADY_TIME = 3


INT64_MAX = 2**63 - 1
INT64_MIN = -(2**63)


@total_ordering
class Duration:
    """A span of time, positive or negative."""

    __slots__ = ("_nanoseconds",)
    __hash__ = None  # as in rclpy, which defines == alone

    def __init__(self, *, seconds: float = 0, nanoseconds: int = 0) -> None:
        total = int(seconds * NSEC_PER_SEC) + int(nanoseconds)
        if not INT64_MIN <= total <= INT64_MAX:
            raise OverflowError("Total nanoseconds value is too large to store in C duration.")
        self._nanoseconds = total

    @property
    def nanoseconds(self) -> int:
        """The whole span [ns]."""
        return self._nanoseconds

    def __repr__(self) -> str:
        return f"Duration(nanoseconds={self._nanoseconds})"

    def __str__(self) -> str:
        return "Infinite" if self == Infinite else f"{self._nanoseconds} nanoseconds"

    def __eq__(self, other: object) -> bool:
        return self._nanoseconds == other._nanoseconds if isinstance(other, Duration) else _unequal(self, other)

    def __lt__(self, other: object) -> bool:
        return self._nanoseconds < other._nanoseconds if isinstance(other, Duration) else NotImplemented

    def __add__(self, other: Duration) -> Duration:
        if not isinstance(other, Duration):
            return NotImplemented
        return Duration(nanoseconds=self._nanoseconds + other._nanoseconds)

    def __sub__(self, other: Duration) -> Duration:
        if not isinstance(other, Duration):
            return NotImplemented
        return Duration(nanoseconds=self._nanoseconds - other._nanoseconds)

    def __mul__(self, factor: float) -> Duration:
        if not isinstance(factor, (int, float)):
            return NotImplemented
        if isinstance(factor, float) and math.isnan(factor):
            raise ValueError("a Duration cannot be multiplied by nan")
        if isinstance(factor, float) and math.isinf(factor):
            return Infinite
        return Duration(nanoseconds=int(self._nanoseconds * factor))

    __rmul__ = __mul__

    def to_msg(self) -> builtin_interfaces.Duration:
        """Return the message; -0.5 s is sec -1 and nanosec 500000000."""
        sec, nanosec = divmod(self._nanoseconds, NSEC_PER_SEC)
        return builtin_interfaces.Duration(sec=sec, nanosec=nanosec)

    @classmethod
    def from_msg(cls, msg: builtin_interfaces.Duration) -> Duration:
        """Return the span of a builtin_interfaces/Duration."""
        if not isinstance(msg, builtin_interfaces.Duration):
            raise TypeError("Must pass a builtin_interfaces.msg.Duration object")
        return cls(seconds=msg.sec, nanoseconds=msg.nanosec)


Infinite = Duration(nanoseconds=INT64_MAX)


def _unequal(one: Time | Duration, other: object) -> Any:
    """Leave a comparison with another type to Python, or refuse it as Humble does."""
    if not distro.current().compares_any_type:
        raise TypeError(f"Can't compare {type(one).__name__.lower()} with object of type: ", type(other))
    return NotImplemented


@total_ordering
class Time:
    """A moment on one clock."""

    __slots__ = ("_clock_type", "_nanoseconds")
    __hash__ = None  # as in rclpy, which defines == alone

    def __init__(
        self, *, seconds: float = 0, nanoseconds: int = 0, clock_type: ClockType = ClockType.SYSTEM_TIME
    ) -> None:
        if not isinstance(clock_type, ClockType):
            raise TypeError("Clock type must be a ClockType enum")
        if seconds < 0:
            raise ValueError("Seconds value must not be negative")
        if nanoseconds < 0:
            raise ValueError("Nanoseconds value must not be negative")
        total = int(seconds * NSEC_PER_SEC) + int(nanoseconds)
        if total > INT64_MAX:
            raise OverflowError("Total nanoseconds value is too large to store in C time point.")
        self._nanoseconds = total
        self._clock_type = clock_type

    @property
    def nanoseconds(self) -> int:
        """Since the clock's zero [ns]."""
        return self._nanoseconds

    @property
    def clock_type(self) -> ClockType:
        """The clock."""
        return self._clock_type

    def seconds_nanoseconds(self) -> tuple[int, int]:
        """Return (whole seconds, remaining nanoseconds)."""
        return divmod(self._nanoseconds, NSEC_PER_SEC)

    def __repr__(self) -> str:
        return f"Time(nanoseconds={self._nanoseconds}, clock_type={self._clock_type.name})"

    def __add__(self, other: Duration) -> Time:
        if not isinstance(other, Duration):
            return NotImplemented
        try:
            return Time(nanoseconds=self._nanoseconds + other.nanoseconds, clock_type=self._clock_type)
        except OverflowError:
            raise OverflowError("Addition leads to overflow in C storage.") from None

    __radd__ = __add__

    def __sub__(self, other: Time | Duration) -> Duration | Time:
        if isinstance(other, Time):
            if self._clock_type != other._clock_type:
                raise TypeError("Can't subtract times with different clock types")
            return Duration(nanoseconds=self._nanoseconds - other._nanoseconds)
        if isinstance(other, Duration):
            try:
                return Time(nanoseconds=self._nanoseconds - other.nanoseconds, clock_type=self._clock_type)
            except ValueError:
                raise ValueError("Subtraction leads to negative time.") from None
        return NotImplemented

    def __eq__(self, other: object) -> bool:
        return self._nanoseconds == self._comparable(other) if isinstance(other, Time) else _unequal(self, other)

    def __lt__(self, other: object) -> bool:
        return self._nanoseconds < self._comparable(other) if isinstance(other, Time) else NotImplemented

    def _comparable(self, other: Time) -> int:
        if self._clock_type != other._clock_type:
            raise TypeError("Can't compare times with different clock types")
        return other._nanoseconds

    def to_msg(self) -> builtin_interfaces.Time:
        """Return the message, as for header.stamp."""
        sec, nanosec = divmod(self._nanoseconds, NSEC_PER_SEC)
        return builtin_interfaces.Time(sec=sec, nanosec=nanosec)

    @classmethod
    def from_msg(cls, msg: builtin_interfaces.Time, clock_type: ClockType = ClockType.ROS_TIME) -> Time:
        """Return the moment of a builtin_interfaces/Time."""
        if not isinstance(msg, builtin_interfaces.Time):
            raise TypeError("Must pass a builtin_interfaces.msg.Time object")
        return cls(seconds=msg.sec, nanoseconds=msg.nanosec, clock_type=clock_type)
