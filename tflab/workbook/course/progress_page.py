"""Where do I stand?  `tflab progress` in a terminal, `show_progress()` on a page.

    03  Target and source        ■ ■ ■ □ ◧ □ □   3/7
    to come: 01, 04

What is ticked is what a check has passed; see `standing.py`.
"""

from __future__ import annotations

import argparse
import html
import sys
from collections.abc import Iterator, Sequence
from pathlib import Path

from ...text import Text
from ..inventory.opened import Opened, opened, waiting
from ..paths import COPY, MARK, WorkbookError, copy_at_hand, workbook_root
from .standing import ChapterStanding, GoalStanding, Standing, TaskStanding, standing

__all__ = ["ProgressPage", "progress", "show_progress"]

TITLE = Text(en="Your progress", ko="학습 현황")
CHAPTERS = Text(en="Chapters", ko="장")
OBJECTIVES = Text(en="What you can do", ko="학습 목표")
CHECKLIST = Text(en="What you have done", ko="실습 체크리스트")
LATER = Text(en="to come", ko="준비 중")
TASKS_PASSED = Text(en="{passed} of {of} tasks passed", ko="과제 {of}개 중 {passed}개 통과")
PASSED_OF = Text(en="{passed} of {of}", ko="과제 {of}개 중 {passed}개 통과")
REST_LATER = Text(en="{count} to come", ko="{count}개는 준비 중")
TO_PASS = Text(en="to pass", ko="남은 과제")
ON_A_ROBOT = Text(en="simulated here; on the robot", ko="여기서는 시뮬레이션으로 했습니다. 로봇에서는")
WILL_ROBOT = Text(en="on the robot", ko="로봇에서는")
TRIES = Text(en="tries: {tries}, hints: {hints}", ko="시도 {tries}번, 힌트 {hints}번")
ONLY_CHECKS = Text(
    en="Only a passed check ticks anything here.",
    ko="check를 통과해야만 표시됩니다.",
)
NO_COPY = Text(
    en="Nothing is kept here: these are tflab's own pages. Make your copy with: tflab lab",
    ko="여기는 tflab에 들어 있는 원본이라 기록을 남기지 않습니다. tflab lab으로 내 워크북을 만드십시오.",
)
PASSED, TRIED, UNTRIED = "■", "◧", "□"
STATES = {"passed": "✓", "open": "○"}
SQUARES = Text(
    en=f"{PASSED} passed, {TRIED} tried and not passed yet, {UNTRIED} not tried",
    ko=f"{PASSED} 통과, {TRIED} 시도했으나 아직 통과 못 함, {UNTRIED} 아직 시도 안 함",
)
TICKS = Text(
    en=f"{STATES['passed']} every task for it is passed, {STATES['open']} not yet",
    ko=f"{STATES['passed']} 해당 과제를 모두 통과, {STATES['open']} 아직",
)

STYLE = """
.tflab-progress > table {border-collapse: collapse; margin: 0.4em 0 1.2em; font-size: 1em}
.tflab-progress > table td {border: 0; border-bottom: 1px solid color-mix(in srgb, currentColor 22%, transparent);
  padding: 0.35em 0.9em 0.35em 0; text-align: left !important; vertical-align: top; background: none;
  white-space: normal}
.tflab-progress > table tr {background: none !important}
.tflab-progress > table td.mark {font-weight: bold; padding-left: 0.1em; padding-right: 0.7em; white-space: nowrap}
.tflab-progress > table td.tasks {letter-spacing: 0.25em; white-space: nowrap; font-size: 1.15em}
.tflab-progress > table td.count {white-space: nowrap}
.tflab-progress > table tr.later {opacity: 0.62}
div.tflab-progress > h3 {margin: 0.8em 0 0.2em}
div.tflab-progress > p.signs {margin: 0}
.tflab-progress > table code {background: none; padding: 0; white-space: pre-wrap; overflow-wrap: anywhere}
.tflab-progress small {opacity: 0.85}
"""


