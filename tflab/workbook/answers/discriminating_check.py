"""Define the answer form for a check that separates two suspects: any check with different results and low cost.

    between "odometry slow" and "scan slow"
    "hz /odom"     too seldom, as on the card     tells
    "hz /scan"     as on the card, too seldom     tells, too
    "scan header"  as on the card, both           tells nothing

What each would say stands in the clinic's table of findings, so no list of right
answers is kept.  In the field: a test that *discriminates* between two hypotheses.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from tflab.clinic.checks import CHECKS
from tflab.clinic.table import expected_kind

from ...text import Text, Texts
from .form import Mark, Probe
from .structures import Choice
from .values import Plain

__all__ = ["DiscriminatingCheck"]

TEXTS = Texts(__file__)


@dataclass(frozen=True)
class DiscriminatingCheck(Choice):
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

    def remark(self, answer: Plain, neighbours: Mapping[str, Plain]) -> Text | None:
        """Return why a check does not do: it tells nothing, or it would and costs too much; None if it is none."""
        word = self.option(answer)
        if word not in CHECKS or self._tells(word):
            return None
        if self._differs(word):
            return TEXTS["too_costly"].filled(minutes=CHECKS[word].minutes, most=self.most_min)
        return TEXTS["the_same"] if CHECKS[word].minutes <= self.most_min else None

    def _tells(self, word: str) -> bool:
        return self._differs(word) and CHECKS[word].minutes <= self.most_min

    def _differs(self, word: str) -> bool:
        """Return whether the suspects would answer a check differently."""
        return word in CHECKS and len({expected_kind(suspect, word) for suspect in self.suspects}) > 1
