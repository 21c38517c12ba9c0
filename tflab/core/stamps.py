"""Convert and format stamps: whole nanoseconds.

    seconds(1.5)  ->  1_500_000_000  ->  "1.500000"
    a person          the engine         tf2's error texts

A float of seconds since 1970 has a resolution of about 240 ns, so the engine never
stores one. The number 0 does not mean 1970: tf2 uses it for the latest transform, and
here it is called LATEST.

tf2 calls this `TimePoint` (tf2/time.h).
"""

from __future__ import annotations

import math
from operator import index

__all__ = [
    "LATEST",
    "NSEC_PER_SEC",
    "format_stamp",
    "sec_nanosec_from_stamp",
    "seconds",
    "seconds_typed",
    "stamp_from_sec_nanosec",
]

NSEC_PER_SEC = 1_000_000_000
LATEST = 0  # tf2's "time zero": the newest moment at which every frame on the way is known


def seconds(value: float) -> int:
    """Return `value` [s] in whole nanoseconds, to the nearest: seconds(1.001) == 1_001_000_000.

    Raises:
        ValueError: `value` is not a finite number.
    """
    if not math.isfinite(value):
        raise ValueError(f"seconds({value!r}): a stamp must be a finite number of seconds")
    whole = math.floor(value)
    return int(whole) * NSEC_PER_SEC + round((value - whole) * NSEC_PER_SEC)


def seconds_typed(text: str) -> float:
    """Return the time [s] that somebody typed for how long something may take.

    Raises:
        ValueError: it is no number, or not one above zero.
    """
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not 0.0 < value < math.inf:
        raise ValueError(f"it needs a time in seconds, more than 0, not {text!r}")
    return value


def stamp_from_sec_nanosec(sec: int, nanosec: int) -> int:
    """Return the stamp [ns] of a ROS message time with fields `sec` and `nanosec`."""
    return index(sec) * NSEC_PER_SEC + index(nanosec)


def sec_nanosec_from_stamp(stamp_ns: int) -> tuple[int, int]:
    """Return (sec, nanosec) with 0 <= nanosec < 1e9; before zero, sec is rounded down.

    tf2 rounds towards zero instead and, for stamps before zero, writes a
    meaningless nanosec.  We do not copy that.
    """
    return divmod(stamp_ns, NSEC_PER_SEC)


def format_stamp(stamp_ns: int, digits: int = 6) -> str:
    """Return a time or a duration as tf2 prints it: seconds, with six decimals in its error texts.

    tf2 passes the seconds through a 32-bit integer, so a stamp from 2038-01-19
    on is printed with wrapped seconds (tf2/time.cpp, displayTimePoint).
    """
    nanosec = abs(stamp_ns) % NSEC_PER_SEC * (1 if stamp_ns >= 0 else -1)  # towards zero, as in C
    sec = (stamp_ns - nanosec) // NSEC_PER_SEC
    wrapped_sec = (sec + 2**31) % 2**32 - 2**31
    return f"{wrapped_sec + 1e-9 * nanosec:.{digits}f}"
