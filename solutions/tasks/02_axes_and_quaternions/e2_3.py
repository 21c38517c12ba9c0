"""E2.3: The quaternion of a yaw."""

from __future__ import annotations

import math

from tflab.workbook.tasks import Draws, Quaternion, Task, Text, WrongAnswer, WrongStep


def yaws(rng: Draws) -> list[tuple[float]]:
    """Draw turns to the left and to the right, small and large, and the two that are easy to get right by chance."""
    drawn = (rng.uniform(0.3, 1.4), -rng.uniform(0.3, 1.4), rng.uniform(1.8, 2.9), -rng.uniform(1.8, 2.9))
    return [(0.0,), (math.pi / 2,), (4.0,), (-5.5,), *((round(float(yaw), 3),) for yaw in drawn)]


def turned(yaw, *, unit="radians", half="inside", z="sine", way="left", axis="z", order="w last"):
    """Return the quaternion, step by step; other steps are the slips."""
    yaw = {"radians": yaw, "degrees": math.radians(yaw), "to degrees": math.degrees(yaw)}[unit]
    angle = {"inside": yaw / 2, "none": yaw, "outside": yaw, "sine outside": yaw, "cosine outside": yaw, "double": 2 * yaw, "whole number": yaw // 2, "quarter": yaw / 4,
             "of the sine alone": yaw / 2, "of the cosine alone": yaw, "modulo pi": yaw % math.pi / 2}[half]  # fmt: skip
    sine, cosine = math.sin(angle), math.cos(yaw if half == "of the sine alone" else angle)
    cosine = math.cos(yaw / 2) if half == "of the cosine alone" else cosine
    if half in ("outside", "sine outside"):
        sine, cosine = sine / 2, math.cos(yaw / 2) if half == "sine outside" else cosine / 2
    if half == "cosine outside":
        sine, cosine = math.sin(yaw / 2), cosine / 2
    sine, cosine = {
        "sine": (sine, cosine),
        "cosine": (cosine, sine),
        "squares": (sine**2, cosine**2),
        "angle": (yaw, 1.0),
        "half of it": (yaw / 2, 1.0),
        "angle beside the cosine": (yaw, cosine),
        "half of it beside the cosine": (yaw / 2, cosine),
        "angle alone": (yaw, 0.0),
        "tangent": (math.tan(yaw / 2), 1.0),
        "positive": (abs(sine), cosine),
        "w positive": (sine, abs(cosine)),
        "both positive": (abs(sine), abs(cosine)),
        "all three": (sine, cosine),
        "diagonal": (sine, cosine),
        "sine alone": (sine, 0.0),
        "sine beside one": (sine, 1.0),
        "half of it beside its root": (yaw / 2, math.sqrt(max(0.0, 1.0 - (yaw / 2) ** 2))),
        "sine beside the rest": (sine, 1.0 - sine),
        "sine beside the rest of its size": (sine, 1.0 - abs(sine)),
        "sine beside the square": (sine, 1.0 - sine**2),
        "angle to length one": (yaw / math.hypot(yaw, 1.0), 1.0 / math.hypot(yaw, 1.0)),
        "half of it to length one": (yaw / math.hypot(yaw, 2.0), 2.0 / math.hypot(yaw, 2.0)),
    }[z]
    sine = -sine if way == "right" else sine
    sine = sine / math.sqrt(3.0) if z == "diagonal" else sine
    row = [sine if z in ("all three", "diagonal") or name == axis else 0.0 for name in "xyz"]
    return (cosine, *row) if order == "w first" else (*row, cosine)


WHOLE_ANGLE = WrongStep(
    "whole angle",
    {"half": "none"},
    Text(
        en="This turns twice as far as asked: a quaternion holds half the angle. Try 90°: your robot looks backwards.",
        ko="두 배나 돌았습니다. 쿼터니언에는 각도의 절반이 들어갑니다. 90°를 넣어 보십시오. 로봇이 뒤를 보고 있습니다.",
    ),
    misconception="M5",
)


