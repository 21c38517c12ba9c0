"""Do the numbers of a quaternion hold the angles of the right turn?  Then somebody took `.rpy()` for it.

    asked for  (0, 0, 0.479, 0.878)     given  (0, 0, 1, 1)     z is the yaw, in radians

Whatever stands in w.
"""

from __future__ import annotations

from collections.abc import Sequence

from ...core.quaternions import to_rpy

__all__ = ["holds_angles"]

TINY = 1e-6


def holds_angles(given: Sequence[float], wanted: Sequence[float]) -> bool:
    """Return whether the first three numbers are roll, pitch and yaw of the turn that is wanted, and not all 0."""
    angles = to_rpy(wanted)
    return any(angles) and all(abs(one - other) < TINY for one, other in zip(given, angles, strict=False))
