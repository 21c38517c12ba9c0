"""E8.6: How long must it remember?"""

from __future__ import annotations

import math
from itertools import pairwise

from tflab.workbook.tasks import Number, Task, Text, WrongAnswer, WrongStep

AMOUNTS_S = (0.05, 0.1, 0.2, 0.3, 0.5, 2.0)  # that one adds to be safe, beside 1.0
SHARES = (1.1, 1.2, 1.25, 1.3, 1.5)


def detector(rng):
    """Draw until no two of the times that one may come to are near one another."""
    while True:
        slow, fast = float(rng.choice([0.35, 0.7, 1.4, 3.5])), float(rng.choice([22.0, 24.0, 45.0]))  # no round periods
        thinking_s, period_s, short_s = round(float(rng.uniform(1.5, 6.0)), 2), 1.0 / slow, 1.0 / fast
        sums = [by * thinking_s + times * period_s for by in (0, 1, 2) for times in (-1, 0, 0.5, 1, 2, 3)]
        means = [(period_s + short_s) / 2, period_s + short_s, 1.0 / (slow + fast), 2.0 / (slow + fast), 1.0]
        sums += [
            thinking_s + more for more in (*means, -short_s, short_s, 2 * short_s, 3 * short_s, period_s - short_s)
        ]
        times_s = [*sums, thinking_s * period_s, thinking_s * slow, thinking_s + slow, 10.0, 20.0, 30.0]
        times_s += [by * thinking_s for by in SHARES] + [thinking_s + by for by in AMOUNTS_S]
        times_s += [10.0 + period_s, *map(float, _in_whole(thinking_s, slow, fast)), (thinking_s + 1.0) * period_s]
        times_s = sorted([*times_s, *_in_whole_periods(thinking_s, slow)])
        is_no_rounding = abs(math.ceil(thinking_s) - thinking_s - period_s) > 0.1
        if is_no_rounding and min(b - a for a, b in pairwise(times_s)) > 0.005:
            return {"thinking_s": thinking_s, "rate_hz": {"map -> odom": slow, "odom -> base_link": fast}}


def _in_whole(thinking_s, slow, fast):
    """Return the whole numbers that one may come to: of seconds, and of samples."""
    counts = [math.ceil(thinking_s * rate) for rate in (slow, fast)]
    return (math.ceil(thinking_s), math.ceil(thinking_s + 1.0 / slow), *counts, *(count + 1 for count in counts))


def _in_whole_periods(thinking_s, slow):
    count = math.ceil(thinking_s * slow)
    return (count / slow, (count + 1) / slow, math.ceil(thinking_s) + 1.0 / slow)


def memory(g, *, thinking=1.0, lane="slow", times=1.0, joined="added"):
    """Return how long it must remember, step by step; other steps are the slips."""
    periods = [1.0 / rate for rate in g.rate_hz.values()]
    more = {"slow": max(periods), "fast": min(periods), "both": sum(periods), "rate": min(g.rate_hz.values())}
    more = (more | {"fast rate": max(g.rate_hz.values())})[lane]
    return thinking * g.thinking_s * times * more if joined == "multiplied" else thinking * g.thinking_s + times * more


THINKING_ONLY = WrongStep(
    "thinking only",
    {"times": 0.0},
    Text(
        en="That is the thinking time alone (or the larger of it and a period). Then the sample just before the stamp may be gone already, and without it there is nothing to interpolate from.",
        ko="계산 시간뿐입니다(또는 계산 시간과 주기 가운데 큰 쪽입니다). 그러면 측정 시각 바로 이전의 표본이 이미 사라졌을 수 있고, 그것이 없으면 보간할 수 없습니다.",
    ),
)


THE_FAST_LANE = WrongStep(
    "the fast lane",
    {"lane": "fast"},
    Text(
        en="You counted with the fast edge. Every edge of the path must still hold the sample before the stamp, the slow one too.",
        ko="빠른 연결로 계산했습니다. 경로의 모든 연결이 측정 시각 이전의 표본을 갖고 있어야 하고, 느린 연결도 마찬가지입니다.",
    ),
)


BOTH_PERIODS = WrongStep(
    "both periods",
    {"lane": "both"},
    Text(
        en="You added the periods of both edges. Each lane needs only its own, so the longest one is enough.",
        ko="두 연결의 주기를 더했습니다. 시간줄마다 자기 주기만 필요하므로 가장 긴 것이면 충분합니다.",
    ),
)


