"""How do a class's numbers look?  Bars with their numbers on them, in ink and grey, and the same in words.

What is drawn is in English; the words are in the reader's language.

Read `class_page.py` next.
"""

from __future__ import annotations

import statistics
from collections.abc import Sequence

from tflab.views import style
from tflab.views.picture import Picture
from tflab.workbook.words import Words

__all__ = ["bars", "histogram"]

BINS = 10
ROW_INCH = 0.3
SUMMARY = Words(
    "{count} learners, points [%]: mean {mean}, median {middle}", "{count}명의 점수[%]: 평균 {mean}, 중앙값 {middle}"
)
BIN = Words("  {low} to {high}: {count}", "  {low}~{high}: {count}명")


def bars(
    rows: Sequence[tuple[Words, float]],
    unit: Words,
    *,
    most: float,
    title: Words,
    digits: int = 0,
    language: str = "en",
) -> Picture:
    """Draw a bar for each named number, the first at the top; the text says the same."""
    width, _ = style.WIDE
    picture = Picture((width, 0.95 + ROW_INCH * len(rows)))
    height = picture.figure.get_size_inches()[1]
    with style.our_settings():
        left = style.room_px((name.en for name, _ in rows), 110) / (style.SCREEN_DPI * width)
        ax = picture.figure.add_axes((left, 0.55 / height, 0.92 - left, 1 - 0.9 / height))
        values = [value for _, value in rows]
        ax.barh(range(len(rows)), values, height=0.62, color=style.SHADE, edgecolor=style.INK, linewidth=0.8)
        for place, value in enumerate(values):
            ax.text(value + 0.01 * most, place, f"{value:.{digits}f}", va="center", fontsize=style.SMALL_PT)
        ax.set_yticks(range(len(rows)), [name.en for name, _ in rows])
        ax.set_xlim(0, most * 1.08)
        ax.set_ylim(len(rows) - 0.5, -0.5)
        ax.set_xlabel(unit.en)
        if digits == 0:  # what is counted comes in ones
            ax.xaxis.get_major_locator().set_params(integer=True)
        ax.tick_params(length=0)
        for side in ("top", "right"):
            ax.spines[side].set_visible(False)
    named = (f"  {name.say(language)}: {value:.{digits}f}" for name, value in rows)
    picture.text = "\n".join([f"{title.say(language)}, {unit.say(language)}:", *named])
    return picture


def histogram(values: Sequence[float], language: str = "en") -> Picture:
    """Draw how many learners have how many points, in tenths of 0 to 100 %; 100 is in the last."""
    counts = [0] * BINS
    for value in values:
        counts[min(BINS - 1, int(value // (100 / BINS)))] += 1
    picture = Picture((style.WIDE[0], 2.9))
    with style.our_settings():
        ax = picture.figure.add_axes((0.09, 0.2, 0.86, 0.72))
        width = 100 / BINS
        middles = [width * (place + 0.5) for place in range(BINS)]
        ax.bar(middles, counts, width=0.9 * width, color=style.SHADE, edgecolor=style.INK, linewidth=0.8)
        for middle, count in zip(middles, counts, strict=True):
            if count:
                ax.text(middle, count, str(count), ha="center", va="bottom", fontsize=style.SMALL_PT)
        ax.set_xlim(0, 100)
        ax.set_ylim(0, max(counts, default=1) * 1.15 or 1)
        ax.set_xticks(range(0, 101, 10))
        ax.yaxis.get_major_locator().set_params(integer=True)
        ax.set_xlabel("points [%]")
        ax.set_ylabel("learners")
        for side in ("top", "right"):
            ax.spines[side].set_visible(False)
    mean, middle = (statistics.mean(values), statistics.median(values)) if values else (0.0, 0.0)
    picture.text = "\n".join(
        [
            SUMMARY.say(language, count=len(values), mean=f"{mean:.0f}", middle=f"{middle:.0f}"),
            *(BIN.say(language, low=10 * n, high=10 * n + 10, count=count) for n, count in enumerate(counts)),
        ]
    )
    return picture
