"""What is printed and cut before a lecture?  Cards to raise, prediction sheets, blank tables, exit tickets.

    +-----+-----+-----+      one sheet a learner: 1 A, 2 B, 3 C, 4 D, ?
    |  1  |  2  |  ?  |
    +-----+-----+-----+

All of it is the page's: a table is blank where the page's has words.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from tflab.text import Text

from ..reports.html import text
from .lecture import LecturedPage
from .sheets import grid, inline, markdown, sheet
from .teaching import BlankTable, Teaching

__all__ = ["cards", "without_answers"]

TITLE = Text("To print and cut", "인쇄해서 자를 것")
RAISE = Text(
    "Vote cards: one sheet for each learner, cut into six, raised all at once.",
    "투표 카드: 한 사람에 한 장씩, 여섯 조각으로 자르고 다 함께 듭니다.",
)
PREDICT = Text("Prediction sheet", "예측지")
BLANK = Text("To fill by shouting", "함께 채울 표")
NAME = Text("Name", "이름")
NUMBER = Text("{number:02} · {title}", "{number:02} · {title}")
FACES = ("1 A", "2 B", "3 C", "4 D", "5 E", "?")
PREDICTIONS = ("predict", "predict-error", "predict-question")  # what pages call the cell that asks for them
LINES, TICKETS = 4, 3
FOLD = re.compile(r"<details>.*?</details>", re.DOTALL)


def cards(lectures: Sequence[tuple[Teaching, LecturedPage]], language: str) -> str:
    """Return what is printed for some chapters, as a page."""
    faces = "".join(f'<div class="face">{face}</div>' for face in FACES)
    body = [f'<div class="sheet"><p class=quiet>{text(RAISE.say(language))}</p><div class="cut">{faces}</div></div>']
    for teaching, page in lectures:
        body += _of_chapter(teaching, page, language)
    return sheet(TITLE.say(language), language, body, "cards.css")


def without_answers(table: str, keep: Sequence[int]) -> str:
    """Return a Markdown table whose columns are blank but for some, counted from 1; its heads stay."""
    rows = [line for line in table.splitlines() if line.startswith("|")]
    blank = []
    for number, row in enumerate(rows):
        cells = re.split(r"(?<!\\)\|", row.strip().strip("|"))
        if number > 1:
            cells = [cell if column in keep else " " for column, cell in enumerate(cells, start=1)]
        blank.append(f"|{'|'.join(cells)}|")
    return "\n".join(blank)


def _of_chapter(teaching: Teaching, page: LecturedPage, said: str) -> Iterator[str]:
    title = re.search(r"^# (.*)$", page.cells.get("title", ""), re.MULTILINE)
    name = title[1] if title else teaching.stem
    lines = '<div class="line"></div>' * LINES
    who = f"<p>{text(NAME.say(said))}: ____________________</p>"
    for cell in PREDICTIONS:
        if cell in page.cells:
            asked = FOLD.sub("", re.sub(r"^#+ .*$", "", page.cells[cell], count=1, flags=re.MULTILINE))
            heading = f"<h2>{inline(name)} · {text(PREDICT.say(said))}</h2>"
            yield f'<div class="sheet">{heading}{who}{markdown(asked)}{lines}</div>'
    for table in teaching.tables:
        html = _blank(table, page)
        yield f'<div class="sheet blank"><h2>{inline(name)} · {text(BLANK.say(said))}</h2>{html}</div>'
    ticket = page.ticket()
    if ticket is not None:
        slip = f'<div class="slip"><p><b>{inline(name)}</b></p>{who}{markdown(ticket.asked)}{lines}</div>'
        yield f'<div class="sheet">{slip * TICKETS}</div>'


def _blank(table: BlankTable, page: LecturedPage) -> str:
    if table.heads is None:
        return markdown(without_answers(page.cells[table.cell], table.keep))
    heads = table.heads.say(page.language).split("|")
    return grid(heads, [[text(row), *[""] * (len(heads) - 1)] for row in table.rows])
