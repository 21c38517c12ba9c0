"""Grade a class: `tflab grade SUBMISSIONS --pack DIR/instructor --out results/`.

    submissions (folder, zip)  --collect-->  jobs  --batch-->  records  -->  grades.csv, results.json,
                                                                             feedback/s101.html, class.html

What is missing or malformed is a line in the report and stops nothing.
"""

from __future__ import annotations

import argparse
import contextlib
import json
import os
import sys
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from tflab import __version__
from tflab.core.stamps import seconds_typed
from tflab.text import Text
from tflab.workbook.atomic_files import write_whole
from tflab.workbook.tasks.task import TaskError

from .judging.isolated import stamps_safely
from .judging.job import SEVERAL
from .judging.pack import Pack, PackError, read_pack
from .reports.class_page import class_page
from .reports.feedback import LEVELS, feedback_page
from .reports.gradebook import LMS, file_names, grades_csv, remarks_of, results_json
from .submissions.collect import Collection, collect
from .submissions.reader import Unreadable
from .submissions.remarks import Remark

__all__ = ["main"]

BY_CTRL_C = 130
NEEDS_LINUX = (
    "grading runs what learners wrote behind a wall that only Linux has; use Linux, WSL or a container. "
    "`tflab check` works everywhere"
)


def main(words: Sequence[str]) -> int:
    """Grade, and return 0; 2 if nothing could be graded, 130 if it was stopped."""
    options = _options(words)
    out = Path(options.out)
    if sys.platform != "linux":
        return _refuse(NEEDS_LINUX)
    from .kernels.kernel_pool import KernelError  # from here on it is Linux

    try:
        pack = read_pack(Path(options.pack))
        if out.resolve() == Path(options.submissions).resolve():
            return _refuse("the results would be taken for submissions; name another folder with --out")
        elsewhere = (out, Path(options.pack))
        collection = collect(
            Path(options.submissions), pack.roster, pack.chapters, elsewhere,
            is_genuine=pack.sealed_this, stamps_in=stamps_safely,
        )  # fmt: skip
        if pack.version != __version__:
            other = Remark("other tflab", stamp=pack.version, ours=__version__)
            collection = replace(collection, remarks=(*collection.remarks, other))
        if not collection.submissions:
            return _refuse(f"there is no submission in {options.submissions}")
        (out / "submissions").mkdir(parents=True, exist_ok=True)
        records, wall = _grade(collection, pack, out, options)
        _write_reports(records, collection, pack, out, options, wall)
    except (PackError, TaskError, Unreadable, KernelError, ImportError) as error:
        return _refuse(str(error))
    except KeyboardInterrupt:
        done = len(list((out / "submissions").glob("*.json")))
        print(
            f"\ntflab grade: stopped. {done} are done and kept; the same command goes on from there.", file=sys.stderr
        )
        return BY_CTRL_C
    _say(records, collection, out, wall)
    return 0


def _grade(
    collection: Collection, pack: Pack, out: Path, options: argparse.Namespace
) -> tuple[list[dict], tuple[Text, ...]]:
    from .kernels.kernel_pool import choose_sandbox
    from .kernels.limits import Limits

    pack.compute_cases(quiet=options.quiet)
    hidden = (Path(options.pack), Path(options.submissions), out)
    sandbox = choose_sandbox(hide=tuple(str(path.resolve()) for path in hidden))
    from .batch import GradingOptions, grade_batch

    limits = Limits(cell_s=options.seconds, notebook_s=6 * options.seconds)
    jobs = options.jobs if options.jobs > 0 else os.cpu_count() or 1
    how = GradingOptions(limits, sandbox, jobs, options.quiet, options.several)
    wall = (sandbox.announce(), *sandbox.gaps)
    return grade_batch(collection, pack, out, how), wall


def _write_reports(
    records: list[dict[str, Any]],
    collection: Collection,
    pack: Pack,
    out: Path,
    options: argparse.Namespace,
    wall: tuple[Text, ...],
) -> None:
    about = {
        "tflab": __version__,
        "release": pack.release,
        "chapters": pack.chapters,
        "wall": [line.en for line in wall],
        "several": options.several,
        "remarks": [remark.plain() for remark in collection.remarks],
    }
    before = _learners_in(out / "results.json")
    write_whole(out / "grades.csv", grades_csv(records, options.lms, options.assignment))
    write_whole(out / "results.json", results_json(records, about))
    pages = out / "feedback"
    for name in file_names(before).values():  # of an earlier run, perhaps on another level
        (pages / f"{name}.html").unlink(missing_ok=True)
    if options.feedback != "none":
        names = file_names(record["learner"] for record in records)
        for record in records:
            page = feedback_page(record, pack.titles, options.feedback)
            write_whole(pages / f"{names[record['learner']]}.html", page)
    shown = class_page(records, language=pack.language, wall=wall, remarks=collection.remarks)
    write_whole(out / "class.html", shown)


def _learners_in(results: Path) -> list[str]:
    """Return who is in the results of an earlier run."""
    try:
        return [str(record["learner"]) for record in json.loads(results.read_text(encoding="utf-8"))["submissions"]]
    except (OSError, ValueError, TypeError, KeyError):
        return []


def _say(records: list[dict[str, Any]], collection: Collection, out: Path, wall: tuple[Text, ...]) -> None:
    for remark in collection.remarks:
        print(remark.say("en"))
    for record in records:
        if not record["handed_in"]:
            why = " ".join(remark.say("en") for remark in remarks_of(record)) or "nothing to grade."
            print(f"{record['learner']}: {why}")
    handed_in = [record for record in records if record["handed_in"]]
    counted = f"{len(handed_in)} graded, {len(records) - len(handed_in)} with nothing to grade."
    print(counted, *(line.en for line in wall))
    print(f"{out / 'grades.csv'}  {out / 'results.json'}  {out / 'class.html'}")


def _refuse(why: str) -> int:
    print(f"tflab grade: {why}", file=sys.stderr)
    return 2


def _seconds(word: str) -> float:
    with contextlib.suppress(ValueError):
        return seconds_typed(word)
    raise argparse.ArgumentTypeError(f"{word!r} is no number of seconds above 0")


def _options(words: Sequence[str]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="tflab grade", description="Grade what a class handed in.")
    parser.add_argument("submissions", metavar="SUBMISSIONS", help="a folder of notebooks or of folders, or a zip")
    parser.add_argument("--pack", required=True, metavar="DIR", help="the instructor's folder of the release")
    parser.add_argument("--out", default="results", metavar="DIR", help="where the results go; %(default)s if left out")
    parser.add_argument("--jobs", type=int, default=1, metavar="N", help="how many at once; 0: one for each processor")
    parser.add_argument("--lms", choices=sorted(LMS), help="the columns of grades.csv")
    parser.add_argument("--assignment", default="tflab", metavar="NAME", help="its column in Canvas; %(default)s")
    parser.add_argument("--feedback", choices=LEVELS, default="named", help="what learners see; %(default)s")
    parser.add_argument(
        "--several", choices=SEVERAL, default=SEVERAL[0],
        help="of a chapter that is there more than once: the notebook with most answers, the latest or the first by "
        "its name; %(default)s",
    )  # fmt: skip
    parser.add_argument("--seconds", type=_seconds, default=5.0, metavar="S", help="for one cell; %(default)s")
    parser.add_argument("--quiet", action="store_true", help="no progress bar")
    return parser.parse_args(list(words))