DEGREES = WrongStep(
    "degrees",
    {"unit": "degrees"},
    Text(
        en="You took the argument for degrees. It comes in radians already (REP-103), and math.sin wants radians.",
        ko="인자를 도(degree)로 받아들였습니다. 이미 라디안으로 들어오며(REP-103), math.sin도 라디안을 받습니다.",
    ),
    misconception="M5",
)


W_FIRST = WrongStep(
    "w first",
    {"order": "w first"},
    Text(
        en="The four numbers are right, their order is not: this is (w, x, y, z). ROS writes w last. For a yaw of 0 your robot lies on its back.",
        ko="숫자 네 개는 맞지만 순서가 (w, x, y, z)입니다. ROS는 w를 마지막에 씁니다. yaw가 0일 때 로봇이 뒤집혀 누워 있습니다.",
    ),
    misconception="M5",
)


SINE_AND_COSINE = WrongStep(
    "sine and cosine",
    {"z": "cosine"},
    Text(
        en="Sine and cosine changed places. Try a yaw of 0: 'no rotation' is (0, 0, 0, 1), and yours?",
        ko="sin과 cos의 자리가 바뀌었습니다. yaw에 0을 넣어 보십시오. '회전 없음'은 (0, 0, 0, 1)인데 어떤 값이 나옵니까?",
    ),
    misconception="M5",
)


TO_THE_RIGHT = WrongStep(
    "to the right",
    {"way": "right"},
    Text(
        en="Your robot turns as far as asked, and to the other side. A positive yaw goes from x towards y, to the left.",
        ko="도는 크기는 맞지만 반대쪽으로 돕니다. 양의 yaw는 x에서 y 쪽, 곧 왼쪽으로 돕니다.",
    ),
)


ABOUT_X = WrongStep(
    "about x",
    {"axis": "x"},
    Text(
        en="This is a roll: the sine stands in x. Which axis does a yaw turn about?",
        ko="이것은 roll입니다. sin이 x 자리에 있습니다. yaw는 어느 축을 중심으로 돕니까?",
    ),
)


ABOUT_Y = WrongStep(
    "about y",
    {"axis": "y"},
    Text(
        en="This is a pitch: the sine stands in y, and your robot nods. Which axis does a yaw turn about?",
        ko="이것은 pitch입니다. sin이 y 자리에 있어서 로봇이 고개를 끄덕입니다. yaw는 어느 축을 중심으로 돕니까?",
    ),
)


ANGLE_IN_Z = WrongStep(
    "angle in z",
    {"z": "angle"},
    Text(
        en="You wrote the angle itself into z. A quaternion holds no angle: z takes the sine of half of it, w the cosine.",
        ko="z에 각도를 그대로 넣었습니다. 쿼터니언에는 각도가 직접 들어가지 않습니다. z에는 각도 절반의 sin, w에는 cos을 넣으십시오.",
    ),
    misconception="M5",
)


HALVED_OUTSIDE = WrongStep(
    "halved outside",
    {"half": "outside"},
    Text(
        en="You halved the sine, not the angle. The half belongs inside the brackets; look at the length of what you return.",
        ko="각도가 아니라 sin을 절반으로 나누었습니다. 절반은 괄호 안에서 나누어야 합니다. 반환한 값의 길이를 보십시오.",
    ),
    misconception="M5",
)

TO_DEGREES = WrongStep(
    "to degrees",
    {"unit": "to degrees"},
    Text(
        en="You turned the argument into degrees first. math.sin wants radians, as it comes.",
        ko="인자를 도(degree)로 바꾸었습니다. math.sin은 들어온 그대로의 라디안을 받습니다.",
    ),
    "M5",
)

DOUBLE = WrongStep(
    "doubled",
    {"half": "double"},
    Text(
        en="You doubled the angle where it is to be halved.",
        ko="각도를 절반으로 나누어야 하는데 두 배로 했습니다.",
    ),
    "M5",
)

WHOLE_NUMBER = WrongStep(
    "whole number",
    {"half": "whole number"},
    Text(
        en="`//` cuts the half down to a whole number. `/` keeps the rest.",
        ko="`//`는 절반을 정수로 잘라 버립니다. `/`를 쓰십시오.",
    ),
)

