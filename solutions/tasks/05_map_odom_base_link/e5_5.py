"""E5.5: The shadow on the floor."""

from __future__ import annotations

import math

from tflab.core import Transform
from tflab.workbook.tasks import Angle, Number, Parts, Task, Text, WrongStep


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


def shadow(odom_T_base, *, foot="straight down", yaw="rpy"):
    """Return the footprint, step by step; other steps are the slips."""
    x, y, height = odom_T_base.translation
    roll, pitch, right = odom_T_base.rpy()
    back = odom_T_base.inverse()
    feet = {
        "straight down": (x, y),
        "its own z": odom_T_base.apply((0.0, 0.0, -height))[:2],
        "inverse": back.translation[:2],
        "origin": (0.0, 0.0),
        "y and z": (x, height),
        "through the floor": odom_T_base.apply((0.0, 0.0, -height / math.cos(pitch) / math.cos(roll)))[:2],
        "shortened": (x * math.cos(pitch), y * math.cos(roll)),
        "up its own z": odom_T_base.apply((0.0, 0.0, height))[:2],
        "by the sine": (x - height * math.sin(pitch), y + height * math.sin(roll)),
        "by the tangent": (x - height * math.tan(pitch), y + height * math.tan(roll)),
        "turned": (x * math.cos(right) - y * math.sin(right), x * math.sin(right) + y * math.cos(right)),
    }
    q_x, q_y, z, w = odom_T_base.rotation
    yaws = {
        "rpy": right, "twice atan": 2.0 * math.atan2(z, w), "inverse": back.rpy()[2], "inverse pitch": back.rpy()[1], "negated": -right, "roll": roll,
        "pitch": pitch, "level": 0.0, "twice asin": 2.0 * math.asin(z), "twice acos": 2.0 * math.acos(w), "z": z, "once atan": math.atan2(z, w),
        "degrees": math.degrees(right), "roll in degrees": math.degrees(roll), "height": height,
        "size": abs(right), "x": q_x, "w": w, "signed acos": math.copysign(2.0 * math.acos(w), z),
        "asin": math.asin(max(-1.0, min(1.0, 2.0 * (w * z + q_x * q_y)))),
        "acos": math.acos(max(-1.0, min(1.0, 1.0 - 2.0 * (q_y * q_y + z * z)))),
        "formula without y": math.atan2(2.0 * (w * z + q_x * q_y), 1.0 - 2.0 * z * z),
        "bearing": math.atan2(y, x), "cotangent": 2.0 * math.atan2(w, z),
        "w taken first": 2.0 * math.atan2(w, q_x),
        "formula, w taken first": math.atan2(2.0 * (q_x * w + q_y * z), 1.0 - 2.0 * (z * z + w * w)),
        "formula of x": math.atan2(2.0 * (w * z + q_x * q_y), 1.0 - 2.0 * (q_x * q_x + q_y * q_y)),
    }  # fmt: skip
    return {"x": feet[foot][0], "y": feet[foot][1], "yaw": yaws[yaw]}


ALONG_ITS_OWN_Z = WrongStep(
    "along its own z",
    {"foot": "its own z"},
    Text(
        en="You went down along the robot's own z. It leans, so that ends beside the point below it. Below means along odom's z.",
        ko="로봇 자신의 z를 따라 내려갔습니다. 로봇이 기울어 있으므로 바로 아래가 아닌 옆에 닿습니다. 아래란 odom의 z 방향입니다.",
    ),
)

TWICE_ATAN = WrongStep(
    "twice atan",
    {"yaw": "twice atan"},
    Text(
        en="2·atan2(z, w) is the yaw only of a quaternion that turns about z alone. This body is rolled and pitched as well: take the yaw of `rpy()`.",
        ko="2·atan2(z, w)는 z축으로만 도는 쿼터니언의 yaw입니다. 이 몸체는 roll과 pitch도 있으므로 `rpy()`의 yaw를 쓰십시오.",
    ),
    "M5",
)

