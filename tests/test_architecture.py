"""Test the architecture: packages import one way, modules are short, a class name is used once.

packages      core <- views, ros <- robots, bags <- doctor <- tools <- clinic <- workbook <- grading
subpackages   the same inside a package
"""

from __future__ import annotations

import ast
import importlib
import re
import subprocess
import sys
from collections import defaultdict
from functools import lru_cache
from graphlib import CycleError, TopologicalSorter
from pathlib import Path

import pytest
from radon.complexity import cc_visit

import tflab

ROOT = Path(tflab.__file__).parent
PROJECT = ROOT.parent

# What each package may import besides itself, in reading order.
PACKAGES = {
    "core": set(),
    "views": {"core"},
    "ros": {"core"},
    "robots": {"core", "ros"},
    "bags": {"core", "ros"},
    "doctor": {"core", "views", "ros", "robots", "bags"},
    "tools": {"core", "views", "ros", "robots", "bags", "doctor"},
    "clinic": {"core", "views", "ros", "robots", "bags", "doctor", "tools"},
    "workbook": {"core", "views", "ros", "robots", "bags", "doctor", "tools", "clinic"},
    "grading": {"core", "views", "workbook"},
}

# What each subpackage may import besides itself; "." stands for the package's own modules.
SUBPACKAGES = {
    "views/scene": {"."},
    "views/panels": {".", "scene"},
    "ros/messages": {"."},
    "ros/tf2": {".", "messages"},
    "robots/faults": {"."},
    "doctor/checks": {"."},
    "doctor/report": {".", "checks"},
    "doctor/ci": {".", "checks", "report"},
    "workbook/answers": {"."},
    "workbook/tasks": {".", "answers"},
    "workbook/diagnosis": {".", "answers", "tasks"},
    "workbook/inventory": {".", "answers", "tasks", "diagnosis"},
    "workbook/course": {".", "answers", "tasks", "inventory"},
    "workbook/book": {".", "course"},
    "workbook/pages": {".", "answers", "tasks", "inventory", "course", "book"},
    "workbook/copy": {".", "answers", "tasks", "course", "pages"},
    "workbook/lesson": {".", "course", "copy"},
    "grading/submissions": set(),
    "grading/kernels": {"submissions"},
    "grading/judging": {"submissions", "kernels"},
    "grading/reports": {"submissions"},
    "grading/guide": {"submissions", "reports"},
}

# Class names used more than once, with the reason.
SHARED_NAMES = {
    "BufferCore": "tf2_py's class around the engine's class of the same name",
    "Clock": "rclpy's class, and the clock of a recording",
    "Message": "what every ROS message is, and the form of an answer that is one",
    "Question": "an answer to be explained, and a question about the order of rotations",
    "Service": "rclpy's class, and what a service is made of",
    "Task": "rclpy's class, and a task of the workbook",
    "TimeoutException": "rclpy's class, and tf2's",
}

MAX_LINES = 400  # lines
BROKEN_WORD = r"\w+[a-z]-\n\s*[a-z]\w+"
MAX_COMPLEXITY = 15  # cyclomatic complexity, by radon
HEAVY = {
    "matplotlib",
    "ipywidgets",
    "anywidget",
    "meshcat",
    "rosbags",
    "jupyterlab",
    "IPython",
    "scipy",
    "nbval",
    "yaml",
}


def name_of(path: Path) -> str:
    return ".".join(path.relative_to(PROJECT).with_suffix("").parts).removesuffix(".__init__")


MODULES = {name_of(path): path for path in sorted(ROOT.rglob("*.py"))}


@lru_cache
def tree_of(path: Path) -> ast.Module:
    return ast.parse(path.read_text(encoding="utf-8"))


def docstring_of(path: Path) -> str:
    return ast.get_docstring(tree_of(path)) or ""


@lru_cache
def imported_by(path: Path) -> frozenset[str]:
    """Return the modules of tflab that a module imports, also inside functions and for type checking."""
    package = ["tflab", *path.relative_to(ROOT).parts[:-1]]
    names = set()
    for node in ast.walk(tree_of(path)):
        if isinstance(node, ast.Import):
            names |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            base = package[: len(package) - node.level + 1] if node.level else []
            module = ".".join([*base, node.module] if node.module else base)
            members = {f"{module}.{alias.name}" for alias in node.names}
            names |= {member if member in MODULES else module for member in members}
    return frozenset(name for name in names if name.split(".")[0] == "tflab")


# -- imports --------------------------------------------------------------


def subpackage_of(name: str) -> str:
    """Return the subpackage of a module: "scene" of tflab.views.scene.state, "." of tflab.views.style."""
    parts = MODULES[name].relative_to(ROOT).parts
    return parts[1] if len(parts) > 2 else "."


@pytest.mark.parametrize("package", sorted(PACKAGES))
def test_a_package_imports_only_packages_above_it(package: str) -> None:
    for path in (ROOT / package).rglob("*.py"):
        imported = {name.split(".")[1] for name in imported_by(path) if "." in name} & set(PACKAGES)
        assert imported <= PACKAGES[package] | {package}, path


