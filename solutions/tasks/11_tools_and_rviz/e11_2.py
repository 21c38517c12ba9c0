"""E11.2: Two readings of tf2_echo."""

from __future__ import annotations

import math
import re
from typing import NamedTuple

from tflab.core import StampedTransform, Transform, seconds
from tflab.tools.tf2_echo import echo_text
from tflab.workbook.tasks import Number, Parts, Task, Text, WrongAnswer, WrongStep

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


class Reading(NamedTuple):
    """What one block says: the stamp's two texts, the place, the turn as radians, degrees and quaternion."""

    sec: str
    nanosec: str
    x: float
    y: float
    radians: float
    degrees: float
    z: float
    w: float


def parts_of(block):
    rows = block.splitlines()
    sec, nanosec = rows[0].removeprefix("At time ").split(".")
    (x, y, _), (*_, z, w), (*_, radians), (*_, degrees) = (map(float, NUMBER.findall(rows[i])) for i in (1, 2, 3, 4))
    return Reading(sec, nanosec, x, y, radians, degrees, z, w)


def stamp_of(block):
    one = parts_of(block)
    return int(one.sec) + int(one.nanosec) / 1e9


def read(given, *, zeros="nanoseconds", period="of the stamps", time="divided", which="distance", angle="radians",
         turned="later"):  # fmt: skip
    """Return the three numbers, step by step; other steps are the slips."""
    a, b = parts_of(given.first), parts_of(given.second)

    def stamp(one):
        if zeros == "decimals":
            return float(f"{one.sec}.{one.nanosec}")
        return int(one.sec) + int(one.nanosec) / (1e6 if zeros == "millionths" else 1e9)

    dt = {
        "of the stamps": stamp(b) - stamp(a),
        "a second": 1.0,
        "two seconds": float(int(b.sec) - int(a.sec)),
        "nanoseconds alone": (int(b.nanosec) - int(a.nanosec)) / 1e9,
        "the second stamp": stamp(b),
    }[period]
    x, y = abs(b.x - a.x), abs(b.y - a.y)
    way = {
        "distance": math.hypot(x, y), "x": x, "y": y, "sum": x + y, "no root": x * x + y * y,
        "from the origin": math.hypot(b.x, b.y), "of the distances": math.hypot(b.x, b.y) - math.hypot(a.x, a.y),
    }[which]  # fmt: skip
    one, other = ({
        "radians": each.radians, "degrees": each.degrees, "z": each.z, "twice z": 2 * each.z, "w": each.w,
    }[angle] for each in (a, b))  # fmt: skip
    turn = {
        "later": other - one, "earlier": one - other, "second": other, "first": one, "added": one + other,
        "course": math.atan2(b.y - a.y, b.x - a.x), "wrapped": math.remainder(other - one, math.tau),
    }[turned]  # fmt: skip
    per = dt if time == "multiplied" else 1 / dt
    return {"speed_mps": way * per, "yaw_rate_radps": turn * per, "stamp_s": stamp(b)}


ZEROS_LOST = WrongStep(
    "zeros lost",
    {"zeros": "decimals"},
    Text(
        en="You read what stands behind the point as decimals. It is a number of nanoseconds without its leading zeros: count the digits.",
        ko="점 뒤를 소수로 읽었습니다. 첫머리의 0이 빠진 나노초입니다. 자릿수를 세어 보세요.",
    ),
    part="stamp_s",
)

A_SECOND = WrongStep(
    "a second",
    {"period": "a second"},
    Text(
        en="This is the change as it is, as if just a second lay between. The tool *prints* once a second, and the stamps need not be a second apart: divide by the time between them.",
        ko="변한 양 그대로입니다. 사이의 시간이 꼭 1초일 때의 값입니다. 1초에 한 번 *출력*할 뿐 측정 시각의 간격은 1초가 아닐 수 있으니, 그 간격으로 나누십시오.",
    ),
    partly=True,
)

X_ONLY = WrongStep(
    "x only",
    {"which": "x"},
    Text(
        en="For the speed you took the difference in x alone. The robot also moved in y.",
        ko="속도에 x의 차이만 썼습니다. 로봇은 y로도 움직였습니다.",
    ),
    part="speed_mps",
)

X_PLUS_Y = WrongStep(
    "x plus y",
    {"which": "sum"},
    Text(
        en="You added the steps in x and y. The straight distance is the hypotenuse.",
        ko="x와 y의 차이를 더했습니다. 직선 거리는 빗변입니다.",
    ),
    part="speed_mps",
)

DEGREES = WrongStep(
    "degrees",
    {"angle": "degrees"},
    Text(en="The yaw is in degrees: take the line above it.", ko="yaw가 도(degree) 단위입니다. 그 윗줄을 쓰십시오."),
    part="yaw_rate_radps",
)

DEGREES_WRAPPED = WrongStep(
    "degrees wrapped",
    {"angle": "degrees", "turned": "wrapped"},
    Text(
        en="The yaw is in degrees, and then whole turns of 2π were taken off, as of radians: take the line above it.",
        ko="yaw가 도(degree) 단위인데, 라디안인 것처럼 2π의 배수를 뺐습니다. 그 윗줄을 쓰십시오.",
    ),
    part="yaw_rate_radps",
)

