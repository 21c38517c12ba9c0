"""E2.4: A customs officer for quaternions."""

from __future__ import annotations

import math
from itertools import combinations

from tflab.core import Transform
from tflab.core.quaternions import wxyz_from_xyzw
from tflab.workbook.tasks import Choice, Draws, Task, Text, WrongAnswer, WrongStep

VERDICTS = ("ok", "nan", "zero", "not unit", "w first")
PARTLY = ["".join(some) for size in (1, 2, 3) for some in combinations("xyzw", size)]  # which are asked for NaN


def quaternions(rng: Draws) -> list[tuple[tuple[float, float, float, float]]]:
    """Draw good ones, in every dress that a good one may wear, and one of each bad kind."""

    def yawed(low: float, high: float) -> tuple[float, float, float, float]:
        return Transform.from_rpy(yaw=float(rng.uniform(low, high))).rotation

    good, negative, rough = yawed(0.4, 1.4), yawed(-2.4, -0.6), yawed(1.6, 2.6)
    length, share = float(rng.uniform(1.5, 3.0)), round(float(rng.uniform(0.35, 0.65)), 2)
    drawn = [
        (0.0, 0.0, 0.0, 1.0),
        good,
        tuple(-part for part in negative),
        (0.0, 0.0, 1.0, 0.0),
        (0.0, 0.0, -math.sqrt(0.5), math.sqrt(0.5)),
        tuple(1.008 * part for part in good),
        tuple(math.floor(1000.0 * part) / 1000.0 for part in rough),
        (0.0, 0.0, 0.0, 0.0),
        (0.0, 0.0, math.nan, 1.0),
        (math.inf, 0.0, 0.0, 1.0),
        (0.0, math.nan, 0.0, 1.0),
        (0.0, 0.0, 0.0, math.nan),
        (math.nan, 0.0, 0.0, 1.0),
        tuple(length * part for part in good),
        (0.0, 0.0, share, round(1.0 - share, 2)),
        wxyz_from_xyzw(yawed(0.3, 1.2)),
        tuple(-part for part in wxyz_from_xyzw(yawed(0.3, 1.2))),
        tuple(length * part for part in wxyz_from_xyzw(yawed(0.3, 1.2))),
        Transform.from_rpy(pitch=float(rng.uniform(0.4, 1.2))).rotation,
        Transform.from_rpy(pitch=-float(rng.uniform(0.4, 1.2))).rotation,
        Transform.from_rpy(pitch=float(rng.uniform(1.9, 2.4))).rotation,
        *(
            (0.0, 0.0, 0.0, w) for w in (1.0005, 1.003, 1.004995, 1.009995, 1.010005, 0.990005, 0.989995)
        ),  # a hair beside the tolerance
        *((0.0, 0.0, 0.0, w) for w in (9.995e-7, 1.0005e-6, 5e-3)),  # a hair beside zero
        *((x, 0.0, math.sqrt(1.0 - x * x), 0.0) for x in (0.1, 0.09995, 0.10005)),  # at the bound, and beside it
        (0.0, 0.10005, 0.0, math.sqrt(1.0 - 0.10005**2)),
        (0.08, 0.08, 0.0, math.sqrt(1.0 - 2 * 0.08**2)),  # each below the bound, their sum not
        (-0.4, 0.0, 0.0, math.sqrt(1.0 - 0.4**2)),  # negative, beside a w that is not
        (0.3, -0.3, 0.0, math.sqrt(1.0 - 2 * 0.3**2)),  # each above it, their sum not
        (0.0, 0.08, 0.0, math.sqrt(1.0 - 0.08**2)),  # y alone is not 0
        (0.05, 0.3, math.sqrt(1.0 - 0.05**2 - 0.3**2), 0.0),  # the first is not 0, and below it
        (0.06, -0.07, 0.6, math.sqrt(1.0 - 0.06**2 - 0.07**2 - 0.6**2)),  # none of the four is 0
        (0.06, 0.06, math.sqrt(1.0 - 2 * 0.06**2), 0.0),  # nor is their length
        (8e-7, 8e-7, 8e-7, 8e-7),  # each next to nothing, their length not
        (math.nan, math.nan, math.nan, math.nan),
        (0.9, 0.0, math.nan, 0.0),  # not finite, and tipped
    ]
    return [(q,) for q in drawn]


