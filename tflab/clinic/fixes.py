"""List the fixes: sixteen that each remove a cause, and five workarounds that at most hide a symptom.

    "set the laser's clock"    the cause is gone
    "stamp on arrival"         the error is gone; the points are still in the wrong place

A plaster takes the symptom away, or nothing at all.  What a whole diagnosis says, of
each cause, stands here too: whose place is wrong, who has to change, and how.
"""

from __future__ import annotations

from typing import NamedTuple

__all__ = ["DIAGNOSES", "EFFECTIVE_FIXES", "WORKAROUNDS", "RepairPlan"]


class RepairPlan(NamedTuple):
    """Whose place is not right, who has to change, and how."""

    frame: str
    owner: str
    fix: str


EFFECTIVE_FIXES = {
    "start localization": ("localizer not running",),
    "localization: use_sim_time false": ("localizer waits for /clock",),
    "RViz: Fixed Frame map": ("Fixed Frame misspelt",),
    "start wheel_odometry": ("odometry not running",),
    "wheel_odometry: parent odom": ("parent misspelt",),
    "wheel_odometry: publish_tf true": ("publish_tf off",),
    "ekf_filter_node: publish_tf false": ("two owners of one edge",),
    "localization: send map -> odom": ("localizer owns the base",),
    "leave it as it is": ("nothing is wrong",),
    "laser_mount: as drawn": ("mount wrong",),
    "laser_driver: laser_frame in the header": ("header says base_link", "header says another frame"),
    "set the laser's clock": ("laser clock behind", "laser clock ahead"),
    "repair the network": ("transforms late",),
    "wheel_odometry: 20 Hz": ("odometry slow",),
    "laser_mount: w = 1": ("quaternion of zeros",),
    "laser_mount: transient local": ("mount volatile",),
}

# What the asker of transforms does instead, by the field of `ward.Places` that tells where the points are then.
WORKAROUNDS = {
    "timeout of 1 s": "waited",
    "ask with Time()": "newest",
    "stamp on arrival": "arrived",
    "restart everything": "waited",
    "new sensor": "waited",
}

_FIX_OF = {cause: fix for fix, causes in EFFECTIVE_FIXES.items() for cause in causes}
_WHERE = {
    "localizer not running": ("odom", "localization"),
    "localizer waits for /clock": ("odom", "localization"),
    "Fixed Frame misspelt": ("map", "rviz"),
    "odometry not running": ("base_footprint", "wheel_odometry"),
    "parent misspelt": ("base_footprint", "wheel_odometry"),
    "publish_tf off": ("base_footprint", "wheel_odometry"),
    "two owners of one edge": ("base_footprint", "ekf_filter_node"),
    "localizer owns the base": ("base_footprint", "localization"),
    "nothing is wrong": ("none", "nobody"),
    "mount wrong": ("laser_frame", "laser_mount"),
    "header says base_link": ("laser_frame", "laser_driver"),
    "laser clock behind": ("laser_frame", "laser_driver"),
    "laser clock ahead": ("laser_frame", "laser_driver"),
    "transforms late": ("all that move", "network"),
    "odometry slow": ("base_footprint", "wheel_odometry"),
    "quaternion of zeros": ("laser_frame", "laser_mount"),
    "header says another frame": ("laser_frame", "laser_driver"),
    "mount volatile": ("laser_frame", "laser_mount"),
}
DIAGNOSES = {cause: RepairPlan(*where, _FIX_OF[cause]) for cause, where in _WHERE.items()}
