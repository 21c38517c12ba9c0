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


def turned_cloud(rng: Draws) -> dict:
    """Draw one of five ways to turn a cloud by ninety degrees: the evidence, as one would read it off."""
    frame_id, body_deg, optical_deg = ODD[int(rng.integers(len(ODD)))]
    return {
        "header_frame_id": frame_id,
        "rpy_of_camera_link_in_base_link_deg": body_deg,
        "rpy_of_camera_optical_frame_in_camera_link_deg": optical_deg,
        "wall_in_the_cloud_optical_z_m": round(float(rng.uniform(1.5, 3.0)), 1),
    }


def wall_appears(given) -> str:
    """Return where in base_link the cloud's depth points, its z."""
    mounts = [given.rpy_of_camera_link_in_base_link_deg]
    if given.header_frame_id == OPTICAL:
        mounts.append(given.rpy_of_camera_optical_frame_in_camera_link_deg)
    depth = np.array([0.0, 0.0, 1.0])
    for rpy_deg in reversed(mounts):
        depth = Transform.from_rpy(*np.radians(rpy_deg)).apply(depth)
    x, y, z = np.round(depth)
    return {(1, 0, 0): "ahead", (0, 0, 1): "above", (0, 1, 0): "left", (0, -1, 0): "right"}[x, y, z]


def named(given) -> dict:
    """Return what is wrong, and where it is mended."""
    if given.header_frame_id == "camera_link":
        return {"fault": "header", "change": "driver"}
    mount = OPTICAL if tuple(given.rpy_of_camera_link_in_base_link_deg) == STRAIGHT_DEG else LINK
    return {"fault": f"mount of {mount}", "change": "URDF"}


def at_the_wrong_end(given) -> dict:
    """Blame the mount for a wrong header, and the header for a wrong mount."""
    if given.header_frame_id == "camera_link":
        return {"wall_appears": wall_appears(given), "fault": "mount of camera_optical_frame", "change": "URDF"}
    return {"wall_appears": wall_appears(given), "fault": "header", "change": "driver"}


def mended_elsewhere(given) -> dict:
    """Find the fault, and mend a header in the URDF or a mount in the driver."""
    found = named(given)
    change = "URDF" if found["change"] == "driver" else "driver"
    return {"wall_appears": wall_appears(given), "fault": found["fault"], "change": change}


def the_other_mount(given) -> dict:
    """Blame camera_link whatever the evidence, or the optical frame if camera_link it is."""
    blamed = OPTICAL if named(given)["fault"] == f"mount of {LINK}" else LINK
    return {"wall_appears": wall_appears(given), "fault": f"mount of {blamed}", "change": "URDF"}


ANSWERS = {
    "turn the data": lambda given: {"wall_appears": wall_appears(given), "fault": "data", "change": "my node"},
    "wrong end": at_the_wrong_end,
    "other mount": the_other_mount,
    "mended elsewhere": mended_elsewhere,
    "quaternion": lambda given: {"wall_appears": wall_appears(given), "fault": "quaternion", "change": "URDF"},
}

TASK = define_task(
    __file__, kind="D", points=3, answer="diagnosis", form=DIAGNOSIS, given=turned_cloud, variants=20, answers=ANSWERS
)
