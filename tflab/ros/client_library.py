"""Provide the functions of the module `rclpy`: init, create_node, spin, shutdown; and wait_for_message.

    rclpy.init()              the process's default context begins
    node = Node("name")       a node joins the graph
    rclpy.spin(node)          its callbacks run, until Ctrl-C
    rclpy.shutdown()          the context ends

    found, scan = wait_for_message(LaserScan, node, "scan", time_to_wait=1.0)

`wait_for_message` blocks and needs no spin: the message is taken where it arrives.
Messages published before are missed, unless both sides are transient local.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from typing import Any

from tflab.core import NSEC_PER_SEC

from . import distro
from .context import Context, SignalHandlerOptions, install_signal_handlers, uninstall_signal_handlers
from .executors import Executor, SingleThreadedExecutor
from .graph import current_process
from .messages import copy_message
from .messages.base import Message
from .network import Envelope
from .node import Node
from .qos import QoSProfile
from .task import Future
from .topic_endpoints import Subscription

__all__ = [
    "create_node",
    "get_default_context",
    "get_global_executor",
    "init",
    "ok",
    "rmw_implementation",
    "shutdown",
    "spin",
    "spin_once",
    "spin_until_future_complete",
    "timeout_sec_to_nsec",
    "try_shutdown",
    "wait_for_message",
]


class InitContextManager:
    """What rclpy.init() returns from Lyrical on, for `with rclpy.init(): ...`."""

    def __init__(self, context: Context) -> None:
        self.context = context

    def __enter__(self) -> InitContextManager:
        return self

    def __exit__(self, *exc: object) -> None:
        is_default = self.context is self.context.process.default_context
        try_shutdown(context=None if is_default else self.context, uninstall_handlers=True)


def get_default_context(*, shutting_down: bool = False) -> Context:
    """Return this process's default context; it gets a new one if this one is `shutting_down`."""
    process = current_process()
    if process.default_context is None:
        process.default_context = Context()
    context = process.default_context
    if shutting_down:
        process.default_context = None
    return context


def init(
    *,
    args: Sequence[str] | None = None,
    context: Context | None = None,
    domain_id: int | None = None,
    signal_handler_options: SignalHandlerOptions | None = None,
) -> InitContextManager | None:
    """Begin; `args` is the command line (sys.argv if None), of which `--ros-args` concern ROS.

    Return a context manager that ends it, from Lyrical on.
    """
    is_default = context is None
    context = get_default_context() if context is None else context
    if signal_handler_options is None:
        signal_handler_options = SignalHandlerOptions.ALL if is_default else SignalHandlerOptions.NO
    install_signal_handlers(signal_handler_options)
    context.init(args, domain_id=domain_id)
    return InitContextManager(context) if distro.current().init_is_context else None


def ok(*, context: Context | None = None) -> bool:
    """Return whether the context has begun and not ended."""
    return (get_default_context() if context is None else context).ok()


def shutdown(*, context: Context | None = None, uninstall_handlers: bool | None = None) -> None:
    """End.

    Raises:
        RuntimeError: it has not begun.
        RCLError: it has ended before, for instance by Ctrl-C.
    """
    is_default = context is None
    (get_default_context(shutting_down=True) if context is None else context).shutdown()
    if uninstall_handlers or (uninstall_handlers is None and is_default):
        uninstall_signal_handlers()


def try_shutdown(*, context: Context | None = None, uninstall_handlers: bool | None = None) -> None:
    """End, unless that has happened already."""
    is_default = context is None
    context = get_default_context() if context is None else context
    context.try_shutdown()
    if is_default and not context.ok():
        current_process().default_context = None
    if uninstall_handlers or (uninstall_handlers is None and is_default):
        uninstall_signal_handlers()


def rmw_implementation() -> str:
    """Return what stands below rclpy, where a robot has a DDS vendor: nothing but this process."""
    return "rmw_tflab_in_process"


def timeout_sec_to_nsec(timeout_sec: float | None) -> int:
    """Return a timeout [s] as rclpy's lower half takes it [ns], truncated; -1 is for ever."""
    if timeout_sec is None or timeout_sec < 0:
        return -1
    return int(float(timeout_sec) * NSEC_PER_SEC)


def create_node(node_name: str, **options: Any) -> Node:
    """Return a new node; `options` are those of Node."""
    return Node(node_name, **options)


def get_global_executor() -> Executor:
    """Return the executor that the spin functions use; it lasts until shutdown."""
    process = current_process()
    executor = process.global_executor
    if executor is None:
        context = get_default_context()
        executor = process.global_executor = SingleThreadedExecutor(context=context)

        def forget() -> None:
            process.global_executor = None

        context.on_shutdown(forget, at_ctrl_c=True)  # at once, if a Ctrl-C has ended the context already
    return executor


@contextmanager
def _executing(node: Node, executor: Executor | None, keeps_node: bool) -> Iterator[Executor]:
    """Give an executor, the global one if None, the node for a while; in a callback it may have had it before."""
    executor = get_global_executor() if executor is None else executor
    is_new = executor.add_node(node)
    try:
        yield executor
    finally:
        if is_new or not keeps_node:
            executor.remove_node(node)


def spin(node: Node, executor: Executor | None = None) -> None:
    """Run the callbacks of a node until the context ends, or Ctrl-C."""
    with _executing(node, executor, distro.current().spin_keeps_node) as running:
        running.spin()


def spin_once(node: Node, *, executor: Executor | None = None, timeout_sec: float | None = None) -> None:
    """Run one callback of a node; wait for it at most `timeout_sec` [s], for ever if None."""
    with _executing(node, executor, keeps_node=False) as running:
        running.spin_once(timeout_sec=timeout_sec)


def spin_until_future_complete(
    node: Node, future: Future, executor: Executor | None = None, timeout_sec: float | None = None
) -> None:
    """Run the callbacks of a node until a future is done, at most `timeout_sec` [s]."""
    with _executing(node, executor, keeps_node=True) as running:
        running.spin_until_future_complete(future, timeout_sec)


class _FirstOnly(Subscription):
    """Keeps the first envelope, and wakes whoever waits for it."""

    first: Envelope | None = None
    waiter: Any = None

    def put(self, envelope: Envelope) -> None:
        if self.first is None:
            self.first = envelope
        if self.waiter is not None:
            self.waiter.wake()


def wait_for_message(
    msg_type: type[Message],
    node: Any,
    topic: str,
    *,
    qos_profile: QoSProfile | int = 1,
    time_to_wait: float = -1,
) -> tuple[bool, Message | None]:
    """Block until a message comes; return (True, the message), or (False, None) after `time_to_wait` [s].

    A negative time is for ever.
    """
    process = node.context.process
    subscription = node.create_subscription(
        msg_type, topic, lambda message: None, qos_profile, subscription_class=_FirstOnly
    )
    subscription.waiter = process.driver.new_waiter()
    limit_ns = None if time_to_wait < 0 else round(time_to_wait * NSEC_PER_SEC)
    try:
        process.wait_until(
            lambda: subscription.first is not None or not node.context.ok(), subscription.waiter, limit_ns
        )
    finally:
        node.destroy_subscription(subscription)
    if subscription.first is None:
        return False, None
    return True, copy_message(subscription.first.message)
