"""Wait until entities of nodes are ready, and run their callbacks.

    wait --> round: of each node, what is ready: timers, subscriptions, guards, clients, services
     ^         |    (one message per subscription)
     `---------'    one callback at a time, or several with many threads

A callback that blocks keeps everything else of a single-threaded executor
waiting, the arrival of transforms included.
"""

from __future__ import annotations

import inspect
import threading
from collections import deque
from collections.abc import Callable
from typing import Any

from tflab.core import NSEC_PER_SEC

from .context import Context
from .entity import Entity, Kind
from .exceptions import ConditionReachedException, ExternalShutdownException, ShutdownException, TimeoutException
from .graph import current_process
from .task import Future, Task, _executors_with_waiting_tasks

__all__ = [
    "ConditionReachedException",
    "Executor",
    "ExternalShutdownException",
    "MultiThreadedExecutor",
    "ShutdownException",
    "SingleThreadedExecutor",
    "TimeoutException",
]

DEFAULT_THREADS = 4


class Executor:
    """What both executors share.

    Args:
        context: the default one if None.
    """

    def __init__(self, *, context: Context | None = None) -> None:
        self._process = current_process()
        if context is None:
            if self._process.default_context is None:
                self._process.default_context = Context()
            context = self._process.default_context
        self._context = context
        self._driver = self._process.driver
        self._waiter = self._driver.new_waiter()
        self._nodes: list[Any] = []
        self._tasks: list[tuple[Task, Entity | None]] = []
        self._round_tasks: deque[tuple[Task, Entity | None]] = deque()
        self._round_entities: deque[Entity] = deque()
        self._is_shutdown = False
        self._lock = threading.RLock()
        context.on_shutdown(self.wake, at_ctrl_c=True)

    @property
    def context(self) -> Context:
        """The context it belongs to."""
        return self._context

    # -- nodes and tasks ----------------------------------------------------------

    def add_node(self, node: Any) -> bool:
        """Run a node's callbacks from now on; return False if that is so already."""
        with self._lock:
            if node in self._nodes:
                return False
            self._nodes.append(node)
            node.executor = self
        self.wake()
        return True

    def remove_node(self, node: Any) -> None:
        """Leave a node alone."""
        with self._lock:
            if node not in self._nodes:
                return
            self._nodes.remove(node)
            if node.executor is self:
                node.executor = None
        self.wake()

    def get_nodes(self) -> list[Any]:
        """Return the nodes, in the order they were added."""
        with self._lock:
            return list(self._nodes)

    def create_task(self, callback: Any, *args: Any, **kwargs: Any) -> Task:
        """Have a function or coroutine executed in the next round; return its future."""
        task = Task(callback, args, kwargs, executor=self)
        with self._lock:
            self._tasks.append((task, None))
        self.wake()
        return task

    def wake(self) -> None:
        """End the present wait."""
        self._waiter.wake()

    def resume_tasks(self) -> None:
        """Let the coroutines that wait look again: some future is done."""
        with self._lock:
            for task, _ in self._tasks:
                task.may_go_on = True
        self.wake()

    def shutdown(self, timeout_sec: float | None = None) -> bool:
        """Stop; return True."""
        with self._lock:
            if not self._is_shutdown:
                self._is_shutdown = True
                for node in list(self._nodes):
                    if node.executor is self:
                        node.executor = None
                self._nodes.clear()
                self._round_entities.clear()
                self._tasks.clear()
        self.wake()
        return True

    def __enter__(self) -> Executor:
        return self

    def __exit__(self, *exc: object) -> None:
        self.shutdown()

    # -- spinning -----------------------------------------------------------------

    def spin(self) -> None:
        """Execute callbacks until the context ends or the executor is shut down."""
        with self._driver.spinning():
            while self._context.ok() and not self._is_shutdown:
                self.spin_once()

    def spin_once(self, timeout_sec: float | None = None) -> None:
        """Execute one callback; wait for it at most `timeout_sec` [s], for ever if None or negative.

        Raises:
            ExternalShutdownException: the context was shut down meanwhile.
            Exception: whatever the callback raised.
        """
        try:
            handler = self._next_handler(timeout_sec, lambda: False)
        except (ShutdownException, TimeoutException):
            return
        self._execute(handler)

    def spin_once_until_future_complete(
        self, future: Future, timeout_sec: float | Callable[[], float | None] | None = None
    ) -> None:
        """Execute one callback, unless `future` is done first."""
        future.add_done_callback(lambda _: self.wake())
        timeout_sec = timeout_sec() if callable(timeout_sec) else timeout_sec
        try:
            handler = self._next_handler(timeout_sec, future.done)
        except (ShutdownException, TimeoutException):
            return
        if handler is not None:
            self._execute(handler)

    def spin_until_future_complete(self, future: Future, timeout_sec: float | None = None) -> None:
        """Execute callbacks until `future` is done, at most `timeout_sec` [s], for ever if None or negative."""
        future.add_done_callback(lambda _: self.wake())
        until_ns = self._until_ns(timeout_sec)
        while self._context.ok() and not future.done() and not self._is_shutdown:
            left_s = None if until_ns is None else max(0, until_ns - self._driver.steady_ns()) / NSEC_PER_SEC
            self.spin_once_until_future_complete(future, left_s)
            if until_ns is not None and self._driver.steady_ns() >= until_ns:
                return

    def wait_for_ready_callbacks(
        self, timeout_sec: float | None = None, *, condition: Callable[[], bool] = lambda: False
    ) -> tuple[Task, Entity | None, Any]:
        """Return (what calls back, its entity, its node), for an executor of one's own; of a task, no entity and node.

        Raises:
            TimeoutException, ShutdownException, ExternalShutdownException: there is none.
            ConditionReachedException: `condition()` is true.
        """
        handler = self._next_handler(timeout_sec, condition)
        if handler is None:
            raise ConditionReachedException
        entity = getattr(handler, "entity", None)
        return Task(handler), entity, entity and entity.node

    def can_execute(self, entity: Entity) -> bool:
        """Return whether the group of an entity lets its callback begin now."""
        return entity.callback_group.can_execute(entity)

    def _until_ns(self, timeout_sec: float | None) -> int | None:
        if timeout_sec is None or timeout_sec < 0:
            return None
        return self._driver.steady_ns() + round(timeout_sec * NSEC_PER_SEC)

    def _execute(self, handler: Callable[[], None]) -> None:
        raise NotImplementedError

    # -- waiting --------------------------------------------------------------------

    def _next_handler(self, timeout_sec: float | None, stop: Callable[[], bool]) -> Callable[[], None] | None:
        """Return the next callback to execute, waiting for it; None as soon as `stop()`.

        Raises:
            TimeoutException, ShutdownException, ExternalShutdownException: there is none.
        """
        until_ns = self._until_ns(timeout_sec)
        poll_ns = self._driver.poll_ns if timeout_sec == 0 else 0
        while True:
            if self._is_shutdown:
                raise ShutdownException
            self._process.check()  # Ctrl-C comes before the shutdown that it causes
            if not self._context.ok():
                raise ExternalShutdownException
            if stop():
                return None
            handler = self._ready_handler()
            if handler is not None:
                return handler
            left_ns = None if until_ns is None else until_ns - self._driver.steady_ns() + poll_ns
            if left_ns is not None and left_ns <= 0:
                raise TimeoutException
            self._process.wait(self._waiter, self._shortest_wait_ns(left_ns))

    def _shortest_wait_ns(self, left_ns: int | None) -> int | None:
        """Return how long to wait at most: until the timeout, or until a timer is due."""
        with self._lock:
            for node in self._nodes:
                for timer in node.timer_list:
                    if timer.is_canceled() or timer.clock.is_simulated:
                        continue
                    if not timer.callback_group.can_execute(timer):
                        continue
                    until_ns = max(0, timer.time_until_next_call())
                    left_ns = until_ns if left_ns is None else min(left_ns, until_ns)
        return left_ns

    def _ready_handler(self) -> Callable[[], None] | None:
        """Return the next handler of this round, or of a new one; None if nothing is ready."""
        with self._lock:
            handler = self._next_of_round()
            if handler is None:
                self._new_round()
                handler = self._next_of_round()
            return handler

    def _next_of_round(self) -> Callable[[], None] | None:
        if self._round_tasks:
            return self._task_handler(*self._round_tasks.popleft())
        while self._round_entities:
            entity = self._round_entities.popleft()
            if entity.is_destroyed or entity.node not in self._nodes or not entity.is_pending():
                continue  # something has happened to it since the round began
            if entity.callback_group.beginning_execution(entity):
                return self._handler(entity)
        return None

    def _new_round(self) -> None:
        if self._tasks:
            self._tasks = [(task, entity) for task, entity in self._tasks if not task.done()]
            self._round_tasks.extend(each for each in self._tasks if each[0].may_go_on and not each[0].executing())
        for node in self._nodes:
            ready = [timer for timer in node.timer_list if timer.is_ready()]
            if node.pending:
                ready += _pending(node)
            self._round_entities.extend(entity for entity in ready if self.can_execute(entity))

    def _handler(self, entity: Entity) -> Callable[[], None]:
        """Take one thing of an entity; return what calls back with it; a coroutine is carried on in later rounds."""
        call = entity.take()

        def execute() -> None:
            result = None
            self._driver.enter_callback()
            try:
                result = call()
            finally:
                self._driver.leave_callback()
                is_coroutine = result is not None and inspect.iscoroutine(result)
                if not is_coroutine:
                    self._end_execution(entity)
            if is_coroutine:
                task = Task(result)
                with self._lock:
                    self._tasks.append((task, entity))
                self._task_handler(task, entity)()

        execute.entity = entity
        return execute

    def _task_handler(self, task: Task, entity: Entity | None) -> Callable[[], None]:
        def execute() -> None:
            _executors_with_waiting_tasks.add(self)
            self._driver.enter_callback()
            try:
                task()
            finally:
                self._driver.leave_callback()
            if not task.done():
                if task.may_go_on:
                    self.wake()
                return
            with self._lock:
                self._tasks = [each for each in self._tasks if each[0] is not task]
            if entity is not None:
                self._end_execution(entity)
            if task.exception() is not None:
                raise task.exception()

        return execute

    def _end_execution(self, entity: Entity) -> None:
        entity.callback_group.ending_execution(entity)
        pending = entity.node.pending
        if entity in pending and not entity.is_pending():
            del pending[entity]
        if pending:  # perhaps something waited for this group
            self.wake()


