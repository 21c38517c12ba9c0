"""The first page in a real browser: it runs to its end, 3D is there, words explain themselves, links lead on."""

from __future__ import annotations

import re
from pathlib import Path

import nbformat
import pytest
from axe_playwright_python.sync_playwright import Axe
from nbformat.sign import NotebookNotary

import tflab
from tflab.ros.activation import PACKAGES
from tflab.workbook.copy.lay_out import lay_out
from tflab.workbook.progress import record_try

PAGES = ("notebooks/*/00_*.ipynb", "notebooks/ko/03_*.ipynb")
pytestmark = [pytest.mark.browser, pytest.mark.proof(reads=[*PAGES, "tflab/workbook/copy/jupyter/**/*"])]

SCRIPT = Path(tflab.__file__).parent / "workbook/copy/jupyter/labextensions/tflab/static/remoteEntry.js"
PYTHON = {"name": "python3", "display_name": "Python 3"}
MODEL = "jupyterapp.shell.currentWidget.content.model"
CELLS = f"{MODEL}.cells"
# A page of this length is drawn only where one looks: what has run is asked of its cells, not of their pictures.
HAVE_RUN = f"[...Array({CELLS}.length).keys()].every((i) => {CELLS}.get(i).executionCount !== null)"
SHOW = f"""(name) => {{
  const place = [...Array({CELLS}.length).keys()].find((i) => {CELLS}.get(i).getMetadata("name") === name);
  return jupyterapp.shell.currentWidget.content.scrollToItem(place, "start");
}}"""


def open_page(lab, page, name: str, *cells) -> None:
    """Write a notebook of these cells into the folder of JupyterLab, and open it."""
    metadata = {"tflab": {"language": "en"}, "kernelspec": PYTHON}
    nbformat.write(nbformat.v4.new_notebook(cells=list(cells), metadata=metadata), lab.folder / name)
    lab.open(page, name)


@pytest.mark.parametrize("language", ["en", "ko"])
def test_the_first_page_runs_and_shows_what_has_been_passed(language: str, lab, page) -> None:
    copy = lay_out(lab.folder / f"copy_{language}", language)
    record_try(copy, "E3.1", 4, 4)
    lab.open(page, f"{copy.name}/notebooks/{language}/00_start.ipynb")
    assert page.get_by_text("Jupyter news").count() == 0
    page.evaluate("void jupyterapp.commands.execute('notebook:run-all-cells')")
    page.wait_for_function(HAVE_RUN)
    page.evaluate(SHOW, "rviz")
    page.wait_for_selector(".jp-OutputArea-output canvas")
    page.evaluate(SHOW, "progress")
    page.wait_for_selector('.tflab-progress [title^="E3.1"]', state="attached")
    assert page.locator('.tflab-progress [title^="E3.1"]').text_content() == "■"
    assert page.locator('.tflab-progress [title^="E3.2"]').text_content() == "□"
    assert page.locator('.jp-OutputArea-output[data-mime-type*="error"]').count() == 0
    assert page.locator("abbr[title]").count() >= 3
    page.evaluate(SHOW, "map")
    page.locator(".jp-RenderedMarkdown a", has_text="E3").first.click()
    exercise = f"{copy.name}/exercises/{language}/E03_target_and_source.ipynb"
    page.wait_for_function(f"jupyterapp.shell.currentWidget?.context?.path === '{exercise}'")


def test_what_the_first_cell_brings_is_told_from_a_mistake_of_ones_own(lab, page) -> None:
    copy = lay_out(lab.folder / "copy_too_early", "en")
    going_on = {"tags": ["raises-exception"]}
    sources = [
        "import rclpy",
        "%rviz2 -f map",
        "lesson",
        "%rviz -f map",
        "import rclpi",
        "1 + ''",
        "hint(E1.2)",
        "hint(1",
        "%load_ext tflb",
        "%tflab progress",
    ]
    cells = [nbformat.v4.new_code_cell(source, id=f"cell-{i}", metadata=going_on) for i, source in enumerate(sources)]
    open_page(lab, page, f"{copy.name}/notebooks/en/mine.ipynb", *cells)
    lab.run_all(page)
    page.wait_for_function("document.querySelectorAll('.tflab-advice').length === 7")
    cells_with = "[...document.querySelectorAll('.jp-CodeCell')].map((cell) => !!cell.querySelector('.tflab-advice'))"
    advice = page.locator(".tflab-advice").all_text_contents()  # of those out of sight, too
    assert advice[3] == "There is no %rviz. Did you mean %rviz2?"
    assert advice[4].startswith("A task's number stands in quotes")
    assert advice[5:] == [
        "There is no tflb. Did you mean tflab?",
        "A command of the terminal begins with ! in a cell: !tflab.",
    ]
    assert page.evaluate(cells_with) == [True, True, True, True, False, False, True, False, True, True]


def test_the_packages_of_the_first_cell_are_those_that_it_activates() -> None:
    listed = re.search(r"const PACKAGES = new Set\(\[(.+?)\]\)", SCRIPT.read_text(encoding="utf-8"), re.DOTALL)
    assert set(re.findall(r'"(\w+)"', listed[1])) == set(PACKAGES)


