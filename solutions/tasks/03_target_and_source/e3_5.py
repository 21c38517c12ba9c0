"""E3.5: tf2_echo, both ways."""

from __future__ import annotations

import math

import numpy as np

from tflab.core import LATEST, StampedTransform, Transform
from tflab.views.sentence import echo_text
from tflab.workbook.tasks import Angle, Parts, Task, Twin, Vector, Words

from .draws import some_mount, turned


def echo_given(rng: np.random.Generator) -> dict[str, str]:
    return {"echo": echo_text(StampedTransform("base_link", "laser_frame", LATEST, some_mount(rng)))}


def echoed(given) -> tuple[Transform, float]:
    """Return the transform that was printed, and its yaw [rad]."""
    rows = [line.split("[")[1].rstrip("]").split(", ") for line in given.echo.splitlines()[1:4]]
    yaw = float(rows[2][2])
    return Transform.from_rpy(yaw=yaw, translation=tuple(map(float, rows[0]))), yaw


def echo_answer(laser_in_base, base_in_laser, yaw_back) -> dict[str, object]:
    return {"laser_in_base": laser_in_base, "base_in_laser": base_in_laser, "yaw_back": yaw_back}


def echo_swapped(given) -> dict[str, object]:
    mount, yaw = echoed(given)
    return echo_answer(mount.inverse().translation, mount.translation, yaw)


SWAPPED = Twin(
    "swapped",
    echo_swapped,
    Words(
        en="where it is wrong stands the answer to the other question. `tf2_echo base_link laser_frame` "
        "prints where the second sits in the first, whatever the tool's help calls them.",
        ko="틀린 값은 서로의 자리에 놓여 있습니다. `tf2_echo base_link laser_frame`은 둘째가 첫째 안 어디에 있는지 "
        "출력합니다. 도움말이 무엇이라 부르든 그렇습니다.",
    ),
    "M1",
    partly=True,
)


def echo_sign_only(given) -> dict[str, object]:
    mount, yaw = echoed(given)
    return echo_answer(mount.translation, tuple(-value for value in mount.translation), -yaw)


SIGN_ONLY = Twin(
    "sign_only",
    echo_sign_only,
    Words(
        en="for the way back you flipped the signs. The mount is turned, so the step has to be turned, "
        "too. Stand where the laser is and look for the robot's middle.",
        ko="돌아가는 쪽은 부호만 뒤집었습니다. 센서가 돌아가 있으므로 이동도 돌려야 합니다. 레이저 자리에 서서 "
        "로봇 중심이 어느 쪽인지 찾아보십시오.",
    ),
    "M3",
)


def echo_turned_on(given) -> dict[str, object]:
    mount, yaw = echoed(given)
    return echo_answer(mount.translation, turned(mount, tuple(-value for value in mount.translation)), -yaw)


TURNED_ON = Twin(
    "turned_on",
    echo_turned_on,
    Words(
        en="for the way back the step was turned, but by yaw instead of by minus yaw.",
        ko="돌아가는 쪽의 이동을 돌렸지만, −yaw가 아니라 yaw로 돌렸습니다.",
    ),
)


def echo_not_taken_off(given) -> dict[str, object]:
    mount, yaw = echoed(given)
    return echo_answer(mount.translation, turned(mount.inverse(), mount.translation), -yaw)


NOT_TAKEN_OFF = Twin(
    "not_taken_off",
    echo_not_taken_off,
    Words(
        en="for the way back you turned the step rightly and kept its sign. From the laser, the robot's "
        "middle lies on the other side.",
        ko="돌아가는 쪽의 이동을 바르게 돌렸지만 부호가 그대로입니다. 레이저에서 보면 로봇 중심은 반대쪽에 있습니다.",
    ),
)


def echo_same_yaw(given) -> dict[str, object]:
    mount, yaw = echoed(given)
    return echo_answer(mount.translation, mount.inverse().translation, yaw)


SAME_YAW = Twin(
    "same_yaw",
    echo_same_yaw,
    Words(
        en="both places are right. Going back, one also turns back: look at the sign of the yaw.",
        ko="두 위치는 맞습니다. 돌아갈 때는 회전도 반대입니다. yaw의 부호를 보십시오.",
    ),
)


def echo_height_kept(given) -> dict[str, object]:
    mount, yaw = echoed(given)
    back = mount.inverse().translation
    return echo_answer(mount.translation, (back[0], back[1], -back[2]), -yaw)


