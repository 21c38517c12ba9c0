"""E1.3: A reader that refuses."""

from __future__ import annotations

from tflab.core import seconds
from tflab.ros.time import Time
from tflab.workbook.tasks import Choice, Task, Text, WrongStep

from .draws import clock, point

OPTIONS = ("use it", "no frame", "no stamp", "too old", "from the future")


def messages(rng):
    """Each verdict twice or more; ages across a full second, a nanosec below 0.1 s, both bounds and a hair beside."""
    second = int(rng.integers(20, 90))
    limit = float(rng.choice([1.2, 1.5, 1.8]))
    hair = 200_000
    limit_ns = seconds(limit)

    def row(frame, now_s, age_ns, x=2.0):
        now_ns = seconds(second) + seconds(now_s)
        return point(frame, now_ns - age_ns, x), clock(now_ns), limit

    nothing = point("", 0, 1.0)
    return [
        row("laser_frame", 0.35, seconds(0.3)),  # nanosec below 0.1 s: 0.05
        row("camera_link", 0.15, seconds(0.2)),  # across a full second
        # just that old; of floats too, for halves have no last digit to lose
        (*row("laser_frame", 0.5, seconds(1.5))[:2], 1.5),
        row("laser_frame", 0.5, limit_ns - hair),
        row("laser_frame", 0.5, limit_ns + hair),
        row("map", 0.02, limit_ns + seconds(0.4)),
        row("laser_frame", 0.98, limit_ns + seconds(0.15)),  # too old, and too few full seconds
        row("laser_frame", 0.05 + limit + 0.1, limit_ns + seconds(0.1)),  # too old only if 50000000 ns is 0.05 s
        row("laser_frame", 0.5, 0),
        row("laser_frame", 0.5, hair),
        row("laser_frame", 0.25, seconds(0.25)),  # a whole second: nanosec is 0
        row("laser_frame", 0.5, -hair),
        row("laser_frame", 0.5, -1),
        row("camera_link", 0.9, -seconds(limit + 0.4)),
        (*row("laser_frame", 0.5, seconds(1.0))[:2], 1.0),  # a limit of whole seconds, and just that old
        (point("laser_frame", 0, 1.0), clock(seconds(second)), limit),
        (point("base_link", 0, 3.0), clock(seconds(0.3)), limit),
        (point("base_link", 1, 3.0), clock(seconds(0.3)), limit),  # a nanosecond is a stamp
        (nothing, clock(seconds(second)), limit),
        row("", 0.4, seconds(0.1)),
        row("", 0.4, limit_ns + seconds(3.0)),
    ]


