"""Look transforms up and wait for them: tf2_ros.Buffer.

```
lookup_transform(..., timeout)       polls every 20 ms, and spins nothing: in a callback of the executor
                                     that serves the listener it burns the whole timeout, and fails
wait_for_transform_async(...)        a Future, judged again at every new transform; never gives up
```
"""

from __future__ import annotations

import threading
from collections.abc import Callable
from typing import Any

from .. import distro
from ..clock import Clock, JumpThreshold, TimeJump
from ..graph import current_process
from ..logging import get_logger
from ..messages import geometry_msgs, tf2_msgs
from ..task import Future
from ..time import Duration, Time
from .core import BufferCore
from .interface import NO_WAIT, BufferInterface

__all__ = ["Buffer"]

TransformStamped = geometry_msgs.TransformStamped
POLL_NS = 20_000_000
CLOCK_JUMPED_BACK_NS = 3_000_000_000


class Buffer(BufferCore, BufferInterface):
    """Everything that was published, with waiting.

    Args:
        cache_time: how far it reaches back; 10 s if None.
        node: whose clock it watches, to forget everything when time jumps back by a
            second or more, and where it serves `tf2_frames`.  Without a node it does neither.
    """

    def __init__(self, cache_time: Duration | None = None, node: Any = None) -> None:
        BufferCore.__init__(self, *(() if cache_time is None else (cache_time,)))
        BufferInterface.__init__(self)
        self._new_data_callbacks: list[Callable[[], None]] = []
        self._callbacks_to_remove: list[Callable[[], None]] = []
        self._callbacks_lock = threading.RLock()
        if node is not None:
            self.srv = node.create_service(tf2_msgs.FrameGraph, "tf2_frames", self._serve_frames)
            self.clock = node.get_clock()
        else:
            self.clock = Clock()
        if distro.current().buffer_clears_at_jump_back:
            self._jump_handle = self.clock.create_jump_callback(
                JumpThreshold(min_forward=None, min_backward=Duration(seconds=-1), on_clock_change=True),
                post_callback=self._on_time_jump,
            )

    def _serve_frames(self, request: Any, response: Any) -> Any:
        response.frame_yaml = self.all_frames_as_yaml()
        return response

    def _on_time_jump(self, jump: TimeJump) -> None:
        get_logger("tf2_buffer").warning("Detected jump back in time. Clearing tf buffer.")
        self.clear()

    # -- publishing -------------------------------------------------------------------

    def set_transform(self, transform: TransformStamped, authority: str) -> None:
        """Store a transform, and judge those who wait."""
        super().set_transform(transform, authority)
        self._call_new_data_callbacks()

    def set_transform_static(self, transform: TransformStamped, authority: str) -> None:
        """Store a transform that is good for any time, and judge those who wait."""
        super().set_transform_static(transform, authority)
        self._call_new_data_callbacks()

    def has_waiting(self) -> bool:
        """Return whether anybody waits for new data."""
        return bool(self._new_data_callbacks)

    def _call_new_data_callbacks(self) -> None:
        if not self._new_data_callbacks:
            return
        with self._callbacks_lock:
            for callback in self._new_data_callbacks:
                callback()
            # Callbacks may have removed themselves meanwhile.
            for callback in self._callbacks_to_remove:
                self._new_data_callbacks.remove(callback)
            self._callbacks_to_remove.clear()

    def _remove_callback(self, callback: Callable[[], None]) -> None:
        with self._callbacks_lock:
            self._callbacks_to_remove.append(callback)

    # -- asking, and waiting ------------------------------------------------------------

    def lookup_transform(
        self, target_frame: str, source_frame: str, time: Time, timeout: Duration = NO_WAIT
    ) -> TransformStamped:
        """Return what moves points from source to target; wait for it at most `timeout`.

        Raises:
            TransformException: there is no answer, even then; its class and text say why.
        """
        self.can_transform(target_frame, source_frame, time, timeout)
        return self.lookup_transform_core(target_frame, source_frame, time)

    def lookup_transform_full(
        self,
        target_frame: str,
        target_time: Time,
        source_frame: str,
        source_time: Time,
        fixed_frame: str,
        timeout: Duration = NO_WAIT,
    ) -> TransformStamped:
        """Return source at its time as seen from target at another; wait at most `timeout`."""
        self.can_transform_full(target_frame, target_time, source_frame, source_time, fixed_frame, timeout)
        return self.lookup_transform_full_core(target_frame, target_time, source_frame, source_time, fixed_frame)

    def can_transform(
        self,
        target_frame: str,
        source_frame: str,
        time: Time,
        timeout: Duration = NO_WAIT,
        return_debug_tuple: bool = False,
    ) -> int | tuple[int, str]:
        """Return whether there is an answer, waiting at most `timeout`; with the text why not, if asked."""
        result = _poll(lambda: self.can_transform_core(target_frame, source_frame, time), timeout)
        return result if return_debug_tuple else result[0]

    def can_transform_full(
        self,
        target_frame: str,
        target_time: Time,
        source_frame: str,
        source_time: Time,
        fixed_frame: str,
        timeout: Duration = NO_WAIT,
        return_debug_tuple: bool = False,
    ) -> int | tuple[int, str]:
        """Return whether there is an answer, waiting at most `timeout`; with the text why not, if asked."""
        result = _poll(
            lambda: self.can_transform_full_core(target_frame, target_time, source_frame, source_time, fixed_frame),
            timeout,
        )
        return result if return_debug_tuple else result[0]

    # -- waiting without blocking ---------------------------------------------------------

    async def lookup_transform_async(self, target_frame: str, source_frame: str, time: Time) -> TransformStamped:
        """Return what moves points from source to target, as soon as there is an answer."""
        await self.wait_for_transform_async(target_frame, source_frame, time)
        return self.lookup_transform_core(target_frame, source_frame, time)

    async def lookup_transform_full_async(
        self, target_frame: str, target_time: Time, source_frame: str, source_time: Time, fixed_frame: str
    ) -> TransformStamped:
        """Return source at its time as seen from target at another, as soon as there is an answer."""
        question = (target_frame, target_time, source_frame, source_time, fixed_frame)
        await self.wait_for_transform_full_async(*question)
        return self.lookup_transform_full_core(*question)

    def wait_for_transform_async(self, target_frame: str, source_frame: str, time: Time) -> Future:
        """Return a Future of the transform (True on Humble); it stays pending for as long as there is no answer."""
        return self._wait(
            lambda: self.can_transform_core(target_frame, source_frame, time)[0],
            lambda: self.lookup_transform_core(target_frame, source_frame, time),
        )

    def wait_for_transform_full_async(
        self, target_frame: str, target_time: Time, source_frame: str, source_time: Time, fixed_frame: str
    ) -> Future:
        """Return a Future of the transform (True on Humble); it stays pending for as long as there is no answer."""
        question = (target_frame, target_time, source_frame, source_time, fixed_frame)
        return self._wait(
            lambda: self.can_transform_full_core(*question)[0],
            lambda: self.lookup_transform_full_core(*question),
        )

    def _wait(self, can: Callable[[], int], lookup: Callable[[], TransformStamped]) -> Future:
        future = Future()
        result: Callable[[], Any] = lookup if distro.current().wait_for_transform_gives_it else lambda: True
        if can():
            future.set_result(result())
            return future

        def on_new_data() -> None:
            if future.done():
                return
            try:
                if can():
                    future.set_result(result())
            except BaseException as error:
                future.set_exception(error)

        self._new_data_callbacks.append(on_new_data)
        future.add_done_callback(lambda _: self._remove_callback(on_new_data))
        return future


def _poll(ask: Callable[[], tuple[int, str]], timeout: Any) -> tuple[int, str]:
    """Ask until the answer is yes, or `timeout` is over; return the last answer."""
    if timeout == NO_WAIT:
        return ask()
    process, clock = current_process(), Clock()
    start = clock.now()
    start_ns, until_ns = start.nanoseconds, (start + timeout).nanoseconds  # a float is a TypeError
    result = ask()
    while not result[0] and start_ns - CLOCK_JUMPED_BACK_NS < clock.now_ns() < until_ns:
        process.sleep(POLL_NS)
        result = ask()
    return result
