"""Find the packages of a ROS 2 workspace and what `ros2 run` finds in them; nothing has to be built.

    hop_ws/src/hop/setup.py                  "rabbit = hop.rabbit:main"              ros2 run hop rabbit
    hop_ws/src/hop/CMakeLists.txt            install(PROGRAMS fox.py DESTINATION ..  ros2 run hop fox.py
    hop_ws/src/hop_interfaces/msg/Hop.msg                                            hop_interfaces.msg.Hop

A setup.py is parsed, not executed. A folder of interface texts is a package also without a package.xml.
"""

from __future__ import annotations

import ast
import os
import re
import sys
from collections.abc import Iterator, Mapping
from contextlib import suppress
from importlib.machinery import ModuleSpec
from pathlib import Path
from types import ModuleType
from typing import NamedTuple

from .activation import PACKAGES
from .messages.packages import define, interface_files

__all__ = ["EntryPoint", "find_executable", "find_package", "package_around", "packages_around", "use_packages"]

BUILT = {"build", "install", "log"}  # colcon's folders
DEPTH = 5  # how many folders below a workspace its packages are looked for
INTERFACES = re.compile(r"[a-z]\w*_(msgs|interfaces|srvs|actions)")  # how packages of them are called
ENTRY_POINT = re.compile(r"\s*([\w.-]+)\s*=\s*([\w.]+)\s*:\s*(\w+)\s*")
PROGRAMS = re.compile(r"install\s*\(\s*PROGRAMS\s+(.*?)\bDESTINATION\b", re.DOTALL)


class EntryPoint(NamedTuple):
    """What an executable runs: a function of a module, or a script if these are empty."""

    path: Path
    module: str = ""
    function: str = ""


class Package(NamedTuple):
    """A package in a source folder, which also stands for its installed share folder."""

    name: str
    folder: Path

    def roots(self) -> list[Path]:
        """Return the folders from which its Python modules are imported."""
        return [self.folder, *({path.parent.parent for path in self.folder.glob("src/*/__init__.py")})]

    def executables(self) -> dict[str, EntryPoint]:
        """Return what `ros2 run` finds in it, by name, but programs in C++."""
        found = {}
        for text in (*_texts_in(_read(self.folder / "setup.py")), *_read(self.folder / "setup.cfg").splitlines()):
            match = ENTRY_POINT.fullmatch(text)
            paths = [root / f"{match[2].replace('.', '/')}.py" for root in self.roots()] if match else ()
            for path in [*filter(Path.is_file, paths)][:1]:
                found[match[1]] = EntryPoint(path, match[2], match[3])
        for words in PROGRAMS.findall(_read(self.folder / "CMakeLists.txt")):
            paths = [self.folder / word.strip('"') for word in words.split()]
            found |= {path.name: EntryPoint(path) for path in paths if path.is_file()}
        return found


def package_around(path: str | Path) -> Package | None:
    """Return the package that a file or folder lies in, by its package.xml."""
    path = Path(os.path.abspath(path))
    return next((_package_at(each) for each in (path, *path.parents) if (each / "package.xml").is_file()), None)


def packages_around(path: str | Path) -> dict[str, Package]:
    """Return the packages of a workspace or a cloned repository: those below a folder, or around what lies in one."""
    path, own = Path(os.path.abspath(path)), package_around(path)
    if own is not None:
        tops = (folder for folder in own.folder.parents if folder.name == "src" or (folder / ".git").exists())
        source = next(tops, None)
        return _packages_below(source or own.folder.parent, DEPTH if source else 1) | {own.name: own}
    if path.is_dir():
        above = (_packages_below(folder / "src", DEPTH) for folder in path.parents)
        return _packages_below(path, DEPTH) or next(filter(None, above), {})
    return _packages_below(path.parent, 1)


