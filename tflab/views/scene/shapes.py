"""Build meshes of arrows, axes, balls and mugs, and pass them to meshcat.

Browsers draw every line one pixel wide, so whatever must be seen from afar is a mesh. The shapes
are arithmetic on arrays; only `triangles` and `grid` load meshcat.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np

from .. import style

SIDES = 8
DASHES = {"solid": 1, "dashed": 4, "dotted": 8}
FILLED = {"solid": 1.0, "dashed": 0.66, "dotted": 0.42}  # part of each dash's length that is there
LINES = {"x": "solid", "y": "dashed", "z": "dotted"}


class Triangles(NamedTuple):
    """Triangles: points, shape (n, 3) [m]; faces, shape (m, 3), indices into them; a colour for each point, (n, 3)."""

    points: np.ndarray
    faces: np.ndarray
    colours: np.ndarray


def rgb(colour: str) -> tuple[float, float, float]:
    """Return red, green, blue in [0, 1] of a colour written "#RRGGBB"."""
    return tuple(int(colour[i : i + 2], 16) / 255 for i in (1, 3, 5))


def joined(meshes: Sequence[Triangles]) -> Triangles:
    """Return several meshes as one."""
    starts = np.cumsum([0] + [len(mesh.points) for mesh in meshes[:-1]])
    return Triangles(
        np.vstack([mesh.points for mesh in meshes]),
        np.vstack([mesh.faces + start for mesh, start in zip(meshes, starts, strict=True)]),
        np.vstack([mesh.colours for mesh in meshes]),
    )


def across(direction: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return two directions of length one, at right angles to `direction` and to each other."""
    length = np.linalg.norm(direction)
    along = direction / length if length else np.array((0.0, 0.0, 1.0))
    helper = np.array((1.0, 0.0, 0.0)) if abs(along[0]) < 0.9 else np.array((0.0, 1.0, 0.0))
    side = np.cross(along, helper)
    side /= np.linalg.norm(side)
    return side, np.cross(along, side)


def bar(
    start: Sequence[float], end: Sequence[float], radius_m: float, colour: str, end_radius_m: float = -1.0
) -> Triangles:
    """Return a straight bar; with another radius at its end (0 gives a cone)."""
    start, end = np.asarray(start, dtype=float), np.asarray(end, dtype=float)
    end_radius_m = radius_m if end_radius_m < 0.0 else end_radius_m
    side, up = across(end - start)
    angle = np.linspace(0.0, 2.0 * np.pi, SIDES, endpoint=False)[:, None]
    ring = np.cos(angle) * side + np.sin(angle) * up
    points = np.vstack([start + radius_m * ring, end + end_radius_m * ring, start, end])
    first, second = 2 * SIDES, 2 * SIDES + 1  # the middles of both ends
    faces = []
    for i in range(SIDES):
        j = (i + 1) % SIDES
        faces += [(i, j, SIDES + i), (j, SIDES + j, SIDES + i), (first, j, i), (second, SIDES + i, SIDES + j)]
    return Triangles(points, np.array(faces), np.tile(rgb(colour), (len(points), 1)))


def line(
    start: Sequence[float], end: Sequence[float], radius_m: float, colour: str, style_name: str = "solid"
) -> Triangles:
    """Return a straight line, "solid", "dashed" or "dotted"."""
    start, end = np.asarray(start, dtype=float), np.asarray(end, dtype=float)
    count, filled = DASHES[style_name], FILLED[style_name]
    steps = [(i / count, (i + filled) / count) for i in range(count)]
    return joined([bar(start + a * (end - start), start + b * (end - start), radius_m, colour) for a, b in steps])


def arrow(end: Sequence[float], radius_m: float, colour: str, style_name: str = "solid") -> Triangles:
    """Return a line from the origin that ends in a cone."""
    end = np.asarray(end, dtype=float)
    length_m = float(np.linalg.norm(end))
    head_m = min(7.0 * radius_m, 0.5 * length_m)
    neck = end - (head_m / length_m if length_m else 0.0) * end
    return joined([line(np.zeros(3), neck, radius_m, colour, style_name), bar(neck, end, 2.6 * radius_m, colour, 0.0)])


def axes(length_m: float, is_ghost: bool = False) -> Triangles:
    """Return the three axes of a frame, which differ in colour and in line; a ghost's in line alone."""
    radius_m = 0.026 * length_m
    ends = {"x": (length_m, 0.0, 0.0), "y": (0.0, length_m, 0.0), "z": (0.0, 0.0, length_m)}
    colours = {axis: style.GREY if is_ghost else style.AXIS_COLOURS[axis] for axis in style.AXES}
    return joined([arrow(ends[a], radius_m, colours[a], LINES[a]) for a in style.AXES])


def polyline(points: np.ndarray, radius_m: float, colour: str, dashed: bool = False) -> Triangles:
    """Return a line through `points`, shape (n, 3); dashed leaves out every other part of it."""
    points = np.asarray(points, dtype=float)
    pieces = list(pairwise(points))
    if dashed:
        pieces = [(a, a + 0.5 * (b - a)) for a, b in pieces]
    return joined([bar(a, b, radius_m, colour) for a, b in pieces])