SINE_HALVED_ALONE = WrongStep(
    "cosine of the whole",
    {"half": "of the sine alone"},
    Text(
        en="The sine is of half the angle, the cosine still of the whole: both take the half.",
        ko="sin은 각도의 절반으로, cos은 아직 전체 각도로 계산했습니다. 둘 다 절반을 씁니다.",
    ),
    "M5",
)

SMALL_ANGLE = WrongStep(
    "half the angle in z",
    {"z": "half of it"},
    Text(
        en="You wrote half the angle itself into z, and 1 into w. That is close for a small angle only: z takes the sine of the half, w the cosine.",
        ko="z에 각도의 절반을 그대로, w에 1을 넣었습니다. 작은 각도에서만 비슷합니다. z에는 절반의 sin, w에는 cos을 넣으십시오.",
    ),
    "M5",
)

ANGLE_ALONE = WrongStep(
    "angle alone",
    {"z": "angle alone"},
    Text(
        en="You wrote the angle into z and left w at 0. The four numbers are no angles: z takes the sine of half of it, w the cosine.",
        ko="z에 각도를 넣고 w를 0으로 두었습니다. 숫자 네 개는 각도가 아닙니다. z에는 절반의 sin, w에는 cos을 넣으십시오.",
    ),
    "M5",
)

TANGENT = WrongStep(
    "tangent",
    {"z": "tangent"},
    Text(
        en="z is the tangent of the half, and w is 1: the direction is right, the length is not 1. Take the sine and the cosine.",
        ko="z에 절반의 tan, w에 1을 넣었습니다. 방향은 맞지만 길이가 1이 아닙니다. sin과 cos을 쓰십시오.",
    ),
    "M5",
)

NEVER_RIGHT = WrongStep(
    "never to the right",
    {"z": "positive"},
    Text(
        en="Every turn to the right comes out as the same one to the left: z has lost its sign, or w took it. The sine of a negative angle is negative, its cosine is not turned.",
        ko="오른쪽으로 도는 회전이 모두 같은 크기의 왼쪽 회전이 됩니다. z의 부호가 사라졌거나 w에 붙었습니다. 음의 각도의 sin은 음수이고, cos은 그대로입니다.",
    ),
)

W_NEVER_NEGATIVE = WrongStep(
    "w never negative",
    {"z": "w positive"},
    Text(
        en="w has lost its sign: beyond half a turn the cosine of the half is negative. Did a square root make it positive?",
        ko="w의 부호가 사라졌습니다. 반 바퀴를 넘으면 절반의 cos은 음수입니다. 제곱근을 써서 양수가 되지 않았습니까?",
    ),
)

ALL_THREE = WrongStep(
    "about all three axes",
    {"z": "all three"},
    Text(
        en="The sine stands in x, y and z. A yaw turns about z alone: x and y are 0.",
        ko="sin이 x, y, z에 모두 있습니다. yaw는 z축만 중심으로 돕니다. x와 y는 0입니다.",
    ),
)


ABOUT_THE_DIAGONAL = WrongStep(
    "about the diagonal",
    {"z": "diagonal"},
    Text(
        en="x, y and z share the sine: this turns about the diagonal (1, 1, 1). The axis of a yaw is (0, 0, 1): x and y are 0.",
        ko="x, y, z가 sin을 나누어 가졌습니다. 대각선 (1, 1, 1) 둘레의 회전입니다. yaw의 축은 (0, 0, 1)이므로 x와 y는 0입니다.",
    ),
)


QUARTER_OF_THE_ANGLE = WrongStep(
    "quarter of the angle",
    {"half": "quarter"},
    Text(
        en="You halved the angle twice: your robot turns half as far as asked.",
        ko="각도를 두 번 반으로 나누었습니다. 로봇이 절반만 돕니다.",
    ),
    "M5",
)


