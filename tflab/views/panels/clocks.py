"""What if one node lives in another time?  Boxes and sliders in front of `clocks`.

The pure functions behind it are `tflab.views.clocks.clock_of` and `asked_now`.
This is the last of the panels.
"""

from __future__ import annotations

from dataclasses import replace

from ..clocks import PASSES, WORDS, ClocksPicture, Play
from ..libraries import ipywidgets as widgets
from .drawn_ahead import At
from .panel import Panel, slider

NODES = ("rviz2", "detector")


def clocks_panel(play: Play | None = None, played_s: float = 9.0, language: str = "en") -> Panel:
    """Return a panel in which two nodes' clocks, and how the bag is played, can be changed.

    Args:
        play: what to begin with; a bag in a loop if None.
        played_s: the moment to begin with [s].
        language: of the words, "en" or "ko".

    Raises:
        ValueError: the language is unknown.
    """
    if language not in WORDS:
        raise ValueError(f'there are no words in "{language}"; languages are {", ".join(WORDS)}')
    start = play or Play(loops=True)
    played = slider("played", played_s, 0.0, PASSES * start.length_s, 0.1, "s", language)
    rate = slider("--rate", start.rate, 0.5, 3.0, 0.1, "x")
    follows = [_box(f"{name}: use_sim_time", True) for name in NODES]
    follows[1].value = False
    loop, clock = _box("--loop", start.loops), _box("--clock", start.publishes_clock)
    picture = ClocksPicture(NODES)

    def move(at: At) -> None:
        how = replace(start, rate=at(rate), loops=at(loop), publishes_clock=at(clock))
        nodes = {name: at(box) for name, box in zip(NODES, follows, strict=True)}
        picture.show(nodes, how, at(played), language)

    title = "What each node's clock shows while a bag is played"
    return Panel(title, picture, (played, rate, *follows, loop, clock), move, language=language)


def _box(description: str, value: bool) -> widgets.Checkbox:
    return widgets.Checkbox(
        value=value, description=description, tooltip=description, indent=False, layout={"width": "190px"}
    )
