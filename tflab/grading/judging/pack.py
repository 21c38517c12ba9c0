"""Keep what only the instructor has: a secret seed, and the exercises as they were handed out.

    DIR/instructor/
      pack.json                  seed, roster, version, what each task asks: keep it to yourself
      masters/03_....ipynb       the exercise as it was handed out
      before/1/...               masters as they were before an update

Hidden cases are not stored.  They are computed from the seed when grading begins.  What a
learner gets is made from one seed, what is graded from another, and both from the secret
one: knowing the first does not help to find the second.  Of a task whose answer is a
value, what is graded is what the learner was given; of a function, inputs that nobody has
seen: a sample of their own for each (see `draw.py`).
"""

from __future__ import annotations

import hashlib
import hmac
import json
import os
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import Any, TypeVar

from joblib import Parallel, delayed, parallel_config
from joblib.externals.loky import get_reusable_executor
from tqdm import tqdm

from tflab import __version__
from tflab.text import Text
from tflab.workbook.answers.forms import form_from_plain
from tflab.workbook.atomic_files import write_whole
from tflab.workbook.paths import TASKS, workbook_data
from tflab.workbook.tasks.case_types import TaskCases
from tflab.workbook.tasks.catalog import question_digest, seed_of, solution_of, tasks_of
from tflab.workbook.tasks.credit import usual_among
from tflab.workbook.tasks.generate_cases import task_cases
from tflab.workbook.tasks.reference import in_process_ros
from tflab.workbook.tasks.task import variant_of

from ..submissions.roster import Learner
from .cells import Master, master_of
from .draw import POOL, digest_of, drawn, pool_of

__all__ = [
    "MALFORMED", "Pack", "PackError", "graded_cases", "keep_chapter", "learners_seed", "questions_asked", "read_pack",
    "usual_of", "write_master", "write_pack",
]  # fmt: skip

FORMAT = 4
Made = TypeVar("Made")
PACK = "pack.json"
BEFORE = "before"
MALFORMED = (KeyError, TypeError, ValueError, IndexError, AttributeError)  # what reading JSON that is not ours raises


class PackError(Exception):
    """A folder that is no pack; the text says what is wrong, and what to do."""


@dataclass(frozen=True)
class Pack:
    """An instructor's pack.

    Attributes:
        release: a short name that stands in every notebook handed out; it says nothing about the seed.
        seed: 256 secret bits, as hex.
        roster: the learners by id, or None if everybody got the same folder.
        questions: by chapter and task, what each variant asks, as digests.
        masters: the exercises as they were handed out, by chapter.
    """

    release: str
    seed: str
    version: str = __version__
    language: str = "en"
    roster: dict[str, Learner] | None = None
    questions: dict[str, dict[str, list[str]]] = field(default_factory=dict)
    masters: dict[str, Master] = field(default_factory=dict)
    _cases: dict[str, dict[str, Any]] = field(default_factory=dict, compare=False)

    @property
    def chapters(self) -> list[str]:
        """Return the stems of the chapters that were released."""
        return list(self.questions)

    @cached_property
    def titles(self) -> dict[str, dict[str, Text]]:
        """The titles of the tasks, by chapter and task."""
        return {
            stem: {name: task.title for name, task in tasks_of(workbook_data(), stem).items() if name in tasks}
            for stem, tasks in self.questions.items()
        }

    @cached_property
    def digest(self) -> str:
        """A name for exactly this pack, so that results of another are not taken for its own."""
        held = json.dumps([self.release, self.seed, self.version, self.questions], sort_keys=True)
        return hashlib.sha256(held.encode()).hexdigest()

    def compute_cases(self, *, quiet: bool = True) -> None:
        """Compute what is graded, unless that was done already.

        Raises:
            PackError: a task asks something else than when it was released.
        """
        if self._cases:
            return
        made = _on_all_cores(graded_cases, self.chapters, self.seed, "hidden cases", quiet)
        self.refuse_other_questions({stem: questions for stem, (_, questions) in made.items()})
        for stem, (cases, _) in made.items():
            self._cases[stem] = {name: task for name, task in cases.items() if name in self.questions[stem]}

    def refuse_other_questions(self, now: Mapping[str, Mapping[str, Sequence[str]]]) -> None:
        """Raise PackError if a released task asks something else in this version.

        Args:
            now: what each task asks in this version, as digests, by chapter.
        """
        other = [name for stem in now for name, asked in self.questions[stem].items() if now[stem].get(name) != asked]
        if other:
            raise PackError(
                f"{', '.join(other)} asks something else in tflab {__version__} than when it was released with tflab "
                f"{self.version}. Nothing was changed. Grade this release with tflab {self.version}"
            )

    def seal_of(self, stamp: Mapping[str, str]) -> str:
        """Return what proves that a notebook's stamp is ours: a code for it that only this pack can make (an HMAC)."""
        said = json.dumps([stamp.get(name, "") for name in ("release", "chapter", "learner")])
        return _derived(self.seed, f"stamp/{said}").hex()[:32]

    def sealed_this(self, stamp: Mapping[str, str]) -> bool:
        """Return whether a stamp is as this release handed it out, not written by somebody else."""
        return hmac.compare_digest(stamp.get("seal", "").encode(), self.seal_of(stamp).encode())

    def for_learner(self, learner: str) -> dict[str, dict[str, Any]]:
        """Return what one learner is graded on: the master cells and tasks of each chapter, plain data."""
        self.compute_cases()
        chapters = {}
        for stem in self.chapters:
            cells = [
                [cell.name, cell.source, cell.task, cell.role, list(cell.earlier)] for cell in self.masters[stem].cells
            ]
            tasks = {}
            for task_id, task in self._cases[stem].items():
                number = variant_for(self.roster, learner, task_id, len(task["variants"]))
                variant = task["variants"][number]
                held = {name: held for name, held in task.items() if name not in ("variants", "usual")} | variant
                if "tells" in held["cases"][0]:
                    held |= drawn(held["cases"], _derived(self.seed, f"asked/{learner}/{task_id}"))
                if not task["is_function"]:
                    held["usual"] = task["usual"][number]
                tasks[task_id] = held
            chapters[stem] = {"master": cells, "tasks": tasks}
        return chapters