def _packages_below(top: Path, depth: int) -> dict[str, Package]:
    found: dict[str, Package] = {}
    for parent, folders, files in os.walk(top):
        folder = Path(parent)
        is_package = "package.xml" in files or _has_interfaces(folder)
        if is_package and "COLCON_IGNORE" not in files:
            package = _package_at(folder)
            found.setdefault(package.name, package)
        is_end = is_package or "COLCON_IGNORE" in files or len(folder.relative_to(top).parts) == depth
        folders[:] = () if is_end else sorted(name for name in folders if name[0] not in "._" and name not in BUILT)
    return found


def _package_at(folder: Path) -> Package:
    match = re.search(r"<name>\s*([\w-]+)\s*</name>", _read(folder / "package.xml"))
    return Package(match[1] if match else folder.name, folder)


def _has_interfaces(folder: Path) -> bool:
    return any(interface_files(folder, kind) for kind in ("msg", "srv", "action"))


def _read(path: Path) -> str:
    return path.read_text(encoding="utf-8", errors="replace") if path.is_file() else ""


def _texts_in(source: str) -> Iterator[str]:
    """Yield every text in a setup.py, put together as far as that is plain from the file."""
    names: dict[str, str] = {}
    with suppress(SyntaxError, ValueError):
        for node in ast.walk(ast.parse(source)):
            if isinstance(node, ast.Assign):
                names[ast.unparse(node.targets[0])] = _text(node.value, names)
            yield _text(node, names)


def _text(node: ast.AST, names: Mapping[str, str]) -> str:
    match node:
        case ast.Constant(value=str(text)):
            return text
        case ast.Name(id=name) | ast.FormattedValue(value=ast.Name(id=name)):
            return names.get(name, "")
        case ast.JoinedStr(values=parts):
            return "".join(_text(part, names) for part in parts)
        case ast.BinOp(left=left, op=ast.Add(), right=right):
            return _text(left, names) + _text(right, names)
    return ""


# -- the workspace that runs ----------------------------------------------

_used: dict[str, Package] = {}
_undefined: dict[str, Package] = {}  # those of them whose interfaces nobody has imported yet


def use_packages(packages: Mapping[str, Package]) -> None:
    """Let Python import these packages and their interfaces from now on, and `find_package` find them."""
    for name, package in packages.items():
        if name not in _used and name not in PACKAGES and _has_interfaces(package.folder):
            _undefined[name] = package
        sys.path[:0] = [str(root) for root in package.roots() if str(root) not in sys.path]
    _used.update(packages)
    if _finder not in sys.meta_path:
        sys.meta_path.insert(0, _finder)


def find_package(name: str) -> Package | None:
    """Return a package of the workspace that runs, else of the one around the working folder; None: there is none."""
    if name not in _used:
        use_packages(packages_around(Path.cwd()))
    return _used.get(name)


def find_executable(package: str, name: str) -> EntryPoint:
    """Return what `ros2 run` would run.

    Raises:
        LookupError: there is no such thing, in the words of `ros2 run`.
    """
    found = find_package(package)
    if found is None:
        raise LookupError(f"Package '{package}' not found")
    executables = found.executables()
    if name not in executables:
        there = f"; {package} has, in Python: {', '.join(executables)}" if executables else ""
        raise LookupError(f"No executable found{there}")
    return executables[name]


class _InterfaceFinder:
    """Define an interface package of the workspace when it is imported."""

    def find_spec(self, name: str, path: object = None, target: object = None) -> ModuleSpec | None:
        if INTERFACES.fullmatch(name) and name not in PACKAGES:
            find_package(name)
        package = _undefined.pop(name, None)
        if package is None:
            return None
        try:
            define(name, package.folder, {}).__path__ = [str(package.folder / name)]
        except (ValueError, KeyError) as fault:
            _undefined[name] = package
            raise ImportError(f"cannot read the interfaces in {package.folder}: {fault}", name=name) from None
        return ModuleSpec(name, self, is_package=True)

    def create_module(self, spec: ModuleSpec) -> ModuleType:
        """Return what define() has made."""
        return sys.modules[spec.name]

    def exec_module(self, module: ModuleType) -> None:
        """Leave it as it is."""


_finder = _InterfaceFinder()
