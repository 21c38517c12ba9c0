"""What does this joint move?  A slider for each, in front of `joints`: the arm, its dominoes, and its file.

The pure function behind it is the caller's: joint positions in, steps out.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import NamedTuple

from ..joints import JointsPicture, Step
from .drawn_ahead import At
from .panel import Panel, slider

__all__ = ["Travel", "joints_panel"]


class Travel(NamedTuple):
    """How far a joint may go, and where it stands at first [unit]."""

    joint: str
    low: float
    high: float
    start: float = 0.0
    unit: str = "rad"


def joints_panel(
    chain: Callable[[Mapping[str, float]], Sequence[Step]], travels: Sequence[Travel], language: str = "en"
) -> Panel:
    """Return a panel with a slider for each joint that moves.

    Args:
        chain: the steps from the base to the tip, for joint positions by name [rad or m].
        travels: of the joints, in the order of the chain.
        language: of the button, "en" or "ko".

    Raises:
        ValueError: no joint moves, or the language is unknown.
    """
    if not travels:
        raise ValueError("no joint of this chain moves, so there is nothing to slide")
    sliders = {t.joint: slider(t.joint, t.start, t.low, t.high, 0.05, t.unit) for t in travels}
    for control in sliders.values():
        control.style.description_width = "160px"
    picture = JointsPicture(chain({t.joint: t.start for t in travels}))

    def move(at: At) -> None:
        touched = next(name for name, control in sliders.items() if control is at.moved)
        picture.show(chain({name: at(control) for name, control in sliders.items()}), touched)

    return Panel("An arm, joint by joint", picture, list(sliders.values()), move, language=language)