SINE_OF_THE_WHOLE = WrongStep(
    "sine of the whole",
    {"half": "of the cosine alone"},
    Text(
        en="The cosine is of half the angle, the sine still of the whole: both take the half.",
        ko="cos에는 절반이 들어갔지만 sin에는 각도가 그대로 들어갔습니다. 둘 다 절반입니다.",
    ),
    "M5",
)


MODULO_PI = WrongStep(
    "modulo pi",
    {"half": "modulo pi"},
    Text(
        en="You took the angle modulo π: every turn to the right, and every one to the left from half a circle on, comes out as another. An angle needs no wrapping here.",
        ko="각도를 π로 나눈 나머지를 썼습니다. 오른쪽 회전과, 왼쪽으로 반 바퀴부터의 회전이 모두 다른 각도가 됩니다. 여기서는 각도를 감을 필요가 없습니다.",
    ),
)


W_LEFT_AT_ZERO = WrongStep(
    "w left at zero",
    {"z": "sine alone"},
    Text(
        en="w is still 0: it takes the cosine of half the angle. Without it this is half a turn, or nothing at all.",
        ko="w가 아직 0입니다. 각도 절반의 cos이 들어갑니다. 그것이 없으면 반 바퀴이거나 아무것도 아닙니다.",
    ),
    "M5",
)


W_LEFT_AT_ONE = WrongStep(
    "w left at one",
    {"z": "sine beside one"},
    Text(
        en="w is still 1: it takes the cosine of half the angle, so that the length stays one.",
        ko="w가 아직 1입니다. 길이가 1이 되도록 각도 절반의 cos을 넣어야 합니다.",
    ),
    "M5",
)


HALF_ANGLE_AND_ITS_ROOT = WrongStep(
    "half angle and its root",
    {"z": "half of it beside its root"},
    Text(
        en="z holds half the angle itself, and w what makes the length one. For small angles that is close, for large ones not: z takes the sine.",
        ko="z에 각도의 절반을 그대로 넣고 w로 길이를 1에 맞추었습니다. 작은 각도에서는 비슷하지만 큰 각도에서는 다릅니다. z에는 sin을 넣습니다.",
    ),
    "M5",
)


HALF_TO_LENGTH_ONE = WrongStep(
    "half the angle to length one",
    {"z": "half of it to length one"},
    Text(
        en="You wrote half the angle itself into z, 1 into w, and scaled them to length one. For small angles that is close, for large ones not: z takes the sine of the half, w the cosine.",
        ko="z에 각도의 절반, w에 1을 넣고 길이를 1로 맞추었습니다. 작은 각도에서는 비슷하지만 큰 각도에서는 다릅니다. z에는 절반의 sin, w에는 cos을 넣습니다.",
    ),
    "M5",
)


ANGLE_TO_LENGTH_ONE = WrongStep(
    "angle to length one",
    {"z": "angle to length one"},
    Text(
        en="You wrote the angle into z and scaled the four numbers to length one. z is the sine of half the angle, w the cosine.",
        ko="z에 각도를 넣고 숫자 네 개의 길이를 1로 맞추었습니다. z는 각도 절반의 sin, w는 cos입니다.",
    ),
    "M5",
)

ANGLE_BESIDE_THE_COSINE = WrongStep(
    "angle beside the cosine",
    {"z": "angle beside the cosine"},
    Text(
        en="z holds the angle itself, beside a cosine in w. A quaternion holds no angle: z takes the sine of half of it.",
        ko="w에는 cos이 있지만 z에 각도 자체를 넣었습니다. 쿼터니언에는 각도가 없습니다. z에는 각도 절반의 sin을 넣습니다.",
    ),
    misconception="M5",
)

HALF_BESIDE_THE_COSINE = WrongStep(
    "half of it beside the cosine",
    {"z": "half of it beside the cosine"},
    Text(
        en="z holds half of the angle, beside a cosine in w. z takes the sine of that half.",
        ko="w에는 cos이 있지만 z에 각도의 절반을 넣었습니다. z에는 그 절반의 sin을 넣습니다.",
    ),
    misconception="M5",
)


