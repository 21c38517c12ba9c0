"""E2.5: First the yaw, then the pitch."""

from __future__ import annotations

import math

from tflab.core import Transform
from tflab.core.quaternions import wxyz_from_xyzw
from tflab.workbook.tasks import Draws, Quaternion, Task, Text, WrongAnswer, WrongStep


def two_turns(rng: Draws) -> dict:
    """Draw a yaw and a pitch, both large enough for their order to be seen."""
    yaw = rng.choice((-1, 1)) * rng.uniform(0.5, 2.0)
    if abs(abs(yaw) - math.pi / 2) < 0.1:  # a quarter turn makes a roll of a pitch, whichever came first
        yaw *= 0.85
    pitch = rng.choice((-1, 1)) * rng.uniform(0.4, 1.2)
    return {"first_yaw_rad": round(float(yaw), 2), "then_pitch_rad": round(float(pitch), 2)}


def turned(given, unit: float = 1.0) -> Transform:
    """Return first the yaw, then the pitch, about the fixed axes."""
    return Transform.from_rpy(pitch=unit * given.then_pitch_rad) @ Transform.from_rpy(yaw=unit * given.first_yaw_rad)


def turned_twice(
    given, *, angles="in place", order="yaw first", unit="radians", yaw="left", pitch="down", result="as it is"
):
    """Return the rotation, step by step; other steps are the slips."""
    factor = {"radians": 1.0, "degrees": math.radians(1.0), "to degrees": math.degrees(1.0)}[unit]
    yaw_rad, pitch_rad = given.first_yaw_rad, given.then_pitch_rad
    yaw_rad, pitch_rad = {
        "exchanged": (pitch_rad, yaw_rad),
        "yaw in both": (yaw_rad, yaw_rad),
        "pitch in both": (pitch_rad, pitch_rad),
    }.get(angles, (yaw_rad, pitch_rad))
    ways = {
        "twice": 2.0,
        "half": 0.5,
        "about x": 1.0,
        "left": 1.0,
        "down": 1.0,
        "right": -1.0,
        "up": -1.0,
        "left out": 0.0,
        "roll": 1.0,
        "to degrees": math.degrees(1.0),
    }
    turn = ways[yaw] * factor * yaw_rad
    first = Transform.from_rpy(roll=turn) if yaw == "about x" else Transform.from_rpy(yaw=turn)
    second = ways[pitch] * factor * pitch_rad
    then = Transform.from_rpy(roll=second) if pitch == "roll" else Transform.from_rpy(pitch=second)
    both = first @ then if order == "pitch first" else then @ first
    both = {
        "sandwiched": first.inverse() @ then @ first,
        "sandwiched the other way": first @ then @ first.inverse(),
        "yaw twice": first @ then @ first,
        "pitch twice": then @ first @ then,
    }.get(order, both)
    return both.inverse().rotation if result == "inverse" else both.rotation


INVERSE = WrongStep(
    "inverse",
    {"result": "inverse"},
    Text(
        en="This undoes the two turns instead of making them. Did a sign get lost, or an inverse get in?",
        ko="두 회전을 하는 것이 아니라 되돌렸습니다. 부호를 잃었거나 inverse가 끼어들지 않았습니까?",
    ),
    misconception="M3",
)


DEGREES = WrongStep(
    "degrees",
    {"unit": "degrees"},
    Text(
        en="You turned by hundredths of what was asked: the angles are radians already.",
        ko="거의 돌지 않았습니다. 각도는 이미 라디안입니다.",
    ),
    misconception="M5",
)


W_FIRST = WrongAnswer(
    "w first",
    lambda given: wxyz_from_xyzw(turned(given).rotation),
    Text(
        en="The rotation is right, the order of its numbers is not: w comes last.",
        ko="회전은 맞지만 숫자의 순서가 다릅니다. w는 마지막에 옵니다.",
    ),
    misconception="M5",
)


OTHER_ORDER = WrongStep(
    "other order",
    {"order": "pitch first"},
    Text(
        en="That is first the pitch, then the yaw: the order that rpy always has. Here the yaw comes first, and both axes stand still. (In a product by hand, x has the other sign.)",
        ko="먼저 pitch, 다음에 yaw를 한 결과입니다. rpy는 언제나 그 순서입니다. 여기서는 yaw가 먼저이고 두 축 모두 고정되어 있습니다. (직접 곱했다면 x의 부호가 반대입니다.)",
    ),
)


