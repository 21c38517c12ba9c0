"""E6.6: How far does a bolt fall behind?"""

from __future__ import annotations

from itertools import combinations, pairwise
from types import SimpleNamespace

from tflab.workbook.tasks import Number, Task, Text, WrongStep


def bolt(rng):
    """A bolt that is sent on /tf; drawn again where two mistakes would come to the same length."""
    while True:
        drawn = {
            "rate_hz": float(rng.choice([2.0, 3.0, 4.0, 5.0, 8.0, 10.0])),
            "delay_ms": float(rng.choice([30.0, 50.0, 70.0, 110.0, 130.0, 160.0])),
            "speed_mps": float(rng.choice([0.4, 0.6, 0.8, 1.2, 1.5])),
        }
        given = SimpleNamespace(**drawn)
        lengths = sorted(worst(given, **at) for at in ({}, *(slip.at for slip in SLIPS)))
        apart = min(after - before for before, after in pairwise(lengths))
        if apart > 0.008 and not _another_unit(given) and not _meets_another(given):
            return drawn


def _meets_another(given):
    """Return whether two of all the slips, or one and a time that was given, come to nearly the same number."""
    lengths = [worst(given, **at) for at in ({}, *(slip.at for slip in TASK.mistakes))]
    lengths = sorted([*lengths, given.delay_ms / 1000.0, 1.0 / given.rate_hz])
    return min(after - before for before, after in pairwise(lengths)) < 0.004


def _another_unit(given):
    """Return whether two slips together come to the right number, as if it were in cm or mm."""
    pairs = ((one.at, other.at) for one, other in combinations(SLIPS, 2) if not one.at.keys() & other.at.keys())
    wrong = [worst(given, **one, **other) for one, other in pairs]
    return any(abs(length / unit - worst(given)) < 0.005 for length in wrong for unit in (100.0, 1000.0))


def worst(g, *, period="whole", delay="as seconds", together="added", speed="times"):
    """Return how far off the latest is at worst [m], step by step; other steps are the slips."""
    between = {
        "whole": 1.0 / g.rate_hz,
        "half": 0.5 / g.rate_hz,
        "twice": 2.0 / g.rate_hz,
        "none": 0.0,
        "rate": g.rate_hz,
    }[period]
    on_its_way = {
        "as seconds": g.delay_ms / 1000.0,
        "none": 0.0,
        "ms": g.delay_ms,
        "twice": g.delay_ms / 500.0,
        "half": g.delay_ms / 2000.0,
        "hundredths": g.delay_ms / 100.0,
    }[delay]
    age = {"added": between + on_its_way, "subtracted": between - on_its_way, "multiplied": between * on_its_way}
    return {
        "times": g.speed_mps * age[together],
        "period alone": g.speed_mps * between + on_its_way,
        "delay alone": g.speed_mps * on_its_way + between,
        "divided": age[together] / g.speed_mps,
        "none": age[together],
        "zero": 0.0,
    }[speed]


HALF_A_PERIOD = WrongStep(
    "half a period",
    {"period": "half"},
    Text(
        en="Half a period is how old it is on average. At worst the next message is just about to come.",
        ko="반 주기는 평균일 때의 나이입니다. 최악은 다음 메시지가 오기 바로 전입니다.",
    ),
)

DELAY_ONLY = WrongStep(
    "delay only",
    {"period": "none"},
    Text(
        en="You count the way of one message. Between two messages nothing comes, and the newest grows older.",
        ko="메시지 하나가 오는 시간만 셌습니다. 메시지와 메시지 사이에는 아무것도 오지 않고 가장 새로운 값이 낡아 갑니다.",
    ),
    "M9",
)

RATE_FOR_PERIOD = WrongStep(
    "rate for period",
    {"period": "rate"},
    Text(
        en="You used the rate [Hz] as a time. The time between two messages is one over the rate.",
        ko="발행률[Hz]을 시간으로 썼습니다. 메시지 사이의 시간은 1을 발행률로 나눈 값입니다.",
    ),
)

PERIOD_ONLY = WrongStep(
    "period only",
    {"delay": "none"},
    Text(
        en="You count the time between two messages. When one arrives at last, it is already as old as its way was long.",
        ko="메시지 사이의 시간만 셌습니다. 메시지는 도착했을 때 이미 오는 데 걸린 시간만큼 낡아 있습니다.",
    ),
    "M9",
)

MILLISECONDS = WrongStep(
    "milliseconds",
    {"delay": "ms"},
    Text(
        en="The delay went in as milliseconds, as if they were seconds.",
        ko="지연을 밀리초 그대로, 초인 것처럼 넣었습니다.",
    ),
)

DELAY_TWICE = WrongStep(
    "delay twice",
    {"delay": "twice"},
    Text(
        en="You count the delay twice. The last message has been on its way once.",
        ko="지연을 두 번 셌습니다. 마지막 메시지가 오는 길은 한 번입니다.",
    ),
)

SUBTRACTED = WrongStep(
    "subtracted",
    {"together": "subtracted"},
    Text(
        en="You took the delay off. It makes things worse: what arrives is old already.",
        ko="지연을 뺐습니다. 지연이 있으면 더 나빠집니다. 도착한 값은 이미 낡았습니다.",
    ),
)

