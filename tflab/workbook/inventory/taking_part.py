"""What does `check` say where nothing is right or wrong?  How many questions are answered, and nothing else.

    E0.1 ✓ 15/15     15 of 15 answered. Your first answers are kept.
    E0.1 12/15       12 of 15 answered. Not yet: 3, 7, 9.

There is no reply, no hint and no solution, and only the first complete answer is kept
in the copy.  When form B is in, both open (see `opened.py`).
"""

from __future__ import annotations

from pathlib import Path

from ...text import Text
from .. import progress
from ..answers.form import Form
from ..answers.values import Plain
from ..diagnosis.mistake import Mistake
from ..diagnosis.verdict import Verdict
from ..paths import workbook_data
from ..reply import show_page, show_reply
from .opened import opened
from .replies import chosen

__all__ = ["NO_HELP", "say_taken_part"]

ANSWERED = Text("{passed} of {of} answered.", "{of}개 가운데 {passed}개에 답했습니다.")
NOT_YET = Text("Not yet: {parts}.", "아직 답이 없는 문제: {parts}.")
LOOK = Text(
    'Look at question {part}: one of the letters a to e, with "?" behind it if you guess.',
    "{part}번을 다시 보십시오. a에서 e까지의 글자 하나를 쓰고, 짐작이면 뒤에 ?를 붙입니다.",
)
WRONG_KIND = Text(
    'A dict is asked for, with a letter for each question: {"1": "b", "2": "c?", ...}.',
    '문제마다 글자 하나를 담은 dict가 필요합니다: {"1": "b", "2": "c?", ...}.',
)
KEPT = Text("Your answers are kept.", "답을 보관했습니다.")
FIRST_KEPT = Text(
    "The first answers that you gave are kept; these change nothing.",
    "처음에 쓴 답을 보관하고 있습니다. 지금 쓴 답은 보관하지 않습니다.",
)
OPENS_LATER = Text(
    "Nothing is told until you have answered the second form, E12.8.",
    "두 번째 시험지인 E12.8에 답할 때까지 정답은 알려 주지 않습니다.",
)
NO_HELP = Text(
    "no hints and no solution here: nothing is marked, and both forms open when the second, E12.8, is in.",
    "여기에는 힌트도 풀이도 없습니다. 채점하지 않으며, 두 번째 시험지인 E12.8에 답하면 두 장이 함께 열립니다.",
)


def say_taken_part(task_id: str, root: Path, language: str, form: Form, verdict: Verdict, outcome: Plain) -> None:
    """Say how many questions are answered, keep the first complete answer, and show both forms when they are open."""
    said = ANSWERED.say(language, passed=verdict.passed, of=verdict.of)
    score = f"{verdict.passed}/{verdict.of}"
    if verdict.mistake is not None:
        show_reply(f"{task_id} {score}", f"{said} {_what_is_left(verdict, language)}")
        return
    if root == workbook_data():  # a solution that is being built: the same in both languages, and plain
        print(f"{task_id} ✓ {score}")
        return
    answers = chosen(form, outcome)
    kept = progress.record_answers(root, task_id, answers)
    said += " " + (KEPT if kept == answers else FIRST_KEPT).say(language) if kept else ""
    page = opened(root, language)
    show_reply(f"{task_id} ✓ {score}", said, [] if page else [OPENS_LATER.say(language)], "passed")
    if page is not None:
        show_page(page)


def _what_is_left(verdict: Verdict, language: str) -> str:
    if verdict.mistake is Mistake.MISSING_PARTS:
        return NOT_YET.say(language, parts=", ".join(sorted(verdict.detail["parts"], key=int)))
    if "part" in verdict.detail:
        return LOOK.say(language, part=verdict.detail["part"])
    return WRONG_KIND.say(language)
