"""Run a ROS 2 command from a page as a node of the current graph, for some seconds of the graph's time.

    %ros2 run tf2_ros tf2_echo map odom            3.5 s of the graph, then Ctrl-C
    %ros2 --for 10 run tf2_ros tf2_echo map odom   10 s, then Ctrl-C
    %ros2 run tf2_ros static_transform_publisher   started, and left running: a terminal of its own
    %ros2 bag play drive &                         the same with any tool (a background job), until graph.stop()
    %ros2 topic info /tf                           until it has ended

Time stands still before and after.  A tool that waits for something that never
comes is stopped, and that is said.
"""

from __future__ import annotations

import os
import shlex
from collections.abc import Sequence
from typing import Any, NamedTuple

from tflab.core import NSEC_PER_SEC
from tflab.core.stamps import seconds_typed
from tflab.ros.graph import Graph, Participant

from . import ros2

__all__ = ["LineError", "ToolResult", "run_words", "split_line", "words_of_line"]

LIMIT_S = 60.0  # of the graph's time, for a tool that ends by itself
STEP_S = 0.05


class LineError(Exception):
    """The line cannot be run; the text says why, and what to type instead."""


class ToolResult(NamedTuple):
    """How a tool ended: its exit code, None if it runs on or was stopped, and the pictures it has for the page."""

    exit_code: int | None
    pictures: tuple[Any, ...] = ()


def words_of_line(line: str, *, comments: str = "", backslash_escapes: bool = os.name != "nt") -> list[str]:
    """Return the words of a line as a shell has them; on Windows a backslash is part of a path.

    Raises:
        ValueError: unbalanced quotes.
    """
    reader = shlex.shlex(line, posix=True)
    reader.whitespace_split = True
    reader.commenters = comments
    reader.escape = "\\" if backslash_escapes else ""
    return list(reader)


def split_line(line: str) -> tuple[float | None, list[str]]:
    """Return how long to run [s], None if that is not said, and the words after `ros2`, a last "&" among them.

    Raises:
        LineError: unbalanced quotes, or `--for` without a time.
    """
    in_background = line.rstrip().endswith("&")
    try:
        words = words_of_line(line.rstrip().removesuffix("&"), comments="#")
    except ValueError as fault:
        raise LineError(f"cannot read the line: {fault}") from None
    words += ["&"] if in_background else []
    words = words[1:] if words[:1] == ["ros2"] else words
    if "--for" in words[1:]:
        raise LineError("--for stands first, before the tool: %ros2 --for 3 topic hz /tf")
    seconds = None
    if words and words[0].partition("=")[0] == "--for":
        first = words.pop(0)
        text = first.partition("=")[2] if "=" in first else words.pop(0) if words else ""
        try:
            seconds = seconds_typed(text)
        except ValueError:
            raise LineError(
                f"--for needs a time in seconds, such as `%ros2 --for 3 topic hz /tf`, not {text!r}"
            ) from None
    return seconds, ["run", "rviz2", *words] if words[:1] == ["rviz2"] else words


def run_words(
    graph: Graph, words: Sequence[str], seconds: float | None = None, ros_args: Sequence[str] = ()
) -> ToolResult:
    """Run `ros2` with these words on the graph; for `seconds` [s] of its time, as long as suits the tool if None.

    With "&" as the last word the tool is started and left running, to its end or for `seconds`.
    `ros_args` are for the tool's nodes, such as ["--ros-args", "-p", "use_sim_time:=true"].
    """
    in_background = words[-1:] == ["&"]
    words = words[:-1] if in_background else words
    try:
        plan = ros2.plan(words)
    except SystemExit as stop:  # help, or a wrong option, which argparse has explained
        return ToolResult(stop.code or 0)
    pictures: list[Any] = []
    codes: list[int] = []
    name = f"ros2 {' '.join(words)}"
    participant = graph.start(lambda: codes.append(plan.run(pictures)), name=name, argv=[name, *ros_args])
    if in_background and seconds is not None:
        graph.driver.call_after(round(seconds * NSEC_PER_SEC), participant.interrupt)
    if in_background or (plan.stays and seconds is None):
        return ToolResult(codes[0] if codes else None)
    span_s = seconds if seconds is not None else plan.page_s
    _let_run(graph, participant, LIMIT_S if span_s is None else span_s, counts_from_beginning=seconds is not None)
    if participant.is_running:
        _stop(graph, participant, should_have_ended=span_s is None)
    failed = None if isinstance(participant.exception, (KeyboardInterrupt, type(None))) else 1
    return ToolResult(codes[0] if codes else failed, tuple(pictures))


def _stop(graph: Graph, participant: Participant, should_have_ended: bool) -> None:
    """Stop a tool as Ctrl-C does, and say so if it should have ended by itself."""
    graph.stop(participant)
    if should_have_ended:
        print(
            f"`{participant.name}` did not end within {LIMIT_S:g} s of the graph's time, and was stopped.\n"
            "Is the node that it waits for running, and spinning?  `%ros2 --for SECONDS ...` gives it longer."
        )


def _let_run(graph: Graph, participant: Participant, span_s: float, counts_from_beginning: bool) -> None:
    """Let time pass while a tool runs, `span_s` [s] at most; from when it has what it waited for, if it says so."""
    span_ns = round(span_s * NSEC_PER_SEC)
    until_ns = graph.now_ns + span_ns
    try:
        while participant.is_running and (left_ns := until_ns - graph.now_ns) > 0:
            graph.run(seconds=min(STEP_S, left_ns / NSEC_PER_SEC))
            if participant.began_ns is not None and not counts_from_beginning:
                until_ns = participant.began_ns + span_ns
    except KeyboardInterrupt:  # the stop button stops everything, also if it was pressed between two steps
        graph.stop()
        raise
