"""Files are written whole, also where a file system has no locks and no rights."""

from __future__ import annotations

import errno
from pathlib import Path

import pytest

from tflab.workbook import atomic_files
from tflab.workbook.atomic_files import locked, write_whole

fcntl = pytest.importorskip("fcntl", reason="Windows locks in another way")


@pytest.mark.parametrize("number", [errno.ENOLCK, errno.ENOSYS, errno.EOPNOTSUPP])
def test_a_share_without_locks_is_used_without(number: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def refuses(handle: int, operation: int) -> None:
        raise OSError(number, "no locks here")

    monkeypatch.setattr(atomic_files.fcntl, "flock", refuses)
    with locked(tmp_path):
        write_whole(tmp_path / "kept", "mine")
    assert (tmp_path / "kept").read_text() == "mine"


def test_a_lock_that_fails_for_another_reason_is_said(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def fails(handle: int, operation: int) -> None:
        raise OSError(errno.EIO, "the disk is broken")

    monkeypatch.setattr(atomic_files.fcntl, "flock", fails)
    with pytest.raises(OSError, match="the disk is broken"), locked(tmp_path):
        pass


def test_a_share_without_rights_is_written_to_all_the_same(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def refuses(*of_a_file: object) -> None:
        raise PermissionError(errno.EPERM, "Operation not permitted")

    monkeypatch.setattr(atomic_files.os, "chmod", refuses)
    write_whole(tmp_path / "kept", "mine")
    assert (tmp_path / "kept").read_text() == "mine"
