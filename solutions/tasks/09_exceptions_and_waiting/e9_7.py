"""E9.7: The smallest wait that always succeeds."""

from __future__ import annotations

import math
from functools import partial
from itertools import pairwise
from statistics import mean
from types import SimpleNamespace

from tflab.workbook.tasks import Draws, Number, Task, Text, WrongAnswer, WrongStep

TOLERANCE_S = 0.0005


def two_edges(rng: Draws) -> dict:
    """Draw until no two mistakes give the same wait; two that are easily made together count as one more."""
    together = partial(wait_of, periods=0.0, scan=-1.0)
    while True:
        given = _two_edges(rng)
        held = SimpleNamespace(**given)
        mistakes = [
            partial(wait_of, **twin.at) if isinstance(twin, WrongStep) else twin.answer for twin in TASK.mistakes
        ]
        waits_s = sorted(mistake(held) if callable(mistake) else mistake for mistake in (wait_of, together, *mistakes))
        if min(later - sooner for sooner, later in pairwise(waits_s)) > TOLERANCE_S + 1e-9:
            return given


def _two_edges(rng: Draws) -> dict:
    """Draw two edges of which the slow one decides, and a scan that has been under way for a while.

    Each ends in another tenth of a millisecond: two mistakes do not come to the same number by chance.
    """

    def drawn(low_s: float, high_s: float, rest_ms: float) -> float:
        return round(round(float(rng.uniform(low_s, high_s)), 3) + rest_ms / 1000.0, 4)

    return {
        "localization": {
            "rate_hz": float(rng.choice((6.0, 7.0, 7.5, 9.0))),
            "delay_s": drawn(0.070, 0.089, 0.3),
            "jitter_s": drawn(0.020, 0.039, 0.4),
        },
        "wheel_odometry": {
            "rate_hz": float(rng.choice((22.0, 24.0, 26.0))),
            "delay_s": drawn(0.004, 0.014, 0.6),
            "jitter_s": drawn(0.045, 0.059, 0.7),
        },
        "scan_delay_s": drawn(0.010, 0.021, 0.9),
    }


def wait_of(
    given, *, periods=1.0, delay=1.0, jitter=1.0, scan=1.0, combine=max, rate="one over it", edges="by edge"
) -> float:
    """Return the wait; the options are the mistakes."""
    sources = (given.localization, given.wheel_odometry)
    every = {name: [one[name] for one in sources] for name in ("rate_hz", "delay_s", "jitter_s")}
    period_of = {
        "one over it": lambda hz: 1.0 / hz,
        "as it is": lambda hz: hz,
        "milliseconds": lambda hz: 1000.0 / hz,
        "radians": lambda hz: 1.0 / (math.tau * hz),
    }[rate]
    if edges in ("periods added", "rates added"):
        rates = every["rate_hz"]
        period = sum(1.0 / hz for hz in rates) if edges == "periods added" else 1.0 / sum(rates)
        late = max(delay * one["delay_s"] + jitter * one["jitter_s"] for one in sources)
        return periods * period + late - scan * given.scan_delay_s
    if edges == "the worst of each":
        worst = 1.0 / min(every["rate_hz"]) + max(every["delay_s"]) + max(every["jitter_s"])
        return worst - scan * given.scan_delay_s
    slow = min(sources, key=lambda one: one["rate_hz"])
    if edges == "delays added":
        late = sum(every["delay_s"]) + sum(every["jitter_s"])
        return 1.0 / slow["rate_hz"] + late - scan * given.scan_delay_s
    if edges == "the period alone":
        return 1.0 / slow["rate_hz"]
    if isinstance(edges, tuple):  # whose period, whose delay, whose jitter
        of_period, of_delay, of_jitter = (getattr(given, name) for name in edges)
        mixed = 1.0 / of_period["rate_hz"] + of_delay["delay_s"] + of_jitter["jitter_s"]
        return mixed - scan * given.scan_delay_s
    parts = [(periods * period_of(one["rate_hz"]), delay * one["delay_s"], jitter * one["jitter_s"]) for one in sources]
    each = [math.hypot(*row) if edges == "root of squares" else sum(row) for row in parts]
    return combine(each) - scan * given.scan_delay_s


