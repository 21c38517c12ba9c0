"""Hold messages until they can be transformed, as tf2's MessageFilter does.

    Subscriber("scan") --> [ scan 3 | scan 4 | scan 5 ] --> callback(scan 3), once map <- laser is known at its stamp
                                waiting, oldest first    --> dropped, and the reason in the log

This is how a robot avoids extrapolation: not by a timeout in the callback, but by
not calling back before the data is there.  Upstream has it in C++ alone
(tf2_ros/message_filter.h); the arguments, rules and texts are those, the callback
is called where the transform arrives.

    queue full           the oldest makes room, even for one that is ready at once
    too old              its moment is further back than the buffer's cache
    no frame             dropped at once
    tolerance            also wait for the transform that much after the stamp

Order of output is the order of the transforms, not of the messages.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, field
from enum import Enum
from typing import TYPE_CHECKING

from tflab.core import NSEC_PER_SEC
from tflab.core.requests import NEVER, POSSIBLE_NOW

from ..logging import get_logger
from ..messages.base import Message
from ..time import Duration, Time
from ..timer import Timer
from .filters import SimpleFilter

if TYPE_CHECKING:
    from ..node import Node
    from .buffer import Buffer

__all__ = ["DropReason", "MessageFilter"]


class DropReason(Enum):
    """Why a message was dropped, in the words of the log.

    (C++ has a fifth text, "did not find a valid transform, this usually happens at startup ...", and no use for it.)
    """

    UNKNOWN = "unknown"
    OUT_THE_BACK = "the timestamp on the message is earlier than all the data in the transform cache"
    EMPTY_FRAME_ID = "the frame id of the message is empty"
    QUEUE_FULL = "discarding message because the queue is full"


@dataclass(eq=False, slots=True)
class _Waiting:
    """One message, and what it waits for."""

    message: Message
    frame_id: str
    stamp_ns: int
    missing: int  # transforms still to come
    handles: list[int] = field(default_factory=list)
    timer: Timer | None = None


class MessageFilter(SimpleFilter):
    """Passes each message on once its frame can be transformed to the target frame at its stamp.

    Args:
        f: the input, often a Subscriber.
        buffer: asked for transforms.
        target_frame: a leading slash is stripped.
        queue_size: how many messages may wait; 0 for any number.
        node: says why messages were dropped, in its log.
        buffer_timeout: how long a message may wait; None for ever.

    Attributes:
        incoming_message_count: messages with a frame that came in.
        successful_transform_count: messages passed on.
        dropped: how many messages were dropped, by DropReason.
    """

    def __init__(
        self,
        f: SimpleFilter,
        buffer: Buffer,
        target_frame: str,
        queue_size: int,
        node: Node,
        buffer_timeout: Duration | None = None,
    ) -> None:
        super().__init__()
        self.incoming_message_count = 0
        self.successful_transform_count = 0
        self.dropped: Counter[DropReason] = Counter()
        self._engine = buffer.core
        self._node = node
        self._queue_size = queue_size
        self._timeout = buffer_timeout
        self._tolerance_ns = 0
        self._waiting: list[_Waiting] = []
        self.setTargetFrame(target_frame)
        self.connectInput(f)

    def connectInput(self, f: SimpleFilter) -> None:
        """Take messages from `f`."""
        f.registerCallback(self.add)

    def setTargetFrame(self, target_frame: str) -> None:
        """Wait for transforms to this frame, from the next message on."""
        self.setTargetFrames([target_frame])

    def setTargetFrames(self, target_frames: Sequence[str]) -> None:
        """Wait for transforms to all of these frames, from the next message on."""
        self._target_frames = [frame.removeprefix("/") for frame in target_frames]

    def getTargetFramesString(self) -> str:
        """Return the target frames, each followed by a blank."""
        return "".join(f"{frame} " for frame in self._target_frames)

    def setTolerance(self, tolerance: Duration) -> None:
        """Wait until the transforms are known at the stamp and `tolerance` after it."""
        self._tolerance_ns = tolerance.nanoseconds

    def setQueueSize(self, new_queue_size: int) -> None:
        """Let that many messages wait; 0 for any number."""
        self._queue_size = new_queue_size

    def getQueueSize(self) -> int:
        """Return how many messages may wait."""
        return self._queue_size

    def clear(self) -> None:
        """Forget the messages that wait; they count as neither passed on nor dropped."""
        while self._waiting:
            self._take_out(self._waiting[0])
        self._debug("Cleared")

    def add(self, message: Message) -> None:
        """Take one message: pass it on, let it wait, or drop it."""
        if not self._target_frames:
            return
        frame_id = message.header.frame_id.removeprefix("/")
        if not frame_id:
            self._drop(message, DropReason.EMPTY_FRAME_ID)
            return
        if self._queue_size and len(self._waiting) + 1 > self._queue_size:
            self._make_room()
        stamp_ns = Time.from_msg(message.header.stamp).nanoseconds
        moments = [stamp_ns, stamp_ns + self._tolerance_ns] if self._tolerance_ns else [stamp_ns]
        requests = [(target, moment_ns) for target in self._target_frames for moment_ns in moments]
        entry = _Waiting(message, frame_id, stamp_ns, missing=len(requests))
        self._waiting.append(entry)
        self.incoming_message_count += 1
        self._debug(f"Added message in frame {frame_id} at time {_time(stamp_ns)}, count now {len(self._waiting)}")
        if self._timeout is not None:
            entry.timer = self._node.create_timer(
                self._timeout.nanoseconds / NSEC_PER_SEC, lambda: self._give_up(entry)
            )
        for target, moment_ns in requests:
            self._request(entry, target, moment_ns)

    def _request(self, entry: _Waiting, target: str, moment_ns: int) -> None:
        def on_answer(handle: int, target: str, source: str, stamp_ns: int, result: str) -> None:
            self._answer(entry, result == "available")

        handle = self._engine.request_transformable(target, entry.frame_id, moment_ns, on_answer)
        if handle == POSSIBLE_NOW:
            self._answer(entry, True)
        elif handle == NEVER:
            self._answer(entry, False)
        else:
            entry.handles.append(handle)

    def _answer(self, entry: _Waiting, is_available: bool) -> None:
        """Note that one of an entry's transforms is decided; the last one decides the entry."""
        entry.missing -= 1
        if entry.missing or entry not in self._waiting:
            return
        self._take_out(entry)
        what = f"message in frame {entry.frame_id} at time {_time(entry.stamp_ns)}, count now {len(self._waiting)}"
        # As in C++, the others are asked about again: a buffer may have been cleared in between.
        if is_available and self._can_transform(entry):
            self._debug(f"Message ready{what.removeprefix('message')}")
            self.successful_transform_count += 1
            self.signalMessage(entry.message)
        else:
            self._debug(f"Discarding {what}")
            self._drop(entry.message, DropReason.UNKNOWN if is_available else DropReason.OUT_THE_BACK)

    def _give_up(self, entry: _Waiting) -> None:
        """Drop an entry that has waited for as long as it may.  (The log blames its age; so does C++'s.)"""
        entry.missing = 1
        self._answer(entry, False)

    def _make_room(self) -> None:
        oldest = self._waiting[0]
        self._debug(
            f"Removed oldest message because buffer is full, count now {len(self._waiting)} "
            f"(frame_id={oldest.message.header.frame_id}, stamp={oldest.stamp_ns / NSEC_PER_SEC:f})"
        )
        self._take_out(oldest)
        self._drop(oldest.message, DropReason.QUEUE_FULL)

    def _take_out(self, entry: _Waiting) -> None:
        self._waiting.remove(entry)
        for handle in entry.handles:
            self._engine.cancel_request(handle)
        if entry.timer is not None:
            self._node.destroy_timer(entry.timer)

    def _can_transform(self, entry: _Waiting) -> bool:
        moments = {entry.stamp_ns, entry.stamp_ns + self._tolerance_ns}
        return all(
            self._engine.can_transform(target, entry.frame_id, moment_ns)
            for target in self._target_frames
            for moment_ns in moments
        )

    def _drop(self, message: Message, reason: DropReason) -> None:
        self.dropped[reason] += 1
        frame_id = message.header.frame_id.removeprefix("/")
        stamp_ns = Time.from_msg(message.header.stamp).nanoseconds
        self._node.get_logger().info(
            f"Message Filter dropping message: frame '{frame_id}' at time {_time(stamp_ns)} for reason '{reason.value}'"
        )

    def _debug(self, text: str) -> None:
        get_logger("tf2_ros_message_filter").debug(f"MessageFilter [target={self.getTargetFramesString()}]: {text}")


def _time(stamp_ns: int) -> str:
    return f"{stamp_ns / NSEC_PER_SEC:.3f}"