def ball(radius_m: float, colour: str) -> Triangles:
    """Return a ball around the origin."""
    rounded, rings = 24, 12
    turned = np.linspace(0.0, 2.0 * np.pi, rounded, endpoint=False)
    up = np.linspace(-0.5 * np.pi, 0.5 * np.pi, rings + 1)
    points = np.array([(np.cos(a) * np.cos(b), np.sin(a) * np.cos(b), np.sin(b)) for b in up for a in turned])
    here, there = np.arange(rounded), np.roll(np.arange(rounded), -1)
    faces = []
    for low in range(0, rings * rounded, rounded):
        faces.append(np.column_stack([low + here, low + there, low + rounded + there]))
        faces.append(np.column_stack([low + here, low + rounded + there, low + rounded + here]))
    return Triangles(radius_m * points, np.vstack(faces), np.tile(rgb(colour), (len(points), 1)))


def mug(height_m: float, colour: str) -> Triangles:
    """Return an upright mug, open at its top, around the origin; its handle is at -y."""
    radius_m, rounded = 0.42 * height_m, 24
    angle = np.linspace(0.0, 2.0 * np.pi, rounded, endpoint=False)
    ring = radius_m * np.column_stack([np.cos(angle), np.sin(angle), np.zeros(rounded)])
    up = np.array((0.0, 0.0, 0.5 * height_m))
    inside = np.array((0.86, 0.86, 1.0))
    points = np.vstack([ring - up, ring + up, (ring + up) * inside, (ring - 0.8 * up) * inside, [-up, -0.8 * up]])
    here, there = np.arange(rounded), np.roll(np.arange(rounded), -1)
    faces = []
    for low in (0, rounded, 2 * rounded):  # the wall outside, the rim, the wall inside
        faces += [np.column_stack([low + here, low + there, low + rounded + there])]
        faces += [np.column_stack([low + here, low + rounded + there, low + rounded + here])]
    under, bottom = 4 * rounded, 4 * rounded + 1
    faces += [np.column_stack([there, here, np.full(rounded, under)])]
    faces += [np.column_stack([3 * rounded + here, 3 * rounded + there, np.full(rounded, bottom)])]
    light = 0.78 + 0.22 * np.cos(angle + 2.2)  # nothing is shaded in a scene: its roundness is in its colours
    shades = np.concatenate([light, light, 0.75 * light[::-1], 0.55 * light, [0.5, 0.6]])
    turn = np.linspace(-0.5 * np.pi, 0.5 * np.pi, 9)
    bow = 0.3 * height_m * np.column_stack([np.zeros(9), -np.cos(turn), np.sin(turn)])
    body = Triangles(points, np.vstack(faces), shades[:, None] * np.array(rgb(colour)))
    return joined([body, polyline(bow - (0.0, 0.92 * radius_m, 0.0), 0.055 * height_m, colour)])


def frustum(half_width_m: float, half_height_m: float, depth_m: float, radius_m: float, colour: str) -> Triangles:
    """Return the four edges of what a camera sees, and the rim of its image plane.

    The camera looks along z, x is to the right in the image and y down (REP-103's
    suffix `_optical`).
    """
    w, h, d = half_width_m, half_height_m, depth_m
    corners = np.array([(-w, -h, d), (w, -h, d), (w, h, d), (-w, h, d)])
    edges = [bar((0.0, 0.0, 0.0), corner, radius_m, colour) for corner in corners]
    rim = [bar(corners[i], corners[(i + 1) % 4], radius_m, colour) for i in range(4)]
    return joined(edges + rim)


GRID_COLOUR = "#8C9196"
GRID_OPACITY = 0.45


def triangles(mesh: Triangles, opacity: float = 1.0) -> tuple[Any, Any]:
    """Return a mesh as meshcat wants it: its geometry, and a material without shading."""
    from meshcat.geometry import MeshBasicMaterial, TriangularMeshGeometry

    return (
        TriangularMeshGeometry(mesh.points, mesh.faces, mesh.colours),
        MeshBasicMaterial(vertexColors=True, opacity=opacity, depthWrite=opacity == 1.0),
    )


def grid(step_m: float = 1.0, cells: int = 10) -> Any:
    """Return the ground: a square of `cells` by `cells` squares around the origin, each `step_m` [m] wide.

    A line goes along one square: of one that began behind the camera, some drivers draw nothing at all.
    """
    from meshcat.geometry import LineBasicMaterial, LineSegments, PointsGeometry

    half = 0.5 * cells * step_m
    at = np.linspace(-half, half, cells + 1)
    along = [((x, y0, 0.0), (x, y1, 0.0)) for x in at for y0, y1 in pairwise(at)]
    ends = along + [tuple((y, x, z) for x, y, z in line) for line in along]
    material = LineBasicMaterial(color=int(GRID_COLOUR[1:], 16), opacity=GRID_OPACITY)
    return LineSegments(PointsGeometry(np.array(ends, np.float32).reshape(-1, 3).T), material)
