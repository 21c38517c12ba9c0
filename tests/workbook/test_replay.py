"""A reply shows the call that went wrong beside the expected result, and `call` returns its arguments."""

from __future__ import annotations

import math

import pytest

from tflab.ros.messages.geometry_msgs import TransformStamped
from tflab.workbook import call, check
from tflab.workbook.answers.values import to_plain
from tflab.workbook.replay import differing


def mount(yaw, sec=0):
    message = TransformStamped()
    message.header.stamp.sec = sec
    message.transform.rotation.z, message.transform.rotation.w = math.sin(yaw / 2.0), math.cos(yaw / 2.0)
    return message


@pytest.mark.parametrize(
    ("got", "expected", "path"),
    [
        ({"x": 1.0, "y": 2.0}, {"x": 1.0, "y": 2.5}, '["y"]'),
        ([("a", "up"), ("b", "up")], [("a", "up"), ("b", "down")], "[1][1]"),
        ([1, 2], [1, 3], ""),
        (["a"], ["a", "b"], ""),
        ({"x": 1.0}, {"y": 1.0}, ""),
        (None, "odom", ""),
        ({"at": (1.0 + 1e-9, 2.0), "yaw": 0.0}, {"at": (1.0, 2.0), "yaw": 1.0}, '["yaw"]'),
        (mount(0.0, sec=4), mount(math.pi), ".transform.rotation"),
        (mount(2.0 * math.pi, sec=4), mount(0.0), ".header.stamp"),  # q and -q are one rotation
    ],
)
def test_the_first_place_where_two_results_differ_is_found(got, expected, path):
    assert differing(to_plain(got), to_plain(expected))[0] == path


def test_a_reply_shows_result_and_expected_result_side_by_side(capsys):
    check("E4.7", lambda prefix, name: prefix + name)
    shown = 'The call frame_name("", "/camera_link") gave "/camera_link". Expected: "camera_link".'
    assert shown in capsys.readouterr().out


def test_call_returns_the_arguments_of_the_call_that_the_reply_showed(capsys):
    def straight(parent_of, target, source):
        return [source, target]

    check("E4.3", straight)
    assert 'call("E4.3") returns its arguments.' in capsys.readouterr().out
    shown = call("E4.3")
    assert list(vars(shown)) == ["parent_of", "target", "source"]
    assert isinstance(shown.parent_of, dict) and shown.source in shown.parent_of
    assert 'source     "imu_link"' in capsys.readouterr().out


def test_call_says_that_a_task_of_values_has_none(capsys):
    assert call("E3.1") is None
    assert "asks for a value" in capsys.readouterr().out
