"""How many submissions a minute, beside nbgrader, on the same work, and how much memory for 500?

    python benchmarks/grading.py [--submissions 40] [--chapter 03_target_and_source]
    python benchmarks/grading.py --memory 500

The work is a chapter's exercises, honestly answered.  Both graders run every task of every
notebook from the command line, from start to end, in turn on one process and on two; the sandbox
is on.  nbgrader, which has no jobs, grades on two as two courses of half the size; it grades
by the checks in the notebook, in the learner's process, and has no sandbox.
"""

from __future__ import annotations

import argparse
import csv
import json
import os
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import psutil

from tflab.grading.kernels.kernel_pool import choose_sandbox
from tflab.workbook.paths import exercise_file, workbook_data

BIN = Path(sys.executable).parent
GOAL = 10.0
COURSE = "c = get_config()\nc.CourseDirectory.course_id = 'bench'\nc.ExecutePreprocessor.timeout = 60\n"


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--submissions", type=int, default=40)
    parser.add_argument("--chapter", default="03_target_and_source")
    parser.add_argument("--memory", type=int, metavar="N", help="only: grade N submissions and watch the memory")
    options = parser.parse_args()
    print(*(line.en for line in (choose_sandbox().announce(), *choose_sandbox().gaps)))
    with tempfile.TemporaryDirectory(prefix="tflab-bench-") as folder:
        if options.memory:
            return memory(Path(folder), options.chapter, options.memory)
        return speed(Path(folder), options.chapter, options.submissions)


