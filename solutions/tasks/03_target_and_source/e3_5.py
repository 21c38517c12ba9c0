"""E3.5: tf2_echo, both ways."""

from __future__ import annotations

import math
from functools import partial

from tflab.core import LATEST, StampedTransform, Transform
from tflab.views.sentence import echo_text
from tflab.workbook.tasks import Angle, Draws, Parts, Task, Text, Vector, WrongAnswer, WrongStep

from .draws import BY_HAND, by_formula, some_mount, tells_ways_apart, turned

AMBIGUOUS_DEG = {  # yaws of which two mistakes give the same angle, modulo a turn: 1 / yaw is cos(yaw / 2) at 70
    44, 45, 56, 70, 113, 118, 119, 125, 126, 135, -25, -44, -45, -70, -117, -125, -126, -127, -129, -135, -149,
}  # fmt: skip


def echo_given(rng: Draws) -> dict[str, str]:
    """Draw until no two mistakes give the same position or the same yaw."""
    while True:
        mount = some_mount(rng)
        (x, y, _), yaw = mount.translation, mount.rpy()[2]
        inverse, half, converted = (
            by_formula(-x, -y, angle, "right") for angle in (-yaw, -yaw / 2, -math.radians(yaw))
        )
        others = (inverse[::-1], half, converted, (-x, -y), (-x, y), (-y, -x))
        is_rounded = abs(math.degrees(round(yaw, 3) - yaw)) > 0.006
        is_clear = is_rounded and round(math.degrees(yaw)) not in AMBIGUOUS_DEG
        if is_clear and tells_ways_apart(-x, -y, -yaw, *others):
            return {"echo": echo_text(StampedTransform("base_link", "laser_frame", LATEST, mount))}


def echoed(given) -> tuple[Transform, float]:
    """Return the transform that was printed, and its yaw [rad]."""
    rows = [line.split("[")[1].rstrip("]").split(", ") for line in given.echo.splitlines()[1:4]]
    yaw = float(rows[2][2])
    return Transform.from_rpy(yaw=yaw, translation=tuple(map(float, rows[0]))), yaw


def read(given, *, laser="as printed", back="inverse", height="turned with it", yaw="minus"):
    """Return both places and the yaw, step by step; other steps are the slips."""
    mount, printed = echoed(given)
    there, inverse = mount.translation, mount.inverse()
    away = tuple(-value for value in there)
    c, s = math.cos(printed), math.sin(printed)
    returned = {
        "inverse": inverse.translation,
        "swapped": there,
        "sign only": away,
        "turned on": turned(mount, away),
        "not taken off": turned(inverse, there),
        "turned on, not taken off": turned(mount, there),
        "by degrees": Transform.from_rpy(yaw=-math.degrees(printed)).apply(away),
        "sine for cosine": (-(there[0] * s + there[1] * c), there[0] * c - there[1] * s, -there[2]),
        "exchanged": (inverse.translation[1], inverse.translation[0], inverse.translation[2]),
        "by half": Transform.from_rpy(yaw=-printed / 2).apply(away),
        "converted": Transform.from_rpy(yaw=-math.radians(printed)).apply(away),
        "about x": Transform.from_rpy(roll=-printed).apply(away),
        "one over": tuple(1.0 / value for value in there),
        "minus in x": (away[0], there[1], there[2]),
        "minus in y": (there[0], away[1], there[2]),
        "minus in z": (there[0], there[1], away[2]),
        "minus in x and z": (away[0], there[1], away[2]),
        "minus in y and z": (there[0], away[1], away[2]),
        "not taken off in the plane": (*turned(inverse, there)[:2], away[2]),
        "inverse of minus": inverse.apply(away),
        "quarter to the left": (there[1], away[0], away[2]),
        "quarter to the right": (away[1], there[0], away[2]),
        "exchanged and minus": (away[1], away[0], away[2]),
        "new x, taken off": (inverse.translation[0], inverse.translation[0] * s - there[1] * c, away[2]),
        "nowhere": (0.0, 0.0, 0.0),
        "moved by the mount": mount.apply(away),
        "mount applied twice": mount.apply(there),
        "its distance": (math.hypot(*there), 0.0, 0.0),
        "behind, at its distance": (-math.hypot(*there), 0.0, 0.0),
    } | {way: (*by_formula(*away[:2], -printed, way), away[2]) for way in BY_HAND}  # fmt: skip
    returned = returned[back]
    seen = {"as printed": there, "swapped": inverse.translation, "negative": away, "turned": turned(mount, there),
            "turned back": turned(inverse, there), "row of the matrix": (c, -s, 0.0),
            "Rotation line": (0.0, 0.0, math.sin(printed / 2)), "RPY line": (0.0, 0.0, printed)}[laser]  # fmt: skip
    returned = {"kept": (*returned[:2], there[2]), "left out": (*returned[:2], 0.0)}.get(height, returned)
    return {
        "laser_in_base": (*seen[:2], 0.0) if height == "left out" else seen,
        "base_in_laser": returned,
        "yaw_back": {"minus": -printed, "same": printed, "in degrees": round(math.degrees(-printed)),
                     "behind": printed + math.pi, "rest of a half": math.pi - printed, "zero": 0.0,
                     "pitch": 0.0, "degrees as printed": round(math.degrees(printed)),
                     "degrees as computed": math.degrees(printed),
                     "converted": -math.radians(printed), "from a quarter": math.pi / 2 - printed,
                     "from 360": 360.0 - printed, "from 180": 180.0 - printed, "one over": 1.0 / printed,
                     "minus one over": -1.0 / printed,
                     "w": math.cos(printed / 2), "minus w": -math.cos(printed / 2)}[yaw],
    }  # fmt: skip


