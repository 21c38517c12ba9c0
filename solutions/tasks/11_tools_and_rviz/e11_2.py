"""E11.2: Two readings of tf2_echo."""

from __future__ import annotations

import math
import re

from tflab.core import StampedTransform, Transform, seconds
from tflab.tools.tf2_echo import echo_text
from tflab.workbook.tasks import Number, Parts, Slip, Task, Twin, Words

NUMBER = re.compile(r"-?\d+\.\d+")


def two_readings(rng):
    """A robot in a bend; the second stamp has lost a zero, the first has not; the pose turns past no half turn."""
    sec = int(rng.integers(20, 60))
    first_s = sec + round(float(rng.uniform(0.80, 0.95)), 2)
    second_s = sec + 2 + round(float(rng.uniform(0.02, 0.09)), 2)
    speed, way = float(rng.uniform(0.4, 0.9)), float(rng.choice([-1.0, 1.0]))
    rate, yaw = way * float(rng.uniform(0.3, 0.7)), float(rng.uniform(0.7, 1.0)) * float(rng.choice([-1.0, 1.0]))
    x, y, t = float(rng.uniform(1.0, 3.0)), float(rng.uniform(-2.0, 2.0)), second_s - first_s
    step = Transform.from_rpy(
        yaw=rate * t, translation=(speed / rate * math.sin(rate * t), speed / rate * (1 - math.cos(rate * t)), 0.0)
    )
    start = Transform.from_rpy(yaw=yaw, translation=(x, y, 0.0))
    return {
        name: echo_text(StampedTransform("map", "base_link", seconds(at_s), pose))
        for name, at_s, pose in (("first", first_s, start), ("second", second_s, start @ step))
    }


def parts_of(block):
    rows = block.splitlines()
    sec, nanosec = rows[0].removeprefix("At time ").split(".")
    (x, y, _), (_, _, radians), (_, _, degrees) = (map(float, NUMBER.findall(rows[i])) for i in (1, 3, 4))
    return sec, nanosec, x, y, radians, degrees


def read(given, *, zeros="nanoseconds", period="of the stamps", which="distance", angle="radians", turned="later"):
    """Return the three numbers, step by step; other steps are the slips."""
    (sec_a, nano_a, x_a, y_a, rad_a, deg_a), (sec_b, nano_b, x_b, y_b, rad_b, deg_b) = map(
        parts_of, (given.first, given.second)
    )

    def stamp(sec, nano):
        return float(f"{sec}.{nano}") if zeros == "decimals" else int(sec) + int(nano) / 1e9

    between = {"of the stamps": stamp(sec_b, nano_b) - stamp(sec_a, nano_a), "a second": 1.0}
    dt = {**between, "two seconds": float(int(sec_b) - int(sec_a))}[period]
    way = {"distance": math.hypot(x_b - x_a, y_b - y_a), "x": abs(x_b - x_a), "y": abs(y_b - y_a)}
    way["sum"] = way["x"] + way["y"]
    turn = deg_b - deg_a if angle == "degrees" else rad_b - rad_a
    return {
        "speed_mps": way[which] / dt,
        "yaw_rate_radps": (-turn if turned == "earlier" else turn) / dt,
        "stamp_s": stamp(sec_b, nano_b),
    }


ZEROS_LOST = Slip(
    "zeros lost",
    {"zeros": "decimals"},
    Words(
        en="You read what stands behind the point as decimals. It is a number of nanoseconds without its leading zeros: count the digits.",
        ko="점 뒤를 소수로 읽었습니다. 첫머리의 0이 빠진 나노초입니다. 자릿수를 세어 보세요.",
    ),
    part="stamp_s",
)

A_SECOND = Slip(
    "a second",
    {"period": "a second"},
    Words(
        en="You took a second for the time between. The tool *prints* once a second; the stamps need not be a second apart.",
        ko="사이의 시간을 1초로 보았습니다. 1초에 한 번 *출력*할 뿐, 측정 시각의 간격은 1초가 아닐 수 있습니다.",
    ),
    partly=True,
)

X_ONLY = Slip(
    "x only",
    {"which": "x"},
    Words(
        en="For the speed you took the difference in x alone. The robot also moved in y.",
        ko="속도에 x의 차이만 썼습니다. 로봇은 y로도 움직였습니다.",
    ),
    part="speed_mps",
)

