"""A CSV file becomes a class, with one clear line for each row that is wrong."""

from __future__ import annotations

from pathlib import Path

import pytest
import yaml

from tflab.grading.submissions.roster import Learner, is_learner_id, read_roster

CASES = yaml.safe_load(Path(__file__).with_suffix(".yaml").read_text(encoding="utf-8"))


def test_a_row_is_a_learner() -> None:
    roster = read_roster("id,name,language\ns101,김민지,ko\ns102,Ada Byron,\n\n , , \n".encode())
    assert roster.learners == {"s101": Learner("s101", "김민지", "ko"), "s102": Learner("s102", "Ada Byron", "en")}
    assert roster.faults == ()
    assert read_roster(b"id\ns101\n", "ko").learners["s101"].language == "ko"
    for spoken, language in (("KO", "ko"), ("한국어", "ko"), ("en-US", "en"), ("English", "en")):
        row = read_roster(f"학번,성명,언어\ns101,김민지,{spoken}\n".encode()).learners["s101"]
        assert (row.name, row.language) == ("김민지", language)


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16", "cp949"])
def test_a_spreadsheet_may_write_it_in_any_encoding_and_divide_it_as_it_likes(encoding: str) -> None:
    for text in (
        "id,name\ns101,김민지\n",
        "sep=;\n\nname;id\n김민지;s101\n",
        'id\tnote\tname\ns101\t"one\ntwo"\t김민지\n',
    ):
        assert read_roster(text.encode(encoding)).learners == {"s101": Learner("s101", "김민지", "en")}


def test_the_columns_of_learning_systems_are_known() -> None:
    moodle = read_roster(b'"Full name","ID number","Email address"\n"Ada Byron",s102,a@b.c\n')
    canvas = read_roster(b'Student,ID,SIS User ID\n"Byron, Ada",77,s102\n')
    assert list(moodle.learners) == ["s102"]
    assert moodle.learners["s102"].name == "Ada Byron"
    assert canvas.learners


@pytest.mark.parametrize(("row", "fault"), CASES["wrong_rows"])
def test_a_wrong_row_is_one_line_and_costs_nobody_else(row: str, fault: str) -> None:
    roster = read_roster(f"id,name,language\n{row}\ns102,Ada,en\n".encode())
    assert len(roster.faults) == 1
    assert roster.faults[0].startswith(fault)
    assert list(roster.learners) == ["s102"]


def test_an_id_that_is_there_twice_is_taken_once() -> None:
    roster = read_roster(b"id,name\ns101,A\nS101,B\n")
    assert roster.learners == {"s101": Learner("s101", "A", "en")}
    assert "twice" in roster.faults[0]


@pytest.mark.parametrize("data", [b"", b"name\nAda\n", b"\0\xff\xfe", b"PK\x03\x04xl/workbook.xml", b"id\x1b[2J\n"])
def test_what_is_no_roster_is_one_line(data: bytes) -> None:
    roster = read_roster(data)
    assert not roster.learners
    assert len(roster.faults) == 1


def test_an_id_is_the_name_of_a_folder_anywhere() -> None:
    assert all(map(is_learner_id, ("s101", "20231234", "a.b-c_d@e.f")))
    odd = ("", "a b", "-a", ".a", "a.", "a..b", "nul", "NUL.txt", "a" * 65, "a\nb", "../x")
    assert not any(map(is_learner_id, odd))


@pytest.mark.parametrize("rest", ["s102,b\n", "s102,b\n" * 40_000])
def test_a_quotation_mark_that_is_not_closed_is_said(rest: str) -> None:
    roster = read_roster(f'id,name\ns101,a\ns1,"x\n{rest}'.encode())
    assert list(roster.learners) == ["s101"]
    assert roster.faults == ("row 3: a quotation mark is not closed; nothing behind it is read",)
