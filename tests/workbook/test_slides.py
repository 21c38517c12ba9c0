"""`tflab slides` makes a deck of a page that works from a disk, with its views, its steps and the speaker's notes."""

from __future__ import annotations

import re
from pathlib import Path
from urllib.parse import quote

import pytest

from tflab.workbook.pages import slides
from tflab.workbook.pages.build import build
from tflab.workbook.pages.slides import main, slides_of

from .making_pages import TITLE, code, text, written

SCENE = "from meshcat.geometry import Box\nfrom tflab.views.scene import Scene\nscene = Scene()\n"
SCENE += "scene['crate'].set_object(Box([1.0, 1.0, 1.0]))\nscene"
DRAW = "from tflab.views.picture import Picture\npicture = Picture()\npicture.text = 'a crate'\npicture"
PAGE = (
    TITLE.replace('name="title"', 'name="title" slide="slide"').replace('name="load"', 'name="load" slide="skip"'),
    text("title-notes", "Wait until *all* sit.", "모두 앉을 때까지 기다립니다.", ' slide="notes"'),
    text("why", "## Why?", "## 왜?", ' slide="slide"'),
    text("because", "Because.", "그래서입니다.", ' slide="fragment"'),
    code("crate", SCENE, ' tags=["interactive"] slide="subslide"'),
    code("still", DRAW, ' tags=["static"]'),
    code("fails", "1 / 0", ' tags=["raises-exception"] slide="slide"'),
)


@pytest.fixture(scope="module")
def workbook(tmp_path_factory: pytest.TempPathFactory) -> Path:
    root = tmp_path_factory.mktemp("lectured")
    written(root, *PAGE)
    assert build(["--root", str(root)]) == 0
    return root


@pytest.fixture(scope="module")
def deck(workbook: Path) -> Path:
    assert main([str(workbook / "notebooks" / "en" / "03_x.ipynb"), "--out", str(workbook / "decks")]) == 0
    return workbook / "decks" / "03_x.html"


def cell(name: str, kind: str = "-", source: str = "text", notes: str = "") -> dict:
    metadata = {"slideshow": {"slide_type": kind}, "tflab": {"notes": notes} if notes else {}}
    return {"id": name, "cell_type": "markdown", "metadata": metadata, "source": [source]}


def test_cells_are_grouped_into_slides_and_steps() -> None:
    page = {
        "cells": [
            cell("a", source="# `Title`"),
            cell("b", "slide", "## Frames", notes="Say *this*."),
            cell("c", "fragment"),
            cell("d"),
            cell("e", "skip"),
            cell("f", "subslide", notes="And that."),
        ]
    }
    slides = slides_of(page)
    assert [slide.steps for slide in slides] == [(("a",),), (("b",), ("c", "d")), (("f",),)]
    assert [slide.title for slide in slides] == ["Title", "Frames", "Frames"]
    assert slides[1].notes == "<p>Say <em>this</em>.</p>"
    assert [slide.notes for slide in slides_of(page, notes=False)] == ["", "", ""]


def test_a_deck_loads_nothing_from_the_network(deck: Path) -> None:
    page = deck.read_text(encoding="utf-8")
    assert not re.search(r"<(script|link|img)[^>]+(src|href)=\"https?:", page)
    assert "reveal" not in page
    assert "ZeroDivisionError: division by zero" in page
    assert "Traceback" not in page


def test_a_page_is_asked_for_by_its_number_in_a_language(workbook: Path, monkeypatch, tmp_path: Path, capsys) -> None:
    monkeypatch.setenv("TFLAB_WORKBOOK", str(workbook))
    monkeypatch.chdir(tmp_path)
    assert main(["03", "--lang", "ko", "--no-notes", "--single-file"]) == 0
    page = (tmp_path / "slides" / "03_x.html").read_text(encoding="utf-8")
    assert 'lang="ko"' in page
    assert "발표자 창" in page
    assert "기다립니다" not in page.partition('id="tflab-deck"')[2]
    assert not (tmp_path / "slides" / "assets").exists()
    assert main(["07"]) == 2
    assert 'unknown page "07"; available: 03' in capsys.readouterr().err


