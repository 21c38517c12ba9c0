"""How did a visit go, step by step?  The door, every question, every fix: a row each, to be drawn or played.

    visit --steps_of--> VisitStep("delay /scan", 1, "-0.285 s", "card: 0.105 s", left=("laser clock ahead",))

Who is left is what the readings leave, whatever one has struck oneself.
"""

from __future__ import annotations

import re

from tflab.views.diagnosis_log import VisitStep

from .examples import EXAMPLES
from .findings import AS_ON_THE_CARD, READERS
from .proof import fitting
from .table import COMPLAINTS, SUSPECTS
from .trolley import TROLLEY, TrolleyCheck, check_named
from .visit import FixTried, Visit

__all__ = ["steps_of"]

LONGEST = 46  # letters of a finding


def steps_of(visit: Visit) -> list[VisitStep]:
    """Return the steps of a visit as `draw_visit` takes them."""
    complaint = COMPLAINTS.get(visit.patient.complaint)
    left = complaint.suspects if complaint else SUSPECTS
    seen = READERS["rviz"](visit.patient.screen) if complaint else ""
    steps = [VisitStep("RViz" if complaint else "it does not work", 0.0, seen, "", left)]
    for asked in visit.log:
        check = TROLLEY[asked.check]
        left = fitting({check.key: check.kind(asked.finding)}, left)
        said, card = _in_a_row(check, asked.finding), _in_a_row(check, EXAMPLES[check.key][check.usual])
        steps.append(VisitStep(check.key, check.minutes, said, f"card: {card}" if card != AS_ON_THE_CARD else "", left))
    return [*steps, *(_fixed(fix, left) for fix in visit.tried)]


def _in_a_row(check: TrolleyCheck, finding: str) -> str:
    """Return a finding, and of a long one, such as all nodes, only its kind."""
    return finding if len(finding) <= LONGEST else check.kind(finding)


def _fixed(tried: FixTried, left: tuple[str, ...]) -> VisitStep:
    """Return a fix as a step: what RViz and the walls say after it, and beside it the reading that decides."""
    seen, _, reading = tried.text.partition("\n$ ")
    command, _, printed = reading.partition("\n")
    check = check_named(command)
    off = re.search(r"up to (\S+ m)", seen)
    rviz = "all Ok" if seen.startswith("RViz: all Ok") else "not Ok"
    said = f"RViz {rviz}, scan up to {off[1]} off" if off else f"RViz {rviz}, no scan placed"
    beside = f"{check.key}: {_in_a_row(check, READERS[check.reader](printed))}"
    return VisitStep(tried.fix, tried.minutes, said, beside, left, is_fix=True)