YAW_OF_THE_INVERSE = WrongStep(
    "yaw of the inverse",
    {"yaw": "inverse"},
    Text(
        en="That is the yaw of odom as seen from the robot, the inverse. Asked for is the robot's yaw in odom.",
        ko="로봇에서 본 odom의 yaw, 곧 역변환의 yaw입니다. odom 기준 로봇의 yaw가 필요합니다.",
    ),
    "M1",
)

SIGN_OF_YAW = WrongStep(
    "sign of yaw",
    {"yaw": "negated"},
    Text(
        en="The yaw has the wrong sign: positive turns to the left.",
        ko="yaw의 부호가 틀렸습니다. 양수는 왼쪽으로 도는 것입니다.",
    ),
)

PITCH_OF_THE_INVERSE = WrongStep(
    "pitch of the inverse",
    {"yaw": "inverse pitch"},
    Text(
        en="That is the pitch of the inverse, of odom as seen from the robot. `rpy()` gives roll, pitch, yaw in this order, and what is asked for is the robot's yaw in odom.",
        ko="로봇에서 본 odom의 pitch, 곧 역변환의 pitch입니다. `rpy()`는 roll, pitch, yaw 순서로 돌려주고, 필요한 것은 odom 기준 로봇의 yaw입니다.",
    ),
    "M1",
)

ROLL_FOR_YAW = WrongStep(
    "roll for yaw",
    {"yaw": "roll"},
    Text(
        en="That is the roll. `rpy()` gives roll, pitch, yaw in this order.",
        ko="roll입니다. `rpy()`는 roll, pitch, yaw 순서로 돌려줍니다.",
    ),
)

PITCH_FOR_YAW = WrongStep(
    "pitch for yaw",
    {"yaw": "pitch"},
    Text(
        en="That is the pitch. `rpy()` gives roll, pitch, yaw in this order.",
        ko="pitch입니다. `rpy()`는 roll, pitch, yaw 순서로 돌려줍니다.",
    ),
)

INVERTED = WrongStep(
    "inverted",
    {"foot": "inverse"},
    Text(
        en="Those are x and y of the inverse: where odom lies, seen from the robot.",
        ko="역변환의 x, y입니다. 로봇에서 본 odom의 위치입니다.",
    ),
    "M1",
)

AT_THE_ORIGIN = WrongStep(
    "at the origin",
    {"foot": "origin"},
    Text(
        en="You set x and y to zero as well. Straight below, only the height changes.",
        ko="x와 y까지 0으로 두었습니다. 바로 아래로 내려가면 높이만 바뀝니다.",
    ),
)

HEIGHT_FOR_Y = WrongStep(
    "height for y",
    {"foot": "y and z"},
    Text(
        en="The height stands where y belongs: translation is (x, y, z).",
        ko="y 자리에 높이가 들어갔습니다. translation은 (x, y, z)입니다.",
    ),
)

SHORTENED = WrongStep(
    "shortened",
    {"foot": "shortened"},
    Text(
        en="You shortened x and y by the tilt. `base_link`'s place is in odom already: nothing is to be projected.",
        ko="기울기만큼 x와 y를 줄였습니다. `base_link`의 위치는 이미 odom 기준이므로 투영할 것이 없습니다.",
    ),
)

YAW_LEVELLED = WrongStep(
    "yaw levelled",
    {"yaw": "level"},
    Text(
        en="Level means that roll and pitch are gone. The yaw stays.",
        ko="수평이란 roll과 pitch가 없다는 뜻입니다. yaw는 그대로입니다.",
    ),
)

TWICE_ASIN = WrongStep(
    "twice asin",
    {"yaw": "twice asin"},
    Text(
        en="2·asin(z) is the yaw only of a quaternion that turns about z alone, and less than half a turn: take the yaw of `rpy()`.",
        ko="2·asin(z)는 z축으로만, 반 바퀴보다 적게 도는 쿼터니언의 yaw입니다. `rpy()`의 yaw를 쓰십시오.",
    ),
    "M5",
)

