"""`check` stops a call that does not end or needs too much memory, and survives exits, prompts and prints."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable

import pytest

from tflab.workbook import call_limits, check
from tflab.workbook.answers.values import outcome_of


def waits(*_: object) -> None:
    time.sleep(3600)


def catches_everything(*_: object) -> None:
    while True:
        try:
            time.sleep(1)
        except:  # noqa: E722  what a learner writes
            continue


def recurses(*args: object) -> None:
    return recurses(*args)


@pytest.fixture(autouse=True)
def _short_calls(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("tflab.workbook.judge_answer.CALL_S", 0.3)


@pytest.mark.parametrize(
    ("answer", "reply"),
    [
        (waits, "this call had not ended after 0.3 seconds, so it was stopped: path("),
        (catches_everything, "this call had not ended after 0.3 seconds, so it was stopped: path("),
        (lambda *_: [0] * 10**9, "this call needed more than 1 GB of memory, so it was stopped: path("),
        (recurses, "your function stopped with RecursionError"),
        (lambda *_: sys.exit(1), "your function stopped with SystemExit: 1"),
        (lambda *_: input("which?"), "your function stopped with EOFError"),
    ],
)
def test_a_call_that_does_not_return_gets_a_reply(
    answer: Callable[..., None], reply: str, capsys: pytest.CaptureFixture[str]
):
    check("E4.3", answer)
    first = capsys.readouterr().out
    assert reply in first
    check("E4.3", answer)
    assert capsys.readouterr().out == first


def test_what_a_function_prints_is_counted_and_not_shown(capsys: pytest.CaptureFixture[str]):
    check("E4.3", lambda *_: print("found it"))
    reply = capsys.readouterr().out
    assert "found it" not in reply
    assert "your function returned nothing (None)" in reply
    assert "also printed 30 lines" in reply


def test_no_alarm_comes_after_a_call_was_stopped():
    with pytest.raises(call_limits.TimeLimitError), call_limits.call_limits(0.1):
        outcome_of(waits, [])
    time.sleep(0.3)
