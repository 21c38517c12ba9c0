"""For which moment was a buffer asked?  Its refusals name it, and where calls have an answer, that tells the mistake.

    stamp 12.045 s    Requested time 0.045000      nanosec alone
    stamp 12.120 s    Requested time 120012.000000 sec plus nanosec taken for millionths
    now 12.420 s      Requested time 12.320000     0.1 s earlier than `now`, in each call

What is said is read off the refusals of all calls that have an answer, so it is so.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from typing import NamedTuple

from ...text import Text
from ..answers.form import member
from ..answers.values import Plain, is_raised
from ..mistakes.losses import stamp_of, time_of
from ..tasks.case_types import Case
from .explanation import Explanation

__all__ = ["of_requests"]

REQUESTED = re.compile(r"Requested time (-?\d+\.\d+)")
FEWEST = 3  # refusals, for what fits all of them to be no luck
CLOSE_S = 2e-6  # what is printed has six digits
A_BILLIONTH = 1e-9
SAID = Text(
    en="the buffer refuses where it has an answer for the right moment. The time that you request, by its own text, is "
    "{what}. {rather}",
    ko="올바른 순간이라면 답이 있는 곳에서 버퍼가 거절합니다. 거절 메시지에 나온 요청 시각은 {what}입니다. {rather}",
)
BOTH_FIELDS = Text(
    en="A stamp is its sec and a billionth of its nanosec: `Time.from_msg(stamp)` reads both.",
    ko="측정 시각은 sec에 nanosec의 10억분의 1을 더한 것입니다. `Time.from_msg(stamp)`는 두 항목을 모두 읽습니다.",
)
AS_IT_IS = Text(
    en="The stamp itself says when it was measured, and nothing is added to it or taken off.",
    ko="언제 측정했는지는 측정 시각에 그대로 적혀 있습니다. 아무것도 더하거나 빼지 않습니다.",
)
OF_A_STAMP: tuple[tuple[Callable[[int, int], float], Text], ...] = (
    (
        lambda _, nanosec: nanosec * A_BILLIONTH,
        Text(
            "the stamp's nanosec, with its sec left out or counted in nanoseconds, too",
            "sec을 빠뜨리거나 나노초로 여기고 nanosec을 쓴 값",
        ),
    ),
    (
        lambda sec, _: sec * A_BILLIONTH,
        Text("the stamp's sec, taken for nanoseconds, without its nanosec", "nanosec 없이 sec을 나노초로 여기고 쓴 값"),
    ),
    (lambda sec, _: float(sec), Text("the stamp's sec alone, without its nanosec", "nanosec 없이 sec만 쓴 값")),
    (
        lambda sec, nanosec: sec + nanosec * 1e-6,
        Text("its sec, and nanosec taken for millionths of a second", "nanosec을 100만분의 1초로 여겨 sec에 더한 값"),
    ),
    (
        lambda sec, nanosec: sec + nanosec * 1e-3,
        Text("its sec, and nanosec taken for thousandths of a second", "nanosec을 1000분의 1초로 여겨 sec에 더한 값"),
    ),
    (
        lambda sec, nanosec: float(sec + nanosec),
        Text("its sec plus nanosec, taken for seconds, too", "nanosec까지 초로 여겨 sec에 더한 값"),
    ),
    (
        lambda _, nanosec: float(nanosec),
        Text(
            "nanosec, taken for seconds (was sec taken for nanoseconds?)",
            "nanosec을 초로 여긴 값(sec은 나노초로 여기지 않았습니까?)",
        ),
    ),
    (
        lambda sec, nanosec: sec * 1e-6 + nanosec * A_BILLIONTH,
        Text("its nanosec, and sec taken for microseconds", "sec을 마이크로초로 여겨 nanosec에 더한 값"),
    ),
    (
        lambda sec, nanosec: sec * 1e-3 + nanosec * A_BILLIONTH,
        Text("its nanosec, and sec taken for milliseconds", "sec을 밀리초로 여겨 nanosec에 더한 값"),
    ),
    (
        lambda sec, nanosec: float(f"{sec}.{nanosec}"),
        Text(
            "its sec, with the digits of nanosec right behind the point", "nanosec의 숫자를 sec의 소수점 뒤에 붙인 값"
        ),
    ),
    (
        lambda sec, nanosec: (sec + nanosec * A_BILLIONTH) * 1e3,
        Text("the stamp in milliseconds, taken for seconds", "밀리초로 나타낸 측정 시각을 초로 여긴 값"),
    ),
)
OF_TWO_TIMES: tuple[tuple[Callable[[float, float], float], Text], ...] = (
    (
        lambda stamp, time: 2.0 * stamp - time,
        Text(
            "the stamp less what has passed since, up to argument {of}",
            "측정 시각에서 {of}번째 인자까지 지난 시간을 뺀 값",
        ),
    ),
    (
        lambda stamp, time: 2.0 * time - stamp,
        Text(
            "argument {of} and, once more, what had passed up to it since the stamp",
            "{of}번째 인자에 측정 시각부터 지난 시간을 더한 값",
        ),
    ),
    (
        lambda stamp, time: time - stamp,
        Text(
            "how much time passed from the stamp to argument {of}, and no moment",
            "측정 시각부터 {of}번째 인자까지 지난 시간, 곧 시각이 아닌 값",
        ),
    ),
)
OFF = {
    True: Text("{by:g} s earlier than {what}, in each call", "호출마다 {what}보다 {by:g}초 이른 값"),
    False: Text("{by:g} s later than {what}, in each call", "호출마다 {what}보다 {by:g}초 늦은 값"),
}
THE_STAMP, THE_TIME = Text("the stamp", "측정 시각"), Text("argument {of}", "{of}번째 인자")


class _Call(NamedTuple):
    """What was requested in a call, the stamp that came with it, and the times that did, by the argument's number."""

    requested_s: float
    stamp: tuple[int, int]
    times_s: dict[int, float]

    @property
    def stamp_s(self) -> float:
        return self.stamp[0] + self.stamp[1] * A_BILLIONTH


