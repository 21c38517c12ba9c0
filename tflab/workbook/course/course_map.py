"""Draw which chapter builds on which, from left to right.

    1 -> 2 -> 3 -> 4 -> 5 ----------> 11 ---.
                   '--> 6 -> 7 ------------- 12
                        '--> 8 -> 9 -> 10 --'

Numbers only, so that it reads in every language: a solid box is a chapter that has a
page, a dashed one is to come.  An arrow that follows from others is not drawn.
"""

from __future__ import annotations

from collections.abc import Collection

from tflab.views import style
from tflab.views.picture import Picture

from .course import Chapter, read_course

__all__ = ["draw_course"]

BOX = (0.44, 0.56)  # of a column and of a lane
LANES = {5: 0, 6: 1, 7: 0.5, 8: 1.5, 9: 1.5, 10: 1.5, 11: 0}  # 1 where nothing is said: the middle


def draw_course(here: Collection[int]) -> Picture:
    """Draw the chapters with what each builds on; those whose numbers are in `here` have a page."""
    from matplotlib.patches import FancyBboxPatch

    chapters = {chapter.number: chapter for chapter in read_course().chapters if chapter.number}
    arrows = _arrows(chapters)
    columns = _columns(chapters)
    places = {number: (columns[number], LANES.get(number, 1.0)) for number in chapters}
    picture = Picture((style.WIDE[0], 2.0))
    with style.our_settings():
        ax = picture.figure.add_axes((0.005, 0.02, 0.99, 0.96))
        ax.set(xlim=(-0.5, max(columns.values()) + 0.5), ylim=(2.0, -0.45))
        ax.axis("off")
        for number, befores in arrows.items():
            for before in befores:
                _draw_arrow(ax, places[before], places[number])
        for number, (x, y) in places.items():
            box = (x - BOX[0] / 2, y - BOX[1] / 2)
            is_here = number in here
            ax.add_patch(
                FancyBboxPatch(
                    box,
                    *BOX,
                    boxstyle="round,pad=0,rounding_size=0.06",
                    facecolor=style.SHADE if is_here else style.PAPER,
                    edgecolor=style.INK if is_here else style.GREY,
                    linestyle="solid" if is_here else "dashed",
                )
            )
            weight, colour = ("bold", style.INK) if is_here else ("normal", style.GREY)
            ax.text(x, y, str(number), ha="center", va="center", weight=weight, color=colour, fontsize=style.TEXT_PT)
    picture.text = "\n".join(_in_words(chapter, arrows[number], number in here) for number, chapter in chapters.items())
    return picture


def _arrows(chapters: dict[int, Chapter]) -> dict[int, list[int]]:
    """Return which chapters come directly before each: those that no other one before it needs already."""
    needs: dict[int, set[int]] = {}
    for number, chapter in chapters.items():
        direct = set(chapter.builds_on) & set(chapters)
        needs[number] = direct.union(*(needs[before] for before in direct))
    return {
        number: sorted(
            before
            for before in needs[number]
            if not any(before in needs[other] for other in needs[number] if other != before)
        )
        for number in chapters
    }


def _columns(chapters: dict[int, Chapter]) -> dict[int, int]:
    """Return how many chapters come one after another before each."""
    columns: dict[int, int] = {}
    for number, chapter in chapters.items():
        columns[number] = max((columns[before] + 1 for before in chapter.builds_on if before in columns), default=0)
    return columns


def _draw_arrow(ax, start: tuple[float, float], end: tuple[float, float]) -> None:
    ax.annotate(
        "",
        xy=(end[0] - BOX[0] / 2, end[1]),
        xytext=(start[0] + BOX[0] / 2, start[1]),
        arrowprops={"arrowstyle": "-|>", "color": style.GREY, "linewidth": 1.1, "shrinkA": 1, "shrinkB": 1},
        annotation_clip=False,
    )


def _in_words(chapter: Chapter, before: list[int], is_here: bool) -> str:
    needs = f", builds on {' and '.join(str(number) for number in before)}" if before else ""
    return f"{chapter.number}{needs}{'' if is_here else ', to come'}"
