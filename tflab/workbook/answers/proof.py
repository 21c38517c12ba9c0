"""Define the answer form for a list of checks that must prove a diagnosis.

    ["delay /scan"]                          proves "laser clock ahead" among its three suspects
    ["node list", "hz /odom", ...]           proves nothing, or too late, or asks on when all is clear
    ("laser clock ahead", ["delay /scan"])   the same, for this suspect alone

The form turns a list into the suspects that it would prove, each a row; which of
them is the true one is nowhere in it.  In a dict
a list proves the cause that is named beside it, or nothing: some lists prove two of
three, whoever looked at the robot.  What is said of a list that proves nothing is
true whatever the patient has.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from tflab.clinic.checks import BUDGET_MIN, CHECKS, find_check
from tflab.clinic.proof import NOTHING_IS_WRONG, Flaw, find_flaw
from tflab.clinic.table import SUSPECTS, expected_kind

from ...text import Text, Texts
from .form import Form, Mark, Probe, inside
from .structures import Choice
from .values import Plain

__all__ = ["Proof"]

TEXTS = Texts(__file__)

NOBODY = "nobody"  # who is proved by a list beside which no suspect is named


@dataclass(frozen=True)
class Proof(Form):
    """The checks of a diagnosis, in their order, by their keys in `CHECKS`.

    Attributes:
        whole: whether all eighteen are suspects, and not the three of one complaint.
        budget_min: how long it may take [min].
    """

    whole: bool = False
    budget_min: float = BUDGET_MIN

    def beside(self, answer: Plain, neighbours: Mapping[str, Plain]) -> Plain:
        read = _read(answer)
        if read is None or read[0] is not None or not neighbours:
            return answer
        causes = [word for other in neighbours.values() if (word := _suspect(other))]
        return {"tuple": [causes[0] if causes else NOBODY, read[1]]}

    def probes(self, plain: Plain) -> list[Probe] | None:
        read = _read(plain)
        if read is None:
            return None
        claimed, checks = read
        suspects = SUSPECTS if claimed is None else [suspect for suspect in SUSPECTS if suspect == claimed]
        rows = [(Mark(suspect),) for suspect in suspects if self._flaw(checks, suspect) is None]
        return [rows or [(Mark(f"no proof of {claimed or 'any'}: {checks}"),)]]  # the same as itself, and as no proof

    def wanted(self) -> Text:
        return TEXTS["wanted"]

    def remark(self, answer: Plain, neighbours: Mapping[str, Plain]) -> Text | None:
        """Return what keeps a list from proving the cause that stands beside it.

        It may be contradicted or unproved, "idle", "late" or "all healthy" (`clinic.proof.Flaw`).
        """
        read = _read(self.beside(answer, neighbours))
        if read is None or not read[0]:
            return None
        cause = read[0]
        if cause == NOBODY:
            return TEXTS["no suspect"]
        flaw = (self._flaw(read[1], cause) or Flaw("contradicted")) if read[1] else Flaw("none")
        names = {**flaw._asdict(), "cause": cause, "budget": self.budget_min}
        is_healthy = cause != NOTHING_IS_WRONG and all(
            expected_kind(cause, check) == CHECKS[check].usual for check in read[1]
        )
        is_both = flaw.kind == "unproved" and is_healthy
        return TEXTS["unproved, all healthy" if is_both else flaw.kind].filled(**names)

    def _flaw(self, checks: list[str], suspect: str) -> Flaw | None:
        return find_flaw(checks, suspect, self.whole, self.budget_min)


def _read(plain: Plain) -> tuple[str | None, list[str]] | None:
    """Return whom an answer claims to prove, None if nobody in particular, and its checks; None if it is no list."""
    members = inside(plain)
    if not isinstance(members, list):
        return None
    claimed = None
    if len(members) == 2 and members[0] in (*SUSPECTS, NOBODY) and isinstance(inside(members[1]), list):
        claimed, members = members[0], inside(members[1])
    if not all(isinstance(member, str) for member in members):
        return None
    try:
        return claimed, [find_check(member).key for member in members]
    except ValueError:
        return None


def _suspect(plain: Plain) -> str | None:
    """Return the suspect that somebody names, written as a person may write it; None if it is none."""
    read = Choice(SUSPECTS).read(plain)
    return str(read[0][0][0].value) if read else None
