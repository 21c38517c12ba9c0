"""Draw a wrong position or pose beside the right one.

    yours      hatched ghost
    expected   solid

Only answers that are somewhere in space can be drawn: points, poses, poses in the
plane, messages that hold one of these, and dicts of them, of which the first wrong
one is drawn.  And only where the right one is open, and another: two that lie on each
other say nothing of names that were exchanged.
"""

from __future__ import annotations

import numpy as np

from tflab.core import Transform
from tflab.views.frames import draw_scene
from tflab.views.picture import Picture

from ..answers.form import inside, member, numbers_of, pose_of
from ..answers.forms import Form, Message, Parts, Pose, Vector
from ..answers.values import Plain

__all__ = ["picture_of"]

NEAREST = 1e-6  # two poses whose matrices differ by less look the same
FARTHEST_M = 1e4  # beyond that there is nothing to see


def picture_of(form: Form, answer: Plain, expected: Plain) -> Picture | None:
    """Return both drawn together, or None if there is nothing to draw."""
    if isinstance(form, Parts):
        return _draw_parts(form, answer, expected)
    if isinstance(form, Pose):
        return _poses(_transform(answer), _transform(expected))
    if isinstance(form, Message):
        return _draw_message(form, answer, expected)
    if isinstance(form, Vector) and form.size == 3 and form.unit == "m":
        return _points(form.frame, answer, expected)
    return None


def _draw_parts(form: Parts, answer: Plain, expected: Plain) -> Picture | None:
    """Draw a pose in the plane, or the first wrong part that can be drawn."""
    if "yaw" in form.parts:
        return _poses(_planar(answer), _planar(expected))
    for name, part in form.parts.items():
        yours, right = _part(answer, name), _part(expected, name)
        if not part.same(yours, right) and (picture := picture_of(part, yours, right)) is not None:
            return picture
    return None


def _draw_message(form: Message, answer: Plain, expected: Plain) -> Picture | None:
    """Draw a TransformStamped, or a PointStamped in the frame that is expected."""
    if form.type.endswith("/TransformStamped"):
        return _poses(_transform(answer), _transform(expected))
    if form.type.endswith("/PointStamped"):
        frame = member(expected, "header", "frame_id")
        return _points(frame, member(answer, "point"), member(expected, "point"))
    return None


def _part(plain: Plain, name: str) -> Plain:
    parts = inside(plain)
    return parts.get(name) if isinstance(parts, dict) else None


def _poses(yours: Transform | None, right: Transform | None) -> Picture | None:
    if yours is None or right is None or np.allclose(yours.matrix(), right.matrix(), rtol=0.0, atol=NEAREST):
        return None
    return draw_scene({"expected": right}, ghosts={"yours": yours}, fixed_frame="the parent")


def _points(frame: Plain, answer: Plain, expected: Plain) -> Picture | None:
    yours, right = numbers_of(answer, 3), numbers_of(expected, 3)
    if yours is None or right is None or max(map(abs, yours)) > FARTHEST_M or np.allclose(yours, right, atol=NEAREST):
        return None
    name = frame if isinstance(frame, str) and frame else "origin"
    return draw_scene({name: Transform()}, {"expected": right}, ghost_points={"yours": yours}, fixed_frame=name)


def _planar(plain: Plain) -> Transform | None:
    """Return a pose in the plane: x, y and yaw, or a position and yaw."""
    place = numbers_of(_part(plain, "position"), 2)
    if place is None:
        x, y = (numbers_of(_part(plain, name), None) for name in ("x", "y"))
        place = (*x, *y) if x is not None and y is not None else None
    yaw = numbers_of(_part(plain, "yaw"), None)
    if place is None or len(place) != 2 or yaw is None or len(yaw) != 1 or max(map(abs, (*place, *yaw))) > FARTHEST_M:
        return None
    return Transform.from_rpy(yaw=yaw[0], translation=(*place, 0.0))


def _transform(plain: Plain) -> Transform | None:
    parts = pose_of(plain)
    if parts is None or sum(number * number for number in parts[3]) < 1e-6:
        return None
    if max(map(abs, parts[2])) > FARTHEST_M:
        return None
    return Transform(parts[2], parts[3])
