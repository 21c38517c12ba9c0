"""E2.2: From the optical frame to the camera."""

from __future__ import annotations

import math

from tflab.core import Transform
from tflab.workbook.tasks import Draws, Vector, define_task


def draw_detection(rng: Draws) -> dict:
    """Draw a detection with three clearly different numbers."""
    right = rng.choice((-1, 1)) * rng.uniform(0.25, 0.45)
    down = rng.choice((-1, 1)) * rng.uniform(0.55, 0.80)
    return {"optical_p_part": (round(float(right), 2), round(float(down), 2), round(float(rng.uniform(1.2, 3.0)), 2))}


MUG = (0.40, -0.20, 1.50)  # the page's example


def convert_to_camera_link(
    given,
    *,
    part="given",
    turns="both",
    side="left",
    height="up",
    depth="ahead",
    places="own",
    origin="camera",
    length="kept",
):
    """Return the point in camera_link, step by step; other arguments are mistakes."""
    x, y, z = MUG if part == "the page's" else given.optical_p_part
    x, y, z = {
        "times the depth": (x * z, y * z, z),
        "over the depth": (x / z, y / z, z),
        "of a ray": (x, y, math.sqrt(z * z - x * x - y * y)),
        "with a ray": (x, y, math.hypot(x, y, z)),
        "mount added": (x + 0.10, y, z + 0.30),
    }.get(part, (x, y, z))
    quarter = math.pi / 2
    x, y, z = {
        "both": lambda: (z, -x, -y),
        "none": lambda: (x, y, z),
        "back": lambda: (-y, -z, x),
        "other order": lambda: (y, z, x),
        "sign of x tossed": lambda: (y, -z, -x),
        "sign of z tossed": lambda: (-y, z, -x),
        "x and z exchanged": lambda: (z, y, x),
        "x and z exchanged, y minus": lambda: (z, -y, x),
        "roll alone": lambda: Transform.from_rpy(roll=-quarter).apply((x, y, z)),
        "yaw alone": lambda: Transform.from_rpy(yaw=-quarter).apply((x, y, z)),
        "pitch": lambda: Transform.from_rpy(pitch=quarter).apply((x, y, z)),
        "roll to the other side": lambda: Transform.from_rpy(roll=quarter, yaw=-quarter).apply((x, y, z)),
        "yaw to the other side": lambda: Transform.from_rpy(roll=-quarter, yaw=quarter).apply((x, y, z)),
        "roll alone, plus": lambda: (x, -z, y),
        "yaw alone, plus": lambda: (-y, x, z),
        "pitch, minus": lambda: (-z, y, x),
        "half turns": lambda: (-x, y, -z),
        "converted twice": lambda: Transform.from_rpy(roll=math.radians(-quarter), yaw=math.radians(-quarter)).apply(
            (x, y, z)
        ),
        "eighths": lambda: Transform.from_rpy(roll=-quarter / 2, yaw=-quarter / 2).apply((x, y, z)),
        "degrees": lambda: Transform.from_rpy(roll=-90.0, yaw=-90.0).apply((x, y, z)),
        "degrees, by position": lambda: Transform.from_rpy(-90.0, -90.0).apply((x, y, z)),
        "degrees, plus": lambda: Transform.from_rpy(roll=90.0, yaw=90.0).apply((x, y, z)),
    }[turns]()
    x, y, z = (-x if depth == "behind" else x), (-y if side == "right" else y), (-z if height == "down" else z)
    x, y, z = (x, z, y) if places == "exchanged" else (x, y, z)
    ahead, up = {
        "base_link": (0.10, 0.30),
        "taken off": (-0.10, -0.30),
        "raised": (0.0, 0.30),
        "set forward": (0.10, 0.0),
    }.get(origin, (0.0, 0.0))
    x, z = x + ahead, z + up
    share = math.hypot(x, y, z) if length == "one" else 1.0
    return (x / share, y / share, z / share)


ANSWERS = {
    "numbers of the rotation": (-0.5, 0.5, -0.5),
}

TASK = define_task(
    __file__,
    kind="N",
    points=3,
    answer="camera_p_part",
    form=Vector(3, unit="m", frame="camera_link", tolerance=0.005),
    given=draw_detection,
    variants=5,
    model=convert_to_camera_link,
    answers=ANSWERS,
)
