"""How do triangles and lines reach meshcat?  As its geometry and its material.

    triangles(mesh)     what is drawn        colours of each point, and no shading: they stay true
    grid(step_m)        the ground           lines, at z = 0

meshcat is loaded only when something is drawn.
"""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import numpy as np

from .shapes import Triangles

__all__ = ["grid", "triangles"]

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
