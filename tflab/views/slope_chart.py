"""Draw what was learned between two tests: two columns of marks, a row for each misconception.

          before        after
    M1      x  =========  o    cured      x  wrong, sure               .  not known, or a wrong guess
    M2      o  ---------  o    held       o  right, sure               @  right by a guess
    M3      .  . . . . .  x    stuck
    M4      o  - - - - -  .    lost

Wrong and sure is a misconception; wrong and guessed is only a gap.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from . import style

if TYPE_CHECKING:
    from .picture import Picture

KINDS = {"right": "right, sure", "guessed right": "right, guessed", "gap": "not known", "wrong": "wrong, sure"}
RIGHT = ("right", "guessed right")
STATES = {(False, True): "cured", (True, True): "held", (False, False): "stuck", (True, False): "lost"}
LINES = {
    "cured": {"color": style.ACCENT, "linewidth": 2.6, "linestyle": "solid"},
    "held": {"color": style.GREY, "linewidth": 1.0, "linestyle": "solid"},
    "stuck": {"color": style.GREY, "linewidth": 1.0, "linestyle": (0, (1.0, 2.2))},
    "lost": {"color": style.INK, "linewidth": 1.6, "linestyle": (0, (5.0, 2.0))},
}
MARKS = {
    "right": {"marker": "o", "markerfacecolor": style.INK},
    "guessed right": {"marker": "o", "markerfacecolor": style.FAINT},
    "gap": {"marker": "o", "markerfacecolor": style.PAPER},
    "wrong": {"marker": "X", "markerfacecolor": style.INK},
}
ROW_PX, HEAD_PX, FOOT_PX = 22, 34, 40
NAME_X, BEFORE_X, AFTER_X, STATE_X = 0.02, 0.2, 0.68, 0.76


def state_of(before: str, after: str) -> str:
    """Return "cured", "held", "stuck" or "lost" for two of KINDS."""
    return STATES[before in RIGHT, after in RIGHT]


def describe_gain(before: Mapping[str, str], after: Mapping[str, str]) -> str:
    """Return the figure's text: a line for each row, and how many there are of each state."""
    states = {name: state_of(before[name], after[name]) for name in before}
    width, middle = max(map(len, before)), max(map(len, KINDS.values()))
    rows = [
        f"{name:<{width}}  {KINDS[before[name]]:<{middle}} -> {KINDS[after[name]]:<{middle}}  {state}"
        for name, state in states.items()
    ]
    counts = [f"{state} {list(states.values()).count(state)}" for state in LINES]
    return "\n".join([*rows, " · ".join(counts)])


def draw_gain(before: Mapping[str, str], after: Mapping[str, str]) -> Picture:
    """Draw two columns of marks joined by lines.

    Args:
        before: of each row what was known, one of KINDS, by its name.
        after: the same rows later.

    Raises:
        ValueError: there are no rows, the two have others, or one is of no kind.
    """
    from .picture import Picture

    if not before or set(before) != set(after):
        raise ValueError(f"before and after need the same rows, at least one: {', '.join(before)}; {', '.join(after)}")
    if strange := {*before.values(), *after.values()} - set(KINDS):
        raise ValueError(f"{', '.join(sorted(strange))}: there is {', '.join(KINDS)}")
    height_px = HEAD_PX + ROW_PX * len(before) + FOOT_PX
    picture = Picture((style.WIDE[0] * 0.72, height_px / style.SCREEN_DPI))
    with style.our_settings():
        ax = picture.figure.add_axes((0.03, 0.0, 0.94, 1.0))
        ax.set_axis_off()
        ax.set_xlim(0.0, 1.0)
        ax.set_ylim(height_px, 0.0)
        for x, words in ((BEFORE_X, "before"), (AFTER_X, "after")):
            ax.text(x, HEAD_PX / 2, words, va="center", ha="center", color=style.GREY)
        for number, name in enumerate(before):
            _draw_row(ax, HEAD_PX + (number + 0.5) * ROW_PX, name, before[name], after[name])
        _draw_key(ax, height_px - FOOT_PX / 2)
    picture.text = describe_gain(before, after)
    return picture


def _draw_row(ax, y: float, name: str, before: str, after: str) -> None:
    state = state_of(before, after)
    learnt = {"color": style.ACCENT, "weight": "bold"} if state == "cured" else {"color": style.INK}
    ax.text(NAME_X, y, name, va="center", fontsize=style.SMALL_PT, **learnt)
    ax.text(STATE_X, y, state, va="center", fontsize=style.SMALL_PT, **learnt)
    ax.plot([BEFORE_X, AFTER_X], [y, y], zorder=1, **LINES[state])
    for x, kind in ((BEFORE_X, before), (AFTER_X, after)):
        _mark(ax, x, y, kind)


def _draw_key(ax, y: float) -> None:
    """Say below what each mark means."""
    for place, (kind, words) in enumerate(KINDS.items()):
        x = 0.02 + 0.255 * place
        _mark(ax, x + 0.01, y, kind)
        ax.text(x + 0.035, y, words, va="center", color=style.GREY, fontsize=style.SMALL_PT)


def _mark(ax, x: float, y: float, kind: str) -> None:
    ax.plot(
        [x], [y], markersize=8.0, markeredgecolor=style.INK, markeredgewidth=0.9, linestyle="", zorder=2, **MARKS[kind]
    )
