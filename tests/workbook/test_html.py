"""`tflab build --html` and `tflab export` make of a notebook a page that needs neither kernel nor network."""

from __future__ import annotations

import re
from pathlib import Path

import nbformat
import pytest

from tflab.workbook.pages.build import build
from tflab.workbook.pages.html import main

VIEW = "application/vnd.jupyter.widget-view+json"


def notebook(path: Path, *sources: str) -> Path:
    cells = [nbformat.v4.new_code_cell(source, id=f"cell-{i}") for i, source in enumerate(sources)]
    nbformat.write(nbformat.v4.new_notebook(cells=cells), path)
    return path


def test_a_page_is_run_and_written_and_its_source_stays_as_it_was(tmp_path: Path) -> None:
    source = notebook(
        tmp_path / "look.ipynb",
        "from meshcat.geometry import Box\nfrom tflab.views.scene import Scene\nscene = Scene()\n"
        "scene['crate'].set_object(Box([1.0, 1.0, 1.0]))\nscene",
        "open('made_here', 'w').close()\nprint(6 * 7)",
    )
    before = source.read_bytes()
    assert build(["--html", str(source), "--out", str(tmp_path / "out")]) == 0
    page = (tmp_path / "out" / "look.html").read_text(encoding="utf-8")
    assert "42" in page
    assert (tmp_path / "out" / "assets").is_dir()
    assert "crate" in page
    assert not re.search(r"<(script|link)[^>]+(src|href)=\"https?:", page)
    assert source.read_bytes() == before
    assert not (tmp_path / "made_here").exists()


def test_a_notebook_that_fails_is_named_and_does_not_stop_the_other_pages(tmp_path: Path, capsys) -> None:
    bad = notebook(tmp_path / "bad.ipynb", "raise RuntimeError('wheel came off')")
    ends = notebook(tmp_path / "ends.ipynb", "import os\nos._exit(1)")
    good = notebook(tmp_path / "good.ipynb", "for n in range(6):\n    print('line', n, flush=True)")
    none = tmp_path / "none.ipynb"
    none.write_text("[1, 2]")
    assert build(["--html", *map(str, (none, bad, ends, good)), "--out", str(tmp_path / "out")]) == 1
    said = capsys.readouterr().err
    for wrong in ("wheel came off", "ends.ipynb: Kernel died", f"{none}: this is no notebook, or a damaged one"):
        assert wrong in said
    assert [path.name for path in (tmp_path / "out").glob("*.html")] == ["good.html"]
    shown = (tmp_path / "out" / "good.html").read_text(encoding="utf-8")
    assert "".join(f"line {n}\n" for n in range(6)) in shown  # one text, however it came
    assert build(["--html", str(tmp_path / "nowhere.ipynb")]) == 2
    assert "nowhere.ipynb" in capsys.readouterr().err


def test_a_link_leads_to_what_is_written_too_and_others_are_words(tmp_path: Path) -> None:
    said = (
        "[on](04_y.ipynb#why) [do](../../exercises/en/E03_x.ipynb) [far](05_z.ipynb) [web](https://a.example/b.ipynb)"
    )
    for stem in ("03_x", "04_y"):
        cells = [nbformat.v4.new_markdown_cell(f"# `{stem}` · *two* things\n\n{said}")]
        page = nbformat.v4.new_notebook(cells=cells, metadata={"tflab": {"language": "ko"}})
        nbformat.write(page, tmp_path / f"{stem}.ipynb")
    files = [str(tmp_path / f"{stem}.ipynb") for stem in ("03_x", "04_y")]
    assert build(["--html", *files, "--out", str(tmp_path / "out")]) == 0
    text = (tmp_path / "out" / "03_x.html").read_text(encoding="utf-8")
    assert '<a href="04_y.html#why">on</a> do far <a' in text
    assert 'href="https://a.example/b.ipynb"' in text
    assert "<title>03_x · two things · tflab</title>" in text
    assert 'lang="ko"' in text


def executed(folder: Path, *outputs: dict) -> Path:
    """Write a notebook that was run."""
    prose = nbformat.v4.new_markdown_cell(
        "# A title\n\n## Part\n\n[on](02_next.ipynb) ![mine](../assets/mine.png)", id="prose"
    )
    shown = [nbformat.v4.new_output("display_data", data) for data in outputs]
    cell = nbformat.v4.new_code_cell("1 + 1", outputs=shown, execution_count=1, id="a")
    nbformat.write(nbformat.v4.new_notebook(cells=[prose, cell]), folder / "page.ipynb")
    return folder / "page.ipynb"


def test_export_writes_a_page_in_the_frame_of_the_book_and_prints_where(tmp_path: Path, capsys, monkeypatch) -> None:
    executed(tmp_path)
    monkeypatch.chdir(tmp_path)
    assert main(["page.ipynb"]) == 0
    assert capsys.readouterr().out.split() == [str(Path("html", "page.html"))]
    page = Path("html/page.html").read_text(encoding="utf-8")
    assert 'href="#Part"' in page and "book-theme" in page  # its sections, and a dark theme
    assert "02_next" not in page and "index.html" not in page  # no link to what is not there
    assert '"../assets/mine.png"' in page  # a picture of the reader's own
    for asset in re.findall(r'(?:src|href)="(assets/[^"]+)"', page):
        assert Path("html", asset).is_file()
    assert main(["page.ipynb", "--out", "mail", "--single-file"]) == 0
    assert not re.search(r'(?:src|href)="assets/', Path("mail/page.html").read_text(encoding="utf-8"))


@pytest.mark.parametrize("text", ["hi", "[1, 2]", '{"nbformat": 4}', "\udc80"])
def test_export_of_a_file_that_is_no_notebook_writes_nothing(text: str, tmp_path: Path, capsys) -> None:
    path = tmp_path / "none.ipynb"
    assert main([str(path), "--out", str(tmp_path / "site")]) == 2
    assert "there is no notebook" in capsys.readouterr().err
    path.write_bytes(text.encode(errors="surrogateescape"))
    assert main([str(path), "--out", str(tmp_path / "site")]) == 2
    assert capsys.readouterr().err == f"tflab export: {path}: this is no notebook, or a damaged one\n"
    assert not (tmp_path / "site").exists()


def test_export_of_a_notebook_without_cells_writes_a_page(tmp_path: Path) -> None:
    nbformat.write(nbformat.v4.new_notebook(), tmp_path / "empty.ipynb")
    assert main([str(tmp_path / "empty.ipynb"), "--out", str(tmp_path / "out")]) == 0
    assert "<title>empty · tflab</title>" in (tmp_path / "out/empty.html").read_text(encoding="utf-8")


def test_export_counts_the_views_that_were_not_stored(tmp_path: Path, capsys) -> None:
    notebook = executed(tmp_path, {VIEW: {"model_id": "one"}}, {VIEW: {"model_id": "two"}})
    assert main([str(notebook), "--out", str(tmp_path / "out")]) == 0
    printed = capsys.readouterr().err
    assert "live views that the notebook does not store: 2" in printed and f'tflab build --html "{notebook}"' in printed
