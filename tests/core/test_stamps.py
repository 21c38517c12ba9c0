"""Stamps are whole nanoseconds: exact conversion, and tf2's format."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tflab.core import LATEST, format_stamp, sec_nanosec_from_stamp, seconds, stamp_from_sec_nanosec
from tflab.core.stamps import seconds_typed


@given(st.integers(-(10**9), 10**9))
def test_every_millisecond_is_exact(millis: int) -> None:
    assert seconds(millis / 1000) == millis * 1_000_000


def test_seconds_rounds_to_the_nearest_nanosecond_also_long_after_1970() -> None:
    assert seconds(1.001) == 1_001_000_000
    assert seconds(1_700_000_000) == 1_700_000_000 * 10**9
    # The nearest double to 1700000000.123 is 1700000000.1229999065...: 123 ms - 93.5 ns.
    assert seconds(1_700_000_000.123) == 1_700_000_000_122_999_907


def test_a_time_that_is_no_finite_number_is_refused() -> None:
    for value in (math.nan, math.inf):
        with pytest.raises(ValueError, match="finite number of seconds"):
            seconds(value)
    assert seconds_typed("2.5") == 2.5
    for text in ("", "x", "0", "-1", "nan", "inf"):
        with pytest.raises(ValueError, match="needs a time in seconds"):
            seconds_typed(text)


@given(st.integers(-(2**62), 2**62))
def test_sec_and_nanosec_come_back_together(stamp_ns: int) -> None:
    sec, nanosec = sec_nanosec_from_stamp(stamp_ns)
    assert 0 <= nanosec < 10**9
    assert stamp_from_sec_nanosec(sec, nanosec) == stamp_ns


@pytest.mark.parametrize(
    ("stamp_ns", "text"),
    [
        (LATEST, "0.000000"),
        (1_500_000_000, "1.500000"),
        (4_999_999_999, "5.000000"),  # tf2 rounds, so two different stamps can look alike
        (-1_500_000_000, "-1.500000"),
        (2**31 * 10**9, "-2147483648.000000"),  # 2038-01-19: seconds are 32 bits there
    ],
)
def test_stamps_are_printed_as_tf2_prints_them(stamp_ns: int, text: str) -> None:
    assert format_stamp(stamp_ns) == text