SWAPPED = WrongStep(
    "swapped",
    {"laser": "swapped", "back": "swapped"},
    Text(
        en="where it is wrong stands the answer to the other question. `tf2_echo base_link laser_frame` "
        "prints where the second sits in the first, whatever the tool's help calls them.",
        ko="틀린 값은 서로 바뀌어 있습니다. `tf2_echo base_link laser_frame`은 첫째를 기준으로 둘째가 어디에 있는지 "
        "출력합니다. 도움말이 무엇이라 부르든 그렇습니다.",
    ),
    "M1",
    partly=True,
)

SIGN_ONLY = WrongStep(
    "sign_only",
    {"back": "sign only"},
    Text(
        en="for the way back only the signs are flipped. The mount is turned, so the step has to be turned, too. If you "
        "made a Transform: does the yaw go into it, and does `.inverse()` follow? Its `.translation` alone is what went in.",
        ko="돌아가는 쪽은 부호만 뒤집혔습니다. 센서가 돌아가 있으므로 이동도 돌려야 합니다. Transform을 만들었다면, 거기에 yaw를 "
        "넣었고 `.inverse()`를 호출했습니까? `.translation`만 읽으면 넣은 값이 그대로 나옵니다.",
    ),
    "M3",
)

TURNED_ON = WrongStep(
    "turned_on",
    {"back": "turned on"},
    Text(
        en="for the way back the step was turned, but by yaw instead of by minus yaw. If you took a minus for it, there "
        "are two: −yaw and `.inverse()`, or −yaw in a formula whose sines have other signs already. They undo each other.",
        ko="돌아가는 쪽의 이동을 돌렸지만, −yaw가 아니라 yaw만큼 돌아갔습니다. 마이너스를 붙였다면 두 번 붙인 것입니다. "
        "−yaw에 `.inverse()`까지 쓰거나, sin의 부호가 이미 뒤집힌 공식에 −yaw를 넣으면 서로 지워집니다.",
    ),
)

NOT_TAKEN_OFF = WrongStep(
    "not_taken_off",
    {"back": "not taken off"},
    Text(
        en="for the way back you turned the step rightly and kept its sign. From the laser, the robot's "
        "middle lies on the other side.",
        ko="돌아가는 쪽의 이동을 바르게 돌렸지만 부호가 그대로입니다. 레이저에서 보면 로봇 중심은 반대쪽에 있습니다.",
    ),
)

SAME_YAW = WrongStep(
    "same_yaw",
    {"yaw": "same"},
    Text(
        en="going back, one also turns back: look at the sign of the yaw.",
        ko="돌아갈 때는 회전도 반대입니다. yaw의 부호를 보십시오.",
    ),
)

