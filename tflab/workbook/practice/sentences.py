"""What is said of it?  Why a question comes, what it was about, when it comes again, and where one stands.

    Question 18. What it looks for went wrong before.
    It was about M3 (the inverse is only a minus sign). Box 2 of 5: it comes again after 4 other tasks, or tomorrow.

What a question is about is told after it: before, it would be half the answer.
"""

from __future__ import annotations

import time
from collections.abc import Iterator

from ...text import Text
from ..tasks.misconceptions import MISCONCEPTIONS
from .kept import Kept, Open, Practised
from .spacing import AGAIN, AHEAD, DUE, GAPS, LAST_BOX, NEW, Idea, is_due

__all__ = ["afterwards", "standing", "why_asked"]

WHY = {
    AGAIN: Text(
        en="Question {number}. What it looks for went wrong before.",
        ko="{number}번 문제입니다. 전에 틀린 적이 있는 내용입니다.",
    ),
    DUE: Text(
        en="Question {number}. It is time to see this again.", ko="{number}번 문제입니다. 다시 볼 때가 되었습니다."
    ),
    NEW: Text(
        en="Question {number}. Its idea is new to your practice.",
        ko="{number}번 문제입니다. 연습에서는 처음 나오는 내용입니다.",
    ),
    AHEAD: Text(
        en="Question {number}. Nothing is due, so this one comes early.",
        ko="{number}번 문제입니다. 다시 볼 때가 된 것이 없어 조금 일찍 나왔습니다.",
    ),
}
LAST_TIME = Text(en=" Last time: {day}.", ko=" 지난번: {day}.")
ABOUT = Text(en="It was about {idea}.", ko="{idea}에 관한 문제였습니다.")
ALSO_SHOWN = Text(en="Your answers showed {ideas}.", ko="답에서 이런 점도 드러났습니다: {ideas}.")
AGAIN_AFTER = Text(
    en="Box {box} of {last}: it comes again after {tasks} other task{s}, or {wait}.",
    ko="상자 {last}개 중 {box}번에 있습니다. 다른 과제 {tasks}개를 푼 뒤, 또는 {wait} 다시 나옵니다.",
)
WAITS = (
    Text(en="in an hour", ko="한 시간 뒤에"),
    Text(en="tomorrow", ko="내일"),
    Text(en="in 3 days", ko="사흘 뒤에"),
    Text(en="in a week", ko="일주일 뒤에"),
    Text(en="in 3 weeks", ko="3주 뒤에"),
)
PUT_OFF = Text(en="Put off: nothing was seen of it.", ko="건너뛰었습니다. 상자는 그대로입니다.")
NOTHING_YET = Text(en="Nothing has been practised yet.", ko="아직 연습한 것이 없습니다.")
SUM = Text(
    en="{count} question{s} so far, {right} right at the first go. None of it counts for marks or progress.",
    ko="지금까지 {count}문제, 그중 한 번에 맞힌 것은 {right}문제입니다. 점수나 학습 현황에는 들어가지 않습니다.",
)
ROW = Text(
    en="box {box}; shown {shown}, right since then {right}; last asked {day}; comes again {next}",
    ko="상자 {box}. 드러난 횟수 {shown}, 그 뒤 맞힌 횟수 {right}. 마지막 출제: {day}. 다음: {next}",
)
NOW = Text(en="now", ko="지금")
NEXT = Text(en="after {tasks} more task{s}, or on {day}", ko="과제 {tasks}개 뒤, 또는 {day}")
NEVER = Text(en="never", ko="없음")
COMES_NEXT = Text(en="What comes next: {ideas}.", ko="다음에 나올 내용: {ideas}.")
COMES_OLDEST = Text(
    en="Nothing is due; next comes what was asked longest ago.",
    ko="다시 볼 때가 된 것이 없으므로, 나온 지 가장 오래된 것이 다음에 나옵니다.",
)
OPEN = Text(en="Question {number} waits for your answer.", ko="{number}번 문제가 답을 기다립니다.")
CAME = {
    "right": Text(en="right", ko="맞힘"),
    "wrong": Text(en="wrong at first", ko="처음에 틀림"),
    "skipped": Text(en="skipped", ko="건너뜀"),
}
LINES_OF_LOG = 10


