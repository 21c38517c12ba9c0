"""What do nodes say?  Log lines as ROS 2 prints them.

    [WARN] [1712829858.209008073] [point_to_map]: no transform yet
     level  when                   who            what

The time is that of the graph (the machine's clock in real time), even where a
node follows /clock.  Lines go to stderr, or to stdout with
RCUTILS_LOGGING_USE_STDOUT=1.  The engine's refusals (TF_OLD_DATA ...) appear
here as well, from the nameless logger `[]`, as on a robot.
"""

from __future__ import annotations

import logging
import os
import sys
from collections.abc import Callable
from enum import IntEnum
from pathlib import Path

from tflab.core import NSEC_PER_SEC

from .exceptions import RCLError
from .graph import current_process
from .logging_filters import CallSite, Place

__all__ = [
    "LoggingSeverity",
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

    def warn(self, message: str, **options: object) -> bool:
        """Say that something looks wrong; return whether it was printed."""
        return self._log(message, LoggingSeverity.WARN, **options)

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
    stream = sys.stdout if to_stdout else sys.stderr
    print(f"[{severity.name}] [{sec}.{nanosec:09d}] [{name}]: {message}", file=stream, flush=True)


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