def judged(q: tuple, *, finite="all", zero="length", below=1e-6, length="root", tolerance=0.01, sides="both",
           looks="xy", size="abs", above=0.1, w="any sign", first="length") -> str:  # fmt: skip
    """Judge a quaternion as the task asks, step by step; other steps are the slips."""
    finites = {
        "all": math.isfinite,
        "infinity": lambda part: not math.isinf(part),
        "nan": lambda part: not math.isnan(part),
        "not asked": lambda part: True,
        "any": math.isfinite,
        "last": lambda part: True,
        **dict.fromkeys(PARTLY, math.isfinite),
    }
    letters = finite if finite in PARTLY else "xyzw"
    asked = [finites[finite](part) for letter, part in zip("xyzw", q, strict=True) if letter in letters]
    if first == "of all" and max(map(abs, q[:2])) > above:
        return "w first"
    if not (any(asked) if finite == "any" else all(asked)):
        return "nan"
    if length == "of the scaled" and math.hypot(*q) >= below:
        q = tuple(part / math.hypot(*q) for part in q)
    x, y = (q[0] if "x" in looks else 0.0), (q[1] if "y" in looks else 0.0)
    sizes = {"never": 0.0, "abs": max(abs(x), abs(y)), "signed": max(x, y), "sum": abs(x) + abs(y), "of the sum": abs(x + y),
             "length": math.hypot(x, y), "both": min(abs(q[0]), abs(q[1])), "z, too": max(map(abs, q[:3])),
             "x signed": max(x, abs(y)), "y signed": max(abs(x), y), "signed sum": x + y,
             "x or z": max(abs(x), abs(q[2])), "first that is not 0": abs(x or y), "squares": max(x * x, y * y),
             "sum of squares": x * x + y * y, "x and y": abs(x and y), "z": abs(q[2]), "w large": abs(q[3])}  # fmt: skip
    beside = {"w": abs(q[3]) < above, "w over z": abs(q[3]) > abs(q[2]), "x over w": abs(q[0]) > abs(q[3]),
              "x over z": abs(q[0]) > abs(q[2]),
              "at the bound": max(abs(x), abs(y)) >= above, "turned round": min(abs(x), abs(y)) < above,
              "w over z, signed": q[3] > q[2], "x over w, signed": q[0] > q[3],
              "x or y over w": max(abs(q[0]), abs(q[1])) > abs(q[3]),
              "turned by w": max(-x, -y) > above if q[3] < 0.0 else max(x, y) > above,
              "w near one": abs(q[3]) > 0.9, "z small": abs(q[2]) < above,
              "just one": (abs(q[0]) > above) != (abs(q[1]) > above), "both small": max(abs(x), abs(y)) < above,
              "any x, signed y": q[0] != 0.0 or q[1] > above,
              "any x": q[0] != 0.0 or abs(q[1]) > above, "any y": abs(q[0]) > above or q[1] != 0.0,
              "read w first": max(abs(q[1]), abs(q[2])) > above}  # fmt: skip
    is_tipped = (beside[size] if size in beside else sizes[size] > above) or (w == "positive" and q[3] < 0.0)
    if first == "w" and is_tipped:
        return "w first"
    without = {letter: [*q[:place], *q[place + 1 :]] for place, letter in enumerate("xyzw")}
    is_zero = {
        "w": q[3] == 0.0,
        "sum": abs(sum(q)) < below,
        "signed sum": sum(q) < below,
        "length": math.hypot(*q) < below,
        "square": math.hypot(*q) ** 2 < below,
        **{f"without {letter}": math.hypot(*row) < below for letter, row in without.items()},
        "each": max(map(abs, q)) < below,
        "not asked": False,
        "any": 0.0 in q,
        "any small": min(map(abs, q)) < below,
        "no vector": not any(q[:3]),
    }
    if is_zero[zero] or (zero == "w" and is_zero["length"]):
        return "zero"
    lengths = {
        **{f"without {letter}": math.hypot(*row) for letter, row in without.items()},
        "root": math.hypot(*q),
        "of the scaled": math.hypot(*q),
        "square": math.hypot(*q) ** 2,
        "sum": sum(map(abs, q)),
        "signed sum": sum(q),
        "largest": max(map(abs, q)),
    }
    off = lengths[length] - 1.0
    window = {"above": off, "below": -off, "none above": math.inf if off > 1e-9 else -off,
              "none below": math.inf if off < -1e-9 else off,
              "a share": abs(off) / max(1.0, lengths[length])}  # fmt: skip
    if window.get(sides, abs(off)) > tolerance:
        return "w first" if first == "last of all" and is_tipped else "not unit"
    if first == "last of all":
        return "ok"
    if is_tipped:
        return "w first"
    return "nan" if finite == "last" and not all(map(math.isfinite, q)) else "ok"


NAN_SLIPS_THROUGH = WrongStep(
    "nan slips through",
    {"finite": "not asked"},
    Text(
        en="NaN slips through: math.sqrt and math.hypot raise nothing, every comparison with NaN is False, and `in` finds it by luck alone. Ask for it first, with math.isfinite, called with each part.",
        ko="NaN이 빠져나갔습니다. math.sqrt나 math.hypot은 예외를 내지 않고, NaN과의 비교는 모두 False이며, `in`으로는 운이 좋아야 찾습니다. 성분마다 math.isfinite를 호출해 맨 먼저 확인하십시오.",
    ),
    misconception="M5",
)


INFINITY_SLIPS_THROUGH = WrongStep(
    "infinity slips through",
    {"finite": "nan"},
    Text(
        en="Infinity slips through: you ask for NaN alone, or ask only after the length, and infinity is never of length one. Ask math.isfinite of each of the four numbers, before anything else; it finds both.",
        ko="무한대가 빠져나갔습니다. NaN만 확인했거나, 길이를 본 다음에야 확인했습니다. 무한대의 길이는 1이 될 수 없습니다. math.isfinite로 숫자 네 개를 맨 먼저 모두 확인하십시오. 둘 다 찾아냅니다.",
    ),
    misconception="M5",
)


SCALED_FIRST = WrongStep(
    "scaled first",
    {"length": "of the scaled"},
    Text(
        en="You scale the numbers before you measure their length; after that it is one, whatever came. Measure what came.",
        ko="길이를 재기 전에 크기부터 맞춥니다. 그러면 무엇이 들어왔든 길이는 1입니다. 들어온 그대로 재십시오.",
    ),
)


ZERO_IF_W_IS_ZERO = WrongStep(
    "zero if w is zero",
    {"zero": "w"},
    Text(
        en="You call (0, 0, 1, 0) zero. It is half a turn: w is 0, the length is 1. Look at all four numbers.",
        ko="(0, 0, 1, 0)을 zero라고 했습니다. 이것은 반 바퀴 회전입니다. w는 0이지만 길이는 1입니다. 숫자 네 개를 모두 보십시오.",
    ),
    misconception="M5",
)


EXACTLY_ONE = WrongStep(
    "exactly one",
    {"tolerance": 0.0},
    Text(
        en="A quaternion that was rounded to three decimals is still a good one. Compare its length with a tolerance.",
        ko="소수 셋째 자리까지 반올림한 쿼터니언도 올바른 쿼터니언입니다. 길이는 허용 오차를 두고 비교하십시오.",
    ),
)


TOO_STRICT = WrongStep(
    "too strict",
    {"tolerance": 1e-6},
    Text(
        en="Your tolerance is finer than the task's: a quaternion that was cut to three decimals has a length of 0.999, and is still a good one.",
        ko="허용 오차가 문제에서 정한 것보다 엄격합니다. 소수 셋째 자리까지만 적은 쿼터니언은 길이가 0.999쯤 되지만 여전히 올바릅니다.",
    ),
)


