"""Draw frames, scans, cameras and robots into a 3D scene.

    draw_frame(scene, "base_link", map_T_base)           three axes and a name
    draw_scan, draw_points, draw_path, draw_arrow        what sensors and planners publish
    draw_camera                                          what a camera sees, and its image plane
    draw_ball, draw_mug                                  something to be seen
    draw_robot                                           links, from boxes, cylinders, spheres
    draw_frame, draw_path with is_ghost=True             the wrong answer: grey, translucent

All poses and points are in the scene's own frame. Drawing the same path again moves what is there.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import numpy as np

from tflab.core import Transform

from .. import style
from . import shapes
from .shapes import triangles
from .widget import Scene

IDENTITY = Transform()
IMAGE_PX, FOCAL_PX = (640, 480), 525.0  # of a camera
GHOST_OPACITY = 0.28
BALL_M, BALL_OPACITY = 0.3, 0.5
ACCENT = "#B5539B"  # style.ACCENT, in a shade that stands out on a light and on a dark page


@dataclass(frozen=True, slots=True)
class Part:
    """A piece of a robot's link.

    Attributes:
        shape: "box", "cylinder" (its axis along z) or "sphere".
        size: of a box (x, y, z), of a cylinder (radius, length), of a sphere (radius,) [m].
        link_T_part: where it is on its link.
        rgba: its colour, each in [0, 1].
    """

    shape: str
    size: tuple[float, ...]
    link_T_part: Transform = IDENTITY
    rgba: tuple[float, float, float, float] = (0.62, 0.65, 0.69, 1.0)


def draw_frame(
    scene: Scene,
    name: str,
    scene_T_frame: Transform,
    parent: str = "",
    length_m: float = 0.4,
    is_ghost: bool = False,
) -> None:
    """Draw a frame: its axes, their letters, and its name."""
    path = scene[frame_path(name, is_ghost)]
    path.set_object(*triangles(_axes(length_m, is_ghost), GHOST_OPACITY * 2 if is_ghost else 1.0))
    path.set_transform(scene_T_frame.matrix())
    label = _label(name, (0.0, 0.0, 0.0), style.GREY if is_ghost else "", name=True, slanted=is_ghost)
    path.set_property("labels", [*_axis_letters(length_m, is_ghost), label])
    path.set_property("frame", {"name": name, "parent": parent, "ghost": is_ghost})


def draw_arrow(
    scene: Scene,
    path: str,
    start: Sequence[float],
    end: Sequence[float],
    name: str = "",
    colour: str = style.GREY,
    radius_m: float = 0.01,
) -> None:
    """Draw an arrow between two points (x, y, z) [m], its name beside the middle; of no length, it vanishes."""
    start, end = np.asarray(start, dtype=float), np.asarray(end, dtype=float)
    length_m = float(np.linalg.norm(end - start))
    if length_m < 4.0 * radius_m:
        scene[path].delete()
        return
    scene[path].set_object(*triangles(_arrow_along_x(round(length_m, 6), radius_m, colour)))
    scene[path].set_transform(_x_along(start, end))
    if name:
        beside = {"along": [length_m, 0.0, 0.0]}  # the name keeps clear of the line from the origin to there
        scene[path].set_property("labels", [_label(name, (0.5 * length_m, 0.0, 0.0), colour) | beside])
        scene[path].set_property("words", f"arrow from {style.fmt_all(start)} to {style.fmt_all(end)}")


def draw_ball(scene: Scene, path: str, at: Sequence[float], colour: str = ACCENT) -> None:
    """Draw a ball around a point (x, y, z) [m], through which one sees what ends there, and its name above it."""
    scene[path].set_object(*triangles(shapes.ball(BALL_M, colour), BALL_OPACITY))
    _place_thing(scene, path, at, _label("ball", (0.0, 0.0, 1.6 * BALL_M), colour))


def draw_mug(scene: Scene, path: str, at: Sequence[float], name: str = "mug", height_m: float = 0.2) -> None:
    """Draw an upright mug whose middle is at a point (x, y, z) [m], and its name above it."""
    scene[path].set_object(*triangles(shapes.mug(height_m, ACCENT)))
    _place_thing(scene, path, at, _label(name, (0.0, 0.0, height_m), ACCENT))


def _place_thing(scene: Scene, path: str, at: Sequence[float], label: dict) -> None:
    """Put what was drawn at a point (x, y, z) [m], with its label."""
    scene[path].set_transform(Transform(at).matrix())
    scene[path].set_property("labels", [label])
    scene[path].set_property("words", f"{label['text']} at {style.fmt_all(at)}")


def draw_path(
    scene: Scene, path: str, points: np.ndarray, colour: str = ACCENT, radius_m: float = 0.015, is_ghost: bool = False
) -> None:
    """Draw a line through `points`, shape (n, 3) [m]; a ghost is grey and dashed."""
    mesh = shapes.polyline(points, radius_m, style.GREY if is_ghost else colour, dashed=is_ghost)
    scene[path].set_object(*triangles(mesh, GHOST_OPACITY * 2 if is_ghost else 1.0))
    scene[path].set_property("words", f"{'ghost path' if is_ghost else 'path'}, {len(points)} points")


def draw_points(
    scene: Scene,
    path: str,
    points: np.ndarray,
    colour: str | np.ndarray = ACCENT,
    size_m: float = 0.05,
    words: str = "point cloud",
) -> None:
    """Draw `points`, shape (n, 3) [m], in one colour or in n of them, shape (n, 3), each in [0, 1]."""
    from meshcat.geometry import Points, PointsGeometry, PointsMaterial

    points = np.asarray(points, dtype=np.float32).reshape(-1, 3)
    colours = shapes.rgb(colour) if isinstance(colour, str) else colour
    colours = np.broadcast_to(np.asarray(colours, dtype=np.float32), points.shape)
    scene[path].set_object(Points(PointsGeometry(points.T, colours.T), PointsMaterial(size=size_m)))
    scene[path].set_property("words", f"{words}, {len(points)} points")


def draw_scan(
    scene: Scene,
    path: str,
    scene_T_scan: Transform,
    ranges_m: np.ndarray,
    angle_min_rad: float,
    angle_increment_rad: float,
    colour: str = ACCENT,
    size_m: float = 0.06,
) -> None:
    """Draw a laser scan: its points, and faintly what it has swept; rays that hit nothing (inf, nan) are left out."""
    ranges_m = np.asarray(ranges_m, dtype=float)
    angles = angle_min_rad + angle_increment_rad * np.arange(len(ranges_m))
    hit = np.isfinite(ranges_m)
    reach_m = np.where(hit, ranges_m, 0.0)
    scan_p_hits = np.column_stack([reach_m * np.cos(angles), reach_m * np.sin(angles), np.zeros(len(reach_m))])
    with scene.redraw():
        scene[path].set_transform(scene_T_scan.matrix())
        draw_points(scene, f"{path}/points", scan_p_hits[hit], colour, size_m, "laser scan")
        scene[f"{path}/swept"].set_object(*triangles(_fan(scan_p_hits, hit, colour), 0.10))


def draw_camera(
    scene: Scene, path: str, scene_T_optical: Transform, depth_m: float = 0.6, pixels: np.ndarray | None = None
) -> None:
    """Draw what a camera sees, down to an image plane at `depth_m`, and on it `pixels` (u, v), shape (n, 2).

    `scene_T_optical` is the pose of its *optical* frame: z forward, x right, y down.
    """
    width_px, height_px = IMAGE_PX
    half_w, half_h = depth_m * width_px / FOCAL_PX / 2.0, depth_m * height_px / FOCAL_PX / 2.0
    camera = scene[path]
    with scene.redraw():
        camera.set_transform(scene_T_optical.matrix())
        camera["rim"].set_object(*triangles(shapes.frustum(half_w, half_h, depth_m, 0.008 * depth_m, ACCENT)))
        camera["image"].set_object(*triangles(_image_plane(half_w, half_h, depth_m, ACCENT), 0.16))
        camera["image"].set_property("labels", [
            _label("u", (half_w * 0.1, -half_h * 1.18, depth_m), ACCENT, small=True),
            _label("v", (-half_w * 1.18, half_h * 0.1, depth_m), ACCENT, small=True),
        ])  # fmt: skip
        camera.set_property("words", f"camera, {width_px} x {height_px} pixels, image plane at {depth_m:.2f} m")
        if pixels is not None:
            centred = (np.asarray(pixels, dtype=float).reshape(-1, 2) - (width_px / 2.0, height_px / 2.0)) / FOCAL_PX
            points = np.column_stack([centred * depth_m, np.full(len(centred), depth_m)])
            draw_points(scene, f"{path}/pixels", points, ACCENT, 0.05 * depth_m, "pixels")


def draw_robot(scene: Scene, path: str, links: Mapping[str, Sequence[Part]], poses: Mapping[str, Transform]) -> None:
    """Draw each link that has a pose, from its parts, and take away each that has none."""
    with scene.redraw():
        for name, parts in links.items():
            link = scene[f"{path}/{_bare(name)}"]
            if name not in poses:
                link.delete()
                continue
            link.set_transform(poses[name].matrix())
            for i, part in enumerate(parts):
                _draw_part(link[f"part{i}"], part)
        drawn = sum(name in poses for name in links)
        scene[path].set_property("words", f"robot, {drawn} of {len(links)} links")


def frame_path(name: str, is_ghost: bool = False) -> str:
    """Return where a frame is in the scene's tree; frames stand side by side there, whoever is whose parent."""
    return f"{'ghosts' if is_ghost else 'frames'}/{_bare(name)}"