def speed(folder: Path, chapter: str, count: int) -> int:
    ours, tasks = hand_in(folder / "ours", chapter, count)
    print(f"{count} submissions of {chapter}: {tasks} tasks each")
    worst = float("inf")
    for processes in (1, 2):
        theirs = [course(folder / f"nbgrader-{processes}-{n}", chapter, count // processes) for n in range(processes)]
        slow = time_of([nbgrader(one) for one in theirs], count)
        fast = time_of([tflab(ours, folder / f"results-{processes}", processes)], count)
        marks = {*marks_of_nbgrader(theirs), *marks_of_tflab(folder / f"results-{processes}")}
        ratio = fast / slow
        worst = min(worst, ratio)
        print(f"{processes} process{'es' * (processes > 1):2}  nbgrader {slow:6.0f} / min   tflab {fast:6.0f} / min   "
              f"ratio {ratio:5.1f}   marks {', '.join(sorted(marks))}")  # fmt: skip
    print(f"goal: {GOAL:g} on one process and on two")
    return 0 if worst >= GOAL else 1


def memory(folder: Path, chapter: str, count: int) -> int:
    ours, _ = hand_in(folder / "ours", chapter, count)
    before = set(Path(tempfile.gettempdir()).iterdir())
    grader = psutil.Popen(tflab(ours, folder / "results", 1), stdout=subprocess.DEVNULL)
    seen: list[tuple[float, float]] = []
    begin = time.monotonic()
    while grader.poll() is None:
        with psutil.Process().oneshot():
            seen.append((grader.memory_info().rss / 1e6, together(grader)))
        time.sleep(0.5)
    third = max(1, len(seen) // 3)
    print(f"{count} submissions in {time.monotonic() - begin:.0f} s")
    print(f"the grader itself: {max(rss for rss, _ in seen):.0f} MB at most; a third of the way "
          f"{max(rss for rss, _ in seen[:third]):.0f}, at the end {seen[-1][0]:.0f}")  # fmt: skip
    print(f"with its forkserver and kernels, shared pages counted once: {max(all_ for _, all_ in seen):.0f} MB at most")
    left = {path.name for path in set(Path(tempfile.gettempdir()).iterdir()) - before}
    print(f"left behind in {tempfile.gettempdir()}: {', '.join(sorted(left)) or 'nothing'}")
    return 0


def together(process: psutil.Process) -> float:
    """Return what a process and all below it hold [MB]."""
    total = 0.0
    for one in (process, *process.children(recursive=True)):
        try:
            total += one.memory_full_info().pss / 1e6
        except psutil.Error:
            continue
    return total


# The work.


def hand_in(folder: Path, chapter: str, count: int) -> tuple[Path, int]:
    """Release a chapter and answer it `count` times."""
    release = [BIN / "tflab", "release", folder, "--chapters", chapter[:2]]
    subprocess.run(release, check=True, stdout=subprocess.DEVNULL)
    (blank,) = (folder / "learners").glob(f"*/exercises/en/{exercise_file(chapter)}")
    notebook, tasks = answered(blank, chapter)
    for number in range(count):
        copy = folder / "submissions" / f"s{number:03}" / f"{chapter}.ipynb"
        copy.parent.mkdir(parents=True)
        copy.write_text(notebook, encoding="utf-8")
    return folder, tasks


def answered(blank: Path, chapter: str) -> tuple[str, int]:
    """Return an exercise notebook with the answers of the solution in it, and how many those are."""
    solution = json.loads((workbook_data() / "solutions" / "en" / f"{chapter}.ipynb").read_text(encoding="utf-8"))
    answers = {cell["id"]: cell["source"] for cell in solution["cells"] if "answer" in cell["metadata"].get("tags", ())}
    notebook = json.loads(blank.read_text(encoding="utf-8"))
    for cell in notebook["cells"]:
        cell["source"] = answers.get(cell["id"], cell["source"])
    return json.dumps(notebook), len(answers)


def course(folder: Path, chapter: str, count: int) -> Path:
    """Make an nbgrader course of the same exercise, handed in `count` times."""
    blank = workbook_data() / "exercises" / "en" / exercise_file(chapter)
    source = folder / "source" / "ps1" / f"{chapter}.ipynb"
    source.parent.mkdir(parents=True)
    shutil.copy(blank, source)
    (folder / "nbgrader_config.py").write_text(COURSE, encoding="utf-8")
    generate = [BIN / "nbgrader", "generate_assignment", "ps1"]
    subprocess.run(generate, cwd=folder, check=True, capture_output=True, env=environment())
    notebook, _ = answered(folder / "release" / "ps1" / f"{chapter}.ipynb", chapter)
    for number in range(count):
        copy = folder / "submitted" / f"s{number:03}" / "ps1" / f"{chapter}.ipynb"
        copy.parent.mkdir(parents=True)
        copy.write_text(notebook, encoding="utf-8")
    return folder


# The graders.


def nbgrader(folder: Path) -> list[object]:
    return [BIN / "nbgrader", "autograde", "ps1", f"--CourseDirectory.root={folder}", "--log-level=ERROR"]


def tflab(ours: Path, out: Path, jobs: int) -> list[object]:
    graded = [BIN / "tflab", "grade", ours / "submissions", "--pack", ours / "instructor", "--out", out]
    return [*graded, "--jobs", str(jobs)]


def time_of(commands: list[list[object]], count: int) -> float:
    """Return how many submissions a minute commands graded that ran side by side."""
    begin = time.monotonic()
    running = [
        subprocess.Popen(
            [str(word) for word in words], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, env=environment()
        )
        for words in commands
    ]
    for one in running:
        if one.wait():
            raise SystemExit(f"{one.args} failed")
    return 60 * count / (time.monotonic() - begin)


def environment() -> dict[str, str]:
    """Return ours, with the programs beside this Python found first."""
    return os.environ | {"PATH": f"{BIN}{os.pathsep}{os.environ.get('PATH', os.defpath)}"}


def marks_of_nbgrader(folders: list[Path]) -> set[str]:
    marks = set()
    for folder in folders:
        export = [BIN / "nbgrader", "export", f"--CourseDirectory.root={folder}", "--to=grades.csv"]
        subprocess.run(export, cwd=folder, check=True, capture_output=True, env=environment())
        with open(folder / "grades.csv", encoding="utf-8", newline="") as grades:
            marks |= {f"{float(row['score']):g}/{float(row['max_score']):g}" for row in csv.DictReader(grades)}
    return {f"nbgrader {mark}" for mark in marks}


def marks_of_tflab(out: Path) -> set[str]:
    results = json.loads((out / "results.json").read_text(encoding="utf-8"))
    return {f"tflab {one['points']:g}/{one['most']:g}" for one in results["submissions"]}


if __name__ == "__main__":
    raise SystemExit(main())
