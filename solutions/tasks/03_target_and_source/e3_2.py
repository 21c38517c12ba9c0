"""E3.2: A corner seen by a rotated laser."""

from __future__ import annotations

import math

from tflab.core import Transform
from tflab.workbook.tasks import Draws, Parts, Vector, define_task

from .draws import WRONG_FORMULAS, are_distinct, draw_mount, draw_yaw_degrees, rotate, rotate_by_formula


def add(*points) -> tuple[float, ...]:
    """Return the sum of points, component by component."""
    return tuple(map(sum, zip(*points, strict=True)))


def draw_corner(rng: Draws) -> dict[str, object]:
    """Draw until the wrong rotations of both points are distinct."""
    while True:
        given = _corner(rng)
        mount, robot, point = given["base_T_laser"], given["map_T_base"], given["laser_p_corner"]
        if _has_distinct_rotation(mount, point) and _has_distinct_rotation(robot, mount.apply(point)):
            return given


def _has_distinct_rotation(transform: Transform, point) -> bool:
    """Return whether half the rotation, twice the rotation and each wrong formula move the point elsewhere."""
    (x, y, _), yaw = point, transform.rpy()[2]
    half = abs(yaw) / 2.0
    is_half_told = math.hypot(x, y) * (half - math.sin(half)) > 0.008
    return is_half_told and abs(math.sin(3 * half)) > 0.02 and are_distinct(x, y, yaw)


def _corner(rng: Draws) -> dict[str, object]:
    x, y = rng.integers(200, 600, size=2) / 100
    map_T_base = Transform.from_rpy(yaw=math.radians(draw_yaw_degrees(rng)), translation=(x, y, 0.1))
    point = (rng.integers(150, 400) / 100, rng.choice([-1, 1]) * rng.integers(30, 120) / 100, 0.0)
    return {"map_T_base": map_T_base, "base_T_laser": draw_mount(rng), "laser_p_corner": tuple(map(float, point))}


def transform_point(transform: Transform, point, way: str) -> tuple[float, ...]:
    """Return a point transformed from child to parent, or by a mistake."""
    if way in WRONG_FORMULAS:
        return add((*rotate_by_formula(*point[:2], transform.rpy()[2], way), point[2]), transform.translation)
    back = tuple(-number for number in transform.translation)
    return {
        "apply": transform.apply(point),
        "inverse": transform.inverse().apply(point),
        "no turn": add(point, transform.translation),
        "step first": rotate(transform, add(point, transform.translation)),
        "turn only": rotate(transform, point),
        "turn back": add(rotate(transform.inverse(), point), transform.translation),
        "step back": add(rotate(transform, point), back),
        "origin": transform.translation,
        "no turn, step back": add(point, back),
        "w first": Transform(transform.translation, transform.rotation[3:] + transform.rotation[:3]).apply(point),
        "z for the yaw": Transform.from_rpy(yaw=transform.rotation[2], translation=transform.translation).apply(point),
        "turn back, no step": rotate(transform.inverse(), point),
        "twice": transform.apply(transform.apply(point)),
        "half the turn": add(rotate(_half(transform), point), transform.translation),
        "turned twice": add(rotate(transform, rotate(transform, point)), transform.translation),
        "by degrees": _by_yaw(transform, math.degrees(transform.rpy()[2]), point),
        "converted": _by_yaw(transform, math.radians(transform.rpy()[2]), point),
    }[way]


def _by_yaw(transform: Transform, yaw: float, point) -> tuple[float, ...]:
    return Transform.from_rpy(yaw=yaw, translation=transform.translation).apply(point)


def _half(transform: Transform) -> Transform:
    return Transform.from_rpy(yaw=transform.rpy()[2] / 2)


def transform_twice(
    given, *, first="apply", height="kept", then="apply", product="in order", between="as computed"
) -> dict[str, tuple]:
    """Return the corner in both frames, step by step; other arguments are mistakes."""
    point = given.laser_p_corner
    base_p = transform_point(given.base_T_laser, point, first)
    if product == "reversed":
        return {"base_link": base_p, "map": (given.base_T_laser @ given.map_T_base).apply(point)}
    if product == "inverted":
        return {"base_link": base_p, "map": (given.map_T_base @ given.base_T_laser).inverse().apply(point)}
    if product == "laser twice":
        return {"base_link": base_p, "map": (given.map_T_base @ given.base_T_laser).apply(base_p)}
    if product == "laser itself":
        return {"base_link": base_p, "map": given.map_T_base.apply(given.base_T_laser.translation)}
    if product in BY_COPYING:
        return {"base_link": base_p, "map": _copied(given, base_p, product)}
    base_p = (*base_p[:2], {"left out": 0.0, "twice": 2 * base_p[2]}.get(height, base_p[2]))
    carried = {"as computed": base_p, "to tenths": tuple(round(number, 1) for number in base_p)}[between]
    return {
        "base_link": base_p,
        "map": transform_point(given.map_T_base, point if product == "skipped" else carried, then),
    }


BY_COPYING = (
    "mount's turn", "mount's step", "mount again", "mount's step not turned", "mount's turn left out",
    "mount's turn once more", "robot's step once more", "both inverses",
)  # fmt: skip


def _copied(given, base_p, what: str) -> tuple[float, ...]:
    """Return the corner in map with a part of the laser's mount in a wrong place."""
    mount, robot, point = given.base_T_laser, given.map_T_base, given.laser_p_corner
    return {
        "mount's turn": add(rotate(mount, base_p), robot.translation),
        "mount's step": add(rotate(robot, base_p), mount.translation),
        "mount again": mount.apply(base_p),
        "mount's turn once more": add(rotate(robot, rotate(mount, base_p)), robot.translation),
        "robot's step once more": add(robot.apply(base_p), robot.translation),
        "both inverses": (robot.inverse() @ mount.inverse()).apply(point),
        "mount's step not turned": add(rotate(robot, rotate(mount, point)), mount.translation, robot.translation),
        "mount's turn left out": add(rotate(robot, point), mount.translation, robot.translation),
    }[what]


def round_twice(given) -> dict[str, tuple]:
    """Return both points rounded to tenths, the second computed from the rounded first."""
    rough = transform_twice(given, between="to tenths")
    return {name: tuple(round(number, 1) for number in row) for name, row in rough.items()}


def leave_height_out(given) -> dict[str, tuple]:
    """Return both points, the one in map with the z of the other."""
    corner = transform_twice(given)
    return corner | {"map": (*corner["map"][:2], corner["base_link"][2])}


ANSWERS = {
    "height of the robot left out": leave_height_out,
    "rounded twice": round_twice,
}

TASK = define_task(
    __file__,
    kind="N",
    points=4,
    answer="corner",
    form=Parts({"base_link": Vector(3, "m", "base_link", 0.005), "map": Vector(3, "m", "map", 0.005)}),
    given=draw_corner,
    variants=6,
    model=transform_twice,
    answers=ANSWERS,
)