def of_edges(edges: str | tuple[str, str, str]) -> dict:
    """Return the steps of who takes numbers from the wrong edges: besides, only the scan's delay can be wrong."""
    return {"edges": edges, "periods": 1.0, "delay": 1.0, "jitter": 1.0}


def delay_taken_off(given) -> float:
    """Return the wait for the edge that decides, its delay with the wrong sign."""
    later = max((given.localization, given.wheel_odometry), key=lambda one: 1.0 / one["rate_hz"] + one["delay_s"])
    return 1.0 / later["rate_hz"] - later["delay_s"] + later["jitter_s"] - given.scan_delay_s


PERIOD_FORGOTTEN = WrongStep(
    "period forgotten",
    {"periods": 0.0},
    reply=Text(
        en="the period is missing: with this wait it succeeds only sometimes. In the worst case the transform you need is stamped a whole period after the scan.",
        ko="주기가 빠졌습니다. 이 시간으로는 가끔만 성공합니다. 최악의 경우 필요한 변환의 시각은 스캔의 측정 시각보다 한 주기 늦습니다.",
    ),
)


HALF_A_PERIOD = WrongStep(
    "half a period",
    {"periods": 0.5},
    reply=Text(
        en="half a period is the average. Asked for is a wait that always succeeds.",
        ko="반 주기는 평균입니다. 필요한 것은 언제나 성공하는 시간입니다.",
    ),
)


JITTER_FORGOTTEN = WrongStep(
    "jitter forgotten",
    {"jitter": 0.0},
    reply=Text(
        en="the jitter is missing: you reckon with a quiet day. By how much may a transform be later than its delay?",
        ko="지터가 빠져 조용한 날만 계산했습니다. 변환은 정해진 지연보다 얼마나 더 늦을 수 있습니까?",
    ),
)


SCAN_S_DELAY_FORGOTTEN = WrongStep(
    "scan's delay forgotten",
    {"scan": 0.0},
    reply=Text(
        en="the scan's own delay is missing. While it was under way, time had already passed: by that much the wait is shorter.",
        ko="스캔 자신의 지연이 빠졌습니다. 스캔이 오는 동안 이미 시간이 흘렀으므로 기다림은 그만큼 짧아집니다.",
    ),
)


SCAN_S_DELAY_ADDED = WrongStep(
    "scan's delay added",
    {"scan": -1.0},
    reply=Text(
        en="the wait is reckoned from the scan's arrival. Does the time that the scan was under way make it longer, or shorter?",
        ko="기다림은 스캔이 도착한 때부터 잽니다. 스캔이 오는 데 걸린 시간은 기다림을 늘립니까, 줄입니까?",
    ),
)


QUICK_EDGE = WrongStep(
    "quick edge",
    {"combine": min},
    reply=Text(
        en="this is the wait for one edge alone, `wheel_odometry`, which comes first. A lookup needs `map → odom`, too: is an edge left out, or is it `min` where the later one decides?",
        ko="먼저 오는 연결인 `wheel_odometry` 하나로만 계산했습니다. 조회에는 `map → odom`도 필요합니다. 연결 하나를 빠뜨렸습니까, 늦은 쪽이 정하는 곳에 `min`을 썼습니까?",
    ),
)


ADDED_UP = WrongStep(
    "added up",
    {"combine": sum},
    reply=Text(
        en="the two edges do not wait for one another: their messages travel at the same time.",
        ko="두 연결은 서로를 기다리지 않습니다. 메시지는 동시에 옵니다.",
    ),
)


A_ROUND_SECOND = WrongAnswer(
    "a round second",
    1.0,
    misconception="M10",
    reply=Text(
        en="one second is a habit, not a result: it is longer than any of these numbers asks for, and it hides a clock that is wrong. Work it out.",
        ko="1초는 흔히 쓰는 값일 뿐, 계산한 값이 아닙니다. 이 숫자들에 필요한 것보다 길고, 틀린 시계를 숨깁니다. 계산해 보십시오.",
    ),
)