def variant_for(roster: Mapping[str, Learner] | None, learner: str, task_id: str, count: int) -> int:
    """Return which of a task's variants a learner has; without a roster everybody has the first."""
    return variant_of(learner, task_id, count) if roster is not None and learner in roster else 0


def usual_of(task: Mapping[str, Any]) -> list[list[bool]]:
    """Return for each variant of a value task which of its parts are right in most others, too."""
    form = form_from_plain(task["form"])
    expected = [variant["cases"][0]["expected"] for variant in task["variants"]]
    return [
        usual_among(form, right, [*expected[:number], *expected[number + 1 :]]) for number, right in enumerate(expected)
    ]


def learners_seed(seed: str) -> str:
    """Return the seed from which the learners' numbers are drawn; it stands in their copies."""
    return _derived(seed, "learners").hex()


def questions_asked(stems: Sequence[str], seed: str, *, quiet: bool = True) -> dict[str, dict[str, list[str]]]:
    """Return what each variant of each task asks with a seed, as digests, by chapter and task.

    Raises:
        TaskError: a chapter's task or solution cannot be used.
    """
    return _on_all_cores(_questions_of, stems, seed, "tasks", quiet)


def _questions_of(data: Path, stem: str, seed: str) -> dict[str, list[str]]:
    made = ((name, _learners_cases(data, stem, name, seed)) for name in tasks_of(data, stem))
    return {name: [question_digest(task, variant) for variant in task.variants] for name, task in made}


def graded_cases(data: Path, stem: str, seed: str) -> tuple[dict[str, Any], dict[str, list[str]]]:
    """Return what a chapter is graded on, by task, and what each variant asks, as digests."""
    cases, questions = {}, {}
    for name, task in tasks_of(data, stem).items():
        public = _learners_cases(data, stem, name, seed)
        questions[name] = [question_digest(public, variant) for variant in public.variants]
        held = public.plain()
        # What a learner was shown is part of the question: then the inputs that go with it are, too.
        if public.is_function and not any(variant.given for variant in public.variants):
            with in_process_ros():
                hidden = task_cases(task, _derived(seed, "hidden"), solution_of(data, stem), fewest_inputs=POOL)
            held = _pooled(hidden.plain(), held)
        if not public.is_function:
            held["usual"] = usual_of(held)
        cases[name] = held
    return cases, questions


def _learners_cases(data: Path, stem: str, task_id: str, seed: str) -> TaskCases:
    task = tasks_of(data, stem)[task_id]
    with in_process_ros():
        return task_cases(task, seed_of(task, learners_seed(seed)), solution_of(data, stem))


def _on_all_cores(
    make: Callable[[Path, str, str], Made], stems: Sequence[str], seed: str, what: str, quiet: bool
) -> dict[str, Made]:
    """Return what is made of each chapter with a seed; the longest are begun first, side by side."""
    data = workbook_data()
    size = {stem: sum(path.stat().st_size for path in (data / TASKS / stem).glob("*.py")) for stem in stems}
    longest_first = sorted(stems, key=size.__getitem__, reverse=True)
    made = {}
    work = Parallel(min(len(stems), os.cpu_count() or 1) or 1, return_as="generator_unordered", batch_size=1)
    with tqdm(desc=what, total=len(stems), leave=False, disable=quiet or None) as bar:
        try:
            for stem, held in work(delayed(_called)(make, data, stem, seed) for stem in longest_first):
                made[stem] = held
                bar.update()
        except BaseException:
            if work.n_jobs != 1:
                get_reusable_executor().shutdown(wait=True, kill_workers=True)
            raise
    return {stem: made[stem] for stem in stems}


