"""E3.4: Two dominoes into one."""

from __future__ import annotations

import math
from functools import partial

from tflab.workbook.tasks import Draws, Task, Text, WrongAnswer, WrongStep

from .draws import (
    PLANAR,
    WRONG_TERMS,
    by_formula,
    moved,
    some_planar,
    wrong_terms,
)


def compose_inputs(rng: Draws) -> list[tuple]:
    """Draw pairs, in one of which the yaws add up to more than half a turn, and in one of which they differ by more."""
    nothing = {"x": 0.0, "y": 0.0, "yaw": 0.0}
    sums = differences = [0.0]
    while max(sums) <= math.pi or max(differences) <= math.pi:
        pairs = [(some_planar(rng), some_planar(rng)) for _ in range(4)]
        sums = [abs(one["yaw"] + two["yaw"]) for one, two in pairs]
        differences = [abs(one["yaw"] - two["yaw"]) for one, two in pairs]
    straight = {"x": 1.5, "y": -2.0, "yaw": 0.0}  # not turned, and not at the origin either
    return [*pairs, (some_planar(rng), nothing), (nothing, some_planar(rng)), (straight, some_planar(rng))]


def turned_round(pose):
    """Return the pose of a in b of that of b in a."""
    return moved({"yaw": -pose["yaw"]}, -pose["x"], -pose["y"], -pose["yaw"])


def joined(
    a_pose_b,
    b_pose_c,
    *,
    first="as it is",
    second="as it is",
    order="as given",
    unit="radians",
    turned="second",
    by="first",
    step="added",
    yaw="sum",
    end="as it is",
):
    """Return a_pose_c, step by step; other steps are the slips."""
    a_pose_b = turned_round(a_pose_b) if first == "inverted" else a_pose_b
    b_pose_c = turned_round(b_pose_c) if second == "inverted" else b_pose_c
    outer, inner = (b_pose_c, a_pose_b) if order == "exchanged" else (a_pose_b, b_pose_c)
    one, two = outer["yaw"], inner["yaw"]
    angle = {"first": one, "back": -one, "second": two, "both": one + two, "none": 0.0,
             "half": one / 2, "difference": one - two}[by]  # fmt: skip
    angle = math.radians(angle) if unit == "degrees" else angle
    if turned == "first":  # and the second added as it is
        angle, step = one, "as it is"
    x, y = (outer["x"], outer["y"]) if turned == "first" else (inner["x"], inner["y"])
    if turned == "sum":
        x, y = x + outer["x"], y + outer["y"]
    if turned == "difference":
        x, y = x - outer["x"], y - outer["y"]
    pose = moved(inner, x, y, angle)
    if step == "x alone turned":
        pose |= {"y": y}
    if step in ("one sign in x", "one sign in y"):
        c, s = math.cos(angle), math.sin(angle)
        pose |= {"x": c * x + s * y} if step == "one sign in x" else {"y": c * y - s * x}
    if step in WRONG_TERMS:
        pose |= dict(zip("xy", by_formula(x, y, angle, step), strict=True))
    if step == "exchanged":
        pose |= {"x": math.sin(angle) * x - math.cos(angle) * y, "y": math.cos(angle) * x + math.sin(angle) * y}
    if step == "new x":
        pose |= {"y": math.sin(angle) * pose["x"] + math.cos(angle) * y}
    if step == "new x, added":
        pose |= {"y": math.sin(angle) * (pose["x"] + outer["x"]) + math.cos(angle) * y}
    if step == "second lost":
        pose |= {"x": 0.0, "y": 0.0}
    if step == "first twice":
        pose |= {"x": pose["x"] + outer["x"], "y": pose["y"] + outer["y"]}
    if turned == "first":
        pose |= {"x": pose["x"] + inner["x"], "y": pose["y"] + inner["y"]}
    if turned == "second" and step != "lost":
        sign = -1.0 if step == "subtracted" else 1.0
        pose |= {"x": -pose["x"], "y": -pose["y"]} if step == "second subtracted" else {}
        pose |= {"x": pose["x"] + sign * outer["x"], "y": pose["y"] + sign * outer["y"]}
    pose |= {
        "yaw": {
            "sum": one + two,
            "second": two,
            "first": one,
            "difference": two - one,
            "first minus second": one - two,
            "mean": (one + two) / 2,
            "product": one * two,
            "sizes": abs(one) + abs(two),
            "first twice": 2 * one,
            "asin": math.asin(math.sin(one + two)),
            "atan": math.atan(math.tan(one + two)),
            "atan2 exchanged": math.atan2(math.cos(one + two), math.sin(one + two)),
            "mean of directions": math.atan2(math.sin(one) + math.sin(two), math.cos(one) + math.cos(two)),
            "half turns off": one + two - math.copysign(math.pi, one + two) * (abs(one + two) > math.pi),
            "half a turn more": one + two + math.pi,
            "modulo pi": (one + two) % math.pi,
            "clamped": max(-math.pi, min(math.pi, one + two)),
        }[yaw]
    }
    return turned_round(pose) if end == "inverted" else pose


