"""E3.3: The way back."""

from __future__ import annotations

import math

import numpy as np

from tflab.workbook.tasks import Task, Twin, Words

from .draws import PLANAR, moved, some_planar


def invert_inputs(rng: np.random.Generator) -> list[tuple]:
    straight = {"x": 2.0, "y": 1.0, "yaw": 0.0}
    on_the_spot = {"x": 0.0, "y": 0.0, "yaw": round(float(rng.uniform(0.4, 1.2)), 4)}
    return [(some_planar(rng),), (some_planar(rng),), (some_planar(rng),), (some_planar(rng),), (straight,),
            (on_the_spot,)]  # fmt: skip


def sign_only(a_pose_b: dict) -> dict[str, float]:
    return {"x": -a_pose_b["x"], "y": -a_pose_b["y"], "yaw": -a_pose_b["yaw"]}


SIGN_ONLY = Twin(
    "sign_only",
    sign_only,
    Words(
        en="the step has only got a minus sign. It is measured along a's axes; you need it along b's, "
        "which are turned. Without a turn you are right, and only then.",
        ko="이동에 마이너스만 붙였습니다. 그 이동은 a의 축을 따라 잰 값인데, 필요한 것은 돌아가 있는 b의 축을 "
        "따라 잰 값입니다. 회전이 없을 때만 맞습니다.",
    ),
    "M3",
)


def sign_and_same_turn(a_pose_b: dict) -> dict[str, float]:
    return {"x": -a_pose_b["x"], "y": -a_pose_b["y"], "yaw": a_pose_b["yaw"]}


SAME_TURN = Twin(
    "same_turn",
    sign_and_same_turn,
    Words(
        en="the turn has not changed at all: going back, one turns back. And the step needs more than a minus sign.",
        ko="회전이 그대로입니다. 돌아갈 때는 반대로 돌려야 합니다. 이동도 부호만 바꿔서는 모자랍니다.",
    ),
    "M3",
)


def turn_kept(a_pose_b: dict) -> dict[str, float]:
    return moved(a_pose_b, -a_pose_b["x"], -a_pose_b["y"], -a_pose_b["yaw"])


TURN_KEPT = Twin(
    "turn_kept",
    turn_kept,
    Words(
        en="`x` and `y` are right. The yaw has not changed: going back, one turns back.",
        ko="`x`와 `y`는 맞습니다. yaw가 그대로입니다. 돌아갈 때는 반대로 돌려야 합니다.",
    ),
    "M3",
)


def x_overwritten(a_pose_b: dict) -> dict[str, float]:
    yaw, x, y = -a_pose_b["yaw"], -a_pose_b["x"], -a_pose_b["y"]
    x = math.cos(yaw) * x - math.sin(yaw) * y
    y = math.sin(yaw) * x + math.cos(yaw) * y
    return {"x": x, "y": y, "yaw": yaw}


X_OVERWRITTEN = Twin(
    "x_overwritten",
    x_overwritten,
    Words(
        en="`x` is right. For `y` you used the new `x`, which had just been overwritten; both need the old "
        "ones. Give the results other names.",
        ko="`x`는 맞습니다. `y`를 구할 때 방금 덮어쓴 새 `x`를 썼습니다. 둘 다 원래 값으로 계산해야 합니다. 결과에는 "
        "다른 이름을 붙이십시오.",
    ),
)


def radians_twice(a_pose_b: dict) -> dict[str, float]:
    return moved({"yaw": -a_pose_b["yaw"]}, -a_pose_b["x"], -a_pose_b["y"], -math.radians(a_pose_b["yaw"]))


RADIANS_TWICE = Twin(
    "radians_twice",
    radians_twice,
    Words(
        en="the step has hardly turned: the yaw comes in radians already, and you converted it once more.",
        ko="이동이 거의 돌지 않았습니다. yaw는 이미 라디안인데 한 번 더 바꾸었습니다.",
    ),
    "M5",
)


def turned_on(a_pose_b: dict) -> dict[str, float]:
    back = {"yaw": -a_pose_b["yaw"]}
    return moved(back, -a_pose_b["x"], -a_pose_b["y"], a_pose_b["yaw"])


TURNED_ON = Twin(
    "turned_on",
    turned_on,
    Words(
        en="you turned the step, but the wrong way: by yaw instead of by minus yaw. Try it with a quarter "
        "turn to the left and stand up.",
        ko="이동을 돌리기는 했는데 방향이 반대입니다. −yaw가 아니라 yaw로 돌렸습니다. 왼쪽으로 90° 돌린 경우를 "
        "일어서서 직접 해 보십시오.",
    ),
)


def not_taken_off(a_pose_b: dict) -> dict[str, float]:
    back = {"yaw": -a_pose_b["yaw"]}
    return moved(back, a_pose_b["x"], a_pose_b["y"], -a_pose_b["yaw"])


NOT_TAKEN_OFF = Twin(
    "not_taken_off",
    not_taken_off,
    Words(
        en="the turn is right, and the step has kept its sign: from b, the origin of a lies on the other side.",
        ko="회전은 맞지만 이동의 부호가 그대로입니다. b에서 보면 a의 원점은 반대쪽에 있습니다.",
    ),
)


TASK = Task(
    id="E3.3",
    kind="F",
    points=4,
    title=Words(en="The way back", ko="돌아가는 길"),
    answer="invert",
    form=PLANAR,
    inputs=invert_inputs,
    variants=3,
    twins=(
        SIGN_ONLY,
        SAME_TURN,
        TURNED_ON,
        NOT_TAKEN_OFF,
        TURN_KEPT,
        X_OVERWRITTEN,
        RADIANS_TWICE,
    ),
    hints=(
        Words(
            en="Going there is: turn by yaw, then step by (x, y). Going back undoes the last thing first.",
            ko="가는 길은 yaw만큼 돌고 (x, y)만큼 옮기는 것입니다. 돌아갈 때는 나중에 한 것부터 되돌립니다.",
        ),
        Words(
            en="(−x, −y) takes the step off, along a's axes. Along b's axes it looks different: b is turned.",
            ko="(−x, −y)는 a의 축을 따라 이동을 되돌립니다. b는 돌아가 있으므로 b의 축을 따르면 값이 달라집니다.",
        ),
        Words(
            en="Turn (−x, −y) by −yaw: in the formula, u is −x, v is −y, and the angle is −yaw.",
            ko="(−x, −y)를 −yaw만큼 돌리십시오. 공식에서 u는 −x, v는 −y, 각도는 −yaw입니다.",
        ),
    ),
    cures=("M3",),
)
