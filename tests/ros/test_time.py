"""rclpy's Time, Duration and Clock: conversion, arithmetic and errors."""

import operator

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tflab.ros.clock import Clock, ClockChange, JumpThreshold, ROSClock, TimeJump
from tflab.ros.messages import builtin_interfaces
from tflab.ros.time import ClockType, Duration, Infinite, Time

LARGEST = 2**63 - 1


# Time -----------------------------------------------------------------------------


def test_a_time_is_whole_nanoseconds_of_one_clock():
    time = Time(seconds=1, nanoseconds=5)
    assert time.nanoseconds == 1_000_000_005
    assert Time(seconds=1.001).nanoseconds == 1_000_999_999  # truncated, as in rclpy
    assert time.clock_type == ClockType.SYSTEM_TIME
    assert time.seconds_nanoseconds() == (1, 5)
    assert repr(Time(nanoseconds=5, clock_type=ClockType.ROS_TIME)) == "Time(nanoseconds=5, clock_type=ROS_TIME)"


@pytest.mark.parametrize(
    ("make", "error", "text"),
    [
        (lambda: Time(seconds=-1), ValueError, "Seconds value must not be negative"),
        (lambda: Time(nanoseconds=-1), ValueError, "Nanoseconds value must not be negative"),
        (lambda: Time(nanoseconds=2**63), OverflowError, None),
        (lambda: Time(clock_type="ROS_TIME"), TypeError, "Clock type must be a ClockType enum"),
        (lambda: Time.from_msg("now"), TypeError, None),
        (lambda: Time(1), TypeError, None),
    ],
)
def test_what_is_no_time_is_refused(make, error, text):
    with pytest.raises(error, match=text):
        make()


def test_a_message_becomes_a_ros_time_and_a_default_time_is_of_the_system():
    message = builtin_interfaces.Time(sec=3, nanosec=7)
    assert repr(Time.from_msg(message)) == "Time(nanoseconds=3000000007, clock_type=ROS_TIME)"
    assert Time.from_msg(message, clock_type=ClockType.SYSTEM_TIME).clock_type == ClockType.SYSTEM_TIME
    assert Time().clock_type == ClockType.SYSTEM_TIME


@given(st.integers(0, (2**31 - 1) * 10**9 + 999_999_999))
def test_a_time_survives_conversion_to_a_message(nanoseconds):
    assert Time.from_msg(Time(nanoseconds=nanoseconds).to_msg()).nanoseconds == nanoseconds


@pytest.mark.parametrize("compare", [operator.eq, operator.ne, operator.lt, operator.le, operator.gt, operator.ge])
def test_times_of_different_clocks_can_be_neither_compared_nor_subtracted(compare):
    with pytest.raises(TypeError, match="Can't compare times with different clock types"):
        compare(Time(), Time(clock_type=ClockType.ROS_TIME))
    with pytest.raises(TypeError, match="Can't subtract times with different clock types"):
        Time(clock_type=ClockType.ROS_TIME) - Time()


def test_a_time_is_unequal_to_other_things_but_not_orderable_with_them():
    assert Time() != 0
    assert (Time() == "now") is False
    with pytest.raises(TypeError):
        _ = Time() < 1
    with pytest.raises(TypeError):
        hash(Time())


def test_arithmetic_of_times_and_durations():
    at_five, two = Time(seconds=5, clock_type=ClockType.ROS_TIME), Duration(seconds=2)
    assert repr(at_five + two) == repr(two + at_five) == "Time(nanoseconds=7000000000, clock_type=ROS_TIME)"
    assert (at_five - two).nanoseconds == 3_000_000_000
    earlier = Time(seconds=1, clock_type=ClockType.ROS_TIME)
    assert (earlier - at_five) == Duration(seconds=-4)


@pytest.mark.parametrize(
    ("attempt", "error", "text"),
    [
        (lambda: Time(nanoseconds=LARGEST) + Duration(nanoseconds=1), OverflowError, "Addition leads to overflow in C"),
        (lambda: Time(seconds=1) - Duration(seconds=2), ValueError, None),
        (lambda: Time(seconds=1) + Duration(seconds=-2), ValueError, None),
        (lambda: Time() + Time(), TypeError, None),
        (lambda: Duration() - Time(), TypeError, None),
        (lambda: Time() + 1, TypeError, None),
        (lambda: Duration(nanoseconds=2**63), OverflowError, None),
        (lambda: Duration(nanoseconds=-(2**63) - 1), OverflowError, None),
        (lambda: JumpThreshold(min_forward=Duration(), min_backward=None), ValueError, "min_forward"),
        (lambda: JumpThreshold(min_forward=None, min_backward=Duration(seconds=1)), ValueError, "min_backward"),
        (lambda: JumpThreshold(min_forward=None, min_backward=Duration()), ValueError, "min_backward"),
    ],
)
def test_invalid_arithmetic_is_refused(attempt, error, text):
    with pytest.raises(error, match=text):
        attempt()