BACKWARDS = WrongStep(
    "backwards",
    {"turned": "earlier"},
    Text(
        en="The turn has the wrong sign: later minus earlier.",
        ko="회전의 부호가 반대입니다. 나중 값에서 이전 값을 빼십시오.",
    ),
    part="yaw_rate_radps",
)

Y_ONLY = WrongStep(
    "y only",
    {"which": "y"},
    Text(
        en="For the speed you took the difference in y alone. The robot also moved in x.",
        ko="속도에 y의 차이만 썼습니다. 로봇은 x로도 움직였습니다.",
    ),
    part="speed_mps",
)

TWO_SECONDS = WrongStep(
    "two seconds",
    {"period": "two seconds"},
    Text(
        en="You subtracted only the whole seconds of the stamps. What stands behind the point counts, too.",
        ko="측정 시각에서 초의 정수 부분만 뺐습니다. 점 뒤도 세어야 합니다.",
    ),
    partly=True,
)

NANOSECONDS_ALONE = WrongStep(
    "nanoseconds alone",
    {"period": "nanoseconds alone"},
    Text(
        en="You subtracted only what stands behind the point. The whole seconds passed, too.",
        ko="점 뒤만 뺐습니다. 점 앞의 초도 지나갔습니다.",
    ),
    partly=True,
)

STAMP_FOR_THE_TIME_BETWEEN = WrongStep(
    "stamp for the time between",
    {"period": "the second stamp"},
    Text(
        en="You divided by the second stamp. That is a moment on the clock, not the time between the two.",
        ko="둘째 측정 시각으로 나눴습니다. 그것은 시계가 가리키는 순간이지 두 시각의 간격이 아닙니다.",
    ),
    partly=True,
)

MULTIPLIED = WrongStep(
    "multiplied by the time",
    {"time": "multiplied"},
    Text(
        en="You multiplied by the time between. A rate is how much changes in one second.",
        ko="사이의 시간을 곱했습니다. 속도는 1초에 얼마나 바뀌는지입니다.",
    ),
    partly=True,
)

MILLIONTHS = WrongStep(
    "nanoseconds as millionths",
    {"zeros": "millionths"},
    Text(
        en="You divided what stands behind the point by 1e6: that makes milliseconds of nanoseconds, and seconds are asked for.",
        ko="점 뒤를 1e6으로 나눴습니다. 그러면 나노초가 밀리초가 됩니다. 필요한 것은 초입니다.",
    ),
    part="stamp_s",
)

NO_ROOT = WrongStep(
    "no root",
    {"which": "no root"},
    Text(
        en="You added the squares of the two differences. That is the square of the distance.",
        ko="두 차이의 제곱을 더했습니다. 그것은 거리의 제곱입니다.",
    ),
    part="speed_mps",
)

FROM_THE_ORIGIN = WrongStep(
    "from the origin",
    {"which": "from the origin"},
    Text(
        en="You took the second position itself. That is how far it is from the origin of `map`, not how far it went.",
        ko="둘째 위치 자체를 썼습니다. 그것은 `map`의 원점에서 떨어진 거리이지 간 거리가 아닙니다.",
    ),
    part="speed_mps",
)

NEARER_OR_FARTHER = WrongStep(
    "nearer or farther",
    {"which": "of the distances"},
    Text(
        en="You subtracted two distances from the origin. A robot that drives around it would stand still: subtract the positions first.",
        ko="원점에서 떨어진 두 거리를 뺐습니다. 그러면 원점 둘레를 도는 로봇은 서 있는 것이 됩니다. 위치부터 빼십시오.",
    ),
    part="speed_mps",
)

Z_FOR_THE_YAW = WrongStep(
    "z for the yaw",
    {"angle": "z"},
    Text(
        en="You took z of the quaternion for the yaw. It is the sine of half of it; the line below has angles.",
        ko="쿼터니언의 z를 yaw로 썼습니다. 그것은 yaw 절반의 sin입니다. 각도는 아랫줄에 있습니다.",
    ),
    "M5",
    part="yaw_rate_radps",
)

TWICE_Z = WrongStep(
    "twice z for the yaw",
    {"angle": "twice z"},
    Text(
        en="You took twice z of the quaternion for the yaw. That holds for small angles only; the line below has angles.",
        ko="쿼터니언 z의 두 배를 yaw로 썼습니다. 작은 각도에서만 맞습니다. 각도는 아랫줄에 있습니다.",
    ),
    "M5",
    part="yaw_rate_radps",
)

W_FOR_THE_YAW = WrongStep(
    "w for the yaw",
    {"angle": "w"},
    Text(
        en="You took w of the quaternion for the yaw. It is the cosine of half of it; the line below has angles.",
        ko="쿼터니언의 w를 yaw로 썼습니다. 그것은 yaw 절반의 cos입니다. 각도는 아랫줄에 있습니다.",
    ),
    "M5",
    part="yaw_rate_radps",
)

