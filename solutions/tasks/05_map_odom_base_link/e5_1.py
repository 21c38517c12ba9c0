"""E5.1: What a localiser publishes."""

from __future__ import annotations

from tflab.core import Transform
from tflab.workbook.tasks import Pose, define_task

from .draws import draw_planar_pose, draw_sloped_pose, invert, subtract_by_component


def draw_poses(rng):
    """Draw rotated poses of laser, robot and mount: odometry without error, odom's origin below the robot, ramps."""
    same = draw_planar_pose(rng)
    pairs = [(draw_planar_pose(rng), draw_planar_pose(rng)) for _ in range(4)]
    ramps = [(draw_sloped_pose(rng), draw_planar_pose(rng)), (draw_planar_pose(rng), draw_sloped_pose(rng))]
    origin, both = (draw_planar_pose(rng), Transform()), (draw_sloped_pose(rng), draw_sloped_pose(rng))
    rows = [(*each, draw_planar_pose(rng, 0.8)) for each in (*pairs, (same, same), origin, *ramps, both)]
    rows.append((draw_planar_pose(rng), draw_planar_pose(rng), draw_sloped_pose(rng)))  # a tilted mount
    return [(map_T_base @ mount, odom_T_base, mount) for map_T_base, odom_T_base, mount in rows]


def correct_odometry(map_T_laser, odom_T_base, base_T_laser, *, mount="turned round", poses="as given",
            found="as given", wheels="turned round", order="found first", way="as asked", edge="whole"):  # fmt: skip
    """Return map_T_odom, step by step; other arguments are mistakes."""
    laser_T_base = invert(base_T_laser, mount)
    map_T_base = {"left out": map_T_laser, "in front": base_T_laser.inverse() @ map_T_laser}.get(
        mount, map_T_laser @ laser_T_base
    )
    if poses == "flat":
        map_T_base, odom_T_base = flatten(map_T_base), flatten(odom_T_base)
    left = map_T_base.inverse() if found == "turned round" else map_T_base
    right = invert(odom_T_base, wheels)
    joined = left @ right if order == "found first" else right @ left
    joined = joined.inverse() if way == "turned round" else joined
    return flatten(joined) if edge == "flat" else joined


def right_edge(map_T_base, odom_T_base):
    return map_T_base @ odom_T_base.inverse()


def flatten(pose):
    """Return x, y and yaw of a pose, as a planar map stores it."""
    x, y, _ = pose.translation
    return Transform.from_rpy(yaw=pose.rpy()[2], translation=(x, y, 0.0))


OF_THE_BASE = {
    "subtracted": subtract_by_component,
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
    "x, y and yaw subtracted": lambda map_T_base, odom_T_base: subtract_by_component(
        flatten(map_T_base), flatten(odom_T_base)
    ),
    "subtracted the other way": lambda map_T_base, odom_T_base: subtract_by_component(odom_T_base, map_T_base),
    "the robot's turn kept": lambda map_T_base, odom_T_base: Transform(
        right_edge(map_T_base, odom_T_base).translation, map_T_base.rotation
    ),
}

ANSWERS = {
    name: lambda map_T_laser, odom_T_base, base_T_laser, of_the_base=of_the_base: of_the_base(
        map_T_laser @ base_T_laser.inverse(), odom_T_base
    )
    for name, of_the_base in OF_THE_BASE.items()
} | {
    "inverses exchanged": lambda map_T_laser, odom_T_base, base_T_laser: (
        map_T_laser @ odom_T_base.inverse() @ base_T_laser.inverse()
    )
}

TASK = define_task(
    __file__,
    kind="F",
    points=4,
    answer="map_to_odom",
    form=Pose(),
    inputs=draw_poses,
    variants=3,
    model=correct_odometry,
    answers=ANSWERS,
)
