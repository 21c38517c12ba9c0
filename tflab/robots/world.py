"""What is there to see?  A room with walls, and a ray that finds the nearest one.

       y
     3 +--------------------+
       |            [crate] |        ray: origin + distance * direction
       |      []            |        wall: a segment of the floor plan, 2 m high
       |    pillar      o   |
    -3 +--------------ball--+ x
      -2                    8

Walls are upright and stand on a floor at z = 0, so a laser that is mounted
level sees a floor plan, and one that is tilted sees the floor where it should see
a wall.  All coordinates are in `map`.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from tflab.core.quaternions import Vector3

__all__ = ["BALL", "ROOM", "Room", "rectangle"]

Point2 = tuple[float, float]
Wall = tuple[Point2, Point2]

PARALLEL = 1e-12  # below this, a ray runs along a wall and does not hit it


def rectangle(x_min: float, y_min: float, x_max: float, y_max: float) -> tuple[Wall, ...]:
    """Return four walls around a rectangle [m]."""
    corners = ((x_min, y_min), (x_max, y_min), (x_max, y_max), (x_min, y_max))
    return tuple(zip(corners, (*corners[1:], corners[0]), strict=True))


@dataclass(frozen=True, slots=True)
class Room:
    """Walls on a floor.

    Attributes:
        walls: each from a point (x, y) to another [m].
        height: of all walls [m]; there is no ceiling.
    """

    walls: tuple[Wall, ...]
    height: float = 2.0

    def distances(self, origins: np.ndarray, directions: np.ndarray) -> np.ndarray:
        """Return how far each ray goes before it meets a wall or the floor; inf if it meets nothing.

        Args:
            origins: shape (N, 3) [m], above the floor.
            directions: shape (N, 3), of length one.

        Returns:
            shape (N,) [m].
        """
        begin, end = np.array(self.walls)[:, 0], np.array(self.walls)[:, 1]
        along = end - begin  # shape (M, 2)
        dx, dy = directions[:, 0:1], directions[:, 1:2]  # shape (N, 1), against M walls
        to_x, to_y = begin[:, 0] - origins[:, 0:1], begin[:, 1] - origins[:, 1:2]
        # origin + distance * direction = begin + share * along, solved by Cramer's rule
        determinant = dx * along[:, 1] - dy * along[:, 0]
        with np.errstate(divide="ignore", invalid="ignore"):
            distance = (to_x * along[:, 1] - to_y * along[:, 0]) / determinant
            share = (to_x * dy - to_y * dx) / determinant
            floor = np.where(directions[:, 2] < 0.0, -origins[:, 2] / directions[:, 2], np.inf)
            height = origins[:, 2:3] + distance * directions[:, 2:3]
        is_hit = (np.abs(determinant) > PARALLEL) & (distance > 0.0) & (share >= 0.0) & (share <= 1.0)
        is_hit &= (height >= 0.0) & (height <= self.height)
        nearest = np.where(is_hit, distance, np.inf).min(axis=1)
        return np.minimum(nearest, floor)

    def cells(self, resolution_m: float = 0.05) -> tuple[np.ndarray, tuple[float, float]]:
        """Return the floor plan as a grid of cells, row by row from the lower left corner: true where a wall is.

        Returns:
            shape (height, width), and where its corner is: (x, y) [m].
        """
        ends = np.array(self.walls)  # shape (M, 2, 2)
        corner = ends.min(axis=(0, 1)) - 1.5 * resolution_m  # walls lie in the middle of cells, with one more around
        width, height = np.ceil((ends.max(axis=(0, 1)) - corner) / resolution_m - 1e-6).astype(int) + 1
        grid = np.zeros((height, width), dtype=bool)
        for begin, end in ends:
            steps = int(np.ceil(np.abs(end - begin).max() / resolution_m * 2)) + 1
            columns, rows = ((np.linspace(begin, end, steps) - corner) // resolution_m).astype(int).T
            grid[rows, columns] = True
        return grid, (float(corner[0]), float(corner[1]))

    def is_in_sight(self, eye: Sequence[float], point: Sequence[float]) -> bool:
        """Return whether nothing stands between two points [m]."""
        way = np.subtract(point, eye)
        length = float(np.linalg.norm(way))
        if length == 0.0:
            return True
        return float(self.distances(np.array([eye], dtype=float), np.array([way / length]))[0]) >= length


ROOM = Room(
    walls=(
        *rectangle(-2.0, -3.0, 8.0, 3.0),
        *rectangle(2.3, -0.2, 2.7, 0.2),  # the pillar that the lap goes around
        *rectangle(6.0, 1.6, 6.8, 2.2),  # a crate
    )
)
BALL: Vector3 = (6.5, -1.5, 0.30)  # what the camera looks for, in map [m]
