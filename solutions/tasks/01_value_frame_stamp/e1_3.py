"""E1.3: A reader that refuses."""

from __future__ import annotations

from tflab.core import seconds
from tflab.ros.time import Time
from tflab.workbook.tasks import Choice, Task, Twin, Words

from .draws import point

OPTIONS = ("use it", "no frame", "no stamp", "too old", "from the future")


def messages(rng):
    """Each verdict at least twice; ages across a full second, a nanosec below 0.1 s, both bounds and a hair beside."""
    second = int(rng.integers(20, 90))
    limit = float(rng.choice([0.5, 0.8, 1.2]))
    hair = 200_000
    limit_ns = seconds(limit)

    def row(frame, now_s, age_ns, x=2.0):
        now_ns = seconds(second) + seconds(now_s)
        return point(frame, now_ns - age_ns, x), Time(nanoseconds=now_ns), limit

    nothing = point("", 0, 1.0)
    return [
        row("laser_frame", 0.35, seconds(0.3)),  # nanosec below 0.1 s: 0.05
        row("camera_link", 0.15, seconds(0.2)),  # across a full second
        row("laser_frame", 0.5, limit_ns),
        row("laser_frame", 0.5, limit_ns - hair),
        row("laser_frame", 0.5, limit_ns + hair),
        row("map", 0.02, limit_ns + seconds(0.4)),
        row("laser_frame", 0.5, 0),
        row("laser_frame", 0.5, -hair),
        row("laser_frame", 0.5, -1),
        row("camera_link", 0.9, -seconds(limit + 0.4)),
        (point("laser_frame", 0, 1.0), Time(nanoseconds=seconds(second)), limit),
        (point("base_link", 0, 3.0), Time(nanoseconds=seconds(0.3)), limit),
        (point("base_link", 1, 3.0), Time(nanoseconds=seconds(0.3)), limit),  # a nanosecond is a stamp
        (nothing, Time(nanoseconds=seconds(second)), limit),
        row("", 0.4, seconds(0.1)),
        row("", 0.4, limit_ns + seconds(3.0)),
    ]


def age_of(message, now):
    return now.nanoseconds - Time.from_msg(message.header.stamp).nanoseconds


def verdict(message, now, max_age_s, age_ns=None, order="frame stamp future old", bound=True):
    """Return what a reader says that looks in this order."""
    age_ns = age_of(message, now) if age_ns is None else age_ns
    limit = seconds(max_age_s)
    says = {
        "frame": (not message.header.frame_id, "no frame"),
        "stamp": (Time.from_msg(message.header.stamp).nanoseconds == 0, "no stamp"),
        "future": (age_ns < 0, "from the future"),
        "old": (age_ns > limit if bound else age_ns >= limit, "too old"),
    }
    return next((says[look][1] for look in order.split() if says[look][0]), "use it")