def why_asked(opened: Open, kept: Kept, language: str) -> str:
    """Return why a question comes, and when its task came last."""
    last = next((line for line in reversed(kept.asked) if line.task == opened.task), None)
    said = WHY[opened.why].say(language, number=opened.number)
    return said + (LAST_TIME.say(language, day=_day(last.at_s)) if last else "")


def afterwards(kept: Kept, language: str) -> str:
    """Return what the last question was about, and when that comes again."""
    line = kept.asked[-1]
    idea = kept.ideas.get(line.idea)
    said = [ABOUT.say(language, idea=_named(line.idea, language))]
    others = [name for name in line.shown if name != line.idea]
    if others:
        said.append(ALSO_SHOWN.say(language, ideas=", ".join(_named(name, language) for name in others)))
    if line.came == "skipped" or idea is None:
        return " ".join([*said, PUT_OFF.say(language)])
    wait = WAITS[idea.box - 1].say(language)
    tasks = GAPS[idea.box - 1].tasks
    again = AGAIN_AFTER.say(language, box=idea.box, last=LAST_BOX, tasks=tasks, s=_s(tasks), wait=wait)
    return " ".join([*said, again])


def standing(kept: Kept, language: str, now_s: int | None = None) -> str:
    """Return what was shown and when, where each idea stands, and what comes next, as lines."""
    return "\n".join(_standing(kept, language, int(time.time()) if now_s is None else now_s))


def _standing(kept: Kept, language: str, now_s: int) -> Iterator[str]:
    if not kept.asked and not kept.ideas:
        yield NOTHING_YET.say(language)
    else:
        right = sum(line.came == "right" for line in kept.asked)
        yield SUM.say(language, count=len(kept.asked), s=_s(len(kept.asked)), right=right)
    for name, idea in sorted(kept.ideas.items(), key=lambda one: (one[1].box, -one[1].shown, one[0])):
        yield f"  {_named(name, language)}"
        yield f"      {_row(idea, kept.number, now_s, language)}"
    for line in kept.asked[-LINES_OF_LOG:]:
        yield _line(line, language)
    due = [name for name, idea in kept.ideas.items() if is_due(idea, kept.number, now_s)]
    if kept.open is not None:
        yield OPEN.say(language, number=kept.open.number)
    elif due:
        due.sort(key=lambda name: (kept.ideas[name].box, -kept.ideas[name].shown, kept.ideas[name].number, name))
        yield COMES_NEXT.say(language, ideas=", ".join(due))
    else:
        yield COMES_OLDEST.say(language)


def _row(idea: Idea, number: int, now_s: int, language: str) -> str:
    left = idea.gap.tasks - (number - idea.number - 1)
    comes = NEXT.say(language, tasks=left, s=_s(left), day=_day(idea.asked_s + idea.gap.seconds))
    if is_due(idea, number, now_s):
        comes = NOW.say(language)
    day = _day(idea.asked_s) if idea.number else NEVER.say(language)
    return ROW.say(language, box=idea.box, shown=idea.shown, right=idea.right, day=day, next=comes)


def _line(line: Practised, language: str) -> str:
    shown = f" ({', '.join(line.shown)})" if line.shown else ""
    return (
        f"  {line.number:>4}  {_day(line.at_s)}  {line.task:<6} {line.idea:<6} {CAME[line.came].say(language)}{shown}"
    )


def _named(idea: str, language: str) -> str:
    return f"{idea} ({MISCONCEPTIONS[idea].say(language)})" if idea in MISCONCEPTIONS else idea


def _day(time_s: int) -> str:
    return time.strftime("%Y-%m-%d %H:%M", time.localtime(time_s))


def _s(count: int) -> str:
    return "" if count == 1 else "s"