SUM_FOR_LENGTH = WrongStep(
    "sum for length",
    {"length": "sum"},
    Text(
        en="That is the sum of the sizes of the four numbers, not their length. The length is the root of the sum of squares: math.hypot.",
        ko="그것은 숫자 네 개의 크기를 더한 합이지 길이가 아닙니다. 길이는 제곱의 합의 제곱근입니다. math.hypot을 쓰십시오.",
    ),
)


MINUS_Q_REFUSED = WrongStep(
    "minus q refused",
    {"w": "positive"},
    Text(
        en="You refuse a quaternion because its w is negative. q and -q are the same rotation; both are good.",
        ko="w가 음수라는 이유로 거절했습니다. q와 -q는 같은 회전이며 둘 다 올바릅니다.",
    ),
    misconception="M5",
)


ZERO_IS_ONLY_NOT_UNIT = WrongStep(
    "zero is only not unit",
    {"zero": "not asked"},
    Text(
        en="All zeros is worse than not unit: the others can be scaled to length one, this one cannot. Give it its own verdict, before the length.",
        ko="모두 0인 것은 not unit보다 나쁩니다. 다른 것은 길이를 1로 맞출 수 있지만 이것은 그럴 수 없습니다. 길이를 보기 전에 따로 판정하십시오.",
    ),
    misconception="M5",
)


W_FIRST_BEFORE_LENGTH = WrongStep(
    "w first before length",
    {"first": "w"},
    Text(
        en="A quaternion can have two faults at once, and the task says which to name: you ask about x and y before you ask about the length.",
        ko="한 쿼터니언에 결함이 둘일 수도 있고, 무엇을 먼저 말할지는 문제에 적혀 있습니다. 길이를 보기 전에 x와 y부터 보았습니다.",
    ),
)


SUM_EVERYWHERE = WrongStep(
    "sum everywhere",
    {"zero": "sum", "length": "sum"},
    Text(
        en="You took the sum of the four numbers for their length, once for zero and once for one. The length is the root of the sum of squares: math.hypot.",
        ko="숫자 네 개의 합을 길이로 보았습니다. zero인지 볼 때도, 길이가 1인지 볼 때도 그랬습니다. 길이는 제곱의 합의 제곱근입니다. math.hypot을 쓰십시오.",
    ),
    misconception="M5",
)


ZERO_BY_SUM = WrongStep(
    "zero by sum",
    {"zero": "sum"},
    Text(
        en="You add the four numbers, and a quarter turn to the right adds up to zero. The length is the root of the sum of squares: math.hypot.",
        ko="숫자 네 개를 그냥 더했습니다. 오른쪽으로 4분의 1바퀴 도는 회전은 더하면 0이 됩니다. 길이는 제곱의 합의 제곱근입니다. math.hypot을 쓰십시오.",
    ),
    misconception="M5",
)


SQUARE_FOR_LENGTH = WrongStep(
    "square for length",
    {"length": "square"},
    Text(
        en="That is the square of the length, and it strays from 1 twice as fast as the length does. Take the root: math.sqrt, or math.hypot at once.",
        ko="그것은 길이의 제곱이어서 길이보다 두 배 빨리 1에서 벗어납니다. math.sqrt로 제곱근을 구하거나 처음부터 math.hypot을 쓰십시오.",
    ),
)


SMALL_W = WrongStep(
    "small w",
    {"size": "w"},
    Text(
        en="You look whether w is small. It is in every half turn, and those are good; look at the size of x and of y, "
        "which a robot on a floor does not need.",
        ko="w가 작은지를 보았습니다. 반 바퀴 회전은 모두 그렇지만 올바릅니다. 바닥 위의 로봇이 쓰지 않는 x와 y의 크기를 "
        "보십시오.",
    ),
)

NEGATIVE_X_OR_Y_PASSES = WrongStep(
    "negative x or y passes",
    {"size": "signed"},
    Text(
        en="You look only for a large positive x or y. q and -q are the same rotation, so a w that came first may also be -0.9: compare abs().",
        ko="x나 y가 양수로 큰 경우만 보았습니다. q와 -q는 같은 회전이므로 맨 앞에 온 w가 -0.9일 수도 있습니다. abs()로 비교하십시오.",
    ),
    misconception="M5",
)


ONLY_X = WrongStep(
    "only x",
    {"looks": "x"},
    Text(
        en="You look at x alone. (Does a loop return in its first round?) The task says x or y: a large y would tip the robot over just the same.",
        ko="x만 보았습니다. (반복문이 첫 바퀴에서 반환하지 않습니까?) 문제에는 x나 y라고 적혀 있습니다. y가 커도 로봇은 똑같이 넘어집니다.",
    ),
)


TOO_SHORT_PASSES = WrongStep(
    "too short passes",
    {"sides": "above"},
    Text(
        en="You refuse a length above 1, but not one below. It differs to both sides: compare abs(length - 1).",
        ko="길이가 1보다 큰 것만 걸러 냈고 1보다 작은 것은 통과시켰습니다. 양쪽으로 모두 벗어날 수 있으니 abs(length - 1)을 비교하십시오.",
    ),
)


ONLY_Y = WrongStep(
    "only y",
    {"looks": "y"},
    Text(
        en="You look at y alone. The task says x or y, and a w that was written first lands in x.",
        ko="y만 보았습니다. 문제에는 x나 y라고 적혀 있습니다. 맨 앞에 쓴 w는 x 자리에 옵니다.",
    ),
)

NEVER_NOT_UNIT = WrongStep(
    "never not unit",
    {"tolerance": math.inf},
    Text(
        en='You never say "not unit" of a length that is not zero: the question about the length is missing or never reached, its bound is far too wide, or it asks for a length above and below at once.',
        ko='길이가 0이 아니면 "not unit"이라고 하는 일이 없습니다. 길이를 묻지 않았거나, 거기까지 가지 못하거나, 기준이 지나치게 넓거나, 크면서 동시에 작아야 한다고 물었습니다.',
    ),
)

WITHIN_A_HALF = WrongStep(
    "tolerance 0.5",
    {"tolerance": 0.5},
    Text(
        en="Your tolerance for the length is about a half, as by round(length): the task allows 0.01.",
        ko="길이의 허용 오차가 0.5쯤 됩니다. round(길이)가 그렇습니다. 문제에서는 0.01까지만 허용합니다.",
    ),
)