def _called(make: Callable[[Path, str, str], Made], data: Path, stem: str, seed: str) -> tuple[str, Made]:
    with parallel_config(backend="loky"):  # patients made in threads would share the folder they are made in
        return stem, make(data, stem, seed)


def _pooled(hidden: Mapping[str, Any], public: Mapping[str, Any]) -> dict[str, Any]:
    """Return a function's hidden cases as the pool from which each learner's are drawn."""
    shown = {digest_of(case["args"]) for variant in public["variants"] for case in variant["cases"]}
    variants = [variant | {"cases": pool_of(hidden, variant["cases"], shown)} for variant in hidden["variants"]]
    return dict(hidden) | {"variants": variants}


def write_pack(folder: Path, pack: Pack) -> None:
    """Write `pack.json`, readable by its owner only; the chapters have files of their own."""
    folder.mkdir(parents=True, exist_ok=True)
    roster = (
        None
        if pack.roster is None
        else [[learner.id, learner.name, learner.language] for learner in pack.roster.values()]
    )
    held = {
        "format": FORMAT,
        "what": "The instructor's pack: whoever has it has the hidden cases. Keep it to yourself.",
        "release": pack.release,
        "seed": pack.seed,
        "version": pack.version,
        "language": pack.language,
        "roster": roster,
        "questions": pack.questions,
    }
    write_whole(folder / PACK, json.dumps(held, indent=1, ensure_ascii=False) + "\n")
    for path, mode in ((folder, 0o700), (folder / PACK, 0o600)):
        os.chmod(path, mode)


def write_master(folder: Path, stem: str, master: bytes) -> None:
    """Write the exercise of a chapter as it is handed out."""
    write_whole(folder / "masters" / f"{stem}.ipynb", master)


def keep_chapter(folder: Path, stem: str) -> None:
    """Put a chapter's master aside, as it is: what was handed out with it stays gradable."""
    number = 1
    while (folder / BEFORE / str(number) / "masters" / f"{stem}.ipynb").exists():
        number += 1
    name = f"masters/{stem}.ipynb"
    write_whole(folder / BEFORE / str(number) / name, (folder / name).read_bytes())


def read_pack(folder: Path) -> Pack:
    """Return the pack in a folder.

    Raises:
        PackError: there is none, or it is damaged, or of another format.
    """
    path = folder / PACK if folder.is_dir() else folder
    try:
        held = json.loads(path.read_text(encoding="utf-8"))
    except OSError:
        raise PackError(f"there is no pack in {folder}; `tflab release DIR` writes one to DIR/instructor") from None
    except ValueError as error:
        raise PackError(f"{path} is damaged: {error}") from None
    if not isinstance(held, dict) or held.get("format") != FORMAT:
        raise PackError(f"{path} was made by another version of tflab; grade with the version that made it")
    try:
        roster = None if held["roster"] is None else {row[0]: Learner(*row) for row in held["roster"]}
        check_roster(roster or {})
        questions = held["questions"]
        _check_questions(questions)
        masters = {stem: _read_master(path.parent, stem, questions[stem]) for stem in questions}
        return Pack(held["release"], held["seed"], held["version"], held["language"], roster, questions, masters)
    except (*MALFORMED, OSError) as error:
        raise PackError(f"{path.parent} is damaged: {type(error).__name__}: {error}") from None


def check_roster(roster: Mapping[str, Learner]) -> None:
    """Raise TypeError if a learner is not made of texts."""
    words = [word for learner in roster.values() for word in (learner.id, learner.name, learner.language)]
    if not all(isinstance(word, str) for word in words):
        raise TypeError("the roster holds something else than texts")


def _check_questions(questions: Mapping[str, Mapping[str, Sequence[str]]]) -> None:
    """Raise TypeError if what each task asks is not there as digests."""
    for stem, tasks in questions.items():
        asked = [digest for digests in tasks.values() for digest in digests]
        if not (isinstance(stem, str) and asked and all(isinstance(digest, str) for digest in asked)):
            raise TypeError(f"what the tasks of {stem} ask is not there")


def _read_master(folder: Path, stem: str, tasks: Iterable[str]) -> Master:
    paths = [folder / "masters" / f"{stem}.ipynb", *sorted((folder / BEFORE).glob(f"*/masters/{stem}.ipynb"))]
    notebook, *earlier = (json.loads(path.read_text(encoding="utf-8")) for path in paths)
    return master_of(notebook, stem, tasks, earlier)


def _derived(seed: str, purpose: str) -> bytes:
    return hmac.new(bytes.fromhex(seed), purpose.encode(), "sha256").digest()
