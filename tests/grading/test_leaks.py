"""A learner's folder holds nothing of a teacher's files, solutions or keys: every file of it is searched."""

from __future__ import annotations

import base64
import json
import re
import zlib
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

import pytest
import yaml

from tflab.grading import release as releasing
from tflab.grading.submissions.roster import Learner
from tflab.workbook.answers.values import is_raised
from tflab.workbook.copy.lay_out import lay_out
from tflab.workbook.paths import Workbook, chapters, read_workbook, workbook_data
from tflab.workbook.tasks.catalog import assigned_cases, outlines, task_ids
from tflab.workbook.tasks.strip_solution import BEGIN, regions

from . import tiny

DATA = workbook_data()
NUMBERS, PATIENTS = "03_target_and_source", "12_owners_and_diagnosis"
PICTURES = ("image/png", "image/webp")  # no sentence is in their bytes
SENTENCE = re.compile(r"(?<=[.?!])\s+|\n")
SHORTEST = 24  # letters; what is shorter is said by anybody
# Of a teaching file: what all see.
ON_THE_SCREEN = ["said", "check", "command", "text", "cause", "cell", "slide", "show"]


def texts_in(held: Any, *leaving: str) -> Iterator[str]:
    """Yield every text in JSON or YAML, the lines of a notebook's cell as one."""
    if isinstance(held, str):
        yield held
    elif isinstance(held, dict):
        for name, inner in held.items():
            if name not in leaving:
                yield from texts_in(inner, *leaving)
    elif isinstance(held, list):
        if held and all(isinstance(line, str) for line in held):
            yield "".join(held)
        for inner in held:
            yield from texts_in(inner, *leaving)


def plain(text: str) -> str:
    return re.sub(r"\s+", " ", text).strip()


def all_below(folder: Path) -> str:
    """Return every text in every file of a folder, hidden ones, too."""
    found = []
    for name, content in tiny.files_below(folder).items():
        text = content.decode()
        parsed = json.loads(text) if Path(name).suffix in (".ipynb", ".json") else [text]
        found += [Path(name).name, *texts_in(parsed, *PICTURES)]
    return plain("\n".join(found))


def sentences(texts: Iterator[str]) -> set[str]:
    parts = {plain(part) for text in texts for part in SENTENCE.split(text)}
    return {part for part in parts if len(part) >= SHORTEST and part.endswith((".", "?", "!"))}


def leaked(lines: set[str], text: str) -> list[str]:
    """Return the lines that are in a text. Most are ruled out by three of their words, which is much faster."""
    words = text.split()
    there = set(zip(words, words[1:], words[2:], strict=False))
    split = {line: line.split() for line in lines}
    likely = (line for line, own in split.items() if len(own) < 5 or tuple(own[1:4]) in there)
    return sorted(line for line in likely if line in text)


@cache
def cells_of_pages() -> tuple[dict[str, Any], ...]:
    pages = [json.loads(path.read_text(encoding="utf-8")) for path in sorted((DATA / "notebooks").glob("*/*.ipynb"))]
    return tuple(cell for page in pages for cell in page["cells"])


@cache
def said_to_all() -> str:
    """Return what the pages say to their readers, and `check` to whoever answers."""
    tasks = [task.plain() for stem in chapters() for task in outlines(DATA, stem).values()]
    words = [[task["feedback"], task["hints"]] for task in tasks]
    return plain("\n".join([*("".join(cell["source"]) for cell in cells_of_pages()), *texts_in(words)]))


def not_on_a_page(said: set[str]) -> set[str]:
    """Return the sentences that no page and no reply says, too."""
    prose = said_to_all()
    return {line for line in said if line not in prose}


@cache
def notes() -> set[str]:
    """Return what the pages say to the speaker alone."""
    said = (cell["metadata"].get("tflab", {}).get("notes", "") for cell in cells_of_pages())
    return not_on_a_page(sentences(said))


@cache
def teaching() -> set[str]:
    """Return what the teaching files alone say, the patients' truths among it."""
    files = sorted((DATA / "solutions" / "teaching").rglob("*.yaml"))
    held = [yaml.safe_load(path.read_text(encoding="utf-8")) for path in files]
    return not_on_a_page(sentences(text for one in held for text in texts_in(one, *ON_THE_SCREEN)))


def reasons() -> set[str]:
    """Return what the test of before and after says of each option once both are in: the key, in words."""
    items = yaml.safe_load((DATA / "solutions" / "inventory.yaml").read_text(encoding="utf-8"))["items"]
    options = (option for item in items for form in ("A", "B") for option in item[form].values())
    return sentences(text for option in options if isinstance(option, dict) for text in texts_in(option.get("why")))


@cache
def replies() -> set[str]:
    """Return what the task files say of mistakes, options and parts, and neither a page nor a question does."""
    files = [yaml.safe_load(path.read_text(encoding="utf-8")) for path in (DATA / "solutions").glob("tasks/*/*.yaml")]
    questions = "\n".join(path.read_text(encoding="utf-8") for path in (DATA / "solutions" / "src").glob("*.py"))
    printed = plain("\n".join([*texts_in(list(cells_of_pages()), *PICTURES), re.sub("^# ", "", questions, flags=re.M)]))
    return {line for line in sentences(texts_in(files, "title", "hints", "equivalent")) if line not in printed}