OTHER_ORDER = WrongStep(
    "other_order",
    {"order": "exchanged"},
    Text(
        en="you put them together in the other order: b_pose_c first, then a_pose_b. Lay the dominoes: [a|b][b|c].",
        ko="순서를 바꿔 이었습니다. b_pose_c가 먼저, a_pose_b가 나중입니다. 도미노를 놓아 보십시오. [a|b][b|c]",
    ),
)


WAY_BACK = WrongStep(
    "way_back",
    {"end": "inverted"},
    Text(
        en="that is the way back, c_pose_a, and a_pose_c is asked for: it is inverted once too often.",
        ko="구해야 할 것은 a_pose_c인데 돌아오는 길인 c_pose_a가 나왔습니다. 한 번 더 뒤집혔습니다.",
    ),
    "M1",
)


ONLY_ADDED = WrongStep(
    "only_added",
    {"by": "none"},
    Text(
        en="you added the steps as they are. The second step is measured along b's axes, and b is turned in a.",
        ko="이동을 그대로 더했습니다. 둘째 이동은 b의 축을 따라 잰 값이고, b는 a를 기준으로 돌아가 있습니다.",
    ),
    "M3",
)


TURNED_BACK = WrongStep(
    "turned_back",
    {"by": "back"},
    Text(
        en="the second step is turned the wrong way. What is measured along b's axes goes to a by b's own yaw, with the "
        "sign that it has.",
        ko="둘째 이동을 반대로 돌렸습니다. b의 축을 따라 잰 것은 b의 yaw만큼, 부호도 그대로 돌려서 a로 옮깁니다.",
    ),
    "M1",
)


TURNED_BY_BOTH = WrongStep(
    "turned_by_both",
    {"by": "both"},
    Text(
        en="you turned the second step by both yaws. It is measured along b's axes; c's own yaw turns what "
        "comes after c.",
        ko="둘째 이동을 두 yaw의 합만큼 돌렸습니다. 둘째 이동은 b의 축을 따라 잰 값입니다. c의 yaw는 c 다음에 오는 "
        "것을 돌립니다.",
    ),
)


ADDED_THEN_TURNED = WrongStep(
    "added_then_turned",
    {"turned": "sum"},
    Text(
        en="you added the steps and then turned the sum. The first step is measured in a already, so nobody turns it.",
        ko="이동을 더한 다음 합을 돌렸습니다. 첫째 이동은 이미 a에서 잰 값이므로 돌리지 않습니다.",
    ),
)


FIRST_TURNED_INSTEAD = WrongStep(
    "first turned instead",
    {"turned": "first"},
    Text(
        en="you turned the first step and added the second as it is. It is the second that is measured along b's axes, "
        "which are turned in a.",
        ko="첫째 이동을 돌리고 둘째 이동은 그대로 더했습니다. a를 기준으로 돌아가 있는 b의 축을 따라 잰 것은 둘째 "
        "이동입니다.",
    ),
    "M3",
)


YAWS_NOT_ADDED = WrongStep(
    "yaws_not_added",
    {"yaw": "second"},
    Text(
        en="the yaw is that of c in b: in a, b's own turn comes on top.",
        ko="yaw는 b에서 본 c의 값입니다. a에서 보면 b가 돌아간 만큼 더해집니다.",
    ),
)


