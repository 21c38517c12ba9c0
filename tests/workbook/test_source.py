"""A page is read as cells with their names, languages, tags and lines, and with magics as they are typed."""

from __future__ import annotations

from pathlib import Path

import pytest

from tflab.workbook.pages.source import PageError, code_lines, read_page

from .making_pages import TITLE, code, page, text, written


def test_a_cell_has_its_name_its_language_its_tags_and_its_line(tmp_path: Path) -> None:
    read = page(tmp_path, TITLE, code("look", "print(1)", ' tags=["check", "answer"] slide="fragment"'))
    title, _, load, look = read.cells
    assert (title.name, title.kind, title.lang, title.source, title.line) == ("title", "markdown", "en", "# A page", 1)
    assert (load.source, load.lang, load.slide) == ("%load_ext tflab", None, "-")
    assert (look.tags, look.slide, look.line) == (("check", "answer"), "fragment", 10)
    assert read.stem == "03_x"
    assert page(tmp_path, TITLE, code("look", "1", ' colour="red"')).cells[-1].unknown == ("colour",)


def test_a_reader_of_one_language_sees_its_texts_and_all_code(tmp_path: Path) -> None:
    read = page(tmp_path, TITLE, text("why", "Because.", "그래서입니다."))
    assert [cell.source for cell in read.in_language("ko")] == ["# 한 쪽", "%load_ext tflab", "그래서입니다."]


def test_text_before_the_first_cell_is_said_with_its_file(tmp_path: Path) -> None:
    path = written(tmp_path, "print('lost')\n", TITLE)
    with pytest.raises(PageError, match=r"^notebooks/src/03_x\.py:1: .*3 cells are marked and 4 are there"):
        read_page(path)


def test_fenced_code_in_a_text_is_told_from_prose() -> None:
    assert code_lines("a\n```python\n# no heading\n```\nb\n~~~\n```\n~~~") == {1, 2, 3, 5, 6, 7}