LOOSE = WrongStep(
    "tolerance 0.1",
    {"tolerance": 0.1},
    Text(
        en="Your tolerance for the length is wider than the task's: a length just beyond 1.01 passes, and it should not.",
        ko="길이의 허용 오차가 문제에서 정한 것보다 넓습니다. 1.01을 갓 넘은 길이가 통과하는데, 통과하면 안 됩니다.",
    ),
)

FINE = WrongStep(
    "tolerance 0.001",
    {"tolerance": 0.001},
    Text(
        en="Your tolerance for the length is narrower than the task's: a length of 1.005 is refused, and it should not be.",
        ko="길이의 허용 오차가 문제에서 정한 것보다 좁습니다. 길이 1.005를 거절하는데, 통과시켜야 합니다.",
    ),
)

ZERO_SOON = WrongStep(
    "zero below 0.01",
    {"below": 0.01},
    Text(
        en='You call short quaternions zero too soon: a length of 0.005 is "not unit", it can still be scaled.',
        ko='짧은 쿼터니언을 너무 일찍 zero라고 합니다. 길이 0.005는 "not unit"입니다. 아직 길이를 맞출 수 있습니다.',
    ),
)

ZERO_EXACTLY = WrongStep(
    "exactly zero",
    {"below": 5e-324},
    Text(
        en="Your bound for zero is lower than the task's, or 0 itself: a length just below 0.000001 is not zero for you. The task draws the line there: what is shorter cannot be scaled.",
        ko="zero의 기준이 문제보다 낮거나 0 자체입니다. 0.000001보다 조금 짧은 길이를 zero라고 하지 않습니다. 문제의 기준은 0.000001이고, 그보다 짧으면 길이를 맞출 수 없습니다.",
    ),
)

ANY_X = WrongStep(
    "any x or y",
    {"above": 0.0},
    Text(
        en="Your bound for x and y is lower than the task's, or there is none: a small x or y is taken for a w that came first. Small ones are noise: the task draws the line at 0.1.",
        ko="x와 y의 기준이 문제보다 낮거나 없습니다. 작은 x나 y까지 w를 먼저 쓴 것으로 보았습니다. 작은 값은 잡음입니다. 문제의 기준은 0.1입니다.",
    ),
)

ZERO_BY_SQUARE = WrongStep(
    "zero by square",
    {"zero": "square"},
    Text(
        en="A length of 0.0005 is zero for you, as it is where the square of the length is compared with 0.000001 (or the length with 0.001). Take the root first, and compare with the task's bound.",
        ko="길이 0.0005도 zero가 됩니다. 길이의 제곱을 0.000001과 비교하거나 길이를 0.001과 비교하면 그렇습니다. 먼저 제곱근을 구하고 문제의 기준과 비교하십시오.",
    ),
    "M5",
)

WITHOUT_W = WrongStep(
    "length without w",
    {"length": "without w", "zero": "without w"},
    Text(
        en="The length is made of x, y and z alone. w is one of the four: no turn at all is (0, 0, 0, 1), and its length is 1.",
        ko="x, y, z만으로 길이를 구했습니다. w도 넷 중 하나입니다. 회전 없음은 (0, 0, 0, 1)이고 길이는 1입니다.",
    ),
    "M5",
)


SUM_OF_X_AND_Y = WrongStep(
    "sum of x and y",
    {"size": "sum"},
    Text(
        en="You add the sizes of x and y. The task looks at each by itself: is one of them larger than 0.1?",
        ko="x와 y의 크기를 더합니다. 하나씩 보아야 합니다. 둘 가운데 하나가 0.1보다 큽니까?",
    ),
)


SIZE_OF_THE_SUM = WrongStep(
    "size of the sum",
    {"size": "of the sum"},
    Text(
        en="You add x and y first, and the one can hide the other: 0.3 and -0.3 make 0. Look at the size of each.",
        ko="x와 y를 먼저 더하므로 서로 상쇄됩니다. 0.3과 -0.3은 0이 됩니다. 각각의 크기를 보십시오.",
    ),
)


LENGTH_OF_X_AND_Y = WrongStep(
    "length of x and y",
    {"size": "length"},
    Text(
        en="You take the length of (x, y). The task looks at each of the two by itself.",
        ko="(x, y)의 길이를 봅니다. 둘을 하나씩 보아야 합니다.",
    ),
)


X_AND_Y_BOTH = WrongStep(
    "x and y both",
    {"size": "both"},
    Text(
        en="You want x *and* y to be large. One of them is enough.",
        ko="x와 y가 *둘 다* 커야 한다고 봅니다. 하나만 커도 됩니다.",
    ),
)


Z_TOO = WrongStep(
    "z too",
    {"size": "z, too"},
    Text(
        en="You look at z as well. On a flat floor a turn is about z: z may be as large as it likes.",
        ko="z도 봅니다. 평평한 바닥에서는 z 둘레로 돌기 때문에 z는 얼마든지 커도 됩니다.",
    ),
)


EACH_NEXT_TO_NOTHING = WrongStep(
    "each next to nothing",
    {"zero": "each"},
    Text(
        en="You ask whether each number is next to nothing. The task asks for the length: four small ones make a longer one.",
        ko="숫자 하나하나가 0에 가까운지 봅니다. 길이를 보아야 합니다. 작은 숫자도 네 개가 모이면 더 길어집니다.",
    ),
)


W_OVER_Z = WrongStep(
    "w over z",
    {"size": "w over z"},
    Text(
        en="You ask whether w is larger than z in size. It is in every turn by less than a quarter circle, and in no turn at all: ask whether x or y is large.",
        ko="w의 크기가 z보다 큰지 물었습니다. 90°보다 작게 돌거나 돌지 않으면 늘 그렇습니다. x나 y가 큰지 물으십시오.",
    ),
)


X_OVER_W = WrongStep(
    "x over w",
    {"size": "x over w"},
    Text(
        en="You ask whether x is larger than w in size. A w that came first may be small, and then z stands last; y may be large as well: the task asks whether x or y is larger than 0.1.",
        ko="x의 크기가 w보다 큰지 물었습니다. 앞에 온 w가 작을 수도 있고 y가 클 수도 있습니다. 과제는 x나 y가 0.1보다 큰지 묻습니다.",
    ),
)


