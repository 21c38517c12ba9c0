"""Read a truncated bag, whose recorder was killed, up to its last complete message.

    magic | record | chunk of records | chunk of records | chunk of re      the index, which would come last,
                                                                  ^ cut     is missing

An .mcap and a .bag of ROS 1 are such sequences, and their index only tells where
to find what.  Without it they are read from the beginning, twice: once for the
topics, once for the messages.  What is broken in its middle ends there, too.

Other tools call it recovering (`mcap recover`) and reindexing (`rosbag reindex`).
"""

from __future__ import annotations

import sys
from bz2 import BZ2Decompressor
from collections import Counter
from collections.abc import Iterator, Sequence
from contextlib import suppress
from pathlib import Path
from struct import Struct
from struct import error as StructError
from typing import BinaryIO, NamedTuple

from tflab.core import NSEC_PER_SEC

from .errors import BagError

__all__ = ["Salvage", "has_other_profile", "is_without_end", "unpack"]

MCAP_MAGIC = b"\x89MCAP0\r\n"
MCAP_FOOTER = 37  # bytes, with the closing magic
MCAP_SCHEMA, MCAP_CHANNEL, MCAP_MESSAGE, MCAP_CHUNK = 3, 4, 5, 6  # kinds of record
ROS1_MAGIC = b"#ROSBAG V2.0\n"
ROS1_MESSAGE, ROS1_CHUNK, ROS1_CONNECTION = 2, 5, 7
LARGEST = 2**31  # bytes of a record: who says more is broken

_u16, _u32, _u64 = Struct("<H"), Struct("<I"), Struct("<Q")
_message = Struct("<HIQQ")  # channel, sequence, log time, publish time
_stamp = Struct("<II")


class FoundTopic(NamedTuple):
    """One connection, in the words of the file."""

    number: int
    topic: str
    msgtype: str
    definition: str
    publisher: str
    encoding: str = ""


class FoundMessage(NamedTuple):
    """One message, of a connection that came before it."""

    number: int
    receive_ns: int
    data: bytes


class Salvage:
    """A file without its end, or an .mcap that rosbags does not read, with the interface of a reader of rosbags.

    Attributes:
        connections: with as many messages as are left.
        message_count: of all of them.
        start_time, end_time: of the messages [ns], the end exclusive.
    """

    def __init__(self, path: Path) -> None:
        self._path = path
        with path.open("rb") as file:
            self._is_bag = file.read(len(ROS1_MAGIC)) == ROS1_MAGIC
        topics: dict[int, FoundTopic] = {}
        counts: Counter[int] = Counter()
        self.start_time, self.end_time = 2**63 - 1, 0
        for record in self._records():
            if isinstance(record, FoundTopic):
                topics.setdefault(record.number, record)
            elif record.number in topics:
                counts[record.number] += 1
                self.start_time = min(self.start_time, record.receive_ns)
                self.end_time = max(self.end_time, record.receive_ns + 1)
        encodings = {topic.encoding for topic in topics.values()}
        self.is_ros1 = self._is_bag or "ros1" in encodings
        if encodings and not encodings & {"", "cdr", "ros1"}:
            raise BagError(f"{path}: not supported, the messages are encoded as {', '.join(sorted(encodings))}; "
                           f"those of ROS are cdr or ros1")  # fmt: skip
        self.message_count = counts.total()
        self.connections = [_connection(topic, counts[number], self.is_ros1) for number, topic in topics.items()]

    def messages(self, connections: Sequence, start: int = 0) -> Iterator[tuple]:
        """Yield (connection, time of receipt [ns], bytes) of each message from `start` on, in the order of the file."""
        wanted = {connection.id: connection for connection in connections}
        for record in self._records():
            if isinstance(record, FoundMessage) and record.number in wanted and record.receive_ns >= start:
                yield wanted[record.number], record.receive_ns, record.data

    def _records(self) -> Iterator[FoundTopic | FoundMessage]:
        with self._path.open("rb") as file:
            yield from _ros1_records(file) if self._is_bag else _mcap_records(file)