HEIGHT_KEPT = Twin(
    "height_kept",
    echo_height_kept,
    Words(
        en="all but one number is right: from the laser, is the robot's middle above or below?",
        ko="숫자 하나만 빼고 모두 맞습니다. 레이저에서 보면 로봇 중심은 위에 있습니까, 아래에 있습니까?",
    ),
)


def echo_yaw_in_degrees(given) -> dict[str, object]:
    mount, yaw = echoed(given)
    return echo_answer(mount.translation, mount.inverse().translation, round(math.degrees(-yaw)))


YAW_IN_DEGREES = Twin(
    "yaw_in_degrees",
    echo_yaw_in_degrees,
    Words(
        en="both places are right, and the yaw is in degrees. It is asked for in radians: the tool prints "
        "both, one line above the other.",
        ko="두 위치는 맞고, yaw가 도(degree)로 되어 있습니다. 라디안으로 답해야 합니다. 도구는 두 단위를 위아래 "
        "두 줄로 출력합니다.",
    ),
    "M5",
)


def echo_behind(given) -> dict[str, object]:
    mount, yaw = echoed(given)
    return echo_answer(mount.translation, mount.inverse().translation, yaw + math.pi)


def echo_turned_by_degrees(given) -> dict[str, object]:
    mount, yaw = echoed(given)
    back = Transform.from_rpy(yaw=-math.degrees(yaw)).apply([-value for value in mount.translation])
    return echo_answer(mount.translation, back, -yaw)


def echo_on_the_floor(given) -> dict[str, object]:
    mount, yaw = echoed(given)
    return echo_answer((*mount.translation[:2], 0.0), (*mount.inverse().translation[:2], 0.0), -yaw)


BEHIND = Twin(
    "behind",
    echo_behind,
    Words(
        en="you added half a turn. The way back is turned by as much as the way there, to the other side.",
        ko="반 바퀴를 더했습니다. 돌아가는 쪽은 같은 만큼 반대로 돕니다.",
    ),
)

TURNED_BY_DEGREES = Twin(
    "turned_by_degrees",
    echo_turned_by_degrees,
    Words(
        en="the step was turned by the degrees, taken for radians: `math.cos` and `math.sin` want radians.",
        ko="도 단위의 각도를 라디안으로 여기고 이동을 돌렸습니다. `math.cos`과 `math.sin`은 라디안을 받습니다.",
    ),
    "M5",
)

ON_THE_FLOOR = Twin(
    "on_the_floor",
    echo_on_the_floor,
    Words(
        en="the height was left out: the third number counts as well.",
        ko="높이를 빠뜨렸습니다. 셋째 숫자도 필요합니다.",
    ),
    partly=True,
)


TASK = Task(
    id="E3.5",
    kind="N",
    points=3,
    title=Words(en="tf2_echo, both ways", ko="tf2_echo 양쪽으로 읽기"),
    answer="both_ways",
    form=Parts(
        {
            "laser_in_base": Vector(3, "m", "base_link", 0.005),
            "base_in_laser": Vector(3, "m", "laser_frame", 0.005),
            "yaw_back": Angle(0.005),
        }
    ),
    given=echo_given,
    variants=6,
    twins=(
        SWAPPED,
        SIGN_ONLY,
        TURNED_ON,
        NOT_TAKEN_OFF,
        HEIGHT_KEPT,
        YAW_IN_DEGREES,
        SAME_YAW,
        BEHIND,
        TURNED_BY_DEGREES,
        ON_THE_FLOOR,
    ),
    hints=(
        Words(
            en="One of the two places stands in the output as it is.",
            ko="두 위치 가운데 하나는 출력에 그대로 적혀 있습니다.",
        ),
        Words(
            en="The output is base_T_laser. The other one is its inverse: E3.3, with z.",
            ko="출력은 base_T_laser입니다. 다른 하나는 그 역변환입니다. E3.3에 z가 더해진 것입니다.",
        ),
        Words(
            en="`Transform.from_rpy(yaw=..., translation=(...)).inverse()` does the arithmetic; z only changes sign.",
            ko="`Transform.from_rpy(yaw=..., translation=(...)).inverse()`로 계산할 수 있습니다. z는 부호만 바뀝니다.",
        ),
    ),
    cures=("M1", "M3"),
)