X_PLUS_Y = Slip(
    "x plus y",
    {"which": "sum"},
    Words(
        en="You added the steps in x and y. The straight distance is the hypotenuse.",
        ko="x와 y의 차이를 더했습니다. 직선 거리는 빗변입니다.",
    ),
    part="speed_mps",
)

DEGREES = Slip(
    "degrees",
    {"angle": "degrees"},
    Words(en="The yaw is in degrees: take the line above it.", ko="yaw가 도(degree) 단위입니다. 그 윗줄을 쓰십시오."),
    part="yaw_rate_radps",
)

BACKWARDS = Slip(
    "backwards",
    {"turned": "earlier"},
    Words(
        en="The turn has the wrong sign: later minus earlier.",
        ko="회전의 부호가 반대입니다. 나중 값에서 이전 값을 빼십시오.",
    ),
    part="yaw_rate_radps",
)

Y_ONLY = Slip(
    "y only",
    {"which": "y"},
    Words(
        en="For the speed you took the difference in y alone. The robot also moved in x.",
        ko="속도에 y의 차이만 썼습니다. 로봇은 x로도 움직였습니다.",
    ),
    part="speed_mps",
)

TWO_SECONDS = Slip(
    "two seconds",
    {"period": "two seconds"},
    Words(
        en="You subtracted only the whole seconds of the stamps. What stands behind the point counts, too.",
        ko="측정 시각에서 초의 정수 부분만 뺐습니다. 점 뒤도 세어야 합니다.",
    ),
    partly=True,
)

YAW_ITSELF = Twin(
    "yaw itself",
    lambda g: {**read(g), "yaw_rate_radps": parts_of(g.second)[4]},
    Words(
        en="yaw_rate_radps: that is the yaw of the second reading. How much did it change, and in which time?",
        ko="yaw_rate_radps: 둘째 출력의 yaw 자체입니다. 얼마 동안 얼마나 바뀌었습니까?",
    ),
    part="yaw_rate_radps",
)

STAMP_AS_DECIMALS = Twin(
    "stamp as decimals",
    lambda g: {**read(g), "stamp_s": float(".".join(parts_of(g.second)[:2]))},
    Words(
        en="stamp_s: that is how it is printed. Behind the point stand nanoseconds without their leading zeros.",
        ko="stamp_s: 출력된 모양 그대로입니다. 점 뒤는 첫머리의 0이 빠진 나노초입니다.",
    ),
    part="stamp_s",
)

STAMP_OF_THE_FIRST = Twin(
    "stamp of the first",
    lambda g: {**read(g), "stamp_s": int(parts_of(g.first)[0]) + int(parts_of(g.first)[1]) / 1e9},
    Words(en="stamp_s: that is the first reading's.", ko="stamp_s: 첫째 출력의 시각입니다."),
    part="stamp_s",
)


TASK = Task(
    id="E11.2",
    kind="N",
    points=3,
    title=Words(en="Two readings of tf2_echo", ko="tf2_echo의 두 출력"),
    answer="motion",
    form=Parts(
        {
            "speed_mps": Number("m/s", tolerance=0.004),
            "yaw_rate_radps": Number("rad/s", tolerance=0.004),
            "stamp_s": Number("s", tolerance=0.0005),
        }
    ),
    given=two_readings,
    variants=6,
    model=read,
    twins=(
        ZEROS_LOST,
        A_SECOND,
        X_ONLY,
        X_PLUS_Y,
        DEGREES,
        BACKWARDS,
        Y_ONLY,
        TWO_SECONDS,
        YAW_ITSELF,
        STAMP_AS_DECIMALS,
        STAMP_OF_THE_FIRST,
    ),
    hints=(
        Words(
            en="Write down for both blocks: stamp in seconds, x, y, yaw in radians.",
            ko="두 출력에서 측정 시각(초), x, y, yaw(rad)를 적어 보세요.",
        ),
        Words(
            en="Behind the point stand nanoseconds: 9 digits are 0.9 s and less, 8 digits less than 0.1 s.",
            ko="점 뒤는 나노초입니다. 아홉 자리면 0.1초 이상, 여덟 자리면 0.1초 미만입니다.",
        ),
        Words(
            en="Speed: hypot of the differences, divided by the time between the stamps. Yaw rate: the yaws' difference, divided by the same.",
            ko="속도는 두 차이의 hypot을 측정 시각의 간격으로, 각속도는 yaw의 차이를 같은 간격으로 나눈 값입니다.",
        ),
    ),
)
