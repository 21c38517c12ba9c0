"""What is a learner shown once both forms are in?  What was learnt, what to read again, and both forms with their key.

    Before: 5 right, 4 of them sure. After: 13 right, 12 of them sure.
    cured 8 · held 5 · stuck 2 · lost 0
    Sure and wrong before, right now: 3 ...
    Still to do: 7 what the map program announces -> chapter 05, task E5.1
    form A, form B: a sentence for each option

Nobody learns the key before form B is in, and nobody is given a number for what they
gained: fifteen items are too few to measure one person.
"""

from __future__ import annotations

import html
from base64 import b64encode
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING

from tflab.views.slope_chart import draw_gain

from ...text import Text
from ..paths import chapters
from ..progress import read_progress
from ..tasks.task import chapter_of
from .change import changes, relearnt
from .items import FORMS, Item, read_inventory
from .questions import DO_NOT_KNOW
from .replies import Reply, replies_to

if TYPE_CHECKING:
    from tflab.views.picture import Picture

__all__ = ["LIMITS", "Opened", "opened", "waiting"]

TITLE = Text("Fifteen questions, before and after", "열다섯 문제, 처음과 끝")
RIGHT = Text("{right} right, {sure} of them sure", "{right}개 맞음(그중 {sure}개는 확신)")
BEFORE = Text("Before: {first}. After: {then}.", "처음: {first}. 끝: {then}.")
ONLY_AFTER = Text(
    "{then}. Form A was not answered, so there is no before.",
    "{then}. A형에 답하지 않아 처음과 비교할 수 없습니다.",
)
STATES = {
    "cured": Text("cured", "바로잡음"),
    "held": Text("held", "지킴"),
    "stuck": Text("stuck", "그대로"),
    "lost": Text("lost", "놓침"),
}
SIGNS = {"cured": "▲", "held": "●", "stuck": "○", "lost": "▽"}
RELEARNT = Text(
    "What you have really learnt: you were sure of it and wrong, and now you are right.",
    "정말로 새로 배운 것: 처음에는 확신했지만 틀렸고, 이제는 맞았습니다.",
)
TO_DO = Text("Where to go now", "이제 다시 볼 곳")
WHERE = Text(
    "{number} · {about} → chapter {chapter:02}, task {task}", "{number} · {about} → {chapter:02}장, 과제 {task}"
)
CAPTION = Text(
    "In the picture: a row for each question, what you said before and after.",
    "그림 읽기: 줄마다 문제 하나. before 처음, after 끝 · right 맞음, wrong 틀림, sure 확신, guessed 짐작, "
    "not known 모름 · cured 바로잡음, held 지킴, stuck 그대로, lost 놓침.",
)
LIMITS = Text(
    "This is a small test, and it has not been validated yet. It tells you what to look at again; "
    "it is not made to compare people.",
    "작은 시험이고, 아직 타당성을 검증하지 않았습니다. 무엇을 다시 볼지 알려 줄 뿐 사람을 비교하는 데 쓰지 않습니다.",
)
FORM = Text("Form {form}, with a sentence for each option", "{form}형: 보기마다 한 문장씩")
YOURS = Text("your answer", "내 답")
GUESSED = Text("your guess", "짐작한 답")
TO_DO = Text(
    "The one task of 00, E0.1, is fifteen questions to answer before you begin. Any answers pass it.",
    "00의 과제 하나(E0.1)는 시작하기 전에 푸는 열다섯 문제입니다. 맞든 틀리든 모두 답하면 통과합니다.",
)
WAITING = Text(
    "Fifteen questions: your first answers are kept. Both forms open when you have answered the second, E12.8.",
    "열다섯 문제: 처음 답을 보관했습니다. 마지막의 E12.8에 답하면 시험지 두 장이 함께 열립니다.",
)


def opened(root: Path, language: str) -> Opened | None:
    """Return what is open in the copy at `root`; None before form B is in."""
    kept = read_progress(root)
    before, after = (kept[task].answers if task in kept else {} for task in FORMS.values())
    items = read_inventory()
    return Opened(items, before, after, language) if after and items else None


def waiting(root: Path, language: str) -> str:
    """Return a line where form B is not in: what to do, or what is kept; "" else, and where the forms are not."""
    kept = read_progress(root)
    before, after = (bool(task in kept and kept[task].answers) for task in FORMS.values())
    if after or not {chapter_of(task) for task in FORMS.values()} <= {int(stem[:2]) for stem in chapters(root)}:
        return ""
    return (WAITING if before else TO_DO).say(language)