NEVER_W_FIRST = WrongStep(
    "never w first",
    {"size": "never"},
    Text(
        en='You say "w first" to none of these. The question about x and y is missing or never reached, its bound is too high, or it asks for both to be large, on one side of zero: one of them is enough, to either side, so compare the abs() of each and join with `or`.',
        ko='어느 것에도 "w first"라고 하지 않습니다. x와 y를 묻지 않았거나, 거기까지 가지 못하거나, 기준이 너무 높거나, 둘 다 한쪽으로 커야 한다고 물었습니다. 어느 쪽으로든 하나만 커도 됩니다. 각각 abs()로 비교하고 `or`로 이으십시오.',
    ),
    "M5",
)


HALF_A_UNIT = WrongStep(
    "bound of 0.5",
    {"above": 0.5},
    Text(
        en="Your bound for x and y is higher than the task's: 0.3 passes, and it tips the robot over.",
        ko="x와 y의 한계가 과제보다 높습니다. 0.3이 통과하는데, 그래도 로봇이 기울어집니다.",
    ),
)


NAN_COMPARED = WrongStep(
    "nan compared",
    {"finite": "infinity"},
    Text(
        en="NaN gets through. Any of the four may be NaN, and NaN equals nothing, not even itself, so `==` never finds it: ask math.isfinite of each part.",
        ko="NaN이 지나갑니다. 네 성분 가운데 어느 것이나 NaN일 수 있고, NaN은 자기 자신과도 같지 않아 `==`로는 찾을 수 없습니다. 성분마다 math.isfinite로 확인하십시오.",
    ),
    "M5",
)


SQUARE_EVERYWHERE = WrongStep(
    "square everywhere",
    {"zero": "square", "length": "square"},
    Text(
        en="You take the square of the length for the length, once for zero and once for one: it strays from 1 twice as fast, and calls a length of 0.0005 zero. The root is missing: math.sqrt, or math.hypot at once.",
        ko="길이의 제곱을 길이로 썼습니다. zero인지 볼 때도, 길이가 1인지 볼 때도 그랬습니다. 제곱은 1에서 두 배 빨리 벗어나고, 길이 0.0005도 zero로 만듭니다. 제곱근이 빠졌습니다. math.sqrt를 쓰거나 처음부터 math.hypot을 쓰십시오.",
    ),
)


SIGNED_SUM = WrongStep(
    "signed sum",
    {"zero": "signed sum", "length": "signed sum"},
    Text(
        en="You added the four numbers, signs and all, and took the sum for the length. The length is the root of the sum of squares: math.hypot.",
        ko="숫자 네 개를 부호까지 그대로 더해 길이로 썼습니다. 길이는 제곱의 합의 제곱근입니다. math.hypot을 쓰십시오.",
    ),
    "M5",
)


W_OVER_Z_WITH_SIGNS = WrongStep(
    "w over z, signs and all",
    {"size": "w over z, signed"},
    Text(
        en="You ask whether w is larger than z, signs and all. So it is in every small turn, and in none where both are negative: ask whether x or y is large in size.",
        ko="w가 z보다 큰지 부호까지 넣어 물었습니다. 조금만 돌아도 그렇고, 부호가 바뀌면 달라집니다. x나 y의 크기가 큰지 물으십시오.",
    ),
)


X_OVER_W_WITH_SIGNS = WrongStep(
    "x over w, signs and all",
    {"size": "x over w, signed"},
    Text(
        en="You ask whether x is larger than w, signs and all. A good turn may have a negative w (q and -q are the same), and a w that came first may be negative as well: the task asks whether x or y is larger than 0.1 in size.",
        ko="x가 w보다 큰지 부호까지 넣어 물었습니다. 올바른 회전에서도 w가 음수일 수 있고(q와 -q는 같습니다), 맨 앞에 온 w도 음수일 수 있습니다. 과제는 x나 y의 크기가 0.1보다 큰지 묻습니다.",
    ),
    "M5",
)


X_OR_Y_OVER_W = WrongStep(
    "x or y over w",
    {"size": "x or y over w"},
    Text(
        en="You compare x and y with w. In half a turn w is next to nothing, and a tipped robot may have a large one: the task compares them with 0.1.",
        ko="x와 y를 w와 비교했습니다. 반 바퀴에서는 w가 거의 0이고, 기울어진 로봇의 w는 클 수도 있습니다. 과제에서는 0.1과 비교합니다.",
    ),
)


FIVE_THOUSANDTHS = WrongStep(
    "tolerance 0.005",
    {"tolerance": 0.005},
    Text(
        en="Your tolerance for the length is narrower than the task's: a length of 1.008 is refused, and it should not be. To round the length to two digits allows half of 0.01 alone.",
        ko="길이의 허용 오차가 문제에서 정한 것보다 좁습니다. 길이 1.008을 거절하는데, 통과시켜야 합니다. 길이를 소수 둘째 자리로 반올림하면 0.01의 절반만 허용하게 됩니다.",
    ),
)


def the_last_that_fits(q: tuple) -> str:
    """Judge a quaternion by every question of the task, and keep the last verdict."""
    length = math.hypot(*q)
    verdicts = {
        "nan": not all(map(math.isfinite, q)),
        "zero": length < 1e-6,
        "not unit": abs(length - 1.0) > 0.01,
        "w first": max(abs(q[0]), abs(q[1])) > 0.1,
    }
    return [verdict for verdict, fits in {"ok": True, **verdicts}.items() if fits][-1]


def judged_by(name: str, steps: dict[str, str], en: str, ko: str) -> WrongAnswer:
    """Return a judge that stands alone: he composes with no other slip."""
    return WrongAnswer(name, lambda q: judged(q, **steps), Text(en=en, ko=ko))


