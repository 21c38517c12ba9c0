"""Each fault of a page is found before anything runs, with its line, its cell and what to do."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from tflab.workbook.pages.rules import page_faults

from .making_pages import TITLE, code, exercise, page, text

KO = '# %% [markdown] lang="ko" name="why"\n# 그래서입니다.\n'
EN = '# %% [markdown] lang="en" name="why"\n# Because.\n'
BROKEN = {
    "a cell without a name": ("# %%\nprint(1)\n", "this cell has no name"),
    "a name with a capital": (code("Look", "1"), "this is no name for a cell"),
    "two cells of one name": (code("look", "1") + code("look", "2"), "there is another cell of this name"),
    "code named as a text": (text("look", "a", "b") + code("look", "2"), "a code cell has this name, too"),
    "no Korean": (EN, "there is no Korean text"),
    "no English": (KO, "there is no English text"),
    "Korean elsewhere": (EN + code("between", "1") + KO, "the Korean text stands elsewhere"),
    "a text in no language": ('# %% [markdown] name="why"\n# Because.\n', "this text is in no language"),
    "an empty text": (text("why", "Because.", ""), "there is no text"),
    "code with a language": (code("look", "1", ' lang="en"'), "code has a language"),
    "16 lines of code": (code("long", "\n".join(["x = 1"] * 16)), "16 lines of code"),
    "headings of different depth": (
        text("why", "## Why\n### So", "## 왜\n## 아"),
        r"depths \[2, 2\], those of the English \[2, 3\]",
    ),
    "a depth left out": (text("why", "### Why", "### 왜"), "a heading of depth 3 comes after one of depth 1"),
    "two titles": (text("why", "# Why", "# 왜"), "this is a second title"),
    "an image without alt text": (text("why", "![](data:,)", "![그림](data:,)"), "an image has no alt text"),
    "an image of the network": (text("why", "![a](https://a.b/c.png)", "그림"), "an image comes from the network"),
    "a term nobody knows": (text("why", "[[wheel]]", "[[wheel]]"), '"wheel" is not in the glossary'),
    "a term in one language only": (text("why", "[[frame]]", "좌표계"), "only one language marks frame"),
    "an unknown tag": (code("look", "1", ' tags=["chek"]'), 'there is no tag "chek"'),
    "an unknown slide type": (code("look", "1", ' slide="sldie"'), 'there is no slide type "sldie"'),
    "an unknown option": (code("look", "1", ' tag="check"'), "there is no option tag"),
    "code as speaker's notes": (code("look", "1", ' slide="notes"'), "notes are code"),
    "nothing after an interactive cell": (code("turn", "1", ' tags=["interactive"]'), "no figure follows"),
    "a link into the other language": (
        text("why", "[go](../ko/03_x.ipynb)", "[가기](03_x.ipynb#why)"),
        "is in the other language",
    ),
    "a link to a page that is not there": (
        text("why", "[go](../../exercises/en/E03_x.ipynb)", "[가기](../../exercises/ko/E03_x.ipynb)"),
        "which will not be there",
    ),
    "a link to a file of the repository": (text("why", "[go](../../README.md)", "갑니다."), "which will not be there"),
}  # fmt: skip


@pytest.mark.parametrize("broken, wrong", BROKEN.values(), ids=BROKEN.keys())
def test_a_fault_is_found_and_named(tmp_path: Path, broken: str, wrong: str) -> None:
    faults = page_faults(page(tmp_path, TITLE, broken), {"frame"})
    assert faults
    for fault in faults:  # one for each language, at most
        assert re.search(wrong, fault.wrong), fault
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
    faults = page_faults(page(tmp_path, TITLE, *(broken for broken, _ in BROKEN.values())), {"frame"})
    assert len(faults) >= 20
    assert [fault.line for fault in faults] == sorted(fault.line for fault in faults)
