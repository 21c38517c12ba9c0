"""How long?  rclpy's Duration: a signed number of nanoseconds in 64 bits.

    Duration(seconds=0.2)      Duration(nanoseconds=-5)

As in rclpy, a float of seconds is truncated, not rounded.
"""

from __future__ import annotations

import math

from tflab.core import NSEC_PER_SEC

from .messages import builtin_interfaces

__all__ = ["Duration", "Infinite"]

INT64_MAX = 2**63 - 1
INT64_MIN = -(2**63)


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
        return self._nanoseconds == other._nanoseconds if isinstance(other, Duration) else NotImplemented

    def __ne__(self, other: object) -> bool:
        return self._nanoseconds != other._nanoseconds if isinstance(other, Duration) else NotImplemented

    def __lt__(self, other: object) -> bool:
        return self._nanoseconds < other._nanoseconds if isinstance(other, Duration) else NotImplemented

    def __le__(self, other: object) -> bool:
        return self._nanoseconds <= other._nanoseconds if isinstance(other, Duration) else NotImplemented

    def __gt__(self, other: object) -> bool:
        return self._nanoseconds > other._nanoseconds if isinstance(other, Duration) else NotImplemented

    def __ge__(self, other: object) -> bool:
        return self._nanoseconds >= other._nanoseconds if isinstance(other, Duration) else NotImplemented

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
