"""How does one practise in a notebook?  A question in a cell, its answer in the cell that appears below it.

    practice.ask()             the question; below it a cell with what is given, and blanks to fill in
    practice.check(corner)     the reply, and when the idea comes again; `practice.ask()` goes on
    practice.boxes()           a picture of where each idea lies
    practice.hint()  practice.solution()  practice.skip()  practice.given()  practice.standing()

They write into the copy and nothing else.  Where the page is not able to add a cell,
the question's starter is printed.
"""

from __future__ import annotations

import re
import time
from collections.abc import Sequence
from types import SimpleNamespace
from typing import TYPE_CHECKING, Any

from ...text import Text
from ..answers.showing import show_all
from ..checks import TRIES_BEFORE_SOLUTION, solution_text
from ..places import MARK, WorkbookError, read_workbook, workbook_root
from ..reply import in_notebook, shell, show_reply
from ..tasks.task import TaskError
from ..trying import say_verdict, show_hint
from .question import DrawnQuestion
from .sentences import afterwards, why_asked
from .sentences import standing as standing_of
from .session import Session, known_of
from .spacing import DAY_S, GAPS, HOUR_S, Spacing, is_due

if TYPE_CHECKING:
    from tflab.views.picture import Picture

__all__ = ["ask", "boxes", "check", "given", "hint", "say_hint", "say_solution", "skip", "solution", "standing"]

HERE = Text(
    en="Your answer goes into the cell below; run it, and it is checked.",
    ko="아래 셀에 답을 쓰고 실행하면 바로 확인합니다.",
)
GO_ON = Text(en="practice.ask() brings the next one.", ko="practice.ask()를 실행하면 다음 문제가 나옵니다.")
NO_COPY = Text(
    en="Nothing is kept here: these are tflab's own pages.",
    ko="여기는 tflab에 들어 있는 원본이라 기록을 남기지 않습니다.",
)
HELP = Text(
    en="practice.hint() helps, practice.skip() leaves it for later.",
    ko="practice.hint()로 힌트를 보고, practice.skip()으로 나중으로 미룰 수 있습니다.",
)
_shown: list[tuple[str, int]] = []  # the questions that have their cell already, in this kernel


def ask(*chapters: str | int) -> None:
    """Show the question that is open, or a new one, and put a cell for its answer below."""
    session = _session(chapters)
    if session is None:
        return
    question = session.question()
    language = session.workbook.language
    more = [HERE.say(language), HELP.say(language)]
    if not (session.root / MARK).is_file():
        more.append(NO_COPY.say(language))
    show_reply(why_asked(question.open, session.kept, language), more=more)
    _show(question)
    if (place := (str(session.root), question.open.number)) not in _shown:
        _shown.append(place)
        _put_below(starter_of(question))


def check(answer: Any = ...) -> None:
    """Say what is right or wrong about an answer to the open question; after a pass, when its idea comes again."""
    session = _session()
    question = session and _open(session)
    if question is None:
        return
    result = session.answer(question, answer)
    language = session.workbook.language
    more = [afterwards(result.kept, language), GO_ON.say(language)] if result.is_over else [HELP.say(language)]
    say_verdict(result.assigned, result.verdict, result.outcomes, more, draws=False)


def hint() -> None:
    """Print the next of the open question's three hints."""
    session = _session()
    if session is not None and (question := _open(session)) is not None:
        say_hint(session, question)


def solution() -> None:
    """Print how the open question is solved, after three tries; a class's solutions are with its instructor."""
    session = _session()
    if session is not None and (question := _open(session)) is not None:
        say_solution(session, question)


def skip() -> None:
    """Close the open question, and say when its idea comes again."""
    session = _session()
    if session is not None and _open(session) is not None:
        language = session.workbook.language
        show_reply(afterwards(session.leave(), language), more=[GO_ON.say(language)])


def given() -> SimpleNamespace:
    """Return what the open question gives: `e3_2.laser_p_corner`."""
    session = _session()
    question = session and _open(session)
    return SimpleNamespace(**question.given) if question else SimpleNamespace()


def standing() -> None:
    """Print what was shown, when, and what comes next."""
    root = workbook_root()
    print(standing_of(known_of(root), read_workbook(root).language))


def boxes() -> Picture:
    """Draw in which box each idea lies, and which is due."""
    from tflab.views.boxes import draw_boxes

    kept, now_s = known_of(workbook_root()), int(time.time())
    lying = {name: idea.box for name, idea in sorted(kept.ideas.items(), key=lambda one: _in_order(one[0]))}
    due = [name for name, idea in kept.ideas.items() if is_due(idea, kept.number, now_s)]
    return draw_boxes(lying, [_wait(gap) for gap in GAPS], due)


def say_hint(session: Session, question: DrawnQuestion) -> None:
    """Show the next hint of a question."""
    show_hint(session.assigned(question), session.hint(question))


def say_solution(session: Session, question: DrawnQuestion) -> None:
    """Show how a question is solved, to whoever studies alone and has tried."""
    task = session.assigned(question)
    tries = question.open.tries
    if task.workbook.edition == "class":
        show_reply(task.id, task.phrase("solution_of_class"))
    elif tries < TRIES_BEFORE_SOLUTION:
        show_reply(task.id, task.phrase("solution_later", tries=tries))
    else:
        print(solution_text(task))


def starter_of(question: DrawnQuestion) -> str:
    """Return the cell in which a question is answered."""
    parts = [question.imports, question.starter, f"practice.check({question.item.task.answer})"]
    return "\n\n".join(filter(None, parts))


def _in_order(name: str) -> list[int]:
    return [int(number) for number in re.findall(r"\d+", name)]


def _wait(gap: Spacing) -> str:
    """Return how long something stays away, in a few letters: "4 tasks, 1 d"."""
    time_s = f"{gap.seconds // DAY_S} d" if gap.seconds >= DAY_S else f"{gap.seconds // HOUR_S} h"
    return f"{gap.tasks} task{'' if gap.tasks == 1 else 's'} / {time_s}"


def _show(question: DrawnQuestion) -> None:
    if in_notebook():
        from IPython.display import Markdown, display

        display(Markdown(question.text))
    else:
        print(question.text)
    if question.given:
        print(f"{question.given_name}\n{show_all(question.given)}")


def _put_below(text: str) -> None:
    """Put a new cell below the one that runs; where there are no cells, print what would stand in it."""
    if not in_notebook():
        print(text)
        return
    shell().set_next_input(text)


def _session(chapters: Sequence[str | int] = ()) -> Session | None:
    """Return the practice of this workbook; None, having said why, if there is none."""
    try:
        return Session(workbook_root(), [str(chapter) for chapter in chapters])
    except (WorkbookError, TaskError) as error:
        show_reply("practice", str(error))
        return None


def _open(session: Session) -> DrawnQuestion | None:
    """Return the open question; None, having said so, if there is none."""
    if session.kept.open is None:
        show_reply("practice", GO_ON.say(session.workbook.language))
        return None
    return session.question()