HEIGHT_KEPT = WrongStep(
    "height_kept",
    {"height": "kept"},
    Text(
        en="the height has kept its sign: from the laser, is the robot's middle above or below?",
        ko="높이의 부호가 그대로입니다. 레이저에서 보면 로봇 중심은 위에 있습니까, 아래에 있습니까?",
    ),
)

YAW_IN_DEGREES = WrongStep(
    "yaw_in_degrees",
    {"yaw": "in degrees"},
    Text(
        en="the yaw is in degrees. It is asked for in radians: the tool prints both, one line above the other.",
        ko="yaw가 도(degree)로 되어 있습니다. 라디안으로 답해야 합니다. 도구는 두 단위를 위아래 두 줄로 출력합니다.",
    ),
    "M5",
)

BEHIND = WrongStep(
    "behind",
    {"yaw": "behind"},
    Text(
        en="you added half a turn. The way back is turned by as much as the way there, to the other side.",
        ko="반 바퀴를 더했습니다. 돌아가는 쪽은 같은 만큼 반대로 돕니다.",
    ),
)

TURNED_BY_DEGREES = WrongStep(
    "turned_by_degrees",
    {"back": "by degrees"},
    Text(
        en="the step was turned by the degrees, taken for radians: `math.cos` and `math.sin` want radians.",
        ko="도 단위의 각도를 라디안으로 여기고 이동을 돌렸습니다. `math.cos`과 `math.sin`은 라디안을 받습니다.",
    ),
    "M5",
)

ON_THE_FLOOR = WrongStep(
    "on_the_floor",
    {"height": "left out"},
    Text(
        en="the height was left out: the third number counts as well.",
        ko="높이를 빠뜨렸습니다. 셋째 숫자도 필요합니다.",
    ),
    partly=True,
)

TURNED_ON_AND_NOT_TAKEN_OFF = WrongStep(
    "turned on and not taken off",
    {"back": "turned on, not taken off"},
    Text(
        en="for the way back the step was turned by yaw instead of by minus yaw, and it has kept its sign.",
        ko="돌아가는 길에서 이동을 -yaw가 아니라 yaw만큼 돌렸고 부호도 그대로입니다.",
    ),
)


SINE_FOR_COSINE = WrongStep(
    "sine for cosine",
    {"back": "sine for cosine"},
    Text(
        en="for the way back sine and cosine have changed places in the turn.",
        ko="돌아가는 길의 회전에서 sin과 cos의 자리가 바뀌었습니다.",
    ),
)


X_AND_Y_EXCHANGED = WrongStep(
    "x and y exchanged",
    {"back": "exchanged"},
    Text(
        en="x and y of the way back have changed places.",
        ko="돌아가는 길의 x와 y가 서로 바뀌었습니다.",
    ),
)


NO_YAW = WrongStep(
    "no yaw",
    {"yaw": "zero"},
    Text(
        en="the yaw of the way back is 0 for you. Seen from the laser the robot is turned too: as far, and to the other "
        "side. In the line RPY (roll, pitch, yaw) the yaw is the last number; the first two are 0.",
        ko="돌아가는 길의 yaw가 0입니다. 레이저에서 보면 로봇도 돌아 있습니다. 크기는 같고 방향은 반대입니다. RPY(roll, pitch, "
        "yaw) 줄에서 yaw는 마지막 숫자이고, 앞의 둘은 0입니다.",
    ),
)


REST_OF_HALF_A_TURN = WrongStep(
    "rest of half a turn",
    {"yaw": "rest of a half"},
    Text(
        en="you took the yaw off half a turn. To turn back is to turn by as much the other way.",
        ko="반 바퀴에서 yaw를 뺐습니다. 되돌아가는 것은 같은 만큼 반대로 도는 것입니다.",
    ),
)


WITH_A_YAW_OF_ZERO = WrongStep(
    "with a yaw of zero",
    {"back": "sign only", "yaw": "zero"},
    Text(
        en="you reckoned with a yaw of 0: the step of the way back has only other signs, and its yaw is 0. This mount is "
        "turned. The line RPY prints roll, pitch, yaw, in this order: the yaw is the last of the three.",
        ko="yaw를 0으로 보고 계산했습니다. 돌아가는 길의 이동은 부호만 뒤집혔고 yaw도 0입니다. 이 레이저는 돌려서 "
        "달았습니다. RPY 줄은 roll, pitch, yaw 순서이므로 yaw는 셋 가운데 마지막 숫자입니다.",
    ),
)


