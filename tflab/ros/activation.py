"""How does `import rclpy` find us?  Modules put in place of a ROS 2 that is not there.

    import rclpy  -->  sys.meta_path: [our finder, ...]  -->  tflab/ros/packages/rclpy/

Without ROS 2 the names of its packages belong to nobody, so `activate()` serves
those that have a folder in `packages`.  Beside a real ROS 2 it stands aside, unless it is told
otherwise; the choice is one environment variable:

    TFLAB_ROS=in-process    always ours
    TFLAB_ROS=real          always the real one, an error if there is none

ROS 1 also has a `tf2_ros`, but no `rclpy`, so only `rclpy` tells that ROS 2 is here.
"""

from __future__ import annotations

import os
import sys
from importlib.machinery import ModuleSpec, PathFinder
from importlib.util import find_spec
from pathlib import Path
from pkgutil import iter_modules

from . import threads

__all__ = ["PACKAGES", "activate", "deactivate", "is_active"]

FOLDER = Path(__file__).parent / "packages"
PACKAGES = tuple(sorted(face.parent.name for face in FOLDER.glob("*/__init__.py")))
VARIABLE = "TFLAB_ROS"


class _Finder:
    """Finds exactly the packages that have a face in our folder, and says what they have instead of what they lack."""

    def find_spec(self, name: str, path: object = None, target: object = None) -> ModuleSpec | None:
        if path is None and name in PACKAGES:
            return PathFinder.find_spec(name, [str(FOLDER)])
        parent = name.rpartition(".")[0]
        if parent.partition(".")[0] in PACKAGES and parent in sys.modules and _is_ours(parent):
            there = sorted(module.name for module in iter_modules(sys.modules[parent].__path__))
            if name.rpartition(".")[2] not in there:
                raise ModuleNotFoundError(
                    f"No module named {name!r} in the in-process ROS 2 of tflab; {parent} has "
                    f"{', '.join(there) or 'no modules'}.",
                    name=name,
                )
        return None


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
    threads.uninstall()
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
    file = getattr(sys.modules[name], "__file__", None)
    return file is not None and Path(file).is_relative_to(FOLDER)