YAW_ONLY = WrongStep(
    "yaw only",
    {"pitch": "left out"},
    Text(en="The pitch is missing.", ko="pitch가 빠졌습니다."),
)

PITCH_ONLY = WrongStep(
    "pitch only",
    {"yaw": "left out"},
    Text(en="The yaw is missing.", ko="yaw가 빠졌습니다."),
)

YAW_RIGHT = WrongStep(
    "yaw to the other side",
    {"yaw": "right"},
    Text(
        en="The yaw turns to the other side: a positive one turns left.",
        ko="yaw가 반대로 돌았습니다. 양수면 왼쪽으로 돕니다.",
    ),
)

PITCH_UP = WrongStep(
    "pitch to the other side",
    {"pitch": "up"},
    Text(
        en="The pitch turns to the other side: a positive one takes the nose down.",
        ko="pitch가 반대로 돌았습니다. 양수면 앞쪽이 내려갑니다.",
    ),
)

ROLL_FOR_PITCH = WrongStep(
    "roll for pitch",
    {"pitch": "roll"},
    Text(
        en="The second turn goes about x, and pitch is about y.",
        ko="둘째 회전을 x축으로 돌렸습니다. pitch는 y축 회전입니다.",
    ),
)

TO_DEGREES = WrongStep(
    "to degrees",
    {"unit": "to degrees"},
    Text(
        en="Both turns go as by degrees: the angles are radians, and `from_rpy`, sine and cosine want them as they are.",
        ko="두 각도를 도로 바꾼 것처럼 돌았습니다. 각도는 라디안이고, `from_rpy`와 sin, cos에는 그대로 넣습니다.",
    ),
)


YAW_TO_DEGREES = WrongStep(
    "yaw to degrees",
    {"yaw": "to degrees"},
    Text(
        en="The yaw turns as by degrees: it is in radians, and `from_rpy`, sine and cosine want it as it is.",
        ko="yaw를 도로 바꾼 것처럼 돌았습니다. yaw는 라디안이고, `from_rpy`와 sin, cos에는 그대로 넣습니다.",
    ),
    "M5",
)

PITCH_TO_DEGREES = WrongStep(
    "pitch to degrees",
    {"pitch": "to degrees"},
    Text(
        en="The pitch turns as by degrees: it is in radians, and `from_rpy`, sine and cosine want it as it is.",
        ko="pitch를 도로 바꾼 것처럼 돌았습니다. pitch는 라디안이고, `from_rpy`와 sin, cos에는 그대로 넣습니다.",
    ),
    "M5",
)


def of_length_one(row):
    return [number / math.hypot(*row) for number in row]


def slanted(given):
    """Return one turn whose axis and angle are those of the two angles taken for the sides of an arrow."""
    angle = math.hypot(given.first_yaw_rad, given.then_pitch_rad)
    share = math.sin(angle / 2) / angle
    return [0.0, share * given.then_pitch_rad, share * given.first_yaw_rad, math.cos(angle / 2)]


def rows(given):
    """Return the quaternions of the two turns, each on its own."""
    return [
        list(Transform.from_rpy(yaw=given.first_yaw_rad).rotation),
        list(Transform.from_rpy(pitch=given.then_pitch_rad).rotation),
    ]


SUM_AS_YAW = WrongAnswer(
    "sum as one yaw",
    lambda given: Transform.from_rpy(yaw=given.first_yaw_rad + given.then_pitch_rad).rotation,
    Text(
        en="You added the two angles to one yaw. They turn about two axes: each is a turn of its own.",
        ko="두 각도를 더해 yaw 하나로 만들었습니다. 두 각도는 서로 다른 축을 중심으로 돕니다. 회전을 따로 만드십시오.",
    ),
    "M5",
)


ADDED = WrongAnswer(
    "added",
    lambda given: [a + b for a, b in zip(*rows(given), strict=True)],
    Text(
        en="You added the two quaternions. Turns are made one after the other: they are multiplied.",
        ko="두 쿼터니언을 더했습니다. 회전은 차례로 하는 것이므로 곱합니다.",
    ),
    "M5",
)

