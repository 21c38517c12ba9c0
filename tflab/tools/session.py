"""Give a tool its own rclpy session: init, a node, spin, shutdown.

    with tool_node("tf2_echo") as node:      rclpy.init(), Node, ... destroy_node(), shutdown()
        spin_for(node, 1.0)                  callbacks run; Ctrl-C ends it

Whoever runs the tool decides on which graph and clock: a page on virtual time, a
shell on wall time.
"""

from __future__ import annotations

import hashlib
import string
import sys
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from datetime import timezone
from typing import Any

from tflab.core import NSEC_PER_SEC, BufferCore
from tflab.ros import client_library
from tflab.ros.clock import JumpThreshold, TimeJump
from tflab.ros.graph import Graph, current_process
from tflab.ros.logging import RcutilsLogger
from tflab.ros.node import Node
from tflab.ros.task import Future
from tflab.ros.time import Duration

__all__ = [
    "CPP_AUTHORITY",
    "abort",
    "answer_of",
    "call_service",
    "cli_node",
    "cpp_listener",
    "display_time_zone",
    "log_as_root",
    "result_of",
    "spin",
    "spin_for",
    "spin_until_done",
    "tool_node",
    "unused_name",
]

DISCOVERY_S = 0.5  # how long a command looks around before it answers; on virtual time everybody is known at once
MOMENT_S = 0.01
CPP_AUTHORITY = "Authority undetectable"  # under which rclcpp's listener stores what it hears
ABORTED = -6  # what the parent of a process sees that called abort()


@contextmanager
def tool_node(name: str, **options) -> Iterator[Node]:
    """Begin a program, give it a node of that name, and end it; `options` are those of Node."""
    client_library.init()
    try:
        node = Node(name, **options)
        yield node
        node.destroy_node()
    finally:
        client_library.try_shutdown()


@contextmanager
def cli_node() -> Iterator[Node]:
    """Give one of the `ros2` commands its node, hidden and without services."""
    name = unused_name("_ros2cli_", (), digits=string.digits, length=5)
    with tool_node(name, start_parameter_services=False) as node:
        if not current_process().driver.is_virtual:
            spin_for(node, DISCOVERY_S)
        yield node


def result_of(graph: Graph, program: Callable[[], Any], seconds: float, name: str) -> Any:
    """Return what a program returns that looks at a graph for `seconds` [s] of its time.

    Raises:
        ValueError: that is no time to look for.
        RuntimeError: the program came to nothing; what ended it has been printed.
    """
    if not isinstance(seconds, (int, float)) or not 0 <= seconds < float("inf"):
        raise ValueError(f"how long to look is a time in seconds, 0 or more, such as seconds=2.0, not {seconds!r}")
    results: list[Any] = []
    participant = graph.start(lambda: results.append(program()), name=name)
    graph.run(seconds=seconds)
    while participant.is_running:  # a program may take a moment longer
        graph.run(seconds=MOMENT_S)
    if not results:
        raise RuntimeError(f'"{name}" was ended before it had seen anything') from participant.exception
    return results[0]


def unused_name(
    prefix: str, arguments: Sequence[str], digits: str = string.digits + string.ascii_letters, length: int = 16
) -> str:
    """Return a name that no node has: `prefix` and what looks random, but follows from the arguments.

    Upstream draws it; here the same page prints the same name every time.
    """
    taken = {node.get_name() for node in current_process().graph.network.nodes}
    number = 0
    while True:
        digest = hashlib.sha256(repr((list(arguments), number)).encode()).digest()
        name = prefix + "".join(digits[byte % len(digits)] for byte in digest[:length])
        if name not in taken:
            return name
        number += 1


# -- spinning -------------------------------------------------------------


def spin(node: Node) -> None:
    """Run callbacks until stopped."""
    client_library.spin(node)


def spin_for(node: Node, duration_s: float) -> None:
    """Run callbacks for a while [s].

    Raises:
        KeyboardInterrupt: the tool is to end.
    """
    executor, driver = client_library.get_global_executor(), current_process().driver
    executor.add_node(node)
    until_ns = driver.steady_ns() + round(duration_s * NSEC_PER_SEC)
    while (left_ns := until_ns - driver.steady_ns()) > 0:
        if not node.context.ok():
            raise KeyboardInterrupt
        executor.spin_once(timeout_sec=left_ns / NSEC_PER_SEC)


def display_time_zone() -> timezone | None:
    """Return the time zone to print: UTC on virtual time, which begins in 1970 everywhere; the machine's own (None)."""
    return timezone.utc if current_process().driver.is_virtual else None


def spin_until_done(node: Node, future: Future) -> None:
    """Run callbacks until a future is done."""
    client_library.spin_until_future_complete(node, future)


def answer_of(node: Node, future: Future) -> Any:
    """Run callbacks until a future is done, and return its result."""
    spin_until_done(node, future)
    return future.result()


def call_service(node: Node, srv_type: type, name: str, request: Any) -> Any:
    """Return a service's answer; wait for it as long as it takes, as upstream does."""
    return answer_of(node, node.create_client(srv_type, name).call_async(request))


# -- as a C++ program does ------------------------------------------------


class _CppNode(Node):
    """A node as rclcpp makes one, as far as its terminal shows."""

    def policy_name(self, policy: str) -> str:
        return f"{policy}_QOS_POLICY"  # in every distribution


@contextmanager
def cpp_listener(node: Node) -> Iterator[BufferCore]:
    """Listen to the transforms as rclcpp's listener does: with a node of its own, which `ros2 node list` shows."""
    from tflab.ros.tf2.buffer import Buffer
    from tflab.ros.tf2.topics import TransformListener

    # Upstream's name ends with an address on the heap, in hexadecimal digits.
    name = unused_name("transform_listener_impl_55", [node.get_name()], digits=string.hexdigits[:16], length=10)
    hidden = _CppNode(name, start_parameter_services=False)
    client_library.get_global_executor().add_node(hidden)
    buffer = Buffer()
    listener = TransformListener(buffer, hidden)
    listener.authority = CPP_AUTHORITY
    threshold = JumpThreshold(min_forward=None, min_backward=Duration(nanoseconds=-1), on_clock_change=True)

    def on_jump(jump: TimeJump) -> None:
        what = "jump back in time" if jump.delta.nanoseconds < 0 else "time source change"
        RcutilsLogger("tf2_buffer").warning(f"Detected {what}. Clearing TF buffer.")
        buffer.clear()

    with node.get_clock().create_jump_callback(threshold, post_callback=on_jump):
        yield buffer.core
    listener.unregister()
    hidden.destroy_node()


def abort(kind: str, what: str) -> int:
    """Say what an exception says that nobody catches in C++; return the exit code."""
    print(f"terminate called after throwing an instance of '{kind}'\n  what():  {what}", file=sys.stderr, flush=True)
    return ABORTED


def log_as_root(level: str, text: str) -> None:
    """Log before there is a node: the name is empty, `[ERROR] [...] []: ...`."""
    getattr(RcutilsLogger(""), level)(text)