TURNED_BY_THE_SECOND = WrongStep(
    "turned_by_the_second",
    {"by": "second"},
    Text(
        en="you turned the second step by its own yaw. It is b that is turned in a: which of the two yaws "
        "says by how much?",
        ko="둘째 이동을 자기 yaw로 돌렸습니다. a를 기준으로 돌아가 있는 것은 b입니다. 그 각도는 두 yaw 가운데 "
        "어느 것입니까?",
    ),
)


FIRST_STEP_LOST = WrongStep(
    "first_step_lost",
    {"step": "lost"},
    Text(
        en="you forgot to add the first step: b itself does not lie at a's origin.",
        ko="첫째 이동을 더하지 않았습니다. b는 a의 원점에 있지 않습니다.",
    ),
)


DEGREES = WrongStep(
    "degrees",
    {"unit": "degrees"},
    Text(
        en="the step has hardly turned: the yaw comes in radians already, and you converted it once more.",
        ko="이동이 거의 돌지 않았습니다. yaw는 이미 라디안인데 한 번 더 바꾸었습니다.",
    ),
    "M5",
)

SUBTRACTED = WrongStep(
    "first step subtracted",
    {"step": "subtracted"},
    Text(en="the first step is subtracted, and it should be added.", ko="첫째 이동을 뺐습니다. 더해야 합니다."),
)

YAW_OF_THE_FIRST = WrongStep(
    "yaw of the first",
    {"yaw": "first"},
    Text(
        en="the yaw is that of b in a: c's own turn comes on top.",
        ko="yaw가 a에서 본 b의 값입니다. 거기에 c가 돌아간 만큼 더해집니다.",
    ),
)

YAWS_SUBTRACTED = WrongStep(
    "yaws subtracted",
    {"yaw": "difference"},
    Text(
        en="the yaws are subtracted: two turns, one after the other, add up.",
        ko="yaw를 서로 뺐습니다. 이어서 도는 두 회전은 더합니다.",
    ),
)

SECOND_SUBTRACTED = WrongStep(
    "second_subtracted",
    {"step": "second subtracted"},
    Text(
        en="you took the second step off. From a one walks to b, and from there on to c: the steps add up.",
        ko="둘째 이동을 뺐습니다. a에서 b까지 가고 거기서 c까지 더 갑니다. 이동은 더합니다.",
    ),
)

DIFFERENCE_TURNED = WrongStep(
    "difference_turned",
    {"turned": "difference"},
    Text(
        en="you turned the difference of the two steps. Only the second step is turned, and then the first is added.",
        ko="두 이동의 차를 돌렸습니다. 둘째 이동만 돌린 다음 첫째를 더하십시오.",
    ),
)

YAWS_MULTIPLIED = WrongStep(
    "yaws multiplied",
    {"yaw": "product"},
    Text(
        en="you multiplied the yaws. Turns in the plane add up.",
        ko="yaw를 곱했습니다. 평면에서 회전은 더합니다.",
    ),
)


FIRST_INVERTED = WrongStep(
    "first inverted",
    {"first": "inverted"},
    Text(
        en="you turned the first pose round before joining. It stands as it is: [a|b] begins with a already.",
        ko="앞의 포즈를 뒤집은 다음 이었습니다. [a|b]는 이미 a로 시작하므로 그대로 씁니다.",
    ),
    "M1",
)


SECOND_INVERTED = WrongStep(
    "second inverted",
    {"second": "inverted"},
    Text(
        en="you turned the second pose round before joining. It stands as it is: [b|c] begins where the first ends.",
        ko="뒤의 포즈를 뒤집은 다음 이었습니다. [b|c]는 앞의 것이 끝나는 곳에서 시작하므로 그대로 씁니다.",
    ),
    "M1",
)


ONE_SIGN_IN_X = WrongStep(
    "one sign in x",
    {"step": "one sign in x"},
    Text(
        en="one sine in your x has the wrong sign: look at the formula once more, u·cos α − v·sin α.",
        ko="x의 sin 하나의 부호가 틀렸습니다. 공식을 다시 보십시오: u·cos α − v·sin α.",
    ),
)


