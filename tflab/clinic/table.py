"""State what each check shows for each of eighteen suspects (possible causes), three for each of six complaints.

    complaint   "Frame [map] does not exist"
    suspects    localizer not running   localizer waits for /clock   Fixed Frame misspelt
    node list   without localization    as on the card               as on the card         tells one from two
    publish_tf  True                    True                         True                   tells nothing

A complaint is what an operator sees, a suspect what may be behind it.  The table
is general knowledge about robots and says nothing of any patient; diagnosis from
such a table is called a *fault dictionary*.  The ward's test runs all eighteen and
holds the table to what they said.
"""

from __future__ import annotations

from typing import NamedTuple

from .checks import CHECKS

__all__ = ["COMPLAINTS", "DECIDING", "SENSOR_BROKEN", "SUSPECTS", "Complaint", "expected_kind"]


class Complaint(NamedTuple):
    """What an operator says, in English and in Korean, and who may be behind it."""

    en: str
    ko: str
    suspects: tuple[str, ...]


COMPLAINTS = {
    "no map": Complaint(
        "Since this morning RViz stays empty. All it says is that a frame does not exist.",
        "오늘 아침부터 RViz가 비어 있습니다. 좌표계가 없다는 말만 나옵니다.",
        ("localizer not running", "localizer waits for /clock", "Fixed Frame misspelt"),
    ),
    "no robot": Complaint(
        "The map is drawn, and the robot is not. It drives, I can hear it.",
        "지도는 그려지는데 로봇이 보이지 않습니다. 로봇은 움직이고 있습니다. 소리가 납니다.",
        ("odometry not running", "parent misspelt", "publish_tf off"),
    ),
    "jumps": Complaint(
        "In RViz the robot jumps to and fro, or is gone for a moment. On the floor it drives quite calmly.",
        "RViz에서 로봇이 앞뒤로 튀거나 잠깐씩 사라집니다. 실제 바닥에서는 아주 얌전하게 달립니다.",
        ("two owners of one edge", "localizer owns the base", "nothing is wrong"),
    ),
    "beside the walls": Complaint(
        "Everything in RViz is green, and yet the scan does not lie on the walls.",
        "RViz는 모두 초록색인데 스캔이 벽과 맞지 않습니다.",
        ("mount wrong", "header says base_link", "laser clock behind"),
    ),
    "flickers": Complaint(
        "The scan flickers, and now and then it is gone altogether. RViz says something about the future.",
        "스캔이 깜빡이다가 가끔은 아예 사라집니다. RViz에는 future라는 말이 나옵니다.",
        ("laser clock ahead", "transforms late", "odometry slow"),
    ),
    "no scan": Complaint(
        "The robot is there, the map is there, only the scan is missing.",
        "로봇도 있고 지도도 있는데 스캔만 없습니다.",
        ("quaternion of zeros", "header says another frame", "mount volatile"),
    ),
}

SUSPECTS = tuple(suspect for complaint in COMPLAINTS.values() for suspect in complaint.suspects)
SENSOR_BROKEN = "sensor broken"  # whom everybody suspects, and nobody in the clinic has

_APART, _MAP = "not in one tree", "map unknown"
_NO_MAP = {
    "rviz": _MAP, "echo map base_footprint": _MAP, "echo map odom": _MAP, "view_frames": "roots odom", "monitor": _MAP,
}  # fmt: skip
_ISLAND = {
    "rviz": "robot lost", "echo map base_footprint": _APART, "echo odom base_footprint": _APART,
    "view_frames": "roots base_footprint, map", "monitor": _APART,
}  # fmt: skip
_LISTENERS = (
    "echo map base_footprint", "echo odom base_footprint", "echo base_link laser_frame", "echo map odom", "view_frames",
    "monitor",
)  # fmt: skip
_WITH_EKF = "with ekf_filter_node"

