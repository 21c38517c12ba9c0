"""E10.5: How wrong is the sensor's clock?"""

from __future__ import annotations

import statistics
from itertools import pairwise

from tflab.workbook.tasks import Number, Task, Text, WrongAnswer, WrongStep

PICKS = {
    "smallest": min,
    "mean": statistics.fmean,
    "middle": statistics.median,
    "largest": max,
    "first": lambda gaps: gaps[0],
    "last": lambda gaps: gaps[-1],
    "both ends": lambda gaps: (gaps[0] + gaps[-1]) / 2,
    "halfway": lambda gaps: (min(gaps) + max(gaps)) / 2,
}


def log_of_a_sensor(rng):
    """Draw messages in which first, last, middle, mean, largest and smallest delay are told apart, whatever is done."""
    while True:
        given = _one_log(rng)
        gaps = [heard - stamp for stamp, heard in given["log"]]
        told = sorted(pick(gaps) + k * given["shortest_delay_s"] for pick in PICKS.values() for k in (-1, -0.5, 0, 1))
        if min(after - before for before, after in pairwise(told)) > 0.004:
            return given


def _one_log(rng):
    """Draw thirteen messages: delays that only add to the healthiest one, and a clock that is off."""
    shortest_s = round(float(rng.uniform(0.03, 0.12)), 3)
    behind_s = round(float(rng.choice([-1.0, 1.0])) * float(rng.uniform(0.25, 0.9)), 3)
    begin_s = round(float(rng.uniform(20.0, 60.0)), 1)
    late_s = [round(float(late), 3) for late in rng.uniform(0.02, 0.25, 13)]  # an odd number: one is in the middle
    late_s[int(rng.integers(3, 9))] = 0.0
    log = []
    for number, extra_s in enumerate(late_s):
        true_s = begin_s + 0.1 * number
        log.append((round(true_s - behind_s, 3), round(true_s + shortest_s + extra_s, 3)))
    return {"log": log, "shortest_delay_s": shortest_s}


def behind(g, pick="smallest", delay="taken off", way="heard - stamp", sign="behind"):
    """Return by how much the sensor's clock is behind, step by step."""
    gaps = [heard - stamp if way == "heard - stamp" else stamp - heard for stamp, heard in g.log]
    healthy = {"taken off": -1, "taken off twice": -2, "halved": -0.5, "forgotten": 0, "added": 1}[delay]
    found = PICKS[pick](gaps) + healthy * g.shortest_delay_s
    return -found if sign == "ahead" else found


HOW_LONG_THE_LOG_IS = WrongAnswer(
    "how long the log is",
    lambda g: g.log[-1][1] - g.log[0][0],
    Text(
        en="That is last heard minus first stamp: how long the whole log is. A clock that is off shows in one and the same message, as heard minus stamp.",
        ko="마지막으로 받은 시각에서 첫 측정 시각을 뺀 것, 곧 로그 전체의 길이입니다. 시계의 오차는 같은 메시지의 받은 시각과 측정 시각의 차이에서 드러납니다.",
    ),
    "M10",
)

MEAN = WrongStep(
    "mean",
    {"pick": "mean"},
    Text(
        en="You took the mean. Delays only ever add: the mean holds half of all the traffic jams.",
        ko="평균을 썼습니다. 지연은 더해지기만 합니다. 평균에는 막힌 시간이 함께 들어 있습니다.",
    ),
    "M10",
)

MEDIAN = WrongStep(
    "median",
    {"pick": "middle"},
    Text(
        en="You took the one in the middle. That is the usual delay, not the healthy one: delays only ever add.",
        ko="가운데 값을 썼습니다. 흔한 지연이지 정상 지연이 아닙니다. 지연은 더해지기만 합니다.",
    ),
    "M10",
)

