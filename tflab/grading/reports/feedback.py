"""What does a learner read?  One page in their language: points, and the names of the mistakes.

    none     nothing is written
    score    what each chapter got
    named    what each task got, which mistake an answer is, and what kept it from being graded
    full     also how many of the cases were right, and which parts of an answer were not

On no level is there an input, an expected value or a reference, nor anything that
the learner's code made: what was run could have written a hidden input there.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache
from typing import Any

from tflab.text import Text
from tflab.workbook.course.course import read_course

from ..submissions.remarks import Remark
from .html import page, points, prose, rows, text

__all__ = ["LEVELS", "STATUS", "feedback_page"]

LEVELS = ("none", "score", "named", "full")
ONLY_FULL = {"parts", "missing parts", "unit", "frame"}

TITLE = Text("Your exercises", "연습 문제 결과")
OF = Text("{points} of {most} points", "{most}점 만점에 {points}점")
FOR = Text("for {name}", "{name}")
HEADS = (Text("Task", "과제"), Text("", ""), Text("Points", "점수"), Text("What there is to say", "의견"))
CASES = Text("{passed} of {of} checks right.", "확인 항목 {of}개 중 {passed}개가 맞습니다.")
ABOUT_CHAPTER = Text("About the notebook", "노트북에 대하여")
ABOUT_FILES = Text("About what was handed in", "제출한 파일에 대하여")
HOW = Text(
    "Values were judged on your own variant, functions on inputs that nobody has seen before. "
    "To find out more, run the checks in your notebook: they tell you about the inputs there.",
    "값은 자신의 변형 문제로, 함수는 공개하지 않은 입력으로 채점했습니다. "
    "더 알아보려면 노트북의 check를 실행하십시오. 그쪽 입력에 대해서는 자세히 알려 줍니다.",
)
WRONG = Text("The result is not right yet.", "결과가 아직 맞지 않습니다.")
NOT_HANDED_IN = Text("Not handed in.", "제출되지 않았습니다.")
STATUS = {
    "right": ("✓", Text("right", "정답")),
    "partly": ("◐", Text("partly right", "일부 정답")),
    "wrong": ("✗", Text("not right", "오답")),
    "unanswered": ("–", Text("not answered", "미응답")),
    "trouble": ("!", Text("could not be judged", "채점 불가")),
    "missing": ("–", Text("not handed in", "미제출")),
}


def feedback_page(record: Mapping[str, Any], titles: Mapping[str, Mapping[str, Text]], level: str) -> str:
    """Return a learner's page as HTML.

    Args:
        titles: of the tasks, by chapter and task.
        level: "score", "named" or "full".
    """
    language = record["language"]
    total = OF.say(language, points=points(record["points"]), most=points(record["most"]))
    who = record["name"] or record["learner"]
    body = [
        f"<h1>{text(TITLE.say(language))}</h1>",
        f'<p class="quiet">{text(FOR.say(language, name=who))}</p>',
        f'<p class="total">{text(total)}</p>',
    ]
    for stem, chapter in record["chapters"].items():
        body += _chapter(stem, chapter, titles[stem], level, language)
    if level != "score":
        lines = [Remark.from_plain(remark).say(language) for remark in record["remarks"]]
        body += _about(ABOUT_FILES.say(language), lines)
        body.append(f'<p class="quiet">{text(HOW.say(language))}</p>')
    return page(f"{TITLE.say(language)} · {who}", language, body)


def _chapter(stem: str, chapter: Mapping[str, Any], titles: Mapping[str, Text], level: str, language: str) -> list[str]:
    of_chapter = chapter["tasks"].values()
    got, most = (points(sum(row[name] for row in of_chapter)) for name in ("points", "most"))
    title = _titles().get(stem)
    heading = f"{stem[:2]} · {title.say(language) if title else stem[3:].replace('_', ' ')}"
    score = OF.say(language, points=got, most=most)
    body = [f"<h2>{text(heading)}</h2>", f"<p>{text(score)}</p>"]
    if level == "score":
        return body
    if all(row["status"] == "missing" for row in of_chapter):
        return [*body, f"<p>{text(NOT_HANDED_IN.say(language))}</p>"]
    cells = [_task(task_id, row, titles[task_id], level, language) for task_id, row in chapter["tasks"].items()]
    lines = [Remark.from_plain(remark).say(language) for remark in chapter["remarks"]]
    table = rows([head.say(language) for head in HEADS], cells, numbers=(2,), widths=(28, 17, 11, 44))
    return [*body, table, *_about(ABOUT_CHAPTER.say(language), lines)]


def _task(task_id: str, row: Mapping[str, Any], title: Text, level: str, language: str) -> tuple[str, str, str, str]:
    sign, status = STATUS[row["status"]]
    said = []
    if row["said"]:
        said.append(Text(**row["said"]).say(language))
    remarks = [Remark.from_plain(remark) for remark in row["remarks"]]
    shown = [remark for remark in remarks if level == "full" or remark.kind not in ONLY_FULL]
    said += [remark.say(language, with_task=False) for remark in shown]
    if row["status"] in ("wrong", "partly") and not said:
        said.append(WRONG.say(language))
    if level == "full" and row["status"] in ("partly", "wrong", "right") and row["of"] > 1:
        said.append(CASES.say(language, passed=row["passed"], of=row["of"]))
    return (
        f"<b>{text(task_id)}</b> {text(title.say(language))}",
        f"{sign}&nbsp;{text(status.say(language))}",
        f"{points(row['points'])} / {points(row['most'])}",
        "<br>".join(map(prose, said)),
    )


@lru_cache(maxsize=1)
def _titles() -> dict[str, Text]:
    return {chapter.stem: chapter.title for chapter in read_course().chapters}


def _about(heading: str, lines: list[str]) -> list[str]:
    items = "".join(f"<li>{prose(line)}</li>" for line in dict.fromkeys(lines))
    return [f'<div class="card"><b>{text(heading)}</b><ul>{items}</ul></div>'] if items else []
