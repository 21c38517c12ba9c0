"""Write a learner's page in their language: points, and the names of the mistakes.

    none     nothing is written
    score    what each chapter got
    named    what each task got, which mistake an answer is, and what kept it from being graded
    full     also how many of the cases were right, and which parts of an answer were not

On no level is there an input, an expected value or a reference, nor anything that the
learner's code made: what was run could have written a hidden input there.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

from markupsafe import Markup

from tflab.text import Text, Texts
from tflab.workbook.course.course import read_course

from ..submissions.remarks import Remark
from .html import page, prose, render

__all__ = ["LEVELS", "SIGNS", "TEXTS", "feedback_page"]

LEVELS = ("none", "score", "named", "full")
ONLY_FULL = {"parts", "missing parts", "unit", "frame"}
SIGNS = {"right": "✓", "partly": "◐", "wrong": "✗", "unanswered": "–", "trouble": "!", "missing": "–"}
TEXTS = Texts(__file__)


def feedback_page(record: Mapping[str, Any], titles: Mapping[str, Mapping[str, Text]], level: str) -> str:
    """Return a learner's page as HTML.

    Args:
        titles: of the tasks, by chapter and task.
        level: "score", "named" or "full".
    """
    language, who = record["language"], record["name"] or record["learner"]
    chapters = [_chapter(stem, chapter, titles[stem], level, language) for stem, chapter in record["chapters"].items()]
    lines = _lines(record["remarks"], language)
    body = render("feedback.html", TEXTS, language, record=record, who=who, chapters=chapters, level=level, lines=lines)
    return page(f"{TEXTS['title'].say(language)} · {who}", language, body)


def _chapter(
    stem: str, chapter: Mapping[str, Any], titles: Mapping[str, Text], level: str, language: str
) -> dict[str, Any]:
    rows = chapter["tasks"]
    title = next((one.title for one in read_course().chapters if one.stem == stem), None)
    is_missing = all(row["status"] == "missing" for row in rows.values())
    return {
        "heading": f"{stem[:2]} · {title.say(language) if title else stem[3:].replace('_', ' ')}",
        "points": sum(row["points"] for row in rows.values()),
        "most": sum(row["most"] for row in rows.values()),
        "tasks": [] if is_missing else [_task(name, row, titles[name], level, language) for name, row in rows.items()],
        "lines": _lines(chapter["remarks"], language),
    }


def _task(task_id: str, row: Mapping[str, Any], title: Text, level: str, language: str) -> dict[str, Any]:
    lines = [Text(**row["said"]).say(language)] if row["said"] else []
    remarks = [Remark.from_plain(remark) for remark in row["remarks"]]
    shown = [remark for remark in remarks if level == "full" or remark.kind not in ONLY_FULL]
    lines += [remark.say(language, with_task=False) for remark in shown]
    if row["status"] in ("wrong", "partly") and not lines:
        lines.append(TEXTS["not_right"].say(language))
    if level == "full" and row["status"] in ("partly", "wrong", "right") and row["of"] > 1:
        lines.append(TEXTS["cases"].say(language, passed=row["passed"], of=row["of"]))
    return {**row, "id": task_id, "title": title.say(language), "sign": SIGNS[row["status"]], "lines": lines}


def _lines(remarks: Iterable[Mapping[str, Any]], language: str) -> list[Markup]:
    """Return remarks as lines, each once."""
    return [prose(line) for line in dict.fromkeys(Remark.from_plain(remark).say(language) for remark in remarks)]
