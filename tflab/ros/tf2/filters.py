"""Match and filter messages of several topics: message_filters.

    Subscriber("image") --\\
                           TimeSynchronizer --> callback(image, camera_info)    equal stamps
    Subscriber("info")  --/
    Subscriber("scan")  --> Cache(size) --> what was between two times

Everything is a SimpleFilter: it has callbacks, and may be somebody's input.
A filter that waits for a transform is `message_filter.py`.
"""

from __future__ import annotations

import itertools
import threading
from collections.abc import Callable, Sequence

from ..clock import ROSClock
from ..logging import LoggingSeverity, get_logger
from ..messages.base import Message
from ..time import Duration, Time
from ..topic_endpoints import Subscription

__all__ = ["ApproximateTimeSynchronizer", "Cache", "SimpleFilter", "Subscriber", "TimeSynchronizer"]


class SimpleFilter:
    """Something that has messages to pass on."""

    def __init__(self) -> None:
        self.callbacks: dict[int, tuple[Callable, tuple]] = {}

    def registerCallback(self, cb: Callable, *args: object) -> int:
        """Have `cb(message..., *args)` called for each output; return the number of the connection."""
        connection = len(self.callbacks)
        self.callbacks[connection] = (cb, args)
        return connection

    def signalMessage(self, *msg: Message) -> None:
        """Pass messages on to every callback, in the order of registration."""
        for callback, args in list(self.callbacks.values()):
            callback(*msg, *args)


class Subscriber(SimpleFilter):
    """A subscription as the start of a chain: Subscriber(node, Image, 'image', qos_profile=10)."""

    def __init__(self, *args: object, **kwargs: object) -> None:
        super().__init__()
        self.node, _, self.topic = args[:3]
        kwargs.setdefault("qos_profile", 10)
        self.sub: Subscription = self.node.create_subscription(*args[1:], self.callback, **kwargs)

    def callback(self, msg: Message) -> None:
        """Pass a received message on."""
        self.signalMessage(msg)

    def getTopic(self) -> str:
        """Return the topic, as it was given."""
        return self.topic


class Cache(SimpleFilter):
    """The last messages of an input, to be asked for by time.

    Args:
        f: the input.
        cache_size: how many messages are kept; the one that came first goes first.
        allow_headerless: stamp messages without a header with the time of arrival.
    """

    def __init__(self, f: SimpleFilter, cache_size: int = 1, allow_headerless: bool = False) -> None:
        super().__init__()
        self.cache_size = cache_size
        self.allow_headerless = allow_headerless
        self.cache_msgs: list[Message] = []
        self.cache_times: list[Time] = []
        self.connectInput(f)

    def connectInput(self, f: SimpleFilter) -> None:
        """Take messages from `f`."""
        self.incoming_connection = f.registerCallback(self.add)

    def add(self, msg: Message) -> None:
        """Keep a message, and pass it on."""
        stamp = _stamp(msg, self.allow_headerless)
        if stamp is None:
            _warn_headerless("message_filters_cache", "can not use message filters messages")
            return
        self.cache_msgs.append(msg)
        self.cache_times.append(stamp)
        if len(self.cache_msgs) > self.cache_size:
            del self.cache_msgs[0], self.cache_times[0]
        self.signalMessage(msg)

    def getInterval(self, from_stamp: Time, to_stamp: Time) -> list[Message]:
        """Return the messages stamped within [from_stamp, to_stamp], in order of arrival."""
        if from_stamp > to_stamp:
            raise AssertionError(f"the interval ends before it starts: {from_stamp}, {to_stamp}")
        return [msg for msg, stamp in self._contents() if from_stamp <= stamp <= to_stamp]

    def getElemAfterTime(self, stamp: Time) -> Message | None:
        """Return the first message at or after a time, or None."""
        return next((msg for msg, time in self._contents() if time >= stamp), None)

    def getElemBeforeTime(self, stamp: Time) -> Message | None:
        """Return the last message at or before a time, or None."""
        return next((msg for msg, time in reversed(self._contents()) if time <= stamp), None)

    def getLastestTime(self) -> Time | None:
        """Return the time of the newest message, or None.  (The misspelling is upstream's.)"""
        return self.cache_times[-1] if self.cache_times else None

    def getOldestTime(self) -> Time | None:
        """Return the time of the oldest message, or None."""
        return self.cache_times[0] if self.cache_times else None

    def getLast(self) -> Message | None:
        """Return the newest message, or None."""
        return self.getElemAfterTime(self.getLastestTime()) if self.cache_times else None

    def _contents(self) -> list[tuple[Message, Time]]:
        return list(zip(self.cache_msgs, self.cache_times, strict=True))


