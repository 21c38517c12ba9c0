"""E2.6: A cloud at ninety degrees."""

from __future__ import annotations

import numpy as np

from tflab.core import Transform
from tflab.workbook.tasks import Choice, Draws, Parts, define_task

OPTICAL_RPY_DEG = (-90.0, 0.0, -90.0)
STRAIGHT_DEG = (0.0, 0.0, 0.0)
LINK, OPTICAL = "camera_link", "camera_optical_frame"
ODD = (  # the header, the camera's mount, the optical one: one of the three is not as it should be
    (LINK, STRAIGHT_DEG, OPTICAL_RPY_DEG),
    (OPTICAL, STRAIGHT_DEG, STRAIGHT_DEG),
    (OPTICAL, STRAIGHT_DEG, (-90.0, 0.0, 0.0)),
    (OPTICAL, OPTICAL_RPY_DEG, OPTICAL_RPY_DEG),
    (OPTICAL, (0.0, -90.0, 0.0), OPTICAL_RPY_DEG),
)

DIAGNOSIS = Parts(
    {
        "wall_appears": Choice(("ahead", "above", "left", "right")),
        "fault": Choice(("header", "mount of camera_link", "mount of camera_optical_frame", "data", "quaternion")),
        "change": Choice(("driver", "URDF", "my node")),
    }
)


def draw_rotated_cloud(rng: Draws) -> dict:
    """Draw one of five ways to rotate a cloud by 90 degrees, as the readings show it."""
    frame_id, body_deg, optical_deg = ODD[int(rng.integers(len(ODD)))]
    return {
        "header_frame_id": frame_id,
        "rpy_of_camera_link_in_base_link_deg": body_deg,
        "rpy_of_camera_optical_frame_in_camera_link_deg": optical_deg,
        "wall_in_the_cloud_optical_z_m": round(float(rng.uniform(1.5, 3.0)), 1),
    }


def wall_direction(given) -> str:
    """Return the direction of the cloud's depth axis z in base_link."""
    mounts = [given.rpy_of_camera_link_in_base_link_deg]
    if given.header_frame_id == OPTICAL:
        mounts.append(given.rpy_of_camera_optical_frame_in_camera_link_deg)
    depth = np.array([0.0, 0.0, 1.0])
    for rpy_deg in reversed(mounts):
        depth = Transform.from_rpy(*np.radians(rpy_deg)).apply(depth)
    x, y, z = np.round(depth)
    return {(1, 0, 0): "ahead", (0, 0, 1): "above", (0, 1, 0): "left", (0, -1, 0): "right"}[x, y, z]


def diagnose(given) -> dict:
    """Return what is wrong, and where it is fixed."""
    if given.header_frame_id == "camera_link":
        return {"fault": "header", "change": "driver"}
    mount = OPTICAL if tuple(given.rpy_of_camera_link_in_base_link_deg) == STRAIGHT_DEG else LINK
    return {"fault": f"mount of {mount}", "change": "URDF"}


def blame_other_end(given) -> dict:
    """Blame the mount for a wrong header, and the header for a wrong mount."""
    if given.header_frame_id == "camera_link":
        return {"wall_appears": wall_direction(given), "fault": "mount of camera_optical_frame", "change": "URDF"}
    return {"wall_appears": wall_direction(given), "fault": "header", "change": "driver"}


def fix_elsewhere(given) -> dict:
    """Find the fault, but fix a header in the URDF and a mount in the driver."""
    found = diagnose(given)
    change = "URDF" if found["change"] == "driver" else "driver"
    return {"wall_appears": wall_direction(given), "fault": found["fault"], "change": change}


def blame_other_mount(given) -> dict:
    """Blame camera_link in every case, or the optical frame where it is camera_link."""
    blamed = OPTICAL if diagnose(given)["fault"] == f"mount of {LINK}" else LINK
    return {"wall_appears": wall_direction(given), "fault": f"mount of {blamed}", "change": "URDF"}


ANSWERS = {
    "turn the data": lambda given: {"wall_appears": wall_direction(given), "fault": "data", "change": "my node"},
    "wrong end": blame_other_end,
    "other mount": blame_other_mount,
    "fixed elsewhere": fix_elsewhere,
    "quaternion": lambda given: {"wall_appears": wall_direction(given), "fault": "quaternion", "change": "URDF"},
}

TASK = define_task(
    __file__,
    kind="D",
    points=3,
    answer="diagnosis",
    form=DIAGNOSIS,
    given=draw_rotated_cloud,
    variants=20,
    answers=ANSWERS,
)
