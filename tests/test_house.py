"""Is the house in order?  Imports point one way, pages are short, one name is one thing.

rooms     core <- views, ros <- robots, bags <- doctor <- tools <- clinic <- workbook <- grading
folders   the same, inside a room
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

# A room may import from the rooms named after it, and from itself; they stand in the order in which one reads them.
ROOMS = {
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

# A folder may import from the folders named after it, from itself, and from the room's own pages where "." is named.
FOLDERS = {
    "views/scene": {"."},
    "views/panels": {".", "scene"},
    "ros/messages": {"."},
    "ros/tf2": {".", "messages"},
    "robots/faults": {"."},
    "doctor/checks": {"."},
    "doctor/report": {".", "checks"},
    "doctor/gate": {".", "checks", "report"},
    "workbook/answers": {"."},
    "workbook/tasks": {".", "answers"},
    "workbook/mistakes": {".", "answers", "tasks"},
    "workbook/explaining": {".", "answers", "tasks", "mistakes"},
    "workbook/verdicts": {".", "answers", "tasks", "mistakes", "explaining"},
    "workbook/inventory": {".", "answers", "tasks", "verdicts"},
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

# One name for two classes, each for its reason.
SHARED_NAMES = {
    "BufferCore": "tf2_py's face of the engine's class, under its name",
    "Clock": "rclpy's class, and the clock of a recording",
    "Message": "what every ROS message is, and the form of an answer that is one",
    "Service": "rclpy's class, and what a service is made of",
    "Task": "rclpy's class, and a task of the workbook",
    "TimeoutException": "rclpy's class, and tf2's",
}

LONGEST_PAGE = 400  # lines
BROKEN_WORD = r"\w+[a-z]-\n\s*[a-z]\w+"
MOST_COMPLEX = 15  # McCabe's number, as radon counts it
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


PAGES = {name_of(path): path for path in sorted(ROOT.rglob("*.py"))}
ALL_FILES = sorted(ROOT.rglob("*.py"))


@lru_cache
def tree_of(path: Path) -> ast.Module:
    return ast.parse(path.read_text(encoding="utf-8"))


def docstring_of(path: Path) -> str:
    return ast.get_docstring(tree_of(path)) or ""


@lru_cache
def imported_by(path: Path) -> frozenset[str]:
    """Return what of tflab a page imports, wherever in it the import stands: in a function, for type checking."""
    package = ["tflab", *path.relative_to(ROOT).parts[:-1]]
    names = set()
    for node in ast.walk(tree_of(path)):
        if isinstance(node, ast.Import):
            names |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            base = package[: len(package) - node.level + 1] if node.level else []
            module = ".".join([*base, node.module] if node.module else base)
            pages = {f"{module}.{alias.name}" for alias in node.names}
            names |= {page if page in PAGES else module for page in pages}
    return frozenset(name for name in names if name.split(".")[0] == "tflab")


# -- walls ----------------------------------------------------------------


def room_of(path: Path) -> str:
    return path.relative_to(ROOT).parts[0]


def folder_of(name: str) -> str:
    """Return the folder of a page below its room: "scene" of tflab.views.scene.state, "." of tflab.views.style."""
    parts = PAGES[name].relative_to(ROOT).parts
    return parts[1] if len(parts) > 2 else "."


@pytest.mark.parametrize("room", sorted(ROOMS))
def test_a_room_imports_only_from_the_rooms_above_it(room: str) -> None:
    for path in (ROOT / room).rglob("*.py"):
        rooms = {name.split(".")[1] for name in imported_by(path) if "." in name} & set(ROOMS)
        assert rooms <= ROOMS[room] | {room}, path


@pytest.mark.parametrize("folder", sorted(FOLDERS))
def test_a_folder_imports_only_from_those_it_may(folder: str) -> None:
    room, own = folder.split("/")
    pages = [name for name, path in PAGES.items() if room_of(path) == room and folder_of(name) == own]
    assert pages, "there is no such folder"
    for name in pages:
        neighbours = {other for other in imported_by(PAGES[name]) if other.startswith(f"tflab.{room}")}
        assert {folder_of(other) for other in neighbours} <= FOLDERS[folder] | {own}, name


def test_every_room_and_every_folder_that_exists_has_its_rule() -> None:
    folders = {path.parent.relative_to(ROOT) for path in PAGES.values()} - {Path()}
    assert {str(folder) for folder in folders if len(folder.parts) == 1} == set(ROOMS)
    assert {folder.as_posix() for folder in folders if len(folder.parts) == 2} == set(FOLDERS)
    assert not [folder for folder in folders if len(folder.parts) > 2]


def test_no_imports_run_in_a_circle() -> None:
    graph = {name: imported_by(path) & set(PAGES) - {name} for name, path in PAGES.items()}
    try:
        TopologicalSorter(graph).prepare()
    except CycleError as error:
        pytest.fail(" -> ".join(error.args[1]))


# -- pages ----------------------------------------------------------------


def test_a_page_is_short_and_says_what_it_is() -> None:
    lines = {path: path.read_text(encoding="utf-8").count("\n") for path in ALL_FILES}
    assert {name_of(path): n for path, n in lines.items() if n > LONGEST_PAGE} == {}
    assert [path for path, n in lines.items() if n and not docstring_of(path)] == []


def test_no_function_has_more_branches_than_a_reader_can_hold() -> None:
    hard = {}
    for name, path in PAGES.items():
        blocks = cc_visit(path.read_text(encoding="utf-8"))
        functions = [inner for block in blocks for inner in (block, *getattr(block, "methods", ()))]
        hard |= {f"{name}.{f.name}": f.complexity for f in functions if f.letter != "C" and f.complexity > MOST_COMPLEX}
    assert hard == {}


def test_no_docstring_breaks_a_word_over_a_line() -> None:
    documented = (ast.Module, ast.ClassDef, ast.FunctionDef, ast.AsyncFunctionDef)
    broken = {}
    for name, path in PAGES.items():
        for node in ast.walk(tree_of(path)):
            words = isinstance(node, documented) and re.findall(BROKEN_WORD, ast.get_docstring(node) or "")
            broken |= {name: words} if words else {}
    assert broken == {}


def test_a_class_name_stands_for_one_thing() -> None:
    where = defaultdict(set)
    for name, path in PAGES.items():
        for node in ast.walk(tree_of(path)):
            if isinstance(node, ast.ClassDef):
                where[node.name].add(name)
    shared = {word: sorted(pages) for word, pages in where.items() if len(pages) > 1}
    assert set(shared) == set(SHARED_NAMES), shared


@pytest.mark.parametrize("folder", sorted([*ROOMS, *FOLDERS]))
def test_the_face_of_a_folder_names_each_of_its_pages(folder: str) -> None:
    named = set(re.findall(r"\w+", docstring_of(ROOT / folder / "__init__.py")))
    pages = {path.stem for path in (ROOT / folder).glob("*.py")} - {"__init__"}
    folders = {path.parent.name for path in (ROOT / folder).glob("*/__init__.py")}
    assert pages | folders <= named, (pages | folders) - named


def test_the_rooms_stand_in_one_order_wherever_they_are_listed() -> None:
    rooms = "|".join(ROOMS)
    package = re.findall(rf"^    ({rooms}) ", docstring_of(ROOT / "__init__.py"), re.MULTILINE)
    readme = re.findall(rf"^\| `tflab\.({rooms})` ", (PROJECT / "README.md").read_text(encoding="utf-8"), re.MULTILINE)
    working = re.findall(rf"^({rooms})  ", (PROJECT / "CONTRIBUTING.md").read_text(encoding="utf-8"), re.MULTILINE)
    assert package == readme == working == list(ROOMS)


# -- what it costs to come in ---------------------------------------------


@pytest.mark.parametrize("code", ["import tflab", "import tflab.core", "import tflab.cli"])
def test_importing_the_engine_loads_nothing_heavy(code: str) -> None:
    probe = f"import sys; {code}; print(*{{name.split('.')[0] for name in sys.modules}})"
    loaded = set(
        subprocess.run([sys.executable, "-c", probe], capture_output=True, text=True, check=True).stdout.split()
    )
    assert not loaded & HEAVY


@pytest.mark.parametrize("name", sorted(PAGES))
def test_everything_a_module_promises_is_there(name: str) -> None:
    module = importlib.import_module(name)
    for promised in getattr(module, "__all__", ()):
        assert hasattr(module, promised), f"{name}.__all__ names {promised!r}"
