"""How does one practise in a terminal?  `tflab practice`: a question, an answer, what it was, and the next.

    tflab practice                  goes on where you stopped
    tflab practice --chapters 3,8   about these chapters; else as far as you have come
    tflab practice --log            what was shown, when, and what comes next

What is a line is typed at the prompt; a function, a tree or a file is written in a
file of your copy, practice/018_E3.3.py, and Enter checks it.  Ctrl-C loses nothing.
"""

from __future__ import annotations

import argparse
import os
import subprocess
import sys
import traceback
from collections.abc import Sequence
from importlib import import_module
from pathlib import Path
from shutil import get_terminal_size
from tempfile import mkdtemp
from types import SimpleNamespace
from typing import Any

from ...text import Text
from ..answers.showing import show_all
from ..places import COPY, MARK, WorkbookError, copy_at_hand, workbook_root
from ..tasks.reference import in_process_ros
from ..tasks.task import TaskError
from ..trying import say_verdict
from ..whole_files import write_whole
from .cells import say_hint, say_solution
from .prompt import WORDS, Said, ask_for, can_be_typed
from .question import DrawnQuestion
from .sentences import afterwards, standing, why_asked
from .session import Session
from .terminal import as_text

__all__ = ["main"]

WIDEST = 88
GIVEN = Text(en="Given, as {name}:", ko="주어진 값({name}):")
HOW_TO_TYPE = Text(
    en="Type your answer; words need no quotes, numbers may be expressions ({name}). Also: hint, skip, quit.",
    ko="답을 입력하십시오. 낱말에 따옴표는 필요 없고, 숫자는 식({name})도 됩니다. 다른 명령: hint, skip, quit.",
)
IN_FILE = Text(
    en="Write your answer in this file, save it, and press Enter here:\n  {file}\nAlso: hint, skip, quit{edit}.",
    ko="이 파일에 답을 쓰고 저장한 다음 여기서 Enter를 누르십시오.\n  {file}\n다른 명령: hint, skip, quit{edit}.",
)
NEXT = Text(en="Enter: the next question. quit: until later. ", ko="Enter를 누르면 다음 문제, quit이면 끝냅니다. ")
KEPT = Text(
    en="Everything is kept{where}; go on with: tflab practice",
    ko="모두 남아 있습니다{where}. 이어서 하려면: tflab practice",
)
NO_COPY = Text(
    en="There is no copy of the workbook here, so nothing is kept; make one with: tflab lab",
    ko="여기에는 워크북이 없어 기록을 남기지 않습니다. 워크북을 만들려면: tflab lab",
)
STOPPED = Text(en="Stopped, as you wished.", ko="멈추었습니다.")
EMPTY = "..."


def main(words: Sequence[str]) -> int:
    """Ask until the learner has enough, and return 0; 2 if there is nothing to ask."""
    options = _options(words)
    root = Path(options.folder) if options.folder else copy_at_hand() or workbook_root()
    if options.folder and not (root / MARK).is_file():
        print(f"tflab practice: {root} is no copy of the workbook; tflab lab makes one", file=sys.stderr)
        return 2
    try:
        session = Session(root, options.chapters.replace(",", " ").split())
        if options.log:
            print(standing(session.kept, session.workbook.language))
            return 0
        _Terminal(session).run()
    except (WorkbookError, TaskError) as error:
        print(f"tflab practice: {error}", file=sys.stderr)
        return 2
    return 0


