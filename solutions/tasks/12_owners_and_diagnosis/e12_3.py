"""E12.3: The first check."""

from __future__ import annotations

from tflab.clinic.checks import CHECKS
from tflab.workbook.tasks import DiscriminatingCheck, Parts, define_task

OTHERS = ("longer timeout", "read the code")
OPTIONS = (*CHECKS, *OTHERS)
SUSPECTS = {
    "no frame map": ("localizer not running", "localizer waits for /clock"),
    "odom stands alone": ("publish_tf off", "parent misspelt"),
    "robot to and fro": ("two owners of one edge", "wheel bad"),
    "scan beside the walls": ("mount wrong", "map wrong"),
    "walls smear in bends": ("laser clock behind", "mount wrong"),
    "into the future": ("laser clock ahead", "transforms late"),
    "localizer silent": ("localizer waits for /clock", "localizer waits for a scan"),
    "unknown frame": ("header says another frame", "mount never sent"),
    "static late joiner": ("mount volatile", "mount never sent"),
    "slow robot": ("odometry slow", "scan slow"),
}

TASK = define_task(
    __file__,
    kind="D",
    points=3,
    answer="first",
    form=Parts({symptom: DiscriminatingCheck(OPTIONS, suspects) for symptom, suspects in SUSPECTS.items()}),
)
