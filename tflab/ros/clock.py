"""Provide rclpy's clocks and their time jump callbacks.

```
SYSTEM_TIME   the graph's clock: virtual in pages, the machine's in real time
STEADY_TIME   the same, but never set back
ROS_TIME      SYSTEM_TIME, until use_sim_time: then what /clock says, and 0 before it said anything
```
"""

from __future__ import annotations

from collections.abc import Callable
from enum import IntEnum
from typing import Any

from .exceptions import NotInitializedException
from .graph import current_process
from .time import ClockType, Duration, Time

__all__ = ["Clock", "ClockChange", "ClockType", "JumpHandle", "JumpThreshold", "ROSClock", "TimeJump"]


class ClockChange(IntEnum):
    """What happened to a clock's source."""

    ROS_TIME_NO_CHANGE = 1
    ROS_TIME_ACTIVATED = 2
    ROS_TIME_DEACTIVATED = 3
    SYSTEM_TIME_NO_CHANGE = 4


class JumpThreshold:
    """Which jumps are worth a call.

    Args:
        min_forward: the least step forward, None for none.
        min_backward: the least step back, a negative duration, None for none.
        on_clock_change: whether turning simulated time on or off counts.

    Raises:
        ValueError: a step that is none, or in the other direction, or nothing that counts at all.
    """

    def __init__(
        self, *, min_forward: Duration | None, min_backward: Duration | None, on_clock_change: bool = True
    ) -> None:
        if min_forward is not None and min_forward.nanoseconds <= 0:
            raise ValueError("min_forward must be a positive non-zero duration")
        if min_backward is not None and min_backward.nanoseconds >= 0:
            raise ValueError("min_backward must be a negative non-zero duration")
        if min_forward is None and min_backward is None and not on_clock_change:
            raise ValueError("At least one jump threshold must be enabled")
        self.min_forward = min_forward
        self.min_backward = min_backward
        self.on_clock_change = on_clock_change

    def is_met(self, jump: TimeJump) -> bool:
        """Return whether a jump is worth a call."""
        delta_ns = jump.delta.nanoseconds
        if jump.clock_change in (ClockChange.ROS_TIME_ACTIVATED, ClockChange.ROS_TIME_DEACTIVATED):
            return self.on_clock_change
        if self.min_backward is not None and delta_ns <= self.min_backward.nanoseconds:
            return True
        return self.min_forward is not None and delta_ns >= self.min_forward.nanoseconds


class TimeJump:
    """How far a clock jumped, and whether its source changed."""

    def __init__(self, clock_change: ClockChange, delta: Duration) -> None:
        if not isinstance(clock_change, ClockChange):
            raise TypeError("clock_change must be an instance of rclpy.clock.ClockChange")
        self._clock_change = clock_change
        self._delta = delta

    @property
    def clock_change(self) -> ClockChange:
        """Whether the source changed."""
        return self._clock_change

    @property
    def delta(self) -> Duration:
        """How far."""
        return self._delta


class JumpHandle:
    """A registered pair of callbacks, to be unregistered."""

    def __init__(
        self,
        *,
        clock: Clock,
        threshold: JumpThreshold,
        pre_callback: Callable[[], None] | None,
        post_callback: Callable[[TimeJump], None] | None,
    ) -> None:
        if pre_callback is None and post_callback is None:
            raise ValueError("One of pre_callback or post_callback must be callable")
        self._clock: Clock | None = clock
        self.threshold = threshold
        self.pre_callback = pre_callback
        self.post_callback = post_callback
        clock.jump_handles.append(self)

    def unregister(self) -> None:
        """Hear of no more jumps."""
        if self._clock is not None:
            self._clock.jump_handles.remove(self)
            self._clock = None

    def __enter__(self) -> JumpHandle:
        return self

    def __exit__(self, *exc: object) -> None:
        self.unregister()


