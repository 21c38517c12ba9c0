"""E2.4: A customs officer for quaternions."""

from __future__ import annotations

import math

import numpy as np

from tflab.core import Transform
from tflab.core.quaternions import wxyz_from_xyzw
from tflab.workbook.tasks import Choice, Task, Twin, Words

VERDICTS = ("ok", "nan", "zero", "not unit", "w first")


def quaternions(rng: np.random.Generator) -> list[tuple[tuple[float, float, float, float]]]:
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
        tuple(length * part for part in good),
        (0.0, 0.0, share, round(1.0 - share, 2)),
        wxyz_from_xyzw(yawed(0.3, 1.2)),
        tuple(-part for part in wxyz_from_xyzw(yawed(0.3, 1.2))),
        tuple(length * part for part in wxyz_from_xyzw(yawed(0.3, 1.2))),
        Transform.from_rpy(pitch=float(rng.uniform(0.4, 1.2))).rotation,
    ]
    return [(q,) for q in drawn]


def judged(q: tuple, *, nan=True, zero=True, tolerance=0.01, norm=2, last_sign=False, zero_by_w=False) -> str:
    """Judge a quaternion as the task asks; the options are the mistakes."""
    x, y, _, w = q
    if nan and not all(math.isfinite(part) for part in q):
        return "nan"
    length = float(np.linalg.norm(np.array(q, dtype=float), norm))
    if (zero_by_w and w == 0.0) or (zero and length < 1e-6):
        return "zero"
    if abs(length - 1.0) > tolerance:
        return "not unit"
    if abs(x) > 0.1 or abs(y) > 0.1 or (last_sign and w < 0.0):
        return "w first"
    return "ok"


NAN_SLIPS_THROUGH = Twin(
    "nan slips through",
    lambda q: judged(q, nan=False),
    Words(
        en="NaN slips through: every comparison with it is False, so no 'if' catches it. Ask for it first, with math.isfinite.",
        ko="NaN이 빠져나갔습니다. NaN과의 비교는 모두 False여서 어떤 if에도 걸리지 않습니다. math.isfinite로 맨 먼저 확인하십시오.",
    ),
    misconception="M5",
)


INFINITY_SLIPS_THROUGH = Twin(
    "infinity slips through",
    lambda q: judged(q, nan=any(math.isnan(part) for part in q)),
    Words(
        en="You catch NaN, but not infinity, which is no number to compute with either. math.isfinite asks for both at once.",
        ko="NaN은 잡았지만 무한대가 빠져나갔습니다. 무한대로도 계산할 수 없습니다. math.isfinite는 둘을 한꺼번에 확인합니다.",
    ),
    misconception="M5",
)


ZERO_IF_W_IS_ZERO = Twin(
    "zero if w is zero",
    lambda q: judged(q, zero_by_w=True),
    Words(
        en="You call (0, 0, 1, 0) zero. It is half a turn: w is 0, the length is 1. Look at all four numbers.",
        ko="(0, 0, 1, 0)을 zero라고 했습니다. 이것은 반 바퀴 회전입니다. w는 0이지만 길이는 1입니다. 네 숫자를 모두 보십시오.",
    ),
    misconception="M5",
)


EXACTLY_ONE = Twin(
    "exactly one",
    lambda q: judged(q, tolerance=0.0),
    Words(
        en="A quaternion that was rounded to three decimals is still a good one. Compare its length with a tolerance.",
        ko="소수 셋째 자리까지 반올림한 쿼터니언도 올바른 쿼터니언입니다. 길이는 허용 오차를 두고 비교하십시오.",
    ),
)


TOO_STRICT = Twin(
    "too strict",
    lambda q: judged(q, tolerance=1e-6),
    Words(
        en="Your tolerance is finer than the task's: a quaternion that was cut to three decimals has a length of 0.999, and is still a good one.",
        ko="허용 오차가 문제에서 정한 것보다 엄격합니다. 소수 셋째 자리까지만 적은 쿼터니언은 길이가 0.999쯤 되지만 여전히 올바릅니다.",
    ),
)


SUM_FOR_LENGTH = Twin(
    "sum for length",
    lambda q: judged(q, norm=1),
    Words(
        en="That is the sum of the four numbers, not their length. The length is the root of the sum of squares: math.hypot.",
        ko="그것은 네 수의 합이지 길이가 아닙니다. 길이는 제곱의 합의 제곱근입니다. math.hypot을 쓰십시오.",
    ),
)


MINUS_Q_REFUSED = Twin(
    "minus q refused",
    lambda q: judged(q, last_sign=True),
    Words(
        en="You refuse a quaternion because its w is negative. q and -q are the same rotation; both are good.",
        ko="w가 음수라는 이유로 거절했습니다. q와 -q는 같은 회전이며 둘 다 올바릅니다.",
    ),
    misconception="M5",
)


ZERO_IS_ONLY_NOT_UNIT = Twin(
    "zero is only not unit",
    lambda q: judged(q, zero=False),
    Words(
        en="All zeros is worse than not unit: the others can be scaled to length one, this one cannot. Give it its own verdict, before the length.",
        ko="모두 0인 것은 not unit보다 나쁩니다. 다른 것은 길이를 1로 맞출 수 있지만 이것은 그럴 수 없습니다. 길이를 보기 전에 따로 판정하십시오.",
    ),
    misconception="M5",
)


def w_first_before_length(q: tuple) -> str:
    """Ask whether w is first before asking how long the quaternion is."""
    early = all(math.isfinite(part) for part in q) and max(abs(q[0]), abs(q[1])) > 0.1
    return "w first" if early else judged(q)


