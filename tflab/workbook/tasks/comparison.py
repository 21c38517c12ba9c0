"""Where did my answer go?  A wrong place or pose, drawn as a ghost beside the right one.

    yours      hatched ghost
    expected   solid

Only answers that are somewhere in space can be drawn, and only where the right
one is open.  Read `blank.py` next.
"""

from __future__ import annotations

from tflab.core import Transform
from tflab.views.frames import draw_scene
from tflab.views.picture import Picture

from ..answers import sealed
from ..answers.form import numbers_of, pose_of
from ..answers.forms import Form, Pose, Vector
from ..answers.values import Plain

__all__ = ["picture_of"]

FARTHEST_M = 1e4  # beyond that there is nothing to see


def picture_of(form: Form, answer: Plain, expected: Plain) -> Picture | None:
    """Return both drawn together, or None if there is nothing to draw."""
    if sealed.is_sealed(expected):
        return None
    if isinstance(form, Pose):
        yours, right = _transform(answer), _transform(expected)
        if yours is None or right is None:
            return None
        return draw_scene({"expected": right}, ghosts={"yours": yours}, fixed_frame="the parent")
    if isinstance(form, Vector) and form.size == 3 and form.unit == "m":
        yours, right = numbers_of(answer, 3), numbers_of(expected, 3)
        if yours is None or right is None or max(map(abs, yours)) > FARTHEST_M:
            return None
        frame = form.frame or "origin"
        return draw_scene({frame: Transform()}, {"expected": right}, ghost_points={"yours": yours}, fixed_frame=frame)
    return None


def _transform(plain: Plain) -> Transform | None:
    parts = pose_of(plain)
    if parts is None or sum(number * number for number in parts[3]) < 1e-6:
        return None
    if max(map(abs, parts[2])) > FARTHEST_M:
        return None
    return Transform(parts[2], parts[3])
