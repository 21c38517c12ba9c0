"""E3.3: The way back."""

from __future__ import annotations

import math
from functools import partial

from tflab.workbook.tasks import Draws, Task, Text, WrongAnswer, WrongStep

from .draws import (
    PLANAR,
    WRONG_TERMS,
    by_formula,
    some_planar,
    wrong_terms,
)


def invert_inputs(rng: Draws) -> list[tuple]:
    quarters = [some_planar(rng) | {"yaw": round(float(way * rng.uniform(low, low + 1.0)), 4)}
                for way in (1, -1) for low in (0.4, 1.9)]  # fmt: skip
    straight = {"x": 2.0, "y": 1.0, "yaw": 0.0}
    on_the_spot = {"x": 0.0, "y": 0.0, "yaw": round(float(rng.uniform(0.4, 1.2)), 4)}
    return [*((pose,) for pose in quarters), (straight,), (on_the_spot,)]


def yaws(yaw: float) -> dict[str, float]:
    """Return what people make of the yaw on the way back."""
    return {
        "back": -yaw,
        "kept": yaw,
        "behind": yaw + math.pi,
        "zero": 0.0,
        "rest of a half": math.pi - yaw,
        "rest of a quarter": math.pi / 2 - yaw,
        "modulo pi": -yaw % math.pi,
        "one over": 1.0 / yaw if yaw else 0.0,
        "converted": -math.radians(yaw),
        "always positive": abs(yaw),
        "always negative": -abs(yaw),
        "asin": -math.asin(math.sin(yaw)),
        "atan": -math.atan(math.tan(yaw)),
    }


def inverted(
    a_pose_b, *, unit="radians", turn="back", step="off", angle="back", y="old", sine="sin"
) -> dict[str, float]:
    """Return b_pose_a, step by step; other steps are the slips."""
    yaw = a_pose_b["yaw"]
    angles = {"back": -yaw, "on": yaw, "none": 0.0, "half": -yaw / 2, "twice": -2 * yaw,
              "asin": -math.asin(math.sin(yaw))}  # fmt: skip
    by = math.radians(angles[angle]) if unit == "degrees" else angles[angle]
    signs = {"off": (-1.0, -1.0), "on": (1.0, 1.0), "x alone": (-1.0, 1.0), "y alone": (1.0, -1.0)}.get(
        step, (1.0, 1.0)
    )
    u, v = signs[0] * a_pose_b["x"], signs[1] * a_pose_b["y"]
    c, s = math.cos(by), math.sin(by)
    c, s = (s, c) if sine == "cos" else (c, s)
    x = c * u - s * v
    x = x if sine != "one sign" else c * u + s * v
    to_y = -s if sine == "sign in y" else s
    by_hand = sine in WRONG_TERMS
    if step == "a quarter":
        return {"x": -a_pose_b["y"], "y": a_pose_b["x"], "yaw": yaws(yaw)[turn]}
    if step == "one over":
        u, v = (1.0 / number if number else 0.0 for number in (a_pose_b["x"], a_pose_b["y"]))
    if by_hand or step == "one over":
        x, straight_y = by_formula(u, v, by, sine) if by_hand else (u, v)
        return {"x": x, "y": straight_y, "yaw": yaws(yaw)[turn]}
    return {
        "x": x,
        "y": to_y * {"old": u, "new": x, "new, taken off": -x}[y] + c * v,
        "yaw": yaws(yaw)[turn],
    }


SIGN_ONLY = WrongStep(
    "sign_only",
    {"angle": "none"},
    Text(
        en="the step is not turned, it has at most got a minus sign. It is measured along a's axes; you need it along b's, "
        "which are turned.",
        ko="이동을 돌리지 않았습니다. 부호를 바꾸는 것만으로는 부족합니다. 그 이동은 a의 축을 따라 잰 값인데, 필요한 것은 돌아가 있는 b의 축을 "
        "따라 잰 값입니다.",
    ),
    "M3",
)


SAME_TURN = WrongStep(
    "same_turn",
    {"angle": "none", "turn": "kept"},
    Text(
        en="the turn has not changed at all: going back, one turns back. And the step needs more than a minus sign.",
        ko="회전이 그대로입니다. 돌아갈 때는 반대로 돌려야 합니다. 이동도 부호만 바꿔서는 모자랍니다.",
    ),
    "M3",
)


TURN_KEPT = WrongStep(
    "turn_kept",
    {"turn": "kept"},
    Text(
        en="the yaw has not changed: going back, one turns back.",
        ko="yaw가 그대로입니다. 돌아갈 때는 반대로 돌려야 합니다.",
    ),
    "M3",
)