class Clock:
    """A source of Time.  `Clock(clock_type=ClockType.ROS_TIME)` makes a ROSClock.

    Attributes:
        offset_ns: how far this clock is wrong [ns]; lessons set it through graph.set_clock_offset.
        jump_handles: who wants to hear of jumps.
    """

    def __new__(cls, *, clock_type: ClockType = ClockType.SYSTEM_TIME) -> Clock:
        if not isinstance(clock_type, ClockType):
            raise TypeError("Clock type must be a ClockType enum")
        return super().__new__(ROSClock if clock_type is ClockType.ROS_TIME else cls)

    def __init__(self, *, clock_type: ClockType = ClockType.SYSTEM_TIME) -> None:
        self._clock_type = clock_type
        self._driver = current_process().driver
        self.offset_ns = 0
        self.jump_handles: list[JumpHandle] = []

    @property
    def clock_type(self) -> ClockType:
        """Which of the four kinds it is."""
        return self._clock_type

    def __repr__(self) -> str:
        return f"Clock(clock_type={self._clock_type.name})"

    def now(self) -> Time:
        """Return the present moment."""
        return Time(nanoseconds=self.now_ns(), clock_type=self._clock_type)

    def now_ns(self) -> int:
        """Return the present moment [ns]."""
        steady = self._clock_type == ClockType.STEADY_TIME
        return (self._driver.steady_ns() if steady else self._driver.now_ns()) + self.offset_ns

    @property
    def is_simulated(self) -> bool:
        """Whether it only moves when somebody sets it."""
        return False

    def create_jump_callback(
        self,
        threshold: JumpThreshold,
        *,
        pre_callback: Callable[[], None] | None = None,
        post_callback: Callable[[TimeJump], None] | None = None,
    ) -> JumpHandle:
        """Have `pre_callback()` and `post_callback(jump)` called before and after each jump worth it."""
        return JumpHandle(clock=self, threshold=threshold, pre_callback=pre_callback, post_callback=post_callback)

    def sleep_until(self, until: Time, context: Any = None) -> bool:
        """Sleep until this clock shows `until`; return False if it was kept from that.

        Raises:
            NotInitializedException: there is no context.
            ValueError: `until` is a time of another clock.
        """
        process = current_process()
        if context is None:
            context = process.default_context
        if context is None or not context.ok():
            raise NotInitializedException
        if until.clock_type != self._clock_type:
            raise ValueError("until's clock type does not match this clock's type")
        waiter = process.driver.new_waiter()
        changed: list[TimeJump] = []

        def on_jump(jump: TimeJump) -> None:
            if jump.clock_change != ClockChange.ROS_TIME_NO_CHANGE:
                changed.append(jump)
            waiter.wake()

        smallest = Duration(nanoseconds=1)
        threshold = JumpThreshold(min_forward=smallest, min_backward=Duration(nanoseconds=-1))
        with self.create_jump_callback(threshold, post_callback=on_jump), context.waking(waiter):
            while context.ok() and not changed and (left_ns := until.nanoseconds - self.now_ns()) > 0:
                process.wait(waiter, None if self.is_simulated else left_ns)
        return context.ok() and not changed and self.now_ns() >= until.nanoseconds

    def sleep_for(self, rel_time: Duration, context: Any = None) -> bool:
        """Sleep for a span of this clock; return False if it was kept from that."""
        return self.sleep_until(self.now() + rel_time, context)


class ROSClock(Clock):
    """A clock whose time can be set."""

    def __new__(cls, *, clock_type: ClockType = ClockType.ROS_TIME) -> ROSClock:
        return super().__new__(cls, clock_type=ClockType.ROS_TIME)

    def __init__(self, *, clock_type: ClockType = ClockType.ROS_TIME) -> None:
        super().__init__(clock_type=ClockType.ROS_TIME)
        self._active = False
        self._override_ns = 0

    def now_ns(self) -> int:
        """Return the present moment [ns]."""
        return self._override_ns if self._active else self._driver.now_ns() + self.offset_ns

    @property
    def is_simulated(self) -> bool:
        """Whether it only moves when somebody sets it."""
        return self._active

    @property
    def ros_time_is_active(self) -> bool:
        """Whether it only moves when somebody sets it."""
        return self._active

    def _set_ros_time_is_active(self, enabled: bool) -> None:
        if enabled == self._active:
            return
        change = ClockChange.ROS_TIME_ACTIVATED if enabled else ClockChange.ROS_TIME_DEACTIVATED
        self._jump(TimeJump(change, Duration()), active=enabled, override_ns=self._override_ns)

    def set_ros_time_override(self, time: Time) -> None:
        """Say what time it is; while simulated time is off, only remember it.

        Raises:
            TypeError: not a Time of ROS_TIME.
        """
        if not isinstance(time, Time):
            raise TypeError("Time must be specified as rclpy.time.Time. Received type: " + str(type(time)))
        if not self._active:
            self._override_ns = time.nanoseconds
            return
        delta = Duration(nanoseconds=time.nanoseconds - self._override_ns)
        self._jump(TimeJump(ClockChange.ROS_TIME_NO_CHANGE, delta), active=True, override_ns=time.nanoseconds)

    def _jump(self, jump: TimeJump, active: bool, override_ns: int) -> None:
        concerned = [handle for handle in self.jump_handles if handle.threshold.is_met(jump)]
        for handle in concerned:
            if handle.pre_callback is not None:
                handle.pre_callback()
        self._active, self._override_ns = active, override_ns
        for handle in concerned:
            if handle.post_callback is not None:
                handle.post_callback(jump)