SECOND_YAW_ALONE = WrongStep(
    "second yaw alone",
    {"turned": "second"},
    Text(
        en="You took the second yaw itself. It says which way the robot looks then, not how much it turned.",
        ko="둘째 yaw 자체를 썼습니다. 그때 어디를 보는지이지 얼마나 돌았는지가 아닙니다.",
    ),
    part="yaw_rate_radps",
)

FIRST_YAW_ALONE = WrongStep(
    "first yaw alone",
    {"turned": "first"},
    Text(
        en="You took the first yaw itself. It says which way the robot looked, not how much it turned.",
        ko="첫째 yaw 자체를 썼습니다. 처음에 어디를 보았는지이지 얼마나 돌았는지가 아닙니다.",
    ),
    part="yaw_rate_radps",
)

YAWS_ADDED = WrongStep(
    "yaws added",
    {"turned": "added"},
    Text(
        en="You added the two yaws. How much it turned is their difference.",
        ko="두 yaw를 더했습니다. 얼마나 돌았는지는 둘의 차이입니다.",
    ),
    part="yaw_rate_radps",
)

COURSE_FOR_THE_TURN = WrongStep(
    "course for the turn",
    {"turned": "course"},
    Text(
        en="You took the direction of the way from one position to the other. How the robot turned stands in the yaws.",
        ko="한 위치에서 다른 위치로 가는 방향을 썼습니다. 로봇이 얼마나 돌았는지는 yaw에 있습니다.",
    ),
    part="yaw_rate_radps",
)

TIME_BETWEEN_FOR_THE_STAMP = WrongAnswer(
    "time between for the stamp",
    lambda g: {**read(g), "stamp_s": stamp_of(g.second) - stamp_of(g.first)},
    Text(
        en="stamp_s: that is the time between the two. Asked is the moment that the second one tells.",
        ko="stamp_s: 두 시각의 간격입니다. 구할 것은 둘째 출력에 나오는 시각입니다.",
    ),
    part="stamp_s",
)

YAW_ITSELF = WrongAnswer(
    "yaw itself",
    lambda g: {**read(g), "yaw_rate_radps": parts_of(g.second).radians},
    Text(
        en="yaw_rate_radps: that is the yaw of the second reading. How much did it change, and in which time?",
        ko="yaw_rate_radps: 둘째 출력의 yaw 자체입니다. 얼마 동안 얼마나 바뀌었습니까?",
    ),
    part="yaw_rate_radps",
)

STAMP_AS_DECIMALS = WrongAnswer(
    "stamp as decimals",
    lambda g: {**read(g), "stamp_s": float(".".join(parts_of(g.second)[:2]))},
    Text(
        en="stamp_s: that is how it is printed. Behind the point stand nanoseconds without their leading zeros.",
        ko="stamp_s: 출력된 모양 그대로입니다. 점 뒤는 첫머리의 0이 빠진 나노초입니다.",
    ),
    part="stamp_s",
)

STAMP_OF_THE_FIRST = WrongAnswer(
    "stamp of the first",
    lambda g: {**read(g), "stamp_s": stamp_of(g.first)},
    Text(en="stamp_s: that is the first reading's.", ko="stamp_s: 첫째 출력의 시각입니다."),
    part="stamp_s",
)


TASK = Task(
    id="E11.2",
    kind="N",
    points=3,
    title=Text(en="Two readings of tf2_echo", ko="tf2_echo의 두 출력"),
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
    mistakes=(
        ZEROS_LOST,
        A_SECOND,
        X_ONLY,
        X_PLUS_Y,
        DEGREES,
        DEGREES_WRAPPED,
        BACKWARDS,
        Y_ONLY,
        TWO_SECONDS,
        NANOSECONDS_ALONE,
        STAMP_FOR_THE_TIME_BETWEEN,
        MULTIPLIED,
        MILLIONTHS,
        NO_ROOT,
        FROM_THE_ORIGIN,
        NEARER_OR_FARTHER,
        Z_FOR_THE_YAW,
        TWICE_Z,
        W_FOR_THE_YAW,
        SECOND_YAW_ALONE,
        FIRST_YAW_ALONE,
        YAWS_ADDED,
        COURSE_FOR_THE_TURN,
        TIME_BETWEEN_FOR_THE_STAMP,
        YAW_ITSELF,
        STAMP_AS_DECIMALS,
        STAMP_OF_THE_FIRST,
    ),
    hints=(
        Text(
            en="Write down for both blocks: stamp in seconds, x, y, yaw in radians.",
            ko="두 출력에서 측정 시각(초), x, y, yaw(rad)를 적어 보세요.",
        ),
        Text(
            en="Behind the point stand nanoseconds: 9 digits are 0.9 s and less, 8 digits less than 0.1 s.",
            ko="점 뒤는 나노초입니다. 아홉 자리면 0.1초 이상, 여덟 자리면 0.1초 미만입니다.",
        ),
        Text(
            en="Speed: hypot of the differences, divided by the time between the stamps. Yaw rate: the yaws' difference, divided by the same.",
            ko="속도는 두 차이의 hypot을 측정 시각의 간격으로, 각속도는 yaw의 차이를 같은 간격으로 나눈 값입니다.",
        ),
    ),
)
