"""E8.6: How long must it remember?"""

from __future__ import annotations

from tflab.workbook.tasks import Number, Task, Twin, Words


def detector(rng):
    slow = float(rng.choice([0.5, 2.0, 2.5, 4.0]))
    return {
        "thinking_s": round(float(rng.uniform(1.5, 6.0)), 2),
        "rate_hz": {"map -> odom": slow, "odom -> base_link": float(rng.choice([20.0, 25.0, 50.0]))},
    }


THINKING_ONLY = Twin(
    "thinking only",
    lambda g: g.thinking_s,
    Words(
        en="Then the sample just before the stamp may be gone already, and without it there is nothing to interpolate from.",
        ko="그러면 측정 시각 바로 앞의 표본이 이미 사라졌을 수 있고, 그것이 없으면 보간할 수 없습니다.",
    ),
)


THE_FAST_LANE = Twin(
    "the fast lane",
    lambda g: g.thinking_s + 1.0 / max(g.rate_hz.values()),
    Words(
        en="You counted with the fast edge. Every edge of the path must still hold the sample before the stamp, the slow one too.",
        ko="빠른 연결로 계산했습니다. 경로의 모든 연결이 측정 시각 앞의 표본을 갖고 있어야 하고, 느린 연결도 마찬가지입니다.",
    ),
)


BOTH_PERIODS = Twin(
    "both periods",
    lambda g: g.thinking_s + sum(1.0 / rate for rate in g.rate_hz.values()),
    Words(
        en="You added the periods of both edges. Each lane needs only its own, so the longest one is enough.",
        ko="두 연결의 주기를 더했습니다. 차선마다 자기 주기만 필요하므로 가장 긴 것이면 충분합니다.",
    ),
)


ONE_PERIOD_LESS = Twin(
    "one period less",
    lambda g: g.thinking_s - 1.0 / min(g.rate_hz.values()),
    Words(
        en="A period less than the thinking time: then even the moment of the picture is forgotten.",
        ko="계산 시간보다 한 주기 짧습니다. 그러면 영상을 찍은 순간조차 잊습니다.",
    ),
)


RATE_INSTEAD_OF_PERIOD = Twin(
    "rate instead of period",
    lambda g: g.thinking_s + min(g.rate_hz.values()),
    Words(
        en="Did you add a rate to a time? A period is one over the rate.",
        ko="시간에 Hz를 더하지 않았습니까? 주기는 Hz의 역수입니다.",
    ),
)


WHAT_ONE_GETS = Twin(
    "what one gets",
    10.0,
    Words(
        en="Ten seconds is what you get if you say nothing. It is enough here, but not the least that is enough.",
        ko="10초는 따로 정하지 않을 때의 값입니다. 여기서는 충분하지만, 충분한 값 가운데 가장 작은 것은 아닙니다.",
    ),
)


TWENTY = Twin(
    "longer is safer",
    20.0,
    Words(
        en="Twenty seconds are more than is needed. Longer is not safer: it only costs memory. The least that is always enough is asked for.",
        ko="20초는 필요보다 깁니다. 길다고 더 안전하지 않고 메모리만 듭니다. 언제나 충분한 값 가운데 가장 작은 것이 필요합니다.",
    ),
)

HOUR = Twin(
    "an hour",
    3600.0,
    Words(
        en="An hour is always enough, and hides what is needed. The least that is always enough is asked for: work it out.",
        ko="한 시간이면 언제나 충분하지만 얼마가 필요한지 알 수 없게 됩니다. 언제나 충분한 값 가운데 가장 작은 것을 계산하십시오.",
    ),
)


TASK = Task(
    id="E8.6",
    kind="N",
    points=2,
    title=Words(en="How long must it remember?", ko="얼마나 오래 기억해야 합니까?"),
    answer="cache_time_s",
    form=Number(unit="s", tolerance=0.002),
    given=detector,
    variants=6,
    twins=(
        THINKING_ONLY,
        THE_FAST_LANE,
        BOTH_PERIODS,
        ONE_PERIOD_LESS,
        RATE_INSTEAD_OF_PERIOD,
        WHAT_ONE_GETS,
        TWENTY,
        HOUR,
    ),
    hints=(
        Words(
            en="When the question comes, how far back does the picture's stamp lie?",
            ko="물어보는 순간, 영상의 측정 시각은 얼마나 과거에 있습니까?",
        ),
        Words(
            en="To interpolate at the stamp, a lane needs a sample before it. How much older than the stamp can that one be?",
            ko="측정 시각에서 보간하려면 그 앞의 표본이 필요합니다. 그 표본은 측정 시각보다 얼마나 더 오래된 것일 수 있습니까?",
        ),
        Words(
            en="Thinking time plus one period of the slowest edge on the path.",
            ko="계산 시간에 경로에서 가장 느린 연결의 한 주기를 더합니다.",
        ),
    ),
)