ALONE = (
    WrongAnswer(
        "the last that fits",
        the_last_that_fits,
        Text(
            en="Where several verdicts fit, you name the last one, and the first is asked for. Return each where it is "
            "found, or ask on with elif.",
            ko="판정이 여럿 맞을 때 마지막 것을 답합니다. 처음 맞는 것을 답해야 합니다. 찾는 즉시 return 하거나 elif로 "
            "이으십시오.",
        ),
    ),
    judged_by(
        "none finite",
        {"finite": "any"},
        'You say "nan" only where none of the four is finite: any and all are exchanged. One that is not finite is enough: '
        "not all of them are.",
        '숫자 네 개가 모두 유한하지 않을 때만 "nan"이라고 합니다. any와 all이 바뀌었습니다. 하나만 유한하지 않아도 됩니다.',
    ),
    judged_by(
        "finite asked last",
        {"finite": "last"},
        "You ask last whether the four are finite. By then infinity has been called not unit, and NaN beside a large x or y "
        "w first. The task asks it first.",
        "유한한지를 맨 나중에 확인합니다. 그 전에 무한대는 not unit이 되고, 큰 x나 y와 함께 온 NaN은 w first가 됩니다. "
        "문제에서는 이것을 맨 먼저 봅니다.",
    ),
    judged_by(
        "read w first",
        {"size": "read w first"},
        "You look at the second and third of the four numbers, as if they were (w, x, y, z). q is (x, y, z, w): x and y are "
        "the first two.",
        "숫자 네 개를 (w, x, y, z)로 읽은 것처럼 둘째와 셋째 숫자를 봅니다. q는 (x, y, z, w)이므로 x와 y는 처음 둘입니다.",
    ),
    *(
        judged_by(
            f"asked of {letters}",
            {"finite": letters},
            f"Of {' and '.join(letters)} alone you ask whether {'it is' if len(letters) == 1 else 'they are'} finite: a NaN in "
            "another of the four slips through.",
            f"{', '.join(letters)}만 유한한지 확인합니다. 숫자 네 개 가운데 다른 것이 NaN이면 빠져나갑니다.",
        )
        for letters in PARTLY
    ),
    judged_by(
        "too long passes",
        {"sides": "below"},
        "You refuse a length below 1, but not one above. It differs to both sides: compare abs(length - 1).",
        "길이가 1보다 짧으면 거절하지만 길면 통과시킵니다. 차이는 양쪽으로 납니다. abs(길이 - 1)을 비교하십시오.",
    ),
    judged_by(
        "none above one",
        {"sides": "none above"},
        "You refuse every length above 1, and below it as the task does. It may differ by 0.01 to both sides.",
        "1보다 긴 것은 모두 거절하고 짧은 쪽만 문제대로 봅니다. 양쪽으로 0.01까지 달라도 됩니다.",
    ),
    judged_by(
        "none below one",
        {"sides": "none below"},
        "You refuse every length below 1, and above it as the task does. It may differ by 0.01 to both sides.",
        "1보다 짧은 것은 모두 거절하고 긴 쪽만 문제대로 봅니다. 양쪽으로 0.01까지 달라도 됩니다.",
    ),
    judged_by(
        "the first that is not zero",
        {"size": "first that is not 0"},
        "You look at y only where x is 0, as `x or y` does in Python. The task asks each: abs(x) > 0.1 or abs(y) > 0.1.",
        "x가 0일 때만 y를 봅니다. 파이썬의 `x or y`가 그렇게 합니다. 하나씩 물으십시오. abs(x) > 0.1 or abs(y) > 0.1.",
    ),
    *(
        judged_by(
            f"any {one}",
            {"size": f"any {one}"},
            f"Any {one} that is not 0 is too large for you, and of {other} you ask whether it is above 0.1. In `abs(x) or abs(y) > "
            "0.1` only the last is compared: ask each, abs(x) > 0.1 or abs(y) > 0.1.",
            f"{one}는 0만 아니면 크다고 보고, {other}만 0.1과 비교합니다. `abs(x) or abs(y) > 0.1`에서는 마지막 것만 "
            "비교합니다. 하나씩 물으십시오. abs(x) > 0.1 or abs(y) > 0.1.",
        )
        for one, other in ("xy", "yx")
    ),
    judged_by(
        "squares over the bound",
        {"size": "squares"},
        "You compare the square of x, or of y, with 0.1. The task compares its size.",
        "x나 y의 제곱을 0.1과 비교합니다. 문제에서는 크기를 비교합니다.",
    ),
    judged_by(
        "sum of squares over the bound",
        {"size": "sum of squares"},
        "You compare x² + y² with 0.1. The task compares the size of each by itself.",
        "x² + y²를 0.1과 비교합니다. 문제에서는 하나씩 그 크기를 비교합니다.",
    ),
    judged_by(
        "at the bound",
        {"size": "at the bound"},
        "A size of exactly 0.1 is not larger than 0.1: that is > and not >=.",
        "크기가 정확히 0.1이면 0.1보다 큰 것이 아닙니다. >=가 아니라 >입니다.",
    ),
    judged_by(
        "turned round",
        {"size": "turned round"},
        'You say "w first" where x or y is small. It is the other way round: one of them is large.',
        'x나 y가 작을 때 "w first"라고 합니다. 반대입니다. 둘 가운데 하나가 클 때입니다.',
    ),
    judged_by(
        "largest for the length",
        {"length": "largest", "zero": "each"},
        "You took the largest of the four numbers for the length. The length is the root of the sum of squares: "
        "math.hypot.",
        "숫자 네 개 가운데 가장 큰 것을 길이로 썼습니다. 길이는 제곱을 더해 제곱근을 구한 것입니다. math.hypot을 쓰십시오.",
    ),
    judged_by(
        "zero if one is zero",
        {"zero": "any"},
        "You call it zero if one of the four is 0: then nearly every good one is. All four together are short: look at the "
        "length.",
        "숫자 네 개 가운데 하나만 0이어도 zero라고 합니다. 그러면 올바른 것도 거의 모두 걸립니다. 넷 전체의 길이를 보십시오.",
    ),
    judged_by(
        "zero if one is small",
        {"zero": "any small"},
        "You call it zero if one of the four is next to 0: then nearly every good one is. All four together are short: look "
        "at the length.",
        "숫자 네 개 가운데 하나만 0에 가까워도 zero라고 합니다. 그러면 올바른 것도 거의 모두 걸립니다. 넷 전체의 길이를 보십시오.",
    ),
    judged_by(
        "w first before all",
        {"first": "of all"},
        "You ask about x and y before anything else: what is not finite, or not of length one, is called w first. The task "
        "says in which order to ask.",
        "x와 y부터 묻습니다. 그래서 유한하지 않거나 길이가 1이 아닌 것도 w first가 됩니다. 묻는 순서는 문제에 적혀 있습니다.",
    ),
    *(
        judged_by(
            f"length without {letter}",
            {"length": f"without {letter}", "zero": f"without {letter}"},
            f"The length is made of three of the four numbers: {letter} is not in it.",
            f"숫자 네 개 가운데 세 개만으로 길이를 구했습니다. {letter}가 빠졌습니다.",
        )
        for letter in "xyz"
    ),
    judged_by(
        "nan and zero alone",
        {"tolerance": math.inf, "size": "never"},
        'Apart from "nan" and "zero" you only say "ok": the questions about the length and about x and y are missing, or '
        "answered by no each time.",
        '"nan"과 "zero" 말고는 언제나 "ok"라고 합니다. 길이와, x와 y에 관한 물음이 없거나 언제나 아니라는 답이 나옵니다.',
    ),
    judged_by(
        "nan alone",
        {"zero": "not asked", "tolerance": math.inf, "size": "never"},
        'Apart from "nan" you only say "ok": the other three questions are missing, or answered by no each time.',
        '"nan" 말고는 언제나 "ok"라고 합니다. 나머지 세 물음이 없거나 언제나 아니라는 답이 나옵니다.',
    ),
    judged_by(
        "ok before w first",
        {"first": "last of all"},
        'You say "ok" as soon as the length is right: x and y are asked after that, where it is too late.',
        '길이가 맞으면 바로 "ok"라고 합니다. x와 y는 그 뒤에야 묻게 되어 늦습니다.',
    ),
    judged_by(
        "a share for the tolerance",
        {"sides": "a share"},
        "Above 1 your tolerance is wider than the task's, and below it is not: math.isclose with rel_tol=0.01 takes a share "
        "of the larger number, for one. Compare abs(length - 1) with 0.01.",
        "1보다 길 때만 허용 오차가 문제보다 넓습니다. 예를 들어 rel_tol=0.01인 math.isclose는 둘 중 큰 수의 비율로 봅니다. "
        "abs(길이 - 1)을 0.01과 비교하십시오.",
    ),
    judged_by(
        "the square within 0.02",
        {"length": "square", "tolerance": 0.02},
        "You compare the square of the length with 1, and 0.02 is nearly the same bound and not quite. Take the root: "
        "math.sqrt, or math.hypot at once.",
        "길이의 제곱을 1과 비교합니다. 0.02는 비슷한 기준이지만 똑같지는 않습니다. math.sqrt로 제곱근을 구하거나 처음부터 "
        "math.hypot을 쓰십시오.",
    ),
    judged_by(
        "w large",
        {"size": "w large"},
        "You ask whether w is larger than 0.1. It is in nearly every good turn: look at the size of x and of y.",
        "w가 0.1보다 큰지 묻습니다. 올바른 회전에서도 거의 늘 그렇습니다. x와 y의 크기를 보십시오.",
    ),
    judged_by(
        "w near one",
        {"size": "w near one"},
        "You ask whether w is nearly 1. It is in every small turn, and in no turn at all: look at the size of x and of y.",
        "w가 1에 가까운지 묻습니다. 조금만 돌거나 돌지 않을 때도 그렇습니다. x와 y의 크기를 보십시오.",
    ),
    judged_by(
        "z large",
        {"size": "z"},
        "You look at z alone. A turn on the floor lives in z, so z may be large: the task asks x and y.",
        "z만 봅니다. 바닥에서 도는 회전은 z에 나타나므로 z는 커도 됩니다. 문제에서는 x와 y를 봅니다.",
    ),
    judged_by(
        "z small",
        {"size": "z small"},
        "You ask whether z is small. It is where the robot hardly turns, and that is good: look at the size of x and of y.",
        "z가 작은지 묻습니다. 로봇이 거의 돌지 않으면 그렇고, 그것은 올바릅니다. x와 y의 크기를 보십시오.",
    ),
    judged_by(
        "just one of them",
        {"size": "just one"},
        "You want just one of x and y to be large. Where both are it is w first, too: join with `or`.",
        "x와 y 가운데 하나만 커야 한다고 봅니다. 둘 다 커도 w first입니다. `or`로 이으십시오.",
    ),
    judged_by(
        "both small",
        {"size": "both small"},
        'You say "w first" where x and y are both small. It is the other way round: there it is "ok".',
        'x와 y가 둘 다 작을 때 "w first"라고 합니다. 반대입니다. 그때가 "ok"입니다.',
    ),
    judged_by(
        "x and y in Python",
        {"size": "x and y"},
        "`x and y` is no question in Python but a number: y where x is not 0, and else x. Ask each: abs(x) > 0.1 or "
        "abs(y) > 0.1.",
        "파이썬에서 `x and y`는 물음이 아니라 숫자입니다. x가 0이 아니면 y, 0이면 x입니다. 하나씩 물으십시오. "
        "abs(x) > 0.1 or abs(y) > 0.1.",
    ),
    judged_by(
        "any x, y with its sign",
        {"size": "any x, signed y"},
        "Any x that is not 0 is too large for you, and of y you ask whether it is above 0.1, sign and all, as in "
        "`x or y > 0.1`. Ask the size of each: abs(x) > 0.1 or abs(y) > 0.1.",
        "`x or y > 0.1`처럼 x는 0만 아니면 크다고 보고, y는 부호까지 넣어 0.1과 비교합니다. 하나씩 크기를 물으십시오. "
        "abs(x) > 0.1 or abs(y) > 0.1.",
    ),
    judged_by(
        "zero without a vector",
        {"zero": "no vector"},
        "You call it zero if x, y and z are 0. (0, 0, 0, 1) is no turn at all, and a good quaternion: its length is 1.",
        "x, y, z가 0이면 zero라고 합니다. (0, 0, 0, 1)은 돌지 않는 회전이고 올바른 쿼터니언입니다. 길이가 1입니다.",
    ),
    judged_by(
        "negative x passes",
        {"size": "x signed"},
        "A large negative x passes: of y you ask the size, of x only whether it is above 0.1. Compare the abs() of both.",
        "크지만 음수인 x가 통과합니다. y는 크기를 보는데 x는 0.1보다 큰지만 봅니다. 둘 다 abs()를 비교하십시오.",
    ),
    judged_by(
        "signs turned by w",
        {"size": "turned by w"},
        "A large negative x or y passes beside a w that is not negative: to turn the signs where w is negative takes none "
        "from x and y. Compare the abs() of both.",
        "w가 음수가 아니면 크지만 음수인 x나 y가 통과합니다. w가 음수일 때 부호를 뒤집어도 x와 y의 부호는 없어지지 않습니다. "
        "둘 다 abs()를 비교하십시오.",
    ),
    judged_by(
        "negative y passes",
        {"size": "y signed"},
        "A large negative y passes: of x you ask the size, of y only whether it is above 0.1. Compare the abs() of both.",
        "크지만 음수인 y가 통과합니다. x는 크기를 보는데 y는 0.1보다 큰지만 봅니다. 둘 다 abs()를 비교하십시오.",
    ),
    judged_by(
        "signed sum of x and y",
        {"size": "signed sum"},
        "You add x and y, signs and all, and ask whether the sum is large. The task looks at the size of each by itself.",
        "x와 y를 부호까지 더해 그 합이 큰지 봅니다. 문제에서는 하나씩 그 크기를 봅니다.",
    ),
    judged_by(
        "x or z",
        {"size": "x or z"},
        "You look at x and z. A turn on the floor lives in z, so z may be large: the task asks x and y.",
        "x와 z를 봅니다. 바닥에서 도는 회전은 z에 나타나므로 z는 커도 됩니다. 문제에서는 x와 y를 봅니다.",
    ),
    judged_by(
        "x over z",
        {"size": "x over z"},
        "You ask whether x is larger than z in size. z may be large as well where w came first, and y counts too: is x or "
        "y larger than 0.1?",
        "x의 크기가 z보다 큰지 봅니다. w가 먼저 왔을 때 z도 클 수 있고, y도 봐야 합니다. x나 y가 0.1보다 큽니까?",
    ),
)