def test_a_page_without_a_slide_is_said(tmp_path: Path, monkeypatch, capsys) -> None:
    monkeypatch.chdir(tmp_path)
    Path("blank.ipynb").write_text('{"cells": [], "metadata": {}, "nbformat": 4, "nbformat_minor": 5}')
    assert main(["blank.ipynb"]) == 1
    assert capsys.readouterr().err == "blank.ipynb: no cell of it is shown on a slide\n"
    assert not Path("slides").exists()


def shown(page) -> str:
    return page.inner_text(".deck-current")


@pytest.mark.browser
def test_keys_go_through_the_slides_step_by_step(deck: Path, page) -> None:
    page.goto(deck.as_uri())
    assert "A page" in shown(page)
    assert page.inner_text("#deck-place") == "1 / 4"
    assert "load_ext" not in page.inner_text("main")
    page.keyboard.press("ArrowRight")
    assert "Why?" in shown(page)
    assert not page.get_by_text("Because.").is_visible()
    page.keyboard.press("Space")
    assert page.get_by_text("Because.").is_visible()
    page.keyboard.press("PageDown")
    assert page.url.endswith("#crate")
    page.keyboard.press("ArrowLeft")
    assert page.get_by_text("Because.").is_visible()
    page.keyboard.press("End")
    assert "division by zero" in shown(page)
    page.keyboard.press("ArrowRight")
    assert page.inner_text("#deck-place") == "4 / 4"
    page.keyboard.press("Home")
    assert page.inner_text("#deck-place") == "1 / 4"


DRAWN = """() => [...document.querySelectorAll('.deck-slide canvas')].every((c) => c.width > 300
  && c.getContext('2d').getImageData(0, 0, c.width, c.height).data.some((v) => v))"""


@pytest.mark.browser
def test_a_view_is_drawn_when_its_slide_is_shown_and_all_are_before_they_are_printed(deck: Path, page) -> None:
    page.goto(f"{deck.as_uri()}#crate")
    page.wait_for_selector(".deck-current canvas")
    page.wait_for_function(DRAWN)
    assert page.locator(".deck-current img[alt]").count() == 0  # the same, standing still

    page.goto("about:blank")
    page.goto(deck.as_uri())
    page.wait_for_selector(".deck-slide canvas", state="attached")
    page.evaluate("window.print = () => { window.printed = document.body.className; }")
    page.keyboard.press("p")
    page.wait_for_function("window.printed?.includes('deck-printing')")
    assert page.evaluate(DRAWN)
    assert page.inner_text("#deck-place") == "1 / 4"


@pytest.mark.proof(reads=["notebooks/en/03_*.ipynb"])
@pytest.mark.browser
def test_the_deck_of_a_chapter_shows_every_slide_and_draws_every_view(tmp_path: Path, page) -> None:
    assert main(["03", "--lang", "en", "--out", str(tmp_path)]) == 0
    wrong = []
    page.on("pageerror", lambda error: wrong.append(error))
    page.goto((tmp_path / "03_target_and_source.html").as_uri())
    assert page.title() == page.inner_text(".deck-current h1").removesuffix("¶")
    last = page.locator(".deck-slide").count()
    for _ in range(500):
        page.keyboard.press("ArrowRight")
        page.wait_for_timeout(30)  # a long slide is scrolled before it is left
        page.wait_for_function(DRAWN.replace(".deck-slide canvas", ".deck-current .deck-shown canvas"))
        if page.inner_text("#deck-place") == f"{last} / {last}":
            break
    assert page.inner_text("#deck-place") == f"{last} / {last}"
    assert page.locator(".deck-slide canvas").count() >= 1
    assert page.evaluate(DRAWN)
    assert wrong == []


