"""Print an example line for each kind of finding of each diagnostic tool.

    delay /scan   1 min   ros2 topic delay /scan
        0.105 s, std dev 0.000 s       (card)
        -0.295 s, std dev 0.000 s      laser clock ahead

Who writes a program that reads findings needs to know their form; numbers and names
are those of one robot, and another has others.  The same three tables in print: the
suspects, the checks, and what each suspect would say.
"""

from __future__ import annotations

from .checks import CHECKS, unknown_name_error
from .findings import AS_ON_THE_CARD, DENORMALIZED, INCOMPATIBLE
from .table import COMPLAINTS, SUSPECTS, expected_kind

__all__ = ["EXAMPLES", "checks_as_text", "findings_as_text", "suspects_as_text"]

_CARD = AS_ON_THE_CARD
_NODES = "joint_driver laser_driver laser_mount localization map_server robot_state_publisher wheel_odometry"
_LOST = {"map unknown": "map unknown", "not in one tree": "not in one tree"}
_LOGS = {DENORMALIZED: f"answers; log: {DENORMALIZED}", INCOMPATIBLE: f"answers; log: {INCOMPATIBLE}"}
_NO_LASER = {
    DENORMALIZED: f"laser_frame unknown; log: {DENORMALIZED}",
    INCOMPATIBLE: f"laser_frame unknown; log: {INCOMPATIBLE}",
}
_TREE = "roots: map; odom 10.2 Hz; base_footprint"
_NO_NODE = {"Node not found": "Node not found"}

EXAMPLES: dict[str, dict[str, str]] = {
    "rviz": {
        _CARD: "all Ok",
        "map unknown": "Fixed Frame [map] unknown, map not listed",
        "Fixed Frame unknown, map listed": "Fixed Frame [Map] unknown, map listed",
        "robot lost": "no transform from base_footprint",
        "robot lost, and a foreign frame": "foreign frames: odm; no transform from base_footprint",
        "into the future": "extrapolation into the future",
        "scan's own frame unknown": "scan's frame [laser_frame] unknown",
        "scan's frame is another": "scan's frame [laser] unknown",
    },
    "node list": {
        _CARD: _NODES,
        "without localization": _NODES.replace("localization ", ""),
        "without wheel_odometry": _NODES.replace(" wheel_odometry", ""),
        "with ekf_filter_node": f"ekf_filter_node {_NODES}",
    },
    "echo map base_footprint": {_CARD: "answers", "comes and goes": "comes and goes", **_LOST, **_LOGS},
    "echo odom base_footprint": {
        _CARD: "smooth",
        "to and fro": "to and fro, 0.51 m apart",
        "comes and goes": "comes and goes",
        "a new pose every 0.3 s or less often": "a new pose every 0.3 s or less often",
        "not in one tree": "not in one tree",
        **_LOGS,
    },
    "echo base_link laser_frame": {_CARD: "0.200, 0.000, 0.150", "elsewhere": "0.000, 0.000, 0.150", **_NO_LASER},
    "echo map odom": {_CARD: "steps of up to 0.13 m", **_LOST, **_LOGS},
    "hz /odom": {
        _CARD: "20.0 Hz, std dev 0.000 s",
        "too seldom": "2.0 Hz, std dev 0.000 s",
        "trembles": "20.1 Hz, std dev 0.059 s",
        "nothing heard": "nothing heard",
    },
    "hz /scan": {_CARD: "10.0 Hz, std dev 0.000 s"},
    "delay /odom": {
        _CARD: "0.004 s, std dev 0.000 s",
        "late": "0.362 s, std dev 0.046 s",
        "nothing heard": "nothing heard",
    },
    "delay /scan": {
        _CARD: "0.105 s, std dev 0.000 s",
        "late": "0.505 s, std dev 0.000 s",
        "ahead": "-0.295 s, std dev 0.000 s",
    },
    "scan header": {_CARD: "laser_frame", "base_link": "base_link", "another frame": "laser"},
    "use_sim_time": {"False": "False", "True": "True", **_NO_NODE},
    "publish_tf": {"True": "True", "False": "False", **_NO_NODE},
    "info /tf": {
        _CARD: "robot_state_publisher VOLATILE, wheel_odometry VOLATILE, localization VOLATILE",
        "without localization": "robot_state_publisher VOLATILE, wheel_odometry VOLATILE",
        "without wheel_odometry": "robot_state_publisher VOLATILE, localization VOLATILE",
        "with ekf_filter_node": "robot_state_publisher VOLATILE, wheel_odometry VOLATILE, ekf_filter_node VOLATILE, "
        "localization VOLATILE",
    },
    "info /tf_static": {
        _CARD: "robot_state_publisher TRANSIENT_LOCAL, laser_mount TRANSIENT_LOCAL",
        "laser_mount VOLATILE": "robot_state_publisher TRANSIENT_LOCAL, laser_mount VOLATILE",
    },
    "echo /tf_static": {
        _CARD: "x 0.2, y 0.0, z 0.15, w 1.0",
        "elsewhere": "x 0.0, y 0.0, z 0.15, w 1.0",
        "w 0": "x 0.2, y 0.0, z 0.15, w 0.0",
        "no laser_frame": "no laser_frame",
    },
    "view_frames": {
        _CARD: f"{_TREE} 20.2 Hz",
        "roots odom": "roots: odom; base_footprint 20.2 Hz",
        "roots base_footprint, map": "roots: base_footprint, map; odom 10.2 Hz",
        "a foreign root": "roots: map, odm; odom 10.2 Hz; base_footprint 20.2 Hz",
        "base_footprint too often": f"{_TREE} 50.2 Hz",
        "base_footprint too seldom": f"{_TREE} 2.2 Hz",
        DENORMALIZED: f"{_TREE} 20.2 Hz; no laser_frame; log: {DENORMALIZED}",
        INCOMPATIBLE: f"{_TREE} 20.2 Hz; no laser_frame; log: {INCOMPATIBLE}",
    },
    "monitor": {
        _CARD: "base_footprint 0.004 s; odom 0.010 s; 50.2 Hz in all",
        "too much in all": "base_footprint 0.006 s; odom 0.010 s; 80.2 Hz in all",
        "too little in all": "base_footprint 0.004 s; odom 0.010 s; 32.2 Hz in all",
        "late": "base_footprint 0.369 s; odom 0.367 s; 48.4 Hz in all",
        "answers, then aborts": "answers, then aborts",
        **_LOST,
        **_NO_LASER,
    },
    "tape measure": {_CARD: "0.200 m ahead, 0.000 m to the side, 0.150 m up: where the drawing has it"},
    "other cable": {_CARD: "360 points ten times a second, as with the cable before"},
}
WIDEST = 64  # letters of a finding that has its suspects beside it
CARD = {"en": "(card)", "ko": "(카드)"}
MINUTES = {"en": "{minutes:>4g} min", "ko": "{minutes:>4g}분"}


