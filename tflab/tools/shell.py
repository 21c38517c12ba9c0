"""Run `tflab run` for node files and `tflab ros2` for the tools, in a shell.

    tflab run robot.py ekf.py --with "ros2 topic hz /tf" --for 10
    tflab run my_ws my_package:talker my_package:listener
    tflab ros2 --bag drive run tf2_ros tf2_echo map base_link
    tflab ros2 run tf2_ros static_transform_publisher --frame-id map --child-frame-id odom

Everything of one command line lives in one process: tools see the nodes of their
own command line, not those of another terminal.  Nodes run in real time; a bag is
played on virtual time, so its twenty seconds take as long as the work in them.
"""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Callable, Sequence
from itertools import takewhile
from typing import Any

from tflab.core import NSEC_PER_SEC
from tflab.core.stamps import seconds_typed

from . import ros2 as ros2_words
from .page import words_of_line

__all__ = ["ros2", "run"]

HEAD_START_S = 0.01
CLOCK_HZ = 100.0


def run(words: Sequence[str]) -> int:
    """Run node files, and tools beside them, until they have ended or Ctrl-C; return the exit code."""
    try:
        options = _run_options(words)
        beside = [(line, _program(ros2_words.plan(_words_of(line)).words)) for line in options.tools]
    except SystemExit as stop:  # help, or wrong words, which argparse has explained; nothing has begun
        return stop.code or 0
    except ValueError as fault:
        return _refuse(fault)
    if notebooks := [path for path in options.files if path.endswith(".ipynb")]:
        return _refuse(f"a notebook is no node file: {notebooks[0]}; open it with `tflab lab`")
    try:
        return _run_files(options.files, args=options.ros_args, beside=beside, seconds=options.seconds)
    except (FileNotFoundError, LookupError) as fault:
        return _refuse(fault)


def ros2(words: Sequence[str]) -> int:
    """Run one of the tools, alone or with `--bag`, until it has ended or Ctrl-C; return its exit code."""
    parser = argparse.ArgumentParser(
        prog="tflab ros2",
        description="Run one of ROS 2's command line tools. `tflab ros2 topic -h` is about `ros2 topic`.",
    )
    parser.add_argument("--bag", metavar="BAG", help="play this bag meanwhile, with /clock, on virtual time")
    parser.add_argument(
        "--for", dest="seconds", type=_seconds, metavar="SECONDS", help="stop after this time, as by Ctrl-C"
    )
    parser.add_argument("words", nargs=argparse.REMAINDER, metavar="...", help="as after `ros2`")
    try:
        options = parser.parse_args(list(words))
    except SystemExit as stop:
        return stop.code or 0
    if late := {"--bag", "--for"} & set(options.words):
        print(f"tflab ros2: {late.pop()} stands first: tflab ros2 --for 3 topic hz /tf", file=sys.stderr)
        return 2
    if options.bag is not None:
        return _on_bag(options.bag, options.words, options.seconds)
    codes: list[int] = []
    failed = _run_files([], beside=[("ros2", _program(options.words, codes))], seconds=options.seconds)
    return codes[0] % 256 if codes else failed


def _on_bag(bag: str, words: Sequence[str], seconds: float | None) -> int:
    """Run a tool on a graph where nothing lives but a bag, until one of them is over; return the exit code."""
    from tflab.bags.errors import BagError
    from tflab.bags.info import bag_facts
    from tflab.ros.graph import new_graph

    from .page import run_words

    try:
        bag_s = bag_facts(bag).duration_ns / NSEC_PER_SEC
    except BagError as fault:
        print(f"tflab ros2: {fault}", file=sys.stderr)
        return 2
    try:
        page_s = ros2_words.plan(words).page_s
    except SystemExit as stop:
        return stop.code or 0
    if seconds is None and page_s is not None:
        seconds = max(bag_s + HEAD_START_S, page_s)
    graph = new_graph()
    graph.start(_play, bag, name="ros2 bag play")
    outcome = run_words(graph, words, seconds, ros_args=["--ros-args", "-p", "use_sim_time:=true"])
    graph.stop()
    if page_s is not None and outcome.exit_code is None:  # stopped by us: it would have gone on for ever
        print(f"tflab ros2: {_why_stopped(seconds, bag_s)}", file=sys.stderr)
    return (outcome.exit_code or 0) % 256


