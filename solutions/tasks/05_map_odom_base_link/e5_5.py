"""E5.5: The shadow on the floor."""

from __future__ import annotations

import math

from tflab.core import Transform
from tflab.workbook.tasks import Angle, Number, Parts, Task, Twin, Words


def tilted(rng):
    """Bodies 0.3 to 0.8 m high, rolled and pitched together, looking every way."""
    rows = []
    for way in (1, -1, 1, -1, 1):
        x, y = (float(rng.choice([-1.0, 1.0])) * float(rng.uniform(0.5, 4.0)) for _ in range(2))
        pitch, roll = (float(rng.choice([-1.0, 1.0])) * float(rng.uniform(0.15, 0.35)) for _ in range(2))
        yaw = way * float(rng.uniform(0.6, 2.4))
        height = float(rng.uniform(0.3, 0.8))
        rows.append((Transform.from_rpy(roll=roll, pitch=pitch, yaw=yaw, translation=(x, y, height)),))
    return rows


def shadow(pose, x=None, y=None, yaw=None):
    return {
        "x": pose.translation[0] if x is None else x,
        "y": pose.translation[1] if y is None else y,
        "yaw": pose.rpy()[2] if yaw is None else yaw,
    }


def along_its_own_z(odom_T_base):
    foot = odom_T_base.apply((0.0, 0.0, -odom_T_base.translation[2]))
    return shadow(odom_T_base, x=foot[0], y=foot[1])


def twice_atan(odom_T_base):
    _, _, z, w = odom_T_base.rotation
    return shadow(odom_T_base, yaw=2.0 * math.atan2(z, w))


ALONG_ITS_OWN_Z = Twin(
    "along its own z",
    along_its_own_z,
    Words(
        en="You went down along the robot's own z. It leans, so that ends beside the point below it. Below means along odom's z.",
        ko="로봇 자신의 z를 따라 내려갔습니다. 로봇이 기울어 있으므로 바로 아래가 아닌 옆에 닿습니다. 아래란 odom의 z 방향입니다.",
    ),
)

TWICE_ATAN = Twin(
    "twice atan",
    twice_atan,
    Words(
        en="2·atan2(z, w) is the yaw only of a quaternion that turns about z alone. This body is rolled and pitched as well: take the yaw of `rpy()`.",
        ko="2·atan2(z, w)는 z축으로만 도는 쿼터니언의 yaw입니다. 이 몸체는 roll과 pitch도 있으므로 `rpy()`의 yaw를 쓰십시오.",
    ),
    "M5",
)

YAW_OF_THE_INVERSE = Twin(
    "yaw of the inverse",
    lambda odom_T_base: shadow(odom_T_base, yaw=odom_T_base.inverse().rpy()[2]),
    Words(
        en="That is the yaw of odom as seen from the robot, the inverse. Asked for is the robot's yaw in odom.",
        ko="로봇에서 본 odom의 yaw, 곧 역변환의 yaw입니다. odom 기준 로봇의 yaw가 필요합니다.",
    ),
    "M1",
)

SIGN_OF_YAW = Twin(
    "sign of yaw",
    lambda odom_T_base: shadow(odom_T_base, yaw=-odom_T_base.rpy()[2]),
    Words(
        en="The yaw has the wrong sign: positive turns to the left.",
        ko="yaw의 부호가 틀렸습니다. 양수는 왼쪽으로 도는 것입니다.",
    ),
)

ROLL_FOR_YAW = Twin(
    "roll for yaw",
    lambda odom_T_base: shadow(odom_T_base, yaw=odom_T_base.rpy()[0]),
    Words(
        en="That is the roll. `rpy()` gives roll, pitch, yaw in this order.",
        ko="roll입니다. `rpy()`는 roll, pitch, yaw 순서로 돌려줍니다.",
    ),
)

PITCH_FOR_YAW = Twin(
    "pitch for yaw",
    lambda odom_T_base: shadow(odom_T_base, yaw=odom_T_base.rpy()[1]),
    Words(
        en="That is the pitch. `rpy()` gives roll, pitch, yaw in this order.",
        ko="pitch입니다. `rpy()`는 roll, pitch, yaw 순서로 돌려줍니다.",
    ),
)


TASK = Task(
    id="E5.5",
    kind="F",
    points=3,
    title=Words(en="The shadow on the floor", ko="바닥에 비친 그림자"),
    answer="footprint",
    form=Parts({"x": Number(unit="m"), "y": Number(unit="m"), "yaw": Angle()}),
    inputs=tilted,
    variants=3,
    twins=(ALONG_ITS_OWN_Z, TWICE_ATAN, YAW_OF_THE_INVERSE, SIGN_OF_YAW, ROLL_FOR_YAW, PITCH_FOR_YAW),
    hints=(
        Words(en="Straight below: which of x, y, z change?", ko="바로 아래로 내려가면 x, y, z 가운데 무엇이 바뀝니까?"),
        Words(
            en="`odom_T_base.translation` and `odom_T_base.rpy()` hold all that is needed.",
            ko="필요한 것은 `odom_T_base.translation`과 `odom_T_base.rpy()`에 모두 있습니다.",
        ),
        Words(
            en="x and y stay, and so does the yaw; the rest is dropped.",
            ko="x와 y, 그리고 yaw는 그대로이고 나머지는 버립니다.",
        ),
    ),
    cures=("M5",),
)