def is_without_end(path: Path, kind: str) -> bool:
    """Return whether a file of this kind lacks the index that is written last."""
    size = path.stat().st_size
    with path.open("rb") as file:
        if kind == ".mcap":
            file.seek(max(0, size - len(MCAP_MAGIC)))
            return size < MCAP_FOOTER + len(MCAP_MAGIC) or file.read() != MCAP_MAGIC
        if kind != ".bag":
            return False
        file.seek(len(ROS1_MAGIC))
        fields = _ros1_fields(_sized(file))
    index_at = int.from_bytes(fields.get(b"index_pos", b""), "little")
    is_empty = index_at == size and not any(fields.get(b"conn_count", b"\1"))
    return not (0 < index_at < size or is_empty)


def has_other_profile(path: Path) -> bool:
    """Return whether the header of an .mcap names another profile than ros2, or none; rosbags reads no such file."""
    with path.open("rb") as file:
        file.seek(len(MCAP_MAGIC) + 9)
        header = file.read(256)
    return len(header) >= 4 and _word(header)[0] != "ros2"


def unpack(path: Path, whole: Path) -> None:
    """Write what is in a file that was compressed by zstd."""
    unpacker = _zstd()
    with path.open("rb") as packed, whole.open("wb") as file:
        while data := packed.read(2**20):
            file.write(unpacker.decompress(data))


def _connection(topic: FoundTopic, count: int, is_ros1: bool):
    """Return a connection as rosbags makes them; who offered what is not told any more."""
    from rosbags.interfaces import (
        Connection,
        ConnectionExtRosbag1,
        ConnectionExtRosbag2,
        MessageDefinition,
        MessageDefinitionFormat,
    )

    definition = MessageDefinition(
        MessageDefinitionFormat.MSG if topic.definition else MessageDefinitionFormat.NONE, topic.definition
    )
    ext = ConnectionExtRosbag1(topic.publisher, None) if is_ros1 else ConnectionExtRosbag2("cdr", [])
    return Connection(topic.number, topic.topic, topic.msgtype, definition, "", count, ext, None)


# -- mcap ------------------------------------------------------------------------


def _mcap_records(file: BinaryIO) -> Iterator[FoundTopic | FoundMessage]:
    file.seek(len(MCAP_MAGIC))
    schemas: dict[int, tuple[str, str]] = {0: ("", "")}
    for kind, data in _mcap_parts(file):
        if kind == MCAP_CHUNK:
            for inner_kind, inner in _parts_of(_mcap_chunk(data)):
                yield from _mcap_record(inner_kind, inner, schemas)
        else:
            yield from _mcap_record(kind, data, schemas)


def _mcap_parts(file: BinaryIO) -> Iterator[tuple[int, bytes]]:
    """Yield kind and bytes of each record; of the last one what is left."""
    while len(head := file.read(9)) == 9:
        size = _u64.unpack(head[1:])[0]
        if size > LARGEST:
            return
        yield head[0], file.read(size)


def _parts_of(data: bytes) -> Iterator[tuple[int, bytes]]:
    """Yield kind and bytes of each whole record in a chunk."""
    at = 0
    while at + 9 <= len(data):
        size = _u64.unpack_from(data, at + 1)[0]
        if at + 9 + size > len(data):
            return
        yield data[at], data[at + 9 : at + 9 + size]
        at += 9 + size


def _mcap_record(kind: int, data: bytes, schemas: dict[int, tuple[str, str]]) -> Iterator[FoundTopic | FoundMessage]:
    """Yield what a record tells, nothing if it is cut off."""
    with suppress(StructError, UnicodeDecodeError, KeyError):
        if kind == MCAP_MESSAGE:
            number, _, receive_ns, _ = _message.unpack_from(data)
            yield FoundMessage(number, receive_ns, data[_message.size :])
        elif kind == MCAP_SCHEMA:
            name, rest = _word(data[2:])
            _, rest = _word(rest)
            schemas[_u16.unpack_from(data)[0]] = (name, _word(rest)[0])
        elif kind == MCAP_CHANNEL:
            number, schema = _u16.unpack_from(data)[0], _u16.unpack_from(data, 2)[0]
            (topic, rest), (kind_of_message, definition) = _word(data[4:]), schemas[schema]
            modern = kind_of_message if "/msg/" in kind_of_message else kind_of_message.replace("/", "/msg/")
            yield FoundTopic(number, topic, modern, definition, "", _word(rest)[0])