DELAY_FORGOTTEN = WrongStep(
    "delay forgotten",
    {"delay": 0.0},
    reply=Text(
        en="the delay of the transform is missing: it is on its way for that long, each time.",
        ko="변환의 지연이 빠졌습니다. 매번 그만큼 걸려서 옵니다.",
    ),
)

JITTER_TWICE = WrongStep(
    "jitter twice",
    {"jitter": 2.0},
    reply=Text(
        en="the jitter is counted twice. A transform is late by its delay and up to the jitter more, and then it is there.",
        ko="흔들림을 두 번 셌습니다. 변환은 지연에 흔들림을 한 번 더한 만큼까지만 늦습니다.",
    ),
)

JITTER_TAKEN_OFF = WrongStep(
    "jitter taken off",
    {"jitter": -1.0},
    reply=Text(
        en="you take the jitter off. It makes a transform later, and the worst case has all of it on top of the delay.",
        ko="흔들림을 뺐습니다. 흔들림은 변환을 더 늦게 합니다. 최악의 경우에는 지연에 흔들림을 모두 더합니다.",
    ),
)

TWO_PERIODS = WrongStep(
    "two periods",
    {"periods": 2.0},
    reply=Text(
        en="two periods are more than is needed: the first transform stamped after the scan will do.",
        ko="두 주기는 필요보다 깁니다. 스캔 뒤의 첫 변환이면 됩니다.",
    ),
)

TEN_SECONDS = WrongAnswer(
    "ten seconds",
    10.0,
    reply=Text(
        en="ten seconds is a habit, not a result: the scan would be ten seconds old. Work it out.",
        ko="10초는 흔히 쓰는 값일 뿐, 계산한 결과가 아닙니다. 그때 스캔은 10초나 지난 것입니다. 계산해 보십시오.",
    ),
    misconception="M10",
)


RATE_FOR_PERIOD = WrongStep(
    "rate for period",
    {"rate": "as it is"},
    Text(
        en="you used the rate [Hz] as a time. The time between two messages is one over the rate.",
        ko="발행률[Hz]을 시간으로 썼습니다. 두 메시지 사이의 시간은 그 역수입니다.",
    ),
)


HALF_THE_JITTER = WrongStep(
    "half the jitter",
    {"jitter": 0.5},
    Text(
        en="you counted half of the jitter. In the worst case all of it comes on top.",
        ko="지터를 절반만 셌습니다. 최악의 경우에는 전부 더해집니다.",
    ),
)


THE_WORST_OF_EACH = WrongStep(
    "the worst of each",
    of_edges("the worst of each"),
    Text(
        en="you took the longest period, the longest delay and the largest jitter, each from whichever edge has it. They are of two edges: is it a `max` for each number, or a line copied from the other edge? Reckon each edge by itself, and then take the later.",
        ko="주기와 지연과 지터를 저마다 가장 큰 연결에서 골랐습니다. 서로 다른 연결의 것입니다. 수마다 `max`를 썼거나 다른 연결의 줄을 복사했습니까? 연결마다 따로 계산한 다음 늦은 쪽을 고르십시오.",
    ),
)


PERIODS_ADDED = WrongStep(
    "periods added",
    of_edges("periods added"),
    Text(
        en="you added the periods of the two edges. They run side by side, each at its own rate: reckon each edge by itself, and then take the later.",
        ko="두 연결의 주기를 더했습니다. 둘은 저마다의 주파수로 나란히 옵니다. 연결마다 따로 계산한 다음 늦은 쪽을 고르십시오.",
    ),
)


RATES_ADDED = WrongStep(
    "rates added",
    of_edges("rates added"),
    Text(
        en="you added the rates, as if either message would do. A lookup needs one of each edge: reckon each by itself, and then take the later.",
        ko="두 연결의 주파수를 더해, 아무 메시지나 오면 되는 것처럼 계산했습니다. 조회에는 연결마다 하나씩 필요합니다. 따로 계산한 다음 늦은 쪽을 고르십시오.",
    ),
)