ONE_PERIOD_LESS = WrongStep(
    "one period less",
    {"times": -1.0},
    Text(
        en="A period less than the thinking time: then even the moment of the picture is forgotten.",
        ko="계산 시간보다 한 주기 짧습니다. 그러면 영상을 찍은 순간조차 잊습니다.",
    ),
)


RATE_INSTEAD_OF_PERIOD = WrongStep(
    "rate instead of period",
    {"lane": "rate"},
    Text(
        en="That is a time with a rate added to it. A period is one over the rate.",
        ko="시간에 Hz를 더한 값입니다. 주기는 Hz의 역수입니다.",
    ),
)


WHAT_ONE_GETS = WrongAnswer(
    "what one gets",
    10.0,
    Text(
        en="Ten seconds is what you get if you say nothing. It is enough here, but not the least that is enough.",
        ko="10초는 따로 정하지 않을 때의 값입니다. 여기서는 충분하지만, 충분한 값 가운데 가장 작은 것은 아닙니다.",
    ),
)


TWENTY = WrongAnswer(
    "longer is safer",
    20.0,
    Text(
        en="Twenty seconds are more than is needed. Longer is not safer: it only costs memory. The least that is always enough is asked for.",
        ko="20초는 필요보다 깁니다. 길다고 더 안전하지 않고 메모리만 듭니다. 언제나 충분한 값 가운데 가장 작은 것이 필요합니다.",
    ),
)

HOUR = WrongAnswer(
    "an hour",
    3600.0,
    Text(
        en="An hour is always enough, and hides what is needed. The least that is always enough is asked for: work it out.",
        ko="한 시간이면 언제나 충분하지만 얼마가 필요한지 알 수 없게 됩니다. 언제나 충분한 값 가운데 가장 작은 것을 계산하십시오.",
    ),
)

TWICE_THINKING = WrongStep(
    "thinking twice",
    {"thinking": 2.0},
    Text(
        en="The thinking time is counted twice.",
        ko="계산 시간을 두 번 셌습니다.",
    ),
)

PERIOD_ALONE = WrongStep(
    "period alone",
    {"thinking": 0.0},
    Text(
        en="That is a period alone (or the larger of it and the thinking time). The thinking time is missing: so far back lies the picture's stamp already when the question comes.",
        ko="주기뿐입니다(또는 주기와 계산 시간 가운데 큰 쪽입니다). 계산 시간이 빠졌습니다. 물어볼 때 영상의 측정 시각은 이미 그만큼 과거에 있습니다.",
    ),
)

TWICE_THINKING_ALONE = WrongStep(
    "twice the thinking time",
    {"thinking": 2.0, "times": 0.0},
    Text(
        en="That is twice the thinking time. To double is no rule: how much more than the thinking time is needed, the slowest edge says.",
        ko="계산 시간의 두 배입니다. 두 배라는 규칙은 없습니다. 계산 시간보다 얼마나 더 필요한지는 가장 느린 연결이 정합니다.",
    ),
)

HALF_A_PERIOD = WrongStep(
    "half a period",
    {"times": 0.5},
    Text(
        en="Half a period is enough for half of the pictures. Asked for is what is enough for every one.",
        ko="반 주기로는 영상의 절반만 됩니다. 모든 영상에 충분한 값이 필요합니다.",
    ),
)

TWO_PERIODS = WrongStep(
    "two periods",
    {"times": 2.0},
    Text(
        en="Two periods are more than is needed: one sample before the stamp is enough, and it is at most one period older.",
        ko="두 주기는 필요보다 깁니다. 측정 시각 이전의 표본 하나면 되고, 그것은 길어야 한 주기 더 오래되었습니다.",
    ),
)

THREE_PERIODS = WrongStep(
    "three periods",
    {"times": 3.0},
    Text(
        en="Three periods are more than is needed: one sample before the stamp is enough, and it is at most one period older.",
        ko="세 주기는 필요보다 깁니다. 측정 시각 이전의 표본 하나면 되고, 그것은 길어야 한 주기 더 오래되었습니다.",
    ),
)

MULTIPLIED = WrongStep(
    "multiplied",
    {"joined": "multiplied"},
    Text(
        en="That is the thinking time multiplied by a period (or divided by a rate, which is the same). One time comes after the other: they add up.",
        ko="계산 시간에 주기를 곱한 값입니다. Hz로 나누어도 같습니다. 두 시간은 하나 다음에 다른 하나가 오므로 더합니다.",
    ),
)

