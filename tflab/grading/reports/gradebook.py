"""Write grades as CSV in a learning system's columns, and as JSON with everything.

    grades.csv       learner, name, total, of, percent, E3.1, E3.2, ..., remarks
                     --lms canvas: Student, ID, ...        --lms moodle: ID number, Full name, Grade, ...
    results.json     the records: verdicts, probes, mistakes, seconds, remarks

A cell that a spreadsheet would take for a formula is made a text.  The same
submissions give the same grades.csv to the byte.
"""

from __future__ import annotations

import csv
import hashlib
import io
import json
import re
import unicodedata
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any

from ..submissions.remarks import Remark

__all__ = ["LMS", "file_name", "file_names", "grades_csv", "remarks_of", "results_json", "tasks_of", "verdicts_of"]

FORMULA = ("=", "+", "-", "@", "\t", "\r", "\n", "|", "%")
PARTED = re.compile(r"(;\s*|\S[\t\n\r]\s*)([=+\-@|%＝＋－＠｜％])")
Record = Mapping[str, Any]


def grades_csv(records: Sequence[Record], lms: str | None = None, assignment: str = "tflab") -> str:
    """Return the grades as a CSV file, with the columns of a learning system if one is named."""
    out = io.StringIO()
    rows = LMS[lms](records, assignment) if lms else _plain_rows(records)
    csv.writer(out, lineterminator="\r\n").writerows([_safe(cell) for cell in row] for row in rows)
    return "\ufeff" + out.getvalue()  # so that a spreadsheet reads Korean


def results_json(records: Sequence[Record], about: Mapping[str, Any]) -> str:
    """Return everything as JSON."""
    held = {**about, "submissions": list(records)}
    return json.dumps(held, ensure_ascii=False, indent=1, sort_keys=True) + "\n"


def tasks_of(records: Sequence[Record]) -> dict[str, str]:
    """Return every task that was graded, in order, with its chapter."""
    tasks = {
        task: stem for record in records for stem, chapter in record["chapters"].items() for task in chapter["tasks"]
    }
    return dict(sorted(tasks.items(), key=lambda pair: [int(number) for number in pair[0][1:].split(".")]))


def verdicts_of(record: Record) -> dict[str, dict[str, Any]]:
    """Return a record's verdicts by task."""
    return {task: row for chapter in record["chapters"].values() for task, row in chapter["tasks"].items()}


def remarks_of(record: Record) -> list[Remark]:
    """Return the remarks on a submission, except those on its tasks."""
    plain = [*record["remarks"], *(remark for chapter in record["chapters"].values() for remark in chapter["remarks"])]
    return [Remark.from_plain(remark) for remark in plain]


def file_name(learner: str) -> str:
    """Return a learner's id as the name of a file; if it cannot be one, with a part of its digest."""
    letters = "".join(letter if letter.isalnum() or letter in "._@-" else "_" for letter in learner)[:64].strip(".")
    return letters if letters and letters == learner else _with_digest(letters, learner)


def file_names(learners: Iterable[str]) -> dict[str, str]:
    """Return a file's name for each learner; of two that differ in their case only, one has a part of its digest."""
    names: dict[str, str] = {}
    taken: set[str] = set()
    for learner in sorted(learners):
        name = file_name(learner)
        names[learner] = _with_digest(name, learner) if name.casefold() in taken else name
        taken.add(name.casefold())
    return names


def _with_digest(letters: str, learner: str) -> str:
    return f"{letters}~{hashlib.sha256(learner.encode()).hexdigest()[:6]}"


def _plain_rows(records: Sequence[Record]) -> list[list[Any]]:
    tasks = tasks_of(records)
    rows: list[list[Any]] = [["learner", "name", "total", "of", "percent", *tasks, "remarks"]]
    for record in records:
        verdicts = verdicts_of(record)
        points = [_number(verdicts[task]["points"]) if task in verdicts else "" for task in tasks]
        remarks = " | ".join(remark.say("en") for remark in _all_remarks(record))
        percent = round(100 * record["points"] / record["most"], 1) if record["most"] else 0.0
        sums = [_number(record["points"]), _number(record["most"]), _number(percent)]
        rows.append([record["learner"], record["name"], *sums, *points, remarks])
    return rows


def _canvas_rows(records: Sequence[Record], assignment: str) -> list[list[Any]]:
    most = max((record["most"] for record in records), default=0.0)
    rows: list[list[Any]] = [["Student", "ID", "SIS User ID", "SIS Login ID", "Section", assignment]]
    rows.append(["    Points Possible", "", "", "", "", _number(most)])
    for record in records:
        learner = record["learner"]
        rows.append([record["name"] or learner, "", learner, learner, "", _number(record["points"])])
    return rows


def _moodle_rows(records: Sequence[Record], assignment: str) -> list[list[Any]]:
    rows: list[list[Any]] = [["ID number", "Full name", "Grade", "Maximum Grade", "Feedback comments"]]
    for record in records:
        words = "; ".join(
            f"{task} {_number(row['points'])}/{_number(row['most'])}" for task, row in verdicts_of(record).items()
        )
        rows.append([record["learner"], record["name"], _number(record["points"]), _number(record["most"]), words])
    return rows


LMS: dict[str, Callable[[Sequence[Record], str], list[list[Any]]]] = {"canvas": _canvas_rows, "moodle": _moodle_rows}


def _all_remarks(record: Record) -> list[Remark]:
    of_tasks = [Remark.from_plain(remark) for row in verdicts_of(record).values() for remark in row["remarks"]]
    heard = [*remarks_of(record), *(remark for remark in of_tasks if remark.kind != "unanswered")]
    return list({remark.say("en"): remark for remark in heard}.values())


def _number(value: float) -> str:
    return f"{value:.3f}".rstrip("0").rstrip(".")


def _safe(cell: Any) -> Any:
    """Return a cell that no spreadsheet computes, also one that parts columns at semicolons or knows wide letters."""
    text = PARTED.sub(r"\1'\2", str(cell).replace("\0", ""))
    return f"'{text}" if unicodedata.normalize("NFKC", text).lstrip(" ").startswith(FORMULA) else text