MEAN_OF_THE_EDGES = WrongStep(
    "mean of the edges",
    {"combine": mean},
    Text(
        en="the mean of the two edges gives this. A lookup needs both: the later one decides.",
        ko="두 연결의 평균이 이 값입니다. 조회에는 둘 다 필요하므로 늦은 쪽이 정합니다.",
    ),
)


PERIOD_ALONE = WrongAnswer(
    "the period alone",
    partial(wait_of, edges="the period alone"),
    Text(
        en="the longer period alone gives this. A transform is also on its way for a while, and the scan was as well: the delay and the jitter make the wait longer, the scan's own delay makes it shorter.",
        ko="긴 쪽의 주기만으로 이 값이 나옵니다. 변환도 오는 데 시간이 걸리고 스캔도 그랬습니다. 지연과 지터만큼 더 기다려야 하고, 스캔 자신의 지연만큼 덜 기다려도 됩니다.",
    ),
)


def mixed(period: str, delay: str, jitter: str) -> WrongStep:
    """Return the slip that takes its three numbers from different edges."""
    of = (("rate_hz", period), ("delay_s", delay), ("jitter_s", jitter))
    rows = [f"`{name}` of `{source}`" for name, source in of]
    korean = [f"`{source}`의 `{name}`" for name, source in of]
    return WrongStep(
        f"mixed: {period}, {delay}, {jitter}",
        of_edges((period, delay, jitter)),
        Text(
            en=f"this comes of {rows[0]}, {rows[1]} and {rows[2]}: was a line copied, and not changed everywhere? Reckon each edge with its own three numbers, and then take the later.",
            ko=f"{korean[0]}, {korean[1]}, {korean[2]}로 계산한 값입니다. 줄을 복사하고 다 고치지 않은 것이 아닙니까? 연결마다 자기의 세 수로 계산한 다음 늦은 쪽을 쓰십시오.",
        ),
    )


LOCAL, WHEELS = "localization", "wheel_odometry"
MIXED = (
    mixed(LOCAL, WHEELS, WHEELS),
    mixed(LOCAL, WHEELS, LOCAL),
    mixed(WHEELS, LOCAL, LOCAL),
    mixed(WHEELS, LOCAL, WHEELS),
    mixed(WHEELS, WHEELS, LOCAL),
)


DELAYS_ADDED = WrongStep(
    "delays added",
    of_edges("delays added"),
    Text(
        en="you added the delays and the jitters of both edges. Their messages travel at the same time: reckon each edge by itself, and then take the later.",
        ko="두 연결의 지연과 지터를 모두 더했습니다. 메시지는 동시에 오므로 연결마다 따로 계산한 다음 늦은 쪽을 쓰십시오.",
    ),
)


ROOT_OF_SQUARES = WrongAnswer(
    "root of squares",
    partial(wait_of, edges="root of squares"),
    Text(
        en="you took the root of the squares. That is how errors that vary by chance add up; in the worst case the three come one after the other, and are added as they are.",
        ko="제곱을 더해 제곱근을 구했습니다. 그것은 제멋대로 변하는 오차를 합치는 법입니다. 최악의 경우에는 셋이 차례로 다 걸리므로 그대로 더합니다.",
    ),
)


PERIOD_IN_MILLISECONDS = WrongStep(
    "period in milliseconds",
    {"rate": "milliseconds"},
    Text(
        en="your period is in milliseconds, and what you add to it is in seconds: 1000 over the rate is 1 over it in ms.",
        ko="주기는 밀리초인데 거기에 더하는 값은 초입니다. 1000을 주파수로 나누면 밀리초가 됩니다.",
    ),
)


PERIOD_OF_RADIANS = WrongAnswer(
    "period of radians",
    partial(wait_of, rate="radians"),
    Text(
        en="you divided by 2π, too. A rate in Hz counts messages, not radians: the period is one over it.",
        ko="2π로도 나누었습니다. Hz는 라디안이 아니라 1초에 오는 메시지의 수이므로 주기는 그 역수입니다.",
    ),
)


