"""Run `tflab package`: make a ROS 2 package of node files, which `colcon build` and `tflab run` understand.

    hop/rabbit.py              -->  ros2_ws/src/hop/package.xml, setup.py, setup.cfg, resource/hop
    hop/gait.py                                 hop/__init__.py, rabbit.py, gait.py
    hop/robot.urdf, else ours                   launch/hop.launch.py, urdf/robot.urdf, test/test_hop.py

A file with a function main() becomes an executable, any other file a module beside it.
"""

from __future__ import annotations

import argparse
import ast
import os
import re
import sys
from collections.abc import Iterator, Mapping, Sequence
from itertools import chain
from keyword import iskeyword
from pathlib import Path
from string import Template
from tempfile import TemporaryDirectory

from tflab.robots.teaching import teaching_urdf
from tflab.robots.urdf import UrdfError, parse_urdf
from tflab.ros.activation import PACKAGES
from tflab.ros.workspace import INTERFACES
from tflab.text import Texts, language_of_tools

__all__ = ["main"]

TEXTS = Texts(__file__)  # what it prints when it is done
TEMPLATES = Path(__file__).parent / "package_files"
GENERATED = {  # the files that are made from templates
    "package.xml": "package.xml.txt",
    "setup.py": "setup.py.txt",
    "setup.cfg": "setup.cfg.txt",
    "launch/{}.launch.py": "launch.py.txt",
    "test/test_{}.py": "test.py.txt",
}
NAME = re.compile(r"[a-z](_?[a-z0-9])+")
TAKEN = {*PACKAGES, *sys.stdlib_module_names, "resource", "test", "urdf"}  # other packages, and folders of this one
NO_NODE = re.compile(r"setup|conftest|__init__|test_.*|.*_test|.*\.launch")
LAUNCH_DEPENDS = {"ament_index_python", "launch", "launch_ros", "robot_state_publisher"}
ROSDEP_KEYS = {"PIL": "python3-pil", "cv2": "python3-opencv"} | {
    name: f"python3-{name}" for name in ("matplotlib", "numpy", "pandas", "scipy", "serial", "yaml")
}


class PackageError(ValueError):
    """No package can be made of these files; the text says why, and what to do."""


def main(words: Sequence[str]) -> int:
    """Write a package; return 0, or 2 if nothing was written."""
    parser = argparse.ArgumentParser(
        prog="tflab package", description="Make a ROS 2 package, ready for colcon build, of Python node files."
    )
    parser.add_argument("folder", metavar="DIR", help="a folder with node files; the package gets its name")
    parser.add_argument("files", nargs="*", metavar="node.py", help="take only these files; DIR need not exist")
    parser.add_argument("--name", help="another name for the package")
    parser.add_argument("--ws", default="ros2_ws", help="the workspace: the package is WS/src/NAME (%(default)s)")
    try:
        options = parser.parse_args(list(words))
    except SystemExit as stop:
        return stop.code or 0
    folder = Path(os.path.abspath(options.folder))
    name = options.name or folder.name
    target = Path(options.ws, "src", name)
    try:
        _check_place(name, options.folder, folder, target)
        if not options.files and not folder.is_dir():
            raise PackageError(f"there is no folder {options.folder}")
        modules = _modules(folder, [*map(Path, options.files)])
        nodes = [path.stem for path, tree in modules.items() if _is_node(path, tree)]
        if not nodes:
            raise PackageError(f"{options.folder} has no node: a Python file with a function main()")
        texts = _package(name, folder, modules, nodes)
        _write(target, texts)
    except (PackageError, UrdfError) as fault:
        print(f"tflab package: {fault}", file=sys.stderr)
        return 2
    executables = " ".join(f"{name}:{node}" for node in nodes)
    print(TEXTS["done"].say(language_of_tools(), target=target, ws=options.ws, name=name, executables=executables))
    return 0


def _check_place(name: str, word: str, folder: Path, target: Path) -> None:
    if folder.is_file():
        raise PackageError(f"{word} is a file. Name the package first: tflab package my_robot_py {word}")
    if (folder / "package.xml").is_file():
        raise PackageError(f"{folder} is a package already. Run it with: tflab run {folder}")
    if not NAME.fullmatch(name) or iskeyword(name) or name in TAKEN:
        raise PackageError(
            f'a package cannot have the name "{name}". Choose small letters, digits and single underscores, '
            "and no name of another package: --name my_robot_py"
        )
    if target.exists():
        raise PackageError(f"{target} exists and stays as it is. Move it away, or choose another --name or --ws")


def _write(target: Path, texts: Mapping[str, str]) -> None:
    """Write all files of a package, or none."""
    target.parent.mkdir(parents=True, exist_ok=True)
    with TemporaryDirectory(prefix=".", dir=target.parent) as folder:
        part = Path(folder, target.name)
        for path, text in texts.items():
            (part / path).parent.mkdir(parents=True, exist_ok=True)
            (part / path).write_text(text, encoding="utf-8", newline="\n")
        part.rename(target)


def _package(name: str, folder: Path, modules: Mapping[Path, ast.Module], nodes: Sequence[str]) -> dict[str, str]:
    """Return the text of each file of the package, by its path."""
    texts = {f"urdf/{path.name}": _read(path) for path in sorted(folder.glob("*.urdf"))}
    texts = texts or {"urdf/tf_lab_robot.urdf": teaching_urdf()}
    (urdf, text), *_ = texts.items()
    mounted = {joint.child for joint in parse_urdf(text, source=urdf).joints}
    names = {
        "name": name,
        "urdf": Path(urdf).name,
        "publishes_urdf": str(not mounted & set(chain(*map(_child_frames, modules.values())))).lower(),
        "depends": "\n".join(_depends(name, modules)),
        "nodes": "\n".join(f'    "{each}",' for each in nodes),
        "scripts": "\n".join(f'            "{each} = {name}.{each}:main",' for each in nodes),
    }
    for path, template in GENERATED.items():
        texts[path.format(name)] = Template(_read(TEMPLATES / template)).substitute(names)
    texts |= {f"resource/{name}": "", f"{name}/__init__.py": ""}
    texts |= {f"launch/{path.name}": _read(path) for path in folder.glob("*.launch.py")}
    return texts | {f"{name}/{path.name}": _text_in(name, path, modules) for path in modules}