AVERAGED = WrongAnswer(
    "averaged",
    lambda given: [(a + b) / 2 for a, b in zip(*rows(given), strict=True)],
    Text(
        en="You took the mean of the two quaternions. Turns are made one after the other: they are multiplied.",
        ko="두 쿼터니언의 평균을 냈습니다. 회전은 차례로 하는 것이므로 곱합니다.",
    ),
    "M5",
)

NUMBER_BY_NUMBER = WrongAnswer(
    "number by number",
    lambda given: [a * b for a, b in zip(*rows(given), strict=True)],
    Text(
        en="You multiplied number by number. Quaternions have a product of their own; `@` of two Transforms makes it.",
        ko="숫자끼리 곱했습니다. 쿼터니언에는 고유한 곱이 있고, Transform 둘을 `@`로 이으면 됩니다.",
    ),
    "M5",
)

WHOLE_ANGLES = WrongStep(
    "whole angles",
    {"yaw": "twice", "pitch": "twice"},
    Text(
        en="Each turn goes twice as far as asked: a quaternion holds the sine and cosine of half the angle.",
        ko="두 회전 모두 두 배로 돌았습니다. 쿼터니언에는 각도의 절반에 대한 sin과 cos을 넣습니다.",
    ),
    "M5",
)

ANGLES_EXCHANGED = WrongStep(
    "angles exchanged",
    {"angles": "exchanged"},
    Text(
        en="The two angles have changed places: the yaw turns by the pitch's angle, and the pitch by the yaw's. (Or y and z of the quaternion have.)",
        ko="두 각도가 서로 바뀌었습니다. yaw가 pitch의 각도로, pitch가 yaw의 각도로 돌았습니다. (쿼터니언의 y와 z가 바뀌어도 같습니다.)",
    ),
)

ANGLES_AS_NUMBERS = WrongAnswer(
    "angles as numbers",
    lambda given: [0.0, given.then_pitch_rad, given.first_yaw_rad, 1.0],
    Text(
        en="You wrote the angles themselves into y and z. A quaternion holds no angles.",
        ko="y와 z에 각도를 그대로 넣었습니다. 쿼터니언에는 각도가 직접 들어가지 않습니다.",
    ),
    "M5",
)

HALVES_BESIDE = WrongAnswer(
    "halves side by side",
    lambda given: [
        0.0,
        math.sin(given.then_pitch_rad / 2),
        math.sin(given.first_yaw_rad / 2),
        math.cos(given.then_pitch_rad / 2) * math.cos(given.first_yaw_rad / 2),
    ],
    Text(
        en="You put the sines of both halves side by side. Two turns one after the other also mix: make each a Transform, and multiply.",
        ko="두 절반의 sin을 나란히 적었습니다. 차례로 돌리면 서로 섞입니다. 각각 Transform으로 만들어 곱하십시오.",
    ),
    "M5",
)


YAW_TWICE = WrongStep(
    "yaw twice",
    {"yaw": "twice"},
    Text(
        en="The yaw turns twice as far as asked: made twice, or its angle not halved in the quaternion.",
        ko="yaw가 두 배로 돕니다. 두 번 돌렸거나, 쿼터니언에서 각도를 반으로 나누지 않았습니다.",
    ),
    "M5",
)


PITCH_TWICE = WrongStep(
    "pitch twice",
    {"pitch": "twice"},
    Text(
        en="The pitch turns twice as far as asked: made twice, or its angle not halved in the quaternion.",
        ko="pitch가 두 배로 돕니다. 두 번 돌렸거나, 쿼터니언에서 각도를 반으로 나누지 않았습니다.",
    ),
    "M5",
)


YAW_ABOUT_X = WrongStep(
    "yaw about x",
    {"yaw": "about x"},
    Text(
        en="The first turn goes about x, and yaw is about z.",
        ko="첫 회전이 x축 둘레로 돕니다. yaw는 z축 둘레입니다.",
    ),
)


SANDWICHED = WrongStep(
    "sandwiched",
    {"order": "sandwiched"},
    Text(
        en="You put the pitch between a yaw and its inverse: then the yaw is undone again. Both turns stay: the later one stands left.",
        ko="pitch를 yaw와 그 역회전 사이에 넣어서 yaw가 다시 풀렸습니다. 두 회전이 모두 남아야 합니다. 나중 것이 왼쪽에 섭니다.",
    ),
)


