"""E1.4: How far ahead by now?"""

from __future__ import annotations

from tflab.workbook.tasks import Number, Parts, Task, Twin, Words


def a_late_message(rng):
    """The stamp's nanosec is below 0.1 s, the arrival is in the same second or the next."""
    sec = int(rng.integers(11, 95))
    stamp_ms = int(rng.integers(12, 96))
    age_ms = int(rng.integers(150, 480)) + (1000 if rng.random() < 0.3 else 0)
    arrived_ms = stamp_ms + age_ms
    return {
        "stamp": [sec, stamp_ms * 1_000_000],
        "arrived": [sec + arrived_ms // 1000, arrived_ms % 1000 * 1_000_000],
        "speed_mps": round(float(rng.uniform(0.6, 1.6)), 2),
        "ahead_m": round(float(rng.uniform(3.0, 7.0)), 2),
    }


def seconds_of(stamp):
    return stamp[0] + stamp[1] / 1e9


def as_digits(stamp):
    return float(f"{stamp[0]}.{stamp[1]}")


def answer(given, age_s, way=-1.0, scale=1.0):
    return {"age_s": age_s * scale, "ahead_m": given.ahead_m + way * given.speed_mps * age_s * scale}


def age(given):
    return seconds_of(given.arrived) - seconds_of(given.stamp)


LEFT_AS_IT_WAS = Twin(
    "left as it was",
    lambda g: answer(g, age(g), way=0.0),
    Words(
        en="The age is right, and the distance is that of the stamp. The robot went on driving while the message was on its way.",
        ko="나이는 맞지만 거리는 측정 시각의 것입니다. 메시지가 오는 동안에도 로봇은 계속 달렸습니다.",
    ),
    "M9",
)

FARTHER = Twin(
    "farther",
    lambda g: answer(g, age(g), way=1.0),
    Words(
        en="You let the post come farther away. The robot drives towards it: each moment there is less in between.",
        ko="기둥이 더 멀어졌습니다. 로봇은 기둥 쪽으로 달리므로 남은 거리는 줄어듭니다.",
    ),
)

DIGITS = Twin(
    "digits",
    lambda g: answer(g, as_digits(g.arrived) - as_digits(g.stamp)),
    Words(
        en="You wrote nanosec behind a point, as digits. 58000000 ns is 0.058 s, not 0.58 s: divide by 1e9.",
        ko="nanosec을 소수점 뒤의 숫자로 그대로 썼습니다. 58000000 ns는 0.58초가 아니라 0.058초입니다. 1e9로 나누십시오.",
    ),
)

MILLISECONDS = Twin(
    "milliseconds",
    lambda g: answer(g, age(g), scale=1000.0),
    Words(
        en="The age is in milliseconds. Asked for are seconds, and the speed is per second, too.",
        ko="나이가 밀리초 단위입니다. 초로 답해야 하고, 속도도 초당입니다.",
    ),
)

AGE_IN_MILLISECONDS = Twin(
    "age in milliseconds",
    lambda g: {**answer(g, age(g)), "age_s": age(g) * 1000.0},
    Words(
        en="The distance is right; the age is written in milliseconds, and asked for are seconds.",
        ko="거리는 맞습니다. 나이를 밀리초로 썼는데, 초로 답해야 합니다.",
    ),
)

SEC_ALONE = Twin(
    "sec alone",
    lambda g: answer(g, float(g.arrived[0] - g.stamp[0])),
    Words(
        en="Only sec went into the age. The nanoseconds are a part of it, too.",
        ko="나이에 sec만 들어갔습니다. 나노초도 함께 계산해야 합니다.",
    ),
)


BACKWARDS = Twin(
    "backwards",
    lambda g: answer(g, -age(g)),
    Words(
        en="Stamp minus arrival: an age below zero. It was measured first, and arrived later.",
        ko="측정 시각에서 도착 시각을 뺐습니다. 나이가 0보다 작을 수는 없습니다. 먼저 측정하고 나중에 도착했습니다.",
    ),
)


TASK = Task(
    id="E1.4",
    kind="N",
    points=3,
    title=Words(en="How far ahead by now?", ko="지금은 몇 미터 앞입니까?"),
    answer="on_arrival",
    form=Parts({"age_s": Number(unit="s", tolerance=0.0005), "ahead_m": Number(unit="m", tolerance=0.003)}),
    given=a_late_message,
    variants=6,
    twins=(
        LEFT_AS_IT_WAS,
        FARTHER,
        DIGITS,
        MILLISECONDS,
        AGE_IN_MILLISECONDS,
        BACKWARDS,
        SEC_ALONE,
    ),
    hints=(
        Words(
            en="Turn both moments into seconds first: sec + nanosec / 1e9.",
            ko="먼저 두 시각을 초로 바꾸십시오. sec + nanosec / 1e9입니다.",
        ),
        Words(en="Age is arrival minus stamp.", ko="나이는 도착한 시각에서 측정 시각을 뺀 것입니다."),
        Words(
            en="The robot has come speed × age closer.",
            ko="로봇은 속도 × 나이만큼 더 가까이 갔습니다.",
        ),
    ),
    cures=("M9",),
)
