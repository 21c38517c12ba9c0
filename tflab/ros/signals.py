"""What does Ctrl-C do?  It shuts the contexts down first, and then interrupts.

So on ROS 2 a program that ends with `finally: rclpy.shutdown()` ends with an
RCLError: the context is shut down already.  In pages there is no signal:
`graph.stop()` interrupts and leaves the context valid.
"""

from __future__ import annotations

import signal
import threading
from enum import IntEnum
from types import FrameType
from typing import Any

from .graph import current_process

__all__ = ["SignalHandlerOptions", "install_signal_handlers", "uninstall_signal_handlers"]


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
