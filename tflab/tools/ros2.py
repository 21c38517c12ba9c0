"""Run `ros2 <command> <verb> ...`: a module for each command, a program for each executable.

    ros2 topic info /tf          COMMANDS["topic"] -> topic.info
    ros2 run tf2_ros tf2_echo    EXECUTABLES["tf2_ros"]["tf2_echo"] -> tf2_echo.main

A new command is one line in COMMANDS, a new program one line in EXECUTABLES; its
module is imported when it is asked for.  Errors and exit codes are those of ros2cli
and argparse: 2 for a wrong option, 1 for a refusal.

upstream: ros2cli/ros2cli/cli.py, ros2run.
"""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Callable, Sequence
from importlib import import_module
from typing import Any, NamedTuple

__all__ = ["COMMANDS", "EXECUTABLES", "Executable", "Plan", "main", "plan", "verbs_of"]


class Executable(NamedTuple):
    """A program of a package.

    Attributes:
        module: where its `main(arguments)` is; it returns the exit code.
        stays: in a page it goes on running after the cell, as in a terminal of its own.
        page_s: how long a page runs it if it is not told [s], from when it has what it waits for; None: until it ends.
        shows: its main also takes a list, to which it appends pictures.
    """

    module: str
    stays: bool = False
    page_s: float | None = None
    shows: bool = False


class Ros2Command(NamedTuple):
    """A command of `ros2`: what its help says, and the module whose `add_verbs(verbs)` adds its verbs."""

    help: str
    module: str


COMMANDS = {
    "action": Ros2Command("Various action related sub-commands", "tflab.tools.action"),
    "bag": Ros2Command("Various rosbag related sub-commands", "tflab.tools.bag"),
    "interface": Ros2Command("Show information about ROS interfaces", "tflab.tools.interface"),
    "launch": Ros2Command("Run a launch file", "tflab.tools.launch"),
    "lifecycle": Ros2Command("Various lifecycle related sub-commands", "tflab.tools.lifecycle"),
    "node": Ros2Command("Various node related sub-commands", "tflab.tools.node"),
    "param": Ros2Command("Various param related sub-commands", "tflab.tools.param"),
    "run": Ros2Command("Run a package specific executable", ""),
    "service": Ros2Command("Various service related sub-commands", "tflab.tools.service"),
    "topic": Ros2Command("Various topic related sub-commands", "tflab.tools.topic"),
}

EXECUTABLES = {
    "robot_state_publisher": {
        "robot_state_publisher": Executable("tflab.robots.state_publisher", stays=True),
    },
    "rviz2": {"rviz2": Executable("tflab.tools.rviz2")},
    "tf2_ros": {
        "static_transform_publisher": Executable("tflab.tools.static_transform_publisher", stays=True),
        "tf2_echo": Executable("tflab.tools.tf2_echo", page_s=3.5),
        "tf2_monitor": Executable("tflab.tools.tf2_monitor", page_s=11.0),
    },
    "tf2_tools": {"view_frames": Executable("tflab.tools.view_frames", shows=True)},
    "turtlesim": {"turtlesim_node": Executable("tflab.robots.turtlesim", stays=True)},
}

CLOSED_PIPE = 141  # what a shell says of a program that wrote to a reader who has gone

# How long a page runs a verb that would go on for ever, or very long [s].
PAGE_SECONDS = {"echo": 2.0, "hz": 3.5, "delay": 3.5, "pub": 3.5, "record": 5.0, "play": 3600.0}


class Plan(NamedTuple):
    """A command line that was understood, and can be run.

    Attributes:
        words: what was typed, without `ros2`.
        run: runs it, on the current process's graph; takes a list for pictures, returns the exit code.
        stays, page_s: as of an Executable.
    """

    words: tuple[str, ...]
    run: Callable[[list[Any]], int]
    stays: bool = False
    page_s: float | None = None


def main(words: Sequence[str]) -> int:
    """Run `ros2` with these words to its end; return the exit code."""
    try:
        return plan(words).run([])
    except SystemExit as stop:  # argparse's way to end, after --help or a wrong option
        return stop.code or 0


def plan(words: Sequence[str]) -> Plan:
    """Understand what was typed, without running it.

    Raises:
        SystemExit: help was asked for and printed, or the words are wrong and argparse has said so.
    """
    options = _parser(words).parse_args(list(words))
    if options.command is None:
        options.command_parser.print_help()
        raise SystemExit(0)
    if options.command == "run":
        return _plan_executable(words, options)
    if not hasattr(options, "run"):
        options.command_parser.print_help()
        raise SystemExit(0)
    is_endless = getattr(options, "loop", False)
    ends_by_itself = getattr(options, "once", False) or getattr(options, "times", 0)
    page_s = None if ends_by_itself or is_endless else PAGE_SECONDS.get(getattr(options, "verb", ""))
    stays = options.command == "launch" and not options.show_args
    return Plan(tuple(words), lambda pictures: _exit_code(lambda: options.run(options)), stays, page_s)


