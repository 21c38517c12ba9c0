"""What did a class really choose?  Counts by vote and option, in a CSV that a deck, a person or `tflab votes` fills.

    chapter              vote         option  text       expected  first  again
    11_tools_and_rviz    wheels-rate  3       50         45        13     2
                                              before anybody has argued -^      ^- after it

A folder of results may hold many (`votes.csv`, `votes-11.csv`): classes add up.  An
expected share is a guess until thirty have voted.
"""

from __future__ import annotations

import csv
import io
from collections import Counter
from collections.abc import Iterable, Mapping
from pathlib import Path

from .vote import Vote

__all__ = ["COLUMNS", "ENOUGH", "Counts", "read_counts", "share", "votes_csv"]

COLUMNS = ("chapter", "vote", "option", "text", "expected", "first", "again")
ENOUGH = 30  # voters, from whom on a share is one's own and no guess
MOST_BYTES = 4 * 1024 * 1024

Counts = dict[tuple[str, str], Counter[str]]


def votes_csv(votes: Iterable[Vote], counts: Counts | None = None) -> str:
    """Return the votes as CSV; the columns to fill are empty where nothing was counted."""
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\r\n")
    writer.writerow(COLUMNS)
    for vote in votes:
        counted = (counts or {}).get(vote.key)
        for option in vote.options:
            first = counted[option.label] if counted else ""
            writer.writerow([*vote.key, option.label, option.text, f"{option.expected:g}", first, ""])
    return "\ufeff" + out.getvalue()  # so that a spreadsheet reads Korean


def read_counts(folder: Path) -> tuple[Counts, list[str]]:
    """Return what was counted before anybody argued, in all `votes*.csv` of a folder, and a line for each bad row.

    Raises:
        FileNotFoundError: there is no such folder, or no such file in it.
    """
    files = sorted(folder.glob("votes*.csv"))
    if not files:
        raise FileNotFoundError(f"there is no votes.csv in {folder}; `tflab votes` or a deck's button writes one")
    counts: Counts = {}
    faults = []
    for path in files:
        rows = csv.DictReader(io.StringIO(_text(path)))
        missing = [name for name in ("chapter", "vote", "option", "first") if name not in (rows.fieldnames or ())]
        if missing:
            faults.append(f"{path.name}: no column {', '.join(missing)}; left out")
            continue
        for number, row in enumerate(rows, start=2):
            first = (row["first"] or "").strip()
            if first.isdecimal():
                counts.setdefault((row["chapter"] or "", row["vote"] or ""), Counter())[row["option"] or ""] += int(
                    first
                )
            elif first:
                faults.append(f'{path.name}, row {number}: "{first[:20]}" is no number of voters; left out')
    return counts, faults


def share(vote: Vote, counts: Mapping[tuple[str, str], Counter[str]]) -> tuple[dict[str, float], int]:
    """Return what share took each option [%], by label, and how many voted."""
    counted = counts.get(vote.key, Counter())
    voters = sum(counted[option.label] for option in vote.options)
    return {option.label: 100 * counted[option.label] / voters for option in vote.options if voters}, voters


def _text(path: Path) -> str:
    with path.open("rb") as file:
        data = file.read(MOST_BYTES)
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError:
        return data.decode("cp949", errors="replace")  # as a Korean spreadsheet saves it
