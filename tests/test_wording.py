"""Words to avoid do not come back into what people read: pages, exercises, replies, tools, README and docs."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
import yaml

ROOT = Path(__file__).parents[1]
WORDS = yaml.safe_load((ROOT / "tests" / "wording.yaml").read_text(encoding="utf-8"))
PAGES = [path for folder in ("notebooks/src", "solutions/src") for path in sorted((ROOT / folder).glob("*.py"))]
GUIDES = [ROOT / "CHANGELOG.md", *sorted(ROOT.glob("README*.md")), *sorted((ROOT / "docs").glob("*.md"))]
TEXTS = [path for folder in ("solutions", "tflab") for path in sorted((ROOT / folder).rglob("*.yaml"))]
TEXTS.remove(ROOT / "solutions" / "inventory.yaml")  # the test before and after the course, which is in everyday words
CELL = re.compile(r"(?m)^# %%.*$")
EVERYDAY = re.compile(r'name="question')  # the test before and after the course, which is in everyday words
BLANK = re.compile(r"\{\w+\}")
FENCED = re.compile(r"```.*?```", re.DOTALL)
CODE = {"en": re.compile(r"`[^`]*`"), "ko": re.compile("(?!)")}  # a Korean particle is judged by the code before it


def prose_of(path: Path, language: str) -> str:
    """Return what a reader of one language reads in a page source, without code."""
    text = path.read_text(encoding="utf-8")
    heads = [*CELL.finditer(text)]
    ends = [head.start() for head in heads[1:]] + [len(text)]
    cells = [
        re.sub(r"(?m)^# ?", "", text[head.end() : end])
        for head, end in zip(heads, ends, strict=True)
        if f'lang="{language}"' in head[0] and not EVERYDAY.search(head[0])
    ]
    return CODE[language].sub("", FENCED.sub("", "\n".join(cells)))


def sentences_in(data: Any, language: str) -> Iterator[str]:
    """Yield each text of a language in the data of a YAML file."""
    for key, value in data.items() if isinstance(data, dict) else enumerate(data if isinstance(data, list) else ()):
        if key == language and isinstance(value, str):
            yield BLANK.sub("", value)
        yield from sentences_in(value, language)


def what_people_read(language: str) -> Iterator[tuple[str, str]]:
    """Yield the name and the prose of each file."""
    for path in PAGES:
        yield path.name, prose_of(path, language)
    for path in GUIDES:
        if path.name.endswith(".ko.md") == (language == "ko"):
            yield path.name, CODE[language].sub("", FENCED.sub("", path.read_text(encoding="utf-8")))
    for path in TEXTS:
        texts = sentences_in(yaml.load(path.read_text(encoding="utf-8"), yaml.CSafeLoader), language)
        yield path.name, CODE[language].sub("", "\n".join(texts))


@pytest.mark.parametrize("language", sorted(WORDS))
def test_no_word_to_avoid_is_in_what_people_read(language: str) -> None:
    found = []
    for name, text in what_people_read(language):
        for row in WORDS[language]:
            for match in re.finditer(row["find"], text, re.IGNORECASE if language == "en" else 0):
                around = re.sub(r"\s+", " ", text[max(0, match.start() - 40) : match.end() + 40])
                if not any(phrase in around for phrase in row.get("allow", ())):
                    found.append(f"{name}: …{around}… write: {row['use']}")
    assert not found, "\n".join(found)
