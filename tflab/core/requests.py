"""Queue requests for transforms that are not available yet, and call back.

    request(map <- laser at t)  ->  handle 1, 2, 3, ...    queued
                                    POSSIBLE_NOW  (0)      available now; there will be no call
                                    NEVER  (2**64 - 1)     older than the cache

After every transform that the buffer accepts, each waiting request is evaluated again:
"available" if a lookup would succeed, "failure" if its stamp is older than the cache.
A waiting request for LATEST can therefore fail: its stamp is 0.

tf2: BufferCore::addTransformableRequest, testTransformableRequests. (There, cancelling
one request can remove the callback of another. This bug is not copied.)
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

from .tree import FrameTree, LookupFailure, find_path, latest_common_time

__all__ = ["NEVER", "POSSIBLE_NOW", "RequestCallback", "RequestQueue"]

POSSIBLE_NOW = 0
NEVER = 2**64 - 1

# handle, target_frame, source_frame, stamp_ns, "available" or "failure"
RequestCallback = Callable[[int, str, str, int, str], None]


class _Request(NamedTuple):
    handle: int
    target_frame: str
    source_frame: str
    stamp_ns: int
    callback: RequestCallback


class RequestQueue:
    """The requests that wait on one tree."""

    def __init__(self, tree: FrameTree) -> None:
        self._tree = tree
        self.waiting: list[_Request] = []
        self._last_handle = 0

    def add(self, target_frame: str, source_frame: str, stamp_ns: int, callback: RequestCallback) -> int:
        """Queue a request, or say at once that it is POSSIBLE_NOW or NEVER will be.

        A name that nobody has mentioned yet is no fault: the request waits for it.
        """
        if target_frame == source_frame or self._is_possible(target_frame, source_frame, stamp_ns):
            return POSSIBLE_NOW
        if self._is_too_old(target_frame, source_frame, stamp_ns):
            return NEVER
        self._last_handle += 1
        self.waiting.append(_Request(self._last_handle, target_frame, source_frame, stamp_ns, callback))
        return self._last_handle

    def cancel(self, handle: int) -> None:
        """Forget a request; its callback will not be called.  An unknown handle is ignored."""
        self.waiting = [request for request in self.waiting if request.handle != handle]

    def judge_all(self) -> None:
        """Take every decided request out of the queue, then call back.

        A gap in the queue is filled with its last request, which is judged next:
        that is tf2's order of calls.  Callbacks may use the buffer, add and cancel.
        If one raises, the others are still called, and the first error is raised.
        """
        decided = []
        i = 0
        while i < len(self.waiting):
            request = self.waiting[i]
            result = self._judge(request)
            if result is None:
                i += 1
                continue
            decided.append((request, result))
            last = self.waiting.pop()
            if last is not request:
                self.waiting[i] = last
        errors = []
        for request, result in decided:
            try:
                request.callback(request.handle, request.target_frame, request.source_frame, request.stamp_ns, result)
            except Exception as error:
                errors.append(error)
        if errors:
            raise errors[0]

    def _judge(self, request: _Request) -> str | None:
        if self._is_too_old(request.target_frame, request.source_frame, request.stamp_ns):
            return "failure"
        if self._is_possible(request.target_frame, request.source_frame, request.stamp_ns):
            return "available"
        return None

    def _is_possible(self, target_frame: str, source_frame: str, stamp_ns: int) -> bool:
        target = self._tree.numbers.get(target_frame, 0)
        source = self._tree.numbers.get(source_frame, 0)
        if not (target and source):
            return False
        return not isinstance(find_path(self._tree, target, source, stamp_ns), LookupFailure)

    def _is_too_old(self, target_frame: str, source_frame: str, stamp_ns: int) -> bool:
        target = self._tree.numbers.get(target_frame, 0)
        source = self._tree.numbers.get(source_frame, 0)
        if not (target and source):
            return False
        common_ns = latest_common_time(self._tree, target, source)
        if isinstance(common_ns, LookupFailure) or common_ns == 0:
            return False
        return stamp_ns + self._tree.cache_time_ns < common_ns