class TimeSynchronizer(SimpleFilter):
    """Calls back with one message from each input whenever all have the same stamp, to the nanosecond.

    Args:
        fs: the inputs.
        queue_size: how many messages of each input wait; the one with the oldest stamp goes first.
    """

    def __init__(self, fs: Sequence[SimpleFilter], queue_size: int) -> None:
        super().__init__()
        self.queue_size = queue_size
        self.lock = threading.RLock()
        self.connectInput(fs)

    def connectInput(self, fs: Sequence[SimpleFilter]) -> None:
        """Take messages from each of `fs`."""
        self.queues: list[dict[int, Message]] = [{} for _ in fs]  # stamp [ns] -> message
        self.input_connections = [
            f.registerCallback(self.add, queue, index)
            for index, (f, queue) in enumerate(zip(fs, self.queues, strict=True))
        ]

    def add(self, msg: Message, my_queue: dict[int, Message], my_queue_index: int | None = None) -> None:
        """Queue a message of one input, and pass on each set that is now complete, oldest first."""
        with self.lock:
            self._queue(msg, my_queue, Time.from_msg(msg.header.stamp).nanoseconds)
            for stamp_ns in sorted(set.intersection(*map(set, self.queues))):
                self._pass_on([stamp_ns] * len(self.queues))

    def _queue(self, msg: Message, my_queue: dict[int, Message], stamp_ns: int) -> None:
        my_queue[stamp_ns] = msg
        while len(my_queue) > self.queue_size:
            del my_queue[min(my_queue)]

    def _pass_on(self, stamps_ns: Sequence[int]) -> None:
        """Take one message out of each queue, by its stamp, and pass the set on."""
        self.signalMessage(*[queue.pop(stamp_ns) for queue, stamp_ns in zip(self.queues, stamps_ns, strict=True)])


class ApproximateTimeSynchronizer(TimeSynchronizer):
    """Calls back with one message from each input whenever their stamps differ by less than `slop` [s].

    Args:
        fs: the inputs.
        queue_size: how many messages of each input wait.
        slop: how far apart the stamps of a set may be [s].
        allow_headerless: stamp messages without a header with the time of arrival.
    """

    def __init__(
        self, fs: Sequence[SimpleFilter], queue_size: int, slop: float, allow_headerless: bool = False
    ) -> None:
        super().__init__(fs, queue_size)
        self.slop = Duration(seconds=slop)
        self.allow_headerless = allow_headerless

    def add(self, msg: Message, my_queue: dict[int, Message], my_queue_index: int | None = None) -> None:
        """Queue a message of one input, and pass on the set of nearest stamps that it completes, if any."""
        stamp = _stamp(msg, self.allow_headerless)
        if stamp is None:
            _warn_headerless("message_filters_approx", "can not use message filters for messages")
            return
        with self.lock:
            self._queue(msg, my_queue, stamp.nanoseconds)
            chosen = self._nearest_set(stamp.nanoseconds, my_queue_index)
            if chosen is not None:
                self._pass_on(chosen)

    def _nearest_set(self, stamp_ns: int, index: int | None) -> tuple[int, ...] | None:
        """Return one stamp [ns] from each queue, that of queue `index` being `stamp_ns`, within the slop; or None."""
        slop_ns = self.slop.nanoseconds
        candidates = []
        for i, queue in enumerate(self.queues):
            near = [stamp_ns] if i == index else [s for s in queue if abs(s - stamp_ns) <= slop_ns]
            candidates.append(sorted(near, key=lambda s: abs(s - stamp_ns)))
        for stamps_ns in itertools.product(*candidates):
            still_queued = all(s in queue for s, queue in zip(stamps_ns, self.queues, strict=True))
            if still_queued and max(stamps_ns) - min(stamps_ns) < slop_ns:
                return stamps_ns
        return None


def _stamp(msg: Message, allow_headerless: bool) -> Time | None:
    """Return when a message was made; if it does not say so, the present, or None if that is not allowed."""
    if hasattr(msg, "header") and hasattr(msg.header, "stamp"):
        stamp = msg.header.stamp
        return stamp if isinstance(stamp, Time) else Time.from_msg(stamp)
    return ROSClock().now() if allow_headerless else None


def _warn_headerless(logger_name: str, start: str) -> None:
    logger = get_logger(logger_name)
    logger.set_level(LoggingSeverity.INFO)
    logger.warning(
        f"{start} without timestamp infomation when 'allow_headerless' is disabled. "
        "auto assign ROSTIME to headerless messages once enabling constructor option of 'allow_headerless'."
    )
