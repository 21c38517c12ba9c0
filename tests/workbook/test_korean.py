"""The Korean of the pages has no expression that a Korean reader would take otherwise."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
import yaml

from tflab.workbook.pages.source import read_page
from tflab.workbook.paths import workbook_data

NEVER, OF_ANSWERS = yaml.safe_load(Path(__file__).with_suffix(".yaml").read_text(encoding="utf-8")).values()
SECTIONS = r"^## (확인 문제|나가기 전에|풀이 예제|기억할 것|이것만은|해 보기|예측하기|망가뜨리기)"
THREADS = r"(?i)\bissue \d+|\w #\d+|이슈 \d+(?!\d|\]\()"
PAGES = sorted(path.stem for path in (workbook_data() / "notebooks" / "src").glob("*.py"))


@pytest.mark.parametrize("stem", PAGES)
def test_a_page_has_no_sentence_that_is_heard_otherwise_and_its_sections_have_one_name(stem: str) -> None:
    page = read_page(workbook_data() / "notebooks" / "src" / f"{stem}.py")
    texts = {cell.name: cell.source for cell in page.cells if cell.lang == "ko"}
    never = {**NEVER, "one kind of section has one name": SECTIONS, "a thread is linked in one form": THREADS}
    found = [
        (name, why) for name, text in texts.items() for why, words in never.items() if re.search(words, text, re.M)
    ]
    assert found == []
    if "01" <= stem[:2] <= "12":
        able = re.findall(r"^- (.+)$", texts["title"].partition("이 장을 마치면\n")[2], re.MULTILINE)
        assert 3 <= len(able) <= 6
        assert [line for line in able if not re.search("수 있습니다|않게 됩니다", line)] == []


def test_what_is_said_of_answers_and_beside_the_pages_is_heard_as_it_is_meant() -> None:
    root, never = Path(__file__).parents[2], re.compile("|".join([*NEVER.values(), *OF_ANSWERS]))
    texts = ("src/*.py", "tasks/*/*.py", "tasks/*/*.yaml", "teaching/*.yaml")
    paths = [path for pattern in texts for path in (workbook_data() / "solutions").glob(pattern)]
    paths += [root / "README.ko.md", *root.glob("docs/*.ko.md")]
    paths += [path for ending in ("md", "py", "yaml", "html") for path in root.glob(f"tflab/**/*.{ending}")]
    lines = [(path, line) for path in paths for line in path.read_text(encoding="utf-8").splitlines()]
    assert [f"{path.name}: {line.strip()}" for path, line in lines if never.search(line)] == []
