"""Print and filter log lines as ROS 2 does.

    logger.info(text, throttle_duration_sec=1.0)    at most once a second
    logger.info(text, skip_first=True)              not the first time
    logger.info(text, once=True)                    only the first time

Each call site has its own memory. Filters run in this order, and a filter that rejects
a line keeps the later ones from counting it: with skip_first and once, the second call
is printed. On simulated time, which begins at 0, throttling begins there, too. The
filters of a call site must not change.

upstream: rclpy/impl/rcutils_logger.py.
"""

from __future__ import annotations

import logging
import os
import sys
from collections.abc import Callable
from enum import IntEnum
from pathlib import Path
from typing import Any

from tflab.core import NSEC_PER_SEC

from .exceptions import RCLError
from .graph import current_process
from .process import write_line

__all__ = [
    "CallSite",
    "LoggingSeverity",
    "Place",
    "RcutilsLogger",
    "clear_config",
    "get_logger",
    "get_logger_effective_level",
    "get_logger_level",
    "get_logging_directory",
    "get_logging_severity_from_string",
    "set_logger_level",
    "show_engine_refusals",
    "write_to_stdout",
]


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


class LoggingSeverity(IntEnum):
    """How bad it is."""

    UNSET = 0
    DEBUG = 10
    INFO = 20
    WARN = 30
    ERROR = 40
    FATAL = 50


DEFAULT_LEVEL = LoggingSeverity.INFO
_levels: dict[str, LoggingSeverity] = {}
_stdout = False


def write_to_stdout(on: bool) -> None:
    """Have log lines go to stdout, as pages want it; otherwise the environment decides."""
    global _stdout
    _stdout = on


def get_logger(name: str) -> RcutilsLogger:
    """Return the logger of that name.

    Raises:
        ValueError: no name.
    """
    if not name:
        raise ValueError("Logger name must not be empty.")
    return RcutilsLogger(name)


def set_logger_level(name: str, level: LoggingSeverity | int, detailed_error: bool = False) -> None:
    """Let a logger, and those below it, print from `level` on; errors are detailed in any case."""
    _levels[name] = LoggingSeverity(level)


def get_logging_severity_from_string(log_severity: str) -> LoggingSeverity:
    """Return the severity of that name, in capitals or not.

    Raises:
        RCLError: there is none.
    """
    try:
        return LoggingSeverity[log_severity.upper()]
    except KeyError:
        raise RCLError(
            f"Failed to get log severity from name: '{log_severity}', it is none of "
            f"{', '.join(LoggingSeverity.__members__)}"
        ) from None


def get_logging_directory() -> Path:
    """Return where ROS 2 would write its log files: ROS_LOG_DIR, else `log` in ROS_HOME, else in ~/.ros."""
    if directory := os.environ.get("ROS_LOG_DIR"):
        return Path(directory).expanduser()
    home = os.environ.get("ROS_HOME")
    return (Path(home).expanduser() if home else Path.home() / ".ros") / "log"


def clear_config() -> None:
    """Forget every level that was set."""
    _levels.clear()


def get_logger_level(name: str) -> LoggingSeverity:
    """Return the level that was set for exactly this logger, or UNSET."""
    return _levels.get(name, LoggingSeverity.UNSET)


def get_logger_effective_level(name: str) -> LoggingSeverity:
    """Return the level from which on a logger prints, its own or the nearest ancestor's; the root's may be UNSET."""
    while name:
        if _levels.get(name):
            return _levels[name]
        name = name.rpartition(".")[0]
    return _levels.get("", DEFAULT_LEVEL)


