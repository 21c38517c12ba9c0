"""Write the guide of a chapter as HTML, and the six patients of the last chapter.

    1 what they can do afterwards      4 what is shown live      7 marking
    2 what they bring                  5 votes                   8 the exit ticket
    3 the minutes                      6 questions of the class  9 what follows

A patient is a file in solutions/teaching/patients: `said`, `command` and `text` are shown to
the class; `rules_out`, `next`, `no_timeout` and `truth` are the answers. They were made by
the clinic from a public number; a test compares.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

from tflab.text import Text
from tflab.workbook.course.course import Chapter, Course
from tflab.workbook.paths import workbook_data
from tflab.workbook.tasks.misconceptions import MISCONCEPTIONS
from tflab.workbook.tasks.task import Task

from ..reports.html import text
from .layout import grid, inline, markdown
from .lecture import LecturedPage
from .teaching import (
    LATER,
    RULES,
    TEACHING,
    Demo,
    Marking,
    PlanRow,
    Teaching,
    TeachingError,
    Vote,
    as_words,
    read_yaml,
    said_once,
    votes_of,
)

__all__ = ["BoardPatient", "board_patients", "chapter_guide", "patients_section"]

WHO = {
    "you": Text("you", "강사"),
    "room": Text("the room", "모두"),
    "pairs": Text("pairs", "둘씩"),
    "each": Text("each alone", "각자"),
}
LENGTH = Text("{talk} minutes of talk, {lab} of laboratory", "강의 {talk}분, 실습 {lab}분")
NO_LAB = Text("{talk} minutes", "{talk}분")
AFTERWARDS = Text("What they can do afterwards", "마치면 할 수 있는 것")
KEEP = Text("What they are to keep (the page's last words; read them first)", "남길 것(본문의 정리. 먼저 읽으십시오)")
BRING = Text("What they bring", "학습자가 아는 것")
LACKS = Text("What is usually missing", "흔히 빠져 있는 것")
TEST = Text("One question to test it", "확인할 질문 하나")
MINUTES = Text("The minutes", "분 단위 계획")
MINUTE_HEADS = (
    Text("Minute", "분"),
    Text("On the screen", "화면"),
    Text("Who", "누가"),
    Text("What happens", "하는 일"),
)
LATE = Text("Late:", "늦었으면:")
NOTES = Text("Note on the slide:", "발표자 노트:")
LAB = Text("laboratory", "실습")
DEMOS = Text("What to show live", "직접 보일 것")
DEMO_CELL = Text("Cell {cell}, on the slide “{slide}”", "셀 {cell}, 슬라이드 “{slide}”")
OFF_SLIDE = Text("Cell {cell} of the page", "본문의 셀 {cell}")
DO, SEE = Text("Do:", "할 일:"), Text("Must be seen:", "보여야 하는 것:")
FAILS = Text("If it fails:", "안 되면:")
FIGURE = Text("(cell {cell})", "(셀 {cell})")
TYPES = Text("Type into new cells:", "새 셀에 입력:")
VOTES = Text("Votes", "투표")
VOTE_NUMBER = Text("Vote {number}", "투표 {number}")
AFTER = Text("After the slide “{slide}”.", "슬라이드 “{slide}” 다음에 합니다.")
VOTE_HEADS = (Text("", ""), Text("Option", "보기"), Text("Expected", "예상"), Text("What to say", "할 말"))
GUESS = Text("{expected} % (guess)", "{expected} % (짐작)")
RIGHT = Text("right", "정답")
ROOM = Text("What the room asks", "나올 만한 질문")
MARKING = Text("Marking", "채점")
IDEAS = Text("One point an idea, in any words:", "내용 하나에 1점, 표현은 자유입니다.")
FULL, HALF, WRONG = Text("Full", "만점"), Text("Half", "절반"), Text("Wrong", "오답")
HAS = Text("{got} of {most}: ideas {ideas}", "{most}점 중 {got}점: {ideas}번 내용")
BEHIND = Text("behind it: {name} ({code})", "바탕에 있는 생각: {name}({code})")
ELSEWHERE = Text("Samples are in the guide of chapter {number}.", "답안 예시는 {number}장의 안내서에 있습니다.")
TICKET = Text("The exit ticket", "마무리 쪽지")
COMPARE = Text("Compare with:", "맞춰 볼 것:")
PILES = (
    ("full", Text("Has it", "됨")),
    ("half", Text("Half", "절반")),
    ("none", Text("Not yet", "아직")),
)
FOLLOWS = Text("What follows", "이어지는 것")
TASK_HEADS = (
    Text("Task", "과제"),
    Text("", ""),
    Text("Points", "점수"),
    Text("Numbers of one's own", "사람마다 다른 숫자"),
    Text("Cures", "다루는 오개념"),
)
YES, NO = Text("yes", "예"), Text("no", "아니요")


def chapter_guide(
    teaching: Teaching,
    page: LecturedPage,
    course: Course,
    tasks: Mapping[str, Task],
    marked_in: Mapping[int, int],
) -> str:
    """Return a chapter's guide as HTML.

    Args:
        tasks: those of the chapter.
        marked_in: the chapter whose guide has the samples of each practice question.
    """
    said = page.language
    chapter = next(one for one in course.chapters if one.stem == teaching.stem)
    length = (LENGTH if chapter.lab else NO_LAB).say(said, talk=chapter.talk, lab=chapter.lab)
    parts = [
        f'<section class="chapter" id="ch{chapter.number:02}">',
        f"<h1>{chapter.number:02} · {text(chapter.title.say(said))}</h1>",
        f"<p><b>{text(chapter.question.say(said))}</b> <span class=quiet>{text(length)}</span></p>",
        _heading(1, AFTERWARDS, said),
        _bullets(page.objectives()),
        f"<h3>{text(KEEP.say(said))}</h3>",
        markdown(page.recap()),
        *_brings(teaching, said),
        _heading(3, MINUTES, said),
        _minutes(teaching.plan, page),
        *_demos(teaching.demos, page),
        *_votes(votes_of(teaching, page), page),
        _heading(6, ROOM, said),
        *(f"<p><b>{inline(ask.say(said))}</b><br>{inline(answer.say(said))}</p>" for ask, answer in teaching.questions),
        *_marking(teaching, chapter, page, course, marked_in),
        *_ticket(teaching, page),
        _heading(9, FOLLOWS, said),
        _tasks(tasks, said),
        f"<p>{inline(teaching.handover.say(said))}</p>",
        "</section>",
    ]
    return "\n".join(filter(None, parts))


def _heading(number: int, words: Text, language: str) -> str:
    return f"<h2>{number} · {text(words.say(language))}</h2>"


def _bullets(lines: Sequence[str]) -> str:
    return f"<ul>{''.join(f'<li>{inline(line)}</li>' for line in lines)}</ul>" if lines else ""


def _brings(teaching: Teaching, said: str) -> Iterator[str]:
    brings = teaching.brings
    yield _heading(2, BRING, said)
    yield f"<p>{inline(brings['has'].say(said))}</p>"
    yield f"<p><b>{text(LACKS.say(said))}:</b> {inline(brings['lacks'].say(said))}</p>"
    asked, answer = (inline(brings[name].say(said)) for name in ("ask", "answer"))
    yield f"<p><b>{text(TEST.say(said))}:</b> {asked}<br>→ {answer}</p>"


# -- the plan and the demonstrations ---------------------------------------------------------


def _minutes(plan: Sequence[PlanRow], page: LecturedPage) -> str:
    said, rows, clock = page.language, [], {"talk": 0, "lab": 0}
    slides = [row.slide for row in plan if row.slide]
    for row in plan:
        kind = "lab" if row.lab else "talk"
        begin, clock[kind] = clock[kind], clock[kind] + row.minutes
        at = slides.index(row.slide) if row.slide else 0
        screen = _screen(row.slide, (*slides[at + 1 :], None)[0], page) if row.slide else ", ".join(row.lab)
        what = inline(row.do.say(said))
        if row.late:
            what += f"<br><span class=quiet><b>{text(LATE.say(said))}</b> {inline(row.late.say(said))}</span>"
        when = f"{begin}–{clock[kind]}" + (f"<br>{text(LAB.say(said))}" if row.lab else "")
        rows.append((when, screen, text(WHO[row.who].say(said)), what))
    return grid([head.say(said) for head in MINUTE_HEADS], rows, kind="minutes")


def _screen(begin: str, end: str | None, page: LecturedPage) -> str:
    """Return the titles of the slides of a row, and what is said to the speaker on them."""
    slides = page.screen(begin, end)
    titles = "<br>".join(text(title) for title in dict.fromkeys(slide.title for slide in slides))
    notes = [note for slide in slides for note in page.notes_of(slide)]
    heard = "".join(f"<br><i>{inline(note)}</i>" for note in notes)
    return f"{titles}<span class=quiet>{heard}</span>"


def _demos(demos: Sequence[Demo], page: LecturedPage) -> Iterator[str]:
    said = page.language
    yield _heading(4, DEMOS, said)
    for number, demo in enumerate(demos, start=1):
        at = page.shown.get(demo.cell)
        place = OFF_SLIDE if at is None else DEMO_CELL
        where = place.say(said, cell=demo.cell, slide=page.slides[at or 0].title)
        fails = inline(demo.fails.say(said))
        if demo.figure:
            fails += f" <span class=quiet>{text(FIGURE.say(said, cell=demo.figure))}</span>"
        yield f'<div class="card"><p><b>{number}. {text(where)}</b></p>'
        yield f"<p>{text(DO.say(said))} {inline(demo.do.say(said))}</p>"
        if demo.types:
            yield f"<p>{text(TYPES.say(said))}</p><pre><code>{text(demo.types)}</code></pre>"
        yield f"<p><b>{text(SEE.say(said))}</b> {inline(demo.see.say(said))}</p>"
        yield f"<p><b>{text(FAILS.say(said))}</b> {fails}</p></div>"


# -- votes -------------------------------------------------------------------------------------


def _votes(votes: Sequence[Vote], page: LecturedPage) -> Iterator[str]:
    said = page.language
    yield _heading(5, VOTES, said)
    yield f"<ul class=quiet>{''.join(f'<li>{text(rule.say(said))}</li>' for rule in RULES)}</ul>"
    for number, vote in enumerate(votes, start=1):
        slide = page.slides[page.shown[vote.after]].title
        yield f"<h3>{text(VOTE_NUMBER.say(said, number=number))} <code>{text(vote.name)}</code></h3>"
        when = AFTER.say(said, slide=slide)
        if vote.answered:
            when += " " + LATER.say(said, slide=page.slides[page.shown[vote.answered]].title)
        yield f"{markdown(vote.question)}<p class=quiet>{text(when)}</p>"
        rows = [
            (
                text(option.label),
                inline(option.text) + (f" ✓ {text(RIGHT.say(said))}" if option.is_right else ""),
                text(GUESS.say(said, expected=f"{option.expected:g}")),
                markdown(option.say),
            )
            for option in vote.options
        ]
        right = [at for at, option in enumerate(vote.options) if option.is_right]
        yield grid([head.say(said) for head in VOTE_HEADS], rows, kind="votes", marked=right)


# -- marking, the ticket, what follows ------------------------------------------------------------


def _marking(
    teaching: Teaching, chapter: Chapter, page: LecturedPage, course: Course, marked_in: Mapping[int, int]
) -> Iterator[str]:
    said = page.language
    if not chapter.practice:
        return
    yield _heading(7, MARKING, said)
    markings = {marking.question: marking for marking in teaching.markings}
    for question, ideas in zip(chapter.practice, page.rubrics(), strict=False):
        yield f"<h3>Q{question} · {text(course.questions[question - 1].say(said))}</h3>"
        yield f"<p>{text(IDEAS.say(said))}</p><ol>{''.join(f'<li>{inline(idea)}</li>' for idea in ideas)}</ol>"
        if question in markings:
            yield from _samples(markings[question], len(ideas), said)
        elif question in marked_in:
            yield f"<p class=quiet>{text(ELSEWHERE.say(said, number=f'{marked_in[question]:02}'))}</p>"


def _samples(marking: Marking, most: int, said: str) -> Iterator[str]:
    ideas = marking.half.ideas
    got = HAS.say(said, got=len(ideas), most=most, ideas=", ".join(map(str, ideas)))
    behind = BEHIND.say(said, name=MISCONCEPTIONS[marking.because].say(said), code=marking.because)
    yield grid(
        ("", "", ""),
        [
            (text(FULL.say(said)), inline(marking.full.say(said)), f"{most} / {most}"),
            (text(HALF.say(said)), inline(marking.half.words.say(said)), text(got)),
            (text(WRONG.say(said)), inline(marking.wrong.say(said)), text(behind)),
        ],
    )
    if marking.note:
        yield f"<p>{inline(marking.note.say(said))}</p>"


def _ticket(teaching: Teaching, page: LecturedPage) -> Iterator[str]:
    said, ticket = page.language, page.ticket()
    if ticket is None:
        return
    yield _heading(8, TICKET, said)
    yield markdown(ticket.asked)
    yield f"<p><b>{text(COMPARE.say(said))}</b> {inline(ticket.compare)}</p>"
    yield grid(("", ""), [(text(name.say(said)), inline(teaching.ticket[pile].say(said))) for pile, name in PILES])


def _tasks(tasks: Mapping[str, Task], said: str) -> str:
    rows = []
    for name, task in tasks.items():
        own = YES if task.variants > 1 else NO
        cures = ", ".join(
            f"{MISCONCEPTIONS[code].say(said)} ({code})" for code in task.misconceptions if code in MISCONCEPTIONS
        )
        rows.append((text(name), text(task.title.say(said)), text(task.points), text(own.say(said)), text(cures)))
    return grid([head.say(said) for head in TASK_HEADS], rows) if rows else ""


FOLDER = "patients"
SPOKEN = ("said", "rules_out", "next", "no_timeout", "truth")
TITLE = Text("Six patients for the board, and the oral clinic", "칠판용 환자 여섯과 구술 진료")
HOW = Text(
    "On the board: read the complaint, show the output, ask the three questions. As an examination, five minutes and "
    "one patient: a point each for reading the output, for what it rules out, for a cheap next question, and for a "
    "proof. Nobody has to name the cause at once; who names it without a proof has three points at most.",
    "칠판에서는 증상을 읽고 출력을 보인 다음 세 가지를 묻습니다. 시험에서는 5분에 환자 하나입니다. "
    "출력 읽기, 지워지는 것, 값싼 다음 질문, 증명에 1점씩입니다. "
    "원인을 바로 맞히지 않아도 됩니다. 증명 없이 원인만 맞히면 3점까지입니다.",
)
ASKED = (
    ("rules_out", Text("What does this rule out?", "이것으로 무엇이 지워집니까?")),
    ("next", Text("What would you ask next, and why?", "다음에는 무엇을, 왜 묻겠습니까?")),
    ("no_timeout", Text("Why not a longer timeout?", "왜 timeout을 늘리지 않습니까?")),
    ("truth", Text("Truth", "실제 원인")),
)


class BoardPatient(NamedTuple):
    """One patient; `words` holds what is said, by its name in the file."""

    cause: str
    number: int
    check: str
    command: str
    text: str
    words: dict[str, Text]


def board_patients(data: Path | None = None) -> list[BoardPatient]:
    """Return the patients, in order; none where there are none.

    Raises:
        TeachingError: a file lacks something, or says it in one language.
    """
    found, faults = [], []
    for path in sorted(((data or workbook_data()) / TEACHING / FOLDER).glob("*.yaml")):
        shown = f"{FOLDER}/{path.name}"
        plain = read_yaml(path, shown)
        lacks = [name for name in (*BoardPatient._fields[:-1], *SPOKEN) if name not in plain]
        faults += [f"{shown} lacks `{name}`" for name in lacks] + list(said_once(plain, f"{shown}:"))
        if not lacks:
            words = {name: as_words(plain[name]) for name in SPOKEN}
            found.append(BoardPatient(*(plain[name] for name in BoardPatient._fields[:-1]), words))
    if faults:
        raise TeachingError(*faults)
    return found


def patients_section(patients: list[BoardPatient], language: str) -> str:
    """Return the patients as a part of a guide."""
    parts = [
        f'<section class="chapter" id="patients"><h1>{text(TITLE.say(language))}</h1><p>{text(HOW.say(language))}</p>'
    ]
    for number, patient in enumerate(patients, start=1):
        said = patient.words
        rows = [(text(asked.say(language)), inline(said[name].say(language))) for name, asked in ASKED]
        parts.append(
            f"<h3>{number}. “{text(said['said'].say(language))}”</h3>"
            f"<pre><code>$ {text(patient.command)}\n{text(patient.text.rstrip())}</code></pre>{grid(('', ''), rows)}"
        )
    return "\n".join([*parts, "</section>"])
