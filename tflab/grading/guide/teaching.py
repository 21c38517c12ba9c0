"""Read a chapter's teaching file: minutes, demonstrations, votes, answers and samples.

    solutions/teaching/11_tools_and_rviz.yaml
      brings      what learners bring, what is usually missing, a question that shows it
      plan        from which slide on, how many minutes, who talks, what to skip if late
      demos       a cell to run, what must be seen, what to show if it fails
      votes       questions to the class (below)
      questions   what a class asks, and an answer
      marking     of a practice question: a full, a half and a wrong sample
      ticket      what to do with each pile of exit tickets
      handover    the exercises that follow, and what to look for in class.html

A text stands as {en: ..., ko: ...}. All faults of a file's form are reported at once.

    - name: wheels-hz
      cell: predict            where the question stands; `item: 2` is its second one
      after: rates             the slide after which hands are raised; that of `cell` if left out
      answered: rates          where the page answers it, if later: until then it is only counted
      options:
        - {text: {en: "50", ko: "50번"}, expect: 45, say: {en: ..., ko: ...}}

Where the page replies to each option (a checkpoint), options stand there, and here only the
expected share of each, in their order. `quote` is how the page words it, if it is not the
text; `unsure: true` is the option of whoever does not know, which no page has to name.
Below 35 % right explain again, up to 70 % let neighbours argue and vote again, above that
go on (*Peer Instruction*, Mazur).
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import yaml

from tflab.text import LANGUAGES, Text, Texts, load_yaml
from tflab.workbook.paths import workbook_data

from .lecture import LecturedPage

__all__ = [
    "ARGUE_BELOW",
    "EXPLAIN_BELOW",
    "LATER",
    "RULES",
    "TEACHING",
    "Demo",
    "Marking",
    "PlanRow",
    "Sample",
    "Teaching",
    "TeachingError",
    "Vote",
    "VoteOption",
    "as_words",
    "read_teaching",
    "read_yaml",
    "said_once",
    "votes_of",
]

TEXTS = Texts(__file__)
TEACHING = Path("solutions", "teaching")
WHO = ("you", "room", "pairs", "each")

# Of each part what it must have, and what it may have.
PARTS: dict[str, tuple[set[str], set[str]]] = {
    "brings": ({"has", "lacks", "ask", "answer"}, set()),
    "plan": ({"minutes", "who", "do"}, {"slide", "lab", "late"}),
    "demos": ({"cell", "do", "see", "fails"}, {"types", "figure"}),
    "votes": ({"name", "cell", "options"}, {"item", "after", "answered", "options_in"}),
    "options": ({"expect"}, {"text", "quote", "right", "say", "unsure"}),
    "questions": ({"ask", "answer"}, set()),
    "marking": ({"question", "full", "half", "wrong", "because"}, {"half_has", "note"}),
    "ticket": ({"full", "half", "none"}, set()),
}
WHOLE = ({"brings", "plan", "demos", "votes", "questions", "ticket", "handover"}, {"marking"})


class TeachingError(Exception):
    """Teaching files that cannot be used as they are; `faults` says why, each with its place and a remedy."""

    def __init__(self, *faults: str) -> None:
        super().__init__("\n".join(faults))
        self.faults = faults


@dataclass(frozen=True)
class PlanRow:
    """Some minutes: from which slide on, or which tasks in the laboratory; who talks; what to skip if late."""

    minutes: int
    who: str
    do: Text
    slide: str = ""
    lab: tuple[str, ...] = ()
    late: Text | None = None


@dataclass(frozen=True)
class Demo:
    """What is shown live: the cell to run or the line to type, what must be seen, what to show if it fails."""

    cell: str
    do: Text
    see: Text
    fails: Text
    types: str = ""
    figure: str = ""


@dataclass(frozen=True)
class Sample:
    """An answer as a learner writes it, and how many of the rubric's ideas are in it."""

    words: Text
    ideas: tuple[int, ...] = ()