ONE_SIGN_IN_Y = WrongStep(
    "one sign in y",
    {"step": "one sign in y"},
    Text(
        en="one sine in your y has the wrong sign: look at the formula once more, u·sin α + v·cos α.",
        ko="y의 sin 하나의 부호가 틀렸습니다. 공식을 다시 보십시오: u·sin α + v·cos α.",
    ),
)


Y_NOT_TURNED = WrongStep(
    "y not turned",
    {"step": "x alone turned"},
    Text(
        en="your x is turned, and your y is only added: both take a part of u and of v.",
        ko="x는 돌렸지만 y는 더하기만 했습니다. 둘 다 u와 v가 함께 들어갑니다.",
    ),
)


SECOND_STEP_LOST = WrongStep(
    "second step lost",
    {"step": "second lost"},
    Text(
        en="you give the place of b: the second step has not come into x and y.",
        ko="b의 위치를 답했습니다. 두 번째 이동이 x와 y에 들어가지 않았습니다.",
    ),
)


FIRST_STEP_TWICE = WrongStep(
    "first step twice",
    {"step": "first twice"},
    Text(
        en="the first step is added twice. One walks from a to b once, and from there on to c.",
        ko="첫 번째 이동을 두 번 더했습니다. a에서 b까지 한 번 가고 거기서 c까지 갑니다.",
    ),
)


FIRST_YAW_MINUS_SECOND = WrongStep(
    "first yaw minus second",
    {"yaw": "first minus second"},
    Text(
        en="you took the second yaw off the first: two turns, one after the other, add up.",
        ko="첫 번째 yaw에서 두 번째를 뺐습니다. 이어지는 두 회전은 더합니다.",
    ),
)


MEAN_OF_THE_YAWS = WrongStep(
    "mean of the yaws",
    {"yaw": "mean"},
    Text(
        en="you took the mean of the two yaws: two turns, one after the other, add up.",
        ko="두 yaw의 평균을 구했습니다. 이어지는 두 회전은 더합니다.",
    ),
)


SINE_FOR_COSINE = WrongStep(
    "sine for cosine",
    {"step": "exchanged"},
    Text(
        en="sine and cosine have changed places in the turn.",
        ko="회전 공식에서 sin과 cos의 자리가 바뀌었습니다.",
    ),
)


EACH_BY_ITS_OWN = WrongAnswer(
    "each by its own yaw",
    lambda one, two: {
        **{
            name: sum(moved(pose, pose["x"], pose["y"], pose["yaw"])[name] for pose in (one, two))
            for name in ("x", "y")
        },
        "yaw": one["yaw"] + two["yaw"],
    },
    Text(
        en="you turned each step by its own yaw. The first is measured in a already; the second is measured along b's "
        "axes, and b's yaw is the first one.",
        ko="이동을 각각 자기 yaw로 돌렸습니다. 첫째는 이미 a에서 잰 값이고, 둘째는 b의 축을 따라 잰 값인데 b의 yaw는 첫째 "
        "yaw입니다.",
    ),
)


NEW_X = WrongAnswer(
    "new x",
    partial(joined, step="new x"),
    Text(
        en="for `y` you used the x that had just been turned. Both take the old ones: give the results other names.",
        ko="`y`를 구할 때 방금 돌린 x를 썼습니다. 둘 다 돌리기 전의 값으로 계산합니다. 결과에는 다른 이름을 붙이십시오.",
    ),
)


NEW_X_ADDED = WrongAnswer(
    "new x, added",
    partial(joined, step="new x, added"),
    Text(
        en="for `y` you used the result for x, which had taken the place of the second step's. Give the results other "
        "names.",
        ko="`y`를 구할 때 둘째 이동의 x를 덮어쓴 결과 x를 썼습니다. 결과에는 다른 이름을 붙이십시오.",
    ),
)


