"""What does only the instructor have?  A secret seed, the hidden cases it makes, and the master notebooks.

    DIR/instructor/
      pack.json                  seed, roster, chapters, version: keep it to yourself
      cases/03_....json          what is graded; same shape as a learner's cases, other inputs
      masters/03_....ipynb       the exercise as it was handed out
      before/1/...               cases and masters as they were before an update

What a learner gets is made from one seed, what is graded from another, and both
from the secret one: knowing the first does not help to find the second.  Of a task
whose answer is a value, what is graded is what the learner was given; of a
function, inputs that nobody has seen: a sample of their own for each.  Read `draw.py` next.
"""

from __future__ import annotations

import hashlib
import hmac
import json
import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import Any

from joblib import Parallel, delayed, parallel_config
from joblib.externals.loky import get_reusable_executor
from tqdm import tqdm

from tflab import __version__
from tflab.workbook.answers.forms import form_from_plain
from tflab.workbook.answers.sealed import sealed_variant
from tflab.workbook.tasks.cases import CasesError, cases_json, make_cases, read_cases
from tflab.workbook.tasks.evidence import usual_among
from tflab.workbook.tasks.task import variant_of
from tflab.workbook.whole_files import write_whole

from ..submissions.roster import Learner
from .cells import Master, master_of
from .draw import POOL, digest_of, drawn, pool_of

__all__ = [
    "DAMAGE", "Pack", "PackError", "chapter_cases", "chapters_made", "keep_chapter", "learners_cases", "read_pack",
    "usual_of", "write_chapter", "write_pack",
]  # fmt: skip

FORMAT = 2
PACK = "pack.json"
BEFORE = "before"
DAMAGE = (KeyError, TypeError, ValueError, IndexError, AttributeError)  # what reading JSON that is not ours raises


class PackError(Exception):
    """A folder that is no pack; the text says what is wrong, and what to do."""


@dataclass(frozen=True)
class Pack:
    """An instructor's pack.

    Attributes:
        release: a short name that stands in every notebook handed out; it says nothing about the seed.
        seed: 256 secret bits, as hex.
        roster: the learners by id, or None if everybody got the same folder.
        cases: what is graded, by chapter.
        masters: the exercises as they were handed out, by chapter.
    """

    release: str
    seed: str
    version: str = __version__
    language: str = "en"
    roster: dict[str, Learner] | None = None
    cases: dict[str, dict[str, Any]] = field(default_factory=dict)
    masters: dict[str, Master] = field(default_factory=dict)

    @cached_property
    def digest(self) -> str:
        """A name for exactly this pack, so that results of another are not taken for its own."""
        held = json.dumps([self.release, self.seed, self.version, self.cases], sort_keys=True)
        return hashlib.sha256(held.encode()).hexdigest()

    @cached_property
    def usual(self) -> dict[str, list[list[bool]]]:
        """By task and variant, which parts of a value are right in most other variants, too."""
        tasks = {task_id: task for cases in self.cases.values() for task_id, task in cases["tasks"].items()}
        return {task_id: usual_of(task) for task_id, task in tasks.items() if not task["is_function"]}

    def seal_of(self, stamp: Mapping[str, str]) -> str:
        """Return what proves that a notebook's stamp is ours: a code for it that only this pack can make (an HMAC)."""
        said = json.dumps([stamp.get(name, "") for name in ("release", "chapter", "learner")])
        return _derived(self.seed, f"stamp/{said}").hex()[:32]

    def sealed_this(self, stamp: Mapping[str, str]) -> bool:
        """Return whether a stamp is as this release handed it out, not written by somebody else."""
        return hmac.compare_digest(stamp.get("seal", "").encode(), self.seal_of(stamp).encode())

    def for_learner(self, learner: str) -> dict[str, dict[str, Any]]:
        """Return what one learner is graded on: the master cells and tasks of each chapter, plain data."""
        chapters = {}
        for stem, cases in self.cases.items():
            cells = [
                [cell.name, cell.source, cell.task, cell.role, list(cell.earlier)] for cell in self.masters[stem].cells
            ]
            tasks = {}
            for task_id, task in cases["tasks"].items():
                number = variant_for(self.roster, learner, task_id, task)
                variant = task["variants"][number]
                held = {name: held for name, held in task.items() if name != "variants"} | variant
                if "tells" in held["cases"][0]:
                    held |= drawn(held["cases"], _derived(self.seed, f"asked/{learner}/{task_id}"))
                if not task["is_function"]:
                    held["usual"] = self.usual[task_id][number]
                tasks[task_id] = held
            chapters[stem] = {"master": cells, "tasks": tasks}
        return chapters


