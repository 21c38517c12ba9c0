"""Recognise from tf2's refusals which time was passed to a lookup."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from typing import NamedTuple

from ...text import Text, Texts
from ..answers.form import member
from ..answers.values import Plain, is_raised
from .explanation import Explanation
from .precision import stamp_of, time_of
from .question import Question

__all__ = ["explain_lookup_time"]

TEXTS = Texts(__file__)

REQUESTED = re.compile(r"Requested time (-?\d+\.\d+)")
FEWEST = 3  # refusals, for what fits all of them to be no luck
CLOSE_S = 2e-6  # what is printed has six digits
A_BILLIONTH = 1e-9
OF_A_STAMP: dict[str, Callable[[int, int], float]] = {
    "nanosec_alone": lambda _, nanosec: nanosec * A_BILLIONTH,
    "sec_as_nanoseconds": lambda sec, _: sec * A_BILLIONTH,
    "sec_alone": lambda sec, _: float(sec),
    "nanosec_as_millionths": lambda sec, nanosec: sec + nanosec * 1e-6,
    "nanosec_as_thousandths": lambda sec, nanosec: sec + nanosec * 1e-3,
    "sec_plus_nanosec": lambda sec, nanosec: float(sec + nanosec),
    "nanosec_as_seconds": lambda _, nanosec: float(nanosec),
    "sec_as_microseconds": lambda sec, nanosec: sec * 1e-6 + nanosec * A_BILLIONTH,
    "sec_as_milliseconds": lambda sec, nanosec: sec * 1e-3 + nanosec * A_BILLIONTH,
    "digits_behind_the_point": lambda sec, nanosec: float(f"{sec}.{nanosec}"),
    "milliseconds_as_seconds": lambda sec, nanosec: (sec + nanosec * A_BILLIONTH) * 1e3,
}
OF_TWO_TIMES: dict[str, Callable[[float, float], float]] = {
    "stamp_less_age": lambda stamp, time: 2.0 * stamp - time,
    "time_and_age": lambda stamp, time: 2.0 * time - stamp,
    "age": lambda stamp, time: time - stamp,
}


class _Call(NamedTuple):
    """What was requested in a call, the stamp that came with it, and the times that did, by the argument's number."""

    requested_s: float
    stamp: tuple[int, int]
    times_s: dict[int, float]

    @property
    def stamp_s(self) -> float:
        return self.stamp[0] + self.stamp[1] * A_BILLIONTH


def explain_lookup_time(question: Question) -> Explanation | None:
    """Return for which moment a function asks the buffer, if all of its calls that have an answer end in refusals."""
    asked = [(case.args or [], outcome) for case, outcome in zip(question.cases, question.outcomes, strict=True)
             if not is_raised(case.expected)]  # fmt: skip
    calls = [call for args, outcome in asked if (call := _call(args, outcome)) is not None]
    if len(calls) < max(FEWEST, len(asked)):
        return None
    what, rather = next(_moments(calls), (None, None))
    return Explanation.of("another moment", TEXTS["said"].filled(what=what, rather=rather)) if what else None


def _call(args: Sequence[Plain], outcome: Plain) -> _Call | None:
    found = REQUESTED.search(str(outcome.get("text"))) if isinstance(outcome, dict) and is_raised(outcome) else None
    stamp = next((held for arg in args if (held := stamp_of(member(arg, "header", "stamp"))) is not None), None)
    times = {at: held[0] + held[1] * A_BILLIONTH for at, arg in enumerate(args, start=1) if (held := time_of(arg))}
    return _Call(float(found[1]), stamp, times) if found and stamp else None


def _moments(calls: Sequence[_Call]) -> Iterator[tuple[Text, Text]]:
    """Yield what was requested in all of these calls, and what to look at instead."""
    for name, of in OF_A_STAMP.items():
        if all(_is_near(call.requested_s, of(*call.stamp)) for call in calls):
            yield TEXTS[name], TEXTS["both_fields"]
    numbers = sorted(set.intersection(*(set(call.times_s) for call in calls)))
    times = [(number, [call.times_s[number] for call in calls]) for number in numbers]
    for number, moments in times:
        yield from ((words.filled(of=number), TEXTS["as_it_is"]) for words in _compare_two_times(calls, moments))
    stamps = [call.stamp_s for call in calls]
    yield from ((words, TEXTS["as_it_is"]) for words in _off(calls, stamps, TEXTS["the_stamp"]))
    for number, moments in times:
        yield from ((words, TEXTS["as_it_is"]) for words in _off(calls, moments, TEXTS["the_time"].filled(of=number)))


def _compare_two_times(calls: Sequence[_Call], moments: Sequence[float]) -> Iterator[Text]:
    pairs = list(zip(calls, moments, strict=True))
    for name, of in OF_TWO_TIMES.items():
        if all(_is_near(call.requested_s, of(call.stamp_s, moment)) for call, moment in pairs):
            yield TEXTS[name]


def _off(calls: Sequence[_Call], moments: Sequence[float], what: Text) -> Iterator[Text]:
    """Yield how far from a moment was asked, if it is as far in each call."""
    off = [call.requested_s - moment for call, moment in zip(calls, moments, strict=True)]
    if max(off) - min(off) <= CLOSE_S and abs(off[0]) > CLOSE_S:
        yield TEXTS["earlier" if off[0] < 0 else "later"].filled(by=abs(round(off[0], 5)), what=what)


def _is_near(one: float, other: float) -> bool:
    return abs(one - other) <= max(CLOSE_S, A_BILLIONTH * abs(other))
