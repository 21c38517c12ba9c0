"""What does one see first?  The chapters with their questions and minutes, how to run them, the conventions.

```
index.html           of each language; and one above, which asks the browser for its own
conventions.html     which side, which order, which units: `static/conventions.en.md`, `.ko.md`
```
"""

from __future__ import annotations

from collections.abc import Sequence
from html import escape

from ...text import LANGUAGES, Text
from ..course.course import read_course
from ..paths import exercise_file
from .frame import STATIC, BookPage

__all__ = ["CONVENTIONS", "conventions_text", "door", "front_page"]

CONVENTIONS = Text(en="Conventions", ko="규약")
TITLE = Text(en="A book that runs: ROS 2 TF2", ko="실행되는 책: ROS 2 TF2")
LEAD = Text(
    en="On a robot, every number has a frame and a moment. This book teaches ROS 2 <strong>TF2</strong>, coordinate "
    "frames, transforms and the time that belongs to them, to people who have only Python: no robot, no ROS.",
    ko="로봇에서는 모든 숫자에 좌표계와 측정 시각이 있습니다. 이 워크북에서는 ROS 2의 <strong>TF2</strong>, 곧 "
    "좌표계와 변환, 그리고 그 시각을 처음부터 배웁니다. 파이썬 기초만 알면 됩니다. 로봇도 ROS도 필요 없습니다.",
)
CHAPTERS = Text(en="Chapters", ko="장")
MINUTES = Text(en="{n} min", ko="{n}분")
EXERCISE = Text(en="exercise", ko="연습 문제")
TO_COME = Text(en="To come: {titles}.", ko="준비 중: {titles}.")
LOOK_UP = Text(en="To look up", ko="찾아보기")
REFERENCE = Text(en="Reference of the code", ko="코드 레퍼런스(영어)")
RUN = Text(en="Run it yourself", ko="직접 실행하기")
HOW = Text(
    en="Here you read. In the workbook you run: every cell, every exercise, and a wrong answer is told "
    "<em>which</em> mistake it is. You need Python 3.10 or newer:",
    ko="여기서는 읽기만 합니다. 워크북에서는 모든 셀과 연습 문제를 실행하고, 답이 틀리면 "
    "<em>어떤</em> 실수인지 알려 줍니다. 파이썬 3.10 이상이 필요합니다.",
)
COMMANDS = 'pip install "tflab[all]"\ntflab lab'
COMMANDS_KO = f"{COMMANDS} --lang ko"


def front_page(book: Sequence[BookPage], language: str, *, has_reference: bool) -> str:
    """Return the first page's text as HTML; the chapters are those of `book`."""
    files = {page.file: page for page in book}
    rows, to_come, exercises = [], [], set()
    for chapter in read_course().chapters:
        title = f"{chapter.number:02} · {chapter.title.say(language)}"
        if f"{chapter.stem}.html" not in files:
            to_come.append(chapter.title.say(language))
            continue
        exercise = exercise_file(chapter.stem).replace(".ipynb", ".html")
        exercises.add(exercise)
        more = f' · <a href="{exercise}">{EXERCISE.say(language)}</a>' if exercise in files else ""
        rows.append(
            f'<li><a class="book-chapter" href="{chapter.stem}.html">{escape(title)}</a>'
            f"<span>{escape(chapter.question.say(language))}</span>"
            f"<small>{MINUTES.say(language, n=chapter.minutes)}{more}</small></li>\n"
        )
    others = [page for page in book if not page.is_chapter and page.file not in exercises]
    look_up = [f'<li><a href="{page.file}">{escape(page.title)}</a></li>' for page in others]
    if has_reference:
        look_up.append(f'<li><a href="../reference/tflab.html">{REFERENCE.say(language)}</a></li>')
    commands = COMMANDS_KO if language == "ko" else COMMANDS
    coming = f"<p>{escape(TO_COME.say(language, titles=', '.join(to_come)))}</p>\n" if to_come else ""
    return (
        f'<h1 id="tflab">{TITLE.say(language)}</h1>\n<p class="book-lead">{LEAD.say(language)}</p>\n'
        f'<h2 id="chapters">{CHAPTERS.say(language)}</h2>\n<ol class="book-chapters">\n{"".join(rows)}</ol>\n{coming}'
        f'<h2 id="look-up">{LOOK_UP.say(language)}</h2>\n<ul>{"".join(look_up)}</ul>\n'
        f'<h2 id="run">{RUN.say(language)}</h2>\n<p>{HOW.say(language)}</p>\n<pre><code>{commands}</code></pre>'
    )


def conventions_text(language: str) -> str:
    """Return the conventions as Markdown."""
    return (STATIC / f"conventions.{language}.md").read_text(encoding="utf-8")


def door() -> str:
    """Return the page above the languages: it leads to the browser's own, and without a script it asks."""
    links = "".join(
        f'<li><a lang="{code}" href="{code}/index.html">{name}</a></li>'
        for code, name in zip(LANGUAGES, ("English", "한국어"), strict=True)
    )
    return (
        '<!DOCTYPE html>\n<html lang="en">\n<head><meta charset="utf-8">\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1.0">\n<title>tflab</title>\n'
        "<script>location.replace((navigator.language.startsWith('ko') ? 'ko' : 'en') + '/index.html');</script>\n"
        f"</head>\n<body><main><h1>tflab</h1><ul>{links}</ul></main></body>\n</html>\n"
    )