SANDWICHED_THE_OTHER_WAY = WrongStep(
    "sandwiched the other way",
    {"order": "sandwiched the other way"},
    Text(
        en="You made yaw @ pitch @ yaw.inverse(), as one takes a turn about another axis: the yaw is undone again. Both turns stay: the later one stands left.",
        ko="다른 축의 회전으로 바꿀 때처럼 yaw @ pitch @ yaw.inverse()를 만들어서 yaw가 다시 풀렸습니다. 두 회전이 모두 남아야 합니다. 나중 것이 왼쪽에 섭니다.",
    ),
)


YAW_ON_BOTH_SIDES = WrongStep(
    "yaw on both sides",
    {"order": "yaw twice"},
    Text(
        en="The yaw is in it twice, before the pitch and after it. Each turn is made once.",
        ko="yaw가 pitch의 앞과 뒤에 두 번 들어 있습니다. 회전마다 한 번씩만 곱합니다.",
    ),
)


PITCH_ON_BOTH_SIDES = WrongStep(
    "pitch on both sides",
    {"order": "pitch twice"},
    Text(
        en="The pitch is in it twice, before the yaw and after it. Each turn is made once.",
        ko="pitch가 yaw의 앞과 뒤에 두 번 들어 있습니다. 회전마다 한 번씩만 곱합니다.",
    ),
)


AVERAGED_TO_LENGTH_ONE = WrongAnswer(
    "averaged to length one",
    lambda given: of_length_one([a + b for a, b in zip(*rows(given), strict=True)]),
    Text(
        en="You took the middle of the two quaternions and scaled it to length one: that turns about half as far as both together. Turns are multiplied.",
        ko="두 쿼터니언의 중간을 구해 길이를 1로 맞추었습니다. 둘을 합친 것의 절반쯤만 돕니다. 회전은 곱합니다.",
    ),
)


ONE_TURN_ABOUT_A_SLANTED_AXIS = WrongAnswer(
    "one turn about a slanted axis",
    slanted,
    Text(
        en="You made one turn about the axis between y and z. Two turns one after the other are two factors, and their order counts.",
        ko="y와 z 사이의 축 하나로 한 번 돌렸습니다. 이어지는 두 회전은 곱하는 두 인자이고 순서가 중요합니다.",
    ),
)


HALVED = WrongStep(
    "halved",
    {"yaw": "half", "pitch": "half"},
    Text(
        en="Both turns go half as far as asked: the angles were halved before they became turns. `from_rpy` takes the whole angle; the half is made inside.",
        ko="두 회전이 모두 절반만 돕니다. 각도를 미리 절반으로 나누었습니다. `from_rpy`에는 각도를 그대로 넣습니다. 절반은 안에서 만듭니다.",
    ),
    "M5",
)


YAW_HALVED = WrongStep(
    "yaw halved",
    {"yaw": "half"},
    Text(
        en="The yaw turns half as far as asked: `from_rpy` takes the whole angle.",
        ko="yaw가 절반만 돕니다. `from_rpy`에는 각도를 그대로 넣습니다.",
    ),
    "M5",
)


PITCH_HALVED = WrongStep(
    "pitch halved",
    {"pitch": "half"},
    Text(
        en="The pitch turns half as far as asked: `from_rpy` takes the whole angle.",
        ko="pitch가 절반만 돕니다. `from_rpy`에는 각도를 그대로 넣습니다.",
    ),
    "M5",
)


BOTH_TO_THE_OTHER_SIDE = WrongStep(
    "both to the other side",
    {"yaw": "right", "pitch": "up"},
    Text(
        en="Both turns go to the other side: a positive yaw turns left, a positive pitch takes the nose down. (The inverse of the two in the other order is just that.)",
        ko="두 회전 모두 반대쪽으로 돕니다. 양의 yaw는 왼쪽으로, 양의 pitch는 앞이 내려가는 쪽으로 돕니다. (순서를 바꾼 곱의 역회전도 이와 같습니다.)",
    ),
)


