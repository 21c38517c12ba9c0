"""Which check tells two suspects apart?  Any that they would answer differently, and that costs little enough.

    between "odometry slow" and "scan slow"
    "hz /odom"     too seldom, as on the card     tells
    "hz /scan"     as on the card, too seldom     tells, too
    "scan header"  as on the card, both           tells nothing

What each would say stands in the clinic's table of findings, so no list of right
answers is kept.  In the field: a test that *discriminates* between two hypotheses.

Read `forms.py` next.
"""

from __future__ import annotations

from dataclasses import dataclass

from tflab.clinic.table import kind_expected
from tflab.clinic.trolley import TROLLEY

from .form import Mark, Probe
from .structures import Choice
from .values import Plain

__all__ = ["Telling"]


@dataclass(frozen=True)
class Telling(Choice):
    """One of `options` that tells two suspects apart: all that do are the same answer.

    Attributes:
        suspects: the two.
        most_min: how long it may take [min].
    """

    suspects: tuple[str, ...] = ()
    most_min: float = 2.0

    def probes(self, plain: Plain) -> list[Probe] | None:
        word = self.option(plain)
        if word is None:
            return None
        return [[(Mark("tells them apart" if self._tells(word) else word),)]]

    def _tells(self, word: str) -> bool:
        check = TROLLEY.get(word)
        kinds = {kind_expected(suspect, word) for suspect in self.suspects} if check else set()
        return len(kinds) > 1 and check.minutes <= self.most_min
