"""E8.4: How far off?"""

from __future__ import annotations

import math

from tflab.workbook.tasks import Number, Parts, Task, Twin, Words


def motion(rng):
    way = float(rng.choice([-1.0, 1.0]))
    speed_mps = float(rng.uniform(0.6, 1.8))
    yaw_rate_degps = way * float(rng.uniform(15.0, 40.0))
    range_m = float(rng.uniform(3.0, 8.0))
    if abs(speed_mps - range_m * math.radians(abs(yaw_rate_degps))) < 0.15:  # the two pieces must not look alike
        speed_mps += 0.3
    return {
        "speed_mps": round(speed_mps, 2),
        "yaw_rate_degps": round(yaw_rate_degps, 1),
        "range_m": round(range_m, 1),
        "delay_ms": float(rng.integers(8, 25) * 10),
    }


def _late(given, forwards=1.0, left=1.0, together=None, degrees=False, delay=1e-3):
    delay_s = given.delay_ms * delay
    yaw_rate = given.yaw_rate_degps if degrees else math.radians(given.yaw_rate_degps)
    forwards_m = forwards * given.speed_mps * delay_s
    left_m = left * given.range_m * yaw_rate * delay_s
    length = math.hypot(forwards_m, left_m) if together is None else together(forwards_m, left_m)
    return {"forwards_m": forwards_m, "left_m": left_m, "together_m": length}


SPEED_ONLY = Twin(
    "speed only",
    lambda g: _late(g, left=0.0),
    Words(
        en="You left out the turn. The pose of now looks another way, and drags the object along sideways: the more, the farther it is.",
        ko="회전을 빠뜨렸습니다. 지금의 자세는 다른 쪽을 보고 있어 물체를 옆으로 끌고 갑니다. 멀리 있을수록 더 그렇습니다.",
    ),
    "M9",
)


DEGREES = Twin(
    "degrees",
    lambda g: _late(g, degrees=True),
    Words(
        en="The yaw rate went in as degrees per second. Arc = range × angle holds for radians.",
        ko="각속도를 초당 도 단위 그대로 넣었습니다. 호 = 거리 × 각도는 라디안일 때 맞습니다.",
    ),
    "M5",
)


WRONG_SIDE = Twin(
    "wrong side",
    lambda g: _late(g, left=-1.0),
    Words(
        en="The wrong side. If the robot has turned left meanwhile, its straight ahead points further left, and so does the old sight.",
        ko="반대쪽입니다. 그사이 로봇이 왼쪽으로 돌았다면 정면이 더 왼쪽을 가리키고, 옛 관측도 왼쪽으로 갑니다.",
    ),
)


ADDED = Twin(
    "added",
    lambda g: _late(g, together=lambda f, s: abs(f) + abs(s)),
    Words(
        en="The two pieces are at right angles: their lengths do not simply add up.",
        ko="두 조각은 서로 직각입니다. 길이를 그냥 더하지 않습니다.",
    ),
)


MILLISECONDS = Twin(
    "milliseconds",
    lambda g: _late(g, delay=1.0),
    Words(
        en="The delay went in as milliseconds. Speeds are per second.",
        ko="지연을 밀리초 그대로 넣었습니다. 속도는 초당입니다.",
    ),
)


WITHOUT_THE_RANGE = Twin(
    "without the range",
    lambda g: _late(g, left=1.0 / g.range_m),
    Words(
        en="Yaw rate × delay is the angle only. How long is the arc that it cuts off at the object's distance?",
        ko="각속도 × 지연은 각도일 뿐입니다. 물체까지의 거리에서 그 각도는 얼마나 긴 호가 됩니까?",
    ),
)


def _crosswise(given):
    right = _late(given)
    return {**right, "forwards_m": right["left_m"], "left_m": right["forwards_m"]}


CROSSWISE = Twin(
    "crosswise",
    _crosswise,
    Words(
        en="The two pieces have changed places. Driving pushes the point forwards, turning drags it to the side.",
        ko="두 조각이 자리를 바꾸었습니다. 주행은 점을 앞으로 밀고, 회전은 옆으로 끌고 갑니다.",
    ),
)


TASK = Task(
    id="E8.4",
    kind="N",
    points=3,
    title=Words(en="How far off?", ko="얼마나 빗나갑니까?"),
    answer="late_error",
    form=Parts(
        {name: Number(unit="m", tolerance=0.003) for name in ("forwards_m", "left_m", "together_m")},
    ),
    given=motion,
    variants=6,
    twins=(
        SPEED_ONLY,
        DEGREES,
        WRONG_SIDE,
        ADDED,
        MILLISECONDS,
        WITHOUT_THE_RANGE,
        CROSSWISE,
    ),
    hints=(
        Words(
            en="First bring everything to seconds, metres and radians.",
            ko="먼저 모두 초, m, rad로 바꾸십시오.",
        ),
        Words(
            en="Forwards comes from driving, left from turning. Positive yaw turns to the left.",
            ko="앞뒤는 주행에서, 좌우는 회전에서 옵니다. 양의 yaw는 왼쪽으로 도는 것입니다.",
        ),
        Words(
            en="speed × delay, range × yaw rate × delay, and `math.hypot` of the two.",
            ko="속도 × 지연, 거리 × 각속도 × 지연, 그리고 둘의 `math.hypot`입니다.",
        ),
    ),
    cures=("M9", "M5"),
)