# what only the yaw shows stands alone: beside a slip of x and y it is found part by part
YAW_BY_ASIN = WrongAnswer(
    "yaw by asin",
    partial(joined, yaw="asin"),
    Text(
        en="where the yaws add up to more than a quarter turn, yours comes out mirrored, as by `asin`, which never gives "
        "more than π/2. The sum is the yaw already.",
        ko="yaw의 합이 1/4 바퀴를 넘으면 거울에 비친 듯한 각도가 나옵니다. `asin`은 π/2보다 큰 각도를 내지 않습니다. 합이 "
        "그대로 yaw입니다.",
    ),
)


YAW_BY_ATAN = WrongAnswer(
    "yaw by atan",
    partial(joined, yaw="atan"),
    Text(
        en="where the yaws add up to more than a quarter turn, yours is half a turn off, as by `atan`, which never gives "
        "more than π/2. The sum is the yaw already.",
        ko="yaw의 합이 1/4 바퀴를 넘으면 반 바퀴 어긋납니다. `atan`은 π/2보다 큰 각도를 내지 않습니다. 합이 그대로 "
        "yaw입니다.",
    ),
)


ATAN2_EXCHANGED = WrongAnswer(
    "atan2 exchanged",
    partial(joined, yaw="atan2 exchanged"),
    Text(
        en="your yaw is π/2 minus the sum, as where `atan2` gets its two arguments the wrong way round: the sine comes "
        "first.",
        ko="yaw가 π/2에서 합을 뺀 값입니다. `atan2`의 두 인자를 바꿔 넣으면 이렇게 됩니다. sin이 먼저입니다.",
    ),
)


MEAN_OF_DIRECTIONS = WrongAnswer(
    "mean of directions",
    partial(joined, yaw="mean of directions"),
    Text(
        en="you took the direction midway between the two yaws, as `atan2` of added sines and added cosines gives it: two "
        "turns, one after the other, add up.",
        ko="두 yaw의 한가운데 방향을 구했습니다. sin끼리, cos끼리 더해 `atan2`에 넣으면 이렇게 됩니다. 이어지는 두 회전은 "
        "더합니다.",
    ),
)


HALF_TURNS_OFF = WrongAnswer(
    "half turns off",
    partial(joined, yaw="half turns off"),
    Text(
        en="where the yaws add up to more than half a turn, yours is π off: a full turn may be taken off or added there, "
        "2π, and half a turn is another direction.",
        ko="yaw의 합이 반 바퀴를 넘으면 π만큼 어긋납니다. 거기서 더하거나 빼도 되는 것은 한 바퀴, 곧 2π입니다. 반 바퀴면 다른 "
        "방향이 됩니다.",
    ),
)


HALF_A_TURN_MORE = WrongAnswer(
    "half a turn more",
    partial(joined, yaw="half a turn more"),
    Text(
        en="your yaw is the sum and half a turn, in every call: that is the opposite direction. The sum is the yaw already.",
        ko="어느 호출에서나 yaw가 합에 반 바퀴를 더하거나 뺀 값입니다. 반대 방향입니다. 합이 그대로 yaw입니다.",
    ),
)


YAW_MODULO_PI = WrongAnswer(
    "yaw modulo pi",
    partial(joined, yaw="modulo pi"),
    Text(
        en="your yaw always lies between 0 and π, as by `% math.pi`: half turns are lost. A full turn is 2π.",
        ko="`% math.pi`를 쓴 것처럼 yaw가 언제나 0과 π 사이입니다. 반 바퀴가 사라집니다. 한 바퀴는 2π입니다.",
    ),
)


YAW_CLAMPED = WrongAnswer(
    "yaw clamped",
    partial(joined, yaw="clamped"),
    Text(
        en="where the yaws add up to more than half a turn, yours stops at π or at −π. A turn goes on from there: it may "
        "be written with a full turn less, but not cut off.",
        ko="yaw의 합이 반 바퀴를 넘으면 π나 −π에서 멈춥니다. 회전은 거기서 끝나지 않습니다. 한 바퀴를 빼서 쓸 수는 있어도 "
        "잘라 낼 수는 없습니다.",
    ),
)


BY_HALF = WrongAnswer(
    "turned by half",
    partial(joined, by="half"),
    Text(
        en="the second step is turned by half of b's yaw. Halves belong into quaternions; a step turns by all of it.",
        ko="둘째 이동을 b의 yaw의 절반만 돌렸습니다. 절반은 쿼터니언에만 쓰고, 이동은 각도 전체만큼 돌립니다.",
    ),
)


