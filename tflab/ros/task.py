"""Provide rclpy.task: Future, and Task, a future that an executor runs."""

from __future__ import annotations

import inspect
import sys
import threading
import weakref
from collections.abc import Callable, Generator
from typing import Any

__all__ = ["Future", "Task"]

# Executors with a coroutine that waits for something; any future may be what it waits for.
_executors_with_waiting_tasks: weakref.WeakSet = weakref.WeakSet()


_step = threading.local()  # waits: whether the present step of a coroutine ended at a future


class Future:
    """A result that may not be there yet.

    Without an executor, done callbacks run where the result is set; with one,
    they become its tasks.
    """

    def __init__(self, *, executor: Any = None) -> None:
        self._state = "pending"
        self._result: Any = None
        self._exception: BaseException | None = None
        self._exception_fetched = False
        self._callbacks: list[Callable[[Future], None]] = []
        self._lock = threading.RLock()
        self._executor: Any = None if executor is None else weakref.ref(executor)

    def __del__(self) -> None:
        if self._exception is not None and not self._exception_fetched:
            print(f"The following exception was never retrieved: {self._exception}", file=sys.stderr)

    def __await__(self) -> Generator[None, None, Any]:
        while self._state == "pending":
            _step.waits = True
            yield
        return self.result()

    def done(self) -> bool:
        """Return whether there is a result or an exception, or it was cancelled."""
        return self._state != "pending"

    def cancelled(self) -> bool:
        """Return whether it was cancelled."""
        return self._state == "cancelled"

    def cancel(self) -> None:
        """Give it up, if it is not done."""
        with self._lock:
            if self._state != "pending":
                return
            self._state = "cancelled"
        self._notify()

    def result(self) -> Any:
        """Return the result, None while there is none, or raise the exception."""
        if self._exception is not None:
            raise self.exception()
        return self._result

    def exception(self) -> BaseException | None:
        """Return the exception, if there is one."""
        self._exception_fetched = True
        return self._exception

    def set_result(self, result: Any) -> None:
        """Say what it is."""
        with self._lock:
            self._result = result
            self._state = "finished"
        self._notify()

    def set_exception(self, exception: BaseException) -> None:
        """Say why there will be no result."""
        with self._lock:
            self._exception = exception
            self._exception_fetched = False
            self._state = "finished"
        self._notify()

    def add_done_callback(self, callback: Callable[[Future], None]) -> None:
        """Have `callback(future)` called when it is done, at once if it is."""
        with self._lock:
            if self._state == "pending":
                self._callbacks.append(callback)
                return
        self._invoke(callback)

    def remove_done_callback(self, callback: Callable[[Future], None]) -> int:
        """Forget a callback; return how many times it was registered."""
        with self._lock:
            before = len(self._callbacks)
            self._callbacks = [each for each in self._callbacks if each != callback]
            return before - len(self._callbacks)

    def _notify(self) -> None:
        with self._lock:
            callbacks, self._callbacks = self._callbacks, []
        for callback in callbacks:
            self._invoke(callback)
        for executor in list(_executors_with_waiting_tasks):
            executor.resume_tasks()

    def _invoke(self, callback: Callable[[Future], None]) -> None:
        executor = self._executor() if self._executor is not None else None
        if executor is not None:
            executor.create_task(callback, self)
            return
        try:
            callback(self)
        except Exception as error:
            print(f"Unhandled exception in done callback: {error}", file=sys.stderr)


class Task(Future):
    """A function or coroutine that is executed step by step; its result is the future's.

    Attributes:
        may_go_on: False while a coroutine waits, until some future is done.
    """

    def __init__(
        self, handler: Any, args: tuple | None = None, kwargs: dict | None = None, executor: Any = None
    ) -> None:
        super().__init__(executor=executor)
        self._args = args or ()
        self._kwargs = kwargs or {}
        self._handler = handler
        self._executing = False
        self.may_go_on = True
        if inspect.iscoroutinefunction(handler):
            self._handler = handler(*self._args, **self._kwargs)

    def __call__(self) -> None:
        """Execute it, or the next step of it; do nothing if it is done or already executing."""
        if self.done() or self._executing:
            return
        self._executing = True
        self.may_go_on = False
        try:
            self._step()
        finally:
            self._executing = False

    def _step(self) -> None:
        try:
            if inspect.iscoroutine(self._handler):
                _step.waits = False
                self._handler.send(None)
                if not _step.waits:  # it only gave way, as at asyncio.sleep(0)
                    self.may_go_on = True
            else:
                self.set_result(self._handler(*self._args, **self._kwargs))
        except StopIteration as end:
            self.set_result(end.value)
        except Exception as error:
            self.set_exception(error)

    def executing(self) -> bool:
        """Return whether a step of it is being executed now."""
        return self._executing

    def cancel(self) -> None:
        """Give it up, if it is not done."""
        super().cancel()
        if self.cancelled() and inspect.iscoroutine(self._handler):
            self._handler.close()