X_OVERWRITTEN = WrongStep(
    "x_overwritten",
    {"y": "new"},
    Text(
        en="for `y` you used the new `x`, which had just been overwritten; both need the old "
        "ones. Give the results other names.",
        ko="`y`를 구할 때 방금 덮어쓴 새 `x`를 썼습니다. 둘 다 원래 값으로 계산해야 합니다. 결과에는 "
        "다른 이름을 붙이십시오.",
    ),
)

X_OVERWRITTEN_IN_PLACE = WrongStep(  # x = -(x * c + y * s), and then y = x * s - y * c
    "x overwritten in place",
    {"y": "new, taken off"},
    Text(
        en="your `y` is computed from the result for `x`, which had taken the place of the old `x`. Both results need "
        "the old ones: give them other names.",
        ko="`y`를 원래의 `x`가 아니라, 그 자리에 덮어쓴 결과 `x`로 계산했습니다. 두 결과 모두 원래 값이 필요합니다. 결과에는 "
        "다른 이름을 붙이십시오.",
    ),
)


RADIANS_TWICE = WrongStep(
    "radians_twice",
    {"unit": "degrees"},
    Text(
        en="the step has hardly turned: the yaw comes in radians already, and you converted it once more.",
        ko="이동이 거의 돌지 않았습니다. yaw는 이미 라디안인데 한 번 더 바꾸었습니다.",
    ),
    "M5",
)


TURNED_ON = WrongStep(
    "turned_on",
    {"angle": "on"},
    Text(
        en="you turned the step, but the wrong way: it comes out turned by yaw instead of by minus yaw. If you took a minus "
        "for it, there are two: −yaw once more, or −yaw in a formula whose sines have other signs already. They undo "
        "each other.",
        ko="이동을 돌리기는 했는데 방향이 반대입니다. −yaw가 아니라 yaw만큼 돌아갔습니다. 마이너스를 붙였다면 두 번 붙인 것입니다. "
        "−yaw를 한 번 더 뒤집었거나, sin의 부호가 이미 뒤집힌 공식에 −yaw를 넣으면 서로 지워집니다.",
    ),
)


HALF_A_TURN_OFF = WrongStep(
    "half a turn off",
    {"step": "kept", "angle": "on"},
    Text(
        en="the step is turned by yaw and has kept its sign. Just this comes, too, where sine and cosine of −yaw both get a "
        "minus: of −α the sine is −sin α, and the cosine is cos α as before.",
        ko="이동을 yaw만큼 돌렸고 부호도 그대로입니다. −yaw의 sin과 cos 둘 다에 마이너스를 붙여도 똑같은 값이 나옵니다. −α의 "
        "sin은 −sin α이지만 cos은 그대로 cos α입니다.",
    ),
)


NOT_TAKEN_OFF = WrongStep(
    "not_taken_off",
    {"step": "kept"},
    Text(
        en="the step has kept its sign: from b, the origin of a lies on the other side.",
        ko="이동의 부호가 그대로입니다. b에서 보면 a의 원점은 반대쪽에 있습니다.",
    ),
)


BY_ASIN = WrongStep(
    "by asin",
    {"angle": "asin"},
    Text(
        en="The step is turned by an angle within ±90°, as asin gives it: beyond that it is another angle than the yaw. The yaw is given as it is.",
        ko="이동을 ±90° 이내의 각도로만 돌렸습니다. asin으로 구하면 이렇게 됩니다. 그 밖에서는 이동이 다른 각도로 돌아갑니다. yaw는 그대로 주어져 있습니다.",
    ),
)

SINE_FOR_COSINE = WrongStep(
    "sine for cosine",
    {"sine": "cos"},
    Text(en="sine and cosine have changed places in the turn.", ko="회전 공식에서 sin과 cos의 자리가 바뀌었습니다."),
)

X_ALONE = WrongStep(
    "x_alone",
    {"step": "x alone"},
    Text(
        en="you took x off and left y as it is: the whole step is taken off.",
        ko="x만 빼고 y는 그대로 두었습니다. 이동 전체를 빼야 합니다.",
    ),
)

Y_ALONE = WrongStep(
    "y_alone",
    {"step": "y alone"},
    Text(
        en="you took y off and left x as it is: the whole step is taken off.",
        ko="y만 빼고 x는 그대로 두었습니다. 이동 전체를 빼야 합니다.",
    ),
)

BEHIND = WrongStep(
    "behind",
    {"turn": "behind"},
    Text(
        en="you added half a turn to the yaw. To turn back is to turn by as much the other way.",
        ko="yaw에 반 바퀴를 더했습니다. 되돌린다는 것은 같은 만큼 반대로 도는 것입니다.",
    ),
)

ONE_SIGN = WrongStep(
    "one_sign",
    {"sine": "one sign"},
    Text(
        en="one sine in your x has the wrong sign: look at the formula once more, u·cos α − v·sin α.",
        ko="x의 sin 하나의 부호가 틀렸습니다. 공식을 다시 보십시오. u·cos α − v·sin α입니다.",
    ),
)


