"""Nothing asks for a later Python than the oldest that pyproject.toml allows, nor for one of its later libraries."""

from __future__ import annotations

import ast
import re
import sys
from pathlib import Path

ROOT = Path(__file__).parents[1]
FOLDERS = ("tflab", "tests", "solutions", "notebooks/src", "benchmarks", "docs")
FILES = sorted(path for folder in FOLDERS for path in (ROOT / folder).rglob("*.py"))
OLDEST = (3, 10)

# What the standard library has only since 3.11 or later, and a formatter's target does not tell.
LATER = {
    "tomllib": {"*"},
    "enum": {"StrEnum", "ReprEnum", "verify", "nonmember", "member"},
    "datetime": {"UTC"},
    "asyncio": {"TaskGroup", "Runner", "timeout", "timeout_at", "Barrier", "eager_task_factory"},
    "contextlib": {"chdir"},
    "itertools": {"batched"},
    "typing": {"Self", "Never", "LiteralString", "Unpack", "TypeVarTuple", "assert_never", "assert_type", "override"},
    "hashlib": {"file_digest"},
    "math": {"cbrt", "exp2", "sumprod"},
}


def later_than_the_oldest(source: str) -> list[str]:
    """Return what a source asks of the standard library that the oldest Python does not have."""
    found = []
    tree = ast.parse(source)
    chosen = {id(inner) for node in ast.walk(tree) if _asks_for_the_version(node) for inner in ast.walk(node)}
    for node in ast.walk(tree):
        if id(node) in chosen:
            continue
        if isinstance(node, ast.Import):
            found += [name.name for name in node.names if "*" in LATER.get(name.name, ())]
        elif isinstance(node, ast.ImportFrom):
            names = LATER.get(node.module or "", set())
            found += [f"{node.module}.{name.name}" for name in node.names if name.name in names or "*" in names]
        elif isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name):
            found += [f"{node.value.id}.{node.attr}"] if node.attr in LATER.get(node.value.id, ()) else []
    return found


def _asks_for_the_version(node: ast.AST) -> bool:
    return isinstance(node, ast.If) and "version_info" in ast.dump(node.test)


def test_the_oldest_python_is_the_same_wherever_it_is_named() -> None:
    project = (ROOT / "pyproject.toml").read_text(encoding="utf-8")
    oldest = ".".join(map(str, OLDEST))
    assert f'requires-python = ">={oldest}"' in project
    assert f'target-version = "py{oldest.replace(".", "")}"' in project
    assert f"Programming Language :: Python :: {oldest}" in project
    assert f"(3, {OLDEST[1]})" in (ROOT / "Makefile").read_text(encoding="utf-8")
    for name in ("README.md", "README.ko.md"):
        assert re.search(rf"(Python|파이썬) {oldest}", (ROOT / name).read_text(encoding="utf-8"))


def test_nothing_asks_for_a_later_library() -> None:
    pages = [path for path in FILES if "notebooks" not in path.parts and "lecture" not in path.parts]
    later = {str(path.relative_to(ROOT)): later_than_the_oldest(path.read_text(encoding="utf-8")) for path in pages}
    assert {name: names for name, names in later.items() if names} == {}


def test_what_is_later_is_seen() -> None:
    for source, found in (
        ("from enum import StrEnum", ["enum.StrEnum"]),
        ("import tomllib", ["tomllib"]),
        ("import sys\nif sys.version_info >= (3, 11):\n    import tomllib\nelse:\n    import tomli", []),
        ("import asyncio\nasyncio.TaskGroup()", ["asyncio.TaskGroup"]),
        ("from enum import Enum", []),
    ):
        assert later_than_the_oldest(source) == found
    assert sys.version_info >= OLDEST
