"""What is a patient?  Plain texts: a complaint, RViz's screen, and what each question would be answered.

    patient.ask("delay /scan")           "-0.295 s, std dev 0.000 s"       a minute
    patient.verdict("laser clock ahead", "laser_frame")

A patient is a value that JSON can hold: no graph, no buffer, and nowhere the name
of the cause.  It notes what it was asked, for who asks pays.  Packed, so that
opening a file of cases does not read like its answers: a curtain, not a vault.

Read `ward.py` next.
"""

from __future__ import annotations

import base64
import json
import zlib
from collections.abc import Mapping
from typing import Any

from .trolley import TROLLEY, check_named

__all__ = ["SickRobot"]


class SickRobot:
    """A sick robot, as its ward wrote it down.

    Args:
        complaint: a key of COMPLAINTS, "" for one that says nothing.
        screen: RViz's list.
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
        self.complaint, self.screen, self.budget_min = complaint, screen, budget_min
        self._evidence = {key: tuple(row) for key, row in evidence.items()}
        self._fixes = {fix: tuple(row) for fix, row in fixes.items()}
        self.asked: tuple[str, ...] = ()

    def ask(self, check: str) -> str:
        """Return the finding of a check, and note that it was asked; asked twice, it is paid twice.

        Raises:
            ValueError: it is not on the trolley.
        """
        return self.reading(check)[2]

    def reading(self, check: str) -> tuple[float, str, str]:
        """Return the minutes, the text and the finding of a check, and note that it was asked."""
        key = check_named(check).key
        self.asked += (key,)
        return self._evidence[key]

    @property
    def minutes(self) -> float:
        """What has been asked so far took this long [min]."""
        return sum(TROLLEY[key].minutes for key in self.asked)

    @property
    def fixes(self) -> tuple[str, ...]:
        """Return what can be done about it."""
        return tuple(self._fixes)

    def after(self, fix: str) -> tuple[float, str]:
        """Return the minutes of a fix, and what is seen after it.

        Raises:
            ValueError: there is no such fix.
        """
        if fix not in self._fixes:
            raise ValueError(f'there is no fix "{fix}"; there is {", ".join(self._fixes)}')
        return self._fixes[fix]

    def verdict(self, cause: str, frame: str) -> dict[str, Any]:
        """Return what is handed in: the cause, the frame, and the proof, which is what was asked on the way."""
        return {"cause": cause, "frame": frame, "proof": [cause, list(self.asked)]}

    def packed(self) -> str:
        """Return all of it as one word."""
        row = [self.complaint, self.screen, self.budget_min, self._evidence, self._fixes]
        return base64.b85encode(zlib.compress(json.dumps(row).encode(), 9)).decode()

    @classmethod
    def unpacked(cls, word: str) -> SickRobot:
        """Return the patient that `packed` wrote, nothing asked of it yet."""
        return cls(*json.loads(zlib.decompress(base64.b85decode(word))))

    def __repr__(self) -> str:
        return f"<Patient: {self.complaint or 'it does not work'}>"
