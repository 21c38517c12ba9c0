"""E1.1: One position, three sets of coordinates."""

from __future__ import annotations

from tflab.workbook.tasks import Parts, Vector, define_task


def draw_robot_and_post(rng):
    return {
        "map_p_base": [round(float(rng.uniform(low, high)), 2) for low, high in ((3, 8), (-3, -1), (0.05, 0.12))],
        "base_p_laser": [
            round(float(rng.uniform(low, high)), 2) for low, high in ((0.15, 0.3), (0.05, 0.12), (0.14, 0.3))
        ],
        "laser_p_post": [round(float(rng.uniform(low, high)), 2) for low, high in ((1.5, 4), (0.4, 1.2), (0.33, 0.6))],
    }


def plus(*points):
    return [sum(numbers) for numbers in zip(*points, strict=True)]


def answer(base, map_):
    return {"base_link": base, "map": map_}


SIGN = {"added": 1.0, "taken away": -1.0, "skipped": 0.0, "turned round": 1.0, "twice": 2.0}


def locate_post(
    g, *, side="left", mount="added", way="laser to post", height="added", start="base_link", robot="added"
):
    """Return the position of the post, step by step; other arguments are mistakes."""
    x, y, z = g.laser_p_post
    seen = [x, -y if side == "right" else y, z]
    kept = {"x alone": "x", "without y": "xz"}.get(mount, "xyz")
    there = [
        SIGN.get(mount, 1.0) * n if letter in kept else 0.0 for letter, n in zip("xyz", g.base_p_laser, strict=True)
    ]
    base = plus(there, [seen, [-one for one in seen]][way == "mount minus post"])
    base = plus(g.map_p_base, g.base_p_laser) if way == "the laser in map" else base
    starts = {
        "base_link": base,
        "laser": seen,
        "mount twice": plus(base, g.base_p_laser),
        "robot alone": g.base_p_laser,
    }
    map_ = plus([SIGN[robot] * number for number in g.map_p_base], starts[start])
    map_ = plus(map_, g.laser_p_post, [-number for number in g.map_p_base]) if way == "the laser in map" else map_
    map_ = plus(g.map_p_base, [-number for number in starts[start]]) if robot == "turned round" else map_
    heights = {"added": (base[2], map_[2]), "the laser's": (z, z), "floor": (0.0, 0.0),
               "robot's forgotten": (base[2], map_[2] - g.map_p_base[2])}[height]  # fmt: skip
    return answer([*base[:2], heights[0]], [*map_[:2], heights[1]])


ANSWERS = {
    "same numbers": lambda g: answer(g.laser_p_post, g.laser_p_post),
}

TASK = define_task(
    __file__,
    kind="N",
    points=4,
    answer="post",
    form=Parts({frame: Vector(3, unit="m", frame=frame, tolerance=0.003) for frame in ("base_link", "map")}),
    given=draw_robot_and_post,
    variants=6,
    model=locate_post,
    answers=ANSWERS,
)