def of_requests(cases: Sequence[Case], outcomes: Sequence[Plain]) -> Explanation | None:
    """Return for which moment a function asks the buffer, if all of its calls that have an answer end in refusals."""
    asked = [(case.args or [], outcome) for case, outcome in zip(cases, outcomes, strict=True)
             if not is_raised(case.expected)]  # fmt: skip
    calls = [call for args, outcome in asked if (call := _call(args, outcome)) is not None]
    if len(calls) < max(FEWEST, len(asked)):
        return None
    what, rather = next(_moments(calls), (None, None))
    return Explanation.of("another moment", SAID.filled(what=what, rather=rather)) if what else None


def _call(args: Sequence[Plain], outcome: Plain) -> _Call | None:
    found = REQUESTED.search(str(outcome.get("text"))) if isinstance(outcome, dict) and is_raised(outcome) else None
    stamp = next((held for arg in args if (held := stamp_of(member(arg, "header", "stamp"))) is not None), None)
    times = {at: held[0] + held[1] * A_BILLIONTH for at, arg in enumerate(args, start=1) if (held := time_of(arg))}
    return _Call(float(found[1]), stamp, times) if found and stamp else None


def _moments(calls: Sequence[_Call]) -> Iterator[tuple[Text, Text]]:
    """Yield what was requested in all of these calls, and what to look at instead."""
    for of, words in OF_A_STAMP:
        if all(_is_near(call.requested_s, of(*call.stamp)) for call in calls):
            yield words, BOTH_FIELDS
    numbers = sorted(set.intersection(*(set(call.times_s) for call in calls)))
    times = [(number, [call.times_s[number] for call in calls]) for number in numbers]
    for number, moments in times:
        yield from ((words.filled(of=number), AS_IT_IS) for words in _of_two_times(calls, moments))
    stamps = [call.stamp_s for call in calls]
    yield from ((words, AS_IT_IS) for words in _off(calls, stamps, THE_STAMP))
    for number, moments in times:
        yield from ((words, AS_IT_IS) for words in _off(calls, moments, THE_TIME.filled(of=number)))


def _of_two_times(calls: Sequence[_Call], moments: Sequence[float]) -> Iterator[Text]:
    pairs = list(zip(calls, moments, strict=True))
    for of, words in OF_TWO_TIMES:
        if all(_is_near(call.requested_s, of(call.stamp_s, moment)) for call, moment in pairs):
            yield words


def _off(calls: Sequence[_Call], moments: Sequence[float], what: Text) -> Iterator[Text]:
    """Yield how far from a moment was asked, if it is as far in each call."""
    off = [call.requested_s - moment for call, moment in zip(calls, moments, strict=True)]
    if max(off) - min(off) <= CLOSE_S and abs(off[0]) > CLOSE_S:
        yield OFF[off[0] < 0].filled(by=abs(round(off[0], 5)), what=what)


def _is_near(one: float, other: float) -> bool:
    return abs(one - other) <= max(CLOSE_S, A_BILLIONTH * abs(other))
