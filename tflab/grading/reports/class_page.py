"""Write the instructor's page on a class: mistakes by count, hardest tasks, points, gain.

    what is misunderstood     M1 target and source swapped  ##########  57
    which mistakes            E3.2 swapped (M1)      ################  31 of 180
    how hard the tasks are    E3.4                   #######......     52 %
    how the class did         0 .. 100 %             ..:|||::.
    before and after          gain 0.67              M3 33 % -> 0 %

Each picture stands beside the same in words. In the section on the gain no learner is named
but in the lines on who could not be matched.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

from markupsafe import Markup

from tflab.text import Text, Texts
from tflab.views.picture import Picture
from tflab.workbook.inventory.items import Item, read_inventory
from tflab.workbook.tasks.misconceptions import MISCONCEPTIONS

from ..submissions.remarks import Remark
from .class_figures import bars, histogram, scores
from .feedback import SIGNS
from .gain import (
    BY_GUESSING,
    ClassGain,
    MisconceptionCount,
    band,
    class_gain,
    misconception_counts,
    normalised_gain,
    uninformative_items,
    unused_options,
)
from .gradebook import remarks_of, tasks_of, verdicts_of
from .html import page, render

__all__ = ["CommonMistake", "class_page", "gain_section", "mistakes"]

MOST_BARS = 14
MOST_NAMED = 3
ENOUGH = 20  # learners, to say anything of the test itself
TEXTS = Texts(__file__)


class CommonMistake(NamedTuple):
    """A named mistake, and how many made it."""

    task: str
    name: str
    misconception: str
    reply: Text
    count: int

    @property
    def label(self) -> str:
        """The name as it is shown."""
        return self.name.replace("_", " ") + (f" ({self.misconception})" if self.misconception else "")


def mistakes(records: Sequence[Mapping[str, Any]]) -> list[CommonMistake]:
    """Return the mistakes that were made, the most frequent first."""
    made = [
        (task, name, mistake["misconception"], Text(**mistake["reply"]))
        for record in records
        for chapter in record["chapters"].values()
        for task, row in chapter["tasks"].items()
        for name, mistake in row.get("mistakes", {}).items()
    ]
    found = [CommonMistake(*what, count) for what, count in Counter(made).items()]
    return sorted(found, key=lambda mistake: (-mistake.count, mistake.task, mistake.name))


def class_page(
    records: Sequence[Mapping[str, Any]],
    *,
    language: str = "en",
    wall: Sequence[Text] = (),
    remarks: Sequence[Remark] = (),
) -> str:
    """Return the instructor's page as HTML.

    Args:
        wall: what is said of the sandbox.
        remarks: on the files that were handed in.
    """
    graded = [record for record in records if record["handed_in"]]
    values: dict[str, Any] = _about_grades(graded, language) if graded else {"misunderstood": None}
    if graded:
        items = read_inventory()
        gain = class_gain(records, items)
        values["gain"] = gain_section(gain, items, language) if gain else ""
    body = render(
        "class_page.html", TEXTS, language,
        graded=len(graded),
        empty=len(records) - len(graded),
        seconds=f"{sum(record['seconds'] for record in records):.1f}",
        learners=[_learner(record, language) for record in records],
        about=[remark.say(language) for remark in remarks],
        wall=[line.say(language) for line in wall],
        **values,
    )  # fmt: skip
    return page(TEXTS["title"].say(language), language, body)


def _learner(record: Mapping[str, Any], language: str) -> dict[str, Any]:
    signs = [(task, SIGNS[row["status"]]) for task, row in verdicts_of(record).items()]
    lines = dict.fromkeys(remark.say(language) for remark in remarks_of(record))
    return {"id": record["learner"], "signs": signs, "lines": lines} | {
        name: record[name] for name in ("name", "points", "most")
    }


def _about_grades(graded: Sequence[Mapping[str, Any]], language: str) -> dict[str, Any]:
    """Return mistakes, their misconceptions, and the pictures of the page."""
    found = mistakes(graded)
    most_frequent = [(_same(f"{made.task} {made.label}"), made.count) for made in found[:MOST_BARS]]
    percents = [100 * record["points"] / record["most"] if record["most"] else 0.0 for record in graded]
    title = TEXTS["named"]
    return {
        "misunderstood": _misunderstood(found, language),
        "mistakes": found,
        "mistakes_picture": bars(
            most_frequent, TEXTS["learners"], most=len(graded), title=title, language=language
        ) if found else None,
        "hardest": _hardest(graded, language),
        "distribution": histogram(percents, language),
    }  # fmt: skip


def _misunderstood(found: Sequence[CommonMistake], language: str) -> dict[str, Any] | None:
    """Return the misconceptions behind the mistakes, by how many answers they spoilt, and their picture."""
    counts: Counter[str] = Counter()
    for mistake in found:
        if mistake.misconception in MISCONCEPTIONS:
            counts[mistake.misconception] += mistake.count
    if not counts:
        return None
    order = sorted(counts, key=lambda name: (-counts[name], int(name[1:])))
    named = [(Text(*(f"{words} ({name})" for words in MISCONCEPTIONS[name])), counts[name]) for name in order]
    title, most = TEXTS["spoilt"], max(counts.values())
    return {
        "picture": bars(named, TEXTS["answers"], most=most, title=title, language=language),
        "counts": [(MISCONCEPTIONS[name].say(language), counts[name]) for name in order],
    }


def _hardest(graded: Sequence[Mapping[str, Any]], language: str) -> Picture:
    share = {}
    for task in tasks_of(graded):
        got = [verdicts_of(record)[task] for record in graded if task in verdicts_of(record)]
        share[task] = 100 * sum(row["points"] for row in got) / sum(row["most"] for row in got)
    hardest = sorted(share.items(), key=lambda pair: (pair[1], pair[0]))
    named = [(_same(task), value) for task, value in hardest[:MOST_BARS]]
    return bars(named, TEXTS["mean"], most=100, title=TEXTS["hardest_first"], language=language)


def _same(name: str) -> Text:
    return Text(name, name)


# -- before and after --------------------------------------------------------------------


def gain_section(found: ClassGain, items: Sequence[Item], language: str) -> Markup:
    """Return the part of the page on the concept inventory, as HTML."""
    values: dict[str, Any] = {"rows": []}
    if found.matched:
        (before, after), of = found.means(), len(items)
        gain, table = normalised_gain(before, after, of), misconception_counts(items, found.matched)
        values = {
            "means": TEXTS["means"].say(
                language, count=len(found.matched), of=of, before=f"{before:.1f}", after=f"{after:.1f}",
                by_guessing=BY_GUESSING,
            ),
            "gain": gain,
            "band": "" if gain is None else band(gain).say(language),
            "picture": scores(*found.right(), of, BY_GUESSING, language),
            "named": _named(table, language),
            "rows": [_row(row, len(found.matched), language) for row in table],
        }  # fmt: skip
    lines = [line.say(language) for line in found.lines]
    about = _about_the_test(found, items, language)
    return render("gain.html", TEXTS, language, lines=lines, about_the_test=about, **values)


def _named(table: Sequence[MisconceptionCount], language: str) -> list[str]:
    """Return which misconceptions fell most, and which grew most."""
    fell = sorted((row for row in table if row.after < row.before), key=lambda row: row.after - row.before)
    grew = sorted((row for row in table if row.after > row.before), key=lambda row: row.before - row.after)
    return [
        text.say(language, which="; ".join(f"{_name(row, language)} {row.before} → {row.after}" for row in rows))
        for text, rows in ((TEXTS["cured"], fell[:MOST_NAMED]), (TEXTS["grew"], grew[:MOST_NAMED]))
        if rows
    ]


def _name(row: MisconceptionCount, language: str) -> str:
    return f"{MISCONCEPTIONS[row.misconception].say(language)} ({row.misconception})"


def _row(row: MisconceptionCount, of: int, language: str) -> dict[str, Any]:
    change = "grown" if row.after > row.before else "" if row.after == row.before else "fell" if row.after else "gone"
    return {
        "name": _name(row, language),
        "before": _share(row.before, of),
        "after": _share(row.after, of),
        "sure_before": _share(row.sure_before, row.before),
        "sure_after": _share(row.sure_after, row.after),
        "change": change,
    }


def _share(count: int, of: int) -> Markup | str:
    return Markup("{:.0f}&nbsp;%").format(100 * count / of) if of else "–"


def _about_the_test(found: ClassGain, items: Sequence[Item], language: str) -> list[str]:
    """Return which items and options tell little, for whoever looks after the test."""
    if len(found.matched) < ENOUGH:
        return []
    sides = (
        (TEXTS["out_of_reach"], map(str, uninformative_items(found.matched))),
        (TEXTS["unused"], unused_options(items, found.matched)),
    )
    return [text.say(language, which=", ".join(which)) for text, names in sides if (which := list(names))]