@pytest.mark.browser
def test_the_speaker_has_notes_in_the_page_and_in_a_window_that_follows(deck: Path, page) -> None:
    page.goto(deck.as_uri())
    assert not page.locator("#deck-notes").is_visible()
    page.keyboard.press("n")
    assert page.inner_text("#deck-notes").strip() == "Wait until all sit."
    page.keyboard.press("n")
    with page.expect_popup() as opened:
        page.keyboard.press("s")
    speaker = opened.value
    assert "Wait until all sit." in speaker.inner_text("#notes")
    assert speaker.inner_text("#next") == "next: Why?"
    speaker.keyboard.press("ArrowRight")
    assert speaker.inner_text("#title") == "Why?"
    assert "Why?" in shown(page)


@pytest.mark.browser
def test_keys_show_all_slides_put_the_code_away_and_change_the_theme_and_all_is_printed(deck: Path, page) -> None:
    page.emulate_media(color_scheme="dark")
    page.goto(deck.as_uri())
    page.keyboard.press("o")
    assert page.locator(".deck-slide").nth(3).is_visible()
    page.locator(".deck-slide").nth(3).click()
    assert page.inner_text("#deck-place") == "4 / 4"
    assert not page.locator(".deck-slide").nth(0).is_visible()
    ground = "getComputedStyle(document.body).backgroundColor"
    assert page.evaluate(ground) == "rgb(17, 17, 17)"
    page.keyboard.press("t")
    assert page.evaluate(ground) in ("rgb(255, 255, 255)", "white")

    page.goto(f"{deck.as_uri()}#crate")
    assert "set_object" in shown(page)
    page.keyboard.press("c")
    assert "set_object" not in shown(page)
    assert page.locator(".deck-current canvas").first.is_visible()
    page.keyboard.press("c")
    assert "set_object" in shown(page)

    page.emulate_media(media="print")
    assert page.get_by_text("Because.").is_visible()
    assert page.get_by_text("division by zero").first.is_visible()
    assert not page.locator("#deck-bar").is_visible()


@pytest.mark.browser
def test_what_is_too_long_for_a_slide_stands_in_two_columns(deck: Path, page) -> None:
    page.set_viewport_size({"width": 1280, "height": 720})
    page.goto(f"{deck.as_uri()}#crate")
    grow = (
        "document.querySelector('.deck-current .deck-step').insertAdjacentHTML('beforeend', '<p>a line</p>'.repeat({}))"
    )
    page.evaluate(grow.format(12))
    page.evaluate("dispatchEvent(new Event('resize'))")
    assert page.locator(".deck-current .deck-columns").count() == 1
    assert not page.locator("#deck-more.deck-shown").count()
    page.evaluate(grow.format(200))
    page.evaluate("dispatchEvent(new Event('resize'))")
    assert page.locator(".deck-current .deck-columns").count() == 0
    assert page.locator("#deck-more.deck-shown").count() == 1


HALVES = '<div class="deck-slide deck-current"><div class="deck-content deck-columns" style="{}">{}</div></div>'


@pytest.mark.browser
def test_in_a_slide_of_two_halves_no_picture_is_cut_and_a_long_text_goes_on_in_the_second(page) -> None:
    style = (Path(slides.__file__).parent / "static" / "deck.css").read_text(encoding="utf-8")
    drawn = '<svg width="900" height="300"></svg>'
    picture = f'<img width="900" height="300" src="data:image/svg+xml,{quote(drawn)}">'
    wide = f'<div class="jp-OutputArea-output">{picture}{drawn}</div>'
    page.set_content(f"<style>{style}</style>" + HALVES.format("width: 800px", wide))
    widths = page.evaluate("[...document.querySelectorAll('img, svg')].map((one) => one.getBoundingClientRect().width)")
    assert len(widths) == 2 and max(widths) < 400

    child = '<div class="jp-OutputArea-child" style="display: table; overflow: hidden">{}</div>'
    text = f'<div class="jp-OutputArea-output" style="display: table-cell"><pre>{"line<br>" * 40}</pre></div>'
    area = f'<div class="jp-OutputArea jp-Cell-outputArea" style="overflow: auto">{child.format(text)}</div>'
    page.set_content(f"<style>{style}</style>" + HALVES.format("width: 900px; height: 600px", area))
    content = page.locator(".deck-content")
    assert content.evaluate("(all) => all.scrollHeight <= all.clientHeight && all.scrollWidth <= all.clientWidth")