@dataclass(frozen=True)
class Marking:
    """How a practice question is marked: three samples, and the misconception behind the wrong one."""

    question: int
    full: Text
    half: Sample
    wrong: Text
    because: str
    note: Text | None = None


@dataclass(frozen=True)
class Teaching:
    """What one file says; `votes` is plain, as `vote.py` takes it."""

    stem: str
    path: str
    brings: Mapping[str, Text]
    plan: tuple[PlanRow, ...]
    demos: tuple[Demo, ...]
    votes: tuple[Mapping[str, Any], ...]
    questions: tuple[tuple[Text, Text], ...]
    markings: tuple[Marking, ...]
    ticket: Mapping[str, Text]
    handover: Text


def read_teaching(stem: str, data: Path | None = None) -> Teaching:
    """Return what a chapter's file says.

    Raises:
        FileNotFoundError: the chapter has none.
        TeachingError: something is missing, misspelt, or said in one language only.
    """
    path = (data or workbook_data()) / TEACHING / f"{stem}.yaml"
    shown = (TEACHING / path.name).as_posix()
    found = read_yaml(path, shown)
    faults = [*said_once(found, f"{shown}:"), *_shape_faults(found, shown)]
    if faults:
        raise TeachingError(*faults)
    return Teaching(
        stem,
        shown,
        {name: as_words(text) for name, text in found["brings"].items()},
        tuple(_row(row) for row in found["plan"]),
        tuple(_demo(row) for row in found["demos"]),
        tuple(found["votes"]),
        tuple((as_words(row["ask"]), as_words(row["answer"])) for row in found["questions"]),
        tuple(_marking(row) for row in found.get("marking", ())),
        {name: as_words(text) for name, text in found["ticket"].items()},
        as_words(found["handover"]),
    )


def read_yaml(path: Path, shown: str) -> dict[str, Any]:
    """Return what a YAML file holds.

    Raises:
        FileNotFoundError: there is none.
        TeachingError: it is no YAML, or holds something else than names and values.
    """
    try:
        found = load_yaml(path.read_text(encoding="utf-8"))
    except (yaml.YAMLError, UnicodeDecodeError) as error:
        raise TeachingError(f"{shown}: {' '.join(str(error).split())}; put the text into quotes") from None
    if not isinstance(found, dict):
        raise TeachingError(f"{shown}: it holds no names with values; begin with `brings:`")
    return found


def as_words(text: Mapping[str, str]) -> Text:
    """Return a text in both languages, each without the breaks of its lines."""
    return Text(*(" ".join(str(text[language]).split()) for language in LANGUAGES))


def said_once(found: Any, place: str) -> Iterator[str]:
    """Yield where a text stands in one language and not in the other."""
    if isinstance(found, dict):
        there = [language for language in LANGUAGES if str(found.get(language) or "").strip()]
        if set(found) & set(LANGUAGES) and len(there) < len(LANGUAGES):
            lacks = next(language for language in LANGUAGES if language not in there)
            yield f"{place}: {there[0] if there else 'en'} without {lacks}; say it in {lacks}, too"
    for name, value in _below(found):
        yield from said_once(value, f"{place} {name}")


def _below(found: Any) -> Iterator[tuple[Any, Any]]:
    """Yield what a value holds, each with its name, or its number where it has none."""
    if isinstance(found, dict):
        yield from found.items()
    elif isinstance(found, list):
        for number, value in enumerate(found, start=1):
            yield (value.get("name", number) if isinstance(value, dict) else number), value


def _shape_faults(found: Mapping[str, Any], shown: str) -> Iterator[str]:
    """Yield what is missing, and what nobody knows."""
    yield from _keys(found, WHOLE, f"{shown}:")
    for part, keys in PARTS.items():
        rows = found.get(part, [])
        for number, row in enumerate(rows if isinstance(rows, list) else [rows], start=1):
            place = f"{shown}: {part} {number}"
            yield from _keys(row, keys, place)
            if part == "votes" and isinstance(row, dict):
                for option in row.get("options", ()):
                    yield from _keys(option, PARTS["options"], f"{shown}: votes {row.get('name')}, options")
            if part == "plan" and isinstance(row, dict):
                yield from _row_faults(row, place)