# Duration -------------------------------------------------------------------------


def test_a_duration_may_be_negative_and_has_a_repr():
    assert Duration(seconds=-0.5).nanoseconds == -500_000_000
    assert repr(Duration(nanoseconds=5)) == "Duration(nanoseconds=5)"
    assert str(Duration(nanoseconds=5)) == "5 nanoseconds"
    assert (str(Infinite), Infinite.nanoseconds) == ("Infinite", LARGEST)
    message = Duration(seconds=-0.5).to_msg()
    assert (message.sec, message.nanosec) == (-1, 500_000_000)
    assert Duration.from_msg(message) == Duration(seconds=-0.5)


def test_arithmetic_and_order_of_durations():
    one, two = Duration(seconds=1), Duration(seconds=2)
    assert one + two == Duration(seconds=3)
    assert one - two == Duration(seconds=-1)
    assert one * 2 == two
    assert two * 0.25 == Duration(seconds=0.5)
    assert one < two <= two
    assert one != 1
    assert one * float("inf") == Infinite
    with pytest.raises(ValueError):
        one * float("nan")


# Clocks ---------------------------------------------------------------------------


def test_a_clock_of_ros_time_is_a_ros_clock_and_the_default_is_of_the_system():
    assert isinstance(Clock(clock_type=ClockType.ROS_TIME), ROSClock)
    assert repr(Clock()) == "Clock(clock_type=SYSTEM_TIME)"
    assert repr(ROSClock()) == "Clock(clock_type=ROS_TIME)"
    assert ROSClock().now().clock_type == ClockType.ROS_TIME
    with pytest.raises(TypeError):
        Clock(clock_type=1.5)


def at(seconds):
    return Time(seconds=seconds, clock_type=ClockType.ROS_TIME)


def test_a_ros_clock_stays_at_zero_until_its_override_is_set():
    clock, inactive = ROSClock(), ROSClock()
    clock._set_ros_time_is_active(True)
    assert clock.ros_time_is_active
    assert clock.now() == at(0)
    clock.set_ros_time_override(at(12))
    assert clock.now() == at(12)
    inactive.set_ros_time_override(at(12))
    assert inactive.now() != at(12)  # it is only remembered
    inactive._set_ros_time_is_active(True)
    assert inactive.now() == at(12)


def jumps_heard(threshold, *times, start=100):
    """Return the jumps [s] that a callback with this threshold hears, on a clock that is told these times."""
    clock, heard = ROSClock(), []
    clock._set_ros_time_is_active(True)
    clock.set_ros_time_override(at(start))
    with clock.create_jump_callback(threshold, post_callback=lambda jump: heard.append(jump.delta.nanoseconds)):
        for time in times:
            clock.set_ros_time_override(at(time))
    return [delta_ns / 1e9 for delta_ns in heard]


def test_a_jump_callback_is_called_for_jumps_of_at_least_its_threshold():
    back = JumpThreshold(min_forward=None, min_backward=Duration(seconds=-1), on_clock_change=True)
    assert jumps_heard(back, 99.5, 98.5, 97.6, 200.0) == [-1.0]
    forward = JumpThreshold(min_forward=Duration(seconds=2), min_backward=None)
    assert jumps_heard(forward, 101, 103, 50) == [2.0]


def test_turning_simulated_time_on_calls_jump_callbacks_that_request_it():
    clock, heard = ROSClock(), []
    deaf = JumpThreshold(min_forward=Duration(seconds=1), min_backward=None, on_clock_change=False)
    curious = JumpThreshold(min_forward=None, min_backward=None, on_clock_change=True)
    clock.create_jump_callback(deaf, post_callback=lambda jump: heard.append("deaf"))
    handle = clock.create_jump_callback(
        curious, pre_callback=lambda: heard.append("before"), post_callback=lambda jump: heard.append(jump.clock_change)
    )
    clock._set_ros_time_is_active(True)
    assert heard == ["before", ClockChange.ROS_TIME_ACTIVATED]
    handle.unregister()
    clock._set_ros_time_is_active(False)
    assert heard == ["before", ClockChange.ROS_TIME_ACTIVATED]


def test_a_jump_callback_needs_a_callback_and_a_jump_a_change():
    with pytest.raises(ValueError):
        ROSClock().create_jump_callback(JumpThreshold(min_forward=None, min_backward=None))
    with pytest.raises(ValueError, match="must be enabled"):
        JumpThreshold(min_forward=None, min_backward=None, on_clock_change=False)
    with pytest.raises(TypeError):
        TimeJump("activated", Duration())
