"""Does a learner's folder tell what only a teacher, a solution or the key may tell?  Every file of it is searched."""

from __future__ import annotations

import base64
import json
import re
import zlib
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Any

import pytest
import yaml

from tflab.grading.judging.pack import learners_cases
from tflab.workbook.answers.sealed import is_sealed
from tflab.workbook.copy.lay_out import lay_out
from tflab.workbook.places import workbook_data
from tflab.workbook.tasks.blank import BEGIN, regions
from tflab.workbook.tasks.cases import read_cases

DATA = workbook_data()
PICTURES = ("image/png", "image/webp")  # no sentence is in their bytes
SENTENCE = re.compile(r"(?<=[.?!])\s+|\n")
SHORTEST = 24  # letters; what is shorter is said by anybody
ON_THE_SCREEN = (
    "said",
    "check",
    "command",
    "text",
    "cause",
    "cell",
    "slide",
    "show",
)  # of a teaching file: what all see


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
    for path in sorted(path for path in folder.rglob("*") if path.is_file()):
        text = path.read_text(encoding="utf-8")
        parsed = json.loads(text) if path.suffix in (".ipynb", ".json") else [text]
        found += [path.name, *texts_in(parsed, *PICTURES)]
    return plain("\n".join(found))


def sentences(texts: Iterator[str]) -> set[str]:
    parts = {plain(part) for text in texts for part in SENTENCE.split(text)}
    return {part for part in parts if len(part) >= SHORTEST and part.endswith((".", "?", "!"))}


@cache
def cells_of_pages() -> tuple[dict[str, Any], ...]:
    pages = [json.loads(path.read_text(encoding="utf-8")) for path in sorted((DATA / "notebooks").glob("*/*.ipynb"))]
    return tuple(cell for page in pages for cell in page["cells"])


@cache
def said_to_all() -> str:
    """Return what the pages say to their readers, and `check` to whoever answers."""
    tasks = [read_cases(path)["tasks"] for path in sorted((DATA / "exercises" / "cases").glob("*.json"))]
    words = [[task["twins"], task["hints"]] for chapter in tasks for task in chapter.values()]
    return plain("\n".join([*("".join(cell["source"]) for cell in cells_of_pages()), *texts_in(words)]))


def not_on_a_page(said: set[str]) -> set[str]:
    """Return the sentences that no page and no reply says, too."""
    prose = said_to_all()
    return {line for line in said if line not in prose}


def notes() -> set[str]:
    """Return what the pages say to the speaker alone."""
    said = (cell["metadata"].get("tflab", {}).get("notes", "") for cell in cells_of_pages())
    return not_on_a_page(sentences(said))


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
def of_a_class(tmp_path_factory: pytest.TempPathFactory) -> str:
    """All that a learner of a class is given, in both languages."""
    paths = sorted((DATA / "exercises" / "cases").glob("*.json"))
    cases = {path.stem: learners_cases(read_cases(path), None, None) for path in paths}
    folder = tmp_path_factory.mktemp("class") / "copy"
    for language in ("en", "ko"):
        lay_out(folder, language, edition="class", cases=cases)
    return all_below(folder)


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
    assert [line for line in sorted(said) if line in of_a_class] == []
    assert any(line in own for line in said)  # and the search would find it


@pytest.mark.parametrize("copy", ["of_a_class", "own"])
def test_no_copy_holds_a_sentence_of_a_teaching_file(copy: str, request: pytest.FixtureRequest) -> None:
    said = teaching() - notes()
    assert len(said) > 1000
    text = request.getfixturevalue(copy)
    assert [line for line in sorted(said) if line in text] == []


@pytest.mark.parametrize("copy", ["of_a_class", "own"])
def test_no_copy_holds_what_was_taken_out_of_a_solution(copy: str, request: pytest.FixtureRequest) -> None:
    text = request.getfixturevalue(copy)
    taken_out = marked_regions()
    assert len(taken_out) > 50
    assert [region for region in sorted(taken_out) if region in text] == []
    assert BEGIN not in text


@pytest.mark.parametrize("copy", ["of_a_class", "own"])
def test_no_copy_says_why_an_option_of_the_test_is_right_or_wrong(copy: str, request: pytest.FixtureRequest) -> None:
    said = reasons()
    assert len(said) > 100
    assert [line for line in sorted(said) if line in request.getfixturevalue(copy)] == []


def tasks_as_handed_out() -> Iterator[tuple[str, dict, dict]]:
    """Yield each task, as tflab has it and as a learner of a class is given it."""
    for path in sorted((DATA / "exercises" / "cases").glob("*.json")):
        ours = read_cases(path)
        theirs = learners_cases(ours, None, None)
        yield from ((task, ours["tasks"][task], theirs["tasks"][task]) for task in ours["tasks"])


def test_no_value_that_is_asked_for_can_be_read_off_the_cases_of_a_class() -> None:
    values = [(task, theirs) for task, _, theirs in tasks_as_handed_out() if not theirs["is_function"]]
    open_ones = [
        task for task, held in values for case in held["variants"][0]["cases"] if not is_sealed(case["expected"])
    ]
    assert len(values) > 40
    assert open_ones == []


def test_no_patient_that_is_handed_out_names_its_cause() -> None:
    ours, theirs = next((ours, theirs) for task, ours, theirs in tasks_as_handed_out() if task == "E12.4")
    patients = theirs["variants"][0]["given"]
    truth = ours["variants"][0]["cases"][0]["expected"]["dict"]
    assert len(patients) == 3
    for letter, packed in patients.items():
        word = next(iter(packed.values()))
        told = zlib.decompress(base64.b85decode(word)).decode()
        assert len(told) > 1000
        assert truth[f"{letter} cause"] not in told