def _pending(node: Any) -> list[Entity]:
    """Return the entities of a node that are ready, without timers; forget those that are no longer ready."""
    pending = []
    for entity in sorted(node.pending, key=lambda entity: entity.rank):
        if not entity.is_pending():
            del node.pending[entity]
        elif entity.kind != Kind.TIMER:
            pending.append(entity)
    return pending


class SingleThreadedExecutor(Executor):
    """Runs one callback after the other, in the thread that spins."""

    def _execute(self, handler: Callable[[], None]) -> None:
        handler()


class MultiThreadedExecutor(Executor):
    """Runs callbacks in up to `num_threads` other threads, as far as their groups allow.

    Raises:
        ValueError: fewer than one thread.
    """

    def __init__(self, num_threads: int | None = None, *, context: Context | None = None) -> None:
        super().__init__(context=context)
        if num_threads is not None and num_threads < 1:
            raise ValueError(f"num_threads must be at least 1, not {num_threads}")
        # rclpy takes the number of cores; the same on every machine is easier to teach.
        self._num_threads = num_threads or DEFAULT_THREADS
        self._running = 0
        self._free = self._driver.new_waiter()
        self._errors: deque[BaseException] = deque()

    def _execute(self, handler: Callable[[], None]) -> None:
        self._process.wait_until(lambda: self._running < self._num_threads, self._free, None)
        with self._lock:
            self._running += 1
        threading.Thread(target=self._run, args=(handler,), daemon=True).start()
        self._raise_first_error()

    def spin_once(self, timeout_sec: float | None = None) -> None:
        """Begin one callback; wait for it at most `timeout_sec` [s].  Raises what earlier ones raised."""
        self._raise_first_error()
        super().spin_once(timeout_sec)

    def _next_handler(self, timeout_sec: float | None, stop: Callable[[], bool]) -> Callable[[], None] | None:
        return super()._next_handler(timeout_sec, lambda: stop() or bool(self._errors)) or self._raise_first_error

    def _run(self, handler: Callable[[], None]) -> None:
        try:
            handler()
        except Exception as error:
            self._errors.append(error)
        finally:
            with self._lock:
                self._running -= 1
            self._free.wake()
            self.wake()

    def _raise_first_error(self) -> None:
        if self._errors:
            raise self._errors.popleft()
