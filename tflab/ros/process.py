"""Simulate processes in one Python process: each program has its own rclpy context and globals.

    graph -- process "main" (the cell, the script)     default context, global executor
         |-- process "moving_robot"                    default context, global executor
         `-- process "point_to_map"                    ...

A thread belongs to the process of the thread that started it. What rclpy keeps in
globals is kept there in thread-local storage. A process can be interrupted, as by
Ctrl-C (SIGINT), and it ends when its main function returns.

With the first graph, four things of Python are replaced, until `deactivate()`:

    sys.argv             the command line of the process that reads it
    time.sleep(s)        in a process of a graph: lets the graph's time pass, can be interrupted
    Thread(...).start()  the new thread belongs to the starter's process
    thread.join()        lets the graph's time pass
"""

from __future__ import annotations

import sys
import threading
import time
from collections.abc import Callable
from types import ModuleType
from typing import Any, TextIO

from tflab.core import NSEC_PER_SEC

from .task import Future

__all__ = ["Process", "patch_threads", "process_here", "restore_threads", "use_graph", "write_line"]


class Process:
    """What a program started in its own terminal would have to itself.

    Attributes:
        name: as reports say it.
        graph: the Graph that it lives in.
        argv: what `rclpy.init()` reads if it is given no arguments.
        contexts: those made in it, in order; the rest of ROS 2 hangs on them.
        default_context, global_executor: rclpy's two globals, None until needed.
        ended: nothing runs in it any more.
        began_ns: when what it had waited for was there, for a tool whose time counts from then [ns]; None: not yet.
        loop: where it was found in an endless loop, as "file:line in function".
    """

    def __init__(self, name: str, graph: Any, argv: list[str] | None = None) -> None:
        self.name = name
        self.graph = graph
        self.argv = argv
        self.contexts: list[Any] = []
        self.default_context: Any = None
        self.global_executor: Any = None
        self.main_thread: threading.Thread | None = None
        self.ended = False
        self.began_ns: int | None = None
        self.loop = ""
        self._interrupted = False
        self._waiting: dict[Any, None] = {}

    @property
    def driver(self) -> Any:
        """The clock and the waiting of the graph: VirtualTime or WallTime."""
        return self.graph.driver

    def arguments(self) -> list[str]:
        """Return the command line."""
        return sys.argv if self.argv is None else self.argv

    def interrupt(self, shut_down_contexts: bool = False) -> None:
        """Have the main thread raise KeyboardInterrupt at its next, or present, wait.

        Args:
            shut_down_contexts: first shut down its contexts, as the signal does on ROS 2.
        """
        self._interrupted = True
        if shut_down_contexts:
            for context in list(self.contexts):
                context.signalled()
        for waiter in list(self._waiting):
            waiter.wake()

    def take_interrupt(self) -> bool:
        """Return whether it was interrupted and has not heard of it yet; from now on it has."""
        was_interrupted, self._interrupted = self._interrupted, False
        return was_interrupted

    def end(self) -> None:
        """Take everything of it out of the graph, as an operating system would."""
        self.ended = True
        for context in list(self.contexts):
            context.end()
        for waiter in list(self._waiting):
            waiter.wake()

    def loop_text(self) -> str:
        """Return the report of an endless loop; `loop` says where it was found."""
        return (
            f"Endless loop: it kept busy for {self.driver.patience_s:g} s of real time without sleeping or spinning, "
            f"at {self.loop}. Let it wait for something: rclpy.spin(node), rclpy.spin_once(node, timeout_sec=...), or "
            "time.sleep(...)."
        )

    def lost(self, where: str) -> None:
        """Give up a thread that keeps busy, and cannot even be interrupted."""
        self.loop = where
        write_line(f'participant "{self.name}" was given up. {self.loop_text()}')
        self.end()

    def wait(self, waiter: Any, duration_ns: int | None) -> None:
        """Block until `waiter` is woken, or for `duration_ns` [ns].

        Raises:
            KeyboardInterrupt: the process was interrupted, and this is its main thread.
            SystemExit: the process has ended, and this thread is left over.
        """
        self.check()
        self._waiting[waiter] = None
        try:
            self.driver.wait(waiter, duration_ns)
        finally:
            self._waiting.pop(waiter, None)
        self.check()

    def sleep(self, duration_ns: int) -> None:
        """Let `duration_ns` [ns] pass."""
        driver = self.driver
        waiter = driver.new_waiter()
        until_ns = driver.steady_ns() + duration_ns
        while (left_ns := until_ns - driver.steady_ns()) > 0:
            self.wait(waiter, left_ns)

    def wait_until(self, ready: Callable[[], bool], waiter: Any, duration_ns: int | None) -> bool:
        """Block until `ready()`, asked again whenever `waiter` is woken; return whether it is."""
        driver = self.driver
        until_ns = None if duration_ns is None else driver.steady_ns() + duration_ns
        while not ready():
            left_ns = None if until_ns is None else until_ns - driver.steady_ns()
            if left_ns is not None and left_ns <= 0:
                return False
            self.wait(waiter, left_ns)
        return True

    def wait_for(self, future: Future, duration_ns: int | None = None) -> bool:
        """Block until a future is done, which somebody else must bring about; return whether it is."""
        waiter = self.driver.new_waiter()
        future.add_done_callback(lambda _: waiter.wake())
        return self.wait_until(future.done, waiter, duration_ns)

    def check(self) -> None:
        """Raise a pending interruption of the process; see wait()."""
        if self.ended and self.main_thread is not None:
            raise SystemExit
        if threading.current_thread() is self.main_thread and self.take_interrupt():
            raise KeyboardInterrupt


