"""List the diagnostic tools and what each costs in minutes.

    CHECKS["delay /scan"] = CostedCheck("delay /scan", "ros2 topic delay /scan", 1, "delay")

The prices are those of somebody who has to walk to the robot, wait and read: a
question that shows one number costs a minute, a picture of the whole tree three,
a screwdriver a quarter of an hour.  In decision theory this is the cost of a test.
"""

from __future__ import annotations

import difflib
from collections.abc import Iterable
from typing import NamedTuple

from tflab.text import Text

from .findings import AS_ON_THE_CARD, kind_of

__all__ = ["BUDGET_MIN", "CHECKS", "CostedCheck", "find_check", "unknown_name_error"]

BUDGET_MIN = 12.0


class CostedCheck(NamedTuple):
    """One question.

    Attributes:
        key: its short name.
        command: what is typed, or done.
        minutes: what it costs.
        reader: who reads it, by the name of a function of `findings.py`.
        seconds: how long a tool listens that would go on for ever [s]; None: as long as suits it.
    """

    key: str
    command: str
    minutes: float
    reader: str
    seconds: float | None = None

    @property
    def usual(self) -> str:
        """The kind of finding of a healthy robot."""
        return {"use_sim_time": "False", "publish_tf": "True"}.get(self.key, AS_ON_THE_CARD)

    def instruction(self, language: str = "en") -> str:
        """Return what is typed, which is the same in every language, or what is done by hand."""
        return BY_HAND[self.key].say(language) if self.key in BY_HAND else self.command

    def kind(self, finding: str) -> str:
        """Return what kind of finding it is."""
        return kind_of(self.reader, finding)


BY_HAND = {
    "rviz": Text("look at RViz again", "RViz를 다시 보기"),
    "tape measure": Text("measure where the laser is bolted on", "레이저의 장착 위치를 줄자로 재기"),
    "other cable": Text("put another cable in", "다른 케이블 꽂기"),
}
CHECKS = {
    check.key: check
    for check in (
        CostedCheck("rviz", BY_HAND["rviz"].en, 1, "rviz"),
        CostedCheck("node list", "ros2 node list", 1, "node_list"),
        CostedCheck("echo map base_footprint", "ros2 run tf2_ros tf2_echo map base_footprint", 1, "connection", 3.0),
        CostedCheck("echo odom base_footprint", "ros2 run tf2_ros tf2_echo odom base_footprint 20", 1, "wheels", 1.0),
        CostedCheck("echo base_link laser_frame", "ros2 run tf2_ros tf2_echo base_link laser_frame", 1, "mount", 2.0),
        CostedCheck("echo map odom", "ros2 run tf2_ros tf2_echo map odom", 2, "correction", 10.0),
        CostedCheck("hz /odom", "ros2 topic hz /odom", 1, "rate"),
        CostedCheck("hz /scan", "ros2 topic hz /scan", 1, "rate"),
        CostedCheck("delay /odom", "ros2 topic delay /odom", 1, "delay"),
        CostedCheck("delay /scan", "ros2 topic delay /scan", 1, "delay"),
        CostedCheck("scan header", "ros2 topic echo /scan --once --field header", 1, "header"),
        CostedCheck("use_sim_time", "ros2 param get /localization use_sim_time", 1, "parameter"),
        CostedCheck("publish_tf", "ros2 param get /wheel_odometry publish_tf", 1, "parameter"),
        CostedCheck("info /tf", "ros2 topic info /tf --verbose", 2, "publishers"),
        CostedCheck("info /tf_static", "ros2 topic info /tf_static --verbose", 2, "publishers"),
        CostedCheck("echo /tf_static", "ros2 topic echo /tf_static", 2, "static", 2.0),
        CostedCheck("view_frames", "ros2 run tf2_tools view_frames", 3, "view_frames"),
        CostedCheck("monitor", "ros2 run tf2_ros tf2_monitor map laser_frame", 4, "monitor"),
        CostedCheck("tape measure", BY_HAND["tape measure"].en, 15, "verbatim"),
        CostedCheck("other cable", BY_HAND["other cable"].en, 30, "verbatim"),
    )
}


def find_check(asked: str) -> CostedCheck:
    """Return the check of a key, or of the command as one types it: on a page, after a prompt, or with `-v`.

    Raises:
        ValueError: there is no such check.
    """
    words = " ".join(str(asked).strip("`$%! \n").split())
    words = f"{words.removesuffix('-v')}--verbose" if words.endswith(" -v") else words
    for check in CHECKS.values():
        if words in (check.key, check.command, check.command.removeprefix("ros2 ")):
            return check
    raise unknown_name_error(words, "not on the trolley", CHECKS, (check.command for check in CHECKS.values()))


def unknown_name_error(said: object, what: str, names: Iterable[str], others: Iterable[str] = ()) -> ValueError:
    """Return the error for a name that nothing has: the nearest of them, whatever its capitals, and all there are.

    Args:
        what: is wrong with it, as after "is".
        others: names that it may be near to, too, and that are not listed.
    """
    names = list(names)
    spelt = {name.lower(): name for name in (*others, *names)}
    close = difflib.get_close_matches(str(said).lower(), spelt, n=1)
    near = f'did you mean "{spelt[close[0]]}"? There is' if close else "there is"
    return ValueError(f'"{said}" is {what}; {near} {", ".join(names)}')
