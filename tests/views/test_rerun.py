"""A view of a cell that runs again is closed, and what a learner computed stays."""

from __future__ import annotations

import weakref
from types import SimpleNamespace

import pytest
from IPython.core.interactiveshell import InteractiveShell

from tflab.views import rerun
from tflab.views.panels import rotation_panel
from tflab.views.picture import Picture


@pytest.fixture
def shell(monkeypatch: pytest.MonkeyPatch):
    there = InteractiveShell()
    monkeypatch.setattr(rerun, "_shell", lambda: there)
    rerun.register(there)
    there.user_ns.update(Picture=Picture, rotation_panel=rotation_panel)
    yield there
    there.history_manager.save_thread = None


def results(shell: InteractiveShell) -> list[int]:
    return sorted(shell.user_ns["_oh"])


def test_a_picture_of_a_cell_that_runs_again_is_let_go(shell: InteractiveShell) -> None:
    shell.run_cell("Picture()", store_history=True, cell_id="a")
    first = weakref.ref(shell.user_ns["_oh"][1])
    shell.run_cell("Picture()", store_history=True, cell_id="b")
    shell.run_cell("Picture()", store_history=True, cell_id="a")
    assert results(shell) == [2, 3]
    assert "_1" not in shell.user_ns and "_1" not in shell.user_ns_hidden
    for number in range(4, 4 + rerun.SWEEP_AFTER):  # `_`, `__` and `___` hold on to the last three
        shell.run_cell("Picture()", store_history=True, cell_id=f"c{number}")
        shell.run_cell("Picture()", store_history=True, cell_id=f"c{number}")
    assert first() is None


def test_a_panel_of_a_cell_that_runs_again_is_closed(shell: InteractiveShell) -> None:
    shell.run_cell("rotation_panel()", store_history=True, cell_id="a")
    panel = shell.user_ns["_oh"][1]
    assert panel.widget.comm is not None
    shell.run_cell("rotation_panel()", store_history=True, cell_id="a")
    assert panel.widget.comm is None


def test_what_a_learner_computed_stays_and_a_cell_without_an_id_is_known_by_its_text(shell: InteractiveShell) -> None:
    shell.run_cell("[1, 2]", store_history=True, cell_id="a")
    shell.run_cell("[3, 4]", store_history=True, cell_id="a")
    assert shell.user_ns["_oh"] == {1: [1, 2], 2: [3, 4]}
    shell.run_cell("Picture()", store_history=True)
    shell.run_cell("Picture()", store_history=True)
    assert results(shell) == [1, 2, 4]


def test_a_cell_that_ran_outside_a_notebook_is_no_matter(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(rerun, "_shell", lambda: None)
    rerun._remember(
        SimpleNamespace(result=Picture(), execution_count=1, info=SimpleNamespace(cell_id="x", raw_cell=""))
    )
    rerun._forget(SimpleNamespace(cell_id="x", raw_cell=""))