ZERO = WrongAnswer(
    "zero",
    0.0,
    Text(
        en="With a memory of no time at all, every sample is forgotten as it comes.",
        ko="기억하는 시간이 0이면 표본이 오자마자 잊힙니다.",
    ),
)

THIRTY = WrongAnswer(
    "half a minute",
    30.0,
    Text(
        en="Half a minute is more than is needed, and hides what is. Work out the least that is always enough.",
        ko="30초는 필요보다 길고, 얼마가 필요한지 알 수 없게 합니다. 언제나 충분한 값 가운데 가장 작은 것을 계산하십시오.",
    ),
)


TEN_MORE = WrongAnswer(
    "ten more",
    lambda g: 10.0 + g.thinking_s,
    Text(
        en="That is the thinking time and the ten seconds that one gets unasked. The ten are only what is set where nobody says anything: work out the least that is always enough.",
        ko="계산 시간에 기본값 10초를 더한 값입니다. 10초는 따로 정하지 않을 때의 값일 뿐입니다. 언제나 충분한 가장 짧은 시간을 구하십시오.",
    ),
)


NUMBER_OF_SAMPLES = WrongAnswer(
    "number of samples",
    lambda g: g.thinking_s * max(g.rate_hz.values()),
    Text(
        en="That is how many samples come meanwhile. Asked for is a time.",
        ko="그동안 오는 표본의 개수입니다. 시간이 필요합니다.",
    ),
)


NUMBER_OF_SLOW_SAMPLES = WrongAnswer(
    "number of slow samples",
    lambda g: g.thinking_s * min(g.rate_hz.values()),
    Text(
        en="That is the thinking time by the slow rate: how many samples of the slowest edge come meanwhile. `cache_time` is a time and no count.",
        ko="계산 시간에 느린 쪽의 Hz를 곱했습니다. 그동안 가장 느린 연결에 오는 표본의 개수입니다. `cache_time`은 개수가 아니라 시간입니다.",
    ),
)


MEAN_PERIOD = WrongAnswer(
    "mean period",
    lambda g: g.thinking_s + sum(1.0 / rate for rate in g.rate_hz.values()) / 2,
    Text(
        en="That is the thinking time and the mean of the two periods. Every edge of the path must still hold the sample before the stamp, the slow one, too.",
        ko="계산 시간에 두 주기의 평균을 더한 값입니다. 경로의 모든 연결이, 느린 연결도, 측정 시각 이전의 표본을 갖고 있어야 합니다.",
    ),
)


MEAN_RATE = WrongAnswer(
    "mean rate",
    lambda g: g.thinking_s + 2.0 / sum(g.rate_hz.values()),
    Text(
        en="That is the thinking time and the period of the mean of the two rates. Each edge has a period of its own, and the slow one decides.",
        ko="계산 시간에 두 Hz의 평균으로 구한 주기를 더한 값입니다. 연결마다 자기 주기가 있고 느린 쪽이 정합니다.",
    ),
)


SUM_OF_RATES = WrongAnswer(
    "sum of rates",
    lambda g: g.thinking_s + 1.0 / sum(g.rate_hz.values()),
    Text(
        en="That is the thinking time and one over the sum of both rates. Each edge has a period of its own, and the slow one decides.",
        ko="계산 시간에 두 Hz의 합의 역수를 더한 값입니다. 연결마다 자기 주기가 있고 느린 쪽이 정합니다.",
    ),
)


SHARES_MORE = tuple(
    WrongAnswer(
        f"{share} times the thinking time",
        lambda g, share=share: share * g.thinking_s,
        Text(
            en=f"That is {share} times the thinking time. How much more than the thinking time is needed, the slowest edge says, and no share of it.",
            ko=f"계산 시간의 {share}배입니다. 계산 시간보다 얼마나 더 필요한지는 비율이 아니라 가장 느린 연결이 정합니다.",
        ),
    )
    for share in SHARES
)


AMOUNTS_MORE = tuple(
    WrongAnswer(
        f"{amount_s} s more",
        lambda g, amount_s=amount_s: g.thinking_s + amount_s,
        Text(
            en=f"That is the thinking time and {amount_s:g} s. How much more than the thinking time is needed, the slowest edge says, and no margin.",
            ko=f"계산 시간에 {amount_s:g}초를 더한 값입니다. 계산 시간보다 얼마나 더 필요한지는 여유가 아니라 가장 느린 연결이 정합니다.",
        ),
    )
    for amount_s in (*AMOUNTS_S, 1.0)
)


