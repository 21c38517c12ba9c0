"""Draw the teaching robot in its room, and give the point clouds of its camera.

```
show_drive()                   the robot, its laser and the walls in 3D, second by second
draw_room(at_s=12.0)           the same from above, as a figure
scan_on_map(robot, at_s=1.0)   where the robot's model puts what its laser measured
show_latency()                 a ball that was seen a moment ago, drawn with the current pose
wall_cloud(), floor_cloud()    273 points 2 m ahead, 252 points 0.4 m below, in the optical frame
```
"""

from __future__ import annotations

import numpy as np

from tflab.core import NSEC_PER_SEC, Transform, seconds
from tflab.robots.model import link_poses
from tflab.robots.motion import Drive
from tflab.robots.sensors import ROOM
from tflab.robots.teaching import TeachingRobot
from tflab.tools.rviz import links_to_see
from tflab.views import style
from tflab.views.frames import clear_paper, draw_frames
from tflab.views.map_error import describe_placed
from tflab.views.motion_error import drive
from tflab.views.picture import Picture
from tflab.views.projection import FROM_ABOVE, RobotArtists
from tflab.views.scene import Scene, draw_arrow, draw_ball, draw_frame, draw_path, draw_robot, draw_scan
from tflab.views.scene.drawing import ACCENT

GRID_CELLS = 16  # of a metre, from -8 m to 8 m: the ground of the whole room
DOT_M = 0.14  # where a ray ends: as wide as a wall is drawn
EVERY_RAY = 4  # of the laser's: enough to see the walls
WALL_COLOUR = "#808890"
STEP_S = 0.25
STRAIGHT_S = 2.0  # the drive begins to be seen here, where ahead is to be seen: it goes straight on for five seconds


def show_drive(for_s: float = 24.0) -> Scene:
    """Return a scene to be played: the robot drives for `for_s` [s], and its laser looks round."""
    robot = TeachingRobot(Drive(start_ns=0))
    scene = Scene(grid_cells=GRID_CELLS)
    scene.look((0.4, -5.2, 4.2), (2.6, -0.3, 0.0))
    draw_walls(scene)
    draw_frame(scene, "map", Transform(), length_m=0.8)

    def draw(moment_s: float) -> None:
        stamp_ns = round(moment_s * NSEC_PER_SEC)
        poses = robot.truth_at(stamp_ns)
        scan = robot.laser.scan_at(stamp_ns)
        draw_body(scene, robot, stamp_ns)
        draw_frame(scene, "base_link", poses["base_link"], "map", length_m=0.5)
        draw_frame(scene, "laser_frame", poses["laser_frame"], "base_link", length_m=0.3)
        few = scan.ranges[::EVERY_RAY]
        rays = (few, scan.angle_min, scan.angle_increment * EVERY_RAY)
        draw_scan(scene, "scan", poses["laser_frame"], *rays, size_m=DOT_M)

    moments_s = np.arange(0.0, for_s + STEP_S, STEP_S).tolist()
    scene.sweep("time", moments_s, draw, unit="s", start=min(round(STRAIGHT_S / STEP_S), len(moments_s) - 1))
    return scene


def draw_body(scene: Scene, robot: TeachingRobot, stamp_ns: int) -> None:
    """Draw a robot's body into a scene, where it truly is at a stamp."""
    draw_robot(scene, "robot", links_to_see(robot.urdf), robot.truth_at(stamp_ns))


