"""The Korean of the pages has no expression that a Korean reader would take otherwise."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from tflab.workbook.pages.source import read_page
from tflab.workbook.paths import workbook_data

NEVER = {
    "the wanted side is the source, to a Korean ear": r"쪽이 먼저|쪽을 먼저|보고 싶은 쪽|보려는 쪽",
    "asked at that second: when the asking happens": r"초에 [^.]{0,40}(묻|물)",
    "in front or behind is space; time is earlier or later": r"표본보다 (앞|뒤)|시각보다 (앞|뒤)",
    "a stamp ahead is earlier in Korean": r"(시각|변환|측정)(이|은|보다)? [^.]{0,12}앞[서선섰섬]",
    "in, as inside of": r"안 어디|(\b[ab]|_link`?|map`?|odom`?) 안에서",
    "a lane of traffic": r"차선",
    "an edge of a graph on paper": r"간선",
    "a clock on a wall": r"벽시계",
    "no Korean word": r"오류문",
    "beside the target frame, another target": r"목표점",
    "a visible space before a particle": r"\*\* (은|는|이|가|을|를|의|입니다)\b",
    "things do not complain": r"불평|항의합",
    "data are moved to a frame, not put there": r"(?<!내)놓을 수 (있습|있을|없습)",
    "a fixed frame that jumps": r"(odom|map).{0,30}고정 좌표계",
    "one word for a chain, and one for a costmap": r"체인|비용지도",
    "one form for minutes": r"\d분쯤 걸",
    "the particle after map": r"map`로 ",
}
OF_ANSWERS = [
    "습관",
    "오류 문구",
    "대기 한도",
    "물어본 시각",
    "물은 것",
    "부른 (쪽|곳)",
    "네 숫자",
    "숫자 (셋|넷)[은이을]",
]
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
