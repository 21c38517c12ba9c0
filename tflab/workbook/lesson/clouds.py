"""What does a depth camera see?  A wall 2 m ahead, and the floor before it, in the camera's own axes.

```
optical frame: x right, y down, z forward
wall_cloud()    273 points, 2 m ahead
floor_cloud()   252 points, 0.4 m below
```
"""

from __future__ import annotations

import numpy as np

__all__ = ["floor_cloud", "wall_cloud"]


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