def _row_faults(row: Mapping[str, Any], place: str) -> Iterator[str]:
    if row.get("who") not in WHO:
        yield f'{place}: nobody is called "{row.get("who")}"; there is {", ".join(WHO)}'
    if ("slide" in row) == ("lab" in row):
        yield f"{place}: it needs a `slide` to begin with, or a `lab`, and not both"


def _keys(row: Any, keys: tuple[set[str], set[str]], place: str) -> Iterator[str]:
    needed, allowed = keys
    if not isinstance(row, dict):
        yield f"{place} is no list of names and values; it needs {', '.join(sorted(needed))}"
        return
    for name in sorted(needed - set(row)):
        yield f"{place} lacks `{name}`; write it"
    for name in sorted(set(row) - needed - allowed):
        yield f"{place} has `{name}`, which means nothing; there is {', '.join(sorted(needed | allowed))}"


def _row(row: Mapping[str, Any]) -> PlanRow:
    late = as_words(row["late"]) if "late" in row else None
    return PlanRow(
        row["minutes"], row["who"], as_words(row["do"]), row.get("slide", ""), tuple(row.get("lab", ())), late
    )


def _demo(row: Mapping[str, Any]) -> Demo:
    said = (as_words(row[name]) for name in ("do", "see", "fails"))
    return Demo(row["cell"], *said, row.get("types", "").strip(), row.get("figure", ""))


def _marking(row: Mapping[str, Any]) -> Marking:
    half = Sample(as_words(row["half"]), tuple(row.get("half_has", ())))
    note = as_words(row["note"]) if "note" in row else None
    return Marking(row["question"], as_words(row["full"]), half, as_words(row["wrong"]), row["because"], note)


EXPLAIN_BELOW, ARGUE_BELOW = 35, 70  # percent of a room that are right
LATER = TEXTS["later"]
RULES = (TEXTS["explain"], TEXTS["argue"], TEXTS["go_on"])
UNSURE = TEXTS["unsure"]


@dataclass(frozen=True)
class VoteOption:
    """One option, in one language.

    Attributes:
        label: what is called out, and stands on the card that is raised.
        expected: the share that is expected to take it before anybody has argued [%].
        say: what to say to it, Markdown.
    """

    label: str
    text: str
    expected: float
    is_right: bool
    say: str


@dataclass(frozen=True)
class Vote:
    """A question to the room, in one language; it follows the cell `after`, and is answered at `answered`, if later.

    Attributes:
        asked: the cell of which the question is the whole text; none if it is a part of one.
    """

    stem: str
    name: str
    after: str
    question: str
    options: tuple[VoteOption, ...]
    answered: str = ""
    asked: str = ""


def votes_of(teaching: Teaching, page: LecturedPage) -> list[Vote]:
    """Return a chapter's votes in the order of the deck; the file fits the page (see `validate.py`)."""
    votes = [_vote(plain, teaching.stem, page) for plain in teaching.votes]
    return sorted(votes, key=lambda vote: page.shown.get(vote.after, 0))


def _vote(plain: Mapping[str, Any], stem: str, page: LecturedPage) -> Vote:
    cell = plain["cell"]
    choices = page.choices(cell) if "item" not in plain else []
    options = []
    for number, row in enumerate(plain["options"], start=1):
        said = as_words(row["say"]).say(page.language) if "say" in row else ""
        if row.get("unsure"):
            label, text = "?", UNSURE.say(page.language)
        elif "text" in row:
            label, text = str(number), as_words(row["text"]).say(page.language)
        else:
            label, text, reply = choices[number - 1]
            said = said or reply
        options.append(VoteOption(label, text, row["expect"], bool(row.get("right")), said))
    question = page.item(cell, plain["item"]) if "item" in plain else page.text(cell)
    asked = "" if "item" in plain else cell
    after, answered = plain.get("after", cell), plain.get("answered", "")
    return Vote(stem, plain["name"], after, question or "", tuple(options), answered, asked)