def age_s(message, now, age):
    """Return the age [s], or what becomes of it."""
    stamp = message.header.stamp
    right = (now.nanoseconds - Time.from_msg(stamp).nanoseconds) / 1e9
    return {
        "right": right,
        "sec alone": float(now.nanoseconds // 10**9 - stamp.sec),
        "nanosec alone": (now.nanoseconds - stamp.nanosec) / 1e9,
        "digits": now.nanoseconds / 1e9 - float(f"{stamp.sec}.{stamp.nanosec}"),
        "without sign": abs(right),
        "stamp minus now": -right,
        "milliseconds": right * 1e3,
        "nanoseconds": right * 1e9,
        "nanosec by a million": float(now.nanoseconds // 10**9 - stamp.sec)
        + (now.nanoseconds % 10**9 - stamp.nanosec) / 1e6,
        "tenths": round(right, 1),
        "stamp by a million": now.nanoseconds / 1e9 - stamp.sec - stamp.nanosec / 1e6,
        "stamp in nanoseconds": now.nanoseconds / 1e9 - (stamp.sec * 10**9 + stamp.nanosec),
        "now in nanoseconds": now.nanoseconds - (stamp.sec + stamp.nanosec / 1e9),
        "stamp cut": now.nanoseconds / 1e9 - stamp.sec,
        "nanosec as it is": now.nanoseconds // 10**9 + now.nanoseconds % 10**9 - stamp.sec - stamp.nanosec,
        "now cut": now.nanoseconds // 10**9 - (stamp.sec + stamp.nanosec / 1e9),
    }[age]


def verdict(
    message,
    now,
    max_age_s,
    *,
    looks="frame stamp future old",
    zero="both",
    age="right",
    old_by="right",
    ahead="after now",
    bound="older",
    limit="as given",
):
    """Return what a reader says, step by step; other steps are the slips."""
    stamp = message.header.stamp
    old_s = age_s(message, now, age)
    apart_s = old_s if old_by == "right" else age_s(message, now, old_by)
    max_age_s = {"as given": max_age_s, "whole": float(int(max_age_s))}[limit]
    early_s = round(apart_s - max_age_s, 10)  # what floats make of it is no slip
    says = {
        "frame": (not message.header.frame_id, "no frame"),
        "stamp": (
            {
                "both": not (stamp.sec or stamp.nanosec),
                "sec": not stamp.sec,
                "nanosec": not stamp.nanosec,
                "either": not (stamp.sec and stamp.nanosec),
            }[zero],
            "no stamp",
        ),
        "future": ({"after now": old_s < 0, "now, too": old_s <= 0, "a tenth": old_s < -0.1}[ahead], "from the future"),
        "young": (early_s < 0, "too old"),
        "far": (round(abs(old_s) - max_age_s, 10) > 0, "too old"),
        "old": (early_s > 0 if bound == "older" else early_s >= 0, "too old"),
    }
    return next((says[look][1] for look in looks.split() if says[look][0]), "use it")


FRAME_ONLY = WrongStep(
    "frame only",
    {"looks": "frame"},
    Text(
        en="Nothing but a missing frame makes you refuse. A stamp can be missing, too old, or later than now.",
        ko="거절하는 것은 좌표계가 없을 때뿐입니다. 측정 시각이 없거나, 너무 오래되었거나, 현재보다 나중일 수도 있습니다.",
    ),
    "M9",
)

NO_LOOK_AT_ZERO = WrongStep(
    "no look at zero",
    {"looks": "frame future old"},
    Text(
        en="A stamp of zero is said to be too old, or even good. Zero means that nobody wrote a stamp: that is a fault of its own. `not header.stamp` does not find it, for an object is always true: look at its sec and nanosec.",
        ko="0인 측정 시각을 오래된 것이나 쓸 수 있는 것으로 봅니다. 0은 아무도 측정 시각을 쓰지 않았다는 뜻이고, 따로 알려야 할 잘못입니다. 객체는 언제나 참이므로 `not header.stamp`로는 찾지 못합니다. sec와 nanosec을 보세요.",
    ),
    "M9",
)

NO_LOOK_AHEAD = WrongStep(
    "no look ahead",
    {"looks": "frame stamp old"},
    Text(
        en="What was measured after now is used without a question. Two clocks disagree there, and somebody should hear of it.",
        ko="현재보다 나중에 측정했다는 메시지를 그냥 씁니다. 두 시계가 다르다는 뜻이므로 알려야 합니다.",
    ),
    "M10",
)

NO_LOOK_BACK = WrongStep(
    "no look back",
    {"looks": "frame stamp future"},
    Text(
        en="Nothing is ever too old for you: compare the age with max_age_s, and both in one unit.",
        ko="아무리 오래되어도 받아들입니다. 나이를 max_age_s와 같은 단위로 비교하십시오.",
    ),
)

AGE_WITHOUT_SIGN = WrongStep(
    "age without sign",
    {"age": "without sign"},
    Text(
        en="The future is judged like the past, as with abs() or with the larger time minus the smaller. An age below zero is a verdict of its own.",
        ko="미래를 과거처럼 판정합니다. abs()를 쓰거나 큰 시각에서 작은 시각을 빼면 이렇게 됩니다. 0보다 작은 나이는 따로 판단해야 합니다.",
    ),
    "M10",
)

WHOLE_SECONDS = WrongStep(
    "whole seconds",
    {"age": "sec alone"},
    Text(
        en="The age comes from sec alone. 0.2 s across a full second looks like 1 s, and 0.9 s within one like nothing.",
        ko="sec만으로 나이를 계산합니다. 초가 바뀌는 사이의 0.2초는 1초로, 같은 초 안의 0.9초는 0초로 보입니다.",
    ),
)

DIGITS = WrongStep(
    "digits",
    {"age": "digits"},
    Text(
        en="You wrote nanosec behind a point, as digits. 50000000 ns is 0.05 s, not 0.5 s. `Time.from_msg(stamp).nanoseconds` has it right.",
        ko="nanosec을 소수점 뒤의 숫자로 그대로 썼습니다. 50000000 ns는 0.5초가 아니라 0.05초입니다. `Time.from_msg(stamp).nanoseconds`를 쓰면 됩니다.",
    ),
)

STAMP_BEFORE_FRAME = WrongStep(
    "stamp before frame",
    {"looks": "stamp frame future old"},
    Text(
        en='Where frame and stamp are both missing you say "no stamp". The frame is to be looked at first.',
        ko="좌표계와 측정 시각이 둘 다 없을 때 “no stamp”라고 합니다. 좌표계를 먼저 봐야 합니다.",
    ),
)

TIME_BEFORE_FRAME = WrongStep(
    "time before frame",
    {"looks": "stamp future old frame"},
    Text(
        en="A message without a frame is judged by its time first. Look at the frame before anything else.",
        ko="좌표계가 없는 메시지를 시각부터 판단합니다. 무엇보다 좌표계를 먼저 보십시오.",
    ),
)

OLD_BEFORE_ZERO = WrongStep(
    "old before zero",
    {"looks": "frame future old stamp"},
    Text(
        en="You look at the age first, so a stamp that nobody wrote is called too old. Look for zero before you compute an age.",
        ko="나이부터 보므로, 아무도 쓰지 않은 측정 시각이 “too old”가 됩니다. 나이를 계산하기 전에 0인지 보십시오.",
    ),
    "M9",
)

ALREADY_AT_THE_BOUND = WrongStep(
    "already at the bound",
    {"bound": "from it on"},
    Text(
        en="At exactly max_age_s you refuse: there stands `>=`, or the difference of two floats lies a hair above it (whole nanoseconds have no such hair). Exactly that old is still good.",
        ko="나이가 딱 max_age_s일 때 거절합니다. `>=`로 비교했거나, 실수끼리 뺀 값이 미세하게 커진 것입니다(나노초 정수로 빼면 그런 일이 없습니다). 딱 그만큼은 아직 쓸 수 있습니다.",
    ),
)

SEC_FOR_ZERO = WrongStep(
    "sec for zero",
    {"zero": "sec"},
    Text(
        en="You take a stamp for zero when its sec is 0. A simulation starts at 0 s: a stamp is missing only where nanosec is 0, too.",
        ko="sec만 0이면 측정 시각이 없다고 봅니다. 시뮬레이션은 0초에서 시작합니다. nanosec까지 0일 때만 없는 것입니다.",
    ),
)

NANOSEC_FOR_ZERO = WrongStep(
    "nanosec for zero",
    {"zero": "nanosec"},
    Text(
        en="You take a stamp for zero when its nanosec is 0. At each full second it is: look at sec, too.",
        ko="nanosec만 0이면 측정 시각이 없다고 봅니다. 정각 초마다 그렇게 됩니다. sec도 보십시오.",
    ),
)

TURNED_ROUND = WrongStep(
    "turned round",
    {"age": "stamp minus now"},
    Text(
        en="Your age has the other sign, as stamp minus now has: what is old looks like the future, and the future like something old.",
        ko="측정 시각에서 현재를 뺀 것처럼 나이의 부호가 반대입니다. 오래된 것이 미래처럼, 미래가 오래된 것처럼 보입니다.",
    ),
    "M10",
)

AGE_IN_MS = WrongStep(
    "age in milliseconds",
    {"age": "milliseconds"},
    Text(
        en="Beside max_age_s the age is a thousand times too large, as milliseconds are beside seconds: bring both to one unit before you compare.",
        ko="max_age_s에 비해 나이가 천 배 큽니다. 나이는 밀리초, max_age_s는 초일 때 이렇게 됩니다. 비교하기 전에 단위를 맞추십시오.",
    ),
)

AGE_IN_NS = WrongStep(
    "age in nanoseconds",
    {"age": "nanoseconds"},
    Text(
        en="Beside max_age_s the age is far too large, as nanoseconds are beside seconds: bring both to one unit before you compare.",
        ko="max_age_s에 비해 나이가 너무 큽니다. 나이는 나노초, max_age_s는 초일 때 이렇게 됩니다. 비교하기 전에 단위를 맞추십시오.",
    ),
)

BY_A_MILLION = WrongStep(
    "nanosec by a million",
    {"age": "nanosec by a million"},
    Text(
        en="You divided nanosec by a million. A second has a thousand million of them: 1e9.",
        ko="nanosec을 100만으로 나누었습니다. 1초는 10억, 곧 1e9 나노초입니다.",
    ),
)

TENTHS = WrongStep(
    "tenths",
    {"age": "tenths"},
    Text(
        en="You rounded the age before comparing it: a hair over the limit, and a hair before now, are lost.",
        ko="나이를 반올림한 뒤에 비교했습니다. 한계를 살짝 넘은 것과 현재보다 조금 늦은(미래의) 것을 놓칩니다.",
    ),
)

NOW_IS_THE_FUTURE = WrongStep(
    "now is the future",
    {"ahead": "now, too"},
    Text(
        en="What was measured exactly now is said to be from the future. Its age is 0, and that is not below zero.",
        ko="바로 지금 측정한 것을 미래라고 합니다. 나이가 0이며, 0보다 작지 않습니다.",
    ),
)

A_TENTH_AHEAD = WrongStep(
    "a tenth ahead",
    {"ahead": "a tenth"},
    Text(
        en="You let the near future pass. Asked for is every stamp after now, even by a nanosecond.",
        ko="가까운 미래를 그냥 통과시킵니다. 1나노초라도 현재보다 나중이면 미래입니다.",
    ),
    "M10",
)

FAR_BEFORE_THE_SIGN = WrongStep(
    "far before the sign",
    {"looks": "frame stamp far future"},
    Text(
        en="What lies far in the future is called too old: you compare the size of the age with the limit before you look at its sign.",
        ko="먼 미래의 것을 너무 오래되었다고 합니다. 부호를 보기 전에 나이의 크기부터 한계와 비교합니다.",
    ),
    "M10",
)

OLD_FOR_YOUNG = WrongStep(
    "old for young",
    {"looks": "frame stamp future young"},
    Text(
        en="The comparison is the wrong way round: what is young enough is called too old, and what is too old is used.",
        ko="비교의 방향이 반대입니다. 충분히 새로운 것을 너무 오래되었다고 하고, 너무 오래된 것을 씁니다.",
    ),
)

LIMIT_CUT = WrongStep(
    "limit cut",
    {"limit": "whole"},
    Text(
        en="The limit lost its digits behind the point: of max_age_s you keep whole seconds alone.",
        ko="한계의 소수 부분을 잃었습니다. max_age_s에서 초의 정수 부분만 남깁니다.",
    ),
)


STAMP_FAR_TOO_LARGE = WrongStep(
    "stamp not by 1e9",
    {"age": "stamp by a million"},
    Text(
        en="The stamp comes out far too late: its nanosec is divided by too little, or not at all. A second has a thousand million of them: sec + nanosec / 1e9.",
        ko="측정 시각이 훨씬 늦게 나옵니다. nanosec을 너무 작은 수로 나누었거나 나누지 않았습니다. 1초는 10억 나노초이므로 sec + nanosec / 1e9입니다.",
    ),
)


STAMP_IN_NANOSECONDS = WrongStep(
    "stamp in nanoseconds",
    {"age": "stamp in nanoseconds"},
    Text(
        en="The stamp is in nanoseconds and now in seconds, so every stamp looks like the future: bring both to one unit.",
        ko="측정 시각은 나노초, 현재는 초라서 모든 측정 시각이 미래로 보입니다. 둘을 같은 단위로 맞추십시오.",
    ),
)


NOW_IN_NANOSECONDS = WrongStep(
    "now in nanoseconds",
    {"age": "now in nanoseconds"},
    Text(
        en="Every stamp looks far too old to you: now goes in as nanoseconds, and what you take off it is much less, seconds or nanosec alone. Bring both to one unit, as `Time.from_msg(stamp).nanoseconds` and `now.nanoseconds` are.",
        ko="모든 측정 시각이 너무 오래된 것으로 보입니다. 현재는 나노초인데 거기서 뺀 것은 초이거나 nanosec뿐이라 훨씬 작습니다. `Time.from_msg(stamp).nanoseconds`와 `now.nanoseconds`처럼 둘을 같은 단위로 맞추십시오.",
    ),
)


NOW_IN_WHOLE_SECONDS = WrongStep(
    "now in whole seconds",
    {"age": "now cut"},
    Text(
        en="Of now you keep whole seconds alone, and of the stamp all: what was measured within this second looks like the future.",
        ko="현재 시각은 초만 남기고 측정 시각은 모두 썼습니다. 이번 1초 안에 잰 것이 미래로 보입니다.",
    ),
)


NO_LOOK_AT_THE_FRAME = WrongStep(
    "no look at the frame",
    {"looks": "stamp future old"},
    Text(
        en='A message without a frame is judged as if it had one. A missing frame is the empty text, `""`: `is None` does not find it, `not frame_id` does.',
        ko='좌표계가 없는 메시지를 있는 것처럼 판정합니다. 없는 좌표계는 빈 문자열 `""`입니다. `is None`으로는 찾지 못하고, `not frame_id`로 찾습니다.',
    ),
)


EITHER_FOR_ZERO = WrongStep(
    "either for zero",
    {"zero": "either"},
    Text(
        en="You take a stamp for missing when sec *or* nanosec is 0. It is missing only where both are: at each full second nanosec is 0, and at the start of a simulation sec.",
        ko="sec *또는* nanosec이 0이면 측정 시각이 없다고 합니다. 둘 다 0일 때만 없는 것입니다. 정각에는 nanosec이 0이고, 시뮬레이션이 시작될 때는 sec이 0입니다.",
    ),
    "M9",
)


STAMP_IN_WHOLE_SECONDS = WrongStep(
    "stamp in whole seconds",
    {"age": "stamp cut"},
    Text(
        en="Of the stamp you keep whole seconds alone, and of now all: what is measured looks older than it is, by up to a second. nanosec is a part of the stamp.",
        ko="측정 시각에서는 초만, now에서는 전부를 썼습니다. 측정값이 실제보다 최대 1초까지 더 오래되어 보입니다. nanosec도 측정 시각의 일부입니다.",
    ),
)


NANOSEC_AS_IT_IS = WrongStep(
    "nanosec as it is",
    {"age": "nanosec as it is"},
    Text(
        en="You add nanosec to the seconds as it is. It is a number of nanoseconds: divide it by 1e9 first.",
        ko="나노초를 그대로 초에 더했습니다. 나노초이므로 먼저 1e9로 나누십시오.",
    ),
)


STAMP_BY_NANOSEC_ALONE = WrongStep(
    "stamp by nanosec alone",
    {"age": "nanosec alone"},
    Text(
        en="Of the stamp only nanosec counts for you, which begins anew with each second: its sec is missing. `Time.from_msg(stamp).nanoseconds` has both.",
        ko="측정 시각에서 nanosec만 썼습니다. nanosec은 초마다 0부터 다시 셉니다. sec이 빠졌습니다. `Time.from_msg(stamp).nanoseconds`에는 둘 다 들어 있습니다.",
    ),
)


OLD_BY_WHOLE_SECONDS = WrongStep(
    "old by whole seconds",
    {"old_by": "sec alone"},
    Text(
        en="The future you tell rightly, but what is too old comes out as if by sec alone: 0.2 s across a full second counts as 1 s, and so may 1.9 s. The nanoseconds are a part of the age.",
        ko="미래는 바르게 가려내지만, 너무 오래되었는지는 sec만 본 것처럼 나옵니다. 초가 바뀌는 사이의 0.2초는 1초가 되고, 1.9초도 1초가 될 수 있습니다. 나노초도 나이의 일부입니다.",
    ),
)


TASK = Task(
    id="E1.3",
    kind="F",
    points=4,
    title=Text(en="A reader that refuses", ko="거절할 줄 아는 노드"),
    answer="judge",
    form=Choice(OPTIONS),
    inputs=messages,
    variants=3,
    model=verdict,
    mistakes=(
        FRAME_ONLY,
        NO_LOOK_AT_ZERO,
        NO_LOOK_AHEAD,
        NO_LOOK_BACK,
        AGE_WITHOUT_SIGN,
        WHOLE_SECONDS,
        DIGITS,
        STAMP_BEFORE_FRAME,
        TIME_BEFORE_FRAME,
        OLD_BEFORE_ZERO,
        ALREADY_AT_THE_BOUND,
        SEC_FOR_ZERO,
        NANOSEC_FOR_ZERO,
        TURNED_ROUND,
        AGE_IN_MS,
        AGE_IN_NS,
        BY_A_MILLION,
        TENTHS,
        NOW_IS_THE_FUTURE,
        A_TENTH_AHEAD,
        FAR_BEFORE_THE_SIGN,
        OLD_FOR_YOUNG,
        LIMIT_CUT,
        STAMP_FAR_TOO_LARGE,
        STAMP_IN_NANOSECONDS,
        NOW_IN_NANOSECONDS,
        NOW_IN_WHOLE_SECONDS,
        NO_LOOK_AT_THE_FRAME,
        EITHER_FOR_ZERO,
        STAMP_IN_WHOLE_SECONDS,
        NANOSEC_AS_IT_IS,
        STAMP_BY_NANOSEC_ALONE,
        OLD_BY_WHOLE_SECONDS,
    ),
    hints=(
        Text(
            en="`Time.from_msg(message.header.stamp).nanoseconds` and `now.nanoseconds` are whole numbers that may be subtracted.",
            ko="`Time.from_msg(message.header.stamp).nanoseconds`와 `now.nanoseconds`는 뺄 수 있는 정수입니다.",
        ),
        Text(
            en="One `if … return` for each line of the list, in the order of the list.",
            ko="목록의 한 줄마다 `if … return` 하나를, 목록의 순서대로 쓰면 됩니다.",
        ),
        Text(
            en="Age = now − stamp, in nanoseconds. Below zero: the future. Above `max_age_s * 1e9`: too old.",
            ko="나이 = now − 측정 시각(나노초)입니다. 0보다 작으면 미래, `max_age_s * 1e9`보다 크면 너무 오래된 것입니다.",
        ),
    ),
    misconceptions=("M9", "M10"),
    equivalent={
        "round(max_age_s * 1000000000.0) -> max_age_s * 1000000000.0": "whole nanoseconds compare alike with both",
    },
)