def _mcap_chunk(data: bytes) -> bytes:
    """Return the records in a chunk, as many as are left."""
    if len(data) < 40:
        return b""
    size = _u32.unpack_from(data, 28)[0]
    return _unpacked(data[40 + size :], data[32 : 32 + size].decode("ascii", "replace"))


def _word(data: bytes) -> tuple[str, bytes]:
    """Return the text at the beginning, and what is behind it."""
    size = _u32.unpack_from(data)[0]
    return data[4 : 4 + size].decode(), data[4 + size :]


# -- ROS 1 -----------------------------------------------------------------------


def _ros1_records(file: BinaryIO) -> Iterator[FoundTopic | FoundMessage]:
    file.seek(len(ROS1_MAGIC))
    while head := _sized(file):
        fields = _ros1_fields(head)
        data = _sized(file)
        kind = _kind_of(fields)
        if kind == ROS1_CHUNK:
            packing = fields.get(b"compression", b"none").decode("ascii", "replace")
            yield from _ros1_chunk(_unpacked(data, "" if packing == "none" else packing))
        else:
            yield from _ros1_record(kind, fields, data)


def _ros1_chunk(data: bytes) -> Iterator[FoundTopic | FoundMessage]:
    at = 0
    while at + 8 <= len(data):
        size = _u32.unpack_from(data, at)[0]
        if at + 8 + size > len(data):
            return
        fields = _ros1_fields(data[at + 4 : at + 4 + size])
        at += 4 + size
        size = _u32.unpack_from(data, at)[0]
        if at + 4 + size > len(data):
            return
        yield from _ros1_record(_kind_of(fields), fields, data[at + 4 : at + 4 + size])
        at += 4 + size


def _ros1_record(kind: int, fields: dict[bytes, bytes], data: bytes) -> Iterator[FoundTopic | FoundMessage]:
    with suppress(StructError, KeyError, UnicodeDecodeError):
        if kind == ROS1_MESSAGE:
            sec, nanosec = _stamp.unpack(fields[b"time"])
            yield FoundMessage(_u32.unpack(fields[b"conn"])[0], sec * NSEC_PER_SEC + nanosec, data)
        elif kind == ROS1_CONNECTION:
            more = _ros1_fields(data)
            package, _, name = more[b"type"].decode().partition("/")
            publisher = more.get(b"callerid", b"").decode()
            definition = more.get(b"message_definition", b"").decode()
            topic = fields[b"topic"].decode()
            yield FoundTopic(_u32.unpack(fields[b"conn"])[0], topic, f"{package}/msg/{name}", definition, publisher)


def _sized(file: BinaryIO) -> bytes:
    """Return the next so many bytes, as the four before them say; what is left of them at the end."""
    head = file.read(4)
    size = _u32.unpack(head)[0] if len(head) == 4 else 0
    return file.read(size) if size < LARGEST else b""


def _ros1_fields(data: bytes) -> dict[bytes, bytes]:
    """Return the fields of a header: name=value, each with its size before it."""
    fields, at = {}, 0
    while at + 4 <= len(data):
        size = _u32.unpack_from(data, at)[0]
        name, _, value = data[at + 4 : at + 4 + size].partition(b"=")
        fields[name] = value
        at += 4 + size
    return fields


def _kind_of(fields: dict[bytes, bytes]) -> int:
    return int.from_bytes(fields.get(b"op", b""), "little")


def _unpacked(data: bytes, packing: str) -> bytes:
    """Return what was compressed, as far as it goes."""
    if not packing:
        return data
    unpacked = bytearray()
    with suppress(Exception):  # each of the libraries has its own word for broken
        for at in range(0, len(data), 4096) if packing in UNPACKERS else ():
            if not at:
                unpacker = UNPACKERS[packing]()
            unpacked += unpacker.decompress(data[at : at + 4096])
    return bytes(unpacked)


def _lz4():
    from lz4.frame import LZ4FrameDecompressor

    return LZ4FrameDecompressor()


def _zstd():
    if sys.version_info >= (3, 14):
        from compression import zstd
    else:
        from backports import zstd

    return zstd.ZstdDecompressor()


UNPACKERS = {"bz2": BZ2Decompressor, "lz4": _lz4, "zstd": _zstd}
