"""List the diagnostic tools and what each costs in minutes.

    CHECKS["delay /scan"] = CostedCheck("delay /scan", "ros2 topic delay /scan", 1, "delay")

The prices are those of somebody who has to walk to the robot, wait and read: a
question that shows one number costs a minute, a picture of the whole tree three,
a screwdriver a quarter of an hour.  In decision theory this is the cost of a test.
"""

from __future__ import annotations

import difflib
from collections.abc import Iterable
from pathlib import Path
from typing import NamedTuple

from tflab.text import Text, load_yaml

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
_ROWS = load_yaml(Path(__file__).with_suffix(".yaml").read_text(encoding="utf-8"))
CHECKS = {key: CostedCheck(key, **row) for key, row in _ROWS.items()}


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
