"""Run node files together in real time, as `tflab run a.py b.py` does.

    a.py  -->  participant "a"  --.
    b.py  -->  participant "b"  --+--  one graph, the machine's clock  -- Ctrl-C --> all of them

Each file runs as `python file.py` would run it, in a process of its own, it
believes.  Ctrl-C does what it does on ROS 2: it shuts the contexts down first,
so a file that ends with `finally: rclpy.shutdown()` ends with an RCLError.
"""

from __future__ import annotations

import contextlib
import os
import signal
import sys
import threading
import time
import tokenize
from collections.abc import Callable, Iterator, Sequence
from types import ModuleType

from .activation import activate
from .graph import Graph, Participant, new_graph
from .process import write_line
from .virtual import counting_ctrl_c, place_of, raise_in

__all__ = ["run_files", "runner_of"]

# After Ctrl-C: how long whoever sleeps or spins takes to hear of it, and how long to tidy up [s].
HEARING_S, GRACE_S = 0.5, 5.0


def run_files(
    paths: Sequence[str],
    *,
    args: Sequence[str] = (),
    beside: Sequence[tuple[str, Callable[[], None]]] = (),
    seconds: float | None = None,
) -> int:
    """Run node files in real time until all have ended, or Ctrl-C; return 0, or 1 if one of them failed.

    Args:
        args: the command line of each, such as ["--ros-args", "-p", "use_sim_time:=true"].
        beside: (name, main function) of whatever shall run with them; when the files
            have ended these are interrupted, and when these have ended nothing happens.
        seconds: interrupt them after this time [s].

    Raises:
        FileNotFoundError: one of them does not exist; none has been started then.
        TypeError: a single path, outside of a list.
    """
    if isinstance(paths, str | os.PathLike):
        raise TypeError(f"run_files takes a list of files: run_files([{str(paths)!r}])")
    for path in paths:
        if not os.path.isfile(path):
            raise FileNotFoundError(f"no such node file: {path}")
    activate("in-process")
    graph = new_graph(virtual=False)
    is_ignored = signal.getsignal(signal.SIGINT) == signal.SIG_IGN  # in the background of a shell it is ignored
    with _importing_beside(paths), contextlib.nullcontext([]) if is_ignored else counting_ctrl_c() as pressed:
        files = [
            graph.add(runner_of(path), name=os.path.splitext(os.path.basename(path))[0], argv=[path, *args])
            for path in paths
        ]
        others = [graph.add(main, name=name) for name, main in beside]
        waiting = (graph, files or others, seconds, pressed)
        supervisor = threading.Thread(target=_supervise, args=waiting, daemon=True)
        for each in graph.participants[1:]:
            each.main_thread.start()
        supervisor.start()
        for first in graph.participants[:1]:  # this thread may set signal handlers and open windows
            first.run_here()
        while supervisor.is_alive():
            with contextlib.suppress(KeyboardInterrupt):  # meant for a file that has just ended
                supervisor.join()
    return int(any(_has_failed(each) for each in graph.participants))


def _supervise(graph: Graph, waited: Sequence[Participant], seconds: float | None, pressed: list[int]) -> None:
    """Wait until some have ended, then end the others; in a thread of its own, as a file runs in the main one."""
    _wait_for(waited, seconds, pressed)
    _interrupt([each for each in graph.participants if each.is_running], pressed)
    if any(each.is_running for each in graph.participants[:1]):  # in a call that nothing interrupts
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(1)


def runner_of(path: str) -> Callable[[], None]:
    """Return the main function that runs a file as `python file.py` would."""

    def run() -> None:
        code = compile(_source(path), path, "exec")
        module = ModuleType("__main__")
        module.__file__ = path
        exec(code, module.__dict__)

    return run


def _source(path: str) -> str:
    """Return a Python file's text: UTF-8, or what its "coding:" says.

    Raises:
        SyntaxError: it is neither.
    """
    try:
        with tokenize.open(path) as file:
            return file.read()
    except UnicodeDecodeError as fault:
        raise SyntaxError(f"{path} is not UTF-8 ({fault}); save it as UTF-8 in your editor") from None


@contextlib.contextmanager
def _importing_beside(paths: Sequence[str]) -> Iterator[None]:
    """Let each file import its neighbours, as a script can."""
    folders = list(dict.fromkeys(os.path.dirname(os.path.abspath(path)) for path in paths))
    sys.path[:0] = folders
    try:
        yield
    finally:
        for folder in folders:
            sys.path.remove(folder)


def _wait_for(participants: Sequence[Participant], seconds: float | None, pressed: list[int], presses: int = 1) -> None:
    """Wait until all have ended, the time is over, or Ctrl-C was pressed as often as `presses`."""
    until_s = None if seconds is None else time.monotonic() + seconds
    while any(each.is_running for each in participants) and len(pressed) < presses:
        if until_s is not None and time.monotonic() >= until_s:
            return
        time.sleep(0.05)


def _interrupt(participants: Sequence[Participant], pressed: list[int]) -> None:
    """Do what Ctrl-C does to each, and name whoever goes on regardless."""
    again = len(pressed) + 1  # one more Ctrl-C ends the patience
    for each in participants:
        each.interrupt(shut_down_contexts=True)
    _wait_for(participants, HEARING_S, pressed, again)
    for each in participants:
        if len(pressed) < again and each.is_running and each.take_interrupt():
            # Busy: Python interrupts in the middle of a loop, too.
            write_line(
                f'participant "{each.name}" neither slept nor spun: interrupted at {place_of(each.main_thread)}.'
            )
            raise_in(each.main_thread, KeyboardInterrupt)
            if each.main_thread is threading.main_thread() and hasattr(signal, "pthread_kill"):
                signal.pthread_kill(each.main_thread.ident, signal.SIGINT)  # also out of input()
                again += 1
    _wait_for(participants, GRACE_S, pressed, again)
    for each in participants:
        if each.is_running:
            write_line(f'participant "{each.name}" went on after it was interrupted, at {place_of(each.main_thread)}.')


def _has_failed(participant: Participant) -> bool:
    return participant.is_running or not isinstance(participant.exception, (KeyboardInterrupt, type(None)))