def variant_for(roster: Mapping[str, Learner] | None, learner: str, task_id: str, task: Mapping[str, Any]) -> int:
    """Return which variant of a task a learner has; without a roster everybody has the first."""
    return variant_of(learner, task_id, len(task["variants"])) if roster is not None and learner in roster else 0


def usual_of(task: Mapping[str, Any]) -> list[list[bool]]:
    """Return for each variant of a value task which of its parts are right in most others, too."""
    form = form_from_plain(task["form"])
    expected = [variant["cases"][0]["expected"] for variant in task["variants"]]
    return [
        usual_among(form, right, [*expected[:number], *expected[number + 1 :]]) for number, right in enumerate(expected)
    ]


def chapter_cases(stem: str, seed: str, solutions: Path) -> tuple[dict[str, Any], dict[str, Any]]:
    """Return a chapter's cases for the learners (open) and for grading."""
    learners = make_cases(stem, _derived(seed, "learners"), solutions=solutions)
    hidden = make_cases(stem, _derived(seed, "hidden"), solutions=solutions, fewest_inputs=POOL)
    # As they will be read: a file has its keys sorted, and what is sealed keeps to the order of the parts.
    learners, hidden = (json.loads(cases_json(cases)) for cases in (learners, hidden))
    # What a learner was shown is part of the question: then the inputs that go with it are, too.
    graded = {
        task_id: _pooled(hidden["tasks"][task_id], task) if task["is_function"] and not _shows_values(task) else task
        for task_id, task in learners["tasks"].items()
    }
    return learners, learners | {"tasks": graded}


def chapters_made(
    stems: Sequence[str], seed: str, solutions: Path, *, quiet: bool = True
) -> dict[str, tuple[dict[str, Any], dict[str, Any]]]:
    """Return the `chapter_cases` of each chapter, in their order; the longest are begun first, side by side."""
    size = {stem: sum(path.stat().st_size for path in (solutions / "tasks" / stem).glob("*.py")) for stem in stems}
    longest_first = sorted(stems, key=size.__getitem__, reverse=True)
    made = {}
    work = Parallel(min(len(stems), os.cpu_count() or 1) or 1, return_as="generator_unordered", batch_size=1)
    with tqdm(desc="made", total=len(stems), leave=False, disable=quiet or None) as bar:
        try:
            for stem, cases in work(delayed(_called)(stem, seed, solutions) for stem in longest_first):
                made[stem] = cases
                bar.update()
        except BaseException:
            if work.n_jobs != 1:
                get_reusable_executor().shutdown(wait=True, kill_workers=True)
            raise
    return {stem: made[stem] for stem in stems}


def _called(stem: str, seed: str, solutions: Path) -> tuple[str, tuple[dict[str, Any], dict[str, Any]]]:
    with parallel_config(backend="loky"):  # patients made in threads would share the folder they are made in
        return stem, chapter_cases(stem, seed, solutions)


def _pooled(hidden: Mapping[str, Any], public: Mapping[str, Any]) -> dict[str, Any]:
    """Return a function's hidden cases as the pool from which each learner's are drawn."""
    shown = {digest_of(case["args"]) for variant in public["variants"] for case in variant["cases"]}
    variants = [variant | {"cases": pool_of(hidden, variant["cases"], shown)} for variant in hidden["variants"]]
    return dict(hidden) | {"variants": variants}


