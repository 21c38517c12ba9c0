"""Where was everything at that moment?  The frames in 3D: from a corner, and from above.

    finding --a link--> #moment-2 --> the tree as it was then: three axes a frame, a line to its parent

Each frame is placed by its parents' transforms that were heard last before the
moment, as an impatient listener would.  The projection is orthographic, and drawn
here: a report runs no script.  Read `html.py` next.
"""

from __future__ import annotations

from html import escape

import numpy as np

from tflab.core import Transform

from ..evidence import Edge, Evidence

__all__ = ["draw_frames_at", "poses_at"]

MOST_FRAMES = 80
WIDTH, HEIGHT, RADIUS = 460.0, 340.0, 130.0  # px
CORNER, ABOVE = (-0.6, 0.5), (0.0, np.pi / 2)  # yaw and pitch of the eye [rad]
LEAST_SIZE_M = 0.3
ARM = 0.14  # of the size of what is shown


def draw_frames_at(evidence: Evidence, moment_ns: int) -> str:
    """Return the frames as they were at a moment, seen from a corner and from above, as SVG."""
    poses = poses_at(evidence, moment_ns)
    return _view(evidence, poses, CORNER, "from a corner") + _view(evidence, poses, ABOVE, "from above")


def poses_at(evidence: Evidence, moment_ns: int) -> dict[str, Transform]:
    """Return root_T_frame of each frame at a moment, parents before children."""
    edges = {edge.child: edge for edge in evidence.edges()}
    poses: dict[str, Transform] = {}
    for root, frames in evidence.trees.items():
        poses[root] = Transform()
        waiting = [frame for frame in frames if frame != root]
        while waiting and len(poses) < MOST_FRAMES:
            frame = next(frame for frame in waiting if evidence.parent_of[frame] in poses)
            waiting.remove(frame)
            poses[frame] = poses[evidence.parent_of[frame]] @ _value_at(edges[frame], moment_ns)
    return poses


def _value_at(edge: Edge, moment_ns: int) -> Transform:
    """Return the last usable value that was heard up to a moment, or the first after it."""
    usable = np.flatnonzero(edge.is_usable)
    if not len(usable):
        return Transform()
    heard = usable[edge.receive_ns[usable] <= moment_ns]
    row = edge.source[edge.rows[int(heard[-1] if len(heard) else usable[0])]].tolist()
    length = float(np.linalg.norm(row[3:]))
    return Transform(tuple(row[:3]), tuple(value / length for value in row[3:]))


def _view(evidence: Evidence, poses: dict[str, Transform], eye: tuple[float, float], caption: str) -> str:
    origins = np.array([pose.translation for pose in poses.values()])
    middle = (origins.min(axis=0) + origins.max(axis=0)) / 2
    size_m = max(LEAST_SIZE_M, float(np.linalg.norm(origins - middle, axis=1).max()))
    links, axes, names = [], [], []
    for frame, pose in poses.items():
        x, y = _flat(np.array(pose.translation) - middle, size_m, eye)
        parent = evidence.parent_of.get(frame)
        if parent in poses:
            to_x, to_y = _flat(np.array(poses[parent].translation) - middle, size_m, eye)
            links.append(_line("link", x, y, to_x, to_y))
        for axis, tip in zip("xyz", np.eye(3) * ARM * size_m, strict=True):
            end = _flat(np.array(pose.apply(tuple(tip.tolist()))) - middle, size_m, eye)
            axes.append(_line(f"axis-{axis}", x, y, *end))
        names.append(f'<text x="{x + 5:.1f}" y="{y + 13:.1f}">{escape(frame)}</text>')
    drawn = "".join([*links, *axes, *names])
    return f'<svg class="frames" viewBox="0 0 {WIDTH:.0f} {HEIGHT:.0f}" role="img" aria-label="{caption}">{drawn}</svg>'


def _flat(point: np.ndarray, size_m: float, eye: tuple[float, float]) -> tuple[float, float]:
    """Return where a point stands on the page, seen by an eye that looks down by `pitch` after a turn by `yaw`."""
    yaw, pitch = eye
    x, y, z = (point * RADIUS / size_m).tolist()
    right = np.cos(yaw) * x - np.sin(yaw) * y
    ahead = np.sin(yaw) * x + np.cos(yaw) * y
    return float(WIDTH / 2 + right), float(HEIGHT / 2 - np.cos(pitch) * z - np.sin(pitch) * ahead)


def _line(kind: str, x: float, y: float, to_x: float, to_y: float) -> str:
    return f'<line class="{kind}" x1="{x:.1f}" y1="{y:.1f}" x2="{to_x:.1f}" y2="{to_y:.1f}"/>'
