"""E3.5: tf2_echo in both directions."""

from __future__ import annotations

import math

from tflab.core import LATEST, StampedTransform, Transform
from tflab.views.sentence import echo_text
from tflab.workbook.tasks import Angle, Draws, Parts, Vector, define_task

from .draws import WRONG_FORMULAS, are_distinct, draw_mount, rotate, rotate_by_formula

AMBIGUOUS_DEG = {  # yaws of which two mistakes give the same angle, modulo a turn: 1 / yaw is cos(yaw / 2) at 70
    44, 45, 56, 70, 113, 118, 119, 125, 126, 135, -25, -44, -45, -70, -117, -125, -126, -127, -129, -135, -149,
}  # fmt: skip


def draw_printed_transform(rng: Draws) -> dict[str, str]:
    """Draw until no two mistakes give the same position or the same yaw."""
    while True:
        mount = draw_mount(rng)
        (x, y, _), yaw = mount.translation, mount.rpy()[2]
        inverse, half, converted = (
            rotate_by_formula(-x, -y, angle, "right") for angle in (-yaw, -yaw / 2, -math.radians(yaw))
        )
        others = (inverse[::-1], half, converted, (-x, -y), (-x, y), (-y, -x))
        is_rounded = abs(math.degrees(round(yaw, 3) - yaw)) > 0.006
        is_clear = is_rounded and round(math.degrees(yaw)) not in AMBIGUOUS_DEG
        if is_clear and are_distinct(-x, -y, -yaw, *others):
            return {"echo": echo_text(StampedTransform("base_link", "laser_frame", LATEST, mount))}


def printed_transform(given) -> tuple[Transform, float]:
    """Return the transform that was printed, and its yaw [rad]."""
    rows = [line.split("[")[1].rstrip("]").split(", ") for line in given.echo.splitlines()[1:4]]
    yaw = float(rows[2][2])
    return Transform.from_rpy(yaw=yaw, translation=tuple(map(float, rows[0]))), yaw


def read_printed_transform(given, *, laser="as printed", back="inverse", height="turned with it", yaw="minus"):
    """Return both positions and the yaw, step by step; other arguments are mistakes."""
    mount, printed = printed_transform(given)
    there, inverse = mount.translation, mount.inverse()
    away = tuple(-value for value in there)
    c, s = math.cos(printed), math.sin(printed)
    returned = {
        "inverse": inverse.translation,
        "swapped": there,
        "sign only": away,
        "turned on": rotate(mount, away),
        "not taken off": rotate(inverse, there),
        "turned on, not taken off": rotate(mount, there),
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
        "not taken off in the plane": (*rotate(inverse, there)[:2], away[2]),
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
    } | {way: (*rotate_by_formula(*away[:2], -printed, way), away[2]) for way in WRONG_FORMULAS}  # fmt: skip
    returned = returned[back]
    seen = {"as printed": there, "swapped": inverse.translation, "negative": away, "turned": rotate(mount, there),
            "turned back": rotate(inverse, there), "row of the matrix": (c, -s, 0.0),
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


TASK = define_task(
    __file__,
    kind="N",
    points=3,
    answer="both_ways",
    form=Parts(
        {
            "laser_in_base": Vector(3, "m", "base_link", 0.005),
            "base_in_laser": Vector(3, "m", "laser_frame", 0.005),
            "yaw_back": Angle(0.005),
        }
    ),
    given=draw_printed_transform,
    variants=6,
    model=read_printed_transform,
)