BY_THE_DIFFERENCE = WrongAnswer(
    "turned by the difference",
    partial(joined, by="difference"),
    Text(
        en="the second step is turned by the difference of the yaws. It is measured along b's axes: b's own yaw turns it.",
        ko="둘째 이동을 두 yaw의 차이만큼 돌렸습니다. 그 이동은 b의 축을 따라 잰 것이므로 b의 yaw로 돌립니다.",
    ),
)


SUM_OF_SIZES = WrongAnswer(
    "sum of the sizes",
    partial(joined, yaw="sizes"),
    Text(
        en="your yaw is the sum of the sizes: a turn to the right has lost its minus sign.",
        ko="yaw의 크기를 더했습니다. 오른쪽으로 도는 회전의 마이너스 부호가 없어졌습니다.",
    ),
)


FIRST_YAW_TWICE = WrongAnswer(
    "first yaw twice",
    partial(joined, yaw="first twice"),
    Text(
        en="the first yaw is added to itself: c's own turn, the second yaw, has not come in.",
        ko="첫째 yaw를 두 번 더했습니다. c 자신의 회전인 둘째 yaw가 들어가지 않았습니다.",
    ),
)


TASK = Task(
    id="E3.4",
    kind="F",
    points=4,
    title=Text(en="Two dominoes into one", ko="도미노 둘을 하나로"),
    answer="compose",
    form=PLANAR,
    inputs=compose_inputs,
    variants=3,
    model=joined,
    mistakes=(
        OTHER_ORDER,
        WAY_BACK,
        ONLY_ADDED,
        TURNED_BACK,
        TURNED_BY_THE_SECOND,
        TURNED_BY_BOTH,
        ADDED_THEN_TURNED,
        FIRST_TURNED_INSTEAD,
        FIRST_STEP_LOST,
        YAWS_NOT_ADDED,
        DEGREES,
        SUBTRACTED,
        YAW_OF_THE_FIRST,
        YAWS_SUBTRACTED,
        SECOND_SUBTRACTED,
        DIFFERENCE_TURNED,
        YAWS_MULTIPLIED,
        FIRST_INVERTED,
        SECOND_INVERTED,
        ONE_SIGN_IN_X,
        ONE_SIGN_IN_Y,
        Y_NOT_TURNED,
        SECOND_STEP_LOST,
        FIRST_STEP_TWICE,
        FIRST_YAW_MINUS_SECOND,
        MEAN_OF_THE_YAWS,
        *wrong_terms("step"),
        SINE_FOR_COSINE,
        EACH_BY_ITS_OWN,
        NEW_X,
        NEW_X_ADDED,
        YAW_BY_ASIN,
        YAW_BY_ATAN,
        ATAN2_EXCHANGED,
        MEAN_OF_DIRECTIONS,
        HALF_TURNS_OFF,
        HALF_A_TURN_MORE,
        YAW_MODULO_PI,
        YAW_CLAMPED,
        BY_HALF,
        BY_THE_DIFFERENCE,
        SUM_OF_SIZES,
        FIRST_YAW_TWICE,
    ),
    hints=(
        Text(
            en="Where is c's origin in b? Move that point to a, as in E3.2.",
            ko="c의 원점은 b에서 어디입니까? 그 점을 E3.2처럼 a로 옮기십시오.",
        ),
        Text(
            en="The second step is measured along b's axes. Which of the two yaws says how far these are turned in a?",
            ko="둘째 이동은 b의 축을 따라 잰 값입니다. 그 축이 a를 기준으로 돌아간 각도는 두 yaw 가운데 어느 것입니까?",
        ),
        Text(
            en="Turn the second step by a_pose_b's yaw and add the first step; the yaws add up. "
            "Then compose(p, invert(p)) must be nothing at all: all zeros.",
            ko="둘째 이동을 a_pose_b의 yaw로 돌려 첫째 이동에 더하고, yaw는 서로 더합니다. "
            "그러면 compose(p, invert(p))는 모두 0이어야 합니다.",
        ),
    ),
    misconceptions=("M1", "M3"),
)