def _why_stopped(seconds: float, bag_s: float) -> str:
    """Return why a tool was stopped that runs until Ctrl-C on a robot."""
    if seconds < bag_s:
        return f"stopped after {seconds:g} s; the recording is {bag_s:.1f} s long"
    return f"the recording is over, after {bag_s:.1f} s; on a robot this tool runs until Ctrl-C"


def _play(bag: str) -> None:
    """Play a bag without a word, after a moment in which others can begin to listen; then stay."""
    from tflab.bags.play import PlayOptions, play
    from tflab.ros.graph import current_process

    from .session import spin, spin_for, tool_node

    with tool_node("rosbag2_player") as node:
        driver = current_process().driver
        begin_ns = driver.steady_ns() + round(HEAD_START_S * NSEC_PER_SEC)

        def wait_until(after_ns: int) -> None:
            spin_for(node, (begin_ns + after_ns - driver.steady_ns()) / NSEC_PER_SEC)

        play(node, bag, PlayOptions(clock_hz=CLOCK_HZ), wait_until)
        spin(node)


def _run_parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="tflab run",
        description="Run Python nodes as they are, together, in one process and in real time, until Ctrl-C.",
    )
    parser.add_argument(
        "files", nargs="+", metavar="node.py",
        help="a file that `python node.py` would run, a workspace, or an executable of it as package:executable",
    )  # fmt: skip
    parser.add_argument(
        "--with", dest="tools", action="append", default=[], metavar='"ros2 ..."',
        help='a tool to run beside them, such as "ros2 topic hz /tf"; may be given several times',
    )  # fmt: skip
    parser.add_argument(
        "--for", dest="seconds", type=_seconds, metavar="SECONDS", help="stop after this time, as by Ctrl-C"
    )
    parser.add_argument(
        "--ros-args", nargs=argparse.REMAINDER, action=_WithItsName, default=[],
        help="what follows is every file's command line, such as --ros-args -p use_sim_time:=true; "
        "after -- also other words: -- 2 3 --ros-args -p use_sim_time:=true",
    )  # fmt: skip
    return parser


def _run_options(words: Sequence[str]) -> argparse.Namespace:
    parser = _run_parser()
    own = list(takewhile(lambda word: word != "--", words))
    options, rest = parser.parse_known_args(own)
    options.ros_args += words[len(own) + (not options.ros_args) :]  # a "--" also ends the --ros-args
    if rest:
        quotes = '; the line of a tool stands in quotes: --with "ros2 topic hz /tf"' if options.tools else ""
        parser.error(f"unrecognized arguments: {' '.join(rest)}{quotes}")
    return options


class _WithItsName(argparse.Action):
    """Keeps the words after `--ros-args`, and the option itself before them."""

    def __call__(self, parser, namespace, values, option_string=None) -> None:
        namespace.ros_args = [option_string, *values]


def _seconds(text: str) -> float:
    try:
        return seconds_typed(text)
    except ValueError as fault:
        raise argparse.ArgumentTypeError(str(fault)) from None


def _words_of(line: str) -> list[str]:
    """Return the words after `ros2` of a line as one would type it.

    Raises:
        ValueError: it is not a tool that there is.
    """
    words = words_of_line(line)
    if words[:1] == ["ros2"]:
        return words[1:]
    if words[:1] == ["rviz2"]:
        return ["run", "rviz2", *words]
    raise ValueError(f'--with takes a line that begins with ros2, such as "ros2 topic hz /tf", not {line!r}')


def _program(words: Sequence[str], codes: list[int] | None = None) -> Callable[[], None]:
    def program() -> None:
        code = ros2_words.main(words)
        if codes is not None:
            codes.append(code)

    return program


def _run_files(paths: Sequence[str], **options: Any) -> int:
    from tflab.ros.graph import current_graph  # only now: long to load, and --help must not wait for it
    from tflab.ros.run import run_files

    code = run_files(paths, **options)
    if any(each.is_running for each in current_graph().participants):
        # It sits in a call that nothing interrupts, such as input(); waiting for it, Python itself would abort.
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(code)
    return code


def _refuse(fault: Exception | str) -> int:
    print(f"tflab run: {fault}", file=sys.stderr)
    return 2
