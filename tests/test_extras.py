"""The base install and tflab[bags] work without the libraries that draw, and an error names the missing extra."""

from __future__ import annotations

import ast
import subprocess
import sys
from pathlib import Path

import pytest

import tflab
from tflab.bags.info import example_bag
from tflab.extras import EXTRA_OF, hint, require

ROOT = Path(tflab.__file__).parent
VIEWS = [library for library, extra in EXTRA_OF.items() if extra == "views"]
NOT_IN_BAGS = [library for library, extra in EXTRA_OF.items() if extra != "bags"]


def run_without(libraries: list[str], code: str, folder: Path) -> subprocess.CompletedProcess[str]:
    """Run code in a process in which these libraries cannot be imported."""
    block = f"import sys; sys.modules.update(dict.fromkeys({libraries}))\n"
    return subprocess.run([sys.executable, "-c", block + code], cwd=folder, capture_output=True, text=True)


@pytest.mark.parametrize(
    "words", [["--help"], ["doctor", str(example_bag())], ["doctor", str(example_bag()), "--html", "report.html"]]
)
def test_command_runs_with_the_bags_extra_alone(words: list[str], tmp_path: Path) -> None:
    done = run_without(NOT_IN_BAGS, f"from tflab.cli import main; sys.exit(main({words}))", tmp_path)
    assert (done.returncode, done.stderr) == (0, "")
    assert "--html" not in words or "</html>" in (tmp_path / "report.html").read_text(encoding="utf-8")


def test_help_of_the_base_install_names_the_extra_with_jupyterlab(tmp_path: Path) -> None:
    done = run_without(list(EXTRA_OF), "from tflab.cli import main; main([])", tmp_path)
    assert 'Figures and JupyterLab are not installed. Install them with: pip install "tflab[lab]"\n' in done.stdout


def test_lab_of_the_base_install_names_the_extra_and_makes_no_copy(tmp_path: Path) -> None:
    done = run_without(list(EXTRA_OF), "from tflab.cli import main; sys.exit(main(['lab']))", tmp_path)
    assert done.stderr == 'tflab lab: This needs jupyterlab. Install it with: pip install "tflab[lab]"\n'
    assert done.returncode == 2 and not any(tmp_path.iterdir())


def test_check_replies_in_plain_python_without_any_extra(tmp_path: Path) -> None:
    code = "from tflab.workbook import check; check('E3.2', {'base_link': (1, 0, 0), 'map': (1, 0, 0)})"
    done = run_without(list(EXTRA_OF), code, tmp_path)
    assert done.stdout.startswith("E3.2 ✗") and done.stderr == ""


@pytest.mark.parametrize(
    "module",
    [
        "views.frames",
        "views.slider_frames",
        "views.panels",
        "views.scene",
        "views.rviz",
        "clinic.panel",
        "workbook.lesson",
    ],
)
def test_importing_what_draws_names_the_extra(module: str, tmp_path: Path) -> None:
    done = run_without(VIEWS, f"import tflab.{module}", tmp_path)
    last = done.stderr.splitlines()[-1]
    assert last == 'ModuleNotFoundError: This needs matplotlib. Install it with: pip install "tflab[views]"'


def test_a_hint_names_the_library_of_a_module_and_only_ours() -> None:
    assert hint("rosbags.rosbag2") == 'This needs rosbags. Install it with: pip install "tflab[bags]"'
    assert hint("their_package") is None
    require("numpy")


def test_libraries_that_draw_are_imported_late_or_through_one_module() -> None:
    early = {}
    for path in ROOT.rglob("*.py"):
        for node in ast.parse(path.read_text(encoding="utf-8")).body:
            names = [alias.name for alias in node.names] if isinstance(node, ast.Import) else []
            names += [node.module or ""] if isinstance(node, ast.ImportFrom) and not node.level else []
            if {name.partition(".")[0] for name in names} & set(VIEWS):
                early[path.relative_to(ROOT).as_posix()] = names
    assert set(early) == {"views/libraries.py", "views/number_table.py"}  # number_table.py is imported after picture.py
