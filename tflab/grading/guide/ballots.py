"""What did learners vote in their own copies?  `tflab votes DIR`: names that were set, read and never run.

    late_s, wheels_hz = 0.11, 50      the cell `my-guess` of a page, or any other cell of it
    checkpoint = 2                    as the deck asks for it: {"late_s": 0.11, "wheels_hz": 50, "checkpoint": 2}

A copy is a stranger's file: it is parsed, and only plain values count.
"""

from __future__ import annotations

import argparse
import ast
import sys
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path

from tflab.text import LANGUAGES
from tflab.workbook.atomic_files import write_whole

from ..submissions.listing import few_of_each, is_notebook, listed
from ..submissions.reader import SubmittedNotebook, Unreadable, read_notebook
from ..submissions.remarks import printable
from .counts import Counts, share, votes_csv
from .lecture import lectured_page
from .shelf import teachings_called
from .teaching import TeachingError
from .vote import Vote, matches, votes_of

__all__ = ["ballots", "main", "values_set"]

LONGEST = 200  # characters of a value that may be an option
MAGIC = ("%", "!", "?")  # how a line begins that is not Python


def main(words: Sequence[str]) -> int:
    """Count, and return 0; 1 if a file could not be read, 2 if there was nothing to count."""
    options = _options(words)
    try:
        teachings = teachings_called(options.chapters)
        votes = [vote for one in teachings for vote in votes_of(one, lectured_page(one.stem, options.lang))]
        counts, unread = ballots(Path(options.folder), votes)
    except (LookupError, TeachingError, Unreadable) as error:
        print(f"tflab votes: {error}", file=sys.stderr)
        return 2
    for line in unread:
        print(f"tflab votes: {line}", file=sys.stderr)
    voted = [vote for vote in votes if sum(counts.get(vote.key, Counter()).values())]
    if not voted:
        print(f"tflab votes: nobody in {options.folder} has voted; a page's predictions are votes", file=sys.stderr)
        return 2
    for vote in voted:
        shares, voters = share(vote, counts)
        said = " · ".join(f"{option.label} {shares[option.label]:.0f} %" for option in vote.options)
        print(f"{vote.stem[:2]} {vote.name}: {said} ({voters})")
    write_whole(Path(options.out), votes_csv(voted, counts))
    print(options.out)
    return 1 if unread else 0


def ballots(folder: Path, votes: Sequence[Vote]) -> tuple[Counts, list[str]]:
    """Return how many learners' copies, in a folder or a zip, chose each option, and a line for what was not read.

    A learner is a folder (or a file); who has a page in two languages votes once.

    Raises:
        Unreadable: there is no such folder.
    """
    members, remarks = listed(folder, set())
    unread = [remark.say("en") for remark in remarks]
    names = {vote.stem for vote in votes}
    chosen: dict[tuple[str, str, str], str] = {}
    for member in few_of_each(members):
        stem = member.parts[-1].partition(".")[0]
        if not is_notebook(member) or stem not in names:
            continue
        learner = "" if member.parts[0] == "notebooks" else member.parts[0]  # the folder is one copy, or holds many
        try:
            written = values_set(read_notebook(member.read()))
        except Unreadable as error:
            unread.append(f"{printable('/'.join(member.parts))}: {error}")
            continue
        for vote in (vote for vote in votes if vote.stem == stem):
            label = _chosen(vote, written)
            if label is not None:
                chosen.setdefault((learner, *vote.key), label)
    counts: Counts = {}
    for (_, stem, name), label in chosen.items():
        counts.setdefault((stem, name), Counter())[label] += 1
    return counts, unread


def _chosen(vote: Vote, written: Mapping[str, object]) -> str | None:
    """Return the option that a learner wrote down, by its label; None if there is none."""
    value = written.get(vote.answer)
    return next((option.label for option in vote.options if value is not None and matches(option, value)), None)


def values_set(notebook: SubmittedNotebook) -> dict[str, object]:
    """Return the plain values that a notebook's cells give to names; the last one counts."""
    found: dict[str, object] = {}
    for cell in notebook.cells:
        if cell.kind == "code":
            found.update(_set_in(cell.source))
    return found


def _set_in(source: str) -> Iterator[tuple[str, object]]:
    lines = ("" if line.lstrip().startswith(MAGIC) else line for line in source.splitlines())
    try:
        statements = ast.parse("\n".join(lines)).body
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return
    for statement in statements:
        if not isinstance(statement, ast.Assign):
            continue
        for target in statement.targets:
            yield from _pairs(target, statement.value)


def _pairs(target: ast.expr, value: ast.expr) -> Iterator[tuple[str, object]]:
    if isinstance(target, ast.Tuple) and isinstance(value, ast.Tuple) and len(target.elts) == len(value.elts):
        for name, one in zip(target.elts, value.elts, strict=True):
            yield from _pairs(name, one)
    elif isinstance(target, ast.Name):
        if (
            isinstance(value, ast.UnaryOp)
            and isinstance(value.op, ast.USub)
            and isinstance(value.operand, ast.Constant)
        ):
            yield target.id, f"-{value.operand.value}"
        elif isinstance(value, ast.Constant) and value.value is not ... and len(str(value.value)) <= LONGEST:
            yield target.id, value.value


def _options(words: Sequence[str]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="tflab votes", description="Count what learners voted in their own copies.")
    parser.add_argument("folder", metavar="DIR", help="a folder or a zip with learners' copies")
    parser.add_argument("--chapters", nargs="*", default=[], metavar="11", help="all that have votes if left out")
    parser.add_argument("--lang", choices=LANGUAGES, default="en", help="of the options in the file; %(default)s")
    parser.add_argument("--out", default="votes.csv", metavar="FILE", help="%(default)s if left out")
    return parser.parse_args(list(words))
