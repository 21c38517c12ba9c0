"""A cell that fails shows the reader's own lines, and a line says which cell has to be run first."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from IPython.core.interactiveshell import InteractiveShell

import tflab
from tflab.workbook import cell_errors
from tflab.workbook.cell_errors import reader_traceback
from tflab.workbook.paths import Workbook, write_workbook


@pytest.fixture
def shell() -> InteractiveShell:
    made = InteractiveShell()
    made.user_ns["check"] = print
    cell_errors.register(made)
    return made


def said(shell: InteractiveShell, cell: str, capsys: pytest.CaptureFixture) -> tuple[str, str]:
    """Return the error of a cell, and the last line that it left."""
    ran = shell.run_cell(cell, store_history=True)
    return type(ran.error_in_exec).__name__, capsys.readouterr().out.rstrip().splitlines()[-1]


def plain(text: str) -> str:
    """Return what was printed in colours, without them."""
    return re.sub(r"\x1b\[[0-9;]*m", "", text)


def test_a_check_before_its_answer_says_which_cell_to_run(shell, capsys, tmp_path: Path, monkeypatch) -> None:
    error, line = said(shell, 'check("E3.2", base_p_corner)', capsys)
    assert error == "NameError"
    assert line == "base_p_corner: It does not exist yet. Run the cell above with your answer, then this one again."
    write_workbook(tmp_path, Workbook(language="ko"))
    monkeypatch.chdir(tmp_path)
    assert "답을 쓴 위의 셀" in said(shell, "check('E3.2', x)", capsys)[1]


def test_what_the_first_cells_make_and_what_any_other_makes_are_told_apart(shell, capsys) -> None:
    line = said(shell, "lesson.draw_room()", capsys)[1]
    assert "Run `from tflab.workbook import lesson`" in line  # check is there: the first cell has run
    del shell.user_ns["check"]
    assert "the page's first cells" in said(shell, "lesson.draw_room()", capsys)[1]
    assert "check the spelling" in said(shell, "print(map_T_laser)", capsys)[1]


def test_a_misspelt_name_of_ours_is_told(shell, capsys) -> None:
    for name, meant in (("chek", "check"), ("grpah", "graph")):
        assert said(shell, f"{name}('E1.1')", capsys)[1] == f"{name}: Did you mean `{meant}`?"


def test_what_a_task_gives_is_found_where_it_is_and_what_it_does_not_give_is_told(shell, capsys) -> None:
    given = "SimpleNamespace(base_p_laser=(1.0,), laser_p_post=(2.0,))"
    shell.run_cell(f"from types import SimpleNamespace\ne1_1 = {given}")
    for cell, tip in (
        ("base_p_laser[0]", "as a part of e1_1: `e1_1.base_p_laser`."),
        ("e1_1.laser_p_pst", "`e1_1.laser_p_pst` is not given. Did you mean `e1_1.laser_p_post`?"),
        ("e1_1.speed", "What is given: `e1_1.base_p_laser`, `e1_1.laser_p_post`."),
    ):
        assert said(shell, cell, capsys)[1].endswith(tip)
    assert "check the spelling" in said(shell, "base_p_lasr", capsys)[1]


ODD = "class Odd(Exception):\n    def __eq__(self, other):\n        raise TypeError\nraise Odd('no') from Odd('way')"


@pytest.mark.parametrize(
    ("cell", "tip"),
    [
        ("[1.0] - [2.0]", "the members one by one"),
        ("'1' - 2", "`float(text)` converts a text to a number"),
        ("raise RuntimeError('Context.init() must only be called once')", "with `rclpy.try_shutdown()`, then"),
        ("len(3)", "TypeError: "),
        ("def f():\n    x += 1\nf()", "UnboundLocalError: "),
        ("1 / 0", "ZeroDivisionError: "),
        (ODD, "Odd: no"),  # it calls itself equal to nothing
    ],
)
def test_an_error_has_the_tip_that_check_has_or_is_pythons_alone(shell, capsys, cell: str, tip: str) -> None:
    last = plain(said(shell, cell, capsys)[1])
    assert last.startswith(tip) if tip[0].isupper() else tip in last


def test_an_error_is_shown_as_far_as_the_readers_own_lines_go(shell, capsys) -> None:
    asks = "from tflab.core import BufferCore\ndef ask():\n    BufferCore().lookup_transform('map', 'odom', 0)\nask()"
    assert said(shell, asks, capsys)[0] == "LookupException"
    shell.run_cell(asks)
    shown = plain(capsys.readouterr().out)
    assert "in ask()" in shown
    assert "tflab/core" not in shown
    shell.run_line_magic("xmode", "Verbose")
    shell.run_cell(asks)
    assert "tflab/core" in plain(capsys.readouterr().out)


def test_the_readers_own_lines_below_ours_are_shown_and_another_librarys_too(shell, capsys) -> None:
    shell.run_cell(
        "import fractions\nfrom tflab.text import Text\n"
        "class Mine(str):\n    def format(self, **names):\n        fractions.Fraction('x')\n"
        "Text(Mine('a'), 'b').say('en', x=1)"
    )
    shown = plain(capsys.readouterr().out)
    assert "in Mine.format(" in shown
    assert "text.py" not in shown
    assert "fractions.py" in shown


def test_a_readers_module_in_a_copy_beside_the_package_is_the_readers() -> None:
    beside = f"{Path(tflab.__file__).parent}_workbook/notebooks/mine.py"
    try:
        exec(compile("1 / 0", beside, "exec"), {})
    except ZeroDivisionError as error:
        assert reader_traceback(error.__traceback__.tb_next).tb_frame.f_code.co_filename == beside


def test_a_shell_that_treats_its_own_errors_keeps_doing_so() -> None:
    shell = InteractiveShell()
    shell.set_custom_exc((KeyError,), lambda *_, **__: None)
    cell_errors.register(shell)
    assert shell.custom_exceptions == (KeyError,)


def test_an_answer_that_fails_leaves_none_from_before(capsys) -> None:
    shell = InteractiveShell.instance()
    shell.user_ns["check"] = print
    try:
        cell_errors.register(shell)
        for made, broken in (("def f(a):\n    return a", "def f(a)\n    return a"), ("x = 1", "x = y + 1")):
            name = made.partition("(")[0].removeprefix("def ").partition(" ")[0]
            shell.run_cell(made, cell_id="e3-3-answer")
            shell.run_cell(broken, cell_id="a cell of my own")
            assert name in shell.user_ns
            shell.run_cell(broken, cell_id="e3-3-answer")
            assert name not in shell.user_ns
            assert "stopped with an error" in said(shell, f"check('E3.3', {name})", capsys)[1]
            shell.run_cell(made, cell_id="e3-3-answer")
            assert "stopped" not in said(shell, f"del {name}\ncheck('E3.3', {name})", capsys)[1]
    finally:
        InteractiveShell.clear_instance()