YAW_IN_BOTH = WrongStep(
    "yaw in both",
    {"angles": "yaw in both"},
    Text(
        en="Both turns go by the yaw's angle: the pitch has one of its own.",
        ko="두 회전 모두 yaw의 각도만큼 돕니다. pitch에는 따로 주어진 각도를 쓰십시오.",
    ),
)


PITCH_IN_BOTH = WrongStep(
    "pitch in both",
    {"angles": "pitch in both"},
    Text(
        en="Both turns go by the pitch's angle: the yaw has one of its own.",
        ko="두 회전 모두 pitch의 각도만큼 돕니다. yaw에는 따로 주어진 각도를 쓰십시오.",
    ),
)


def halves(given) -> tuple[float, float, float, float]:
    """Return the sine and cosine of half the yaw, and of half the pitch."""
    yaw, pitch = given.first_yaw_rad / 2, given.then_pitch_rad / 2
    return math.sin(yaw), math.cos(yaw), math.sin(pitch), math.cos(pitch)


def joined(pitch: tuple, yaw: tuple) -> tuple[float, ...]:
    """Return the product of two quaternions of length one, the yaw first."""
    return (Transform(rotation=pitch) @ Transform(rotation=yaw)).rotation


def with_the_yaw_exchanged(given):
    ys, yc, ps, pc = halves(given)
    return joined((0.0, ps, 0.0, pc), (0.0, 0.0, yc, ys))


def with_the_pitch_exchanged(given):
    ys, yc, ps, pc = halves(given)
    return joined((0.0, pc, 0.0, ps), (0.0, 0.0, ys, yc))


def with_both_exchanged(given):
    ys, yc, ps, pc = halves(given)
    return joined((0.0, pc, 0.0, ps), (0.0, 0.0, yc, ys))


def with_w_first_inside(given):
    ys, yc, ps, pc = halves(given)
    return joined((pc, 0.0, ps, 0.0), (yc, 0.0, 0.0, ys))


def without_x(given):
    ys, yc, ps, pc = halves(given)
    return 0.0, ps * yc, pc * ys, pc * yc


def beside_half_the_sum(given):
    ys, _, ps, _ = halves(given)
    return 0.0, ps, ys, math.cos((given.first_yaw_rad + given.then_pitch_rad) / 2)


def pitch_undone(given):
    yaw, pitch = (Transform(rotation=tuple(row)) for row in rows(given))
    return (pitch @ yaw @ pitch.inverse()).rotation


def of_numbers(name: str, answer, en: str, ko: str) -> WrongAnswer:
    """Return an answer that stands alone: it composes with no other slip."""
    return WrongAnswer(name, answer, Text(en=en, ko=ko), "M5")


BY_HAND = (
    of_numbers(
        "no turn",
        (0.0, 0.0, 0.0, 1.0),
        "(0, 0, 0, 1) is no turn at all: neither of the two is in it. Multiplied number by number and scaled to length one, they come to this as well: quaternions have a product of their own, `@` of two Transforms.",
        "(0, 0, 0, 1)은 돌지 않은 것입니다. 두 회전이 모두 들어 있지 않습니다. 숫자끼리 곱해서 길이를 1로 맞추어도 이렇게 됩니다. 쿼터니언에는 고유한 곱이 있고, Transform 둘을 `@`로 이으면 됩니다.",
    ),
    of_numbers(
        "pitch undone",
        pitch_undone,
        "You put the yaw between a pitch and its inverse: then the pitch is undone again. Both turns stay.",
        "yaw를 pitch와 그 역회전 사이에 넣어서 pitch가 다시 풀렸습니다. 두 회전이 모두 남아야 합니다.",
    ),
    of_numbers(
        "sine in the yaw's w",
        with_the_yaw_exchanged,
        "In the yaw's quaternion sine and cosine have changed places: z takes the sine of the half, w the cosine.",
        "yaw의 쿼터니언에서 sin과 cos의 자리가 바뀌었습니다. z에 절반의 sin, w에 cos을 넣습니다.",
    ),
    of_numbers(
        "sine in the pitch's w",
        with_the_pitch_exchanged,
        "In the pitch's quaternion sine and cosine have changed places: y takes the sine of the half, w the cosine.",
        "pitch의 쿼터니언에서 sin과 cos의 자리가 바뀌었습니다. y에 절반의 sin, w에 cos을 넣습니다.",
    ),
    of_numbers(
        "sine in both w",
        with_both_exchanged,
        "In both quaternions sine and cosine have changed places: w takes the cosine of the half.",
        "두 쿼터니언 모두 sin과 cos의 자리가 바뀌었습니다. w에는 절반의 cos을 넣습니다.",
    ),
    of_numbers(
        "w first inside",
        with_w_first_inside,
        "The two quaternions went in with w in front, and were taken for (x, y, z, w): w comes last.",
        "두 쿼터니언의 w를 앞에 두고 넣었는데, (x, y, z, w)로 읽혔습니다. w는 마지막에 옵니다.",
    ),
    of_numbers(
        "x left out",
        without_x,
        "y, z and w are those of the product, and x is 0: two turns about two axes also mix into the third.",
        "y, z, w는 곱한 값인데 x가 0입니다. 두 축의 회전을 이으면 셋째 축에도 값이 생깁니다.",
    ),
    of_numbers(
        "halves beside half the sum",
        beside_half_the_sum,
        "The sines of both halves stand side by side, and w is the cosine of half the sum. Two turns are multiplied, "
        "and mix.",
        "두 절반의 sin을 나란히 적고 w에는 합의 절반의 cos을 넣었습니다. 두 회전은 곱하고, 그러면 서로 섞입니다.",
    ),
    of_numbers(
        "sum as one pitch",
        lambda given: Transform.from_rpy(pitch=given.first_yaw_rad + given.then_pitch_rad).rotation,
        "You added the two angles to one pitch. They turn about two axes: each is a turn of its own.",
        "두 각도를 더해 pitch 하나로 만들었습니다. 두 각도는 서로 다른 축을 중심으로 돕니다. 회전을 따로 만드십시오.",
    ),
)


