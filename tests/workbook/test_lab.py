"""`tflab lab`: JupyterLab on the right folder, and silent towards the network."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest

from tflab.workbook import lab


@pytest.fixture
def started(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> list:
    """What would have been started."""
    calls = []
    monkeypatch.chdir(tmp_path)  # and back afterwards
    monkeypatch.setattr(lab, "start_jupyterlab", lambda options: calls.append((options, Path.cwd())))
    return calls


def test_without_a_folder_it_opens_the_first_page_that_comes_with_tflab(started: list) -> None:
    assert lab.lab([]) == 0
    options, folder = started[0]
    assert folder == lab.pages_folder()
    assert f"--LabApp.default_url=/lab/tree/{lab.FIRST_PAGE}" in options
    assert (folder / lab.FIRST_PAGE).exists()


def test_a_folder_of_ones_own_and_options_for_jupyterlab_are_passed_on(started: list, tmp_path: Path) -> None:
    assert lab.lab([str(tmp_path), "--", "--no-browser"]) == 0
    options, folder = started[0]
    assert folder == tmp_path
    assert options[-1] == "--no-browser"
    assert not any("default_url" in word for word in options)


def test_a_folder_that_is_not_there_is_said_and_nothing_is_started(started: list, capsys) -> None:
    assert lab.lab(["/no/such/folder"]) == 2
    assert "there is no folder /no/such/folder" in capsys.readouterr().err
    assert started == []


def test_installed_from_a_wheel_the_pages_are_those_inside_the_package(monkeypatch, tmp_path: Path) -> None:
    pages = tmp_path / "tflab" / "_workbook" / "notebooks" / "en"
    pages.mkdir(parents=True)
    monkeypatch.setattr(lab, "__file__", str(tmp_path / "tflab" / "workbook" / "lab.py"))
    assert lab.pages_folder() == pages


def test_pages_out_of_a_wheel_are_copied_and_what_was_written_on_the_copy_stays(tmp_path: Path, monkeypatch) -> None:
    monkeypatch.chdir(tmp_path)
    pages = tmp_path / "tflab" / "_workbook" / "notebooks" / "en"
    pages.mkdir(parents=True)
    (pages / "a.ipynb").write_text("as it came")
    copy = lab.own_copy(pages)
    assert (copy / "a.ipynb").read_text() == "as it came"
    (copy / "a.ipynb").write_text("mine")
    (pages / "b.ipynb").write_text("new")
    assert lab.own_copy(pages) == copy == tmp_path / lab.COPY
    assert (copy / "a.ipynb").read_text() == "mine"
    assert (copy / "b.ipynb").read_text() == "new"


def test_jupyterlab_understands_the_options_that_keep_it_quiet() -> None:
    probe = (
        "import json, sys; from jupyterlab.labapp import LabApp;"
        "app = LabApp(); app.parse_command_line(sys.argv[1:]); app.update_config(app.cli_config);"
        "print(json.dumps([app.news_url, app.check_for_updates_class.__name__, app.extension_manager]))"
    )
    answer = subprocess.run(
        [sys.executable, "-c", probe, *lab.QUIET_OPTIONS], capture_output=True, text=True, check=True
    )
    assert json.loads(answer.stdout) == [None, "NeverCheckForUpdate", "readonly"]


def test_every_cell_of_the_first_page_runs(tmp_path: Path) -> None:
    nbclient = pytest.importorskip("nbclient", reason="no nbclient: pip install 'tflab[dev]'")
    import nbformat

    page = nbformat.read(lab.pages_folder() / lab.FIRST_PAGE, 4)
    nbclient.NotebookClient(page, timeout=60, resources={"metadata": {"path": str(tmp_path)}}).execute()
    outputs = {cell.id: cell.outputs for cell in page.cells if cell.cell_type == "code"}
    assert outputs["load"][0].text == "tflab: in-process ROS 2 (jazzy), virtual time, message fields checked.\n"
    assert "At time 2.950000000\n- Translation: [0.396, 0.940, 0.150]" in "".join(o.text for o in outputs["echo"])
    assert "application/vnd.jupyter.widget-view+json" in outputs["rviz"][0].data