TEN_AND_A_PERIOD = WrongAnswer(
    "ten and a period",
    lambda g: 10.0 + 1.0 / min(g.rate_hz.values()),
    Text(
        en="That is ten seconds and a period. The ten are what one gets unasked: how far back the picture's stamp lies when the question comes, the thinking time says.",
        ko="10초에 한 주기를 더한 값입니다. 10초는 따로 정하지 않을 때의 값입니다. 물어볼 때 영상의 측정 시각이 얼마나 과거인지는 계산 시간이 정합니다.",
    ),
)


MINUTE = WrongAnswer(
    "a minute",
    60.0,
    Text(
        en="A minute is more than is needed, and hides what is. Work out the least that is always enough.",
        ko="1분은 필요보다 길고, 얼마가 필요한지 알 수 없게 합니다. 언제나 충분한 값 가운데 가장 작은 것을 계산하십시오.",
    ),
)


ROUNDED_UP = WrongAnswer(
    "rounded up",
    lambda g: float(math.ceil(g.thinking_s + 1.0 / min(g.rate_hz.values()))),
    Text(
        en="That is what is needed, rounded up to whole seconds: it is always enough, and longer than it need be.",
        ko="필요한 값을 초 단위로 올린 것입니다. 언제나 충분하지만 필요한 것보다 깁니다.",
    ),
)


HALF_AS_MUCH_AGAIN = WrongAnswer(
    "half as much again",
    lambda g: 1.5 * (g.thinking_s + 1.0 / min(g.rate_hz.values())),
    Text(
        en="Half as much again, to be safe: it is always enough, and longer than it need be.",
        ko="안전하게 절반을 더 얹었습니다. 언제나 충분하지만 필요한 것보다 깁니다.",
    ),
)


FAST_RATE_INSTEAD_OF_PERIOD = WrongStep(
    "fast rate instead of period",
    {"lane": "fast rate"},
    Text(
        en="That is a time with the faster edge's rate added to it. A period is one over the rate, and the slow edge decides.",
        ko="시간에 더 빠른 연결의 주파수를 더했습니다. 주기는 주파수의 역수이고, 정하는 것은 느린 연결입니다.",
    ),
)


COUNTS = tuple(
    WrongAnswer(
        f"count of {which.__name__} samples, and {more}",
        lambda g, which=which, more=more: float(math.ceil(g.thinking_s * which(g.rate_hz.values())) + more),
        Text(
            en=f"This whole number is how many samples the {en} edge sends while it thinks, rounded up{', and one more' if more else ''}. A count of samples is no time, nor would a guess be a rule: `cache_time` is in seconds.",
            ko=f"이 정수는 계산하는 동안 {ko} 연결이 보내는 표본의 개수를 올림한 것{'에 하나를 더한 값' if more else ''}입니다. 표본의 개수는 시간이 아니고, 어림한 값도 규칙이 아닙니다. `cache_time`의 단위는 초입니다.",
        ),
    )
    for which, en, ko in ((min, "slow", "느린"), (max, "fast", "빠른"))
    for more in (0, 1)
)


THINKING_ROUNDED_UP = WrongAnswer(
    "thinking rounded up",
    lambda g: float(math.ceil(g.thinking_s)),
    Text(
        en="That is the thinking time, rounded up to whole seconds. How much more than the thinking time is needed, the slowest edge says: one period of it, whatever the next whole second is.",
        ko="계산 시간을 초 단위로 올린 값입니다. 계산 시간보다 얼마나 더 필요한지는 가장 느린 연결의 한 주기가 정합니다. 초의 자리올림과는 상관없습니다.",
    ),
)


THINKING_ROUNDED_UP_AND_A_PERIOD = WrongAnswer(
    "thinking rounded up, and a period",
    lambda g: math.ceil(g.thinking_s) + 1.0 / min(g.rate_hz.values()),
    Text(
        en="You rounded the thinking time up to whole seconds before you added the period. Nothing has to be whole here: it is longer than it need be.",
        ko="주기를 더하기 전에 계산 시간을 초 단위로 올렸습니다. 정수일 필요가 없습니다. 필요한 것보다 깁니다.",
    ),
)


