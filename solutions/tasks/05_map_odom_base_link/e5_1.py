"""E5.1: What a localiser publishes."""

from __future__ import annotations

from tflab.core import Transform
from tflab.workbook.tasks import Pose, define_task

from .draws import by_parts, on_a_slope, on_the_floor, turned_round


def two_poses(rng):
    """Both turned; the wheels without a fault; odom's origin under the robot; a ramp that either knows, or both."""
    same = on_the_floor(rng)
    pairs = [(on_the_floor(rng), on_the_floor(rng)) for _ in range(4)]
    ramps = [(on_a_slope(rng), on_the_floor(rng)), (on_the_floor(rng), on_a_slope(rng))]
    return [*pairs, (same, same), (on_the_floor(rng), Transform()), *ramps, (on_a_slope(rng), on_a_slope(rng))]


def product(map_T_base, odom_T_base, *, poses="as given", found="as given", wheels="turned round",
            order="found first", way="as asked", edge="whole"):  # fmt: skip
    """Return map_T_odom, step by step; other steps are the slips."""
    if poses == "flat":
        map_T_base, odom_T_base = flat(map_T_base), flat(odom_T_base)
    left = map_T_base.inverse() if found == "turned round" else map_T_base
    right = turned_round(odom_T_base, wheels)
    joined = left @ right if order == "found first" else right @ left
    joined = joined.inverse() if way == "turned round" else joined
    return flat(joined) if edge == "flat" else joined


def right_edge(map_T_base, odom_T_base):
    return map_T_base @ odom_T_base.inverse()


def flat(pose):
    """Return a pose as a map of the floor has it: x, y and yaw."""
    x, y, _ = pose.translation
    return Transform.from_rpy(yaw=pose.rpy()[2], translation=(x, y, 0.0))


ANSWERS = {
    "subtracted": by_parts,
    "where the robot is": lambda map_T_base, odom_T_base: map_T_base,
    "what the wheels say": lambda map_T_base, odom_T_base: odom_T_base,
    "turn back alone": lambda map_T_base, odom_T_base: (
        map_T_base @ Transform(odom_T_base.translation, odom_T_base.inverse().rotation)
    ),
    "step alone": lambda map_T_base, odom_T_base: Transform(right_edge(map_T_base, odom_T_base).translation),
    "steps subtracted, no turn": lambda map_T_base, odom_T_base: Transform(
        [a - b for a, b in zip(map_T_base.translation, odom_T_base.translation, strict=True)]
    ),
    "subtracted, the robot's turn": lambda map_T_base, odom_T_base: Transform(
        [a - b for a, b in zip(map_T_base.translation, odom_T_base.translation, strict=True)], map_T_base.rotation
    ),
    "x and y subtracted, no turn": lambda map_T_base, odom_T_base: Transform(
        [*(a - b for a, b in zip(map_T_base.translation[:2], odom_T_base.translation[:2], strict=True)), 0.0]
    ),
    "x, y and yaw subtracted": lambda map_T_base, odom_T_base: by_parts(flat(map_T_base), flat(odom_T_base)),
    "subtracted the other way": lambda map_T_base, odom_T_base: by_parts(odom_T_base, map_T_base),
    "the robot's turn kept": lambda map_T_base, odom_T_base: Transform(
        right_edge(map_T_base, odom_T_base).translation, map_T_base.rotation
    ),
}

TASK = define_task(
    __file__,
    kind="F",
    points=4,
    answer="map_to_odom",
    form=Pose(),
    inputs=two_poses,
    variants=3,
    model=product,
    answers=ANSWERS,
)
