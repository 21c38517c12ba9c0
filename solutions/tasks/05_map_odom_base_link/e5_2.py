"""E5.2: A loop closure."""

from __future__ import annotations

import math

from tflab.core import Transform
from tflab.workbook.tasks import Number, Parts, Pose, Vector, define_task

from .draws import draw_planar_pose, subtract_by_component


def draw_loop(rng):
    """Draw a loop closure that moves and rotates the robot, and with it odom's origin."""
    while True:
        given = _one_loop(rng)
        new_edge = given["found_T_base"] @ given["odom_T_base"].inverse()
        slide_m = math.dist(new_edge.translation, given["map_T_odom"].translation)
        believed = given["map_T_odom"] @ given["odom_T_base"]
        leap_m = math.dist(believed.translation, given["found_T_base"].translation)
        sides_m = sum(abs(a - b) for a, b in zip(believed.translation, given["found_T_base"].translation, strict=True))
        origin_m = [math.hypot(*pose.translation) for pose in (believed, given["found_T_base"])]
        farther_m = abs(origin_m[1] - origin_m[0])
        apart = (abs(slide_m - leap_m), abs(slide_m - sides_m), sides_m - leap_m, leap_m - farther_m, farther_m)
        if min(apart) > 0.05:
            return given


def _one_loop(rng):
    map_T_odom, odom_T_base = draw_planar_pose(rng, 2.0), draw_planar_pose(rng, 4.0)
    way = float(rng.choice([-1.0, 1.0]))
    aside = Transform.from_rpy(
        yaw=way * float(rng.uniform(0.1, 0.3)),
        translation=(float(rng.uniform(0.3, 0.7)), float(rng.uniform(0.2, 0.5)), 0.0),
    )
    found = map_T_odom @ odom_T_base @ aside
    x, y, _ = found.translation
    found = Transform.from_rpy(yaw=round(found.rpy()[2], 2), translation=(round(x, 2), round(y, 2), 0.0))
    return {"map_T_odom": map_T_odom, "odom_T_base": odom_T_base, "found_T_base": found}


def closure(g, believed=None, jump=None, edge=None, step=0.0):
    believed = list((g.map_T_odom @ g.odom_T_base).translation[:2]) if believed is None else list(believed)
    return {
        "believed": believed,
        "jump_m": math.dist(believed, g.found_T_base.translation[:2]) if jump is None else jump,
        "map_T_odom": g.found_T_base @ g.odom_T_base.inverse() if edge is None else edge,
        "step_in_odom_m": step,
    }


def jump_of_the_edge(g):
    new = g.found_T_base @ g.odom_T_base.inverse()
    return closure(g, jump=math.dist(new.translation, g.map_T_odom.translation))


def odometry_is_reset(g):
    before = g.map_T_odom @ g.odom_T_base
    return closure(g, step=math.dist(before.translation, g.found_T_base.translation))


def before(g):
    return g.map_T_odom @ g.odom_T_base


def step(g):
    """Return the jump of the robot along x and y."""
    return [a - b for a, b in zip(g.found_T_base.translation, before(g).translation, strict=True)]


ANSWERS = {
    "odometry is reset": odometry_is_reset,
    "jump of the edge": jump_of_the_edge,
    "old edge kept": lambda g: closure(g, edge=g.map_T_odom),
    "subtracted": lambda g: closure(g, edge=subtract_by_component(g.found_T_base, g.odom_T_base)),
    "robot published": lambda g: closure(g, edge=g.found_T_base),
    "believed in odom": lambda g: closure(g, believed=g.odom_T_base.translation[:2]),
    "believed added": lambda g: closure(
        g, believed=[a + b for a, b in zip(g.map_T_odom.translation, g.odom_T_base.translation, strict=True)][:2]
    ),
    "believed is found": lambda g: closure(g, believed=g.found_T_base.translation[:2]),
    "believed in the other order": lambda g: closure(g, believed=(g.odom_T_base @ g.map_T_odom).translation[:2]),
    "believed with the edge turned round": lambda g: closure(
        g, believed=(g.map_T_odom.inverse() @ g.odom_T_base).translation[:2]
    ),
    "jump from odom": lambda g: closure(g, jump=math.dist(g.found_T_base.translation, g.odom_T_base.translation)),
    "jump by sides": lambda g: closure(g, jump=abs(step(g)[0]) + abs(step(g)[1])),
    "edge in the other order": lambda g: closure(g, edge=g.odom_T_base.inverse() @ g.found_T_base),
    "wheels not turned round": lambda g: closure(g, edge=g.found_T_base @ g.odom_T_base),
    "edge is the correction": lambda g: closure(g, edge=g.found_T_base @ before(g).inverse()),
    "edge is the leap": lambda g: closure(g, edge=before(g).inverse() @ g.found_T_base),
    "leap behind the edge": lambda g: closure(g, edge=g.map_T_odom @ before(g).inverse() @ g.found_T_base),
    "correction behind the edge": lambda g: closure(g, edge=g.map_T_odom @ g.found_T_base @ before(g).inverse()),
    "step is the slide": lambda g: closure(
        g, step=math.dist((g.found_T_base @ g.odom_T_base.inverse()).translation, g.map_T_odom.translation)
    ),
    "from the origin": lambda g: closure(g, step=math.hypot(*g.odom_T_base.translation[:2])),
    "believed turned round": lambda g: closure(g, believed=before(g).inverse().translation[:2]),
    "believed is the edge": lambda g: closure(g, believed=g.map_T_odom.translation[:2]),
    "jump is the place found": lambda g: closure(g, jump=math.hypot(*g.found_T_base.translation[:2])),
    "no jump": lambda g: closure(g, jump=0.0),
    "jump along x": lambda g: closure(g, jump=abs(step(g)[0])),
    "jump along y": lambda g: closure(g, jump=abs(step(g)[1])),
    "jump of distances": lambda g: closure(
        g, jump=abs(math.hypot(*g.found_T_base.translation[:2]) - math.hypot(*before(g).translation[:2]))
    ),
    "edge shifted": lambda g: closure(
        g,
        edge=Transform(
            [a + b for a, b in zip(g.map_T_odom.translation, [*step(g)[:2], 0.0], strict=True)], g.map_T_odom.rotation
        ),
    ),
}

TASK = define_task(
    __file__,
    kind="N",
    points=4,
    answer="closure",
    form=Parts(
        {
            "believed": Vector(2, unit="m", tolerance=0.005),
            "jump_m": Number(unit="m", tolerance=0.005),
            "map_T_odom": Pose(tolerance_m=0.005, tolerance_rad=0.005),
            "step_in_odom_m": Number(unit="m", tolerance=0.005),
        }
    ),
    given=draw_loop,
    variants=6,
    answers=ANSWERS,
)