TASK = Task(
    id="E2.4",
    kind="F",
    points=4,
    title=Text(en="A customs officer for quaternions", ko="쿼터니언 검문소"),
    answer="judge_quaternion",
    form=Choice(VERDICTS),
    inputs=quaternions,
    variants=3,
    model=judged,
    mistakes=(
        NAN_SLIPS_THROUGH,
        NEVER_NOT_UNIT,
        SCALED_FIRST,
        INFINITY_SLIPS_THROUGH,
        W_FIRST_BEFORE_LENGTH,
        ZERO_BY_SUM,
        SQUARE_FOR_LENGTH,
        NEGATIVE_X_OR_Y_PASSES,
        SMALL_W,
        ONLY_X,
        TOO_SHORT_PASSES,
        ZERO_IF_W_IS_ZERO,
        EXACTLY_ONE,
        TOO_STRICT,
        SUM_FOR_LENGTH,
        SUM_EVERYWHERE,
        MINUS_Q_REFUSED,
        ZERO_IS_ONLY_NOT_UNIT,
        ONLY_Y,
        LOOSE,
        WITHIN_A_HALF,
        FINE,
        ZERO_SOON,
        ZERO_EXACTLY,
        ANY_X,
        ZERO_BY_SQUARE,
        WITHOUT_W,
        SUM_OF_X_AND_Y,
        SIZE_OF_THE_SUM,
        LENGTH_OF_X_AND_Y,
        X_AND_Y_BOTH,
        Z_TOO,
        EACH_NEXT_TO_NOTHING,
        W_OVER_Z,
        X_OVER_W,
        NEVER_W_FIRST,
        HALF_A_UNIT,
        NAN_COMPARED,
        SQUARE_EVERYWHERE,
        SIGNED_SUM,
        W_OVER_Z_WITH_SIGNS,
        X_OVER_W_WITH_SIGNS,
        X_OR_Y_OVER_W,
        FIVE_THOUSANDTHS,
        *ALONE,
    ),
    hints=(
        Text(
            en="Five verdicts, so four questions, in this order: finite? any length at all? length one? only about z?",
            ko="판정이 다섯이니 질문은 넷입니다. 차례로 묻습니다. 유한합니까? 길이가 있기는 합니까? 길이가 1입니까? z축으로만 돕니까?",
        ),
        Text(
            en="math.isfinite for each number, math.hypot(*q) for the length, a tolerance of 0.01 for one.",
            ko="각 숫자에는 math.isfinite, 길이에는 math.hypot(*q), 1과의 비교에는 허용 오차 0.01을 쓰십시오.",
        ),
        Text(
            en="A yaw has x = y = 0. Written w first, its w lands in x: so ask whether abs(x) or abs(y) exceeds 0.1. The sign of w says nothing.",
            ko="yaw만 있으면 x = y = 0입니다. w를 먼저 쓰면 w가 x 자리에 옵니다. 그러니 abs(x)나 abs(y)가 0.1을 넘는지 보십시오. w의 부호로는 아무것도 알 수 없습니다.",
        ),
    ),
    misconceptions=("M5",),
    equivalent={
        "length < 1e-06 -> length <= 1e-06 in: if length < 1e-06:": "math.hypot and math.sqrt differ in the last digit "
        "there, so none stands at the bound; a hair beside it on both sides there is one",
        "abs(length - 1.0) > 0.01 -> abs(length - 1.0) >= 0.01 in: if abs(length - 1.0) > 0.01:": "1.01 - 1.0 is not "
        "0.01 in floating point: none stands at the bound, but a hair beside it",
        "length - 1.0 -> 1.0 - length in: if abs(length - 1.0) > 0.01:": "abs takes both for the same",
    },
)
