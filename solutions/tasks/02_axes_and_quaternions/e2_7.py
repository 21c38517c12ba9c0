"""E2.7: A few digits too few."""

from __future__ import annotations

import math

import numpy as np

from tflab.workbook.tasks import Number, Task, Twin, Words


def few_digits(rng: np.random.Generator) -> dict:
    """Draw how pi/2 was written in a URDF, and how far away one looks."""
    written = float(rng.choice((1.56, 1.57, 1.58, 1.59)))
    return {"written_yaw_rad": written, "range_m": round(float(rng.uniform(6.0, 30.0)), 1)}


def missing_rad(given) -> float:
    return abs(math.pi / 2 - given.written_yaw_rad)


DEGREES = Twin(
    "degrees",
    lambda given: 1000.0 * given.range_m * math.degrees(missing_rad(given)),
    Words(
        en="You multiplied by degrees. An arc is radius times angle only if the angle is in radians.",
        ko="도(degree)를 곱했습니다. 호의 길이가 반지름 곱하기 각도인 것은 각도가 라디안일 때뿐입니다.",
    ),
)


RELATIVE = Twin(
    "relative",
    lambda given: 1000.0 * given.range_m * missing_rad(given) / (math.pi / 2),
    Words(
        en="That is the error as a part of pi/2, times the range. The missing angle itself is what swings the ray.",
        ko="오차를 π/2로 나눈 비율에 거리를 곱했습니다. 광선을 옆으로 미는 것은 비율이 아니라 모자란 각도 자체입니다.",
    ),
)


HALF = Twin(
    "half",
    lambda given: 500.0 * given.range_m * missing_rad(given),
    Words(
        en="You halved the angle. Halves belong into quaternions; the ray swings by the whole missing angle.",
        ko="각도를 절반으로 나누었습니다. 절반은 쿼터니언에 쓰는 것이고, 광선은 모자란 각도만큼 그대로 돌아갑니다.",
    ),
)


NEGATIVE = Twin(
    "negative",
    lambda given: -1000.0 * given.range_m * missing_rad(given),
    Words(
        en="How far off is asked without a sign: take abs().",
        ko="얼마나 어긋나는지는 부호 없이 답합니다. abs()를 쓰십시오.",
    ),
)


ROUNDED_PI = Twin(
    "rounded pi",
    lambda given: 1000.0 * given.range_m * abs(3.14 / 2 - given.written_yaw_rad),
    Words(
        en="You compared with 3.14 / 2, which is as short of digits as the URDF. Use math.pi.",
        ko="3.14 / 2와 비교했습니다. 그 값도 URDF만큼이나 자릿수가 모자랍니다. math.pi를 쓰십시오.",
    ),
)


TASK = Task(
    id="E2.7",
    kind="N",
    points=2,
    title=Words(en="A few digits too few", ko="모자란 숫자 몇 자리"),
    answer="off_mm",
    form=Number(unit="mm", tolerance=0.5),
    given=few_digits,
    variants=5,
    twins=(
        DEGREES,
        RELATIVE,
        HALF,
        NEGATIVE,
        ROUNDED_PI,
    ),
    hints=(
        Words(
            en="How large is the missing angle? And what does a small angle do to a point far away?",
            ko="모자란 각도는 얼마입니까? 작은 각도는 멀리 있는 점에 어떤 영향을 줍니까?",
        ),
        Words(
            en="The point swings along an arc: radius times angle, the angle in radians.",
            ko="점은 호를 따라 움직입니다. 반지름 곱하기 각도이고, 각도는 라디안입니다.",
        ),
        Words(
            en="abs(math.pi / 2 - written) is the angle. Metres become millimetres at the very end.",
            ko="각도는 abs(math.pi / 2 - written)입니다. 미터를 밀리미터로 바꾸는 일은 맨 마지막에 합니다.",
        ),
    ),
    cures=("M5",),
)
