"""How does one run things in a shell?  `tflab run` for node files, `tflab ros2` for the tools.

    tflab run robot.py ekf.py --with 'ros2 topic hz /tf' --for 10
    tflab ros2 run tf2_ros static_transform_publisher --frame-id map --child-frame-id odom

Everything of one command line lives in one process, in real time: tools see the
nodes of their own command line, not those of another terminal.

This is the last page of the room.
"""

from __future__ import annotations

import argparse
import shlex
import sys
from collections.abc import Callable, Sequence
from typing import Any

from . import ros2 as ros2_words

__all__ = ["ros2", "run"]


def run(words: Sequence[str]) -> int:
    """Run node files, and tools beside them, until they have ended or Ctrl-C; return the exit code."""
    options = _run_parser().parse_args(list(words))
    try:
        beside = [(line, _program(_words_of(line))) for line in options.tools]
        return _run_files(options.files, args=options.ros_args, beside=beside, seconds=options.seconds)
    except (FileNotFoundError, ValueError) as fault:
        print(f"tflab run: {fault}", file=sys.stderr)
        return 2


def ros2(words: Sequence[str]) -> int:
    """Run one of the tools until it has ended or Ctrl-C; return its exit code."""
    codes: list[int] = []
    _run_files([], beside=[("ros2", _program(words, codes))])
    return codes[0] % 256 if codes else 0


def _run_parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="tflab run",
        description="Run node files as they are, together, in one process and in real time, until Ctrl-C.",
    )
    parser.add_argument("files", nargs="+", metavar="node.py", help="a file that `python node.py` would run")
    parser.add_argument(
        "--with", dest="tools", action="append", default=[], metavar="'ros2 ...'",
        help="a tool to run beside them, such as 'ros2 topic hz /tf'; may be given several times",
    )  # fmt: skip
    parser.add_argument(
        "--for", dest="seconds", type=_seconds, metavar="SECONDS", help="stop after this time, as by Ctrl-C"
    )
    parser.add_argument(
        "--ros-args", nargs=argparse.REMAINDER, action=_WithItsName, default=[],
        help="what follows is every file's command line, such as --ros-args -p use_sim_time:=true",
    )  # fmt: skip
    return parser


class _WithItsName(argparse.Action):
    """Keeps the words after `--ros-args`, and the option itself before them."""

    def __call__(self, parser, namespace, values, option_string=None) -> None:
        namespace.ros_args = [option_string, *values]


def _seconds(text: str) -> float:
    try:
        value = float(text)
    except ValueError:
        value = 0.0
    if not 0 < value < float("inf"):
        raise argparse.ArgumentTypeError(f"it needs a time in seconds, more than 0, not {text!r}")
    return value


def _words_of(line: str) -> list[str]:
    """Return the words after `ros2` of a line as one would type it.

    Raises:
        ValueError: it is not a tool that there is.
    """
    words = shlex.split(line)
    if words[:1] == ["ros2"]:
        return words[1:]
    if words[:1] == ["rviz2"]:
        return ["run", "rviz2", *words]
    raise ValueError(f"--with takes a line that begins with ros2, such as 'ros2 topic hz /tf', not {line!r}")


def _program(words: Sequence[str], codes: list[int] | None = None) -> Callable[[], None]:
    def program() -> None:
        code = ros2_words.main(words)
        if codes is not None:
            codes.append(code)

    return program


def _run_files(paths: Sequence[str], **options: Any) -> int:
    from tflab.ros.run import run_files  # only now: it is long to load, and --help must not wait for it

    return run_files(paths, **options)