TWICE_ACOS = WrongStep(
    "twice acos",
    {"yaw": "twice acos"},
    Text(
        en="2·acos(w) is how far the body is turned about whatever axis, and it has lost the side: take the yaw of `rpy()`.",
        ko="2·acos(w)는 어떤 축이든 그 둘레로 돈 크기이고 방향도 잃었습니다. `rpy()`의 yaw를 쓰십시오.",
    ),
    "M5",
)

Z_FOR_YAW = WrongStep(
    "z for yaw",
    {"yaw": "z"},
    Text(
        en="That is the third number of the quaternion, which is no angle: take the yaw of `rpy()`.",
        ko="쿼터니언의 셋째 숫자이며 각도가 아닙니다. `rpy()`의 yaw를 쓰십시오.",
    ),
    "M5",
)

BEARING = WrongStep(
    "bearing",
    {"yaw": "bearing"},
    Text(
        en="That is in which direction the robot lies, seen from the origin. Its yaw is where it looks.",
        ko="원점에서 본 로봇의 방향입니다. yaw는 로봇이 바라보는 쪽입니다.",
    ),
)

COTANGENT = WrongStep(
    "cotangent",
    {"yaw": "cotangent"},
    Text(
        en="atan2 has its arguments exchanged, and even (z, w) would do for a turn about z alone: take the yaw of `rpy()`.",
        ko="atan2의 인자가 바뀌었습니다. (z, w)라도 z축으로만 돌 때 맞습니다. `rpy()`의 yaw를 쓰십시오.",
    ),
    "M5",
)


THROUGH_THE_FLOOR = WrongStep(
    "through the floor",
    {"foot": "through the floor"},
    Text(
        en="You followed the body's own z down to the floor. The body is tilted, and straight below is below in odom.",
        ko="몸체 자신의 z를 따라 바닥까지 내려갔습니다. 몸체가 기울어 있으므로, 바로 아래는 odom 기준의 아래입니다.",
    ),
)


ONCE_ATAN = WrongStep(
    "once atan",
    {"yaw": "once atan"},
    Text(
        en="atan2(z, w) is half of an angle, and a yaw only of a quaternion that turns about z alone: take the yaw of `rpy()`.",
        ko="atan2(z, w)는 각도의 절반이고, z 둘레로만 도는 쿼터니언에서만 yaw와 관계있습니다. `rpy()`의 yaw를 쓰십시오.",
    ),
    "M5",
)

YAW_IN_DEGREES = WrongStep(
    "yaw in degrees",
    {"yaw": "degrees"},
    Text(
        en="yaw is in degrees, and asked for are radians.",
        ko="yaw가 도(degree) 단위입니다. 필요한 것은 라디안입니다.",
    ),
    part="yaw",
)

ROLL_IN_DEGREES = WrongStep(
    "roll in degrees",
    {"yaw": "roll in degrees"},
    Text(
        en="yaw: this is the roll, and in degrees. `rpy()` gives roll, pitch and yaw in this order, in radians.",
        ko="yaw: roll을 도(degree)로 바꾼 값입니다. `rpy()`는 roll, pitch, yaw 순서로, 라디안으로 줍니다.",
    ),
    part="yaw",
)

HEIGHT_FOR_YAW = WrongStep(
    "height for the yaw",
    {"yaw": "height"},
    Text(
        en="yaw: this is the height, the third number of the translation. The turn about z is asked for.",
        ko="yaw: 이동의 셋째 숫자인 높이입니다. 구할 것은 z축 둘레의 회전입니다.",
    ),
    part="yaw",
)


SIZE_OF_YAW = WrongStep(
    "size of yaw",
    {"yaw": "size"},
    Text(
        en="Your yaw is never negative: it has lost its sign, as by abs(). Positive turns to the left, negative to the right.",
        ko="yaw가 음수가 되지 않습니다. abs()를 쓴 것처럼 부호를 잃었습니다. 양수는 왼쪽, 음수는 오른쪽으로 도는 것입니다.",
    ),
)

X_FOR_YAW = WrongStep(
    "x for yaw",
    {"yaw": "x"},
    Text(
        en="That is the first number of the quaternion, which is no angle: take the yaw of `rpy()`.",
        ko="쿼터니언의 첫째 숫자이며 각도가 아닙니다. `rpy()`의 yaw를 쓰십시오.",
    ),
    "M5",
)