class RcutilsLogger:
    """One source of log lines.

    Args:
        name: as the lines show it.
        now_ns: the clock for the lines [ns]; the graph's if None.
        also: called with (stamp_ns, severity, name, message, file, function, line), for /rosout.
    """

    def __init__(
        self, name: str = "", now_ns: Callable[[], int] | None = None, also: Callable[..., None] | None = None
    ) -> None:
        self.name = name
        self._now_ns = now_ns
        self._also = also
        self._sites: dict[Place, CallSite] = {}

    def get_child(self, name: str) -> RcutilsLogger:
        """Return a logger below this one.

        Raises:
            ValueError: no name.
        """
        if not name:
            raise ValueError("Child logger name must not be empty.")
        return RcutilsLogger(f"{self.name}.{name}" if self.name else name, self._now_ns, self._also)

    def set_level(self, level: LoggingSeverity | int) -> None:
        """Print from `level` on."""
        set_logger_level(self.name, level)

    def get_effective_level(self) -> LoggingSeverity:
        """Return the level from which on it prints."""
        return get_logger_effective_level(self.name)

    def is_enabled_for(self, severity: LoggingSeverity | int) -> bool:
        """Return whether a line of that severity would be printed."""
        return severity >= get_logger_effective_level(self.name)

    def debug(self, message: str, **options: object) -> bool:
        """Say something for whoever looks for a fault; return whether it was printed."""
        return self._log(message, LoggingSeverity.DEBUG, **options)

    def info(self, message: str, **options: object) -> bool:
        """Say that something happened; return whether it was printed."""
        return self._log(message, LoggingSeverity.INFO, **options)

    def warning(self, message: str, **options: object) -> bool:
        """Say that something looks wrong; return whether it was printed."""
        return self._log(message, LoggingSeverity.WARN, **options)

    warn = warning

    def error(self, message: str, **options: object) -> bool:
        """Say that something is wrong; return whether it was printed."""
        return self._log(message, LoggingSeverity.ERROR, **options)

    def fatal(self, message: str, **options: object) -> bool:
        """Say that it cannot go on; return whether it was printed."""
        return self._log(message, LoggingSeverity.FATAL, **options)

    def log(self, message: str, severity: LoggingSeverity | int, **options: object) -> bool:
        """Say something of any severity; return whether it was printed.

        Options: `once`, `skip_first`, `throttle_duration_sec` [s] with
        `throttle_time_source_type`, a Clock; and `name`, in place of the logger's own.
        """
        return self._log(message, LoggingSeverity(severity), **options)

    def _log(self, message: str, severity: LoggingSeverity, **options: object) -> bool:
        if not isinstance(message, str):
            raise TypeError(f"a log message is a str, not {type(message).__name__}: write f'{{...}}' around it")
        name = options.pop("name", self.name)
        if severity < get_logger_effective_level(name):
            return False
        frame = sys._getframe(2)
        code = frame.f_code
        place = (code.co_filename, frame.f_lineno, frame.f_lasti)
        if place not in self._sites:
            self._sites[place] = CallSite(name, severity, options)
        if not self._sites[place].passes(name, severity, options, _time_ns):
            return False
        now_ns = self._now_ns() if self._now_ns else _time_ns()
        print_line(severity, name, message, now_ns)
        if self._also:
            self._also(now_ns, severity, name, message, code.co_filename, code.co_name, frame.f_lineno)
        return True


_root_logger = RcutilsLogger()


def _time_ns() -> int:
    return current_process().driver.now_ns()


def print_line(severity: LoggingSeverity, name: str, message: str, now_ns: int) -> None:
    """Print one line in ROS 2's console format."""
    sec, nanosec = divmod(now_ns, NSEC_PER_SEC)
    to_stdout = _stdout or os.environ.get("RCUTILS_LOGGING_USE_STDOUT") == "1"
    line = f"[{severity.name}] [{sec}.{nanosec:09d}] [{name}]: {message}"
    write_line(line, sys.stdout if to_stdout else sys.stderr)


class _EngineHandler(logging.Handler):
    """Prints what the engine refuses, from ROS 2's nameless logger."""

    def emit(self, record: logging.LogRecord) -> None:
        severity = LoggingSeverity.ERROR if record.levelno >= logging.ERROR else LoggingSeverity.WARN
        if severity >= get_logger_effective_level(""):
            print_line(severity, "", record.getMessage(), current_process().driver.now_ns())


_engine_handler = _EngineHandler()


def show_engine_refusals(on: bool) -> None:
    """Have the engine's log lines (logger `tflab.tf2`) printed as ROS 2's."""
    logger = logging.getLogger("tflab.tf2")
    if on and _engine_handler not in logger.handlers:
        logger.addHandler(_engine_handler)
    elif not on:
        logger.removeHandler(_engine_handler)
