"""How does a film of a visit play?  A menu of its steps: the arrow keys go on and back.

    step  2. delay /scan  v
    |==|  -0.285 s                |   x   x

The pure part is `tflab.views.visited`.
"""

from __future__ import annotations

from collections.abc import Sequence

from ..visited import VisitPicture, VisitStep
from .panel import Panel, menu
from .words import said


def visit_panel(steps: Sequence[VisitStep], budget_min: float, language: str = "en") -> Panel:
    """Return a panel that plays a visit step by step; on an exported page it is a film.

    Raises:
        ValueError: the language is unknown.
    """
    picture = VisitPicture(steps, budget_min)
    options = [(f"{number + 1}. {step.name}", number) for number, step in enumerate(steps)]
    step = menu(
        said("step", language), options, 0, said("the arrow keys go on and back", language),
        label_width="60px", width="420px",
    )  # fmt: skip
    return Panel(said("a visit", language), picture, (step,), lambda at: picture.show(at(step)), language=language)
