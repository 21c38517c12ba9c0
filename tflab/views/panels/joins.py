"""What if I come later?  A slider for the moment of joining, and a menu for what the listener asks for.

The pure function behind it is `tflab.views.joins.letters_heard`.
"""

from __future__ import annotations

from collections.abc import Sequence

from ..joins import JoinsPicture, Sender
from ..libraries import ipywidgets as widgets
from .drawn_ahead import At
from .panel import Panel, slider

STEP_S = 0.05


def joins_panel(
    senders: Sequence[Sender], join_s: float, until_s: float, start_s: float = 0.0, language: str = "en"
) -> Panel:
    """Return a panel in which a listener can join earlier or later, and ask for what is stored or not.

    Args:
        senders: who publishes.
        join_s: when the listener joins at first [s].
        start_s, until_s: what is shown [s].
        language: of the controls, "en" or "ko".

    Raises:
        ValueError: the language is unknown.
    """
    join = slider("join", join_s, start_s, until_s, STEP_S, "s", language)
    durability = widgets.Dropdown(
        options=[("TRANSIENT_LOCAL", True), ("VOLATILE", False)],
        description="durability",
        tooltip="durability that the listener requests on /tf_static",
        style={"description_width": "110px"},
    )
    picture = JoinsPicture(senders, until_s, start_s)

    def move(at: At) -> None:
        picture.show(at(join), at(durability))

    return Panel("What a listener knows that joins", picture, (join, durability), move, language=language)