REST_OF_ONE = WrongStep(
    "what is left of one",
    {"z": "sine beside the rest"},
    Text(
        en="You took 1 minus z for w. Sine and cosine are no shares of one, their squares are: w is the cosine of half the angle.",
        ko="w에 1에서 z를 뺀 값을 썼습니다. 더해서 1이 되는 것은 sin과 cos이 아니라 그 제곱입니다. w는 각도 절반의 cos입니다.",
    ),
    "M5",
)


ROOT_FORGOTTEN = WrongStep(
    "root forgotten",
    {"z": "sine beside the square"},
    Text(
        en="w is 1 minus the square of z, which is the square of the cosine: the root is missing, and its sign beyond half a turn.",
        ko="w가 1에서 z의 제곱을 뺀 값, 곧 cos의 제곱입니다. 제곱근과, 반 바퀴를 넘을 때의 부호가 빠졌습니다.",
    ),
    "M5",
)


SQUARES = WrongStep(
    "squares",
    {"z": "squares"},
    Text(
        en="You squared sine and cosine. Their squares add up to one, and the numbers themselves are the quaternion.",
        ko="sin과 cos을 제곱했습니다. 제곱의 합이 1이 되는 것이고, 쿼터니언에는 제곱하지 않은 값을 넣습니다.",
    ),
    "M5",
)


NO_SIGN_AT_ALL = WrongStep(
    "no sign at all",
    {"z": "both positive"},
    Text(
        en="Neither z nor w is ever negative here, as if both came from square roots, or the angle from acos: the signs are lost. For a turn to the right by less than half a circle z is negative, and beyond half a turn w is. Sine and cosine of half the angle have both signs.",
        ko="z도 w도 음수가 되지 않습니다. 둘 다 제곱근으로 구했거나 각도를 acos으로 구한 것처럼 부호가 사라졌습니다. 오른쪽으로 반 바퀴보다 적게 돌면 z가, 반 바퀴를 넘으면 w가 음수입니다. 각도 절반의 sin과 cos에는 두 부호가 모두 들어 있습니다.",
    ),
)


SINE_HALVED_OUTSIDE = WrongStep(
    "sine halved outside",
    {"half": "sine outside"},
    Text(
        en="w is right, and z is half of the sine of the whole angle. The half belongs inside the brackets: the sine of half the angle.",
        ko="w는 맞지만 z가 각도 전체의 sin을 2로 나눈 값입니다. 절반은 괄호 안에서 나누어야 합니다. z는 각도 절반의 sin입니다.",
    ),
    "M5",
)


COSINE_HALVED_OUTSIDE = WrongStep(
    "cosine halved outside",
    {"half": "cosine outside"},
    Text(
        en="z is right, and w is half of the cosine of the whole angle. The half belongs inside the brackets: the cosine of half the angle.",
        ko="z는 맞지만 w가 각도 전체의 cos을 2로 나눈 값입니다. 절반은 괄호 안에서 나누어야 합니다. w는 각도 절반의 cos입니다.",
    ),
    "M5",
)


REST_OF_THE_SIZE = WrongStep(
    "what the size leaves of one",
    {"z": "sine beside the rest of its size"},
    Text(
        en="w is 1 minus the size of z. The two add up to one only when they are squared: w is the cosine of half the angle.",
        ko="w가 1에서 z의 크기를 뺀 값입니다. 둘은 제곱해야 더해서 1이 됩니다. w는 각도 절반의 cos입니다.",
    ),
    "M5",
)


def of_yaw(name: str, answer, en: str, ko: str, misconception: str = "M5") -> WrongAnswer:
    """Return an answer that stands alone: it composes with no other slip."""
    return WrongAnswer(name, answer, Text(en=en, ko=ko), misconception)


def held_within(yaw: float, bound: float) -> tuple[float, float, float, float]:
    """Return the quaternion of a yaw that is cut off at a bound to either side."""
    return turned(max(-bound, min(bound, yaw)))


