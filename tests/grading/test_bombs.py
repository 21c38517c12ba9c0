"""What somebody handed in unpacks, lists and reads within bounds, before anybody is graded."""

from __future__ import annotations

import contextlib
import io
import random
import struct
import time
import tracemalloc
import zipfile
from pathlib import Path

import pytest

from tflab.grading.submissions import archives, collect
from tflab.grading.submissions.archives import archive_members
from tflab.grading.submissions.reader import Unreadable, read_notebook
from tflab.grading.submissions.roster import Learner

MIB = 1 << 20
WAYS = {"stored": zipfile.ZIP_STORED, "deflate": zipfile.ZIP_DEFLATED}
NAME = "03_tiny.ipynb"
LIST_ENTRY = struct.pack("<4sHHHHHHIIIHHHHHII", b"PK\1\2", 46, 46, 0, 0, 0, 0x21, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0)


def packed(data: bytes, way: int) -> bytes:
    held = io.BytesIO()
    with zipfile.ZipFile(held, "w", way) as archive:
        archive.writestr(NAME, data)
    return held.getvalue()


def claiming(held: bytes, size: int) -> bytes:
    """Return a zip of one file that claims another size for it than it has, in both places."""
    at = held.rindex(b"PK\1\2")
    return b"".join([held[:22], struct.pack("<I", size), held[26 : at + 24], struct.pack("<I", size), held[at + 28 :]])


def only_file(held: bytes, tmp_path: Path) -> bytes:
    (tmp_path / "a.zip").write_bytes(held)
    (member,), _ = archive_members(tmp_path / "a.zip")
    return member.read()


