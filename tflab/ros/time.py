"""When?  rclpy's Time: nanoseconds of one clock.

    Time(seconds=1, nanoseconds=5)   Time.from_msg(header.stamp)   node.get_clock().now()

Times of different clocks are not comparable, and that meets everybody once:
`Time()` is SYSTEM_TIME, a node's clock and `from_msg` are ROS_TIME.  As in rclpy,
a float of seconds is truncated.
"""

from __future__ import annotations

from tflab.core import NSEC_PER_SEC

from .clock_type import ClockType
from .duration import INT64_MAX, Duration
from .messages import builtin_interfaces

__all__ = ["Duration", "Time"]


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
        return self._nanoseconds == self._comparable(other) if isinstance(other, Time) else NotImplemented

    def __ne__(self, other: object) -> bool:
        return self._nanoseconds != self._comparable(other) if isinstance(other, Time) else NotImplemented

    def __lt__(self, other: object) -> bool:
        return self._nanoseconds < self._comparable(other) if isinstance(other, Time) else NotImplemented

    def __le__(self, other: object) -> bool:
        return self._nanoseconds <= self._comparable(other) if isinstance(other, Time) else NotImplemented

    def __gt__(self, other: object) -> bool:
        return self._nanoseconds > self._comparable(other) if isinstance(other, Time) else NotImplemented

    def __ge__(self, other: object) -> bool:
        return self._nanoseconds >= self._comparable(other) if isinstance(other, Time) else NotImplemented

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