def _shows_values(task: Mapping[str, Any]) -> bool:
    """Return whether learners are shown what they are to answer about."""
    return any(variant["given"] for variant in task["variants"])


def learners_cases(
    cases: Mapping[str, Any], roster: Mapping[str, Learner] | None, learner: str | None
) -> dict[str, Any]:
    """Return a chapter's cases as one learner gets them: only their variant, values sealed."""
    tasks = {}
    for task_id, task in cases["tasks"].items():
        variant = task["variants"][variant_for(roster, learner or "", task_id, task)]
        if not task["is_function"]:
            variant = sealed_variant(form_from_plain(task["form"]), variant, learner)
        tasks[task_id] = task | {"variants": [variant]}
    return dict(cases) | {"tasks": tasks}


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
        "chapters": sorted(pack.cases),
    }
    write_whole(folder / PACK, json.dumps(held, indent=1, ensure_ascii=False) + "\n")
    for path, mode in ((folder, 0o700), (folder / PACK, 0o600)):
        os.chmod(path, mode)


def write_chapter(folder: Path, stem: str, graded: Mapping[str, Any], master: bytes) -> None:
    """Write what a chapter is graded on, and its master notebook."""
    write_whole(folder / "cases" / f"{stem}.json", cases_json(dict(graded)))
    write_whole(folder / "masters" / f"{stem}.ipynb", master)


def keep_chapter(folder: Path, stem: str) -> None:
    """Put a chapter's cases and master aside, as they are: what was handed out with them stays gradable."""
    number = 1
    while (folder / BEFORE / str(number) / "masters" / f"{stem}.ipynb").exists():
        number += 1
    for name in (f"cases/{stem}.json", f"masters/{stem}.ipynb"):
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
        cases = {stem: read_cases(path.parent / "cases" / f"{stem}.json") for stem in held["chapters"]}
        check_roster(roster or {})
        for held_cases in cases.values():
            check_tasks(held_cases["tasks"])
        masters = {stem: _read_master(path.parent, stem, cases[stem]) for stem in cases}
        return Pack(held["release"], held["seed"], held["version"], held["language"], roster, cases, masters)
    except (*DAMAGE, OSError, CasesError) as error:
        raise PackError(f"{path.parent} is damaged: {type(error).__name__}: {error}") from None


def check_roster(roster: Mapping[str, Learner]) -> None:
    """Raise TypeError if a learner is not made of texts."""
    words = [word for learner in roster.values() for word in (learner.id, learner.name, learner.language)]
    if not all(isinstance(word, str) for word in words):
        raise TypeError("the roster holds something else than texts")


def check_tasks(tasks: Mapping[str, Any]) -> None:
    """Raise KeyError, TypeError or ValueError if what grading will look at is not there, or of another kind."""
    for task_id, task in tasks.items():
        form_from_plain(task["form"])
        if not (task["variants"] and all(variant["cases"] for variant in task["variants"])):
            raise ValueError(f"{task_id} has no cases")
        if not (float(task["points"]) >= 0 and isinstance(task["answer"], str) and isinstance(task["twins"], dict)):
            raise ValueError(f"{task_id} has no points, or no answer to look for")


def _read_master(folder: Path, stem: str, cases: Mapping[str, Any]) -> Master:
    paths = [folder / "masters" / f"{stem}.ipynb", *sorted((folder / BEFORE).glob(f"*/masters/{stem}.ipynb"))]
    notebook, *earlier = (json.loads(path.read_text(encoding="utf-8")) for path in paths)
    return master_of(notebook, stem, cases["tasks"], earlier)


def _derived(seed: str, purpose: str) -> bytes:
    return hmac.new(bytes.fromhex(seed), purpose.encode(), "sha256").digest()
