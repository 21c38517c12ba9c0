"""A function that stops is told the line, the expression, and the values that stood in it."""

from __future__ import annotations

import sys

import pytest

from tflab.core import BufferCore, ExtrapolationException
from tflab.workbook.diagnosis.error_line import error_line, hidden_error


def first_letter(prefix, name):
    return name if prefix[0] == "/" else prefix


def climb(parent_of, frame):
    while True:
        frame = parent_of[frame]


def refuse(frame):
    raise KeyError(frame)


def guarded(frame):
    try:
        return BufferCore().lookup_transform("map", frame, 0)
    except ExtrapolationException:
        return None


@pytest.mark.skipif(sys.version_info < (3, 11), reason="Python 3.10 does not say which expression of a line raised")
@pytest.mark.parametrize(
    ("function", "args", "said"),
    [
        (first_letter, ["", "odom"], '`prefix[0]`. There, `prefix` = `""`.'),
        (
            climb,
            [{"dict": {"odom": "map"}}, "odom"],
            '`parent_of[frame]`. There, `parent_of` = `{"odom": "map"}`, `frame` = `"map"`.',
        ),
    ],
)
def test_an_error_names_the_expression_and_its_values(function, args, said):
    assert error_line(function, args).said.en.endswith(said)


def test_a_raise_of_ones_own_is_told_from_a_failing_lookup():
    assert error_line(refuse, ["odom"]).is_own_raise
    assert not error_line(climb, [{"dict": {}}, "odom"]).is_own_raise


def test_an_except_clause_that_let_the_exception_pass_is_named():
    said = error_line(guarded, ["odom"]).said.en
    assert said.endswith("`except ExtrapolationException` does not catch LookupException.")


def hides(frame):
    try:
        return frame + 1
    except Exception:
        return None


def expects(frame):
    try:
        return float(frame)
    except ValueError:
        return None


def test_a_bug_that_a_broad_except_hides_is_named_and_no_exception_that_is_expected():
    said = hidden_error(hides, ["odom"]).en
    assert "`return frame + 1`, raises TypeError" in said and said.endswith("`except Exception` hides it.")
    assert hidden_error(hides, [1]) is hidden_error(expects, ["odom"]) is hidden_error(refuse, ["odom"]) is None


def test_nothing_is_said_of_a_function_that_returns():
    assert error_line(lambda frame: frame, ["odom"]) is None