# -- a file of the learner ------------------------------------------------


def _read(path: Path) -> str:
    try:
        return path.read_text(encoding="utf-8-sig")
    except UnicodeDecodeError as fault:
        raise PackageError(f"{path} is not UTF-8 ({fault}); save it as UTF-8 in your editor") from None


def _modules(folder: Path, files: Sequence[Path]) -> dict[Path, ast.Module]:
    """Return the named files, or else the files of the folder, each with its syntax tree."""
    files = files or sorted(path for path in folder.glob("*.py") if not NO_NODE.fullmatch(path.stem))
    if len({path.stem for path in files}) < len(files):
        raise PackageError("two of the files have the same name")
    return {path: _parsed(path) for path in files}


def _parsed(path: Path) -> ast.Module:
    if path.suffix != ".py" or not path.stem.isidentifier() or iskeyword(path.stem):
        raise PackageError(f"{path} cannot be a module. A node is a Python file such as my_node.py")
    try:
        return ast.parse(_read(path), str(path))
    except SyntaxError as fault:
        raise PackageError(f"{path}:{fault.lineno or 1}: {fault.msg}") from None


def _is_node(path: Path, tree: ast.Module) -> bool:
    """Return whether a file has a function main().

    Raises:
        PackageError: `ros2 run` could not call it, or the file does more than define when it is imported.
    """
    mains = [each for each in tree.body if isinstance(each, ast.FunctionDef) and each.name == "main"]
    for each in mains:
        given = each.args
        if len([*given.posonlyargs, *given.args]) > len(given.defaults) or None in given.kw_defaults:
            raise PackageError(f"{path}:{each.lineno}: ros2 run gives main() no arguments. Write def main(args=None):")
    for each in tree.body:
        is_guard = isinstance(each, ast.If) and "__name__" in ast.unparse(each.test)
        if _runs_node(each) and not (is_guard and mains):
            raise PackageError(
                f"{path}:{each.lineno}: ros2 run imports this file and calls main(). Put this into a function main(), "
                'and end the file with: if __name__ == "__main__": main()'
            )
    return bool(mains)


def _runs_node(statement: ast.stmt) -> bool:
    """Return whether an import of the module would call main(), or rclpy.init() and the like, in this statement."""
    if isinstance(statement, ast.FunctionDef | ast.AsyncFunctionDef | ast.ClassDef):
        return False
    calls = [ast.unparse(node.func) for node in ast.walk(statement) if isinstance(node, ast.Call)]
    return any(re.fullmatch(r"main|rclpy\.\w+", call) for call in calls)


def _child_frames(tree: ast.Module) -> set[str]:
    """Return the child frames that a file names as literals."""
    given = [node for node in ast.walk(tree) if isinstance(node, ast.Assign | ast.keyword)]
    named = [node.value for node in given if "child_frame_id" in ast.unparse(node)]
    return {str(value.value) for value in named if isinstance(value, ast.Constant)}


def _imports(tree: ast.Module) -> Iterator[tuple[str, ast.Import | ast.ImportFrom]]:
    """Yield each package or module that a file imports by its full name, with the statement."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            yield from ((alias.name.partition(".")[0], node) for alias in node.names)
        elif isinstance(node, ast.ImportFrom) and not node.level:
            yield (node.module or "").partition(".")[0], node


def _depends(package: str, modules: Mapping[Path, ast.Module]) -> Iterator[str]:
    """Yield the lines of package.xml that name what the files import."""
    keys, unknown, own = set(LAUNCH_DEPENDS), set(), {package, *(path.stem for path in modules)}
    for path, tree in modules.items():
        for name in {name for name, _ in _imports(tree)} - own - sys.stdlib_module_names:
            if any(path.with_name(beside).exists() for beside in (name, f"{name}.py")):
                raise PackageError(f"{path} imports {name} from beside it: name {name}.py, too. Folders are left out")
            is_known = name in PACKAGES or name in ROSDEP_KEYS or INTERFACES.fullmatch(name)
            (keys if is_known else unknown).add(ROSDEP_KEYS.get(name, name))
    yield from (f"  <exec_depend>{key}</exec_depend>" for key in sorted(keys))
    yield from (f"  <!-- TODO: an exec_depend with the rosdep key of {name} -->" for name in sorted(unknown))


def _text_in(package: str, path: Path, modules: Mapping[Path, ast.Module]) -> str:
    """Return the text of a file for the package, where `import gait` is `from hop import gait`."""
    lines, own = _read(path).split("\n"), {each.stem for each in modules}
    for name, node in _imports(modules[path]):
        if name not in own:
            continue
        if len(node.names) > 1 and isinstance(node, ast.Import):
            raise PackageError(f"{path}:{node.lineno}: import {name} in a line of its own")
        if name == package:
            raise PackageError(f"{path}:{node.lineno}: {name} is a file and the package: choose another --name")
        before, after = "import", f"from {package} import {name}"
        if isinstance(node, ast.ImportFrom):
            before, after = "from", f"from {package}.{name}"
        lines[node.lineno - 1] = re.sub(rf"\b{before}\s+{name}\b", after, lines[node.lineno - 1], count=1)
    return "\n".join(lines)
