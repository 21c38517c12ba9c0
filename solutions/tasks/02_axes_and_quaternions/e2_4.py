"""E2.4: Check a quaternion."""

from __future__ import annotations

import math
from itertools import combinations

from tflab.core import Transform
from tflab.core.quaternions import wxyz_from_xyzw
from tflab.workbook.tasks import Choice, Draws, define_task

VERDICTS = ("ok", "nan", "zero", "not unit", "w first")
PARTLY = ["".join(some) for size in (1, 2, 3) for some in combinations("xyzw", size)]  # which are asked for NaN


def draw_quaternions(rng: Draws) -> list[tuple[tuple[float, float, float, float]]]:
    """Draw valid quaternions of every kind, and one of each invalid kind."""

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
        (0.0, 0.0, -math.inf, 1.0),
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
        ),  # just past the tolerance
        *((0.0, 0.0, 0.0, w) for w in (9.995e-7, 1.0005e-6, 5e-3)),  # close to zero
        *((x, 0.0, math.sqrt(1.0 - x * x), 0.0) for x in (0.1, 0.09995, 0.10005)),  # at the bound and next to it
        (0.0, 0.10005, 0.0, math.sqrt(1.0 - 0.10005**2)),
        (0.08, 0.08, 0.0, math.sqrt(1.0 - 2 * 0.08**2)),  # each below the bound, their sum not
        (-0.4, 0.0, 0.0, math.sqrt(1.0 - 0.4**2)),  # negative, with a positive w
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


def judge(q: tuple, *, finite="all", zero="length", below=1e-6, length="root", tolerance=0.01, sides="both",
           looks="xy", size="abs", above=0.1, w="any sign", first="length") -> str:  # fmt: skip
    """Judge a quaternion as the task asks, step by step; other arguments are mistakes."""
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
    sizes = {
        "never": 0.0,
        "abs": max(abs(x), abs(y)),
        "signed": max(x, y),
        "sum": abs(x) + abs(y),
        "of the sum": abs(x + y),
        "length": math.hypot(x, y),
        "both": min(abs(q[0]), abs(q[1])),
        "z, too": max(map(abs, q[:3])),
        "x signed": max(x, abs(y)),
        "y signed": max(abs(x), y),
        "signed sum": x + y,
        "x or z": max(abs(x), abs(q[2])),
        "first that is not 0": abs(x or y),
        "squares": max(x * x, y * y),
        "sum of squares": x * x + y * y,
        "x and y": abs(x and y),
        "z": abs(q[2]),
        "w large": abs(q[3]),
    }
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


def last_fitting_verdict(q: tuple) -> str:
    """Return the last verdict that fits, where the task asks for the first."""
    length = math.hypot(*q)
    verdicts = {
        "nan": not all(map(math.isfinite, q)),
        "zero": length < 1e-6,
        "not unit": abs(length - 1.0) > 0.01,
        "w first": max(abs(q[0]), abs(q[1])) > 0.1,
    }
    return [verdict for verdict, fits in {"ok": True, **verdicts}.items() if fits][-1]


ANSWERS = {
    "the last that fits": last_fitting_verdict,
}

TASK = define_task(
    __file__,
    kind="F",
    points=4,
    answer="judge_quaternion",
    form=Choice(VERDICTS),
    inputs=draw_quaternions,
    variants=3,
    model=judge,
    answers=ANSWERS,
)