SIGN_IN_Y = WrongStep(
    "sign in y",
    {"sine": "sign in y"},
    Text(
        en="one sine in your y has the wrong sign: look at the formula once more, u·sin α + v·cos α.",
        ko="y의 sin 하나의 부호가 틀렸습니다. 공식을 다시 보십시오: u·sin α + v·cos α.",
    ),
)


BY_HALF_THE_ANGLE = WrongStep(
    "by half the angle",
    {"angle": "half"},
    Text(
        en="you turned the step by half the yaw. Halves belong into quaternions; in the plane the step turns by the whole angle.",
        ko="이동을 yaw의 절반만큼 돌렸습니다. 절반은 쿼터니언에서 씁니다. 평면에서는 각도 전체만큼 돌립니다.",
    ),
    "M5",
)


NO_YAW = WrongStep(
    "no yaw",
    {"turn": "zero"},
    Text(
        en="the yaw is 0 for you. Seen from b, a is turned too: as far, and to the other side.",
        ko="yaw를 0으로 두었습니다. b에서 보면 a도 돌아 있습니다. 크기는 같고 방향은 반대입니다.",
    ),
)


REST_OF_HALF_A_TURN = WrongStep(
    "rest of half a turn",
    {"turn": "rest of a half"},
    Text(
        en="you took the yaw off half a turn. To turn back is to turn by as much the other way: minus yaw.",
        ko="반 바퀴에서 yaw를 뺐습니다. 되돌아가는 것은 같은 만큼 반대로 도는 것입니다: -yaw.",
    ),
)


ONE_OVER = WrongStep(
    "one over",
    {"step": "one over"},
    Text(
        en="you divided 1 by the numbers. The inverse of a pose is no one-over: it is the way back, from b to a, turned and stepped.",
        ko="1을 숫자로 나누었습니다. 포즈의 역은 역수가 아니라 b에서 a로 돌아가는 길입니다. 회전과 이동을 되돌리십시오.",
    ),
    "M3",
)


A_QUARTER_TURN = WrongStep(
    "a quarter turn",
    {"step": "a quarter"},
    Text(
        en="x and y have changed places, one with a minus: that is right only for a yaw of π/2, a quarter "
        "turn. The step turns back by the yaw that comes in.",
        ko="x와 y의 자리를 바꾸고 하나만 부호를 뒤집었습니다. 1/4 바퀴를 되돌린 값이고, yaw가 π/2일 때만 맞습니다. 이동은 "
        "받은 yaw만큼 되돌립니다.",
    ),
    "M3",
)


ONE_OVER_THE_YAW = WrongStep(
    "one over the yaw",
    {"turn": "one over"},
    Text(
        en="your yaw is 1 divided by the yaw. To turn back is to turn by as much the other way.",
        ko="1을 yaw로 나누었습니다. 돌아갈 때는 같은 만큼 반대쪽으로 돕니다.",
    ),
    "M3",
)


BY_TWICE_THE_ANGLE = WrongStep(
    "by twice the angle",
    {"angle": "twice"},
    Text(
        en="the step is turned twice as far as it should be: by minus twice the yaw. Once is enough.",
        ko="이동이 두 배로 돌았습니다. −yaw의 두 배만큼 돌린 값입니다. 한 번만 돌립니다.",
    ),
)


# what only the yaw shows stands alone: beside a slip of x and y it is found part by part
YAW_CONVERTED = WrongAnswer(
    "yaw converted",
    partial(inverted, turn="converted"),
    Text(
        en="the yaw went through `math.radians`, and it is in radians already: what you give is hardly turned.",
        ko="이미 라디안인 yaw를 `math.radians`에 한 번 더 넣었습니다. 답한 yaw가 거의 0입니다.",
    ),
    "M5",
)


ALWAYS_POSITIVE = WrongAnswer(
    "yaw always positive",
    partial(inverted, turn="always positive"),
    Text(
        en="your yaw is never negative, as by `abs`. To turn back from a turn to the left is to turn to the right.",
        ko="`abs`를 쓴 것처럼 yaw가 음수인 적이 없습니다. 왼쪽으로 돈 것을 되돌리려면 오른쪽으로 돕니다.",
    ),
)


ALWAYS_NEGATIVE = WrongAnswer(
    "yaw always negative",
    partial(inverted, turn="always negative"),
    Text(
        en="your yaw is never positive, as by `-abs` or `-acos`. To turn back from a turn to the right is to turn to the "
        "left.",
        ko="`-abs`나 `-acos`를 쓴 것처럼 yaw가 양수인 적이 없습니다. 오른쪽으로 돈 것을 되돌리려면 왼쪽으로 돕니다.",
    ),
)


