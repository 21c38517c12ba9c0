"""Is this line worth printing again?  The filters of a log call: throttle, skip_first, once.

    logger.info(text, throttle_duration_sec=1.0)    at most once a second
    logger.info(text, skip_first=True)              not the first time
    logger.info(text, once=True)                    one time only

Each place in the code has its own memory.  Filters are asked in this order, and one
that says no keeps the later ones from noticing: with skip_first and once, the second
call is printed.  On simulated time, which begins at 0, throttling begins there, too.
What a place asks for must not change from call to call.

upstream: rclpy/impl/rcutils_logger.py.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from tflab.core import NSEC_PER_SEC

__all__ = ["CallSite", "Place"]

Place = tuple[str, int, int]  # file, line, and which instruction of it

# Of each filter its options, the required one first; it is in use if that one says so.
FILTERS = {
    "throttle": ("throttle_duration_sec", "throttle_time_source_type"),
    "skip_first": ("skip_first",),
    "once": ("once",),
}


class CallSite:
    """What one log call in the code asked for, and what it has said so far."""

    def __init__(self, name: str, severity: int, options: dict[str, Any]) -> None:
        self._name = name
        self._severity = severity
        self._filters = _filters_in(options)
        self._options = dict(options)
        self._last_ns: int | None = None
        self._is_first = True
        self._was_printed = False

    def passes(self, name: str, severity: int, options: dict[str, Any], now_ns: Callable[[], int]) -> bool:
        """Return whether the line is to be printed now.

        Raises:
            ValueError: it asks for something else than before.
        """
        if severity != self._severity:
            raise ValueError("Logger severity cannot be changed between calls.")
        if name != self._name:
            raise ValueError("Logger name cannot be changed between calls.")
        if _filters_in(options) != self._filters:
            raise ValueError("Requested logging filters cannot be changed between calls.")
        if self._filters and options != self._options:
            raise ValueError("Logging filter parameters cannot be changed between calls.")
        asked = {"throttle": lambda: self._throttle(now_ns), "skip_first": self._skip_first, "once": self._once}
        return all(asked[each]() for each in self._filters)

    def _throttle(self, now_ns: Callable[[], int]) -> bool:
        clock = self._options.get("throttle_time_source_type")
        now = clock.now().nanoseconds if clock else now_ns()
        period_ns = self._options["throttle_duration_sec"] * NSEC_PER_SEC
        last_ns = 0 if self._last_ns is None and clock and clock.is_simulated else self._last_ns
        if last_ns is not None and now < last_ns + period_ns:
            return False
        self._last_ns = now
        return True

    def _skip_first(self) -> bool:
        was_first, self._is_first = self._is_first, False
        return not was_first

    def _once(self) -> bool:
        had_printed, self._was_printed = self._was_printed, True
        return not had_printed


def _filters_in(options: dict[str, Any]) -> tuple[str, ...]:
    """Return the filters that the options ask for.

    Raises:
        TypeError: an option of none of them, or one without the option that it belongs to.
    """
    known = [option for names in FILTERS.values() for option in names]
    for option in options:
        if option not in known:
            raise TypeError(f'parameter "{option}" is not one of the recognized logging options "{known}"')
    for kind, (required, *others) in FILTERS.items():
        if required not in options and any(option in options for option in others):
            raise TypeError(
                f'required parameter "{required}" not specified but is required for the the logging filter "{kind}"'
            )
    return tuple(kind for kind, (required, *_) in FILTERS.items() if options.get(required))
