"""Print `ros2 bag info`: size, times, and how many messages of each topic. Also find the example bag.

    Files:             drive_0.mcap
    Bag size:          2.7 MiB
    ...
    Topic information: Topic: /tf | Type: tf2_msgs/msg/TFMessage | Count: 958 | Serialization Format: cdr

Humble prints the times with milliseconds that are not padded (.045 as .45), and
has no lines about distribution and services.  Times of day are local, as upstream;
on virtual time, where a page must print the same everywhere, they are UTC.
"""

from __future__ import annotations

from datetime import datetime, timezone
from importlib.resources import files
from pathlib import Path
from typing import NamedTuple

from tflab.core import NSEC_PER_SEC
from tflab.ros import distro

from .reader import open_bag

__all__ = ["BagFacts", "bag_facts", "example_bag", "info_text"]

INDENT = " " * len("Topic information: ")
UNITS = ("B", "KiB", "MiB", "GiB", "TiB")


class BagFacts(NamedTuple):
    """What `info` prints.

    Attributes:
        size: of all files [bytes].
        topics: name, type, count, serialization format.
    """

    files: tuple[str, ...]
    size: int
    storage: str
    ros_distro: str
    begin_ns: int
    duration_ns: int
    count: int
    topics: tuple[tuple[str, str, int, str], ...]


def bag_facts(path: str | Path) -> BagFacts:
    """Return the facts about a bag.

    Raises:
        BagError: it cannot be read.
    """
    path = Path(path).expanduser()
    files = [path]
    with open_bag(path) as (reader, _):
        if path.is_dir():
            files = sorted(file for file in path.iterdir() if file.suffix != ".yaml")
        has_messages = bool(reader.message_count)
        storage = getattr(reader, "storage", None)  # of a rosbag2
        topics: dict[tuple[str, str, str], int] = {}
        for connection in reader.connections:
            key = (connection.topic, connection.msgtype, getattr(connection.ext, "serialization_format", "ros1"))
            topics[key] = topics.get(key, 0) + connection.msgcount
        return BagFacts(
            files=tuple(file.name for file in files),
            size=sum(file.stat().st_size for file in files),
            storage={".bag": "rosbag_v2", ".mcap": "mcap"}.get(files[0].suffix, "sqlite3"),
            ros_distro=(storage.metadata.ros_distro if storage and storage.metadata else None) or "unknown",
            begin_ns=reader.start_time if has_messages else 0,
            duration_ns=reader.end_time - 1 - reader.start_time if has_messages else 0,
            count=reader.message_count,
            topics=tuple((name, kind, count, form) for (name, kind, form), count in topics.items()),
        )


def info_text(facts: BagFacts, zone: timezone | None = None) -> str:
    """Return what `ros2 bag info` prints, with times of day in `zone`, the machine's own if None."""
    is_humble = distro.current().name == "humble"
    separator = "\n" + INDENT
    topics = separator.join(
        f"Topic: {name} | Type: {kind} | Count: {count} | Serialization Format: {form}"
        for name, kind, count, form in facts.topics
    )
    lines = [
        "",
        f"Files:             {separator.join(facts.files)}",
        f"Bag size:          {size_text(facts.size)}",
        f"Storage id:        {facts.storage}",
        *([] if is_humble else [f"ROS Distro:        {facts.ros_distro}"]),
        f"Duration:          {_seconds_text(facts.duration_ns, is_humble)}s",
        f"Start:             {_moment_text(facts.begin_ns, is_humble, zone)}",
        f"End:               {_moment_text(facts.begin_ns + facts.duration_ns, is_humble, zone)}",
        f"Messages:          {facts.count}",
        f"Topic information: {topics}",
        *([] if is_humble else ["Service:           0", "Service information: "]),
    ]
    return "\n".join(lines)


def size_text(size: int) -> str:
    """Return a size as people read it: 518 B, 2.7 MiB."""
    value, unit = float(size), 0
    while value >= 1024.0 and unit < len(UNITS) - 1:
        value /= 1024.0
        unit += 1
    return f"{value:.1f} {UNITS[unit]}" if unit else f"{size} B"


def _seconds_text(time_ns: int, is_humble: bool) -> str:
    sec, nanosec = divmod(time_ns, NSEC_PER_SEC)
    return f"{sec}.{nanosec // 1_000_000}" if is_humble else f"{sec}.{nanosec:09d}"


def _moment_text(time_ns: int, is_humble: bool, zone: timezone | None) -> str:
    seconds = _seconds_text(time_ns, is_humble)
    moment = datetime.fromtimestamp(time_ns // NSEC_PER_SEC, zone)
    day = f"{moment:%b} {moment.day:2d} {moment:%Y %H:%M:%S}"
    return f"{day}.{seconds.partition('.')[2]} ({seconds})"


def example_bag() -> Path:
    """Return the folder of the bag that comes with the package; it is there to be read."""
    return Path(str(files("tflab.bags") / "data" / "kitchen"))
