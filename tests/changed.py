"""Print the test files that an edit can reach: `python tests/changed.py [BASE]`.

The edit is the difference between the working tree and BASE (HEAD if left out), and the new
files. A test file is reached if it imports a changed module, directly or through others. A
test that is left out as proved before and unchanged (`conftest.py`) is left out here, too.

    an edit in tflab/doctor       all test files that import the doctor
    an edit in solutions/tasks    the tests that read tasks; of these, only the chapter's are stale
    data beside a module          the tests of its package
    pyproject.toml, …             all tests
"""

from __future__ import annotations

import ast
import subprocess
import sys
from functools import cache
from pathlib import Path

import yaml

ROOT = Path(__file__).parents[1]
MODULES = {
    path.relative_to(ROOT).with_suffix("").as_posix().removesuffix("/__init__").replace("/", "."): path
    for folder in ("tflab", "tests")
    for path in sorted((ROOT / folder).rglob("*.py"))
}
IN_PROCESS = yaml.safe_load((ROOT / "tflab/ros/packages.yaml").read_text(encoding="utf-8"))  # what `import rclpy` finds
READ_PAGES = {"tests.workbook.each_task", "tests.workbook.test_editions_of_pages", "tests.workbook.whole_answers"}
PAGES = ("solutions/", "exercises/", "notebooks/")
EVERYTHING = {"conftest.py", "tests/conftest.py", "constraints.txt", "pyproject.toml"}
ON_TOP = sorted((ROOT / "tests").glob("test_*.py"))


def changed_files(base: str) -> list[str]:
    """Return the files that differ from a commit, and those that are new."""
    outputs = [
        subprocess.run(["git", *words], cwd=ROOT, check=True, capture_output=True, text=True).stdout
        for words in (["diff", "--name-only", base], ["ls-files", "--others", "--exclude-standard"])
    ]
    return [name for output in outputs for name in output.splitlines()]


@cache
def imported_by(module: str) -> frozenset[str]:
    """Return the modules of tflab and the tests that a module imports, wherever the import is."""
    path = MODULES[module]
    package = module.split(".") if path.name == "__init__.py" else module.split(".")[:-1]
    names = set()
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            names |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            base = package[: len(package) - node.level + 1] if node.level else []
            found = ".".join([*base, node.module] if node.module else base)
            names |= {found, *(f"{found}.{alias.name}" for alias in node.names)}
        elif isinstance(node, ast.Constant) and isinstance(node.value, str):
            names.add(node.value)  # `import_module("tflab.doctor.command")`
    for package in {name.partition(".")[0] for name in names}:
        names |= served_by(package)
    return frozenset(name for name in names if name in MODULES)


@cache
def served_by(package: str) -> frozenset[str]:
    """Return the modules of tflab that serve a package of ROS."""
    rows = [row for name, row in IN_PROCESS.items() if name.partition(".")[0] == package]
    return frozenset({f"tflab.ros.messages.{package}", *(source for row in rows for source in row)})


def reached_from(module: str) -> set[str]:
    """Return a module and all that it imports, directly or through others."""
    found, waiting = set(), [module]
    while waiting:
        name = waiting.pop()
        if name not in found:
            found.add(name)
            waiting += imported_by(name)
    return found


def tests_reached(changed: list[str]) -> list[Path]:
    """Return the test files for which a change matters."""
    names = {name for name, path in MODULES.items() if path.relative_to(ROOT).as_posix() in changed}
    if any(name.startswith(PAGES) for name in changed):
        names |= READ_PAGES
    tests = {path: name for name, path in MODULES.items() if path.name.startswith("test_")}
    own = [Path(name) for name in changed if name.startswith(("tflab/", "tests/")) and ROOT / name not in tests]
    folders = {ROOT / "tests" / path.parts[1] for path in own}
    reached = {path for path, name in tests.items() if path.parent in folders or reached_from(name) & names}
    if EVERYTHING & set(changed):
        return sorted(tests)
    return sorted(reached | set(ON_TOP)) if changed else []


if __name__ == "__main__":
    for path in tests_reached(changed_files((sys.argv[1:] or ["HEAD"])[0])):
        print(path.relative_to(ROOT))
