"""Provide timers and rates.

    created      1st call       2nd call         missed, not made up for     next
    |--- period ---|--- period ---|-----x-----x-----|----------- period ------|

The first call comes one period after the timer was made.  Calls that were missed
are skipped, not replayed.  A node's timers follow its clock, so with
use_sim_time and no /clock they never fire.
"""

from __future__ import annotations

import inspect
from collections.abc import Callable
from typing import Any

from . import distro
from .clock import Clock, ClockChange, JumpThreshold, TimeJump
from .entity import Entity, Kind
from .exceptions import InvalidHandle, ROSInterruptException
from .time import ClockType, Duration, Time

__all__ = ["Rate", "Timer", "TimerInfo"]


class TimerInfo:
    """When a timer's call was due, and when it came: given in nanoseconds, read as Time."""

    def __init__(
        self,
        *,
        expected_call_time: int = 0,
        actual_call_time: int = 0,
        clock_type: ClockType = ClockType.SYSTEM_TIME,
    ) -> None:
        self._expected_call_time = Time(nanoseconds=expected_call_time, clock_type=clock_type)
        self._actual_call_time = Time(nanoseconds=actual_call_time, clock_type=clock_type)

    @property
    def expected_call_time(self) -> Time:
        """When the call was due."""
        return self._expected_call_time

    @property
    def actual_call_time(self) -> Time:
        """When it came."""
        return self._actual_call_time


class Timer(Entity):
    """Calls back every `timer_period_ns` [ns] of its clock."""

    kind = Kind.TIMER

    def __init__(
        self,
        node: Any,
        callback: Callable[..., Any] | None,
        callback_group: Any,
        timer_period_ns: int,
        clock: Clock,
        autostart: bool = True,
    ) -> None:
        super().__init__(node, callback_group)
        self.callback = callback
        self.clock = clock
        self._period_ns = timer_period_ns
        self._canceled = not autostart
        self._wants_info = _wants_info(callback)
        now_ns = clock.now_ns()
        self._last_call_ns = now_ns
        self._next_call_ns = now_ns + timer_period_ns
        self._jump_handle = clock.create_jump_callback(
            JumpThreshold(min_forward=Duration(nanoseconds=1), min_backward=Duration(nanoseconds=-1)),
            pre_callback=self._before_jump,
            post_callback=self._after_jump,
        )
        self._left_ns: int | None = None

    @property
    def timer_period_ns(self) -> int:
        """The period [ns]; a new one counts from the next call on."""
        return self._period_ns

    @timer_period_ns.setter
    def timer_period_ns(self, value: int) -> None:
        self._period_ns = int(value)

    def is_ready(self) -> bool:
        """Return whether it is due."""
        return not self._canceled and self.clock.now_ns() >= self._next_call_ns

    is_pending = is_ready

    def is_canceled(self) -> bool:
        """Return whether it stands still."""
        return self._canceled

    def cancel(self) -> None:
        """Stand still until reset()."""
        self._canceled = True

    def reset(self) -> None:
        """Start again: the next call comes one period from now."""
        self._canceled = False
        self._next_call_ns = self.clock.now_ns() + self._period_ns
        self.mark_ready()  # the executor may sleep for longer than that

    def time_since_last_call(self) -> int:
        """Return how long ago the last call was [ns]."""
        return self.clock.now_ns() - self._last_call_ns

    def time_until_next_call(self) -> int | None:
        """Return how long it is to the next call [ns], negative if it is late; None if it was cancelled."""
        return None if self._canceled else self._next_call_ns - self.clock.now_ns()

    def destroy(self) -> None:
        if not self.is_destroyed:
            self._jump_handle.unregister()
        self._canceled = True  # nobody waits for it any more
        super().destroy()

    def take(self) -> Callable[[], Any]:
        if self.is_destroyed:
            raise InvalidHandle("cannot use Destroyable because destruction was requested")
        now_ns, expected_ns = self.clock.now_ns(), self._next_call_ns
        self._last_call_ns = now_ns
        self._next_call_ns += self._period_ns
        if self._next_call_ns < now_ns:  # skip what was missed
            if self._period_ns == 0:
                self._next_call_ns = now_ns
            else:
                periods = -((self._next_call_ns - now_ns) // self._period_ns)
                self._next_call_ns += periods * self._period_ns
        return lambda: self._call(expected_ns, now_ns)

    def _call(self, expected_ns: int, now_ns: int) -> Any:
        if self.callback is None:
            return None
        if not self._wants_info:
            return self.callback()
        return self.callback(
            TimerInfo(expected_call_time=expected_ns, actual_call_time=now_ns, clock_type=self.clock.clock_type)
        )

    def _before_jump(self) -> None:
        now_ns = self.clock.now_ns()
        self._left_ns = self._next_call_ns - now_ns if now_ns else None

    def _after_jump(self, jump: TimeJump) -> None:
        now_ns = self.clock.now_ns()
        if jump.clock_change in (ClockChange.ROS_TIME_ACTIVATED, ClockChange.ROS_TIME_DEACTIVATED):
            if now_ns == 0 or self._left_ns is None:  # no /clock yet: its first message is a jump, too
                return
            self._next_call_ns = now_ns + self._left_ns
            self._last_call_ns = self._next_call_ns - self._period_ns
        elif self._next_call_ns <= now_ns:
            self.mark_ready()
        elif now_ns < self._last_call_ns:  # time went back to before the last call
            self._next_call_ns = now_ns + self._period_ns
            self._last_call_ns = now_ns


def _wants_info(callback: Callable[..., Any] | None) -> bool:
    """Return whether a callback has an argument that is annotated as TimerInfo, and the release passes it."""
    if not distro.current().timer_passes_info:
        return False
    try:
        parameters = inspect.signature(callback).parameters.values()
    except (TypeError, ValueError):
        return False
    return any(parameter.annotation in (TimerInfo, "TimerInfo") for parameter in parameters)


class Rate:
    """Sleeps until the next tick; somebody else must spin the node."""

    def __init__(self, timer: Timer, context: Any) -> None:
        self._timer = timer
        self._context = context
        self._ticks = 0
        self._waiter = context.process.driver.new_waiter()
        timer.callback = self._tick
        context.on_shutdown(self._waiter.wake, at_ctrl_c=True)

    def sleep(self) -> None:
        """Block until the next tick.

        Raises:
            ROSInterruptException: the context is, or was, shut down.
        """
        ticks = self._ticks
        self._context.process.wait_until(
            lambda: self._ticks > ticks or not self._context.ok() or self._timer.is_destroyed, self._waiter, None
        )
        if not self._context.ok() or self._timer.is_destroyed:
            raise ROSInterruptException

    def destroy(self) -> None:
        """Wake whoever sleeps."""
        self._timer.destroy()
        self._waiter.wake()

    def _tick(self) -> None:
        self._ticks += 1
        self._waiter.wake()