def edge_path(child: str) -> str:
    """Return where the arrow between a frame and its parent is in the scene's tree."""
    return f"edges/{_bare(child)}"


def _draw_part(place: Any, part: Part) -> None:
    from meshcat.geometry import MeshLambertMaterial

    geometry, part_T_geometry = _geometry(part)
    place.set_transform(part.link_T_part.matrix() @ part_T_geometry)
    red, green, blue, alpha = part.rgba
    colour = (round(255 * red) << 16) + (round(255 * green) << 8) + round(255 * blue)
    place["fill"].set_object(geometry, MeshLambertMaterial(color=colour, opacity=alpha, depthWrite=alpha == 1.0))


def _geometry(part: Part) -> tuple[Any, np.ndarray]:
    """Return meshcat's geometry for a part, and how to turn it: three.js has a cylinder's axis along y, ROS along z."""
    from meshcat.geometry import Box, Cylinder, Sphere

    upright = Transform.from_rpy(roll=np.pi / 2.0).matrix()
    if part.shape == "box":
        return Box(list(part.size)), np.eye(4)
    if part.shape == "cylinder":
        radius_m, length_m = part.size
        return Cylinder(length_m, radius_m), upright
    if part.shape == "sphere":
        return Sphere(part.size[0]), np.eye(4)
    raise ValueError(f'a part is a "box", a "cylinder" or a "sphere", not a "{part.shape}"')


