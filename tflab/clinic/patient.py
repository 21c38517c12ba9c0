"""Define a patient: a simulated faulty robot, stored as the outputs of all diagnostic tools.

    patient.ask("delay /scan")           "-0.295 s, std dev 0.000 s"       a minute
    patient.verdict("laser clock ahead", "laser_frame")

A patient is a value that JSON can hold: no graph, no buffer, and nowhere the name
of the cause.  It notes what it was asked, for who asks pays.  Packed, so that
opening a file of cases does not read like its answers: a curtain, not a vault.
"""

from __future__ import annotations

import base64
import json
import re
import zlib
from collections.abc import Mapping
from copy import copy
from functools import lru_cache
from typing import Any

from tflab.text import Texts

from .checks import CHECKS, find_check

__all__ = ["NOTES", "FaultyRobot", "result_of_fix", "rows_of", "translate_output"]

NOTES = Texts(__file__)  # what is written down without a tool of ROS
KNOWN = 128  # patients that are held open: a ward is asked over and over


class FaultyRobot:
    """A sick robot, as its ward wrote it down.

    Args:
        complaint: a key of COMPLAINTS, "" for one that says nothing.
        screen: RViz's list; that of one without a complaint has to be asked for.
        budget_min: how long a visit may take [min].
        evidence: of each check its minutes, its text and its finding.
        fixes: of each fix its minutes, and what is seen after it.
    """

    def __init__(
        self,
        complaint: str,
        screen: str,
        budget_min: float,
        evidence: Mapping[str, tuple[float, str, str]],
        fixes: Mapping[str, tuple[float, str]],
    ) -> None:
        self.complaint, self.screen, self.budget_min = complaint, screen if complaint else "", budget_min
        self.fixes = tuple(fixes)
        self._word = _packed([evidence, fixes])
        self.asked: tuple[str, ...] = ()

    def ask(self, check: str) -> str:
        """Return the finding of a check, and note that it was asked; asked twice, it is paid twice.

        Raises:
            ValueError: it is none of the checks.
        """
        return self.reading(check)[2]

    def reading(self, check: str) -> tuple[float, str, str]:
        """Return the minutes, the text and the finding of a check, and note that it was asked."""
        key = find_check(check).key
        self.asked += (key,)
        return tuple(_unpacked(self._word)[0][key])

    @property
    def minutes(self) -> float:
        """What has been asked so far took this long [min]."""
        return sum(CHECKS[key].minutes for key in self.asked)

    def verdict(self, cause: str, frame: str) -> dict[str, Any]:
        """Return what is handed in: the cause, the frame, and the proof, which is what was asked on the way."""
        return {"cause": cause, "frame": frame, "proof": [cause, list(self.asked)]}

    def packed(self) -> str:
        """Return all of it as one word."""
        return _whole(self.complaint, self.screen, self.budget_min, self._word)

    @classmethod
    def unpacked(cls, word: str) -> FaultyRobot:
        """Return the patient that `packed` wrote, nothing asked of it yet."""
        return copy(_known(word))

    def __repr__(self) -> str:
        return f"<Patient: {self.complaint or 'it does not work'}>"


def result_of_fix(patient: FaultyRobot, fix: str) -> tuple[float, str]:
    """Return the minutes of a fix, and what is seen after it; whether it may be tried yet, a visit decides."""
    return tuple(_unpacked(patient._word)[1][fix])


def rows_of(patient: FaultyRobot) -> list[Any]:
    """Return what a patient is made of, as JSON has it: the arguments of `FaultyRobot`."""
    return _unpacked(patient.packed())


def translate_output(text: str, language: str = "en") -> str:
    """Return what a patient's tools printed, with our own notes in a language; what a tool printed stays as it is."""
    return text if language == "en" else "\n".join(_translate_line(line, language) for line in text.split("\n"))


def _translate_line(line: str, language: str) -> str:
    bare = line.lstrip(" ")
    for note in NOTES.values():
        pattern = re.sub(r"\\{(\w+)\\}", r"(?P<\1>\\S+)", re.escape(note.en))
        if match := re.fullmatch(pattern, bare):
            return line[: len(line) - len(bare)] + note.say(language, **match.groupdict())
    return line


def _packed(rows: list[Any]) -> str:
    return base64.b85encode(zlib.compress(json.dumps(rows).encode(), 9)).decode()


@lru_cache(maxsize=KNOWN)
def _unpacked(word: str) -> list[Any]:
    """Return the rows; the same ones each time, which nobody changes."""
    return json.loads(zlib.decompress(base64.b85decode(word)))


@lru_cache(maxsize=KNOWN)
def _whole(complaint: str, screen: str, budget_min: float, word: str) -> str:
    return _packed([complaint, screen, budget_min, *_unpacked(word)])


@lru_cache(maxsize=KNOWN)
def _known(word: str) -> FaultyRobot:
    return FaultyRobot(*_unpacked(word))
