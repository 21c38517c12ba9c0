"""Is the house in order?  Imports point one way, modules are short and name the next, `import tflab` is light."""

from __future__ import annotations

import ast
import importlib
import re
import subprocess
import sys
from pathlib import Path

import pytest

import tflab

ROOT = Path(tflab.__file__).parent

# A room may import from the rooms named after it, and from itself.
ROOMS = {
    "core": set(),
    "views": {"core"},
    "ros": {"core"},
    "robots": {"core", "ros"},
    "bags": {"core", "ros"},
    "doctor": {"core", "views", "ros", "robots", "bags"},
    "tools": {"core", "views", "ros", "robots", "bags", "doctor"},
    "workbook": {"core", "views", "ros", "robots", "bags", "doctor", "tools"},
    "grading": {"core", "views", "workbook"},
}
ABOUT_400_LINES = 475
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

MODULES = sorted(path for path in ROOT.rglob("*.py"))


def room_of(path: Path) -> str:
    return path.relative_to(ROOT).parts[0]


def tflab_rooms_imported(path: Path) -> set[str]:
    """Return the rooms that a module imports, wherever in it the import stands."""
    package = ["tflab", *path.relative_to(ROOT).parts[:-1]]
    rooms = set()
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            names = [alias.name for alias in node.names]
        elif isinstance(node, ast.ImportFrom):
            base = package[: len(package) - node.level + 1] if node.level else []
            module = ".".join([*base, node.module] if node.module else base)
            names = [f"{module}.{alias.name}" for alias in node.names]
        else:
            continue
        rooms |= {name.split(".")[1] for name in names if name.startswith("tflab.") and name.count(".") >= 1}
    return rooms & set(ROOMS)


@pytest.mark.parametrize("path", [p for p in MODULES if room_of(p) in ROOMS], ids=lambda p: str(p.relative_to(ROOT)))
def test_a_room_imports_only_from_the_rooms_above_it(path: Path) -> None:
    room = room_of(path)
    assert tflab_rooms_imported(path) <= ROOMS[room] | {room}


def test_every_room_that_exists_has_its_rule() -> None:
    folders = {path.name for path in ROOT.iterdir() if (path / "__init__.py").exists()}
    assert folders <= set(ROOMS)


@pytest.mark.parametrize("path", MODULES, ids=lambda p: str(p.relative_to(ROOT)))
def test_a_module_is_short_and_says_what_it_is(path: Path) -> None:
    text = path.read_text(encoding="utf-8")
    assert text.count("\n") <= ABOUT_400_LINES
    assert ast.get_docstring(ast.parse(text)) or not text.strip()


@pytest.mark.parametrize("path", MODULES, ids=lambda p: str(p.relative_to(ROOT)))
def test_the_page_to_read_next_is_there(path: Path) -> None:
    docstring = ast.get_docstring(ast.parse(path.read_text(encoding="utf-8"))) or ""
    for page in pages_to_read_next(docstring):
        assert (path.parent / page).is_file(), f"there is no {page} beside {path}"
        assert path.parent / page != path


def folders_of_pages() -> list[Path]:
    folders = {path.parent for path in MODULES} - {ROOT}
    return sorted(folder for folder in folders if "packages" not in folder.parts)  # those are laid out as ROS's own


@pytest.mark.parametrize("room", folders_of_pages(), ids=lambda p: str(p.relative_to(ROOT)))
def test_every_page_is_named_by_its_room_or_by_the_page_before_it(room: Path) -> None:
    docstrings = {
        page: ast.get_docstring(ast.parse(page.read_text(encoding="utf-8"))) or "" for page in room.glob("*.py")
    }
    named = set(re.findall(r"\w+", docstrings.pop(room / "__init__.py")))
    for docstring in docstrings.values():
        named |= {Path(page).stem for page in pages_to_read_next(docstring)}
    assert {page.stem for page in docstrings} <= named


def pages_to_read_next(docstring: str) -> list[str]:
    """Return the pages that a docstring sends its reader to: "Read `cache.py` next"."""
    return re.findall(r"[Rr]ead\s+`([\w/]+\.py)`\s+next", docstring)


@pytest.mark.parametrize("code", ["import tflab", "import tflab.core", "import tflab.cli"])
def test_importing_the_engine_loads_nothing_heavy(code: str) -> None:
    probe = f"import sys; {code}; print(*{{name.split('.')[0] for name in sys.modules}})"
    loaded = set(
        subprocess.run([sys.executable, "-c", probe], capture_output=True, text=True, check=True).stdout.split()
    )
    assert not loaded & HEAVY


def importable_modules() -> list[str]:
    names = []
    for path in MODULES:
        parts = path.relative_to(ROOT.parent).with_suffix("").parts
        if "packages" not in parts:  # those go by their ROS names: see test_transform_faces.py
            names.append(".".join(parts[:-1] if parts[-1] == "__init__" else parts))
    return names


@pytest.mark.parametrize("name", importable_modules())
def test_everything_a_module_promises_is_there(name: str) -> None:
    module = importlib.import_module(name)
    for promised in getattr(module, "__all__", ()):
        assert hasattr(module, promised), f"{name}.__all__ names {promised!r}"