def verbs_of(command: str) -> list[str]:
    """Return the verbs of a command, for completion."""
    if command not in COMMANDS or command in ("launch", "run"):
        return []
    parser = argparse.ArgumentParser()
    verbs = parser.add_subparsers()
    import_module(COMMANDS[command].module).add_verbs(verbs)
    return sorted(verbs.choices)


# -- the parser -----------------------------------------------------------


def _parser(words: Sequence[str]) -> argparse.ArgumentParser:
    """Return the parser of `ros2`; of the commands only the one that was typed gets its verbs."""
    parser = argparse.ArgumentParser(prog="ros2", description="ros2 is an extensible command-line tool for ROS 2.")
    parser.set_defaults(command_parser=parser)
    commands = _subparsers(parser, "ros2", "command")
    for name, command in COMMANDS.items():
        sub = commands.add_parser(name, help=command.help, description=command.help)
        if name == "run":
            _add_run(sub)
        elif name == "launch" and name in words:
            import_module(command.module).add_options(sub)
        elif name in words:
            sub.set_defaults(command_parser=sub)
            import_module(command.module).add_verbs(_subparsers(sub, f"ros2 {name}", "verb"))
    return parser


def _subparsers(parser: argparse.ArgumentParser, prog: str, dest: str) -> argparse._SubParsersAction:
    detail = f"Call `{prog} <command> -h` for more detailed usage."
    return parser.add_subparsers(title="Commands", dest=dest, metavar=detail)


def _add_run(sub: argparse.ArgumentParser) -> None:
    sub.add_argument("package_name", help="Name of the ROS package")
    sub.add_argument("executable_name", help="Name of the executable")
    sub.add_argument("argv", nargs=argparse.REMAINDER, help="Pass arbitrary arguments to the executable")


# -- running --------------------------------------------------------------


def _plan_executable(words: Sequence[str], options: argparse.Namespace) -> Plan:
    from tflab.ros.arguments import remove_ros_args
    from tflab.ros.graph import current_process
    from tflab.ros.run import run_entry_point
    from tflab.ros.workspace import find_executable

    package = EXECUTABLES.get(options.package_name, {})
    executable = package.get(options.executable_name)
    try:
        entry = None if executable else find_executable(options.package_name, options.executable_name)
    except LookupError as fault:
        refusal = "No executable found" if package else str(fault)
        return Plan(tuple(words), lambda pictures: _refuse(refusal))

    def run(pictures: list[Any]) -> int:
        process = current_process()
        # rclpy.init() reads the --ros-args there; those that the process was started with come last.
        process.argv = [options.executable_name, *options.argv, *(process.argv or [])[1:]]
        if executable is None:
            try:
                run_entry_point(entry)
                code = 0
            except SystemExit as stop:  # its other exceptions are reported with their traceback
                code = stop.code if isinstance(stop.code, int | None) else _refuse(str(stop.code))
        else:
            program = import_module(executable.module).main
            arguments = remove_ros_args(process.argv)[1:]
            code = _exit_code(lambda: program(arguments, pictures) if executable.shows else program(arguments))
        if code:
            print(f"[ros2run]: {'Aborted' if code < 0 else f'Process exited with failure {code}'}", flush=True)
        return code or 0

    if executable is None:
        return Plan(tuple(words), run, stays=True)
    helps = {"-h", "--help"} & set(options.argv)
    return Plan(tuple(words), run, stays=executable.stays and not helps, page_s=executable.page_s)


def _exit_code(program: Callable[[], int | str | None]) -> int:
    """Return the exit code of a program; a text is its last word, on standard error."""
    try:
        outcome = program()
    except SystemExit as stop:
        outcome = stop.code
    except RuntimeError as refusal:
        outcome = str(refusal)
    except BrokenPipeError:  # whoever read the output has gone, as `| head -1` does: nobody is left to write to
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return CLOSED_PIPE
    except OSError as fault:  # a disk that is full
        outcome = f"ros2: {fault}"
    return _refuse(outcome) if isinstance(outcome, str) else outcome or 0


def _refuse(text: str) -> int:
    print(text, file=sys.stderr, flush=True)
    return 1
