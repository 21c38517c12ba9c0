"""E2.8: From a pixel to a point."""

from __future__ import annotations

import math

from tflab.core import Transform
from tflab.workbook.tasks import Draws, Vector, define_task


def draw_pixel(rng: Draws) -> dict:
    """Draw a camera, a pixel clearly off its centre, and the depth there."""
    right = float(rng.choice((-1, 1)) * rng.uniform(110.0, 160.0))
    down = float(rng.choice((-1, 1)) * rng.uniform(190.0, 230.0))
    cx, cy = round(float(rng.uniform(310.0, 330.0)), 1), round(float(rng.uniform(240.0, 260.0)), 1)
    fx = round(float(rng.uniform(500.0, 530.0)), 1)
    return {
        "fx": fx,
        "fy": round(fx + float(rng.uniform(30.0, 50.0)), 1),
        "cx": cx,
        "cy": cy,
        "u": float(round(cx + right)),
        "v": float(round(cy + down)),
        "depth_m": round(float(rng.uniform(1.6, 2.8)), 2),
        "base_p_camera": (0.12, 0.05, round(float(rng.uniform(0.7, 1.1)), 2)),
    }


def point_in_base_link(
    given,
    *,
    pixel="u, v",
    centre="subtracted",
    focal="own",
    scale="divided",
    depth="along z",
    turns="both",
    side="left",
    height="up",
    mount="added",
):
    """Return the point in base_link, step by step; other arguments are mistakes."""
    u, v = (given.v, given.u) if pixel == "v, u" else (given.u, given.v)
    cx, cy = {"ignored": (0.0, 0.0), "exchanged": (given.cy, given.cx)}.get(centre, (given.cx, given.cy))
    fx, fy = {
        "exchanged": (given.fy, given.fx),
        "fx twice": (given.fx, given.fx),
        "fy twice": (given.fy, given.fy),
    }.get(focal, (given.fx, given.fy))
    x, y, z = (u - cx) / fx, (v - cy) / fy, 1.0
    if scale == "in pixels":
        x, y = u - cx, v - cy
    reach = {"along the ray": given.depth_m / math.hypot(x, y, z), "left out": 1.0}.get(depth, given.depth_m)
    x, y, z = (x, y, given.depth_m) if depth == "only z" else (x * reach, y * reach, z * reach)
    ahead, left, up = given.base_p_camera
    if mount == "added first":
        x, y, z = x + ahead, y + left, z + up
    quarter = math.pi / 2
    x, y, z = {
        "both": lambda: (z, -x, -y),
        "none": lambda: (x, y, z),
        "back": lambda: (-y, -z, x),
        "roll alone": lambda: Transform.from_rpy(roll=-quarter).apply((x, y, z)),
        "yaw alone": lambda: Transform.from_rpy(yaw=-quarter).apply((x, y, z)),
        "other order": lambda: (y, z, x),
    }[turns]()
    y, z = (-y if side == "right" else y), (-z if height == "down" else z)
    times = {"added": 1.0, "subtracted": -1.0}.get(mount, 0.0)
    return (x + times * ahead, y + times * left, z + times * up)


TASK = define_task(
    __file__,
    kind="N",
    points=3,
    answer="base_p_part",
    form=Vector(3, unit="m", frame="base_link", tolerance=0.005),
    given=draw_pixel,
    variants=5,
    model=point_in_base_link,
)