def on_the_way_back(way: str, words: Text, misconception: str = "") -> tuple[WrongAnswer, ...]:
    """Return a step back that was computed otherwise, and the same with the height's sign kept."""
    said = _said_of_the_way_back(words)
    kept = Text(
        en="And the height has kept its sign: from the laser, is the robot's middle above or below?",
        ko="높이의 부호도 그대로입니다. 레이저에서 보면 로봇 중심은 위에 있습니까, 아래에 있습니까?",
    )
    return (
        WrongAnswer(way, partial(read, back=way), said, misconception),
        WrongAnswer(
            f"{way}, height kept", partial(read, back=way, height="kept"), Text.joined(said, kept), misconception
        ),
    )


def _said_of_the_way_back(words: Text) -> Text:
    return Text(en=f"for the way back: {words.en}", ko=f"돌아가는 길의 계산입니다. {words.ko}")


LETTERS = Text(en="Here (u, v) is (−x, −y), and α is −yaw.", ko="(u, v)는 (−x, −y)이고 α는 −yaw입니다.")
BACK = {
    "by half": Text(
        en="the step was turned by half of the yaw. Halves belong into quaternions; a point turns by all of it.",
        ko="이동을 yaw의 절반만 돌렸습니다. 절반은 쿼터니언에만 쓰고, 점은 각도 전체만큼 돌립니다.",
    ),
    "converted": Text(
        en="the step has hardly turned: the yaw is printed in radians, and went through `math.radians` once more.",
        ko="이동이 거의 돌지 않았습니다. 라디안으로 출력된 yaw를 `math.radians`에 한 번 더 넣었습니다.",
    ),
    "about x": Text(
        en="the step was turned about x, as by a roll. A yaw turns about z; `from_rpy` takes roll, pitch, yaw in this "
        "order.",
        ko="이동을 x축으로, 곧 roll로 돌렸습니다. yaw는 z축으로 돕니다. `from_rpy`는 roll, pitch, yaw 순서로 받습니다.",
    ),
    "quarter to the left": Text(
        en="this is x in y's place and y in x's, one with a minus: as after a turn of −90°. How far is this mount turned?",
        ko="x와 y의 자리를 바꾸고 하나만 부호를 뒤집은 값입니다. −90° 돌린 것과 같습니다. 이 장착은 얼마나 돌아가 있습니까?",
    ),
    "quarter to the right": Text(
        en="this is x in y's place and y in x's, one with a minus: as after a turn of +90°. How far is this mount turned?",
        ko="x와 y의 자리를 바꾸고 하나만 부호를 뒤집은 값입니다. +90° 돌린 것과 같습니다. 이 장착은 얼마나 돌아가 있습니까?",
    ),
    "exchanged and minus": Text(
        en="x and y have changed places, each with a minus. The step has to be turned by the yaw that is printed.",
        ko="x와 y의 자리를 바꾸고 둘 다 부호를 뒤집었습니다. 이동은 출력된 yaw로 돌려야 합니다.",
    ),
    "mount applied twice": Text(
        en="the mount moved its own Translation. Which point is `base_link` in `base_link`? That one goes through the "
        "inverse.",
        ko="Translation을 장착 변환으로 한 번 더 옮겼습니다. `base_link`에서 본 `base_link`는 어느 점입니까? 그 점에 역변환을 "
        "적용합니다.",
    ),
    "inverse of minus": Text(
        en="the inverse moved (−x, −y, −z), and takes the step off itself: so it is off twice. Which point is `base_link` "
        "in `base_link`? That one goes through the inverse.",
        ko="역변환으로 (−x, −y, −z)를 옮겼습니다. 역변환이 이동을 빼므로 두 번 뺀 셈입니다. `base_link`에서 본 `base_link`는 "
        "어느 점입니까? 그 점에 역변환을 적용합니다.",
    ),
    "new x, taken off": Text(
        en="y was computed from the new x, which had just been computed. Both take the old ones: give the results other "
        "names.",
        ko="y를 구할 때 방금 구한 새 x를 썼습니다. 둘 다 원래 값으로 계산합니다. 결과에는 다른 이름을 붙이십시오.",
    ),
}