WHOLE_PERIODS = tuple(
    WrongAnswer(
        f"whole periods, and {more}",
        lambda g, more=more: (math.ceil(g.thinking_s * min(g.rate_hz.values())) + more) / min(g.rate_hz.values()),
        Text(
            en=f"That is a whole number of the slow edge's periods: as many as the thinking time takes, rounded up{', and one more' if more else ''}. The thinking time need not be a whole number of them: it counts as it is, and a period is added.",
            ko=f"느린 연결의 주기를 정수 번 센 값입니다. 계산 시간이 차지하는 주기의 수를 올림했습니다{'(그리고 하나를 더했습니다)' if more else ''}. 계산 시간은 주기의 정수배가 아니어도 됩니다. 그대로 두고 한 주기를 더합니다.",
        ),
    )
    for more in (0, 1)
)


BRACKETS = WrongAnswer(
    "brackets",
    lambda g: (g.thinking_s + 1.0) / min(g.rate_hz.values()),
    Text(
        en="You divided the thinking time by the rate, too: only the 1 is divided by it. One over the rate is a period, and that is added to a time in seconds.",
        ko="계산 시간까지 Hz로 나누었습니다. Hz로 나눌 것은 1뿐입니다. 1을 Hz로 나눈 것이 주기이고, 그것을 초 단위의 시간에 더합니다.",
    ),
)


DIFFERENCE_OF_PERIODS = WrongAnswer(
    "difference of periods",
    lambda g: g.thinking_s + 1.0 / min(g.rate_hz.values()) - 1.0 / max(g.rate_hz.values()),
    Text(
        en="From the slow edge's period you took off the fast one's. Each lane needs a period of its own, and the fast one does not shorten the slow one's.",
        ko="느린 연결의 주기에서 빠른 연결의 주기를 뺐습니다. 시간줄마다 자기 주기만큼 필요하고, 빠른 연결이 있다고 느린 연결의 주기가 짧아지지 않습니다.",
    ),
)


TWICE_ALL = WrongAnswer(
    "twice all",
    lambda g: 2.0 * (g.thinking_s + 1.0 / min(g.rate_hz.values())),
    Text(
        en="That is twice the thinking time and two periods, all doubled to be safe: it is always enough, and longer than it need be.",
        ko="계산 시간과 주기를 모두 두 배로 했습니다. 언제나 충분하지만 필요한 것보다 깁니다.",
    ),
)


TASK = Task(
    id="E8.6",
    kind="N",
    points=2,
    title=Text(en="How long must it remember?", ko="얼마나 오래 기억해야 합니까?"),
    answer="cache_time_s",
    form=Number(unit="s", tolerance=0.002),
    given=detector,
    variants=6,
    model=memory,
    mistakes=(
        THINKING_ONLY,
        THE_FAST_LANE,
        BOTH_PERIODS,
        ONE_PERIOD_LESS,
        RATE_INSTEAD_OF_PERIOD,
        WHAT_ONE_GETS,
        TWENTY,
        HOUR,
        TWICE_THINKING,
        PERIOD_ALONE,
        TWICE_THINKING_ALONE,
        HALF_A_PERIOD,
        TWO_PERIODS,
        THREE_PERIODS,
        MULTIPLIED,
        ZERO,
        THIRTY,
        TEN_MORE,
        NUMBER_OF_SAMPLES,
        NUMBER_OF_SLOW_SAMPLES,
        HALF_AS_MUCH_AGAIN,
        MEAN_PERIOD,
        MEAN_RATE,
        SUM_OF_RATES,
        *SHARES_MORE,
        *AMOUNTS_MORE,
        TEN_AND_A_PERIOD,
        MINUTE,
        ROUNDED_UP,
        FAST_RATE_INSTEAD_OF_PERIOD,
        *COUNTS,
        THINKING_ROUNDED_UP,
        THINKING_ROUNDED_UP_AND_A_PERIOD,
        *WHOLE_PERIODS,
        BRACKETS,
        DIFFERENCE_OF_PERIODS,
        TWICE_ALL,
    ),
    hints=(
        Text(
            en="When the question comes, how far back does the picture's stamp lie?",
            ko="물어보는 순간, 영상의 측정 시각은 얼마나 과거에 있습니까?",
        ),
        Text(
            en="To interpolate at the stamp, a lane needs a sample before it. How much older than the stamp can that one be?",
            ko="측정 시각에서 보간하려면 그보다 이전의 표본이 필요합니다. 그 표본은 측정 시각보다 얼마나 더 오래된 것일 수 있습니까?",
        ),
        Text(
            en="Thinking time plus one period of the slowest edge on the path.",
            ko="계산 시간에 경로에서 가장 느린 연결의 한 주기를 더합니다.",
        ),
    ),
)