def test_a_picture_says_what_it_shows_a_page_its_language_and_no_line_of_code_is_cut(lab, page) -> None:
    copy = lay_out(lab.folder / "copy_of_words", "ko")
    lab.open(page, f"{copy.name}/notebooks/ko/03_target_and_source.ipynb")
    page.wait_for_selector(".jp-Notebook[lang=ko]")
    page.wait_for_selector(".jp-CodeCell .cm-content.cm-lineWrapping")
    page.evaluate("jupyterapp.shell.currentWidget.content.scrollToItem(6, 'start')")
    page.wait_for_selector(".jp-RenderedImage img")
    page.wait_for_function(
        "[...document.querySelectorAll('.jp-RenderedImage img')].every((image) => image.alt.length > 20)"
    )


def test_a_view_without_a_kernel_and_a_dotted_word_explain_themselves_and_only_edits_are_unsaved(lab, page) -> None:
    view = {"model_id": "0" * 32, "version_major": 2, "version_minor": 0}
    shown = {"application/vnd.jupyter.widget-view+json": view, "text/plain": "odom and base_link, 2.00 m apart"}
    dotted = nbformat.v4.new_markdown_cell('An <abbr title="An origin and three axes.">frame</abbr> has a name.')
    scene = nbformat.v4.new_code_cell("scene", outputs=[nbformat.v4.new_output("display_data", shown)])
    metadata = {"tflab": {"language": "en"}, "kernelspec": PYTHON}
    notebook = nbformat.v4.new_notebook(cells=[dotted, scene], metadata=metadata)
    nbformat.write(notebook, lab.folder / "yesterday.ipynb")
    NotebookNotary().sign(nbformat.read(lab.folder / "yesterday.ipynb", 4))
    lab.open(page, "yesterday.ipynb")
    page.wait_for_function("document.body.innerText.includes('Run this cell to see it move.')")
    said = page.locator(".jp-OutputArea-output").inner_text()
    assert said.startswith("odom and base_link, 2.00 m apart")
    assert "model not found" not in said

    page.wait_for_selector("abbr[tabindex='0']").focus()
    title = "getComputedStyle(document.querySelector('abbr'), '::after').content"
    assert page.evaluate(title) == '"An origin and three axes."'
    page.evaluate("document.activeElement.blur()")
    assert page.evaluate(title) == "none"

    page.wait_for_function(f"{MODEL}.getMetadata('language_info').version !== undefined")  # what its kernel is called
    page.wait_for_timeout(500)
    assert page.evaluate(f"{MODEL}.dirty") is False
    page.evaluate(f"{MODEL}.cells.get(1).sharedModel.setSource('3 + 3')")
    page.wait_for_timeout(500)
    assert page.evaluate(f"{MODEL}.dirty") is True


def test_a_panel_names_its_picture_and_its_sliders(lab, page) -> None:
    lab.write_notebook("panel.ipynb", ["from tflab.views.panels import latency_panel\nlatency_panel()"])
    lab.open(page, "panel.ipynb")
    lab.run_all(page)
    page.wait_for_selector(".jp-OutputArea-output img.tflab-picture[alt]")
    page.wait_for_selector("[role=slider][aria-label]")  # the extension looks five times a second
    named = page.eval_on_selector_all("[role=slider]", "(all) => all.map((each) => each.getAttribute('aria-label'))")
    assert len(named) >= 3 and named[0] == "speed [m/s]" and all(named)
    assert page.locator("img.tflab-picture").get_attribute("alt").startswith("A robot drives 1.000 m/s")
    found = Axe().run(page, context={"include": [[".jp-OutputArea"]]}, options={"runOnly": ["wcag2a", "wcag2aa"]})
    assert [each["id"] for each in found.response["violations"]] == []


def test_a_drawing_that_is_wider_than_its_column_shrinks_or_says_that_it_scrolls(lab, page) -> None:
    svg = '<svg xmlns="http://www.w3.org/2000/svg" width="{0}" height="40"><rect width="{0}" height="40"/></svg>'
    cells = [f"from IPython.display import SVG\nSVG('{svg.format(width)}')" for width in (900, 2000)]
    page.set_viewport_size({"width": 1000, "height": 600})
    open_page(lab, page, "wide.ipynb", *map(nbformat.v4.new_code_cell, cells))
    page.wait_for_selector(".tflab-page")
    lab.run_all(page)
    page.wait_for_function("document.querySelectorAll('.jp-RenderedSVG[tabindex]').length === 2")
    shrunk, scrolls = page.locator(".jp-RenderedSVG").all()
    assert shrunk.get_attribute("data-scrolls") is None and scrolls.get_attribute("data-scrolls") is not None
    assert shrunk.locator("img").bounding_box()["width"] <= shrunk.bounding_box()["width"]
    assert scrolls.locator("img").bounding_box()["width"] == pytest.approx(0.8 * 2000)


def test_in_a_narrow_window_the_list_of_files_makes_room(lab, page) -> None:
    open_page(lab, page, "narrow.ipynb", nbformat.v4.new_code_cell("1 + 1"))
    for width, is_folded in ((390, True), (1366, False)):
        page.set_viewport_size({"width": width, "height": 768})
        page.goto(f"{lab.url}/lab/workspaces/narrow{width}/tree/narrow.ipynb")
        page.wait_for_selector(".tflab-page")
        page.wait_for_timeout(500)
        assert page.evaluate("jupyterapp.shell.leftCollapsed") is is_folded
        page.evaluate("jupyterapp.shell.expandLeft()")
        page.wait_for_timeout(500)
        assert page.evaluate("jupyterapp.shell.leftCollapsed") is False