SECONDS = WrongStep(
    "seconds",
    {"speed": "none"},
    Text(
        en="That is how old the answer is, in seconds. How far does the robot drive meanwhile?",
        ko="답이 몇 초 전의 것인지까지 구했습니다. 그동안 로봇은 얼마나 갑니까?",
    ),
)

DIVIDED = WrongStep(
    "divided",
    {"speed": "divided"},
    Text(
        en="You divided by the speed. A faster robot is farther off, not less.",
        ko="속도로 나누었습니다. 빠른 로봇일수록 더 많이 빗나갑니다.",
    ),
)

BOLTED = WrongStep(
    "bolted, so zero",
    {"speed": "zero"},
    Text(
        en='It is bolted to the robot, yes, and the robot drives. "The latest" is the newest moment that every edge knows, and this edge knows it late.',
        ko='로봇에 고정되어 있지만 로봇이 달립니다. "최신"은 모든 연결이 아는 가장 늦은 시각이고, 이 연결은 늦게 압니다.',
    ),
    "M12",
)


SLIPS = (
    HALF_A_PERIOD,
    DELAY_ONLY,
    RATE_FOR_PERIOD,
    PERIOD_ONLY,
    MILLISECONDS,
    DELAY_TWICE,
    SUBTRACTED,
    SECONDS,
    DIVIDED,
    BOLTED,
)


TWO_PERIODS = WrongStep(
    "two periods",
    {"period": "twice"},
    Text(
        en="You count two periods. At worst one is about to end: then the next message comes.",
        ko="주기를 두 번 셌습니다. 최악은 한 주기가 끝나기 직전입니다. 그다음 메시지가 오기 때문입니다.",
    ),
)


SPEED_TIMES_THE_PERIOD_ALONE = WrongStep(
    "speed times the period alone",
    {"speed": "period alone"},
    Text(
        en="You multiplied the period by the speed and added the delay as it is: metres and seconds. The robot drives during both.",
        ko="주기에만 속도를 곱하고 지연은 그대로 더했습니다. 미터와 초를 더한 셈입니다. 로봇은 그 두 시간 동안 모두 달립니다.",
    ),
)


SPEED_TIMES_THE_DELAY_ALONE = WrongStep(
    "speed times the delay alone",
    {"speed": "delay alone"},
    Text(
        en="You multiplied the delay by the speed and added the period as it is: metres and seconds. The robot drives during both.",
        ko="지연에만 속도를 곱하고 주기는 그대로 더했습니다. 미터와 초를 더한 셈입니다. 로봇은 그 두 시간 동안 모두 달립니다.",
    ),
)


HALF_THE_DELAY = WrongStep(
    "half the delay",
    {"delay": "half"},
    Text(
        en="You count half of the delay. The message was on its way for all of it.",
        ko="지연을 절반만 셌습니다. 메시지는 지연만큼 내내 오는 중이었습니다.",
    ),
)

HUNDREDTHS = WrongStep(
    "hundredths",
    {"delay": "hundredths"},
    Text(
        en="Your delay is ten times too long: a millisecond is a thousandth of a second, not a hundredth.",
        ko="지연이 열 배입니다. 1밀리초는 100분의 1초가 아니라 1000분의 1초입니다.",
    ),
)

MULTIPLIED = WrongStep(
    "multiplied",
    {"together": "multiplied"},
    Text(
        en="Period and delay are multiplied here (the delay divided by the rate is the same). The one comes after the other: two times add up.",
        ko="주기와 지연을 곱한 값이 들어 있습니다. 지연을 발행률로 나누어도 같습니다. 하나가 끝난 뒤 다른 하나가 이어지므로 두 시간을 더합니다.",
    ),
)


TASK = Task(
    id="E6.6",
    kind="N",
    points=2,
    title=Text(en="How far does a bolt fall behind?", ko="볼트는 얼마나 뒤처질까요?"),
    answer="worst_error_m",
    form=Number(unit="m", tolerance=0.002),
    given=bolt,
    variants=6,
    model=worst,
    mistakes=(
        *SLIPS,
        TWO_PERIODS,
        SPEED_TIMES_THE_PERIOD_ALONE,
        SPEED_TIMES_THE_DELAY_ALONE,
        HALF_THE_DELAY,
        HUNDREDTHS,
        MULTIPLIED,
    ),
    hints=(
        Text(
            en="How old is the newest message of the bolt, just before the next one arrives?",
            ko="다음 메시지가 도착하기 바로 전에, 볼트의 가장 새로운 메시지는 몇 초 전의 것입니까?",
        ),
        Text(
            en="It was stamped one period before the next, and that one has been on its way for the delay.",
            ko="다음 메시지보다 한 주기 일찍 만들어졌고, 그 다음 메시지도 지연만큼 오는 중입니다.",
        ),
        Text(
            en="Age = 1 / rate + delay, in seconds; the robot drives speed × age meanwhile.",
            ko="나이 = 1 / 발행률 + 지연, 단위는 초입니다. 그동안 로봇은 속도 × 나이만큼 갑니다.",
        ),
    ),
    misconceptions=("M9", "M12"),
)
