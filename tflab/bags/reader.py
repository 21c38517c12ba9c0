"""Read a bag of ROS 2 or ROS 1 into a `Recording`.

    drive/  metadata.yaml + drive_0.mcap | .db3     rosbag2
    drive_0.mcap, drive_0.db3                       one file of it
    drive.bag                                       ROS 1
        |
        v  rosbags: which messages are there, and their bytes
    TFMessage, Header, Clock       read here (messages.py)
    JointState, Odometry, String   read by rosbags

A bag whose recorder was killed has no metadata.yaml, or its file no end: then
what is there is read, if that is asked for.
"""

from __future__ import annotations

import re
import shlex
import sqlite3
import struct
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from shutil import copyfile
from tempfile import TemporaryDirectory

from .collect import Collector
from .errors import BagError
from .recording import Recording, Unfinished
from .salvage import Salvage, has_other_profile, is_without_end, unpack

__all__ = ["open_bag", "read_bag"]

SUFFIXES = (".mcap", ".db3", ".bag")
MAGICS = {b"#ROSBAG V": ".bag", b"\x89MCAP0\r\n": ".mcap", b"SQLite format 3\0": ".db3", b"\x28\xb5\x2f\xfd": ".zstd"}
STORAGES = {".mcap": "mcap", ".db3": "sqlite3"}
SAME_BEGIN_NS = 10**9  # of a file that was renamed: a recorder may note when it began the file, or its first message
SQLITE_HEADER = struct.Struct(">16xH10xI")  # size of a page, and how many there are
REMEDIES = {
    ".mcap": "mcap recover {file} -o whole.mcap",
    ".bag": "rosbag reindex {file}",
    "directory": "ros2 bag reindex {file}",
    ".db3": "sqlite3 {file} .recover",
}


def read_bag(path: str | Path, show_progress: bool = True, salvage: bool = False) -> Recording:
    """Return what a bag tells about transforms and time.

    Args:
        salvage: whether to read what a killed recorder has left; the recording then says that it is unfinished.

    Raises:
        BagError: there is no such file, or it is empty, cut short, or not a bag.
    """
    path = Path(path).expanduser()
    files = _files_left_in(path) if salvage else []
    unfinished = _unfinished(path, "directory", "metadata.yaml does not tell of all of it", is_cut=False)
    unfinished = (_missing_from(path)[0] or unfinished) if files else None
    collector, begin_ns, end_ns = None, 2**63 - 1, 0
    for file in files or [path]:
        with _opened(file, salvage) as (reader, is_ros1, why):
            unfinished = why or unfinished
            collector = collector or Collector(is_ros1)
            _read(reader, collector, f"reading {file.name}" if show_progress else "")
            if any(connection.msgcount for connection in reader.connections):
                begin_ns, end_ns = min(begin_ns, reader.start_time), max(end_ns, reader.end_time - 1)
    return collector.recording(path.name, begin_ns if end_ns else 0, end_ns, unfinished)


def _read(reader, collector: Collector, title: str) -> None:
    """Pass all messages that a collector wants to it."""
    from tqdm import tqdm  # comes with tflab[bags], as rosbags does

    collector.begin_file(reader.connections)
    wanted = [connection for connection in reader.connections if collector.wants(connection)]
    messages = reader.messages(connections=wanted) if wanted else ()
    total = sum(connection.msgcount for connection in wanted)
    with tqdm(messages, title, total, leave=False, disable=None if title else True) as progress:
        for connection, receive_ns, data in progress:
            collector.add(connection, receive_ns, data)


@contextmanager
def _opened(path: Path, salvage: bool) -> Iterator[tuple]:
    """Open a file or a directory: (the reader, whether it is ROS 1, what it lacks if it is unfinished)."""
    kind = _kind_of(path)
    log = Path(f"{path}-wal")
    kind = kind if salvage else ""
    if kind in (".mcap", ".bag") and is_without_end(path, kind):
        try:
            reader = Salvage(path)
        except (OSError, MemoryError) as error:
            raise BagError(f"{path}: cannot be read ({error})") from None
        if not any(connection.msgcount for connection in reader.connections):
            raise BagError(f"{path}: the file is cut short, and no message is left")
        yield reader, reader.is_ros1, _unfinished(path, kind, f"{path.name} has no end", is_cut=True)
    elif kind == ".db3" and log.exists() and log.stat().st_size:
        why = _unfinished(path, kind, f"{log.name} was left, and is read, too", is_cut=False)
        with TemporaryDirectory() as folder, open_bag(_with_its_log(path, log, Path(folder))) as (reader, is_ros1):
            yield reader, is_ros1, why
    else:
        with open_bag(path) as (reader, is_ros1):
            yield reader, is_ros1, None


