"""Do the numbers of a quaternion hold the angles of the right turn?  Then somebody took `.rpy()` for it.

    asked for  (0, 0, 0.479, 0.878)     given  (0, 0, 1, 1)     z is the yaw, in radians

Whatever stands in w.
"""

from __future__ import annotations

from collections.abc import Sequence

from ...core.quaternions import to_rpy
from ...text import Text

__all__ = ["ANGLES", "holds_angles"]

TINY = 1e-6
ANGLES = Text(
    en="x, y and z are the angles of the right turn, roll, pitch and yaw. The four numbers of a quaternion are no "
    "angles: of a Transform they are in `.rotation`.",
    ko="x, y, z에 올바른 회전의 각도 roll, pitch, yaw가 들어 있습니다. 쿼터니언의 숫자 네 개는 각도가 아닙니다. "
    "Transform의 쿼터니언은 `.rotation`에 있습니다.",
)


def holds_angles(given: Sequence[float], wanted: Sequence[float]) -> bool:
    """Return whether the first three numbers are roll, pitch and yaw of the turn that is wanted, and not all 0."""
    angles = to_rpy(wanted)
    return any(angles) and all(abs(one - other) < TINY for one, other in zip(given, angles, strict=False))
