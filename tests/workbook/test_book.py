"""`tflab build --html` makes a book of the pages that works from a disk, in both languages."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from pathlib import Path
from pkgutil import iter_modules
from urllib.parse import unquote

import nbformat
import pytest
from axe_playwright_python.sync_playwright import Axe

import tflab
from tflab.workbook.book.pages import BookPage, conventions_text, framed, last_line, shell
from tflab.workbook.book.reference import sentences_kept, write_reference
from tflab.workbook.book.search_index import sections_of
from tflab.workbook.pages.build import build

TEXTS = {
    "en": "# 03 · A title\n\nFirst words.\n\n## Predict\n\nWhere is the <b>laser</b>? It turns by $\\pi / 2$.\n\n"
    "<details><summary>I said 2</summary>\nYou forgot the turn.\n</details>\n\n"
    "[exercise](../../exercises/en/E03_target_and_source.ipynb) [start](00_start.ipynb#cell-id=title)",
    "ko": "# 03 · 제목\n\n첫 문장.\n\n## 예측\n\n레이저는 어디에 있습니까?",
}
FIGURE = (
    "from IPython.display import SVG\nfrom tflab.workbook.paths import read_workbook\n"
    "print(read_workbook().language)\n"
    "assert 'laser' in 'laser_frame' and not None  # 0.2 m\n"
    'SVG(\'<svg xmlns="http://www.w3.org/2000/svg" width="40" height="20"><circle r="9"/></svg>\')'
)


def write(path: Path, language: str, *cells: object) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    metadata = {"tflab": {"language": language}}
    nbformat.write(nbformat.v4.new_notebook(cells=list(cells), metadata=metadata), path)


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Path]:
    """A book of two pages and an exercise."""
    pytest.importorskip("latex2mathml", reason="no latex2mathml: pip install 'tflab[lab]'")
    root, out = tmp_path_factory.mktemp("workbook"), tmp_path_factory.mktemp("site")
    (root / "solutions" / "tasks" / "03_target_and_source").mkdir(parents=True)
    markdown, code = nbformat.v4.new_markdown_cell, nbformat.v4.new_code_cell
    for language, text in TEXTS.items():
        start = markdown("# Start\n\nWelcome." if language == "en" else "# 시작\n\n환영합니다.", id="title")
        write(root / "notebooks" / language / "00_start.ipynb", language, start)
        long, longer = (markdown("word  \n" * 60, id=name) for name in ("long", "longer"))
        folded = markdown("## More", id="more", metadata={"jp-MarkdownHeadingCollapsed": True})
        hidden = code("1 + 1", id="hidden", metadata={"jupyter": {"source_hidden": True}})
        cells = [markdown(text, id="title"), long, code(FIGURE, id="figure"), longer, hidden, folded]
        write(root / "notebooks" / language / "03_target_and_source.ipynb", language, *cells)
        write(root / "exercises" / language / "E03_target_and_source.ipynb", language, markdown("# E3", id="title"))
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("TFLAB_WORKBOOK", str(root))
        assert build(["--html", "--out", str(out)]) == 0
    yield out


def test_every_link_and_every_file_of_the_book_leads_somewhere(site: Path) -> None:
    pages = sorted(site.rglob("*.html"))
    assert len(pages) == 13
    for page in pages:
        text = page.read_text(encoding="utf-8")
        for address in re.findall(r'(?:href|src|data-index)="([^"]+)"', text):
            if address.startswith("data:"):
                continue
            assert not address.startswith(("http:", "https:", "//")), address
            file, _, place = unquote(address).partition("#")
            target = (page.parent / file).resolve() if file else page
            assert target.is_file(), f"{page.name}: {address}"
            if place and target.suffix == ".html":
                assert f'id="{place}"' in unquote(target.read_text(encoding="utf-8")), f"{page.name}: {address}"


def test_a_page_has_its_language_its_title_its_contents_and_the_way_on(site: Path) -> None:
    start, chapter, front, languages = (
        (site / name).read_text(encoding="utf-8")
        for name in ("en/00_start.html", "en/03_target_and_source.html", "ko/index.html", "index.html")
    )
    for language in ("en", "ko"):
        text = (site / language / "03_target_and_source.html").read_text(encoding="utf-8")
        assert f"<pre>{language}\n</pre>" in text and f'<html lang="{language}">' in text
        assert f'href="{language}/index.html"' in languages
    assert "<title>00 · Start here · tflab</title>" in start
    assert '<a href="00_start.html" aria-current=page>' in start
    assert re.search(r'<a rel="next" href="03_target_and_source.html">', start) and 'rel="prev"' not in start
    assert '<a href="#Predict">Predict</a>' in chapter
    assert re.search(r"It turns by <math.*π.*</math>", chapter)
    assert "$" not in re.sub(r"<(script|style).*?</\1>", "", chapter, flags=re.DOTALL)
    assert '<a class="book-chapter" href="03_target_and_source.html">03 · 목표 좌표계와 원본 좌표계</a>' in front
    for said in ("35분", "tflab lab --lang ko"):
        assert said in front


def test_the_gallery_shows_each_figure_with_its_line_and_its_place(site: Path) -> None:
    text = (site / "en" / "gallery.html").read_text(encoding="utf-8")
    assert text.count("<figure ") == 1
    assert "SVG(&#39;&lt;svg" in text
    assert 'href="03_target_and_source.html#cell-id=figure"' in text


def test_the_index_of_the_search_holds_the_words_below_each_heading(site: Path) -> None:
    text = (site / "assets" / "search-en.js").read_text(encoding="utf-8")
    rows = json.loads(text.removeprefix("globalThis.tflabIndex = ").removesuffix(";\n"))
    (row,) = [row for row in rows if row[3] == "Predict"]
    assert row[:3] == ["03_target_and_source.html", "03 · Target and source", "Predict"]
    assert "Where is the laser ?" in row[4].replace("laser?", "laser ?")
    assert "You forgot the turn." in row[4]


def test_sections_are_what_stands_between_headings() -> None:
    first, second = sections_of(
        '<p>before</p><div id="cell-id=a"><h1 id="T">Ti<b>tle</b><a class="anchor-link" href="#T">¶</a></h1><p>one</p>'
        '<script>no()</script><p>two</p></div><div id="cell-id=b"><h2 id="S">Sub</h2>three</div>'
    )
    assert (first.place, first.level, first.cell, first.title, first.text) == ("T", 1, "cell-id=a", "Title", "one two")
    assert (second.cell, second.text) == ("cell-id=b", "three")


def test_the_line_that_draws_is_the_last_statement() -> None:
    assert last_line("a = 1\ndraw(\n    a,\n)") == "draw(\n    a,\n)"
    assert last_line("%ros2 topic hz /tf\n%rviz2 -d x\n") == "%rviz2 -d x"
    assert last_line("") == ""


def test_the_conventions_have_the_same_rows_in_both_languages() -> None:
    counts = {language: conventions_text(language).count("\n|") for language in ("en", "ko")}
    assert counts["en"] == counts["ko"] > 10


def test_a_title_cannot_end_the_page_it_stands_on() -> None:
    page = BookPage("x.html", "</title><script>", shell("<h1>x</h1>", "en"), is_chapter=False)
    assert "</title><script>" not in framed(page, [page], "en")


@pytest.mark.browser
def test_in_a_browser_one_finds_changes_the_language_on_the_place_and_prints(site: Path, page) -> None:
    page.goto(f"file://{site}/en/index.html")
    page.get_by_role("searchbox").fill("forgot turn")
    page.locator(".book-found a").first.click()
    page.wait_for_url("**/03_target_and_source.html#Predict")
    page.evaluate("document.getElementById('cell-id=figure').scrollIntoView()")
    page.locator(".book-language").click()
    page.wait_for_url("**/ko/03_target_and_source.html#cell-id=figure")
    assert page.evaluate("Math.round(document.getElementById('cell-id=figure').getBoundingClientRect().top) < 200")

    before = page.evaluate("document.documentElement.dataset.theme")
    page.locator(".book-theme").click()
    page.reload()
    assert page.evaluate("document.documentElement.dataset.theme") != before

    page.goto(f"file://{site}/en/03_target_and_source.html")
    assert page.locator(".tflab-section[open]").count() == 0
    page.locator(".book-contents").get_by_text("More").click()
    page.wait_for_selector(".tflab-section[open]")
    page.evaluate("dispatchEvent(new Event('beforeprint'))")
    assert page.locator(".book-answers dt").all_text_contents() == ["Predict · I said 2"]
    assert page.locator(".book-answers dd").all_text_contents() == ["\nYou forgot the turn.\n"]
    page.evaluate("dispatchEvent(new Event('afterprint'))")
    assert page.locator(".book-answers").count() == 0


@pytest.mark.browser
@pytest.mark.parametrize("language", ["en", "ko"])
def test_the_cheat_sheet_is_one_page_of_a4(language: str, site: Path, page) -> None:
    page.emulate_media(media="print")
    page.set_viewport_size({"width": 688, "height": 500})  # A4 within the margins of book.css
    page.goto((site / language / "conventions.html").as_uri())
    assert page.evaluate("document.documentElement.scrollHeight") <= 1001
    page.goto((site / language / "index.html").as_uri())
    sizes_px = page.evaluate(
        "[...document.querySelectorAll('main p')].map((p) => parseFloat(getComputedStyle(p).fontSize))"
    )
    assert min(sizes_px) > 14


@pytest.mark.browser
@pytest.mark.parametrize(("width", "scheme"), [(390, "light"), (1366, "dark")])
def test_a_page_fits_a_telephone_and_a_desk_and_can_be_read_by_everybody(
    width: int, scheme: str, site: Path, page
) -> None:
    """WCAG 2.1 A and AA and good practice, as axe-core sees them."""
    page.emulate_media(color_scheme=scheme)
    page.set_viewport_size({"width": width, "height": 768})
    for name in ("index", "03_target_and_source", "E03_target_and_source", "gallery", "conventions"):
        page.goto((site / "en" / f"{name}.html").as_uri())
        assert page.evaluate("document.documentElement.scrollWidth") <= width
        measure = page.evaluate("[...document.querySelectorAll('main p')].map((p) => p.getBoundingClientRect().width)")
        assert max(measure, default=0) <= 800
        assert page.evaluate("document.documentElement.dataset.theme") == scheme
        found = Axe().run(page, options={"runOnly": ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "best-practice"]})
        serious = [each for each in found.response["violations"] if each["impact"] in ("serious", "critical")]
        assert [(each["id"], each["nodes"][0]["html"]) for each in serious] == [], name


def test_a_sentence_that_ends_in_a_colon_is_no_section_of_a_docstring() -> None:
    google = pytest.importorskip("pdoc.docstrings", reason="no pdoc: pip install 'tflab[site]'").google
    text = "One calls four functions:\n\n    import x\n\n    words    is read\n\nRaises:\n    ValueError: no.\n"
    assert google(text).startswith("\n###### One calls four functions:\n> import x")
    kept = google(sentences_kept(text))
    assert kept.startswith("One calls four functions: \n\n    import x\n\n    words    is read\n")
    assert "###### Raises:\n - **ValueError:**  no." in kept


@pytest.mark.browser
def test_the_reference_is_dark_at_night_and_on_paper_the_text_alone(tmp_path: Path, page, monkeypatch) -> None:
    others = [f"tflab.{found.name}" for found in iter_modules(tflab.__path__) if found.name != "core"]
    monkeypatch.setattr("tflab.workbook.book.reference.HIDDEN", others)
    write_reference(tmp_path / "reference")
    page.goto(f"file://{tmp_path}/reference/tflab/core.html")
    assert "Alias for field" not in page.content()
    back = page.get_by_text("Back to the book").evaluate("link => link.href")
    assert back == f"file://{tmp_path}/index.html"
    page.locator("nav a[href$='core/buffer.html']").first.click()  # every page of the engine has one of its own
    assert page.locator("#BufferCore").count() == 1
    page.go_back()
    background = "getComputedStyle(document.body).backgroundColor"
    assert page.evaluate(background) == "rgb(255, 255, 255)"
    page.emulate_media(color_scheme="dark")
    assert page.evaluate(background) == "rgb(20, 23, 27)"

    page.emulate_media(media="print")
    page.set_viewport_size({"width": 690, "height": 900})
    assert page.evaluate(background) == "rgb(255, 255, 255)"
    assert not page.locator("nav.pdoc").is_visible()
    cut = "[...document.querySelectorAll('main pre')].filter((pre) => pre.scrollWidth > pre.clientWidth + 1).length"
    assert page.evaluate(cut) == 0
