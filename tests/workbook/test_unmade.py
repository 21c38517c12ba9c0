"""A cell that was run before the one that makes its names: below Python's error, a line says what to run."""

from __future__ import annotations

from pathlib import Path

import pytest
from IPython.core.interactiveshell import InteractiveShell

from tflab.workbook import unmade
from tflab.workbook.places import Workbook, write_workbook


@pytest.fixture
def shell() -> InteractiveShell:
    made = InteractiveShell()
    made.user_ns["check"] = print
    unmade.register(made)
    return made


def said(shell: InteractiveShell, cell: str, capsys: pytest.CaptureFixture) -> tuple[str, str]:
    """Return the error of a cell, and the last line that it left."""
    ran = shell.run_cell(cell, store_history=True)
    return type(ran.error_in_exec).__name__, capsys.readouterr().out.rstrip().splitlines()[-1]


def test_a_check_before_its_answer_says_which_cell_to_run(shell, capsys) -> None:
    error, line = said(shell, 'check("E3.2", base_p_corner)', capsys)
    assert error == "NameError"
    assert line == "base_p_corner: Not there yet. Run the cell above with your answer, then this one again."


def test_what_the_first_cells_make_and_what_any_other_makes_are_told_apart(shell, capsys) -> None:
    assert "the page's first cells" in said(shell, "lesson.draw_room()", capsys)[1]
    assert "look how it is spelt" in said(shell, "print(map_T_laser)", capsys)[1]


def test_it_is_said_in_the_language_of_the_copy(shell, capsys, tmp_path: Path, monkeypatch) -> None:
    write_workbook(tmp_path, Workbook(language="ko"))
    monkeypatch.chdir(tmp_path)
    assert "답을 쓴 위의 셀" in said(shell, "check('E3.2', x)", capsys)[1]


def test_any_other_error_is_pythons_alone(shell, capsys) -> None:
    assert said(shell, "def f():\n    x += 1\nf()", capsys)[0] == "UnboundLocalError"
    assert "Not there" not in said(shell, "1 / 0", capsys)[1]


def test_a_shell_that_treats_its_own_errors_keeps_doing_so() -> None:
    shell = InteractiveShell()
    shell.set_custom_exc((KeyError,), lambda *_, **__: None)
    unmade.register(shell)
    assert shell.custom_exceptions == (KeyError,)


def test_an_answer_that_fails_leaves_none_from_before(capsys) -> None:
    shell = InteractiveShell.instance()
    try:
        unmade.register(shell)
        for made, broken in (("def f(a):\n    return a", "def f(a)\n    return a"), ("x = 1", "x = y + 1")):
            name = made.partition("(")[0].removeprefix("def ").partition(" ")[0]
            shell.run_cell(made, cell_id="e3-3-answer")
            shell.run_cell(broken, cell_id="a cell of my own")
            assert name in shell.user_ns
            shell.run_cell(broken, cell_id="e3-3-answer")
            assert name not in shell.user_ns
    finally:
        InteractiveShell.clear_instance()
