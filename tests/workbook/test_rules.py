"""Each fault of a page is found before anything runs, with its line, its cell and what to do."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
import yaml

from tflab.workbook.pages.rules import page_faults

from .making_pages import TITLE, code, exercise, page, text

BROKEN = yaml.safe_load(Path(__file__).with_suffix(".yaml").read_text(encoding="utf-8"))


@pytest.mark.parametrize("broken", BROKEN.values(), ids=BROKEN.keys())
def test_a_fault_is_found_and_named(tmp_path: Path, broken: dict[str, str]) -> None:
    faults = page_faults(page(tmp_path, TITLE, broken["page"]), {"frame"})
    assert faults
    for fault in faults:  # one for each language, at most
        assert re.search(broken["wrong"], fault.wrong), fault
        assert fault.line > TITLE.count("\n")
        assert str(fault).startswith(f"notebooks/src/03_x.py:{fault.line}: ")
        assert str(fault).endswith(f"; {fault.remedy}")


def test_a_page_without_a_title_is_said_for_each_language(tmp_path: Path) -> None:
    faults = page_faults(page(tmp_path, text("why", "Because.", "그래서입니다.")), set())
    assert [fault.wrong for fault in faults] == ["there is no title in English", "there is no title in Korean"]


def test_a_good_page_has_no_faults(tmp_path: Path) -> None:
    good = page(
        tmp_path,
        TITLE,
        text("why", "## Why\n[[frame]] ![alt](data:,)", "## 왜\n[[frame|그 좌표계]] ![설명](data:,)", ' slide="slide"'),
        text("why-notes", "Wait.", "기다립니다.", ' slide="notes"'),
        text("code", "```bash\n# no heading\n[[ -f x ]]\n```\n`[[x]]`", "```bash\n# no heading\n```", ""),
        code("long", "\n".join(["x = 1"] * 15)),
        code("turn", "x", ' tags=["interactive"]'),
        code("still", "x"),
        text("go", "[go](../../exercises/en/E03_x.ipynb)", "[가기](../../exercises/ko/E03_x.ipynb)"),
        text("rep", "[[frame]] [REP](https://ros.org/reps) [up](#why)", "[REP](https://ros.org/reps) [[frame|틀]](, )"),
    )
    exercise(tmp_path)
    assert page_faults(good, {"frame"}) == []


def test_all_faults_are_found_at_once_in_the_order_of_their_lines(tmp_path: Path) -> None:
    faults = page_faults(page(tmp_path, TITLE, *(broken["page"] for broken in BROKEN.values())), {"frame"})
    assert len(faults) >= 20
    assert [fault.line for fault in faults] == sorted(fault.line for fault in faults)
