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


def test_the_base_install_names_the_extra_with_jupyterlab_makes_no_copy_and_replies(tmp_path: Path) -> None:
    done = run_without(list(EXTRA_OF), "from tflab.cli import main; main([]); sys.exit(main(['lab']))", tmp_path)
    assert 'Figures and JupyterLab are not installed. Install them with: pip install "tflab[lab]"\n' in done.stdout
    assert done.stderr == 'tflab lab: This needs jupyterlab. Install it with: pip install "tflab[lab]"\n'
    assert done.returncode == 2 and not any(tmp_path.iterdir())
    code = "from tflab.workbook import check; check('E3.2', {'base_link': (1, 0, 0), 'map': (1, 0, 0)})"
    done = run_without(list(EXTRA_OF), code, tmp_path)
    assert done.stdout.startswith("E3.2 ✗") and done.stderr == ""


def test_importing_what_draws_names_the_extra(tmp_path: Path) -> None:
    modules = ("frames", "slider_frames", "panels", "scene", "rviz")
    names = [*(f"tflab.views.{name}" for name in modules), "tflab.clinic.panel", "tflab.workbook.lesson"]
    code = f"""
for name in {names}:
    try:
        __import__(name)
    except ModuleNotFoundError as error:
        print(error)
"""
    said = 'This needs matplotlib. Install it with: pip install "tflab[views]"'
    assert run_without(VIEWS, code, tmp_path).stdout.splitlines() == [said] * len(names)


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
