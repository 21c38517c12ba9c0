"""Draw the numbers of a class as bars, with the same in words.

What is drawn is in English; the words are in the reader's language.
"""

from __future__ import annotations

import statistics
from collections import Counter
from collections.abc import Sequence

from tflab.text import Text, Texts
from tflab.views import style
from tflab.views.picture import Picture

__all__ = ["bars", "histogram", "scores"]

TEXTS = Texts(__file__)
BINS = 10
ROW_INCH = 0.3


def bars(rows: Sequence[tuple[Text, float]], unit: Text, *, most: float, title: Text, language: str = "en") -> Picture:
    """Draw a bar for each named number, the first at the top; the text says the same."""
    width, _ = style.WIDE
    picture = Picture((width, 0.95 + ROW_INCH * len(rows)))
    height = picture.figure.get_size_inches()[1]
    with style.our_settings():
        left = style.names_width_px((name.en for name, _ in rows), 110) / (style.SCREEN_DPI * width)
        ax = picture.figure.add_axes((left, 0.55 / height, 0.92 - left, 1 - 0.9 / height))
        values = [value for _, value in rows]
        ax.barh(range(len(rows)), values, height=0.62, color=style.SHADE, edgecolor=style.INK, linewidth=0.8)
        for place, value in enumerate(values):
            ax.text(value + 0.01 * most, place, f"{value:.0f}", va="center", fontsize=style.SMALL_PT)
        ax.set_yticks(range(len(rows)), [name.en for name, _ in rows])
        ax.set_xlim(0, most * 1.08)
        ax.set_ylim(len(rows) - 0.5, -0.5)
        ax.set_xlabel(unit.en)
        ax.xaxis.get_major_locator().set_params(integer=True)
        ax.tick_params(length=0)
        style.hide_spines(ax, "top", "right")
    named = (f"  {name.say(language)}: {value:.0f}" for name, value in rows)
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
        style.hide_spines(ax, "top", "right")
    mean, middle = (statistics.mean(values), statistics.median(values)) if values else (0.0, 0.0)
    picture.text = "\n".join(
        [
            TEXTS["summary"].say(language, count=len(values), mean=f"{mean:.0f}", middle=f"{middle:.0f}"),
            *(TEXTS["bin"].say(language, low=10 * n, high=10 * n + 10, count=count) for n, count in enumerate(counts)),
        ]
    )
    return picture


def scores(before: Sequence[int], after: Sequence[int], of: int, by_guessing: float, language: str = "en") -> Picture:
    """Draw how many learners had how many right before and after, with a grey line where guessing leads."""
    picture = Picture((style.WIDE[0], 2.9))
    rows = (("before", before, style.SHADE, -0.2), ("after", after, style.GREY, 0.2))
    with style.our_settings():
        ax = picture.figure.add_axes((0.09, 0.2, 0.86, 0.68))
        for name, values, colour, aside in rows:
            counts = [list(values).count(right) for right in range(of + 1)]
            places = [right + aside for right in range(of + 1)]
            ax.bar(places, counts, width=0.38, color=colour, edgecolor=style.INK, linewidth=0.8, label=name)
        ax.axvline(by_guessing, color=style.FAINT, linestyle=(0, (4.0, 2.0)), zorder=0, label="guessing")
        ax.set_xlim(-0.6, of + 0.6)
        ax.margins(y=0.12)
        ax.set_xticks(range(of + 1))
        ax.yaxis.get_major_locator().set_params(integer=True)
        ax.set_xlabel(f"right, of {of}")
        ax.set_ylabel("learners")
        ax.legend(loc="lower right", bbox_to_anchor=(1.0, 1.0), ncols=3, frameon=False, fontsize=style.SMALL_PT)
        style.hide_spines(ax, "top", "right")
    had, has = Counter(before), Counter(after)
    mean_before, mean_after = (f"{statistics.mean(values):.1f}" for values in (before, after))
    picture.text = "\n".join(
        [
            TEXTS["scores"].say(
                language, count=len(before), of=of, before=mean_before, after=mean_after, by_guessing=by_guessing
            ),
            *(
                TEXTS["score"].say(language, right=right, before=had[right], after=has[right])
                for right in range(of + 1)
                if had[right] or has[right]
            ),
        ]
    )
    return picture