ALONE = {  # what is said of the height, too, or whose height comes out as 0
    "minus in x": Text(
        en="only x has got a minus sign. The whole step is taken off, and then it is turned.",
        ko="x의 부호만 뒤집었습니다. 이동 전체의 부호를 뒤집고, 그다음에 돌립니다.",
    ),
    "minus in y": Text(
        en="only y has got a minus sign. The whole step is taken off, and then it is turned.",
        ko="y의 부호만 뒤집었습니다. 이동 전체의 부호를 뒤집고, 그다음에 돌립니다.",
    ),
    "minus in z": Text(
        en="only the height has got a minus sign. The whole step is taken off, and then it is turned.",
        ko="높이의 부호만 뒤집었습니다. 이동 전체의 부호를 뒤집고, 그다음에 돌립니다.",
    ),
    "minus in x and z": Text(
        en="x and the height have got a minus sign, y has not. The whole step is taken off, and then it is turned.",
        ko="x와 높이의 부호만 뒤집고 y는 그대로 두었습니다. 이동 전체의 부호를 뒤집고, 그다음에 돌립니다.",
    ),
    "minus in y and z": Text(
        en="y and the height have got a minus sign, x has not. The whole step is taken off, and then it is turned.",
        ko="y와 높이의 부호만 뒤집고 x는 그대로 두었습니다. 이동 전체의 부호를 뒤집고, 그다음에 돌립니다.",
    ),
    "not taken off in the plane": Text(
        en="x and y are turned rightly and have kept their sign; only the height is taken off. From the laser, the "
        "robot's middle lies on the other side.",
        ko="x와 y를 바르게 돌렸지만 부호가 그대로이고, 높이의 부호만 뒤집혔습니다. 레이저에서 보면 로봇 중심은 반대쪽에 있습니다.",
    ),
    "moved by the mount": Text(
        en="the mount moved (−x, −y, −z), which are no numbers of a point in the laser. Which point is `base_link` in "
        "`base_link`? That one goes through the inverse.",
        ko="(−x, −y, −z)를 장착 변환으로 옮겼습니다. 이 숫자는 레이저 기준의 점이 아닙니다. `base_link`에서 본 `base_link`는 "
        "어느 점입니까? 그 점에 역변환을 적용합니다.",
    ),
    "its distance": Text(
        en="this is how far away it is, put straight ahead. From the laser, too, the robot's middle lies in some direction.",
        ko="거리만 구해서 정면에 놓은 값입니다. 레이저에서 보아도 로봇 중심은 어느 한 방향에 있습니다.",
    ),
    "behind, at its distance": Text(
        en="this is how far away it is, put straight behind. From the laser the robot's middle lies in another direction.",
        ko="거리만 구해서 바로 뒤에 놓은 값입니다. 레이저에서 보면 로봇 중심은 다른 방향에 있습니다.",
    ),
}


ONE_OVER = WrongStep(
    "one over",
    {"back": "one over"},
    Text(
        en="for the way back you divided 1 by the numbers. The inverse of a transform is the way back: turned and "
        "stepped, no one-over.",
        ko="돌아가는 길을 1을 나누어 구했습니다. 변환의 역은 역수가 아니라 되돌아가는 길입니다. 회전과 이동을 되돌리십시오.",
    ),
)


NOWHERE = WrongStep(
    "nowhere",
    {"back": "nowhere"},
    Text(
        en="`base_in_laser` is (0, 0, 0): that is a frame's origin, seen from itself. Which point is `base_link` in "
        "`base_link`? That one goes through the inverse.",
        ko="`base_in_laser`가 (0, 0, 0)입니다. 좌표계의 원점을 그 좌표계에서 본 값입니다. `base_link`에서 본 `base_link`는 "
        "어느 점입니까? 그 점에 역변환을 적용합니다.",
    ),
)


LASER_TURNED = WrongStep(
    "laser turned",
    {"laser": "turned"},
    Text(
        en="for `laser_in_base` you turned the Translation by the yaw. What is printed is where the laser sits, along "
        "the axes of `base_link`: nothing is left to turn.",
        ko="`laser_in_base`에서 Translation을 yaw만큼 돌렸습니다. 출력된 값이 이미 `base_link`의 축으로 잰 레이저의 "
        "위치이므로 돌릴 것이 없습니다.",
    ),
)