@pytest.mark.parametrize("way", WAYS.values(), ids=list(WAYS))
def test_what_is_packed_as_usual_is_read_and_what_was_changed_is_damaged(way: int, tmp_path: Path) -> None:
    assert only_file(packed(b"{} " * 5000, way), tmp_path) == b"{} " * 5000
    held = bytearray(packed(bytes(range(256)) * 40, way))
    held[len(held) // 3] ^= 0xFF
    unknown = bytearray(packed(b"{}", way))
    for at in (8, unknown.rindex(b"PK\1\2") + 10):
        unknown[at : at + 2] = struct.pack("<H", 93)  # Zstandard
    for damaged in (held, unknown):
        with pytest.raises(Unreadable, match="damaged"):
            only_file(bytes(damaged), tmp_path)


@pytest.mark.parametrize("claimed", [1000, 32 * MIB])
def test_no_more_is_unpacked_than_may_be_read_whatever_the_zip_says(
    claimed: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    bomb = claiming(packed(bytes(32 * MIB), zipfile.ZIP_DEFLATED), claimed)
    monkeypatch.setattr(archives, "MAX_BYTES", MIB)
    tracemalloc.start()
    try:
        with pytest.raises(Unreadable):
            only_file(bomb, tmp_path)
        _, most = tracemalloc.get_traced_memory()
    finally:
        tracemalloc.stop()
    assert most < 16 * MIB


@pytest.mark.parametrize("way", [zipfile.ZIP_BZIP2, zipfile.ZIP_LZMA])
def test_what_is_packed_in_a_way_that_cannot_be_unpacked_in_part_is_refused(way: int, tmp_path: Path) -> None:
    with pytest.raises(Unreadable, match="damaged"):
        only_file(packed(b"{}", way), tmp_path)


def list_of(count: int, *, length: int | None = None, wide: bool = False, said: int | None = None) -> bytes:
    """Return a zip of nothing but a list; its end says `said` names, or stands in the long form behind a short one."""
    names = LIST_ENTRY * count
    length = len(names) if length is None else length
    said = min(count, 0xFFFF) if said is None else said
    long_form = struct.pack("<4sQHHIIQQQQ", b"PK\6\6", 44, 45, 45, 0, 0, count, count, length, 0)
    where = struct.pack("<4sIQI", b"PK\6\7", 0, len(names), 1)
    short = struct.pack("<4sHHHHIIH", b"PK\5\6", 0, 0, said, said, 46 if wide else min(length, 0xFFFFFFFE), 0, 0)
    return names + (long_form + where if wide else b"") + short


@pytest.mark.parametrize("inside", [False, True], ids=["on the disk", "in a zip"])
@pytest.mark.parametrize(
    "held",
    [
        list_of(120_000),
        list_of(120_000, said=1),
        list_of(120_000, wide=True, said=1),
        list_of(9, length=1 << 62, wide=True),
    ],
    ids=["many", "fewer are said", "in the long form", "as long as can be said"],
)
def test_a_list_of_too_many_names_is_refused_before_it_is_read(
    held: bytes, inside: bool, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "s101.zip").write_bytes(zipped_in_a_zip(held) if inside else held)
    made: list[int] = []

    class Counted(zipfile.ZipInfo):
        def __init__(self, *args: object) -> None:
            made.append(1)
            super().__init__(*args)  # type: ignore[arg-type]

    monkeypatch.setattr(archives.zipfile, "ZipInfo", Counted)
    found = collect.collect(tmp_path, {"s101": Learner("s101")}, ["03_tiny"], is_genuine=bool)
    said = [remark.say("en") for remark in found.remarks]
    assert any("list of its files is longer" in line or "not a zip" in line for line in said)
    assert len(made) < 10  # of the one that holds it


def zipped_in_a_zip(held: bytes) -> bytes:
    outer = io.BytesIO()
    with zipfile.ZipFile(outer, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("in.zip", held)
    return outer.getvalue()


@pytest.mark.parametrize("begin", [(1 << 64) - 1, 1 << 63, (1 << 63) - 1, 1 << 40])
@pytest.mark.parametrize("inside", [False, True], ids=["on the disk", "in a zip"])
def test_a_file_that_is_said_to_begin_nowhere_is_damaged(begin: int, inside: bool, tmp_path: Path) -> None:
    name, long_form = NAME.encode(), struct.pack("<HHQ", 1, 8, begin)
    lengths = 0, 0, 0, len(name), len(long_form), 0, 0, 0, 0
    entry = struct.pack("<4sHHHHHHIIIHHHHHII", b"PK\1\2", 45, 45, 0, 0, 0, 0x21, *lengths, 0xFFFFFFFF)
    entry += name + long_form
    held = entry + struct.pack("<4sHHHHIIH", b"PK\5\6", 0, 0, 1, 1, len(entry), 0, 0)
    (tmp_path / "a.zip").write_bytes(held)
    (member,), _ = archive_members((lambda: held) if inside else tmp_path / "a.zip", most=10)
    with pytest.raises(Unreadable, match="damaged"):
        member.read()


def test_a_zip_whose_bits_were_changed_anywhere_is_read_or_refused() -> None:
    dice = random.Random(0)
    for way in [*WAYS.values()] * 60:
        held = bytearray(packed(b"{} " * 50, way))
        for _ in range(dice.choice((1, 2, 8))):
            held[dice.randrange(len(held))] = dice.choice((0, 0xFF, dice.randrange(256)))
        with contextlib.suppress(Unreadable):
            for member in archive_members(lambda held=bytes(held): held, most=10)[0]:
                member.read()


def test_more_files_than_one_learner_has_are_refused(tmp_path: Path) -> None:
    (tmp_path / "s101.zip").write_bytes(list_of(10_001))
    found = collect.collect(tmp_path, {"s101": Learner("s101")}, ["03_tiny"], is_genuine=bool)
    assert any("it contains 10001 files, more than" in remark.say("en") for remark in found.remarks)


NOT_CLOSED = {
    "a text full of quotes": '{"cells": "' + '\\"' * 200_000,
    "and one stroke more": '{"cells": "' + '\\"' * 200_000 + "\\",
    "strokes": '"' + "\\" * 400_001,
    "quotes": '"' * 200_001,
    "outputs without end": '"outputs":[' * 40_000,
    "outputs that are none": ('"outputs"' + " " * 40) * 8_000,
    "lists": "[" * 400_000,
    "a number of many digits": '{"cells": [], "x": ' + "9" * 400_000 + ".5}",
}


@pytest.mark.parametrize("text", NOT_CLOSED.values(), ids=list(NOT_CLOSED))
def test_no_text_takes_long_to_read(text: str) -> None:
    begin = time.process_time()
    with contextlib.suppress(Unreadable):
        read_notebook(text.encode())
    assert time.process_time() - begin < 5  # it was hours