@pytest.mark.parametrize("subpackage", sorted(SUBPACKAGES))
def test_a_subpackage_imports_only_what_its_rule_allows(subpackage: str) -> None:
    package, own = subpackage.split("/")
    modules = [name for name in MODULES if name.startswith(f"tflab.{package}") and subpackage_of(name) == own]
    assert modules, "there is no such folder"
    for name in modules:
        imported = {other for other in imported_by(MODULES[name]) if other.startswith(f"tflab.{package}")}
        assert {subpackage_of(other) for other in imported} <= SUBPACKAGES[subpackage] | {own}, name


def test_every_package_and_subpackage_has_an_import_rule() -> None:
    folders = {path.parent.relative_to(ROOT) for path in MODULES.values()} - {Path()}
    assert {str(folder) for folder in folders if len(folder.parts) == 1} == set(PACKAGES)
    assert {folder.as_posix() for folder in folders if len(folder.parts) == 2} == set(SUBPACKAGES)
    assert not [folder for folder in folders if len(folder.parts) > 2]


def test_no_imports_are_circular() -> None:
    graph = {name: imported_by(path) & set(MODULES) - {name} for name, path in MODULES.items()}
    try:
        TopologicalSorter(graph).prepare()
    except CycleError as error:
        pytest.fail(" -> ".join(error.args[1]))


# -- modules --------------------------------------------------------------


def test_modules_are_short_and_have_a_docstring() -> None:
    lines = {name: path.read_text(encoding="utf-8").count("\n") for name, path in MODULES.items()}
    assert {name: n for name, n in lines.items() if n > MAX_LINES} == {}
    assert [name for name, n in lines.items() if n and not docstring_of(MODULES[name])] == []


def test_no_function_is_too_complex() -> None:
    hard = {}
    for name, path in MODULES.items():
        blocks = cc_visit(path.read_text(encoding="utf-8"))
        functions = [inner for block in blocks for inner in (block, *getattr(block, "methods", ()))]
        hard |= {
            f"{name}.{f.name}": f.complexity for f in functions if f.letter != "C" and f.complexity > MAX_COMPLEXITY
        }
    assert hard == {}


def test_no_docstring_breaks_a_word_over_a_line() -> None:
    documented = (ast.Module, ast.ClassDef, ast.FunctionDef, ast.AsyncFunctionDef)
    broken = {}
    for name, path in MODULES.items():
        for node in ast.walk(tree_of(path)):
            words = isinstance(node, documented) and re.findall(BROKEN_WORD, ast.get_docstring(node) or "")
            broken |= {name: words} if words else {}
    assert broken == {}


def test_a_class_name_is_used_once() -> None:
    where = defaultdict(set)
    for name, path in MODULES.items():
        for node in ast.walk(tree_of(path)):
            if isinstance(node, ast.ClassDef):
                where[node.name].add(name)
    shared = {word: sorted(modules) for word, modules in where.items() if len(modules) > 1}
    assert set(shared) == set(SHARED_NAMES), shared


@pytest.mark.parametrize("folder", sorted([*PACKAGES, *SUBPACKAGES]))
def test_the_docstring_of_a_package_names_each_module(folder: str) -> None:
    named = set(re.findall(r"\w+", docstring_of(ROOT / folder / "__init__.py")))
    modules = {path.stem for path in (ROOT / folder).glob("*.py")} - {"__init__"}
    subpackages = {path.parent.name for path in (ROOT / folder).glob("*/__init__.py")}
    assert modules | subpackages <= named, (modules | subpackages) - named


def test_packages_are_listed_in_one_order_everywhere() -> None:
    names = "|".join(PACKAGES)
    package = re.findall(rf"^    ({names}) ", docstring_of(ROOT / "__init__.py"), re.MULTILINE)
    readme = re.findall(rf"^\| `tflab\.({names})` ", (PROJECT / "README.md").read_text(encoding="utf-8"), re.MULTILINE)
    working = re.findall(rf"^({names})  ", (PROJECT / "CONTRIBUTING.md").read_text(encoding="utf-8"), re.MULTILINE)
    assert package == readme == working == list(PACKAGES)


# -- imports of the installed package -------------------------------------


@pytest.mark.parametrize("code", ["import tflab", "import tflab.core", "import tflab.cli"])
def test_importing_the_engine_loads_nothing_heavy(code: str) -> None:
    probe = f"import sys; {code}; print(*{{name.split('.')[0] for name in sys.modules}})"
    loaded = set(
        subprocess.run([sys.executable, "-c", probe], capture_output=True, text=True, check=True).stdout.split()
    )
    assert not loaded & HEAVY


def test_each_module_can_be_imported_and_has_all_its_names() -> None:
    modules = [importlib.import_module(name) for name in sorted(MODULES)]
    missing = [
        (module.__name__, one)
        for module in modules
        for one in getattr(module, "__all__", ())
        if not hasattr(module, one)
    ]
    assert missing == []
