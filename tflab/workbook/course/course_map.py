"""Draw which chapter builds on which, from top to bottom.

    ( 1 )  Value, frame and stamp
      |
    ( 2 )  Axes and quaternions
      |
     ...   an arrow that leaves out a chapter bends to the left

A solid ring is a chapter that has a page, a dashed one is to come.  An arrow that follows from
others is not drawn.
"""

from __future__ import annotations

from collections.abc import Collection

from tflab.views import style
from tflab.views.picture import Picture

from .course import Chapter, read_course

__all__ = ["draw_course"]

WIDTH_PX, ROW_PX, EDGE_PX = 420, 32, 8  # so narrow that a phone shows it at its size
NUMBER_PX, TITLE_PX = 110, 134  # from the left edge: the numbers, the titles
RING_PX = 11  # radius
BEND = 0.8  # of an arrow that leaves out a chapter, in parts of its length


def draw_course(here: Collection[int]) -> Picture:
    """Draw the chapters with what each builds on; those whose numbers are in `here` have a page."""
    from matplotlib.patches import Circle

    chapters = {chapter.number: chapter for chapter in read_course().chapters if chapter.number}
    arrows = _arrows(chapters)
    height_px = ROW_PX * len(chapters) + 2 * EDGE_PX
    places = {number: (NUMBER_PX, EDGE_PX + ROW_PX * (row + 0.5)) for row, number in enumerate(chapters)}
    picture = Picture((WIDTH_PX / style.SCREEN_DPI, height_px / style.SCREEN_DPI))
    with style.our_settings():
        ax = picture.figure.add_axes((0.0, 0.0, 1.0, 1.0))
        ax.set(xlim=(0, WIDTH_PX), ylim=(height_px, 0))
        ax.axis("off")
        for number, befores in arrows.items():
            for before in befores:
                _draw_arrow(ax, places[before], places[number])
        for number, (x, y) in places.items():
            is_here = number in here
            colour, line = (style.INK, "solid") if is_here else (style.GREY, "dashed")
            ax.add_patch(Circle((x, y), RING_PX, facecolor=style.SHADE, edgecolor=colour, linestyle=line, zorder=3))
            ax.text(x, y, str(number), ha="center", va="center", weight="bold", color=colour, zorder=4)
            ax.text(TITLE_PX, y, chapters[number].title.en, va="center", color=colour, fontsize=style.TITLE_PT)
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


def _draw_arrow(ax, start: tuple[float, float], end: tuple[float, float]) -> None:
    """Draw an arrow from a ring to one below it: straight down to the next, else in a bend on the left."""
    (x, top), (_, bottom) = start, end
    is_next = bottom - top < 1.5 * ROW_PX
    ends = ((x, top + RING_PX), (x, bottom - RING_PX)) if is_next else ((x - RING_PX, top), (x - RING_PX, bottom))
    look = {"arrowstyle": "-|>", "color": style.GREY, "linewidth": 1.2, "shrinkA": 0, "shrinkB": 1}
    bend = {} if is_next else {"connectionstyle": f"arc3,rad={BEND}"}
    ax.annotate("", xytext=ends[0], xy=ends[1], arrowprops=look | bend)


def _in_words(chapter: Chapter, before: list[int], is_here: bool) -> str:
    needs = f", builds on {' and '.join(str(number) for number in before)}" if before else ""
    return f"{chapter.number} {chapter.title.en}{needs}{'' if is_here else ', to come'}"