HALF_THE_SCAN_S_DELAY = WrongAnswer(
    "half the scan's delay",
    partial(wait_of, scan=0.5),
    Text(
        en="half of the scan's delay is taken off. All of it has passed when the scan is there.",
        ko="스캔 지연의 절반만 뺐습니다. 스캔이 도착했을 때는 그 지연이 모두 지나갔습니다.",
    ),
)


SCAN_S_DELAY_TWICE = WrongStep(
    "scan's delay twice",
    {"scan": 2.0},
    Text(
        en="the scan's own delay is taken off twice. It was under way once.",
        ko="스캔의 지연을 두 번 뺐습니다. 스캔이 오는 데 걸린 시간은 한 번뿐입니다.",
    ),
)


DELAY_TAKEN_OFF = WrongAnswer(
    "delay taken off",
    delay_taken_off,
    Text(
        en="you take the transform's delay off. It makes the transform later, and so the wait longer.",
        ko="변환의 지연을 뺐습니다. 지연만큼 변환이 늦게 오므로 더 오래 기다려야 합니다.",
    ),
)


HALF_MORE_PERIOD = WrongStep(
    "one and a half periods",
    {"periods": 1.5},
    Text(
        en="one and a half periods are more than is needed: the first transform stamped after the scan will do, and it comes within one.",
        ko="한 주기 반은 필요한 것보다 깁니다. 스캔 뒤 처음으로 측정한 변환이면 되고, 그것은 한 주기 안에 나옵니다.",
    ),
)


TASK = Task(
    id="E9.7",
    kind="N",
    points=2,
    title=Text(en="The smallest wait that always succeeds", ko="언제나 성공하는 가장 짧은 기다림"),
    answer="wait_s",
    form=Number("s", tolerance=TOLERANCE_S),
    given=two_edges,
    variants=5,
    model=wait_of,
    mistakes=(
        PERIOD_FORGOTTEN,
        HALF_A_PERIOD,
        JITTER_FORGOTTEN,
        SCAN_S_DELAY_FORGOTTEN,
        SCAN_S_DELAY_ADDED,
        QUICK_EDGE,
        ADDED_UP,
        A_ROUND_SECOND,
        DELAY_FORGOTTEN,
        JITTER_TWICE,
        JITTER_TAKEN_OFF,
        TWO_PERIODS,
        TEN_SECONDS,
        RATE_FOR_PERIOD,
        HALF_THE_JITTER,
        THE_WORST_OF_EACH,
        PERIODS_ADDED,
        RATES_ADDED,
        MEAN_OF_THE_EDGES,
        PERIOD_ALONE,
        *MIXED,
        DELAYS_ADDED,
        ROOT_OF_SQUARES,
        PERIOD_IN_MILLISECONDS,
        PERIOD_OF_RADIANS,
        HALF_THE_SCAN_S_DELAY,
        SCAN_S_DELAY_TWICE,
        DELAY_TAKEN_OFF,
        HALF_MORE_PERIOD,
    ),
    hints=(
        Text(
            en="Work out for each edge when, at the latest, the first sample at or after the scan's stamp has arrived.",
            ko="연결마다 스캔 시각과 같거나 뒤인 첫 표본이 늦어도 언제 도착하는지 계산하십시오.",
        ),
        Text(
            en="Period, delay and jitter each make it later. What makes your wait shorter?",
            ko="주기, 지연, 지터는 모두 늦어지게 합니다. 기다림을 줄여 주는 것은 무엇입니까?",
        ),
        Text(
            en="(1 / rate + delay + jitter) for each edge; the later of the two counts; the scan's own delay has already passed.",
            ko="연결마다 (1 / 주파수 + 지연 + 지터)를 구하고, 둘 중 늦은 쪽을 씁니다. 스캔 자신의 지연은 이미 지나갔습니다.",
        ),
    ),
    misconceptions=("M10",),
)
