"""E2.5: First the yaw, then the pitch."""

from __future__ import annotations

import math

import numpy as np

from tflab.core import Transform
from tflab.core.quaternions import wxyz_from_xyzw
from tflab.workbook.tasks import Quaternion, Task, Twin, Words


def two_turns(rng: np.random.Generator) -> dict:
    """Draw a yaw and a pitch, both large enough for their order to be seen."""
    yaw = rng.choice((-1, 1)) * rng.uniform(0.5, 2.0)
    pitch = rng.choice((-1, 1)) * rng.uniform(0.4, 1.2)
    return {"first_yaw_rad": round(float(yaw), 2), "then_pitch_rad": round(float(pitch), 2)}


def turned(given, unit: float = 1.0) -> Transform:
    """Return first the yaw, then the pitch, about the fixed axes."""
    return Transform.from_rpy(pitch=unit * given.then_pitch_rad) @ Transform.from_rpy(yaw=unit * given.first_yaw_rad)


INVERSE = Twin(
    "inverse",
    lambda given: turned(given).inverse().rotation,
    Words(
        en="This undoes the two turns instead of making them. Did a sign get lost, or an inverse get in?",
        ko="두 회전을 하는 것이 아니라 되돌렸습니다. 부호를 잃었거나 inverse가 끼어들지 않았습니까?",
    ),
    misconception="M3",
)


DEGREES = Twin(
    "degrees",
    lambda given: turned(given, math.radians(1.0)).rotation,
    Words(
        en="You turned by hundredths of what was asked: the angles are radians already.",
        ko="거의 돌지 않았습니다. 각도는 이미 라디안입니다.",
    ),
    misconception="M5",
)


W_FIRST = Twin(
    "w first",
    lambda given: wxyz_from_xyzw(turned(given).rotation),
    Words(
        en="The rotation is right, the order of its numbers is not: w comes last.",
        ko="회전은 맞지만 숫자의 순서가 다릅니다. w는 마지막에 옵니다.",
    ),
    misconception="M5",
)


OTHER_ORDER = Twin(
    "other order",
    lambda given: Transform.from_rpy(pitch=given.then_pitch_rad, yaw=given.first_yaw_rad).rotation,
    Words(
        en="That is first the pitch, then the yaw: the order that rpy always has. Here the yaw comes first, and both axes stand still.",
        ko="먼저 pitch, 다음에 yaw를 한 결과입니다. rpy는 언제나 그 순서입니다. 여기서는 yaw가 먼저이고 두 축 모두 고정되어 있습니다.",
    ),
)


TASK = Task(
    id="E2.5",
    kind="N",
    points=3,
    title=Words(en="First the yaw, then the pitch", ko="먼저 yaw, 다음에 pitch"),
    answer="robot_q_sensor",
    form=Quaternion(tolerance=2e-3),
    given=two_turns,
    variants=5,
    twins=(
        OTHER_ORDER,
        INVERSE,
        DEGREES,
        W_FIRST,
    ),
    hints=(
        Words(
            en="Two turns, two transforms, one product. Which factor stands next to the point?",
            ko="회전 둘, 변환 둘, 곱 하나입니다. 점과 가까운 쪽에 어느 것이 옵니까?",
        ),
        Words(
            en="What happens first stands on the right. from_rpy with both angles at once has the other order built in.",
            ko="먼저 일어나는 것이 오른쪽에 옵니다. from_rpy에 두 각도를 한꺼번에 넣으면 순서가 반대로 정해져 있습니다.",
        ),
        Words(
            en="Make yaw = Transform.from_rpy(yaw=...) and pitch = Transform.from_rpy(pitch=...), multiply with @, and take .rotation.",
            ko="yaw = Transform.from_rpy(yaw=...)와 pitch = Transform.from_rpy(pitch=...)를 만들어 @로 곱하고 .rotation을 꺼내십시오.",
        ),
    ),
    cures=("M5",),
)
