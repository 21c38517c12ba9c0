"""A reply shows the call that went wrong beside the expected result, and `call` returns its arguments."""

from __future__ import annotations

import ast
import re

import pytest

from tflab.ros.messages.geometry_msgs import PointStamped
from tflab.workbook import call, check
from tflab.workbook.answers.forms import Choice, Message, Name, Number, Pair, Parts, Sequence, Vector
from tflab.workbook.answers.values import to_plain
from tflab.workbook.replay import differing

PAIRS = Sequence(Pair(Name(), Choice(("up", "down"))))
PLANAR = Parts({"x": Number("m"), "position": Vector(2)})
POINT = Message("geometry_msgs/msg/PointStamped", ("header.frame_id", "point"))


def point(x):
    message = PointStamped()
    message.point.x = x
    return message


@pytest.mark.parametrize(
    ("form", "got", "expected", "path"),
    [
        (PLANAR, {"x": 1.0, "position": (1.0, 2.0)}, {"x": 1.0 + 1e-9, "position": (1.0, 2.5)}, '["position"]'),
        (PAIRS, [("a", "up"), ("b", "up")], [("a", "up"), ("b", "down")], "[1][1]"),
        (PAIRS, [("a", "up")], [("a", "up"), ("b", "down")], ""),
        (POINT, point(1.0), point(2.0), ".point"),
        (Name(), None, "odom", ""),
    ],
)
def test_the_first_part_in_which_two_results_differ_is_found(form, got, expected, path):
    assert differing(form, to_plain(got), to_plain(expected))[1] == path


def test_a_reply_shows_the_smallest_call_that_went_wrong_beside_the_expected_result(capsys):
    check("E4.7", lambda prefix, name: prefix + name)
    assert 'The call frame_name("/", "map") gave "/map". Expected: "map".' in capsys.readouterr().out


def straight(parent_of, target, source):
    return [source, target]


def test_the_call_of_a_reply_can_be_pasted_and_call_returns_its_arguments(capsys):
    check("E4.3", straight)
    (shown,) = re.findall(r"The call path\((.*)\) gave", capsys.readouterr().out)
    assert ast.literal_eval(f"({shown})") == tuple(vars(call("E4.3")).values())
    assert list(vars(call("E4.3"))) == ["parent_of", "target", "source"]
    assert 'source     "' in capsys.readouterr().out


def test_a_call_with_a_buffer_is_cut_and_call_returns_its_arguments(capsys):
    check("E8.3", lambda buffer, message, now: None)
    assert 'call("E8.3") returns its arguments.' in capsys.readouterr().out


def test_a_default_argument_that_remembers_earlier_calls_is_named(capsys):
    def several_owners(log, seen={}):  # noqa: B006  what a learner writes
        for node, _, child in log:
            seen.setdefault(child, set()).add(node)
        return sorted(child for child, nodes in seen.items() if len(nodes) > 1)

    check("E4.6", several_owners)
    assert "The default of `seen` is made once and shared by all calls" in capsys.readouterr().out


def test_call_says_that_a_task_of_values_has_none(capsys):
    assert call("E3.1") is None
    assert "asks for a value" in capsys.readouterr().out
