"""Where was everything at that moment?  The frames in 3D: all of them, and close by.

    finding --a link--> #moment-2 --> the tree as it was then: three axes a frame, a line to its parent

Each frame is placed by its parents' transforms that were heard last before the
moment, as an impatient listener would.  The projection is orthographic, and drawn
here: a report runs no script.
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
NEAR = 3.0  # times the usual distance
LETTER, LINE = 6.8, 13.0  # px, of a name


def draw_frames_at(evidence: Evidence, moment_ns: int, first: tuple[str, ...] = ()) -> str:
    """Return the frames as they were at a moment, all of them and a robot's size of them from nearer, as SVG.

    Args:
        first: the frames that matter most: they are in the middle of the second picture, and have a name in both.
    """
    poses = poses_at(evidence, moment_ns)
    if not poses:  # every frame is in a loop
        return ""
    near = _near(poses, [frame for frame in first if frame in poses])
    views = [_view(evidence, poses, CORNER, "all frames", first)]
    if len(near) < len(poses):
        views.append(_view(evidence, near, CORNER, "close by", first))
    else:
        views.append(_view(evidence, poses, ABOVE, "from above", first))
    return "".join(views)


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


def _near(poses: dict[str, Transform], first: list[str]) -> dict[str, Transform]:
    """Return the frames around the first of those that matter, or where most are, without map and odom far away."""
    origins = np.array([pose.translation for pose in poses.values()])
    middle = np.array(poses[first[-1]].translation) if first else np.median(origins, axis=0)
    away_m = np.linalg.norm(origins - middle, axis=1)
    reach_m = max(LEAST_SIZE_M, NEAR * float(np.median(away_m)))
    return {frame: pose for (frame, pose), m in zip(poses.items(), away_m.tolist(), strict=True) if m <= reach_m}


def _view(evidence: Evidence, poses: dict[str, Transform], eye: tuple, caption: str, first: tuple[str, ...]) -> str:
    origins = np.array([pose.translation for pose in poses.values()])
    middle = (origins.min(axis=0) + origins.max(axis=0)) / 2
    size_m = max(LEAST_SIZE_M, float(np.linalg.norm(origins - middle, axis=1).max()))
    links, axes, places = [], [], {}
    for frame, pose in poses.items():
        x, y = places[frame] = _flat(np.array(pose.translation) - middle, size_m, eye)
        parent = evidence.parent_of.get(frame)
        if parent in poses:
            to_x, to_y = _flat(np.array(poses[parent].translation) - middle, size_m, eye)
            links.append(_line("link", x, y, to_x, to_y))
        for axis, tip in zip("xyz", np.eye(3) * ARM * size_m, strict=True):
            end = _flat(np.array(pose.apply(tuple(tip.tolist()))) - middle, size_m, eye)
            axes.append(_line(f"axis-{axis}", x, y, *end))
    told = f'<text class="view" x="8" y="{HEIGHT - 10:.0f}">{caption}</text>'
    drawn = "".join([*links, *axes, *_names(places, first), told])
    return f'<svg class="frames" viewBox="0 0 {WIDTH:.0f} {HEIGHT:.0f}" role="img" aria-label="{caption}">{drawn}</svg>'


def _names(places: dict[str, tuple[float, float]], first: tuple[str, ...]) -> list[str]:
    """Return the names that fit, those that matter first; where one would cover another, pointing at the dot tells."""
    drawn, taken = [], []
    for frame in sorted(places, key=lambda frame: (frame not in first, list(places).index(frame))):
        x, y = places[frame]
        length = LETTER * len(frame)
        left, base = min(x + 5.0, WIDTH - length - 4.0), y + 13.0
        box = (left, base - LINE, left + length, base)
        drawn.append(f'<circle class="dot" cx="{x:.1f}" cy="{y:.1f}" r="3"><title>{escape(frame)}</title></circle>')
        if any(box[0] < b[2] and b[0] < box[2] and box[1] < b[3] and b[1] < box[3] for b in taken):
            continue
        taken.append(box)
        drawn.append(f'<text x="{left:.1f}" y="{base:.1f}">{escape(frame)}</text>')
    return drawn


def _flat(point: np.ndarray, size_m: float, eye: tuple[float, float]) -> tuple[float, float]:
    """Return where a point stands on the page, seen by an eye that looks down by `pitch` after a turn by `yaw`."""
    yaw, pitch = eye
    x, y, z = (point * RADIUS / size_m).tolist()
    right = np.cos(yaw) * x - np.sin(yaw) * y
    ahead = np.sin(yaw) * x + np.cos(yaw) * y
    return float(WIDTH / 2 + right), float(HEIGHT / 2 - np.cos(pitch) * z - np.sin(pitch) * ahead)


def _line(kind: str, x: float, y: float, to_x: float, to_y: float) -> str:
    return f'<line class="{kind}" x1="{x:.1f}" y1="{y:.1f}" x2="{to_x:.1f}" y2="{to_y:.1f}"/>'