ALONE = (
    of_yaw(
        "axis and angle",
        lambda yaw: (0.0, 0.0, 1.0, yaw),
        "These are an axis and an angle: (0, 0, 1) and the yaw. In a quaternion z takes the sine of half the angle, w the "
        "cosine.",
        "축 (0, 0, 1)과 각도를 나란히 적었습니다. 쿼터니언에서는 z에 각도 절반의 sin, w에 cos이 들어갑니다.",
    ),
    of_yaw(
        "angle in w",
        lambda yaw: (0.0, 0.0, math.sin(yaw / 2), yaw),
        "The angle itself stands in w. A quaternion holds no angle: w takes the cosine of half of it.",
        "w에 각도를 그대로 넣었습니다. 쿼터니언에는 각도가 직접 들어가지 않습니다. w에는 각도 절반의 cos을 넣습니다.",
    ),
    of_yaw(
        "half the angle in w",
        lambda yaw: (0.0, 0.0, math.sin(yaw / 2), yaw / 2),
        "Half the angle itself stands in w. w takes the cosine of it.",
        "w에 각도의 절반을 그대로 넣었습니다. w에는 그 cos을 넣습니다.",
    ),
    of_yaw(
        "one in z",
        lambda yaw: (0.0, 0.0, 1.0, math.cos(yaw / 2)),
        "z is always 1, as in the axis. It takes the sine of half the angle: how far the turn goes is in z as well.",
        "z가 축의 값처럼 언제나 1입니다. z에는 각도 절반의 sin을 넣습니다. 얼마나 도는지는 z에도 들어 있습니다.",
    ),
    of_yaw(
        "a direction",
        lambda yaw: (math.cos(yaw), math.sin(yaw), 0.0, 0.0),
        "This is the direction in which the robot looks, (cos, sin), in x and y. A quaternion of a yaw has 0 there.",
        "로봇이 보는 방향 (cos, sin)을 x와 y에 넣었습니다. yaw의 쿼터니언에서는 x와 y가 0입니다.",
    ),
    of_yaw(
        "a direction and a one",
        lambda yaw: (math.cos(yaw), math.sin(yaw), 0.0, 1.0),
        "x and y hold a direction, (cos, sin), and w a 1. Of a turn about z, x and y are 0; z and w tell how far it goes.",
        "x와 y에 방향 (cos, sin)을, w에 1을 넣었습니다. z축 회전에서는 x와 y가 0이고 얼마나 도는지는 z와 w로 나타냅니다.",
    ),
    of_yaw(
        "halves in x and y",
        lambda yaw: (math.cos(yaw / 2), math.sin(yaw / 2), 0.0, 1.0),
        "Cosine and sine of the half stand in x and y. They belong into w and z: a turn about z has 0 in x and y.",
        "절반의 cos과 sin이 x와 y에 있습니다. 그 자리는 w와 z입니다. z축 회전에서는 x와 y가 0입니다.",
    ),
    of_yaw(
        "zeros for no turn",
        lambda yaw: turned(yaw) if yaw else (0.0, 0.0, 0.0, 0.0),
        "For a yaw of 0 you give four zeros. That is no rotation at all, and TF refuses it; not to turn is (0, 0, 0, 1).",
        "yaw가 0일 때 숫자 네 개가 모두 0입니다. 그것은 회전이 아니며 TF가 거절합니다. 돌지 않는 회전은 (0, 0, 0, 1)입니다.",
    ),
    of_yaw(
        "by atan",
        lambda yaw: turned(math.atan(math.tan(yaw))),
        "The angle was brought to between -π/2 and π/2, as `atan` gives it: a yaw beyond a quarter turn comes out as another. "
        "It needs no wrapping: sine and cosine take any angle.",
        "`atan`처럼 각도를 -π/2와 π/2 사이로 옮겼습니다. 1/4 바퀴를 넘는 yaw는 다른 각도가 됩니다. 각도를 감을 필요가 "
        "없습니다. sin과 cos은 어떤 각도든 받습니다.",
    ),
    of_yaw(
        "by asin",
        lambda yaw: turned(math.asin(math.sin(yaw))),
        "The angle was worked out by `asin`, which knows nothing beyond a quarter turn: there a yaw comes out as its mirror "
        "image. It needs no wrapping: sine and cosine take any angle.",
        "`asin`으로 각도를 구했습니다. asin은 1/4 바퀴 너머를 알지 못해 그보다 큰 yaw가 거울에 비친 각도가 됩니다. 각도를 감을 "
        "필요가 없습니다. sin과 cos은 어떤 각도든 받습니다.",
    ),
    of_yaw(
        "times pi",
        lambda yaw: turned(math.pi * yaw),
        "There is a π too many: the yaw is in radians, and π is in it already. Half of it goes into sine and cosine.",
        "π를 한 번 더 곱했습니다. yaw는 라디안이어서 π가 이미 들어 있습니다. sin과 cos에는 그 절반만 넣습니다.",
    ),
    of_yaw(
        "no more than half a turn",
        lambda yaw: held_within(yaw, math.pi),
        "A yaw beyond half a turn is cut off at π. It needs no bound: sine and cosine take any angle.",
        "반 바퀴를 넘는 yaw를 π에서 잘라 냈습니다. 한계를 둘 필요가 없습니다. sin과 cos은 어떤 각도든 받습니다.",
        "",
    ),
    of_yaw(
        "no more than a quarter turn",
        lambda yaw: held_within(yaw, math.pi / 2),
        "A yaw beyond a quarter turn is cut off at π/2. It needs no bound: sine and cosine take any angle.",
        "1/4 바퀴를 넘는 yaw를 π/2에서 잘라 냈습니다. 한계를 둘 필요가 없습니다. sin과 cos은 어떤 각도든 받습니다.",
        "",
    ),
)