def draw_room(at_s: float) -> Picture:
    """Draw the room from above, the robot in it, and what its laser measured at `at_s` [s] of the drive."""
    robot = TeachingRobot(Drive(start_ns=0))
    stamp_ns = round(at_s * NSEC_PER_SEC)
    poses = robot.truth_at(stamp_ns)
    points = poses["laser_frame"].apply(robot.laser.scan_at(stamp_ns).points())
    picture = Picture((4.9, 3.4))
    with style.our_settings():
        ax = clear_paper(picture.figure.add_axes((0.11, 0.15, 0.86, 0.82)))
        ax.set_axis_on()
        style.name_plane(ax, "map")
        ax.set(xlim=(-2.3, 8.3), ylim=(-3.3, 3.3))
        for wall in np.asarray(ROOM.walls, dtype=float):
            ax.plot(*wall.T, color=style.FAINT, linewidth=3.0, zorder=1, solid_capstyle="round")
        hit = points[np.isfinite(points).all(axis=1)]
        ax.plot(*hit[::EVERY_RAY, :2].T, "o", color=style.ACCENT, markersize=2.6, markeredgewidth=0.0, zorder=8)
        for point in hit[:: 6 * EVERY_RAY]:
            ax.plot(*np.array((poses["laser_frame"].translation, point))[:, :2].T, color=style.FAINT, linewidth=0.5)
        RobotArtists(ax, FROM_ABOVE, scale=1.6).move(poses["base_link"])
        draw_frames(ax, {"map": Transform(), "base_link": poses["base_link"]}, FROM_ABOVE, length_m=0.7)
    picture.text = describe_placed({f"laser scan at {at_s:.0f} s, on the map": points}, walls=ROOM.walls)
    return picture


def scan_on_map(robot: TeachingRobot, at_s: float) -> np.ndarray:
    """Return where a scan of `at_s` [s] comes to lie on the map, shape (n, 3) [m].

    The robot is where it truly is; its laser is where the drawing says, screwed on as it may be.
    """
    stamp_ns = seconds(at_s)
    map_T_laser = robot.truth_at(stamp_ns)["base_footprint"] @ link_poses(robot.model)["laser_frame"]
    return map_T_laser.apply(robot.laser.scan_at(stamp_ns).points())


def show_latency(speed_mps: float = 1.0, yaw_rate_radps: float = 0.5, range_m: float = 5.0) -> Scene:
    """Return a scene to be moved by the delay: the ball that a robot saw, and where its pose of now puts it."""
    seen_at = (range_m, 0.0, 0.3)
    scene = Scene()
    scene.look((1.0, -5.2, 3.2), (2.1, 0.4, 0.0))

    def draw(delay_s: float) -> None:
        then_T_now = drive(speed_mps, yaw_rate_radps, seconds(delay_s))
        drawn_at = then_T_now.apply(seen_at)
        draw_frame(scene, "robot at the stamp", Transform())
        draw_frame(scene, "robot now", then_T_now, is_ghost=True)
        draw_ball(scene, "ball", seen_at, colour=style.GREY)
        draw_arrow(scene, "sight", then_T_now.translation, drawn_at, radius_m=0.01)
        draw_arrow(scene, "error", seen_at, drawn_at, "error", ACCENT, radius_m=0.04)

    scene.sweep("delay", [0.05 * i for i in range(11)], draw, "s", start=4)
    return scene


def draw_walls(scene: Scene) -> None:
    """Draw the walls of the room into a scene, as lines a hand above the floor."""
    for i, wall in enumerate(ROOM.walls):
        draw_path(scene, f"walls/{i}", np.array([(*end, 0.2) for end in wall]), colour=WALL_COLOUR, radius_m=0.04)


def wall_cloud() -> np.ndarray:
    """Return points of a wall, 2 m wide, in the optical frame [m], shape (n, 3)."""
    right, down = _grid(np.linspace(-1.0, 1.0, 21), np.linspace(-0.8, 0.4, 13))
    return np.column_stack([right, down, np.full(right.size, 2.0)])


def floor_cloud() -> np.ndarray:
    """Return points of the floor between camera and wall, in the optical frame [m], shape (n, 3)."""
    right, forward = _grid(np.linspace(-1.0, 1.0, 21), np.linspace(0.8, 1.9, 12))
    return np.column_stack([right, np.full(right.size, 0.4), forward])


def _grid(one: np.ndarray, other: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return both coordinates of each point of a grid."""
    first, second = np.meshgrid(one, other)
    return first.ravel(), second.ravel()