class Opened:
    """Both forms, and what came of them: as HTML on a page, as text in a terminal."""

    def __init__(
        self, items: Sequence[Item], before: Mapping[str, str], after: Mapping[str, str], language: str
    ) -> None:
        self._items, self._language = items, language
        self._replies = {"A": replies_to(items, "A", before), "B": replies_to(items, "B", after)}
        self._changes = changes(items, before, after) if before else []

    def _repr_mimebundle_(self, include=None, exclude=None) -> dict[str, str]:
        return {"text/html": self.html, "text/plain": self.text}

    @cached_property
    def picture(self) -> Picture | None:
        """The marks before and after, where there is a before."""
        if not self._changes:
            return None
        rows = [(str(change.number), change) for change in self._changes]
        return draw_gain(
            {name: change.before.kind for name, change in rows}, {name: change.after.kind for name, change in rows}
        )

    @property
    def summary(self) -> str:
        """What was learnt and where to go, as text, without the forms."""
        return "\n".join([self._say(TITLE), *self._counts(), *self._lists(), "", self._say(LIMITS)])

    @property
    def text(self) -> str:
        """All of it as text."""
        lines = [self.summary]
        for form in FORMS:
            lines += ["", self._say(FORM, form=form)]
            for number, item in enumerate(self._items, start=1):
                lines += ["", f"{number}. {item.forms[form].stem.say(self._language)}"]
                for sign, option, chosen, why in self._options(form, number, item):
                    lines += [f"   {sign} {option} {chosen}".rstrip(), *([f"     {why}"] if why else [])]
        return "\n".join(lines)

    @property
    def html(self) -> str:
        """All of it as a page shows it, in the page's own colours; the forms are folded."""
        style = "max-width: 46em; word-break: keep-all; overflow-wrap: anywhere; line-height: 1.5"
        rows = [f'<div class="tflab-opened" style="{style}"><h3>{html.escape(self._say(TITLE))}</h3>']
        rows += [f"<p>{html.escape(line)}</p>" for line in self._counts()]
        rows += self._html_lists()
        if self.picture is not None:
            source = b64encode(self.picture.png()).decode()
            alt = html.escape(self.picture.text, quote=True)
            width, _ = self.picture.size_px
            rows.append(f'<img src="data:image/png;base64,{source}" width="{width}" alt="{alt}">')
            rows.append(f"<p><small>{html.escape(self._say(CAPTION))}</small></p>")
        rows += [self._html_form(form) for form in FORMS]
        return "".join([*rows, f"<p><small>{html.escape(self._say(LIMITS))}</small></p></div>"])

    # -- what came of it --------------------------------------------------------------------

    def _counts(self) -> Iterator[str]:
        """Yield how many were right, then a sign for each question, then how many there are of each."""
        first, then = (self._right(self._replies[form]) for form in FORMS)
        if not self._changes:
            yield self._say(ONLY_AFTER, then=then)
            return
        yield self._say(BEFORE, first=first, then=then)
        yield " ".join(f"{change.number}{SIGNS[change.state]}" for change in self._changes)
        counts = Counter(change.state for change in self._changes)
        yield " · ".join(f"{SIGNS[state]} {self._say(words)} {counts[state]}" for state, words in STATES.items())

    def _right(self, replies: Sequence[Reply]) -> str:
        right = [reply for reply in replies if reply.is_right]
        return self._say(RIGHT, right=len(right), sure=sum(reply.is_sure for reply in right))

    def _sections(self) -> Iterator[tuple[Text, list[str]]]:
        """Yield what was learnt against one's own certainty first, then where to go for what is wrong now."""
        learnt = [f"{change.number} · {change.item.about.say(self._language)}" for change in relearnt(self._changes)]
        if learnt:
            yield RELEARNT, learnt
        wrong = [number for number, reply in enumerate(self._replies["B"], start=1) if not reply.is_right]
        if wrong:
            yield TO_DO, [self._where(number) for number in wrong]

    def _where(self, number: int) -> str:
        item = self._items[number - 1]
        state = f" ({self._say(STATES[self._changes[number - 1].state])})" if self._changes else ""
        about = item.about.say(self._language) + state
        return self._say(WHERE, number=number, about=about, chapter=chapter_of(item.task), task=item.task)

    def _lists(self) -> Iterator[str]:
        for heading, lines in self._sections():
            yield from ("", self._say(heading), *(f"  {line}" for line in lines))

    def _html_lists(self) -> Iterator[str]:
        for heading, lines in self._sections():
            points = "".join(f"<li>{html.escape(line)}</li>" for line in lines)
            yield f"<p><b>{html.escape(self._say(heading))}</b></p><ul>{points}</ul>"

    # -- the forms --------------------------------------------------------------------------

    def _options(self, form: str, number: int, item: Item) -> Iterator[tuple[str, str, str, str]]:
        """Yield of each option a sign, its letter and text, whether it was chosen, and the sentence on it."""
        reply = self._replies[form][number - 1]
        for letter, option in item.forms[form].options.items():
            sign = "✓" if letter == item.forms[form].right else "✗"
            says, why = option.says.say(self._language), option.why.say(self._language)
            yield sign, f"{letter} {says}", self._chosen(reply, letter), why
        if not reply.letter:
            yield "–", f"e {self._say(DO_NOT_KNOW)}", f"[{self._say(YOURS)}]", ""

    def _chosen(self, reply: Reply, letter: str) -> str:
        if letter != reply.letter:
            return ""
        return f"[{self._say(YOURS if reply.is_sure else GUESSED)}]"

    def _html_form(self, form: str) -> str:
        parts = []
        for number, item in enumerate(self._items, start=1):
            stem = html.escape(item.forms[form].stem.say(self._language))
            points = "".join(map(_html_option, self._options(form, number, item)))
            parts.append(
                f'<p><b>{number}.</b> {stem}</p><ul style="list-style: none; padding-left: 1.2em">{points}</ul>'
            )
        summary = html.escape(self._say(FORM, form=form))
        return f"<details><summary>{summary}</summary>{''.join(parts)}</details>"

    def _say(self, words: Text, **names: object) -> str:
        return words.say(self._language, **names)


def _html_option(row: tuple[str, str, str, str]) -> str:
    """Return one option: the right one and one's own in bold, the sentence below."""
    sign, option, chosen, why = map(html.escape, row)
    head = f"{sign} {option}" + (f" {chosen}" if chosen else "")
    head = f"<b>{head}</b>" if chosen or sign == "✓" else head
    return f"<li>{head}{'<br><small>' if why else ''}{why}{'</small>' if why else ''}</li>"
