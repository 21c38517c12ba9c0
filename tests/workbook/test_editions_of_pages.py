"""The committed pages: both languages agree, stubs score zero, solutions score everything, and nothing is stale."""

from __future__ import annotations

import json
import re
from itertools import cycle
from pathlib import Path

import nbformat
import pytest
from nbclient import NotebookClient

from tflab.workbook.copy.lay_out import lay_out
from tflab.workbook.pages.build import build_pages, sources
from tflab.workbook.pages.editions import lecture_notebook, with_figures
from tflab.workbook.pages.stale import stale
from tflab.workbook.paths import chapters, workbook_data
from tflab.workbook.progress import attempts
from tflab.workbook.tasks.catalog import tasks_of
from tflab.workbook.tasks.task import slug

from .making_pages import TITLE, code, page, text

ROOT = workbook_data()
CHAPTERS = chapters()
STEMS = sorted({path.stem for path in sources(ROOT)})
NOTEBOOKS = [path.relative_to(ROOT).as_posix() for path in sorted(ROOT.glob("*/en/*.ipynb"))]


def cells_of(path: Path) -> list[dict]:
    return json.loads(path.read_text(encoding="utf-8"))["cells"]


def points_of(stem: str) -> dict[str, int]:
    return {name: task.points for name, task in tasks_of(ROOT, stem).items()}


@pytest.mark.parametrize("name", NOTEBOOKS)
def test_a_korean_page_has_the_code_and_the_outputs_of_the_english(name: str) -> None:
    english, korean = (
        json.loads((ROOT / name.replace("/en/", f"/{language}/")).read_text()) for language in ("en", "ko")
    )
    outputs = [output for cell in korean["cells"] for output in cell.get("outputs", ())]
    assert not any("image/png" in output.get("data", ()) for output in outputs)  # a figure is stored once
    en, ko = english["cells"], with_figures(korean, english)["cells"]
    texts = [cell for cell in ko if cell["cell_type"] == "markdown"]
    hangul = [cell["id"] for cell in texts if re.search("[가-힣]", "".join(cell["source"]))]
    assert len(hangul) >= 0.9 * len(texts), sorted({cell["id"] for cell in texts} - set(hangul))
    assert [(cell["id"], cell["cell_type"]) for cell in en] == [(cell["id"], cell["cell_type"]) for cell in ko]
    for ours, theirs in zip(en, ko, strict=True):
        if ours["cell_type"] == "code":
            shared = ("source", "outputs", "execution_count")
            if "translated" in ours["metadata"].get("tags", ()):
                shared = ("source", "execution_count")
                assert re.search("[가-힣]", json.dumps(theirs["outputs"], ensure_ascii=False)), theirs["id"]
                assert not re.search("[가-힣]", json.dumps(ours["outputs"], ensure_ascii=False)), ours["id"]
            assert [ours[key] for key in shared] == [theirs[key] for key in shared], ours["id"]


def test_what_follows_the_core_is_collapsed_and_a_live_view_is_one_cell(tmp_path: Path) -> None:
    source = page(
        tmp_path,
        TITLE,
        text("idea", "## Idea", "## 생각"),
        code("view", "panel()", ' tags=["collapsed", "interactive"]'),
        code("figure", "draw()", ' tags=["static"]'),
        text("core-end", "## Enough to go on", "## 여기까지면 충분합니다"),
        text("more", "## More", "## 더 보기"),
        text("detail", "### A detail", "### 자세히"),
    )
    drawn = {"output_type": "display_data", "data": {"image/png": "AA==", "text/plain": ["a"]}, "metadata": {}}
    cells = lecture_notebook(source, "en", {"view": [drawn]})["cells"]
    metadata = {cell["id"]: cell["metadata"] for cell in cells}
    assert [name for name, one in metadata.items() if "jp-MarkdownHeadingCollapsed" in one] == ["more"]
    assert [name for name, one in metadata.items() if "jupyter" in one] == ["view"]
    assert "figure" not in metadata
    view = next(cell for cell in cells if cell["id"] == "view")
    assert view["outputs"] == [drawn] and "nbval-ignore-output" in view["metadata"]["tags"]


@pytest.mark.proof(
    reads=["exercises/{language}/E{stem}.ipynb", "solutions/tasks/{stem}/*", "solutions/en/{stem}.ipynb"]
)
# In one language each: the other has the same code.
@pytest.mark.parametrize(("stem", "language"), [*zip(CHAPTERS, cycle(("en", "ko")), strict=False)])
def test_an_untouched_exercise_runs_to_its_last_cell_and_scores_zero(stem: str, language: str, tmp_path: Path) -> None:
    root = lay_out(tmp_path / "copy", language)
    path = root / "exercises" / language / f"E{stem}.ipynb"
    page = nbformat.read(path, as_version=4)
    NotebookClient(page, timeout=60, resources={"metadata": {"path": str(path.parent)}}).execute()
    said = {
        cell.id: "".join(output.get("text") or output.data.get("text/plain", "") for output in cell.outputs)
        for cell in page.cells
        if cell.cell_type == "code"
    }
    for task in points_of(stem):
        assert said[f"{slug(task)}-check"], f"{task} says nothing to an empty answer"
        assert not re.search("✓|✗ [1-9]", said[f"{slug(task)}-check"])
        assert attempts(root, task).tries == 0  # three tries open the solution


@pytest.mark.parametrize("stem", CHAPTERS)
def test_a_solution_scores_everything_there_is(stem: str) -> None:
    cells = {cell["id"]: cell for cell in cells_of(ROOT / "solutions" / "en" / f"{stem}.ipynb")}
    for task in points_of(stem):
        (printed,) = cells[f"{slug(task)}-check"]["outputs"]
        score = re.fullmatch(rf"{re.escape(task)} ✓ (\d+)/(\d+)(?: points?)?\n", "".join(printed["text"]))
        assert score, f"{task}: {printed['text']}"
        assert score[1] == score[2] != "0"


@pytest.mark.parametrize("stem", CHAPTERS)
def test_an_exercise_holds_nothing_of_its_solution(stem: str) -> None:
    for language in ("en", "ko"):
        cells = cells_of(ROOT / "exercises" / language / f"E{stem}.ipynb")
        solved = {cell["id"]: cell for cell in cells_of(ROOT / "solutions" / language / f"{stem}.ipynb")}
        for cell in cells:
            assert not cell.get("outputs")
            assert "SOLUTION" not in "".join(cell["source"])
            if "answer" in cell["metadata"].get("tags", ()):
                assert cell["source"] != solved[cell["id"]]["source"]
        if stem != CHAPTERS[0]:
            begins, ends = ("".join(cells[place]["source"]) for place in (0, -1))
            assert f'`solution("E{int(stem[:2])}.1")`' in begins and "`tflab lab`" in begins
            assert re.search(r"\*\*(Next|다음):\*\* \[[^]]+\]\(\.\./\.\./notebooks/", ends)


BUILT = (
    "*/src/{stem}.py",
    "*/*/{stem}.ipynb",
    "exercises/*/E{stem}.ipynb",
    "solutions/tasks/{stem}/*",
    "solutions/inventory.yaml",
    "tflab/**/*.yaml",
)


@pytest.mark.proof(reads=BUILT, texts=True)
@pytest.mark.parametrize("stem", STEMS)
def test_what_is_committed_is_what_the_sources_make(stem: str) -> None:
    built = build_pages(sources(ROOT, [stem]))
    assert [str(fault) for fault in built.faults] == []
    assert stale(ROOT, built.files) == []