def marked_regions() -> set[str]:
    """Return what is taken out of the solutions, of more than a line or a long one, and is on no page."""
    pages = plain("\n".join(path.read_text(encoding="utf-8") for path in (DATA / "notebooks" / "src").glob("*.py")))
    found = set()
    for path in (DATA / "solutions" / "src").glob("*.py"):
        for cell in re.split(r"^# %%.*$", path.read_text(encoding="utf-8"), flags=re.MULTILINE):
            lines = cell.splitlines()
            for begin, end in regions(cell) if BEGIN in cell else ():
                found.add(plain("\n".join(lines[begin : end - 1])))
    return {region for region in found if len(region) > SHORTEST and region not in pages}


@pytest.fixture(scope="module")
def class_copies(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folders of two learners of a class, one in each language, with all chapters."""

    def questions_asked(stems: Sequence[str], *_: object, **__: object) -> dict[str, dict[str, list[str]]]:
        """Name nothing by digests: to compute what all chapters ask takes minutes, and no text depends on it."""
        return {stem: {task: ["0"] for task in task_ids(DATA, stem)} for stem in stems}

    folder = tmp_path_factory.mktemp("class") / "release"
    with pytest.MonkeyPatch.context() as fixed:
        fixed.setattr(releasing, "questions_asked", questions_asked)
        fixed.setattr(releasing, "_lay_out_guide", lambda *_: None)
        fixed.setattr(releasing.secrets, "token_hex", lambda count: ("5a17" * count)[: 2 * count])
        releasing.release(folder, chapters(), [Learner("s101"), Learner("s102", language="ko")])
    return folder / "learners"


@pytest.fixture(scope="module")
def of_a_class(class_copies: Path) -> str:
    """All that learners of a class are given, in both languages."""
    return all_below(class_copies)


@pytest.fixture(scope="module")
def own(tmp_path_factory: pytest.TempPathFactory) -> str:
    """All that is in the copy of somebody who learns alone."""
    folder = tmp_path_factory.mktemp("own") / "copy"
    for language in ("en", "ko"):
        lay_out(folder, language)
    return all_below(folder)


def test_a_class_reads_nothing_that_is_for_the_speaker(of_a_class: str, own: str) -> None:
    said = notes()
    assert len(said) > 40
    assert leaked(said, of_a_class) == []
    assert any(line in own for line in said)  # and the search would find it


@pytest.mark.parametrize("copy", ["of_a_class", "own"])
@pytest.mark.parametrize(
    ("of", "fewest"),
    [(lambda: teaching() - notes(), 1000), (reasons, 100), (replies, 5000)],
    ids=["a teaching file", "why an option of the test is right or wrong", "the reply to a mistake"],
)
def test_no_copy_holds_a_sentence(copy: str, of: Callable, fewest: int, request: pytest.FixtureRequest) -> None:
    said = of()
    assert len(said) > fewest
    assert leaked(said, request.getfixturevalue(copy)) == []


@pytest.mark.parametrize("copy", ["of_a_class", "own"])
def test_no_copy_holds_cases_or_what_was_taken_out_of_a_solution(copy: str, request: pytest.FixtureRequest) -> None:
    text = request.getfixturevalue(copy)
    assert "E03_target_and_source.ipynb" in text
    assert [name for name in ('"expected"', '"feedback"', '"cases"', "/cases/", BEGIN) if name in text] == []
    taken_out = marked_regions()
    assert len(taken_out) > 50
    assert [region for region in sorted(taken_out) if region in text] == []


def test_a_class_copy_holds_exercises_and_pages_and_no_other_file(class_copies: Path) -> None:
    expected = re.compile(r"(\.tflab/pristine\.zip/)?(exercises|notebooks)/en/\S+\.ipynb")
    other = {name for name in tiny.files_below(class_copies / "s101") if not expected.fullmatch(name)}
    assert other == {"workbook.json", ".tflab/lock"}


def test_no_number_that_is_asked_for_is_in_a_class_copy(class_copies: Path) -> None:
    workbook, text = read_workbook(class_copies / "s101"), all_below(class_copies / "s101")
    assert (workbook.edition, workbook.learner) == ("class", "s101") and workbook.seed
    workbook = replace(workbook, questions={})  # the fixture stored no real digests to compare with
    tasks = [assigned_cases(DATA, NUMBERS, task, workbook) for task in task_ids(DATA, NUMBERS)]
    expected = [case.expected for task in tasks for case in task.variants[0].cases if not is_raised(case.expected)]
    found = {number for one in expected for number in numbers_in(one) if round(number, 2) != number}
    assert len(found) > 20
    assert [number for number in sorted(found) if f"{abs(number):.7f}"[:-1] in text] == []


def numbers_in(plain: Any) -> Iterator[float]:
    """Yield every float in JSON."""
    if isinstance(plain, float):
        yield plain
    for inner in plain.values() if isinstance(plain, dict) else plain if isinstance(plain, list) else ():
        yield from numbers_in(inner)


def test_no_patient_that_a_task_gives_names_its_cause() -> None:
    (variant,) = assigned_cases(DATA, PATIENTS, "E12.4", Workbook()).variants
    truth = variant.cases[0].expected["dict"]
    assert len(variant.given) == 3
    for letter, packed in variant.given.items():
        word = next(iter(packed.values()))
        told = zlib.decompress(base64.b85decode(word)).decode()
        assert len(told) > 1000
        assert truth[f"{letter} cause"] not in told
