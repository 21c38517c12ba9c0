"""Reply to an answered inventory form, and show both forms with their key once both are answered.

    E0.1 ✓ 15/15     15 of 15 answered. Your answers are kept.
    E0.1 12/15       12 of 15 answered. Not yet: 3, 7, 9.

Only the first complete answer is stored in the copy. Until form B is answered there is no reply, no
hint and no solution. Then the learner sees what was learnt, what to read again, and both forms with
a sentence for each option:

    Before: 5 right, 4 of them sure. After: 13 right, 12 of them sure.
    cured 8 · held 5 · stuck 2 · lost 0

There is no score: fifteen items are too few to measure one person.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path

from tflab.views.report_page import render

from ...text import Text, Texts
from .. import progress
from ..answers.form import Form
from ..answers.values import Plain
from ..diagnosis.failure import Failure
from ..diagnosis.verdict import Verdict
from ..paths import chapters, workbook_data
from ..progress import read_progress
from ..reply_card import show_page, show_reply
from ..tasks.task import chapter_of
from .items import DO_NOT_KNOW, FORMS, Item, read_inventory
from .replies import Reply, changes, chosen, fixed_items, replies_to

__all__ = ["NO_HELP", "RevealedForms", "pending_notice", "report_participation", "revealed_forms"]

TEXTS = Texts(__file__)
SIGNS = {"cured": "▲", "held": "●", "stuck": "○", "lost": "▽"}
NO_HELP = Text(
    "no hints and no solution here: nothing is marked, and both forms open when the second, E12.8, is in.",
    "여기에는 힌트도 풀이도 없습니다. 채점하지 않으며, 두 번째 시험지인 E12.8에 답하면 두 장이 함께 열립니다.",
)


def report_participation(task_id: str, root: Path, language: str, form: Form, verdict: Verdict, outcome: Plain) -> None:
    """Say how many questions are answered, keep the first complete answer, and show both forms when they are open."""
    said = TEXTS["answered"].say(language, passed=verdict.passed, of=verdict.of)
    score = f"{verdict.passed}/{verdict.of}"
    if verdict.failure is not None:
        show_reply(f"{task_id} {score}", f"{said} {_what_is_left(verdict, language)}")
        return
    if root == workbook_data():  # a solution that is being built: the same in both languages, and plain
        print(f"{task_id} ✓ {score}")
        return
    answers = chosen(form, outcome)
    kept = progress.record_answers(root, task_id, answers)
    said += " " + (TEXTS["kept"] if kept == answers else TEXTS["first_kept"]).say(language) if kept else ""
    page = revealed_forms(root, language)
    show_reply(f"{task_id} ✓ {score}", said, [] if page else [TEXTS["opens_later"].say(language)], "passed")
    if page is not None:
        show_page(page)


def _what_is_left(verdict: Verdict, language: str) -> str:
    if verdict.failure is Failure.MISSING_PARTS:
        return TEXTS["not_yet"].say(language, parts=", ".join(sorted(verdict.detail["parts"], key=int)))
    if "part" in verdict.detail:
        return TEXTS["look"].say(language, part=verdict.detail["part"])
    return TEXTS["wrong_kind"].say(language)


def revealed_forms(root: Path, language: str) -> RevealedForms | None:
    """Return what is open in the copy at `root`; None before form B is in."""
    kept = read_progress(root)
    before, after = (kept[task].answers if task in kept else {} for task in FORMS.values())
    items = read_inventory()
    return RevealedForms(items, before, after, language) if after and items else None


def pending_notice(root: Path, language: str) -> str:
    """Return a line where form B is not in: what to do, or what is kept; "" else, and where the forms are not."""
    kept = read_progress(root)
    before, after = (bool(task in kept and kept[task].answers) for task in FORMS.values())
    if after or not {chapter_of(task) for task in FORMS.values()} <= {int(stem[:2]) for stem in chapters(root)}:
        return ""
    return (TEXTS["waiting"] if before else TEXTS["to_do"]).say(language)


class RevealedForms:
    """Both forms and what changed between them: as HTML in a notebook, as text in a terminal."""

    def __init__(
        self, items: Sequence[Item], before: Mapping[str, str], after: Mapping[str, str], language: str
    ) -> None:
        self._items, self._language = items, language
        self._replies = {"A": replies_to(items, "A", before), "B": replies_to(items, "B", after)}
        self._changes = changes(items, before, after) if before else []

    def _repr_mimebundle_(self, include=None, exclude=None) -> dict[str, str]:
        return {"text/html": self.html, "text/plain": self.text}

    @property
    def summary(self) -> str:
        """What was learnt and where to go, as text, without the forms."""
        lists = [
            line for heading, lines in self._sections() for line in ("", heading, *(f"  {each}" for each in lines))
        ]
        return "\n".join([self._say("title"), *self._counts(), *lists, "", self._say("limits")])

    @property
    def text(self) -> str:
        """All of it as text."""
        lines = [self.summary]
        for heading, questions in self._forms():
            lines += ["", heading]
            for number, stem, options in questions:
                lines += ["", f"{number}. {stem}"]
                for sign, option, mark, why in options:
                    lines += [f"   {sign} {option} {mark}".rstrip(), *([f"     {why}"] if why else [])]
        return "\n".join(lines)

    @property
    def html(self) -> str:
        """All of it as a notebook shows it, in the notebook's own colours; the forms are folded."""
        return render(
            __file__,
            title=self._say("title"),
            counts=list(self._counts()),
            sections=list(self._sections()),
            forms=list(self._forms()),
            limits=self._say("limits"),
        )

    def _counts(self) -> Iterator[str]:
        """Yield how many were right, then a sign for each question, then how many there are of each."""
        first, then = (self._right(self._replies[form]) for form in FORMS)
        if not self._changes:
            yield self._say("only_after", then=then)
            return
        yield self._say("before", first=first, then=then)
        yield " ".join(f"{change.number}{SIGNS[change.state]}" for change in self._changes)
        counts = Counter(change.state for change in self._changes)
        yield " · ".join(f"{sign} {self._say(state)} {counts[state]}" for state, sign in SIGNS.items())

    def _right(self, replies: Sequence[Reply]) -> str:
        right = [reply for reply in replies if reply.is_right]
        return self._say("right", right=len(right), sure=sum(reply.is_sure for reply in right))

    def _sections(self) -> Iterator[tuple[str, list[str]]]:
        """Yield what was learnt against the learner's own certainty, then where to go for what is wrong now."""
        learnt = [f"{change.number} · {change.item.about.say(self._language)}" for change in fixed_items(self._changes)]
        if learnt:
            yield self._say("relearnt"), learnt
        wrong = [number for number, reply in enumerate(self._replies["B"], start=1) if not reply.is_right]
        if wrong:
            yield self._say("where_to_go"), [self._where(number) for number in wrong]

    def _where(self, number: int) -> str:
        item = self._items[number - 1]
        state = f" ({self._say(self._changes[number - 1].state)})" if self._changes else ""
        about = item.about.say(self._language) + state
        return self._say("where", number=number, about=about, chapter=chapter_of(item.task), task=item.task)

    def _forms(self) -> Iterator[tuple[str, list[tuple[int, str, list[tuple[str, str, str, str]]]]]]:
        """Yield each form's heading and its questions: number, text, options."""
        for form in FORMS:
            questions = [
                (number, item.forms[form].stem.say(self._language), list(self._options(form, number, item)))
                for number, item in enumerate(self._items, start=1)
            ]
            yield self._say("form", form=form), questions

    def _options(self, form: str, number: int, item: Item) -> Iterator[tuple[str, str, str, str]]:
        """Yield each option's sign, its letter and text, whether it was chosen, and the sentence on it."""
        reply = self._replies[form][number - 1]
        mine = "[" + self._say("yours" if reply.is_sure or not reply.letter else "guessed") + "]"
        for letter, option in item.forms[form].options.items():
            sign = "✓" if letter == item.forms[form].right else "✗"
            text = f"{letter} {option.says.say(self._language)}"
            yield sign, text, mine if letter == reply.letter else "", option.why.say(self._language)
        if not reply.letter:
            yield "–", f"e {DO_NOT_KNOW.say(self._language)}", mine, ""

    def _say(self, key: str, **names: object) -> str:
        return TEXTS[key].say(self._language, **names)