W_FOR_YAW = WrongStep(
    "w for yaw",
    {"yaw": "w"},
    Text(
        en="That is the last number of the quaternion, which is no angle: take the yaw of `rpy()`.",
        ko="쿼터니언의 마지막 숫자이며 각도가 아닙니다. `rpy()`의 yaw를 쓰십시오.",
    ),
    "M5",
)

SIGNED_ACOS = WrongStep(
    "signed acos",
    {"yaw": "signed acos"},
    Text(
        en="2·acos(w) with the sign of z is the yaw only of a quaternion that turns about z alone. This body is rolled and pitched as well: take the yaw of `rpy()`.",
        ko="z의 부호를 붙인 2·acos(w)는 z축으로만 도는 쿼터니언에서만 yaw입니다. 이 몸체는 roll과 pitch도 있으므로 `rpy()`의 yaw를 쓰십시오.",
    ),
    "M5",
)

ASIN_OF_THE_FORMULA = WrongStep(
    "asin of the formula",
    {"yaw": "asin"},
    Text(
        en="The asin of 2(wz + xy) is not the yaw of a tilted body, and knows no turn beyond a quarter. `rpy()` needs no formula.",
        ko="2(wz + xy)의 asin은 기울어진 몸체의 yaw가 아니고 90도를 넘는 회전도 나타내지 못합니다. `rpy()`를 쓰면 공식이 필요 없습니다.",
    ),
    "M5",
)

ACOS_OF_THE_FORMULA = WrongStep(
    "acos of the formula",
    {"yaw": "acos"},
    Text(
        en="The acos of 1 − 2(y² + z²) is not the yaw of a tilted body, and it has lost the side. `rpy()` needs no formula.",
        ko="1 − 2(y² + z²)의 acos은 기울어진 몸체의 yaw가 아니고 방향도 잃었습니다. `rpy()`를 쓰면 공식이 필요 없습니다.",
    ),
    "M5",
)

FORMULA_WITHOUT_Y = WrongStep(
    "formula without y",
    {"yaw": "formula without y"},
    Text(
        en="In your formula for the yaw y² is missing: its second half is 1 − 2(y² + z²). `rpy()` needs no formula.",
        ko="yaw 공식에서 y²가 빠졌습니다. 뒷부분은 1 − 2(y² + z²)입니다. `rpy()`를 쓰면 공식이 필요 없습니다.",
    ),
    "M5",
)

UP_ITS_OWN_Z = WrongStep(
    "up its own z",
    {"foot": "up its own z"},
    Text(
        en="You went along the robot's own z, and upwards. Below means along odom's z, and there x and y stay as they are.",
        ko="로봇 자신의 z를 따라, 그것도 위로 갔습니다. 아래란 odom의 z 방향이고, 그때 x와 y는 그대로입니다.",
    ),
)

MOVED_BY_THE_SINE = WrongStep(
    "moved by the sine",
    {"foot": "by the sine"},
    Text(
        en="x and y are moved by the height times a sine of the tilt. Straight below is below in odom, however the body leans: x and y stay.",
        ko="높이에 기울기의 sin을 곱한 만큼 x와 y를 옮겼습니다. 몸체가 기울어도 바로 아래는 odom 기준의 아래이므로 x와 y는 그대로입니다.",
    ),
)

MOVED_BY_THE_TANGENT = WrongStep(
    "moved by the tangent",
    {"foot": "by the tangent"},
    Text(
        en="x and y are moved by the height times a tangent of the tilt. Straight below is below in odom, however the body leans: x and y stay.",
        ko="높이에 기울기의 tan을 곱한 만큼 x와 y를 옮겼습니다. 몸체가 기울어도 바로 아래는 odom 기준의 아래이므로 x와 y는 그대로입니다.",
    ),
)

PLACE_TURNED = WrongStep(
    "place turned",
    {"foot": "turned"},
    Text(
        en="x and y are turned by the yaw. They are in odom already, and stay as they are.",
        ko="x와 y를 yaw만큼 돌렸습니다. 이미 odom 기준이므로 그대로 둡니다.",
    ),
)