def whole_seconds(message, now, max_age_s):
    return verdict(message, now, max_age_s, seconds(now.nanoseconds // 10**9 - message.header.stamp.sec))


def digits(message, now, max_age_s):
    written = float(f"{message.header.stamp.sec}.{message.header.stamp.nanosec}")
    return verdict(message, now, max_age_s, now.nanoseconds - seconds(written))


FRAME_ONLY = Twin(
    "frame only",
    lambda message, now, max_age_s: verdict(message, now, max_age_s, order="frame"),
    Words(
        en="You look at the frame alone. A stamp can be missing, too old, or later than now.",
        ko="좌표계만 봅니다. 측정 시각이 없거나, 너무 오래되었거나, 현재보다 나중일 수도 있습니다.",
    ),
    "M9",
)

NO_LOOK_AT_ZERO = Twin(
    "no look at zero",
    lambda message, now, max_age_s: verdict(message, now, max_age_s, order="frame future old"),
    Words(
        en="A stamp of zero is said to be too old, or even good. Zero means that nobody wrote a stamp: that is a fault of its own.",
        ko="0인 측정 시각을 오래된 것이나 쓸 수 있는 것으로 봅니다. 0은 아무도 측정 시각을 쓰지 않았다는 뜻이고, 따로 알려야 할 잘못입니다.",
    ),
    "M9",
)

NO_LOOK_AHEAD = Twin(
    "no look ahead",
    lambda message, now, max_age_s: verdict(message, now, max_age_s, order="frame stamp old"),
    Words(
        en="What was measured after now is used without a question. Two clocks disagree there, and somebody should hear of it.",
        ko="현재보다 나중에 측정했다는 메시지를 그냥 씁니다. 두 시계가 다르다는 뜻이므로 알려야 합니다.",
    ),
    "M10",
)

NO_LOOK_BACK = Twin(
    "no look back",
    lambda message, now, max_age_s: verdict(message, now, max_age_s, order="frame stamp future"),
    Words(
        en="Nothing is ever too old for you: compare the age with max_age_s.",
        ko="아무리 오래되어도 받아들입니다. 나이를 max_age_s와 비교해 보세요.",
    ),
)

AGE_WITHOUT_SIGN = Twin(
    "age without sign",
    lambda message, now, max_age_s: verdict(message, now, max_age_s, abs(age_of(message, now))),
    Words(
        en="abs() makes the future look like the past. An age below zero is a verdict of its own.",
        ko="abs()를 쓰면 미래가 과거처럼 보입니다. 0보다 작은 나이는 따로 판단해야 합니다.",
    ),
    "M10",
)

WHOLE_SECONDS = Twin(
    "whole seconds",
    whole_seconds,
    Words(
        en="The age comes from sec alone. 0.2 s across a full second looks like 1 s, and 0.9 s within one like nothing.",
        ko="sec만으로 나이를 계산합니다. 초가 바뀌는 사이의 0.2초는 1초로, 같은 초 안의 0.9초는 0초로 보입니다.",
    ),
)

DIGITS = Twin(
    "digits",
    digits,
    Words(
        en="You wrote nanosec behind a point, as digits. 50000000 ns is 0.05 s, not 0.5 s. `Time.from_msg(stamp).nanoseconds` has it right.",
        ko="nanosec을 소수점 뒤의 숫자로 그대로 썼습니다. 50000000 ns는 0.5초가 아니라 0.05초입니다. `Time.from_msg(stamp).nanoseconds`를 쓰면 됩니다.",
    ),
)

STAMP_BEFORE_FRAME = Twin(
    "stamp before frame",
    lambda message, now, max_age_s: verdict(message, now, max_age_s, order="stamp frame future old"),
    Words(
        en='Where frame and stamp are both missing you say "no stamp". The frame is to be looked at first.',
        ko="좌표계와 측정 시각이 둘 다 없을 때 “no stamp”라고 합니다. 좌표계를 먼저 봐야 합니다.",
    ),
)

TIME_BEFORE_FRAME = Twin(
    "time before frame",
    lambda message, now, max_age_s: verdict(message, now, max_age_s, order="stamp future old frame"),
    Words(
        en="A message without a frame is judged by its time first. Look at the frame before anything else.",
        ko="좌표계가 없는 메시지를 시각부터 판단합니다. 무엇보다 좌표계를 먼저 보십시오.",
    ),
)

OLD_BEFORE_ZERO = Twin(
    "old before zero",
    lambda message, now, max_age_s: verdict(message, now, max_age_s, order="frame future old stamp"),
    Words(
        en="You look at the age first, so a stamp that nobody wrote is called too old. Look for zero before you compute an age.",
        ko="나이부터 보므로, 아무도 쓰지 않은 측정 시각이 “too old”가 됩니다. 나이를 계산하기 전에 0인지 보십시오.",
    ),
    "M9",
)

ALREADY_AT_THE_BOUND = Twin(
    "already at the bound",
    lambda message, now, max_age_s: verdict(message, now, max_age_s, bound=False),
    Words(
        en="At exactly max_age_s you refuse. Older than that is too old; exactly that old is still good.",
        ko="나이가 딱 max_age_s일 때 거절합니다. 그보다 오래된 것만 거절하고, 딱 그만큼은 아직 쓸 수 있습니다.",
    ),
)


TASK = Task(
    id="E1.3",
    kind="F",
    points=4,
    title=Words(en="A reader that refuses", ko="거절할 줄 아는 노드"),
    answer="judge",
    form=Choice(OPTIONS),
    inputs=messages,
    variants=3,
    twins=(
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
    ),
    hints=(
        Words(
            en="`Time.from_msg(message.header.stamp).nanoseconds` and `now.nanoseconds` are whole numbers that may be subtracted.",
            ko="`Time.from_msg(message.header.stamp).nanoseconds`와 `now.nanoseconds`는 뺄 수 있는 정수입니다.",
        ),
        Words(
            en="One `if … return` for each line of the list, in the order of the list.",
            ko="목록의 한 줄마다 `if … return` 하나를, 목록의 순서대로 쓰면 됩니다.",
        ),
        Words(
            en="Age = now − stamp, in nanoseconds. Below zero: the future. Above `max_age_s * 1e9`: too old.",
            ko="나이 = now − 측정 시각(나노초)입니다. 0보다 작으면 미래, `max_age_s * 1e9`보다 크면 너무 오래된 것입니다.",
        ),
    ),
    cures=("M9", "M10"),
    equivalent={
        "round(max_age_s * 1000000000.0) -> max_age_s * 1000000000.0": "whole nanoseconds compare alike with both",
    },
)