def suspects_as_text(language: str = "en") -> str:
    """Return each complaint, and its three suspects."""
    return "\n".join(
        f"{key}: {getattr(each, language)}\n" + "".join(f"    {suspect}\n" for suspect in each.suspects)
        for key, each in COMPLAINTS.items()
    ).rstrip("\n")


def checks_as_text(language: str = "en") -> str:
    """Return each check by its short name, what it costs, and what is typed."""
    width = max(map(len, CHECKS))
    return "\n".join(
        f"{key:<{width}} {MINUTES[language].format(minutes=check.minutes)}   {check.instruction(language)}"
        for key, check in CHECKS.items()
    )


def findings_as_text(complaint: str = "", language: str = "en") -> str:
    """Return of each check what it says of a healthy robot, and of whom it says something else.

    Args:
        complaint: only its suspects, and the checks that tell them apart; "" for all eighteen and every check.

    Raises:
        ValueError: there is no such complaint.
    """
    if complaint and complaint not in COMPLAINTS:
        raise unknown_name_error(complaint, "no complaint", COMPLAINTS)
    suspects = COMPLAINTS[complaint].suspects if complaint else SUSPECTS
    blocks = []
    for key, check in CHECKS.items():
        who: dict[str, list[str]] = {check.usual: []}
        for suspect in suspects:
            who.setdefault(expected_kind(suspect, key), []).append(suspect)
        if complaint and sum(map(bool, who.values())) < 2:
            continue
        rows = [(EXAMPLES[key][kind], ", ".join(who[kind]) if kind != check.usual else CARD[language]) for kind in who]
        blocks.append(
            f"{key}  {MINUTES[language].format(minutes=check.minutes).strip()}  $ {check.instruction(language)}"
        )
        width = max(len(line) for line, _ in rows)
        between = "   " if width <= WIDEST else "\n        "  # a list of nodes leaves no room beside it
        blocks += [f"    {line:<{width if width <= WIDEST else 0}}{between}{names}" for line, names in rows]
    return "\n".join(blocks)
