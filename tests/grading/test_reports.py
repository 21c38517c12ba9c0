"""The table and the pages say what the records hold, and never more than they may."""

from __future__ import annotations

import csv
import io
import re
from pathlib import Path
from typing import Any

import pytest

from tflab import grading
from tflab.grading.judging.pack import read_pack
from tflab.grading.kernels.sandbox import Sandbox
from tflab.grading.reports.class_figures import bars, histogram
from tflab.grading.reports.class_page import TEXTS, class_page, mistakes
from tflab.grading.reports.feedback import LEVELS, feedback_page
from tflab.grading.reports.gradebook import file_name, file_names, grades_csv
from tflab.grading.reports.html import prose, text
from tflab.grading.submissions import remarks
from tflab.grading.submissions.remarks import KINDS, Remark
from tflab.text import Text, Texts
from tflab.workbook.tasks.misconceptions import MISCONCEPTIONS

from . import tiny


@pytest.fixture(scope="module")
def titles(course: tiny.Course) -> dict[str, dict[str, Text]]:
    return read_pack(course.pack).titles


def record(learner: str = "s101", named: str = "", language: str = "en", **more: Any) -> dict[str, Any]:
    row = {"status": "wrong" if named else "right", "passed": 0 if named else 8, "of": 8, "most": 4.0, "remarks": []}
    said = {"en": "You added the legs.", "ko": "두 변을 더했습니다."}
    mistakes = {named: {"reply": said, "misconception": "M1", "part": "", "partly": False}} if named else {}
    tasks = {"E3.2": row | {"points": 0.0 if named else 4.0, "mistakes": mistakes, "said": said if named else None}}
    return {
        "learner": learner, "name": "", "language": language, "handed_in": True, "remarks": [], "seconds": 0.1,
        "chapters": {tiny.STEM: {"file": "a.ipynb", "tasks": tasks, "remarks": []}},
        "points": tasks["E3.2"]["points"], "most": 4.0,
    } | more  # fmt: skip


def test_mistakes_are_counted_and_grouped_by_what_is_misunderstood() -> None:
    (one,) = mistakes([record(named="added"), record(), record(named="added")])
    assert (one.task, one.name, one.misconception, one.count) == ("E3.2", "added", "M1", 2)
    assert "target and source swapped (M1): 3" in class_page([record(named="added")] * 3)
    assert f"{MISCONCEPTIONS['M1'].ko} 1" in class_page([record(named="added")], language="ko")
    assert "0 graded" in class_page([])
    assert "1 with nothing to grade" in class_page([record(handed_in=False)])


def test_a_korean_class_page_says_in_korean_what_was_refused_and_what_the_wall_leaves_open() -> None:
    refused = Remark("file", file="a.zip: ../x", why=Remark("leads out"))
    wall = (Sandbox("bubblewrap").announce(), *Sandbox("bubblewrap").gaps)
    page = class_page([], language="ko", wall=wall, remarks=[refused])
    assert KINDS["leads out"].ko in page and KINDS["leads out"].en not in page
    assert all(line.ko in page and line.en not in page for line in wall)


@pytest.mark.parametrize("level", LEVELS[1:])
@pytest.mark.parametrize("language", ["en", "ko"])
def test_what_learners_bring_along_is_escaped(titles: dict, level: str, language: str) -> None:
    evil = "<script>alert(1)</script>\"'&\x00\u202e"
    remark = Remark("unreadable", file=evil, why=evil).plain()
    page = feedback_page(record(evil, name=evil, language=language, remarks=[remark]), titles, level)
    page += class_page([record(evil, name=evil, remarks=[remark])])
    assert "<script" not in page
    assert "\x00" not in page and "\u202e" not in page


def test_text_is_text_and_prose_knows_code_and_stress_only() -> None:
    assert text("<b>") == "&lt;b&gt;"
    assert prose("is `a<b` *really* 2*3*4 so?") == "Is <code>a&lt;b</code> <em>really</em> 2*3*4 so?"
    assert prose("node_a is right") == "node_a is right"


def test_no_spreadsheet_computes_a_name() -> None:
    def cell(name: str) -> str:
        return list(csv.reader(io.StringIO(grades_csv([record(name)]).removeprefix("\ufeff"))))[1][0]

    for name in ("=1+1", "+1", "-1+1", "@x", "\t=1", "  =1", "|x", "%x", "＝1+1", "＋1", " ＠x"):
        assert cell(name) == f"'{name}"
    for name in ("Kim;=1+1", "Kim; ＝1+1", "Kim\t+1"):
        assert not any(part.strip()[:1] in set("=+＝＋") for part in cell(name).replace("\t", ";").split(";"))
    assert grades_csv([record()]) == grades_csv([record(seconds=9.0)])  # and how long it took is not in it


def test_a_name_that_cannot_be_a_files_gets_one_of_its_own() -> None:
    assert [file_name(name) for name in ("s101", "김민지")] == ["s101", "김민지"]
    odd = {file_name(name) for name in ("a b", "a_b", "a/b", "..", "", ".", "a" * 65, "a" * 66)}
    assert len(odd) == 8
    assert not any("/" in name or name in ("", ".", "..") for name in odd)
    names = file_names(["s0", "S0", "t1"])  # two files on a disk that ignores case
    assert names["S0"] == "S0" and names["t1"] == "t1"
    assert len({name.casefold() for name in names.values()}) == 3


def test_bars_and_a_histogram_say_their_numbers_in_words() -> None:
    rows = [(Text("added", "더함"), 3), (Text("E3.1", "E3.1"), 1)]
    picture = bars(rows, TEXTS["learners"], most=5, title=TEXTS["named"])
    assert picture.text == "named mistakes, learners:\n  added: 3\n  E3.1: 1"
    assert picture.png().startswith(b"\x89PNG")
    korean = bars(rows[:1], TEXTS["learners"], most=5, title=TEXTS["named"], language="ko")
    assert korean.text == "이름 붙은 실수, 명:\n  더함: 3"
    text = histogram([0, 5, 55, 100]).text
    assert "4 learners, points [%]: mean 40" in text
    assert "  0 to 10: 2" in text and "  90 to 100: 1" in text
    assert histogram([], "ko").png()


def test_each_text_of_a_remark_is_used_and_has_the_same_names_in_both_languages() -> None:
    texts = Texts(remarks.__file__)
    sources = "".join(path.read_text(encoding="utf-8") for path in Path(grading.__file__).parent.rglob("*.py"))
    assert [kind for kind in texts if f'"{kind}"' not in sources and not kind.startswith("by ")] == []
    named = {kind: [set(re.findall(r"\{(\w+)\}", part)) for part in text] for kind, text in texts.items()}
    assert {kind: names for kind, names in named.items() if names[0] != names[1]} == {}