@lru_cache(16)
def _axes(length_m: float, is_ghost: bool) -> shapes.Triangles:
    return shapes.axes(length_m, is_ghost)


@lru_cache(256)
def _arrow_along_x(length_m: float, radius_m: float, colour: str) -> shapes.Triangles:
    """Return an arrow in a frame of its own, so that one that only moves need not be sent again."""
    return shapes.arrow((length_m, 0.0, 0.0), radius_m, colour)


def _x_along(start: np.ndarray, end: np.ndarray) -> np.ndarray:
    """Return the pose, shape (4, 4), at `start` whose x points to `end`."""
    pose = np.eye(4)
    pose[:3, 0] = (end - start) / np.linalg.norm(end - start)
    pose[:3, 1], pose[:3, 2] = shapes.across(end - start)
    pose[:3, 3] = start
    return pose


def _fan(points: np.ndarray, hit: np.ndarray, colour: str) -> shapes.Triangles:
    """Return the triangles between the sensor and each two neighbouring hits."""
    both = np.flatnonzero(hit[:-1] & hit[1:]) + 1
    corners = np.vstack([np.zeros((1, 3)), np.where(hit[:, None], points, 0.0)])
    faces = np.column_stack([np.zeros_like(both), both, both + 1])
    return shapes.Triangles(corners, faces, np.tile(shapes.rgb(colour), (len(corners), 1)))


def _image_plane(half_w: float, half_h: float, depth: float, colour: str) -> shapes.Triangles:
    signs = np.array([(-1, -1, 1), (1, -1, 1), (1, 1, 1), (-1, 1, 1)])
    corners = signs * (half_w, half_h, depth)
    return shapes.Triangles(corners, np.array([(0, 1, 2), (0, 2, 3)]), np.tile(shapes.rgb(colour), (4, 1)))


def _axis_letters(length_m: float, is_ghost: bool) -> list[dict]:
    tips = {"x": (1.1, 0.0, 0.0), "y": (0.0, 1.1, 0.0), "z": (0.0, 0.0, 1.1)}
    colours = {axis: style.GREY if is_ghost else style.AXIS_COLOURS[axis] for axis in style.AXES}
    return [_label(axis, np.array(tips[axis]) * length_m, colours[axis], small=True) for axis in style.AXES]


def _label(
    text: str, at: Sequence[float], colour: str, small: bool = False, name: bool = False, slanted: bool = False
) -> dict:
    """Return a piece of writing for scene.js; without a colour it has the page's own."""
    at = [float(value) for value in at]
    return {"text": text, "at": at, "colour": colour, "small": small, "name": name, "slanted": slanted}


def _bare(name: str) -> str:
    """Return a frame's name as one step of a path."""
    return name.replace("/", "|")