LARGEST = WrongStep(
    "largest",
    {"pick": "largest"},
    Text(
        en="You took the largest difference: the message that was held up most says least about the clock.",
        ko="가장 큰 차이를 썼습니다. 가장 오래 막힌 메시지는 시계에 대해 알려 주는 것이 가장 적습니다.",
    ),
    "M10",
)

FIRST = WrongStep(
    "first",
    {"pick": "first"},
    Text(
        en="You took the first message alone. Was just that one not held up anywhere?",
        ko="첫 메시지만 썼습니다. 하필 그 메시지가 어디에서도 막히지 않았을까요?",
    ),
)

LAST = WrongStep(
    "last",
    {"pick": "last"},
    Text(
        en="You took the last message alone. Was just that one not held up anywhere?",
        ko="마지막 메시지만 썼습니다. 하필 그 메시지가 어디에서도 막히지 않았을까요?",
    ),
)

HALFWAY = WrongStep(
    "halfway",
    {"pick": "halfway"},
    Text(
        en="You took the middle between smallest and largest. The largest is the message that was held up most.",
        ko="가장 작은 차와 가장 큰 차의 한가운데를 썼습니다. 가장 큰 차는 가장 오래 막힌 메시지의 것입니다.",
    ),
    "M10",
)

BOTH_ENDS = WrongStep(
    "both ends",
    {"pick": "both ends"},
    Text(
        en="You took the mean of the first message and the last. Were just these two not held up anywhere?",
        ko="첫 메시지와 마지막 메시지의 평균을 썼습니다. 하필 그 둘이 어디에서도 막히지 않았을까요?",
    ),
)

SPREAD_TURNED_ROUND = WrongAnswer(
    "spread turned round",
    lambda g: min(h - s for s, h in g.log) - max(h - s for s, h in g.log),
    Text(
        en="That is by how much the delays differ: smallest minus largest. The clock's error is in both, and so it is gone.",
        ko="지연이 서로 얼마나 다른지, 곧 가장 작은 차에서 가장 큰 차를 뺀 값입니다. 시계의 오차는 둘 다에 들어 있어 사라졌습니다.",
    ),
)

TWO_MESSAGES = WrongAnswer(
    "two messages",
    lambda g: g.log[0][1] - g.log[-1][0] - g.shortest_delay_s,
    Text(
        en="You took when the first message was heard, and what the last one's stamp says. Between these two lies the whole log: subtract within each message.",
        ko="첫 메시지의 수신 시각에서 마지막 메시지의 측정 시각을 뺐습니다. 그 사이에 로그 전체가 들어 있습니다. 메시지마다 따로 빼십시오.",
    ),
)

SPREAD = WrongAnswer(
    "spread",
    lambda g: max(h - s for s, h in g.log) - min(h - s for s, h in g.log),
    Text(
        en="That is by how much the delays differ: largest minus smallest. The clock's error is in both, and so it is gone.",
        ko="지연이 서로 얼마나 다른지, 곧 가장 큰 차에서 가장 작은 차를 뺀 값입니다. 시계의 오차는 둘 다에 들어 있어 사라졌습니다.",
    ),
)

GAINED = WrongAnswer(
    "gained",
    lambda g: (g.log[-1][1] - g.log[0][1]) - (g.log[-1][0] - g.log[0][0]),
    Text(
        en="You compared how far either clock went from the first message to the last. That would show whether one runs faster, not how far they are apart.",
        ko="첫 메시지에서 마지막 메시지까지 두 시계가 간 시간을 비교했습니다. 그것으로는 어느 쪽이 더 빨리 가는지 알 뿐, 얼마나 어긋났는지는 모릅니다.",
    ),
)

DELAY_HALVED = WrongStep(
    "delay halved",
    {"delay": "halved"},
    Text(
        en="You took off half of the healthy delay. Half is for the way there and back; these messages went one way.",
        ko="정상 지연의 절반만 뺐습니다. 절반은 왕복 시간을 쟀을 때 씁니다. 이 메시지들은 한 방향으로만 왔습니다.",
    ),
    "M10",
)