YAW_BY_ASIN = WrongAnswer(
    "yaw by asin",
    partial(inverted, turn="asin"),
    Text(
        en="beyond a quarter turn your yaw comes out smaller than it is, as by `asin`, which never gives more than π/2. "
        "The yaw came in as an angle: no arc is needed.",
        ko="1/4 바퀴를 넘는 yaw가 실제보다 작게 나옵니다. `asin`은 π/2보다 큰 각도를 내지 않습니다. yaw는 각도로 "
        "들어오므로 역함수가 필요 없습니다.",
    ),
)


REST_OF_A_QUARTER = WrongAnswer(
    "rest of a quarter turn",
    partial(inverted, turn="rest of a quarter"),
    Text(
        en="you took the yaw off a quarter turn. To turn back is to turn by as much the other way.",
        ko="1/4 바퀴에서 yaw를 뺐습니다. 되돌아가는 것은 같은 만큼 반대로 도는 것입니다.",
    ),
)


YAW_MODULO_PI = WrongAnswer(
    "yaw modulo pi",
    partial(inverted, turn="modulo pi"),
    Text(
        en="your yaw always lies between 0 and π, as by `% math.pi`: half turns are lost. A full turn is 2π.",
        ko="`% math.pi`를 쓴 것처럼 yaw가 언제나 0과 π 사이입니다. 반 바퀴가 사라집니다. 한 바퀴는 2π입니다.",
    ),
)


YAW_BY_ATAN = WrongAnswer(
    "yaw by atan",
    partial(inverted, turn="atan"),
    Text(
        en="beyond a quarter turn your yaw is half a turn off, as by `atan`, which never gives more than π/2. The yaw "
        "came in as an angle: no arc is needed.",
        ko="1/4 바퀴를 넘으면 yaw가 반 바퀴 어긋납니다. `atan`은 π/2보다 큰 각도를 내지 않습니다. yaw는 각도로 "
        "들어오므로 역함수가 필요 없습니다.",
    ),
)


SINE_FOR_COSINE_BY_HAND = WrongAnswer(
    "sine for cosine, by hand",
    lambda pose: {
        "x": -math.sin(pose["yaw"]) * pose["x"] - math.cos(pose["yaw"]) * pose["y"],
        "y": math.cos(pose["yaw"]) * pose["x"] - math.sin(pose["yaw"]) * pose["y"],
        "yaw": -pose["yaw"],
    },
    Text(
        en="where a cosine belongs stands a sine, and where a sine belongs a cosine.",
        ko="cos이 올 자리에 sin이, sin이 올 자리에 cos이 있습니다.",
    ),
)


TASK = Task(
    id="E3.3",
    kind="F",
    points=4,
    title=Text(en="The way back", ko="돌아가는 길"),
    answer="invert",
    form=PLANAR,
    inputs=invert_inputs,
    variants=3,
    model=inverted,
    mistakes=(
        SIGN_ONLY,
        SAME_TURN,
        TURNED_ON,
        NOT_TAKEN_OFF,
        HALF_A_TURN_OFF,
        TURN_KEPT,
        X_OVERWRITTEN,
        X_OVERWRITTEN_IN_PLACE,
        RADIANS_TWICE,
        BY_ASIN,
        SINE_FOR_COSINE,
        X_ALONE,
        Y_ALONE,
        BEHIND,
        ONE_SIGN,
        SIGN_IN_Y,
        BY_HALF_THE_ANGLE,
        NO_YAW,
        REST_OF_HALF_A_TURN,
        *wrong_terms("sine"),
        ONE_OVER,
        A_QUARTER_TURN,
        ONE_OVER_THE_YAW,
        BY_TWICE_THE_ANGLE,
        YAW_CONVERTED,
        ALWAYS_POSITIVE,
        ALWAYS_NEGATIVE,
        YAW_BY_ASIN,
        REST_OF_A_QUARTER,
        YAW_MODULO_PI,
        YAW_BY_ATAN,
        SINE_FOR_COSINE_BY_HAND,
    ),
    hints=(
        Text(
            en="Going there is: turn by yaw, then step by (x, y). Going back undoes the last thing first.",
            ko="가는 길은 yaw만큼 돌고 (x, y)만큼 옮기는 것입니다. 돌아갈 때는 나중에 한 것부터 되돌립니다.",
        ),
        Text(
            en="(−x, −y) takes the step off, along a's axes. Along b's axes it looks different: b is turned.",
            ko="(−x, −y)는 a의 축을 따라 이동을 되돌립니다. b는 돌아가 있으므로 b의 축을 따르면 값이 달라집니다.",
        ),
        Text(
            en="Turn (−x, −y) by −yaw: in the formula, u is −x, v is −y, and the angle is −yaw.",
            ko="(−x, −y)를 −yaw만큼 돌리십시오. 공식에서 u는 −x, v는 −y, 각도는 −yaw입니다.",
        ),
    ),
    misconceptions=("M3",),
)