LASER_TURNED_BACK = WrongStep(
    "laser turned back",
    {"laser": "turned back"},
    Text(
        en="for `laser_in_base` you turned the Translation by minus the yaw. What is printed is where the laser sits, "
        "along the axes of `base_link`: nothing is left to turn.",
        ko="`laser_in_base`에서 Translation을 −yaw만큼 돌렸습니다. 출력된 값이 이미 `base_link`의 축으로 잰 레이저의 "
        "위치이므로 돌릴 것이 없습니다.",
    ),
)


ROW_OF_THE_MATRIX = WrongStep(
    "row of the matrix",
    {"laser": "row of the matrix"},
    Text(
        en="for `laser_in_base` you took the first row of the Matrix: that is part of the rotation. The place is the "
        "Translation, or the Matrix's last column.",
        ko="`laser_in_base`에 Matrix의 첫 행을 썼습니다. 그것은 회전의 일부입니다. 위치는 Translation, 곧 Matrix의 마지막 "
        "열입니다.",
    ),
)


LINES = tuple(
    WrongAnswer(
        line,
        partial(read, laser=line),
        Text(
            en=f"for `laser_in_base` you took the {held.en} of the {line}. Where the laser sits stands in the Translation.",
            ko=f"`laser_in_base`에 {line}의 {held.ko}를 썼습니다. 레이저의 위치는 Translation 줄에 있습니다.",
        ),
    )
    for line, held in (
        ("Rotation line", Text("first three numbers", "앞의 숫자 세 개")),
        ("RPY line", Text("angles", "각도")),
    )
)


DEGREES_AS_PRINTED = WrongStep(
    "degrees as printed",
    {"yaw": "degrees as printed"},
    Text(
        en="this is the yaw in degrees, as it is printed. Asked for are radians, and the way back turns to the other side.",
        ko="출력된 대로 도(degree)로 쓴 yaw입니다. 라디안으로 답해야 하고, 돌아가는 길은 반대쪽으로 돕니다.",
    ),
    "M5",
)


DEGREES_AS_COMPUTED = WrongStep(
    "degrees as computed",
    {"yaw": "degrees as computed"},
    Text(
        en="this is the printed yaw turned into degrees. It is in radians already, as it is asked for; and the way back "
        "turns to the other side.",
        ko="출력된 yaw를 도(degree)로 바꾼 값입니다. 이미 라디안이고, 라디안으로 답해야 합니다. 그리고 돌아가는 길은 반대쪽으로 "
        "돕니다.",
    ),
    "M5",
)


YAW_CONVERTED = WrongAnswer(
    "yaw converted",
    partial(read, yaw="converted"),
    Text(
        en="the yaw went through `math.radians`, and it is printed in radians already: what you give is hardly turned.",
        ko="라디안으로 출력된 yaw를 `math.radians`에 한 번 더 넣었습니다. 답한 yaw가 거의 0입니다.",
    ),
    "M5",
)


REST_OF_A_QUARTER = WrongAnswer(
    "rest of a quarter turn",
    partial(read, yaw="from a quarter"),
    Text(
        en="you took the yaw off a quarter turn. To turn back is to turn by as much the other way.",
        ko="1/4 바퀴에서 yaw를 뺐습니다. 되돌아가는 것은 같은 만큼 반대로 도는 것입니다.",
    ),
)


def of_the_yaw(name: str, way: str, en: str, ko: str) -> WrongAnswer:
    """Return the right places, and a yaw of the way back that was computed otherwise."""
    return WrongAnswer(name, partial(read, yaw=way), Text(en=en, ko=ko))


