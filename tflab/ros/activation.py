"""Let `import rclpy` find the in-process ROS 2.

    import rclpy  -->  sys.meta_path: [our finder, ...]  -->  the row `rclpy` of packages.yaml

Without ROS 2 the names of its packages are free, so `activate()` serves those of
`packages.yaml` and of `messages`. Beside a real ROS 2 it steps aside, unless an
environment variable decides:

    TFLAB_ROS=in-process    always the in-process modules
    TFLAB_ROS=real          always the real ones, an error if there are none

`load_in_notebook` is what `%load_ext tflab` calls: these modules on virtual time, with field checks.

ROS 1 also has a `tf2_ros`, but no `rclpy`, so only `rclpy` tells that ROS 2 is here.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Iterable, Sequence
from functools import cache
from importlib import import_module
from importlib.machinery import ModuleSpec
from importlib.util import find_spec
from pathlib import Path
from types import ModuleType
from typing import Any

from tflab.text import load_yaml

from . import distro
from .graph import Graph, new_graph
from .logging import write_to_stdout
from .messages import set_field_checks
from .messages.base import types_of
from .messages.packages import definitions, ros_package
from .process import restore_threads

__all__ = ["PACKAGES", "activate", "deactivate", "is_active", "load_in_notebook"]


FOLDER = Path(__file__).parent
KINDS = ("action", "msg", "srv")
MESSAGE_PACKAGES = set(definitions())
VARIABLE = "TFLAB_ROS"


@cache
def _table() -> dict[str, dict[str, list[str]]]:
    """Return the names in each module, but those of message packages."""
    return load_yaml((FOLDER / "packages.yaml").read_text(encoding="utf-8"))


@cache
def _types_of(package: str) -> dict[str, dict[str, type]]:
    """Return the types of a message package by their kind: {"msg": {"Point": ...}}."""
    ros_package(package)
    found: dict[str, dict[str, type]] = {}
    for name, cls in types_of(package).items():
        found.setdefault(name.split("/")[1], {})[cls.__name__] = cls
    return found


def _modules_in(name: str) -> list[str]:
    """Return the names of the modules in a package, sorted; none in a module."""
    if name in MESSAGE_PACKAGES:
        return sorted(_types_of(name))
    return sorted(row.rpartition(".")[2] for row in _table() if row.rpartition(".")[0] == name and distro.has_name(row))


class _Finder:
    """Find and make the modules of the in-process ROS 2; for one that is missing, name those that there are."""

    def find_spec(self, name: str, path: object = None, target: object = None) -> ModuleSpec | None:
        parent, _, last = name.rpartition(".")
        if name.partition(".")[0] not in PACKAGES or (parent and not (parent in sys.modules and _is_ours(parent))):
            return None
        if not distro.has_name(name) and name not in _table():
            raise ImportError(f"cannot import name {last!r} from {parent!r} in ROS 2 {distro.current().name}")
        if parent and last not in _modules_in(parent):
            raise ModuleNotFoundError(
                f"No module named {name!r} in the in-process ROS 2 {distro.current().name} of tflab; {parent} has "
                f"{', '.join(_modules_in(parent)) or 'no modules'}.",
                name=name,
            )
        is_package = not parent or last in KINDS or bool(_modules_in(name))
        return ModuleSpec(name, self, origin="tflab.ros", is_package=is_package)

    def create_module(self, spec: ModuleSpec) -> None:
        """Leave it to Python to make the module."""

    def exec_module(self, module: ModuleType) -> None:
        """Put the names into a module."""
        name = module.__name__
        module.__doc__ = f"{name} in one process, served by tflab.ros."
        package, _, kind = name.partition(".")
        if package in MESSAGE_PACKAGES:
            module.__dict__.update(_types_of(package)[kind] if kind else {})
            return
        for source, names in _table()[name].items():
            if source == "call":
                function_module, _, function = names.rpartition(".")
                getattr(import_module(function_module), function)()
            elif source == ".":
                for each in filter(distro.has_name, (f"{name}.{each}" for each in names)):
                    import_module(each)
            elif source == "modules":
                for other, each in names.items():
                    import_module(each)
                    setattr(module, other, sys.modules[other if each.startswith(f"{other}.") else each])
            else:
                _copy(source, module, names)


def _copy(source: str, target: ModuleType, rows: Iterable[str]) -> None:
    """Copy what this release has of some names, each "name" or "name as other_name", from one module to another."""
    for row in rows if distro.has_name(source) else ():
        name, _, other = row.partition(" as ")
        if distro.has_name(f"{target.__name__}.{other or name}"):
            setattr(target, other or name, getattr(import_module(source, target.__name__), name))


def _top_packages() -> Sequence[str]:
    lines = (FOLDER / "packages.yaml").read_text(encoding="utf-8").splitlines()
    listed = {line.partition(":")[0] for line in lines if line[:1].isalpha()}
    return sorted({name for name in listed if "." not in name} | MESSAGE_PACKAGES)


PACKAGES = tuple(_top_packages())
_finder = _Finder()


def is_active() -> bool:
    """Return whether `import rclpy` finds the in-process modules."""
    return _finder in sys.meta_path


def activate(which: str | None = None) -> str:
    """Put the in-process ROS 2 in place; return "in-process", or "real" if a real one is left alone.

    Args:
        which: "in-process" or "real" decides; None leaves it to TFLAB_ROS, and
            without that to whether a real `rclpy` can be imported.

    Raises:
        ImportError: one of the modules is already imported from elsewhere, or
            the real ones were asked for and are not there.
        ValueError: `which` or TFLAB_ROS is another word.
    """
    if is_active() and which != "real":
        return "in-process"
    which = which or os.environ.get(VARIABLE) or ("real" if find_spec("rclpy") else "in-process")
    if which == "real":
        deactivate()
        if find_spec("rclpy") is None:
            raise ImportError(
                "the real ROS 2 was asked for, but Python cannot find its rclpy. Source its setup file first "
                f"(source /opt/ros/<distro>/setup.bash), or unset {VARIABLE} to use the in-process modules."
            )
        return "real"
    if which != "in-process":
        raise ValueError(f'{VARIABLE}={which!r} is not known: it is "in-process" or "real".')
    _refuse_strangers()
    sys.meta_path.insert(0, _finder)
    return "in-process"


def deactivate() -> None:
    """Undo activate(): the names belong to nobody again, and what was imported is forgotten."""
    restore_threads()
    if not is_active():
        return
    sys.meta_path.remove(_finder)
    for name in [name for name in list(sys.modules) if name.partition(".")[0] in PACKAGES]:
        if _is_ours(name):
            del sys.modules[name]


def _refuse_strangers() -> None:
    strangers = [name for name in PACKAGES if name in sys.modules and not _is_ours(name)]
    if strangers:
        where = getattr(sys.modules[strangers[0]], "__file__", None) or "elsewhere"
        raise ImportError(
            f"{', '.join(strangers)} already imported, from {where}, so the in-process ROS 2 cannot take that place. "
            "Restart Python (in Jupyter: the kernel) and activate tflab before the first ROS import."
        )


def _is_ours(name: str) -> bool:
    spec = getattr(sys.modules[name], "__spec__", None)
    return spec is not None and spec.loader is _finder


def load_in_notebook(ipython: Any) -> Graph:
    """Activate the in-process modules, make the kernel's current graph, and say so in one line.

    Raises:
        ImportError: a real ROS 2 module was imported before.
    """
    activate("in-process")
    set_field_checks(True)
    write_to_stdout(True)  # in pages a log line is an output like any other
    graph = new_graph(virtual=True)
    ipython.push({"graph": graph})
    print(f"tflab: in-process ROS 2 ({distro.current().name}), virtual time, message fields checked.")
    return graph
