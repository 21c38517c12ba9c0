"""Run the command `tflab`. The module of a subcommand is imported when it is called.

    tflab run node.py --with "ros2 topic hz /tf"    SUBCOMMANDS["run"] -> tflab.tools.shell.run

The function of a subcommand takes the arguments after its name and returns the exit code.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Sequence
from difflib import get_close_matches
from importlib import import_module
from importlib.util import find_spec
from io import TextIOWrapper
from itertools import groupby
from pathlib import Path
from typing import NamedTuple

from . import __version__
from .extras import hint
from .text import Texts, language_of_tools

__all__ = ["SUBCOMMANDS", "Subcommand", "main"]


class Subcommand(NamedTuple):
    """A command: the group in which `--help` lists it, and the function that runs it."""

    group: str
    module: str
    function: str


# What a shell says of a program that a signal has ended.
BY_CTRL_C, BY_A_CLOSED_PIPE = 130, 141
UNUSABLE = 2

SUBCOMMANDS = {
    "lab": Subcommand("learn", "tflab.workbook.copy.lab", "lab"),
    "check": Subcommand("learn", "tflab.grading.check_command", "main"),
    "progress": Subcommand("learn", "tflab.workbook.course.progress_page", "progress"),
    "run": Subcommand("use_ros", "tflab.tools.shell", "run"),
    "ros2": Subcommand("use_ros", "tflab.tools.shell", "ros2"),
    "package": Subcommand("use_ros", "tflab.tools.package", "main"),
    "doctor": Subcommand("use_ros", "tflab.doctor.command", "main"),
    "guide": Subcommand("teach", "tflab.grading.guide.command", "main"),
    "slides": Subcommand("teach", "tflab.workbook.pages.slides", "main"),
    "release": Subcommand("teach", "tflab.grading.release", "main"),
    "grade": Subcommand("teach", "tflab.grading.grade", "main"),
    "build": Subcommand("publish", "tflab.workbook.pages.build", "build"),
    "export": Subcommand("publish", "tflab.workbook.pages.html", "main"),
}
HELP = Texts(__file__)  # of each command, of each group, and around them


def main(words: Sequence[str] | None = None) -> int:
    """Run `tflab` with these words, those of the command line if None; return the exit code.

    Ctrl-C ends it without a word, and so does a reader that has gone, as in `tflab ... | head -1`.
    A full disk, a place where one may not write, a missing part or an unknown release of ROS is one line.
    """
    _keep_to_this_python()
    words = list(sys.argv[1:] if words is None else words)
    for name in ("stdout", "stderr"):
        if getattr(sys, name) is None:  # closed by whoever called, as by `>&-`
            setattr(sys, name, open(os.devnull, "w"))  # noqa: SIM115
    if isinstance(sys.stdout, TextIOWrapper):
        sys.stdout.reconfigure(errors="backslashreplace")  # a terminal that lacks a letter shows its number
    try:
        code = _run(words)
        sys.stdout.flush()
    except KeyboardInterrupt:
        return BY_CTRL_C
    except BrokenPipeError:
        _leave_nothing_to_flush()
        return BY_A_CLOSED_PIPE
    except (ModuleNotFoundError, OSError, RuntimeError, ValueError) as error:
        reason = _reason(error)
        if reason is None:
            raise
        print(f"{' '.join(['tflab', *words[:1]])}: {reason}", file=sys.stderr)
        _leave_nothing_to_flush()
        return UNUSABLE
    return code


def _keep_to_this_python() -> None:
    """Have pages run in this very Python, also where its user has told Jupyter of another one called "python3"."""
    before = os.environ.get("JUPYTER_PATH", "").split(os.pathsep)
    ours = str(Path(__file__).parent / "workbook" / "copy" / "jupyter")  # `kernels` in it
    os.environ["JUPYTER_PATH"] = os.pathsep.join([ours, *(path for path in before if path not in ("", ours))])


def _leave_nothing_to_flush() -> None:
    """Send what is still unwritten nowhere, where it cannot be written, so that it does not fail at the exit."""
    try:
        sys.stdout.flush()
    except OSError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def _reason(error: Exception) -> str | None:
    """Return what went wrong and with what, if it is the machine's doing; None if it is a fault of ours."""
    if isinstance(error, ModuleNotFoundError):
        return hint(error.name or "")
    if isinstance(error, RuntimeError):
        return f"{error} Set HOME to a folder of yours." if "home directory" in str(error) else None
    if isinstance(error, ValueError):
        return str(error) if str(error).startswith("TFLAB_ROS_DISTRO=") else None
    return f"{error.filename}: {error.strerror or error}" if error.filename else error.strerror or str(error)


def _run(words: list[str]) -> int:
    match words:
        case [] | ["-h" | "--help", *_]:
            print(_help())
            return 0
        case ["--version", *_]:
            print(f"tflab {__version__}")
            return 0
        case [name, *rest] if name in SUBCOMMANDS:
            return _function(SUBCOMMANDS[name])(rest)
    print(_unknown(words[0]), file=sys.stderr)
    return 2


def _function(subcommand: Subcommand) -> Callable[[Sequence[str]], int]:
    return getattr(import_module(subcommand.module), subcommand.function)


def _help() -> str:
    language = language_of_tools()
    lines = ["usage: tflab [-h] [--version] COMMAND ...", "", HELP["about"].say(language)]
    width = max(map(len, SUBCOMMANDS))
    for group, members in groupby(SUBCOMMANDS.items(), key=lambda row: row[1].group):
        lines += ["", HELP[group].say(language)]
        lines += [f"  {name:<{width}}  {HELP[name].say(language)}" for name, _ in members]
    lines += ["", HELP["start"].say(language), HELP["details"].say(language)]
    return "\n".join([*lines, *([] if find_spec("jupyterlab") else [HELP["no_lab"].say(language)])])


def _unknown(name: str) -> str:
    language, close = language_of_tools(), get_close_matches(name, SUBCOMMANDS, n=1)
    said = HELP["unknown"].say(language, name=name)
    return said + HELP["guess"].say(language, close=close[0]) if close else f"{said}\n\n{_help()}"