class ProgressPage:
    """A standing that can be shown: as HTML on a page, as text in a terminal."""

    def __init__(self, shown: Standing, kept: bool = True, forms: Opened | str = "") -> None:
        """Make a page.

        Args:
            forms: the test before and after once it is open, else what to say of it.
        """
        self._standing, self._kept, self._forms = shown, kept, forms
        self._language = shown.language

    def _repr_mimebundle_(self, include=None, exclude=None) -> dict[str, str]:
        return {"text/html": self.html, "text/plain": self.text}

    @property
    def text(self) -> str:
        """Return it as a terminal shows it."""
        lines = [self._say(TITLE) + ": " + self._sum(), self._note()]
        lines += ["", f"{self._say(CHAPTERS)} ({self._say(SQUARES)})"]
        for stands in self._here:
            marks = " ".join(_mark(task) for task in stands.tasks)
            count = f"{stands.passed}/{len(stands.tasks)}"
            lines.append(f"  {stands.chapter.stem[:2]}  {marks}   {count}   {stands.chapter.title.say(self._language)}")
        lines += [f"  {line}" for line in self._to_come()]
        forms = self._forms if isinstance(self._forms, str) else self._forms.summary
        lines += ["", forms] if forms else []
        for title, goals in ((OBJECTIVES, self._standing.objectives), (CHECKLIST, self._standing.checklist)):
            lines += ["", f"{self._say(title)} ({self._say(TICKS)})"]
            for number, stands in _not_later(goals):
                lines.append(f"  {STATES[stands.state]} {number:>2}  {stands.goal.words.say(self._language)}")
                lines += [f"        {line}" for line in self._details(stands)]
        return "\n".join(lines)

    @property
    def html(self) -> str:
        """Return it as a page shows it, in the page's own colours."""
        rows = [
            f'<style>{STYLE}</style><div class="tflab-progress"><p><b>{self._say(TITLE)}:</b> {self._sum()}. '
            f"<small>{html.escape(self._note())}</small></p>",
            f"{self._heading(CHAPTERS, SQUARES)}<table>",
        ]
        for stands in self._here:
            marks = "".join(self._square(task) for task in stands.tasks)
            title = html.escape(stands.chapter.title.say(self._language))
            rows.append(
                f'<tr><td class="mark">{stands.chapter.stem[:2]}</td><td>{title}</td>'
                f'<td class="tasks">{marks}</td><td class="count">{stands.passed}/{len(stands.tasks)}</td></tr>'
            )
        for line in self._to_come():
            rows.append(f'<tr class="later"><td></td><td colspan="3">{html.escape(line)}</td></tr>')
        said = f"<p>{html.escape(self._forms)}</p>" if isinstance(self._forms, str) else self._forms.html
        rows += ["</table>", said] if self._forms else ["</table>"]
        for title, goals in ((OBJECTIVES, self._standing.objectives), (CHECKLIST, self._standing.checklist)):
            rows.append(f"{self._heading(title, TICKS)}<table>")
            rows += [self._row(number, stands) for number, stands in _not_later(goals)]
            rows.append("</table>")
        return "".join([*rows, "</div>"])

    def _heading(self, title: Text, signs: Text) -> str:
        """Return a heading, and below it what the signs of its table mean."""
        return f'<h3>{self._say(title)}</h3><p class="signs"><small>{self._say(signs)}</small></p>'

    def _row(self, number: int, stands: GoalStanding) -> str:
        details = "<br>".join(
            f"<code>{html.escape(line[2:])}</code>" if line.startswith("$ ") else f"<small>{html.escape(line)}</small>"
            for line in self._details(stands)
        )
        words = html.escape(stands.goal.words.say(self._language))
        return (
            f'<tr class="{stands.state}"><td class="mark" title="{stands.state}">{STATES[stands.state]}</td>'
            f"<td>{number}</td><td>{words}{'<br>' if details else ''}{details}</td></tr>"
        )

    def _details(self, stands: GoalStanding) -> Iterator[str]:
        """Yield what is left to pass, and what to type on a robot."""
        absent = len(stands.tasks) - len(stands.here)
        if stands.state == "open":
            left = [name for name in stands.here if not stands.tasks[name]]
            rest = f" ({REST_LATER.say(self._language, count=absent)})" if absent else ""
            passed = PASSED_OF.say(self._language, passed=stands.passed, of=len(stands.tasks))
            yield f"{passed} · {self._say(TO_PASS)}: {' '.join(left)}{rest}"
        if stands.goal.robot:
            yield f"{self._say(ON_A_ROBOT if stands.state == 'passed' else WILL_ROBOT)}:"
            yield from (f"$ {command}" for command in stands.goal.robot)

    def _square(self, task: TaskStanding) -> str:
        title = f"{task.id} · {task.title.say(self._language)}"
        if task.attempts.tries or task.attempts.hints:
            title += " · " + TRIES.say(self._language, tries=task.attempts.tries, hints=task.attempts.hints)
        return f'<span title="{html.escape(title)}">{_mark(task)}</span>'

    @property
    def _here(self) -> list[ChapterStanding]:
        """Return the chapters that have tasks."""
        return [stands for stands in self._standing.chapters if stands.tasks]

    def _to_come(self) -> Iterator[str]:
        """Yield the chapters that are not here yet, in one line, if there are any."""
        absent = [s.chapter.stem[:2] for s in self._standing.chapters if s.chapter.number and not s.tasks]
        if absent:
            yield f"{self._say(LATER)}: {', '.join(absent)}"

    def _sum(self) -> str:
        tasks = self._standing.tasks
        passed = sum(task.attempts.passed for task in tasks)
        return TASKS_PASSED.say(self._language, passed=passed, of=len(tasks))

    def _note(self) -> str:
        return self._say(ONLY_CHECKS if self._kept else NO_COPY)

    def _say(self, words: Text) -> str:
        return words.say(self._language)


def show_progress() -> ProgressPage:
    """Return where you stand in the nearest workbook, to be shown as the last value of a cell."""
    return _page(workbook_root())


def progress(words: Sequence[str]) -> int:
    """Print where one stands, and return 0; 2 if the workbook cannot be read."""
    parser = argparse.ArgumentParser(prog="tflab progress", description="Say which checks have been passed.")
    parser.add_argument("folder", nargs="?", metavar="DIR", help=f"your copy; the nearest, or ./{COPY}, if left out")
    folder = parser.parse_args(list(words)).folder
    root = Path(folder) if folder else copy_at_hand() or workbook_root()
    if folder and not (root / MARK).is_file():
        print(f"tflab progress: {root} is no copy of the workbook; tflab lab makes one", file=sys.stderr)
        return 2
    try:
        print(_page(root).text)
    except WorkbookError as error:
        print(f"tflab progress: {error}", file=sys.stderr)
        return 2
    return 0


def _page(root: Path) -> ProgressPage:
    shown = standing(root)
    forms = opened(root, shown.language) or waiting(root, shown.language)
    return ProgressPage(shown, kept=(root / MARK).is_file(), forms=forms)


def _mark(task: TaskStanding) -> str:
    return PASSED if task.attempts.passed else TRIED if task.attempts.tries else UNTRIED


def _not_later(goals: Sequence[GoalStanding]) -> list[tuple[int, GoalStanding]]:
    """Return the goals that have a task here, each with its number; the others come with their chapters."""
    return [(number, stands) for number, stands in enumerate(goals, start=1) if stands.state != "later"]