def _unfinished(path: Path, kind: str, what: str, is_cut: bool) -> Unfinished:
    return Unfinished(what, REMEDIES[kind].format(file=path.name), is_cut)


def _files_left_in(path: Path) -> list[Path]:
    """Return the storage files of a directory whose recorder did not come to write what is in it."""
    if not path.is_dir():
        return []
    files = [file for suffix in SUFFIXES for file in path.glob(f"*{suffix}")]
    missing, renamed = _missing_from(path)
    is_whole = not any(is_without_end(file, file.suffix) for file in files) and not missing
    if (path / "metadata.yaml").exists() and is_whole:
        return []
    stems = {file: Path(renamed.get(file.name, file.name)).stem for file in files}
    return sorted(files, key=lambda file: [int(word) if word.isdigit() else 0 for word in stems[file].split("_")[-1:]])


def _listed_in(path: Path) -> tuple[list[str], dict[str, tuple[int, int]]]:
    """Return the files that metadata.yaml names, and when each, or the first, began and how long it lasted [ns]."""
    from ruamel.yaml import YAML, YAMLError  # rosbags brings it

    try:
        bag = YAML(typ="safe").load((path / "metadata.yaml").read_text("utf-8"))["rosbag2_bagfile_information"]
        names = [Path(name).name for name in bag["relative_file_paths"]]
        held = {file["path"]: (file["starting_time"]["nanoseconds_since_epoch"], file["duration"]["nanoseconds"])
                for file in bag.get("files", ())}  # fmt: skip
        return names, held or dict.fromkeys(names[:1], (bag["starting_time"]["nanoseconds_since_epoch"], 0))
    except (OSError, YAMLError, KeyError, TypeError, AttributeError):
        return [], {}  # rosbags gives the reason


def _missing_from(path: Path) -> tuple[Unfinished | None, dict[str, str]]:
    """Return which files of metadata.yaml are not there, and the time they held; and the old names of renamed ones."""
    names, held = _listed_in(path)
    renamed = _renamed(path, names, held)
    gone = [name for name in names if name not in renamed.values() and not (path / name).exists()]
    if renamed and not gone:
        moves = [shlex.join(["mv", f"{path.name}/{new}", f"{path.name}/{old}"]) for new, old in renamed.items()]
        what = f"metadata.yaml of {path.name} names {', '.join(renamed.values())}, which is {', '.join(renamed)} now"
        return Unfinished(what, " && ".join(moves), False, "file-renamed"), renamed
    first_ns = min(begin_ns for begin_ns, _ in held.values()) if gone else 0
    missing = []
    for name in gone:
        begin_ns, long_ns = held.get(name, (first_ns, 0))
        begin_s, end_s = (begin_ns - first_ns) / 1e9, (begin_ns - first_ns + long_ns) / 1e9
        missing.append(f"{name} ({begin_s:.1f} s to {end_s:.1f} s)" if long_ns else name)
    what = f"{', '.join(missing)} of {path.name} is missing"
    remedy = REMEDIES["directory"].format(file=path.name)
    return Unfinished(what, remedy, True, "file-missing") if gone else None, renamed


def _renamed(path: Path, names: list[str], held: dict[str, tuple[int, int]]) -> dict[str, str]:
    """Return the old names of files that metadata.yaml does not name, and that begin when missing ones did."""
    gone = {name: begin_ns for name, (begin_ns, _) in held.items() if not (path / name).exists()}
    renamed = {}
    for file in sorted(path.iterdir()) if gone else ():
        if file.suffix not in SUFFIXES or file.name in names:
            continue
        with suppress(BagError), open_bag(file) as (reader, _):
            old = min(gone, key=lambda name: abs(gone[name] - reader.start_time))
            if abs(gone[old] - reader.start_time) < SAME_BEGIN_NS:
                renamed[file.name] = old
    return renamed


def _with_its_log(path: Path, log: Path, folder: Path) -> Path:
    """Return a copy of a database that holds what a killed recorder had only in its write-ahead log."""
    whole = folder / path.name
    copyfile(path, whole)
    copyfile(log, Path(f"{whole}-wal"))
    try:
        with sqlite3.connect(whole) as database:
            database.execute("PRAGMA wal_checkpoint(TRUNCATE)")
        database.close()
    except sqlite3.Error as error:
        raise BagError(f"{path}: cannot be read together with {log.name} ({error})") from None
    return whole