# Of each suspect what is not as on the card.
_COLUMNS = {
    "localizer not running": {
        **_NO_MAP, "node list": "without localization", "use_sim_time": "Node not found",
        "info /tf": "without localization",
    },
    "localizer waits for /clock": {**_NO_MAP, "use_sim_time": "True"},
    "Fixed Frame misspelt": {"rviz": "Fixed Frame unknown, map listed"},
    "odometry not running": {
        **_ISLAND, "node list": "without wheel_odometry", "hz /odom": "nothing heard", "delay /odom": "nothing heard",
        "publish_tf": "Node not found", "info /tf": "without wheel_odometry",
    },
    "parent misspelt": {**_ISLAND, "rviz": "robot lost, and a foreign frame", "view_frames": "a foreign root"},
    "publish_tf off": {**_ISLAND, "publish_tf": "False"},
    "two owners of one edge": {
        "node list": _WITH_EKF, "info /tf": _WITH_EKF, "echo odom base_footprint": "to and fro",
        "view_frames": "base_footprint too often", "monitor": "too much in all",
    },
    "localizer owns the base": {
        "rviz": "robot lost", "echo map base_footprint": "comes and goes", "echo odom base_footprint": "comes and goes",
        "echo map odom": _APART, "view_frames": "base_footprint too often", "monitor": "answers, then aborts",
    },
    "nothing is wrong": {},
    "mount wrong": {"echo base_link laser_frame": "elsewhere", "echo /tf_static": "elsewhere"},
    "header says base_link": {"scan header": "base_link"},
    "laser clock behind": {"delay /scan": "late"},
    "laser clock ahead": {"rviz": "into the future", "delay /scan": "ahead"},
    "transforms late": {"rviz": "into the future", "hz /odom": "trembles", "delay /odom": "late", "monitor": "late"},
    "odometry slow": {
        "rviz": "into the future", "echo odom base_footprint": "a new pose every 0.3 s or less often",
        "hz /odom": "too seldom", "view_frames": "base_footprint too seldom", "monitor": "too little in all",
    },
    "quaternion of zeros": {
        **dict.fromkeys(_LISTENERS, "TF_DENORMALIZED_QUATERNION"), "rviz": "scan's own frame unknown",
        "echo /tf_static": "w 0",
    },
    "header says another frame": {"rviz": "scan's frame is another", "scan header": "another frame"},
    "mount volatile": {
        **dict.fromkeys(_LISTENERS, "incompatible QoS"), "rviz": "scan's own frame unknown",
        "info /tf_static": "laser_mount VOLATILE", "echo /tf_static": "no laser_frame",
    },
    # Of no complaint, but at hand when one compares two.
    "wheel bad": {},
    "map wrong": {},
    "localizer waits for a scan": {
        **_NO_MAP, "hz /scan": "nothing heard", "delay /scan": "nothing heard", "scan header": "nothing heard",
    },
    "mount never sent": {
        **dict.fromkeys(("echo base_link laser_frame", "view_frames", "monitor"), "laser_frame unknown"),
        "rviz": "scan's own frame unknown", "echo /tf_static": "no laser_frame",
    },
    "scan slow": {"hz /scan": "too seldom"},
    SENSOR_BROKEN: {"hz /scan": "nothing heard", "delay /scan": "nothing heard", "scan header": "nothing heard"},
}  # fmt: skip

# Which reading shows whether the suspect is gone.
DECIDING = {
    "localizer not running": "node list",
    "localizer waits for /clock": "use_sim_time",
    "Fixed Frame misspelt": "rviz",
    "odometry not running": "hz /odom",
    "parent misspelt": "view_frames",
    "publish_tf off": "publish_tf",
    "two owners of one edge": "view_frames",
    "localizer owns the base": "echo map odom",
    "nothing is wrong": "echo odom base_footprint",
    "mount wrong": "echo base_link laser_frame",
    "header says base_link": "scan header",
    "laser clock behind": "delay /scan",
    "laser clock ahead": "delay /scan",
    "transforms late": "delay /odom",
    "odometry slow": "hz /odom",
    "quaternion of zeros": "echo /tf_static",
    "header says another frame": "scan header",
    "mount volatile": "info /tf_static",
    SENSOR_BROKEN: "hz /scan",
}


def expected_kind(suspect: str, check: str) -> str:
    """Return what kind of finding a suspect would give to a check."""
    return _COLUMNS[suspect].get(check, CHECKS[check].usual)