YAWS = (
    of_the_yaw(
        "from 360",
        "from 360",
        "the yaw was taken off 360, and it is in radians: a full turn is 2π there.",
        "360에서 yaw를 뺐습니다. yaw는 라디안이고, 라디안으로 한 바퀴는 2π입니다.",
    ),
    of_the_yaw(
        "from 180",
        "from 180",
        "the yaw was taken off 180, and it is in radians; and to turn back is to turn by as much the other way.",
        "180에서 yaw를 뺐습니다. yaw는 라디안입니다. 그리고 되돌아가는 것은 같은 만큼 반대로 도는 것입니다.",
    ),
    of_the_yaw(
        "one over the yaw",
        "one over",
        "this is 1 divided by the yaw. To turn back is to turn by as much the other way.",
        "1을 yaw로 나눈 값입니다. 되돌아가는 것은 같은 만큼 반대로 도는 것입니다.",
    ),
    of_the_yaw(
        "minus one over the yaw",
        "minus one over",
        "this is −1 divided by the yaw. To turn back is to turn by as much the other way.",
        "−1을 yaw로 나눈 값입니다. 되돌아가는 것은 같은 만큼 반대로 도는 것입니다.",
    ),
)


LASER_NEGATIVE = WrongStep(
    "laser negative",
    {"laser": "negative"},
    Text(
        en="for `laser_in_base` you flipped the signs. What is printed is where the second frame sits in the first, the "
        "laser in `base_link`: it stands there as it is asked for.",
        ko="`laser_in_base`에서 부호를 뒤집었습니다. 출력된 값은 첫째를 기준으로 둘째가 있는 자리, 곧 `base_link`에서 본 "
        "레이저입니다. 그대로가 답입니다.",
    ),
    "M1",
)


W_FOR_THE_YAW = WrongStep(
    "w for the yaw",
    {"yaw": "w"},
    Text(
        en="this is the w of the quaternion, the cosine of half the angle. Asked for is the angle of the way back.",
        ko="쿼터니언의 w, 곧 각도 절반의 cos입니다. 필요한 것은 돌아가는 길의 각도입니다.",
    ),
    "M5",
)


MINUS_W_FOR_THE_YAW = WrongStep(
    "minus w for the yaw",
    {"yaw": "minus w"},
    Text(
        en="this is the w of the quaternion with a minus. w is the cosine of half the angle, and no angle itself.",
        ko="쿼터니언의 w에 마이너스를 붙인 값입니다. w는 각도 절반의 cos이지 각도가 아닙니다.",
    ),
    "M5",
)


TASK = Task(
    id="E3.5",
    kind="N",
    points=3,
    title=Text(en="tf2_echo, both ways", ko="tf2_echo 양쪽으로 읽기"),
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
    model=read,
    mistakes=(
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
        TURNED_ON_AND_NOT_TAKEN_OFF,
        SINE_FOR_COSINE,
        X_AND_Y_EXCHANGED,
        NO_YAW,
        WITH_A_YAW_OF_ZERO,
        REST_OF_HALF_A_TURN,
        ONE_OVER,
        NOWHERE,
        LASER_TURNED,
        LASER_TURNED_BACK,
        ROW_OF_THE_MATRIX,
        *LINES,
        DEGREES_AS_PRINTED,
        DEGREES_AS_COMPUTED,
        YAW_CONVERTED,
        REST_OF_A_QUARTER,
        LASER_NEGATIVE,
        *YAWS,
        W_FOR_THE_YAW,
        MINUS_W_FOR_THE_YAW,
        *(WrongAnswer(way, partial(read, back=way), _said_of_the_way_back(words)) for way, words in ALONE.items()),
        *(twin for way, words in BACK.items() for twin in on_the_way_back(way, words)),
        *(twin for way in BY_HAND for twin in on_the_way_back(way, Text.joined(BY_HAND[way], LETTERS))),
    ),
    hints=(
        Text(
            en="One of the two places stands in the output as it is.",
            ko="두 위치 가운데 하나는 출력에 그대로 적혀 있습니다.",
        ),
        Text(
            en="The output is base_T_laser. The other one is its inverse: E3.3, with z.",
            ko="출력은 base_T_laser입니다. 다른 하나는 그 역변환입니다. E3.3에 z가 더해진 것입니다.",
        ),
        Text(
            en="`Transform.from_rpy(yaw=..., translation=(...)).inverse()` does the arithmetic; z only changes sign.",
            ko="`Transform.from_rpy(yaw=..., translation=(...)).inverse()`로 계산할 수 있습니다. z는 부호만 바뀝니다.",
        ),
    ),
    misconceptions=("M1", "M3"),
)
