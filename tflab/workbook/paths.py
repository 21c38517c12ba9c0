"""Find the workbook: a learner's copy, which `workbook.json` marks, or tflab's own.

    my_copy/
      workbook.json           version, edition, language, learner
      progress.json           what has been tried (see `progress.py`)
      notebooks/en/           pages to read
      exercises/en/E03_....   pages to answer

The same folders, in every language, are in the repository and in the wheel, and with
them the solutions.  `check` computes from these what it compares an answer with, and
`solution` shows one task of them at a time.
"""

from __future__ import annotations

import json
import os
from collections.abc import Iterable, Sequence
from dataclasses import asdict, dataclass, field
from pathlib import Path

from tflab import __version__

from ..text import LANGUAGES

__all__ = [
    "COPY",
    "EDITIONS",
    "MARK",
    "NO_COPY",
    "TASKS",
    "Workbook",
    "WorkbookError",
    "chapter_of",
    "chapters",
    "copy_at_hand",
    "exercise_file",
    "language_here",
    "read_workbook",
    "stems_called",
    "workbook_data",
    "workbook_root",
    "write_workbook",
]

MARK = "workbook.json"
COPY = "tflab_workbook"  # what a copy is called if nobody names it
NO_COPY = f"no workbook copy {{folder}}. Change to your copy ({COPY}), or create one with: tflab lab"
TASKS = Path("solutions", "tasks")
EDITIONS = ("self-study", "class")


LATER = ("seed", "questions")  # what the first copies did not have


class WorkbookError(Exception):
    """What a workbook does not have, or a `workbook.json` that cannot be used; the text says what to try."""

    def _render_traceback_(self) -> list[str]:
        """Return what IPython shows: the text, and not where in our code it was found."""
        return [f"{self}"]


@dataclass(frozen=True)
class Workbook:
    """What a copy of the workbook says about itself.

    Attributes:
        tflab: the version that its pages come from.
        edition: "self-study", with solutions, or "class".
        language: "en" or "ko", that of replies and hints.
        learner: an id, which picks variants of tasks; None has the first ones.
        seed: of a class, what its tasks draw their numbers from; "" is the public seed.
        questions: of a class, what each task asked when it was handed out, as digests by task.
    """

    tflab: str = __version__
    edition: str = "self-study"
    language: str = "en"
    learner: str | None = None
    seed: str = ""
    questions: dict[str, str] = field(default_factory=dict)


def workbook_data() -> Path:
    """Return the folder of what comes with tflab: the wheel's, or in an editable install the repository.

    While pages are built it is another, which TFLAB_WORKBOOK names (see `execute.py`).
    """
    if os.environ.get("TFLAB_WORKBOOK"):
        return Path(os.environ["TFLAB_WORKBOOK"])
    package = Path(__file__).resolve().parents[1]
    in_the_wheel = package / "_workbook"
    return in_the_wheel if in_the_wheel.is_dir() else package.parent


def workbook_root(start: str | Path | None = None) -> Path:
    """Return the nearest folder, from `start` (here) upwards, that is a copy of the workbook; else tflab's own."""
    here = Path(start or Path.cwd()).resolve()
    return next((folder for folder in (here, *here.parents) if (folder / MARK).is_file()), workbook_data())


def copy_at_hand() -> Path | None:
    """Return the copy that a command means to which none is named; else None.

    That is the one we are in, the one below of the usual name, or the only one below.
    """
    usual = next((root for root in (workbook_root(), Path.cwd() / COPY) if (root / MARK).is_file()), None)
    below = [mark.parent for mark in Path.cwd().glob(f"*/{MARK}")]
    return usual or (below[0] if len(below) == 1 else None)


def read_workbook(root: str | Path | None = None) -> Workbook:
    """Return what the workbook at `root` (the nearest) says about itself; of tflab's own, the defaults.

    Raises:
        WorkbookError: its `workbook.json` is not what tflab has written.
    """
    path = Path(root or workbook_root()) / MARK
    if not path.is_file():
        return Workbook()
    try:
        found = json.loads(path.read_text(encoding="utf-8"))
        read = Workbook(**{name: found[name] for name in asdict(Workbook()) if name in found or name not in LATER})
    except (OSError, ValueError, TypeError, KeyError) as error:
        reason = f"{error.args[0]!r} is missing" if isinstance(error, KeyError) else error
        raise WorkbookError(f"{path} cannot be read: {reason}.\n{_remedy(path)}") from None
    if not isinstance(read.seed, str) or not isinstance(read.questions, dict):
        raise WorkbookError(f"{path} cannot be read: what a class asks is damaged.\n{_remedy(path)}")
    if read.edition not in EDITIONS or read.language not in LANGUAGES or not isinstance(read.learner, str | None):
        raise WorkbookError(
            f'{path} says edition "{read.edition}", language "{read.language}" and learner {read.learner!r}; '
            f"there is {' and '.join(EDITIONS)}, {' and '.join(LANGUAGES)}, and a learner is a text or null.\n"
            f"{_remedy(path)}"
        )
    return read


def language_here() -> str:
    """Return the language of the workbook at hand; English if there is none that can be read."""
    try:
        return read_workbook().language
    except WorkbookError:  # said wherever a task is asked for
        return "en"


def write_workbook(root: Path, workbook: Workbook) -> None:
    """Mark `root` as a copy of the workbook."""
    from .atomic_files import write_whole

    write_whole(root / MARK, json.dumps(asdict(workbook), indent=1, ensure_ascii=False) + "\n")


def chapters(root: str | Path | None = None) -> list[str]:
    """Return the stems of the chapters that have tasks, in order; of a class's copy, those that were handed out.

    Raises:
        WorkbookError: the `workbook.json` at `root` cannot be read.
    """
    stems = sorted(path.name for path in (workbook_data() / TASKS).glob("[0-9]*_*") if path.is_dir())
    workbook = Workbook() if root is None else read_workbook(root)
    if workbook.edition != "class":
        return stems
    numbers = {task.partition(".")[0].removeprefix("E") for task in workbook.questions}
    return [stem for stem in stems if str(int(stem.partition("_")[0])) in numbers]


def exercise_file(stem: str) -> str:
    """Return what the notebook with a chapter's exercises is called: two tabs of one chapter have two names."""
    return f"E{stem}.ipynb"


def chapter_of(path: Path) -> str:
    """Return the stem of the chapter that a page, an exercise or its cases belong to."""
    return path.stem.removeprefix("E")


def stems_called(words: Iterable[str], there: Sequence[str], *, what: str = "page") -> list[str]:
    """Return the stems, of those there, that words name whole or by number ("03", "3", "E3"), each once.

    Raises:
        LookupError: a word names none of them; the text says so of a `what`.
    """
    chosen: list[str] = []
    for word in words:
        bare = word.removeprefix("E")
        found = [stem for stem in there if bare == stem or bare.zfill(2) == stem.partition("_")[0]]
        if not found:
            numbers = ", ".join(stem.partition("_")[0] for stem in there)
            raise LookupError(f'unknown {what} "{word}"; available: {numbers or "none"}')
        chosen += found
    return list(dict.fromkeys(chosen))


def _remedy(path: Path) -> str:
    return (
        "Nothing was changed. Put the file right by hand, or move it away and call "
        f'"tflab lab {path.parent.name}" in the folder above: answers and progress.json stay as they are.'
    )