class _Terminal:
    """Asks and listens."""

    def __init__(self, session: Session) -> None:
        self.session = session
        self.language = session.workbook.language
        self.is_copy = (session.root / MARK).is_file()
        self.files = session.root / "practice" if self.is_copy else Path(mkdtemp(prefix="tflab-practice-"))

    def run(self) -> None:
        """Ask until somebody types quit, Ctrl-C or the end of the input."""
        if sys.stdin.isatty():
            _with_line_editing()
        if not self.is_copy:
            self._say(NO_COPY)
        try:
            while self._one_question() and self._line(NEXT.say(self.language)) != "quit":
                pass
        except (KeyboardInterrupt, EOFError):
            print()
        if self.is_copy:
            self._say(KEPT, where=f" ({self.session.root / 'practice.json'})")

    def _one_question(self) -> bool:
        """Ask one question until it is closed; return whether there shall be another."""
        question = self.session.question()
        self._show(question)
        ask = self._typed if self._is_typed(question) else self._written
        while True:
            try:
                answer = ask(question)
                question = self.session.question()  # what was typed stands in it
                result = self.session.answer(question, answer)
                say_verdict(result.assigned, result.verdict, result.outcomes)
                over = result.is_over
            except Said as said:
                if str(said) == "quit":
                    return False
                over = self._obey(str(said), question)
            if over:
                print(afterwards(self.session.kept, self.language))
                return True

    def _obey(self, word: str, question: DrawnQuestion) -> bool:
        """Do what a word says; return whether the question is over."""
        if word == "skip":
            self.session.leave()
            return True
        (say_hint if word == "hint" else say_solution)(self.session, question)
        return False

    def _show(self, question: DrawnQuestion) -> None:
        width = min(get_terminal_size().columns, WIDEST) - 1
        print(f"\n{why_asked(question.open, self.session.kept, self.language)}\n")
        print(as_text(question.text, width) + "\n")
        if question.given:
            self._say(GIVEN, name=question.given_name)
            print(show_all(question.given) + "\n")
        if self._is_typed(question):
            self._say(HOW_TO_TYPE, name=f"{question.given_name}.…" if question.given else "2 * 3")

    def _is_typed(self, question: DrawnQuestion) -> bool:
        return not question.cases.is_function and can_be_typed(question.item.task.form)

    def _typed(self, question: DrawnQuestion) -> Any:
        """Return the answer that is typed."""

        def ask(label: str, part: str) -> str:
            text = self._line(label)
            if text.strip() and text.strip() not in WORDS:
                self.session.typed(part, text.strip())
            return text

        with in_process_ros():
            space = _space(question)
            exec(question.imports, space)
            task = question.item.task
            return ask_for(task.answer, task.form, self.session.question().open.typed, space, ask)

    def _written(self, question: DrawnQuestion) -> Any:
        """Return what the learner's file defines, once they say that it is saved."""
        file = self.files / f"{question.open.number:03d}_{question.item.task.id}.py"
        if not file.exists():
            head = f"# {question.text.splitlines()[0].lstrip('# ')}\n\n"
            imports = f"{question.imports}\n\n" if question.imports else ""
            write_whole(file, f"{head}{imports}{question.starter}\n")
        editor = os.environ.get("VISUAL") or os.environ.get("EDITOR") or ""
        self._say(IN_FILE, file=file, edit=", edit" if editor else "")
        while True:
            word = self._line("> ").strip()
            if word in WORDS:
                raise Said(word)
            if word == "edit" and editor:
                subprocess.run([*editor.split(), str(file)], check=False)
            elif (answer := self._defined(question, file)) is not None:
                return answer

    def _defined(self, question: DrawnQuestion, file: Path) -> Any:
        """Return what a file defines, `...` if that is nothing; None, having said why, if it cannot be run."""
        space = _space(question)
        try:
            with in_process_ros():
                exec(compile(file.read_text(encoding="utf-8"), str(file), "exec"), space)
        except KeyboardInterrupt:
            self._say(STOPPED)
            return None
        except Exception as error:
            print("".join(traceback.format_exception(error.with_traceback(_inside(error, file)))).rstrip())
            return None
        answer = space.get(question.item.task.answer, ...)
        return ... if answer is None else answer

    def _line(self, prompt: str) -> str:
        return input(prompt)

    def _say(self, words: Text, **names: object) -> None:
        print(words.say(self.language, **names))


def _space(question: DrawnQuestion) -> dict[str, Any]:
    """Return what an answer may use: what is given, Python's mathematics, NumPy."""
    given = question.given
    modules = {name: import_module(module) for name, module in (("math", "math"), ("np", "numpy"))}
    practice = SimpleNamespace(given=lambda: SimpleNamespace(**given))
    return {"__name__": "practice", question.given_name: practice.given(), "practice": practice, **modules}


def _inside(error: BaseException, file: Path) -> Any:
    """Return an error's traceback from the learner's file on."""
    trace = error.__traceback__
    while trace is not None and trace.tb_frame.f_code.co_filename != str(file):
        trace = trace.tb_next
    return trace


def _with_line_editing() -> None:
    try:
        import_module("readline")
    except ImportError:  # Windows has its own
        return


def _options(words: Sequence[str]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="tflab practice", description="Practise: the course's tasks, drawn anew.")
    parser.add_argument("folder", nargs="?", metavar="DIR", help=f"your copy; the nearest, or ./{COPY}, if left out")
    parser.add_argument("--chapters", metavar="03,08", default="", help="as far as you have come, if left out")
    parser.add_argument("--log", action="store_true", help="say what was shown, when, and what comes next")
    return parser.parse_args(list(words))