TASK = Task(
    id="E2.3",
    kind="F",
    points=3,
    title=Text(en="The quaternion of a yaw", ko="yaw를 쿼터니언으로"),
    answer="quaternion_from_yaw",
    form=Quaternion(tolerance=1e-3),
    inputs=yaws,
    variants=3,
    model=turned,
    mistakes=(
        WHOLE_ANGLE,
        DEGREES,
        W_FIRST,
        SINE_AND_COSINE,
        TO_THE_RIGHT,
        ABOUT_X,
        ABOUT_Y,
        ANGLE_IN_Z,
        HALVED_OUTSIDE,
        TO_DEGREES,
        DOUBLE,
        WHOLE_NUMBER,
        SINE_HALVED_ALONE,
        SMALL_ANGLE,
        ANGLE_ALONE,
        TANGENT,
        NEVER_RIGHT,
        W_NEVER_NEGATIVE,
        ALL_THREE,
        ABOUT_THE_DIAGONAL,
        QUARTER_OF_THE_ANGLE,
        SINE_OF_THE_WHOLE,
        MODULO_PI,
        W_LEFT_AT_ZERO,
        W_LEFT_AT_ONE,
        HALF_ANGLE_AND_ITS_ROOT,
        ANGLE_TO_LENGTH_ONE,
        HALF_TO_LENGTH_ONE,
        ANGLE_BESIDE_THE_COSINE,
        HALF_BESIDE_THE_COSINE,
        REST_OF_ONE,
        ROOT_FORGOTTEN,
        SQUARES,
        NO_SIGN_AT_ALL,
        SINE_HALVED_OUTSIDE,
        COSINE_HALVED_OUTSIDE,
        REST_OF_THE_SIZE,
        *ALONE,
    ),
    hints=(
        Text(
            en="Axis times the sine of ..., then the cosine of ...: what is the axis of a yaw?",
            ko="축에 sin을 곱하고, 마지막에 cos을 씁니다. yaw의 축은 무엇입니까?",
        ),
        Text(
            en="The axis is (0, 0, 1), so two of the four numbers are zero. And it is half the angle.",
            ko="축은 (0, 0, 1)이므로 넷 중 둘은 0입니다. 그리고 각도의 절반을 씁니다.",
        ),
        Text(
            en="x and y are 0.0; z is math.sin(yaw_rad / 2); one number is left for you.",
            ko="x와 y는 0.0이고 z는 math.sin(yaw_rad / 2)입니다. 남은 하나는 직접 채우십시오.",
        ),
    ),
    misconceptions=("M5",),
)