TASK = Task(
    id="E2.5",
    kind="N",
    points=3,
    title=Text(en="First the yaw, then the pitch", ko="먼저 yaw, 다음에 pitch"),
    answer="robot_q_sensor",
    form=Quaternion(tolerance=2e-3),
    given=two_turns,
    variants=5,
    model=turned_twice,
    mistakes=(
        OTHER_ORDER,
        INVERSE,
        DEGREES,
        W_FIRST,
        YAW_ONLY,
        PITCH_ONLY,
        YAW_RIGHT,
        PITCH_UP,
        ROLL_FOR_PITCH,
        TO_DEGREES,
        YAW_TO_DEGREES,
        PITCH_TO_DEGREES,
        ADDED,
        SUM_AS_YAW,
        AVERAGED,
        NUMBER_BY_NUMBER,
        WHOLE_ANGLES,
        ANGLES_EXCHANGED,
        ANGLES_AS_NUMBERS,
        HALVES_BESIDE,
        YAW_TWICE,
        PITCH_TWICE,
        YAW_ABOUT_X,
        SANDWICHED,
        SANDWICHED_THE_OTHER_WAY,
        YAW_ON_BOTH_SIDES,
        PITCH_ON_BOTH_SIDES,
        AVERAGED_TO_LENGTH_ONE,
        ONE_TURN_ABOUT_A_SLANTED_AXIS,
        HALVED,
        YAW_HALVED,
        PITCH_HALVED,
        BOTH_TO_THE_OTHER_SIDE,
        YAW_IN_BOTH,
        PITCH_IN_BOTH,
        *BY_HAND,
    ),
    hints=(
        Text(
            en="Two turns, two transforms, one product. Which factor stands next to the point?",
            ko="회전 둘, 변환 둘, 곱 하나입니다. 점과 가까운 쪽에 어느 것이 옵니까?",
        ),
        Text(
            en="What happens first stands on the right. from_rpy with both angles at once has the other order built in.",
            ko="먼저 일어나는 것이 오른쪽에 옵니다. from_rpy에 두 각도를 한꺼번에 넣으면 순서가 반대로 정해져 있습니다.",
        ),
        Text(
            en="Make yaw = Transform.from_rpy(yaw=...) and pitch = Transform.from_rpy(pitch=...), multiply with @, and take .rotation.",
            ko="yaw = Transform.from_rpy(yaw=...)와 pitch = Transform.from_rpy(pitch=...)를 만들어 @로 곱하고 .rotation을 꺼내십시오.",
        ),
    ),
    misconceptions=("M5",),
)