W_FIRST_BEFORE_LENGTH = Twin(
    "w first before length",
    w_first_before_length,
    Words(
        en="A quaternion can have two faults at once, and the task says which to name: you ask about x and y before you ask about the length.",
        ko="한 쿼터니언에 결함이 둘일 수도 있고, 무엇을 먼저 말할지는 문제에 적혀 있습니다. 길이를 보기 전에 x와 y부터 보았습니다.",
    ),
)


def zero_by_sum(q: tuple) -> str:
    """Add the four numbers up, signs and all, to see whether there is any length."""
    return "zero" if abs(sum(q)) < 1e-6 else judged(q)


ZERO_BY_SUM = Twin(
    "zero by sum",
    zero_by_sum,
    Words(
        en="You add the four numbers, and a quarter turn to the right adds up to zero. The length is the root of the sum of squares: math.hypot.",
        ko="네 수를 그냥 더했습니다. 오른쪽으로 4분의 1바퀴 도는 회전은 더하면 0이 됩니다. 길이는 제곱의 합의 제곱근입니다. math.hypot을 쓰십시오.",
    ),
    misconception="M5",
)


def judged_by_square(q: tuple) -> str:
    """Forget the root of the length."""
    verdict = judged(q)
    return "not unit" if verdict in ("ok", "w first") and abs(math.hypot(*q) ** 2 - 1.0) > 0.01 else verdict


SQUARE_FOR_LENGTH = Twin(
    "square for length",
    judged_by_square,
    Words(
        en="That is the square of the length, and it strays from 1 twice as fast as the length does. Take the root: math.sqrt, or math.hypot at once.",
        ko="그것은 길이의 제곱이어서 길이보다 두 배 빨리 1에서 벗어납니다. math.sqrt로 제곱근을 구하거나 처음부터 math.hypot을 쓰십시오.",
    ),
)


def judged_without_sign(q: tuple) -> str:
    """Look for a large x or y, but not for one that is largely negative."""
    verdict = judged(q)
    return "ok" if verdict == "w first" and max(q[:2]) <= 0.1 else verdict


NEGATIVE_X_OR_Y_PASSES = Twin(
    "negative x or y passes",
    judged_without_sign,
    Words(
        en="You look only for a large positive x or y. q and -q are the same rotation, so a w that came first may also be -0.9: compare abs().",
        ko="x나 y가 양수로 큰 경우만 보았습니다. q와 -q는 같은 회전이므로 맨 앞에 온 w가 -0.9일 수도 있습니다. abs()로 비교하십시오.",
    ),
    misconception="M5",
)


def judged_by_x(q: tuple) -> str:
    """Look at x alone, where a w that came first would land."""
    verdict = judged(q)
    return "ok" if verdict == "w first" and abs(q[0]) <= 0.1 else verdict


ONLY_X = Twin(
    "only x",
    judged_by_x,
    Words(
        en="You look at x alone. The task says x or y: a large y would tip the robot over just the same.",
        ko="x만 보았습니다. 문제에는 x나 y라고 적혀 있습니다. y가 커도 로봇은 똑같이 넘어집니다.",
    ),
)


def short_passes(q: tuple) -> str:
    """Refuse what is too long, but not what is too short."""
    verdict = judged(q)
    return "ok" if verdict == "not unit" and math.hypot(*q) < 1.0 else verdict


TOO_SHORT_PASSES = Twin(
    "too short passes",
    short_passes,
    Words(
        en="You refuse a length above 1, but not one below. It differs to both sides: compare abs(length - 1).",
        ko="길이가 1보다 큰 것만 걸러 냈고 1보다 작은 것은 통과시켰습니다. 양쪽으로 모두 벗어날 수 있으니 abs(length - 1)을 비교하십시오.",
    ),
)


TASK = Task(
    id="E2.4",
    kind="F",
    points=4,
    title=Words(en="A customs officer for quaternions", ko="쿼터니언 검문소"),
    answer="judge_quaternion",
    form=Choice(VERDICTS),
    inputs=quaternions,
    variants=3,
    twins=(
        NAN_SLIPS_THROUGH,
        INFINITY_SLIPS_THROUGH,
        W_FIRST_BEFORE_LENGTH,
        ZERO_BY_SUM,
        SQUARE_FOR_LENGTH,
        NEGATIVE_X_OR_Y_PASSES,
        ONLY_X,
        TOO_SHORT_PASSES,
        ZERO_IF_W_IS_ZERO,
        EXACTLY_ONE,
        TOO_STRICT,
        SUM_FOR_LENGTH,
        MINUS_Q_REFUSED,
        ZERO_IS_ONLY_NOT_UNIT,
    ),
    hints=(
        Words(
            en="Five verdicts, so four questions, in this order: finite? any length at all? length one? only about z?",
            ko="판정이 다섯이니 질문은 넷입니다. 차례로 묻습니다. 유한합니까? 길이가 있기는 합니까? 길이가 1입니까? z축으로만 돕니까?",
        ),
        Words(
            en="math.isfinite for each number, math.hypot(*q) for the length, a tolerance of 0.01 for one.",
            ko="각 숫자에는 math.isfinite, 길이에는 math.hypot(*q), 1과의 비교에는 허용 오차 0.01을 쓰십시오.",
        ),
        Words(
            en="A yaw has x = y = 0. Written w first, its w lands in x: so ask whether abs(x) or abs(y) exceeds 0.1. The sign of w says nothing.",
            ko="yaw만 있으면 x = y = 0입니다. w를 먼저 쓰면 w가 x 자리에 옵니다. 그러니 abs(x)나 abs(y)가 0.1을 넘는지 보십시오. w의 부호는 아무것도 말해 주지 않습니다.",
        ),
    ),
    cures=("M5",),
)
