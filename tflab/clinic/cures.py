"""What can one do about it?  Sixteen fixes, each for its cause, and five plasters for any.

    "set the laser's clock"    the cause is gone
    "stamp on arrival"         the error is gone; the points are still in the wrong place

A plaster takes the symptom away, or nothing at all.  Read `patient.py` next.
"""

from __future__ import annotations

__all__ = ["CURES", "PLASTERS"]

CURES = {
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
    "mend the network": ("transforms late",),
    "wheel_odometry: 20 Hz": ("odometry slow",),
    "laser_mount: w = 1": ("quaternion of zeros",),
    "laser_mount: transient local": ("mount volatile",),
}

# What the asker of transforms does instead, by the field of `ward.Places` that tells where the points are then.
PLASTERS = {
    "timeout of 1 s": "waited",
    "ask with Time()": "newest",
    "stamp on arrival": "arrived",
    "restart everything": "waited",
    "new sensor": "waited",
}
