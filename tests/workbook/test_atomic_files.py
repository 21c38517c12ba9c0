"""Files are written whole, also where a file system has no locks and no rights."""

from __future__ import annotations

import errno
from pathlib import Path

import pytest

from tflab.workbook import atomic_files
from tflab.workbook.atomic_files import locked, write_whole

fcntl = pytest.importorskip("fcntl", reason="Windows locks in another way")


def test_a_share_without_locks_is_used_without_and_a_lock_that_fails_is_said(tmp_path: Path, monkeypatch) -> None:
    def fails_with(number: int) -> None:
        def fails(handle: int, operation: int) -> None:
            raise OSError(number, "no locks here")

        monkeypatch.setattr(atomic_files.fcntl, "flock", fails)

    for number in (errno.ENOLCK, errno.ENOSYS, errno.EOPNOTSUPP):
        fails_with(number)
        with locked(tmp_path):
            write_whole(tmp_path / "kept", f"mine {number}")
        assert (tmp_path / "kept").read_text() == f"mine {number}"
    fails_with(errno.EIO)
    with pytest.raises(OSError, match="no locks here"), locked(tmp_path):
        pass


def test_a_share_without_rights_is_written_to_all_the_same(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def refuses(*of_a_file: object) -> None:
        raise PermissionError(errno.EPERM, "Operation not permitted")

    monkeypatch.setattr(atomic_files.os, "chmod", refuses)
    write_whole(tmp_path / "kept", "mine")
    assert (tmp_path / "kept").read_text() == "mine"


def test_a_file_is_there_as_it_was_if_writing_it_fails(tmp_path: Path, monkeypatch) -> None:
    def fail(*_: object) -> None:
        raise OSError("no space left")

    write_whole(tmp_path / "progress.json", "as it was")
    monkeypatch.setattr("os.replace", fail)
    with pytest.raises(OSError, match="no space"):
        write_whole(tmp_path / "progress.json", "as it will be")
    assert (tmp_path / "progress.json").read_text() == "as it was"
    assert [found.name for found in tmp_path.iterdir()] == ["progress.json"]
