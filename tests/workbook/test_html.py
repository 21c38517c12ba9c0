"""`tflab build --html` makes of a notebook a page that needs neither kernel nor network."""

from __future__ import annotations

import re
from pathlib import Path

import nbformat

from tflab.workbook.pages.build import build


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
    assert "<title>03_x · two things</title>" in text
    assert 'lang="ko"' in text