class _InUtf8(type(Path())):
    """A path below which texts are UTF-8.

    rosbags names no encoding where it reads metadata.yaml, and that of a Korean Windows spoils the names in it.
    """

    def read_text(self, encoding: str | None = None, errors: str | None = None) -> str:
        """Return the text of metadata.yaml, with the storage that some converters leave empty."""
        kinds = {suffix for file in self.parent.iterdir() for suffix in file.suffixes if suffix in STORAGES}
        storage = f"storage_identifier: {STORAGES[max(kinds, default='.mcap')]}"
        text = super().read_text(encoding or "utf-8", errors)
        return re.sub(r"storage_identifier: *(\"\"|'')? *$", storage, text, flags=re.MULTILINE)


@contextmanager
def open_bag(path: str | Path) -> Iterator[tuple]:
    """Open a bag for reading: (the reader of rosbags, whether it is ROS 1), closed at the end.

    Raises:
        BagError: also for whatever goes wrong while it is open: a foreign or broken
            file can fail anywhere in the library, in its own words.
    """
    from rosbags.rosbag1 import Reader as Reader1
    from rosbags.rosbag2 import Reader as Reader2

    path = Path(path).expanduser()
    kind = _kind_of(path)
    try:
        if kind == ".zstd":
            with TemporaryDirectory() as folder:
                unpack(path, Path(folder) / path.stem)
                with open_bag(Path(folder) / path.stem) as opened:
                    yield opened
            return
        if kind == ".mcap" and has_other_profile(path) and not is_without_end(path, kind):
            foreign = Salvage(path)
            yield foreign, foreign.is_ros1
            return
        with (Reader1 if kind == ".bag" else Reader2)(_InUtf8(path)) as reader:
            yield reader, kind == ".bag"
    except (BagError, KeyboardInterrupt, GeneratorExit):
        raise
    except MemoryError:
        raise BagError(f"{path}: too large for the memory of this machine, or broken") from None
    except Exception as error:
        reason = " ".join(str(error).split()).partition("; please")[0].rstrip(".") or type(error).__name__
        is_foreign_kind = "not supported" in reason or reason.startswith("Profile is not")
        seems = "this kind is not supported" if is_foreign_kind else "it seems to be broken or cut short"
        raise BagError(f"{path}: cannot be read, {seems} ({reason})") from error


def _kind_of(path: Path) -> str:
    """Return ".bag", ".mcap", ".db3" or "directory", judged by what is in there."""
    if not path.exists():
        raise BagError(f"{path}: there is no such file or directory")
    if path.is_dir():
        if (path / "metadata.yaml").exists():
            return "directory"
        files = sorted(p.name for p in path.iterdir() if p.suffix in (".mcap", ".db3", ".bag"))
        if not files:
            raise BagError(f"{path}: not a bag, a rosbag2 directory holds a metadata.yaml and .mcap or .db3 files")
        raise BagError(
            f"{path}: metadata.yaml is missing, the recorder was probably killed; try the file {path / files[0]}, "
            f"or `ros2 bag reindex {path}` on a robot"
        )
    try:
        with path.open("rb") as file:
            start = file.read(SQLITE_HEADER.size)
    except OSError as error:
        raise BagError(f"{path}: cannot be opened ({error.strerror})") from None
    if not start:
        raise BagError(f"{path}: the file is empty")
    for magic, kind in MAGICS.items():
        if start.startswith(magic):
            if kind != ".bag" and path.suffix != kind:
                raise BagError(f"{path}: this is a {kind} file, but its name does not end in {kind}; rename it")
            if kind == ".db3" and _is_cut_short(start, path.stat().st_size):
                raise BagError(f"{path}: the file is cut short; `sqlite3 {path.name} .recover` may save something")
            return kind
    raise BagError(f"{path}: not a bag; known are rosbag2 directories, .mcap, .db3, and .bag of ROS 1 (version 2.0)")


def _is_cut_short(start: bytes, size: int) -> bool:
    """Return whether an SQLite file is smaller than its header says: the missing pages would read as zeros."""
    if len(start) < SQLITE_HEADER.size:
        return True
    page_size, pages = SQLITE_HEADER.unpack(start)
    return pages * (65536 if page_size == 1 else page_size) > size
