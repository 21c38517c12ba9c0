"""Check the values of transforms: finite numbers, unit quaternions, optical frames with z forward.

```
rotation (0, 0, 0, 0)     no direction: tf2 refuses it, and the frame "does not exist"
rotation of length 0.9    tf2 of ROS 2 scales it, ROS 1 refuses it: somebody forgot to normalise
NaN, inf                  a division by zero upstream
optical frame, not turned z must look ahead and x to the right (REP-103)
```
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator

import numpy as np

from tflab.core import Transform
from tflab.text import Text

from ..evidence import Edge, Evidence
from ..findings import Finding

__all__ = ["bad_rotations", "images_in_body_frames", "mounts_in_degrees", "not_numbers", "unturned_optical_frames"]

LENGTH_TOLERANCE = 1e-3  # of a quaternion: rounding to float32 gives 1e-7, careless drivers 1e-4
TURN_TOLERANCE_RAD = 0.02
DEGREES = range(5, 365, 5)  # people give such angles, and no such number of radians
DEGREES_TOLERANCE = 1e-6  # [rad]
BODIES = ("base_link", "base_footprint")
LEVEL = math.sin(math.radians(10.0))  # as good as horizontal
EARTH_M = 1e7  # nothing on the earth is further from its centre


def not_numbers(evidence: Evidence) -> Iterator[Finding]:
    """Yield a finding for each edge with NaN or infinity in it, or with a distance that nobody can have meant."""
    for edge in evidence.edges():
        yield from _finding_where(edge, ~edge.is_finite, "not-a-number", "error")
        furthest_m = np.abs(edge.numbers[:, :3]).max(axis=1)
        is_far = edge.is_finite & (furthest_m > EARTH_M)
        facts = {"furthest": f"{furthest_m[is_far].max():.3g}"} if is_far.any() else {}
        yield from _finding_where(edge, is_far, "out-of-this-world", "error", facts)


def bad_rotations(evidence: Evidence) -> Iterator[Finding]:
    """Yield a finding for each edge with rotations that have no direction, or not length one."""
    for edge in evidence.edges():
        is_zero = edge.is_finite & (edge.norm == 0.0)
        share = "all" if is_zero.all() else "some"
        yield from _finding_where(edge, is_zero, "zero-quaternion", "error", {"share": share})
        off = edge.is_finite & (edge.norm > 0.0) & (np.abs(edge.norm - 1.0) > LENGTH_TOLERANCE)
        lengths = edge.norm[off]
        facts = {"shortest": f"{lengths.min():.4f}", "longest": f"{lengths.max():.4f}"} if len(lengths) else {}
        yield from _finding_where(edge, off, "not-unit-quaternion", "warning", facts)


def unturned_optical_frames(evidence: Evidence) -> Iterator[Finding]:
    """Yield a finding for each optical frame that has the same axes as a parent that is none."""
    for edge in evidence.edges():
        if "optical" not in edge.child or "optical" in edge.usual_parent or not edge.is_usable.any():
            continue
        turn_rad = 2.0 * np.arccos(np.clip(np.abs(edge.numbers[:, 6]) / np.maximum(edge.norm, 1e-12), 0.0, 1.0))
        yield from _finding_where(edge, edge.is_usable & (turn_rad < TURN_TOLERANCE_RAD), "optical-unturned", "warning")


def images_in_body_frames(evidence: Evidence) -> Iterator[Finding]:
    """Yield a finding for each frame of images that is no optical frame, but the body of the camera or the robot."""
    optical = {edge.usual_parent: edge.child for edge in evidence.edges() if "optical" in edge.child}
    topics: dict[str, list[str]] = {}
    for header in evidence.headers:
        for frame in header.frames if re.search(r"Image|CameraInfo", header.msgtype) else ():
            is_body = frame in (*optical, *BODIES) or (not optical and _is_upright(evidence, frame))
            if is_body and "optical" not in frame:
                topics.setdefault(frame, []).append(header.topic)
    for frame, names in topics.items():
        below = optical.get(frame, Text("none", "없음"))
        facts = {"name": frame, "optical": below, "topics": ", ".join(names)}
        yield Finding("image-in-body-frame", "warning", topic=names[0], facts=facts)


def _is_upright(evidence: Evidence, frame: str) -> bool:
    """Return whether y is level and z not below the horizon, as of a body; y of an optical frame points down."""
    poses = {edge.child: edge.source[edge.rows[-1]] for edge in evidence.edges() if edge.is_usable[-1]}
    pose, above = Transform(), frame
    for _ in poses:
        if above in poses:
            pose = Transform(poses[above][:3], poses[above][3:]) @ pose
            above = evidence.parent_of.get(above, "")
    _, y_up, z_up, _ = pose.matrix()[2]
    return frame in poses and abs(y_up) < LEVEL and z_up > -LEVEL


def mounts_in_degrees(evidence: Evidence) -> Iterator[Finding]:
    """Yield a finding for each mount that is rotated about one axis by radians that were meant as degrees."""
    for edge in evidence.statics:
        *axes, w = edge.numbers[-1, 3:]
        axis = max(axes, key=abs)
        angle_rad = 2.0 * float(np.arctan2(axis, w))
        is_one_axis = np.abs(axes).sum() - abs(axis) < DEGREES_TOLERANCE
        for degrees in (*DEGREES, *(-d for d in DEGREES)) if edge.is_usable[-1] and is_one_axis else ():
            if abs(math.remainder(degrees - angle_rad, 2.0 * math.pi)) < DEGREES_TOLERANCE:
                facts = {"degrees": degrees, "turned": f"{np.degrees(math.remainder(angle_rad, 2.0 * math.pi)):.1f}"}
                yield Finding("mount-in-degrees", "warning", edge.usual_parent, edge.child, edge.topic, facts=facts)


def _finding_where(edge: Edge, is_bad: np.ndarray, code: str, severity, facts: dict | None = None) -> Iterator[Finding]:
    """Yield one finding about the samples of an edge that are marked, if any."""
    bad = np.flatnonzero(is_bad)
    if len(bad):
        begin_ns, end_ns = int(edge.receive_ns[bad[0]]), int(edge.receive_ns[bad[-1]])
        facts = {"count": len(bad), "total": len(edge), **(facts or {})}
        yield Finding(code, severity, edge.usual_parent, edge.child, edge.topic, begin_ns, end_ns, facts)
