"""E8.1: How fresh is latest?"""

from __future__ import annotations

from tflab.workbook.tasks import Number, Task, Text, WrongAnswer, WrongStep

PATH = ("map -> odom", "odom -> base_link")


def lanes(rng):
    """Draw until the age of the answer, and the span of the first lane, are near no other time or span."""
    while True:
        given = _lanes(rng)
        newest = [given["newest_s"][edge] for edge in PATH]
        oldest = [given["oldest_s"][edge] for edge in PATH]
        first_s = min(given["oldest_s"].values())
        age_s, span_s = given["clock_s"] - min(newest), newest[0] - oldest[0]
        spans = (min(newest) - max(oldest), min(newest) - first_s, max(newest) - first_s)
        far_s = [abs(age_s - other_s) for other_s in (*newest, *oldest, sum(newest) / 2, 0.12)]
        if min(*far_s, *(abs(span_s - other_s) for other_s in spans)) > 0.02:
            return given


def _lanes(rng):
    map_s, odom_s = sorted(rng.uniform(6.0, 9.0, 2).round(2).tolist(), key=lambda _: rng.random())
    if abs(map_s - odom_s) < 0.2:
        odom_s = round(odom_s + 0.3, 2)
    arm_s = round(min(map_s, odom_s) - float(rng.uniform(0.3, 1.0)), 2)
    starts = (1.0 + 0.4 * rng.permutation(4)[:3] + rng.uniform(0.0, 0.1, 3)).round(2).tolist()
    names = ("map -> odom", "odom -> base_link", "base_link -> arm_link")
    return {
        "oldest_s": dict(zip(names, starts, strict=True)),
        "newest_s": dict(zip(names, (map_s, odom_s, arm_s), strict=True)),
        "static": ["base_link -> laser_frame, sent at 0.12"],
        "clock_s": round(max(map_s, odom_s) + 0.17, 2),
    }


def common(g, *, lanes="the path", end="newest", which="common", told="time"):
    """Return the time, step by step; other steps are the slips."""
    edges = {"the path": PATH, "all": list(g.newest_s), "and the static one": PATH, "map alone": PATH[:1]}[lanes]
    rows = [(g.newest_s if end == "newest" else g.oldest_s)[edge] for edge in edges]
    rows += [0.12] if lanes == "and the static one" else []
    ends = {"latest": max(rows), "earliest": min(rows), "mean": sum(rows) / len(rows)}
    stamp_s = ends.get(which, min(rows) if end == "newest" else max(rows))
    return g.clock_s - stamp_s if told == "age" else stamp_s


NEWEST_OF_ALL = WrongStep(
    "newest of all",
    {"end": "newest", "which": "latest"},
    Text(
        en="That is the newest sample on the path. At that moment the other lane has nothing to say yet, and a lookup needs every lane.",
        ko="경로에서 가장 새로운 표본의 시각입니다. 그 순간 다른 시간줄에는 아직 값이 없고, 조회에는 모든 시간줄이 필요합니다.",
    ),
    "M9",
)


EARLIEST_START = WrongStep(
    "earliest start",
    {"end": "oldest"},
    Text(
        en="That is the latest of the *first* samples, where the common interval begins. `Time()` asks for its end, and that is up to the last samples.",
        ko="*첫* 표본들 가운데 가장 늦은 시각, 곧 공통 구간이 시작되는 시각입니다. `Time()`은 그 구간의 끝을 묻고, 끝은 마지막 표본들이 정합니다.",
    ),
)


OLDEST_OF_ALL = WrongStep(
    "oldest of all",
    {"end": "oldest", "which": "earliest"},
    Text(
        en="That is the oldest sample on the way. `Time()` asks for something as new as possible.",
        ko="경로에 있는 표본 가운데 가장 오래된 것의 시각입니다. `Time()`은 될 수 있는 대로 새로운 것을 묻습니다.",
    ),
)


NOW = WrongAnswer(
    "now",
    lambda g: g.clock_s,
    Text(
        en="That is the clock on the wall. `Time()` does not mean now; nothing in the buffer is that fresh.",
        ko="현재 시각(시스템 시각)입니다. `Time()`은 지금이 아닙니다. 버퍼 안에 그만큼 새로운 것은 없습니다.",
    ),
    "M9",
)


COUNTING_THE_STATIC = WrongStep(
    "counting the static",
    {"lanes": "and the static one"},
    Text(
        en="That is when the static edge was sent. It is good for any time, however long ago that was, and limits no answer.",
        ko="정적 연결을 보낸 시각입니다. 아무리 오래전에 보냈어도 정적 연결은 어느 시각에나 유효하므로 답을 제한하지 않습니다.",
    ),
)


OFF_THE_PATH = WrongStep(
    "off the path",
    {"lanes": "all"},
    Text(
        en="You counted base_link -> arm_link, an edge that the lookup does not walk. (It has the first of the names, and that is what `min` of the dict itself gives.) Which edges lie between map and laser_frame?",
        ko="조회가 지나지 않는 연결인 base_link -> arm_link까지 세었습니다. (dict 자체에 `min`을 쓰면 이름이 맨 앞인 이 연결이 나옵니다.) map과 laser_frame 사이에 있는 연결은 무엇입니까?",
    ),
)


TIME_ZERO = WrongAnswer(
    "time zero",
    0.0,
    Text(
        en="Zero is how the question is written: `Time()` is time zero, and tf2 reads it as a wish for the latest. The answer has a stamp of its own. Which?",
        ko="0은 시각이 아니라 ‘최신’을 뜻하는 약속입니다. `Time()`은 시각 0이고 tf2는 최신 변환을 달라는 뜻으로 읽습니다. 답에는 자기 시각이 붙어 있습니다. 몇 초입니까?",
    ),
    "M9",
)

