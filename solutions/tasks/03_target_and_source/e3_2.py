"""E3.2: A corner seen by a turned laser."""

from __future__ import annotations

import math

from tflab.core import Transform
from tflab.workbook.tasks import Draws, Parts, Vector, define_task

from .draws import BY_HAND, by_formula, some_mount, some_yaw_degrees, tells_ways_apart, turned


def added(*points) -> tuple[float, ...]:
    """Return the sum of points, one number after the other."""
    return tuple(map(sum, zip(*points, strict=True)))


def corner_given(rng: Draws) -> dict[str, object]:
    """Draw until both points show how they were rotated."""
    while True:
        given = _corner(rng)
        mount, robot, point = given["base_T_laser"], given["map_T_base"], given["laser_p_corner"]
        if _shows_its_turn(mount, point) and _shows_its_turn(robot, mount.apply(point)):
            return given


def _shows_its_turn(transform: Transform, point) -> bool:
    """Return whether half the rotation, twice the rotation and each wrong formula move the point elsewhere."""
    (x, y, _), yaw = point, transform.rpy()[2]
    half = abs(yaw) / 2.0
    is_half_told = math.hypot(x, y) * (half - math.sin(half)) > 0.008
    return is_half_told and abs(math.sin(3 * half)) > 0.02 and tells_ways_apart(x, y, yaw)


def _corner(rng: Draws) -> dict[str, object]:
    x, y = rng.integers(200, 600, size=2) / 100
    map_T_base = Transform.from_rpy(yaw=math.radians(some_yaw_degrees(rng)), translation=(x, y, 0.1))
    point = (rng.integers(150, 400) / 100, rng.choice([-1, 1]) * rng.integers(30, 120) / 100, 0.0)
    return {"map_T_base": map_T_base, "base_T_laser": some_mount(rng), "laser_p_corner": tuple(map(float, point))}


def taken(transform: Transform, point, way: str) -> tuple[float, ...]:
    """Return a point taken from the child to the parent, or what people do instead."""
    if way in BY_HAND:
        return added((*by_formula(*point[:2], transform.rpy()[2], way), point[2]), transform.translation)
    back = tuple(-number for number in transform.translation)
    return {
        "apply": transform.apply(point),
        "inverse": transform.inverse().apply(point),
        "no turn": added(point, transform.translation),
        "step first": turned(transform, added(point, transform.translation)),
        "turn only": turned(transform, point),
        "turn back": added(turned(transform.inverse(), point), transform.translation),
        "step back": added(turned(transform, point), back),
        "origin": transform.translation,
        "no turn, step back": added(point, back),
        "w first": Transform(transform.translation, transform.rotation[3:] + transform.rotation[:3]).apply(point),
        "z for the yaw": Transform.from_rpy(yaw=transform.rotation[2], translation=transform.translation).apply(point),
        "turn back, no step": turned(transform.inverse(), point),
        "twice": transform.apply(transform.apply(point)),
        "half the turn": added(turned(_half(transform), point), transform.translation),
        "turned twice": added(turned(transform, turned(transform, point)), transform.translation),
        "by degrees": _by_yaw(transform, math.degrees(transform.rpy()[2]), point),
        "converted": _by_yaw(transform, math.radians(transform.rpy()[2]), point),
    }[way]


def _by_yaw(transform: Transform, yaw: float, point) -> tuple[float, ...]:
    return Transform.from_rpy(yaw=yaw, translation=transform.translation).apply(point)


def _half(transform: Transform) -> Transform:
    return Transform.from_rpy(yaw=transform.rpy()[2] / 2)


def moved_twice(
    given, *, first="apply", height="kept", then="apply", product="in order", between="as computed"
) -> dict[str, tuple]:
    """Return the corner in both frames, step by step; other steps are the slips."""
    point = given.laser_p_corner
    base_p = taken(given.base_T_laser, point, first)
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
    return {"base_link": base_p, "map": taken(given.map_T_base, point if product == "skipped" else carried, then)}


BY_COPYING = (
    "mount's turn", "mount's step", "mount again", "mount's step not turned", "mount's turn left out",
    "mount's turn once more", "robot's step once more", "both inverses",
)  # fmt: skip


def _copied(given, base_p, what: str) -> tuple[float, ...]:
    """Return the corner on the map where something of the laser's mount went in as it should not."""
    mount, robot, point = given.base_T_laser, given.map_T_base, given.laser_p_corner
    return {
        "mount's turn": added(turned(mount, base_p), robot.translation),
        "mount's step": added(turned(robot, base_p), mount.translation),
        "mount again": mount.apply(base_p),
        "mount's turn once more": added(turned(robot, turned(mount, base_p)), robot.translation),
        "robot's step once more": added(robot.apply(base_p), robot.translation),
        "both inverses": (robot.inverse() @ mount.inverse()).apply(point),
        "mount's step not turned": added(turned(robot, turned(mount, point)), mount.translation, robot.translation),
        "mount's turn left out": added(turned(robot, point), mount.translation, robot.translation),
    }[what]


def rounded_twice(given) -> dict[str, tuple]:
    """Return both places rounded to tenths, the second computed from the rounded first."""
    rough = moved_twice(given, between="to tenths")
    return {name: tuple(round(number, 1) for number in row) for name, row in rough.items()}


def without_the_robots_height(given) -> dict[str, tuple]:
    """Return both places, the one on the map with the other's z."""
    corner = moved_twice(given)
    return corner | {"map": (*corner["map"][:2], corner["base_link"][2])}


ANSWERS = {
    "height of the robot left out": without_the_robots_height,
    "rounded twice": rounded_twice,
}

TASK = define_task(
    __file__,
    kind="N",
    points=4,
    answer="corner",
    form=Parts({"base_link": Vector(3, "m", "base_link", 0.005), "map": Vector(3, "m", "map", 0.005)}),
    given=corner_given,
    variants=6,
    model=moved_twice,
    answers=ANSWERS,
)
