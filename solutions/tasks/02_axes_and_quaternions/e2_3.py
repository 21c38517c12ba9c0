"""E2.3: The quaternion of a yaw."""

from __future__ import annotations

import math

import numpy as np

from tflab.workbook.tasks import Quaternion, Task, Twin, Words


def yaws(rng: np.random.Generator) -> list[tuple[float]]:
    """Draw turns to the left and to the right, small and large, and the two that are easy to get right by chance."""
    drawn = (rng.uniform(0.3, 1.4), -rng.uniform(0.3, 1.4), rng.uniform(1.8, 2.9), -rng.uniform(1.8, 2.9))
    return [(0.0,), (math.pi / 2,), (4.0,), (-5.5,), *((round(float(yaw), 3),) for yaw in drawn)]


WHOLE_ANGLE = Twin(
    "whole angle",
    lambda yaw: (0.0, 0.0, math.sin(yaw), math.cos(yaw)),
    Words(
        en="This turns twice as far as asked: a quaternion holds half the angle. Try 90°: your robot looks backwards.",
        ko="두 배나 돌았습니다. 쿼터니언에는 각도의 절반이 들어갑니다. 90°를 넣어 보십시오. 로봇이 뒤를 보고 있습니다.",
    ),
    misconception="M5",
)


DEGREES = Twin(
    "degrees",
    lambda yaw: (0.0, 0.0, math.sin(math.radians(yaw) / 2), math.cos(math.radians(yaw) / 2)),
    Words(
        en="You took the argument for degrees. It comes in radians already (REP-103), and math.sin wants radians.",
        ko="인자를 도(degree)로 받아들였습니다. 이미 라디안으로 들어오며(REP-103), math.sin도 라디안을 받습니다.",
    ),
    misconception="M5",
)


W_FIRST = Twin(
    "w first",
    lambda yaw: (math.cos(yaw / 2), 0.0, 0.0, math.sin(yaw / 2)),
    Words(
        en="The four numbers are right, their order is not: this is (w, x, y, z). ROS writes w last. For a yaw of 0 your robot lies on its back.",
        ko="숫자 넷은 맞지만 순서가 (w, x, y, z)입니다. ROS는 w를 마지막에 씁니다. yaw가 0일 때 로봇이 뒤집혀 누워 있습니다.",
    ),
    misconception="M5",
)


SINE_AND_COSINE = Twin(
    "sine and cosine",
    lambda yaw: (0.0, 0.0, math.cos(yaw / 2), math.sin(yaw / 2)),
    Words(
        en="Sine and cosine changed places. Try a yaw of 0: 'no rotation' is (0, 0, 0, 1), and yours?",
        ko="sin과 cos의 자리가 바뀌었습니다. yaw에 0을 넣어 보십시오. '회전 없음'은 (0, 0, 0, 1)인데 어떤 값이 나옵니까?",
    ),
    misconception="M5",
)


TO_THE_RIGHT = Twin(
    "to the right",
    lambda yaw: (0.0, 0.0, -math.sin(yaw / 2), math.cos(yaw / 2)),
    Words(
        en="Your robot turns right where left was asked. Positive yaw goes from x towards y.",
        ko="왼쪽으로 돌아야 하는데 오른쪽으로 돕니다. 양의 yaw는 x에서 y 쪽으로 돕니다.",
    ),
)


ABOUT_X = Twin(
    "about x",
    lambda yaw: (math.sin(yaw / 2), 0.0, 0.0, math.cos(yaw / 2)),
    Words(
        en="This is a roll: the sine stands in x. Which axis does a yaw turn about?",
        ko="이것은 roll입니다. sin이 x 자리에 있습니다. yaw는 어느 축을 중심으로 돕니까?",
    ),
)


ABOUT_Y = Twin(
    "about y",
    lambda yaw: (0.0, math.sin(yaw / 2), 0.0, math.cos(yaw / 2)),
    Words(
        en="This is a pitch: the sine stands in y, and your robot nods. Which axis does a yaw turn about?",
        ko="이것은 pitch입니다. sin이 y 자리에 있어서 로봇이 고개를 끄덕입니다. yaw는 어느 축을 중심으로 돕니까?",
    ),
)


ANGLE_IN_Z = Twin(
    "angle in z",
    lambda yaw: (0.0, 0.0, yaw, 1.0),
    Words(
        en="You wrote the angle itself into z. A quaternion holds no angle: z takes the sine of half of it, w the cosine.",
        ko="z에 각도를 그대로 넣었습니다. 쿼터니언에는 각도가 직접 들어가지 않습니다. z에는 각도 절반의 sin, w에는 cos을 넣으십시오.",
    ),
    misconception="M5",
)


HALVED_OUTSIDE = Twin(
    "halved outside",
    lambda yaw: (0.0, 0.0, math.sin(yaw) / 2, math.cos(yaw) / 2),
    Words(
        en="You halved the sine, not the angle. The half belongs inside the brackets; look at the length of what you return.",
        ko="각도가 아니라 sin을 절반으로 나누었습니다. 절반은 괄호 안에서 나누어야 합니다. 반환한 값의 길이를 보십시오.",
    ),
    misconception="M5",
)


TASK = Task(
    id="E2.3",
    kind="F",
    points=3,
    title=Words(en="The quaternion of a yaw", ko="yaw를 쿼터니언으로"),
    answer="quaternion_from_yaw",
    form=Quaternion(tolerance=1e-3),
    inputs=yaws,
    variants=3,
    twins=(
        WHOLE_ANGLE,
        DEGREES,
        W_FIRST,
        SINE_AND_COSINE,
        TO_THE_RIGHT,
        ABOUT_X,
        ABOUT_Y,
        ANGLE_IN_Z,
        HALVED_OUTSIDE,
    ),
    hints=(
        Words(
            en="Axis times the sine of ..., then the cosine of ...: what is the axis of a yaw?",
            ko="축에 sin을 곱하고, 마지막에 cos을 씁니다. yaw의 축은 무엇입니까?",
        ),
        Words(
            en="The axis is (0, 0, 1), so two of the four numbers are zero. And it is half the angle.",
            ko="축은 (0, 0, 1)이므로 넷 중 둘은 0입니다. 그리고 각도의 절반을 씁니다.",
        ),
        Words(
            en="x and y are 0.0; z is math.sin(yaw_rad / 2); one number is left for you.",
            ko="x와 y는 0.0이고 z는 math.sin(yaw_rad / 2)입니다. 남은 하나는 직접 채우십시오.",
        ),
    ),
    cures=("M5",),
)