DELAY_FORGOTTEN = WrongStep(
    "delay forgotten",
    {"delay": "forgotten"},
    Text(
        en="A healthy message takes its time, too. That part of the difference is no fault of the clock.",
        ko="정상인 메시지도 오는 데 시간이 걸립니다. 차이 가운데 그만큼은 시계 탓이 아닙니다.",
    ),
    "M10",
)

DELAY_ADDED = WrongStep(
    "delay added",
    {"delay": "added"},
    Text(
        en="You added the healthy delay. It is part of the difference already, and has to be taken off.",
        ko="정상 지연을 더했습니다. 차이에 이미 들어 있으므로 빼야 합니다.",
    ),
    "M10",
)

TURNED_ROUND = WrongStep(
    "turned round",
    {"way": "stamp - heard"},
    Text(
        en="You took stamp minus heard. Behind means: the stamp shows too little, so the difference is heard minus stamp.",
        ko="측정 시각에서 수신 시각을 뺐습니다. 뒤처졌다는 것은 측정 시각이 너무 작다는 뜻이므로, 수신 시각에서 측정 시각을 뺍니다.",
    ),
)

AHEAD_FOR_BEHIND = WrongStep(
    "ahead for behind",
    {"sign": "ahead"},
    Text(
        en="The size is right, the sign is not. A clock that is behind writes a stamp that is too small, and heard minus stamp comes out too large: what is asked for is above 0 then, and below 0 for a clock that is ahead.",
        ko="크기는 맞고 부호가 반대입니다. 늦은 시계는 너무 작은 시각을 적으므로 들은 시각에서 측정 시각을 뺀 값이 너무 커집니다. 그때 답은 0보다 크고, 빠른 시계라면 0보다 작습니다.",
    ),
)

DELAY_TWICE = WrongStep(
    "delay taken off twice",
    {"delay": "taken off twice"},
    Text(
        en="You took the healthy delay off twice. A message travels once, from the sensor to the robot.",
        ko="정상 지연을 두 번 뺐습니다. 메시지는 센서에서 로봇으로 한 번 옵니다.",
    ),
    "M10",
)


TASK = Task(
    id="E10.5",
    kind="N",
    points=3,
    title=Text(en="How wrong is the sensor's clock?", ko="센서의 시계는 얼마나 틀렸습니까?"),
    answer="behind_s",
    form=Number(unit="s", tolerance=0.002),
    given=log_of_a_sensor,
    variants=8,
    model=behind,
    mistakes=(
        HOW_LONG_THE_LOG_IS,
        MEAN,
        MEDIAN,
        LARGEST,
        FIRST,
        LAST,
        TURNED_ROUND,
        HALFWAY,
        BOTH_ENDS,
        SPREAD,
        SPREAD_TURNED_ROUND,
        TWO_MESSAGES,
        GAINED,
        DELAY_HALVED,
        DELAY_FORGOTTEN,
        DELAY_ADDED,
        DELAY_TWICE,
        AHEAD_FOR_BEHIND,
    ),
    hints=(
        Text(
            en="heard - stamp holds three things: the clock's error, the healthy delay, and whatever held this message up.",
            ko="수신 시각 − 측정 시각에는 셋이 들어 있습니다. 시계의 오차, 정상 지연, 그 메시지가 막힌 시간입니다.",
        ),
        Text(
            en="Nothing is ever held up by less than nothing. In which message is the third part smallest?",
            ko="막힌 시간은 0보다 작을 수 없습니다. 셋째 부분이 가장 작은 메시지는 어느 것입니까?",
        ),
        Text(
            en="The smallest difference of all, and the healthy delay taken off.",
            ko="모든 차이 가운데 가장 작은 것에서 정상 지연을 뺍니다.",
        ),
    ),
    misconceptions=("M10",),
)