MEAN = WrongStep(
    "mean",
    {"which": "mean"},
    Text(
        en="You took the mean of the newest samples. At that moment the slower lane has nothing to say yet.",
        ko="가장 새로운 표본들의 평균을 냈습니다. 그 순간 더 느린 시간줄에는 아직 값이 없습니다.",
    ),
)

AGE = WrongStep(
    "age",
    {"told": "age"},
    Text(
        en="That is how old the answer is. Asked for is the time at which it is.",
        ko="답이 얼마나 오래되었는지입니다. 답의 시각이 필요합니다.",
    ),
)


SPAN_OF_THE_COMMON_TIME = WrongAnswer(
    "span of the common time",
    lambda g: min(g.newest_s[edge] for edge in PATH) - max(g.oldest_s[edge] for edge in PATH),
    Text(
        en="That is how long both lanes have something to say together. Asked for is the end of that time.",
        ko="두 줄이 함께 값을 가진 시간의 길이입니다. 그 시간의 끝이 필요합니다.",
    ),
)


SPAN_OF_ONE_LANE = WrongAnswer(
    "span of one lane",
    lambda g: g.newest_s[PATH[0]] - g.oldest_s[PATH[0]],
    Text(
        en="That is how long one lane has something to say. Asked for is a moment, and of the whole path.",
        ko="한 줄에 값이 있는 시간의 길이입니다. 필요한 것은 경로 전체의 한 순간입니다.",
    ),
)


SPAN_OF_ALL = WrongAnswer(
    "span of all samples",
    lambda g: max(g.newest_s.values()) - min(g.oldest_s.values()),
    Text(
        en="That is how long the buffer's whole record is, from its oldest sample to its newest. Asked for is a moment, as the clock counts it, and no length of time.",
        ko="버퍼에 든 가장 오래된 표본부터 가장 새로운 표본까지의 길이입니다. 시간의 길이가 아니라 시계가 세는 한 순간이 필요합니다.",
    ),
)


COUNTED_FROM_THE_START = WrongAnswer(
    "counted from the start",
    lambda g: min(g.newest_s[edge] for edge in PATH) - min(g.oldest_s.values()),
    Text(
        en="That is counted from the oldest sample of all. A stamp is a time of the clock, and nothing is taken off it.",
        ko="가장 오래된 표본부터 센 값입니다. 측정 시각은 시계의 시각이므로 아무것도 빼지 않습니다.",
    ),
)


GAP_OF_THE_NEWEST = WrongAnswer(
    "gap of the newest",
    lambda g: abs(g.newest_s[PATH[0]] - g.newest_s[PATH[1]]),
    Text(
        en="That is how far apart the last samples of the two lanes are. Asked for is a moment, as the clock counts it.",
        ko="두 줄의 마지막 표본이 서로 얼마나 떨어져 있는지입니다. 시계가 세는 한 순간이 필요합니다.",
    ),
)


MIDDLE_OF_THE_COMMON_TIME = WrongAnswer(
    "middle of the common time",
    lambda g: (min(g.newest_s[edge] for edge in PATH) + max(g.oldest_s[edge] for edge in PATH)) / 2,
    Text(
        en="That is the middle of the time in which both lanes have something to say. `Time()` asks for something as new as possible: the end of it.",
        ko="두 줄이 함께 값을 가진 시간의 한가운데입니다. `Time()`은 될 수 있는 대로 새로운 것, 곧 그 시간의 끝을 묻습니다.",
    ),
)


AGE_OF_THE_NEWEST = WrongAnswer(
    "age of the newest",
    lambda g: g.clock_s - max(g.newest_s.values()),
    Text(
        en="That is how long ago the newest sample was taken. Asked for is a moment, and that of the whole path.",
        ko="가장 새로운 표본이 얼마나 오래되었는지입니다. 필요한 것은 경로 전체의 한 순간입니다.",
    ),
)


TASK = Task(
    id="E8.1",
    kind="N",
    points=2,
    title=Text(en="How fresh is latest?", ko="최신은 얼마나 새롭습니까?"),
    answer="latest_common_s",
    form=Number(unit="s", tolerance=0.005),
    given=lanes,
    variants=6,
    model=common,
    mistakes=(
        NEWEST_OF_ALL,
        NOW,
        COUNTING_THE_STATIC,
        OFF_THE_PATH,
        EARLIEST_START,
        OLDEST_OF_ALL,
        TIME_ZERO,
        MEAN,
        AGE,
        SPAN_OF_THE_COMMON_TIME,
        SPAN_OF_ONE_LANE,
        SPAN_OF_ALL,
        COUNTED_FROM_THE_START,
        AGE_OF_THE_NEWEST,
        MIDDLE_OF_THE_COMMON_TIME,
        GAP_OF_THE_NEWEST,
    ),
    hints=(
        Text(
            en="Draw one lane for each edge between map and laser_frame, and shade where all of them have data.",
            ko="map과 laser_frame 사이의 연결마다 시간줄을 하나씩 그리고, 모두 데이터가 있는 구간을 칠해 보십시오.",
        ),
        Text(
            en="Static lanes have no end, and lanes off the path do not matter. What is left?",
            ko="정적 연결의 시간줄에는 끝이 없고, 경로 밖의 시간줄은 상관없습니다. 무엇이 남습니까?",
        ),
        Text(
            en="It is the earliest of the latest ones: `min(...)` of the two `newest_s` on the path.",
            ko="마지막 시각들 가운데 가장 이른 것입니다. 경로에 있는 두 `newest_s`의 `min(...)`입니다.",
        ),
    ),
    misconceptions=("M9",),
)