W_TAKEN_FIRST = WrongStep(
    "w taken first",
    {"yaw": "w taken first"},
    Text(
        en="You took the quaternion for (w, x, y, z), and it comes as (x, y, z, w). Nor is twice an arc tangent the yaw of a tilted body: take the yaw of `rpy()`.",
        ko="쿼터니언을 (w, x, y, z)로 읽었습니다. 순서는 (x, y, z, w)입니다. 기울어진 몸체에서는 atan2의 두 배가 yaw도 아닙니다. `rpy()`의 yaw를 쓰십시오.",
    ),
    "M5",
    part="yaw",
)


FORMULA_W_TAKEN_FIRST = WrongStep(
    "formula, w taken first",
    {"yaw": "formula, w taken first"},
    Text(
        en="Your formula takes the quaternion for (w, x, y, z), and it comes as (x, y, z, w). `rpy()` needs no formula.",
        ko="공식에서 쿼터니언을 (w, x, y, z)로 읽었습니다. 순서는 (x, y, z, w)입니다. `rpy()`를 쓰면 공식이 필요 없습니다.",
    ),
    "M5",
    part="yaw",
)


FORMULA_OF_X = WrongStep(
    "formula of x",
    {"yaw": "formula of x"},
    Text(
        en="In your formula for the yaw, the second half is that of the roll: 1 − 2(y² + z²) belongs there. `rpy()` needs no formula.",
        ko="yaw 공식의 뒷부분이 roll의 것입니다. 1 − 2(y² + z²)이어야 합니다. `rpy()`를 쓰면 공식이 필요 없습니다.",
    ),
    "M5",
    part="yaw",
)


TASK = Task(
    id="E5.5",
    kind="F",
    points=3,
    title=Text(en="The shadow on the floor", ko="바닥에 비친 그림자"),
    answer="footprint",
    form=Parts({"x": Number(unit="m"), "y": Number(unit="m"), "yaw": Angle()}, alone=True),
    inputs=tilted,
    variants=3,
    model=shadow,
    mistakes=(
        ALONG_ITS_OWN_Z,
        TWICE_ATAN,
        YAW_OF_THE_INVERSE,
        SIGN_OF_YAW,
        ROLL_FOR_YAW,
        PITCH_FOR_YAW,
        PITCH_OF_THE_INVERSE,
        INVERTED,
        AT_THE_ORIGIN,
        HEIGHT_FOR_Y,
        SHORTENED,
        YAW_LEVELLED,
        TWICE_ASIN,
        TWICE_ACOS,
        Z_FOR_YAW,
        BEARING,
        COTANGENT,
        THROUGH_THE_FLOOR,
        ONCE_ATAN,
        YAW_IN_DEGREES,
        ROLL_IN_DEGREES,
        HEIGHT_FOR_YAW,
        W_TAKEN_FIRST,
        FORMULA_W_TAKEN_FIRST,
        FORMULA_OF_X,
        SIZE_OF_YAW,
        X_FOR_YAW,
        W_FOR_YAW,
        SIGNED_ACOS,
        ASIN_OF_THE_FORMULA,
        ACOS_OF_THE_FORMULA,
        FORMULA_WITHOUT_Y,
        UP_ITS_OWN_Z,
        MOVED_BY_THE_SINE,
        MOVED_BY_THE_TANGENT,
        PLACE_TURNED,
    ),
    hints=(
        Text(en="Straight below: which of x, y, z change?", ko="바로 아래로 내려가면 x, y, z 가운데 무엇이 바뀝니까?"),
        Text(
            en="`odom_T_base.translation` and `odom_T_base.rpy()` hold all that is needed.",
            ko="필요한 것은 `odom_T_base.translation`과 `odom_T_base.rpy()`에 모두 있습니다.",
        ),
        Text(
            en="x and y stay, and so does the yaw; the rest is dropped.",
            ko="x와 y, 그리고 yaw는 그대로이고 나머지는 버립니다.",
        ),
    ),
    misconceptions=("M5",),
)
