"""Manage contexts, from init to shutdown, and what Ctrl-C does to them.

    rclpy.init()  -->  context ok  -->  rclpy.shutdown(): nodes leave the graph, spins end

Ctrl-C shuts the contexts down first, and then interrupts. So on ROS 2 a program that
ends with `finally: rclpy.shutdown()` raises an RCLError there, and callbacks of
`on_shutdown` are not called. In pages there is no signal: `graph.stop()` interrupts and
leaves the context valid.
"""

from __future__ import annotations

import signal
import threading
import warnings
import weakref
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from enum import IntEnum
from types import FrameType
from typing import Any

from . import distro
from .arguments import Arguments, parse_arguments
from .exceptions import RCLError
from .graph import current_process
from .logging import set_logger_level

__all__ = ["Context", "SignalHandlerOptions", "install_signal_handlers", "uninstall_signal_handlers"]


ALREADY_SHUT_DOWN = "failed to shutdown: rcl_shutdown already called on the given context, at ./src/rcl/init.c:333"
AFTER_CTRL_C = "tflab: Ctrl-C shut the context down, as on a robot. Write rclpy.try_shutdown(), not rclpy.shutdown()."
ENTERED = "init() must be called on a Context before using it in a Python context manager. Calling init() with no "
ENTERED += "arguments, this usage is deprecated"


class Context:
    """One run of ROS within a process.

    Attributes:
        process: the one it was made in.
        arguments: what the command line said.
    """

    def __init__(self) -> None:
        self.process = current_process()
        self.arguments = Arguments()
        self._state = "new"
        self._is_interrupted = False
        self._domain_id = 0
        self._nodes: list[Any] = []
        self._callbacks: list[tuple[Callable[[], Any], bool]] = []  # and whether Ctrl-C calls it
        self._waiters: list[Any] = []
        self._lock = threading.RLock()

    def init(
        self,
        args: Sequence[str] | None = None,
        *,
        initialize_logging: bool = True,
        domain_id: int | None = None,
    ) -> None:
        """Begin; `args` is the command line, the process's own if None.

        Raises:
            RuntimeError: it has begun before.
        """
        with self._lock:
            if domain_id is not None and domain_id < 0:
                raise RuntimeError(f"Domain id ({domain_id}) should not be lower than zero.")
            if self._state != "new":
                raise RuntimeError("Context.init() must only be called once")
            self.arguments = parse_arguments(self.process.arguments() if args is None else args)
            self._domain_id = domain_id or 0
            self._state = "ok"
            self.process.contexts.append(self)
        for logger, severity in self.arguments.log_levels:
            set_logger_level(logger, severity)

    def ok(self) -> bool:
        """Return whether it has begun and not been shut down."""
        return self._state == "ok"

    def get_domain_id(self) -> int:
        """Return the number that init() was given."""
        return self._domain_id

    def track_node(self, node: Any) -> None:
        """Remember a node, which ends with the context or with the process."""
        self._nodes.append(node)

    def untrack_node(self, node: Any) -> None:
        """Forget a node."""
        if node in self._nodes:
            self._nodes.remove(node)

    def shutdown(self) -> None:
        """End: take the nodes out of the graph, from Lyrical on by their destroy_node(), and wake whoever waits.

        Raises:
            RuntimeError: it has not begun.
            RCLError: it was shut down before.
        """
        if self._state == "new":
            raise RuntimeError("Context must be initialized before it can be shutdown")
        self._destroy_nodes()
        if not self.try_shutdown():
            error = RCLError(ALREADY_SHUT_DOWN)
            if self._is_interrupted:
                error.__notes__ = [AFTER_CTRL_C]
            raise error

    def try_shutdown(self) -> bool:
        """End, if it has begun and not ended; return whether it did so now."""
        with self._lock:
            if self._state != "ok":
                return False
            self._destroy_nodes()
            self._state = "shut down"
            if self in self.process.contexts:
                self.process.contexts.remove(self)
        self._after_shutdown()
        return True

    def signalled(self) -> None:
        """End as Ctrl-C ends it: nodes stay, nothing spins any more, and no callback of on_shutdown() is called."""
        with self._lock:
            if self._state != "ok":
                return
            self._state = "shut down"
            self._is_interrupted = True
            self._callbacks = [row for row in self._callbacks if row[1]]
        self._after_shutdown()

    def end(self) -> None:
        """End because the process does: the nodes leave the graph, and nobody calls their destroy_node()."""
        self._callbacks.clear()
        for node in list(self._nodes):
            node.leave_graph()
        self.try_shutdown()

    def on_shutdown(self, callback: Callable[[], None], *, at_ctrl_c: bool = False) -> None:
        """Have `callback()` called once at shutdown(), at Ctrl-C only if asked; at once if the end has been.

        Raises:
            TypeError: it cannot be called.
        """
        if not callable(callback):
            raise TypeError("callback should be a callable, got {}", type(callback))
        if self._state == "shut down":
            callback()
        elif hasattr(callback, "__self__"):
            reference = weakref.WeakMethod(callback)
            self._callbacks.append((lambda: (method := reference()) and method(), at_ctrl_c))
        else:
            self._callbacks.append((callback, at_ctrl_c))

    @contextmanager
    def waking(self, waiter: Any) -> Iterator[None]:
        """Have somebody who waits woken at the end."""
        self._waiters.append(waiter)
        try:
            yield
        finally:
            self._waiters.remove(waiter)

    def _after_shutdown(self) -> None:
        callbacks, self._callbacks = self._callbacks, []
        for callback, _ in callbacks:
            callback()
        for waiter in self._waiters:
            waiter.wake()

    def _destroy_nodes(self) -> None:
        for node in list(self._nodes):
            # Where shutdown() leaves the nodes alone, the garbage collector takes them out of the graph on a robot.
            node.destroy_node() if distro.current().shutdown_destroys_nodes else node.leave_graph()

    def __enter__(self) -> Context:
        text = "'Context' object does not support the context manager protocol"
        distro.require("context_is_context", TypeError, text)
        has_begun = distro.current().context_entry_warns and self._state != "new"
        if distro.current().context_entry_warns and not has_begun:
            warnings.warn(ENTERED, stacklevel=2)
        if not has_begun:
            self.init()
        return self

    def __exit__(self, *exc: object) -> None:
        self.try_shutdown()


class SignalHandlerOptions(IntEnum):
    """Which signals rclpy.init() listens to."""

    NO = 0
    SIGINT = 1
    SIGTERM = 2
    ALL = 3


_before: Any = None


def install_signal_handlers(options: SignalHandlerOptions = SignalHandlerOptions.ALL) -> None:
    """Have Ctrl-C shut down the contexts of a script in real time; elsewhere do nothing."""
    global _before
    process = current_process()
    in_script = process is process.graph.main and not process.driver.is_virtual
    if not in_script or not options & SignalHandlerOptions.SIGINT or _before is not None:
        return
    if threading.current_thread() is threading.main_thread() and signal.getsignal(signal.SIGINT) is not None:
        _before = signal.signal(signal.SIGINT, _on_interrupt)


def uninstall_signal_handlers() -> None:
    """Give Ctrl-C back to Python."""
    global _before
    if _before is not None and threading.current_thread() is threading.main_thread():
        signal.signal(signal.SIGINT, _before)
        _before = None


def _on_interrupt(number: int, frame: FrameType | None) -> None:
    for context in list(current_process().contexts):
        context.signalled()
    if callable(_before):
        _before(number, frame)