def write_line(text: str, stream: TextIO | None = None) -> None:
    """Write text and its line end at once, to standard error if None, so that the lines of others stay whole."""
    stream = sys.stderr if stream is None else stream
    stream.write(f"{text}\n")
    stream.flush()


_graph: Any = None


def use_graph(graph: Any) -> Any:
    """Make a Graph, or None, the current one of this Python; return the one before."""
    global _graph
    before, _graph = _graph, graph
    return before


def process_here() -> Process | None:
    """Return the process that this thread belongs to: its starter's, or the current graph's main one, if any."""
    process = getattr(threading.current_thread(), "tflab_process", None)
    if process is None and _graph is not None:
        return _graph.main
    return process


_sleep, _start, _join = time.sleep, threading.Thread.start, threading.Thread.join


def patch_threads() -> None:
    """Put the four in place."""
    sys.__class__ = _SysOfProcess
    time.sleep = sleep
    threading.Thread.start = start
    threading.Thread.join = join


def restore_threads() -> None:
    """Give Python its own back."""
    sys.__class__ = ModuleType
    time.sleep = _sleep
    threading.Thread.start = _start
    threading.Thread.join = _join


class _SysOfProcess(ModuleType):
    """`sys`, but that each process has a command line of its own."""

    @property
    def argv(self) -> list[str]:
        return getattr(process_here(), "argv", None) or vars(self)["argv"]

    @argv.setter
    def argv(self, words: list[str]) -> None:
        vars(process_here() or self)["argv"] = words


def sleep(seconds: float) -> None:
    """Sleep [s], on the time of whoever calls."""
    process = process_here()
    if process is None or not (process.driver.is_cooperative() or process.main_thread is threading.current_thread()):
        _sleep(seconds)
        return
    if seconds < 0:
        raise ValueError("sleep length must be non-negative")
    process.sleep(round(seconds * NSEC_PER_SEC))


def start(thread: threading.Thread) -> None:
    """Start a thread in the process of whoever calls."""
    process = process_here()
    if process is not None and not hasattr(thread, "tflab_process"):
        thread.tflab_process = process
        if process.driver.is_virtual and (process.driver.is_cooperative() or _spins(thread)):
            process.driver.adopt(thread, process)
    _start(thread)


def join(thread: threading.Thread, timeout: float | None = None) -> None:
    """Wait for a thread, on the time of whoever calls."""
    scheduled = getattr(thread, "tflab_scheduled", None)
    if scheduled is not None and not scheduled.is_finished:
        scheduled.process.driver.join(scheduled, None if timeout is None else round(timeout * NSEC_PER_SEC))
        if not scheduled.is_finished:
            return  # the timeout is over, in the graph's time
    _join(thread, timeout)


def _spins(thread: threading.Thread) -> bool:
    """Return whether a thread was made to run one of our functions, such as rclpy.spin."""
    target = getattr(thread, "_target", None)
    return (getattr(target, "__module__", None) or "").startswith("tflab.ros")
