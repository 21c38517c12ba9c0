"""Record a graph into a bag, as `ros2 bag record` does, without its output.

    publishers --> Recorder (a node's subscriptions, found as they appear) --> BagWriter --> drive/

The subscriptions adapt to what is offered: if all publishers of a topic are
latched, so is the subscription, and /tf_static is there even if it was said
before.  A message is stored with the time of its receipt.

`BagWriter` never writes over anything, and its bag is whole however the recording
ends.
"""

from __future__ import annotations

import atexit
import threading
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from tflab.ros import distro
from tflab.ros.messages.base import Message, type_named
from tflab.ros.messages.packages import type_store
from tflab.ros.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy

from . import wire
from .errors import BagError

if TYPE_CHECKING:
    from tflab.ros.node import Node

__all__ = ["STORAGES", "BagWriter", "Recorder", "adapted_profile"]

STORAGES = ("mcap", "sqlite3")
DISCOVERY_PERIOD_S = 0.1
QUEUE_DEPTH = 1000


class BagWriter:
    """A new bag; use it in a `with` block, so that it is whole also after Ctrl-C or an error.

    Raises:
        BagError: there is something at `path` already, or it cannot be made.
    """

    def __init__(self, path: str | Path, storage: str = "mcap") -> None:
        from rosbags.rosbag2 import StoragePlugin, Writer, WriterError

        self.path = Path(path)
        try:
            self._writer = Writer(self.path, version=9, storage_plugin=StoragePlugin[storage.upper()])
            self._writer.open()
        except WriterError:
            raise BagError(f"{path}: there is something of that name already; nothing is overwritten") from None
        except OSError as error:
            raise BagError(f"{path}: cannot be made ({error.strerror})") from None
        self._connections = {}
        self._lock = threading.Lock()
        self._is_open = True
        atexit.register(self.close)  # whoever presses Ctrl-C twice does not wait for the thread that records

    def add_topic(self, topic: str, ros_type: str, profiles: Sequence[QoSProfile] = ()) -> None:
        """Announce a topic, with the profiles that its publishers offer."""
        self._connections[topic] = self._writer.add_connection(
            topic, ros_type, typestore=type_store(), offered_qos_profiles=[wire.qos_of(p) for p in profiles]
        )

    def write(self, topic: str, message: Message, receive_ns: int) -> None:
        """Store a message of an announced topic, received at `receive_ns` [ns]."""
        data = wire.bytes_of(message)
        with self._lock:
            if self._is_open:
                self._writer.write(self._connections[topic], receive_ns, data)

    def close(self) -> None:
        """Finish the bag; again is no harm, and what comes later is not stored."""
        with self._lock:
            if self._is_open:
                self._is_open = False
                self._writer.close()
                self._name_distro()
        atexit.unregister(self.close)

    def _name_distro(self) -> None:
        """Say which ROS recorded it, as rosbag2 does: the library writes its own name there."""
        metadata = self.path / "metadata.yaml"
        text = metadata.read_text(encoding="utf-8")
        metadata.write_text(
            text.replace("ros_distro: rosbags", f"ros_distro: {distro.current().name}"), encoding="utf-8"
        )

    def __enter__(self) -> BagWriter:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()  # not the library's own way out, which leaves a bag without index after an exception


class Recorder:
    """The subscriptions of a recording.

    Args:
        node: whose clock tells the time of receipt.
        is_wanted: which topics to record, by their name.
        wanted: the topics that are waited for; if given, the search ends when all are there.
    """

    def __init__(
        self, node: Node, writer: BagWriter, is_wanted: Callable[[str], bool], wanted: Sequence[str] = ()
    ) -> None:
        self._node = node
        self._writer = writer
        self._is_wanted = is_wanted
        self._wanted = set(wanted)
        self._seen: set[str] = set()
        self._timer = node.create_timer(DISCOVERY_PERIOD_S, self.subscribe_to_new_topics)
        self.subscribe_to_new_topics()

    def subscribe_to_new_topics(self) -> None:
        """Subscribe to what has appeared since the last look."""
        for topic, types in self._node.get_topic_names_and_types():
            publishers = self._node.get_publishers_info_by_topic(topic)
            if topic not in self._seen and publishers and self._is_wanted(topic):
                self._seen.add(topic)
                self._subscribe(topic, types[0], [info.qos_profile for info in publishers])
        if self._wanted and self._wanted <= self._seen and not self._timer.is_canceled():
            self._timer.cancel()
            self._log("All requested topics are subscribed. Stopping discovery...")

    def _subscribe(self, topic: str, ros_type: str, offered: list[QoSProfile]) -> None:
        try:
            message_class = type_named(ros_type)
            self._writer.add_topic(topic, ros_type, offered)
        except KeyError:
            self._node.get_logger().warning(f"Topic '{topic}' has the unknown type '{ros_type}', it is not recorded")
            return

        def on_message(message: Message) -> None:
            self._writer.write(topic, message, self._node.get_clock().now().nanoseconds)

        self._node.create_subscription(message_class, topic, on_message, adapted_profile(offered))
        self._log(f"Subscribed to topic '{topic}'")

    def _log(self, text: str) -> None:
        self._node.get_logger().info(text)


def adapted_profile(offered: Sequence[QoSProfile]) -> QoSProfile:
    """Return the profile that hears all these publishers, and what they said before if all of them keep it."""
    is_latched = all(profile.durability == DurabilityPolicy.TRANSIENT_LOCAL for profile in offered)
    is_reliable = all(profile.reliability == ReliabilityPolicy.RELIABLE for profile in offered)
    return QoSProfile(
        depth=QUEUE_DEPTH,
        durability=DurabilityPolicy.TRANSIENT_LOCAL if is_latched else DurabilityPolicy.VOLATILE,
        reliability=ReliabilityPolicy.RELIABLE if is_reliable else ReliabilityPolicy.BEST_EFFORT,
    )
