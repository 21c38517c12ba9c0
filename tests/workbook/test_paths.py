"""Files that are written whole, pages that are named, and what the first page says of the machine."""

from __future__ import annotations

from pathlib import Path

import pytest

from tflab.workbook.atomic_files import write_whole
from tflab.workbook.copy import environment
from tflab.workbook.paths import Workbook, chapters, stems_called, workbook_data, write_workbook

from .conftest import HandedOut


def test_a_file_is_there_as_it_was_if_writing_it_fails(tmp_path: Path, monkeypatch) -> None:
    path = tmp_path / "progress.json"
    write_whole(path, "as it was")

    def fail(*_: object) -> None:
        raise OSError("no space left")

    monkeypatch.setattr("os.replace", fail)
    with pytest.raises(OSError, match="no space"):
        write_whole(path, "as it will be")
    assert path.read_text() == "as it was"
    assert [found.name for found in tmp_path.iterdir()] == ["progress.json"]


def test_the_workbook_of_an_editable_install_is_the_repository(monkeypatch) -> None:
    monkeypatch.delenv("TFLAB_WORKBOOK", raising=False)
    assert (workbook_data() / "pyproject.toml").is_file()


def test_installed_from_a_wheel_the_workbook_is_inside_the_package(monkeypatch, tmp_path: Path) -> None:
    from tflab.workbook import paths

    inside = tmp_path / "tflab" / "_workbook"
    inside.mkdir(parents=True)
    monkeypatch.delenv("TFLAB_WORKBOOK", raising=False)
    monkeypatch.setattr(paths, "__file__", str(tmp_path / "tflab" / "workbook" / "paths.py"))
    assert workbook_data() == inside


def test_chapters_are_those_with_tasks(handed_out: HandedOut) -> None:
    assert chapters() == ["03_small"]


def test_a_page_is_named_by_its_stem_or_its_number_and_stands_once() -> None:
    there = ["03_target", "08_buffer"]
    assert stems_called(["8", "03_target", "03", "E3", "E03_target"], there) == ["08_buffer", "03_target"]
    assert stems_called([], there) == []
    with pytest.raises(LookupError, match='there is no exercise "4"; there is 03_target, 08_buffer'):
        stems_called(["4"], there, what="exercise")
    with pytest.raises(LookupError, match='there is no page ""; there is none'):
        stems_called([""], [])


def test_what_is_missing_is_named_with_what_to_type(tmp_path: Path, monkeypatch, capsys) -> None:
    environment.check_environment()
    assert "✗" not in capsys.readouterr().out
    monkeypatch.setattr(environment, "LEAST_PYTHON", (99, 0))
    needed = environment.Need(environment.NEEDED[1].what, "tflab[lab]", ("no_such_package",))
    monkeypatch.setattr(environment, "NEEDED", (environment.NEEDED[0], needed))
    environment.check_environment()
    said = capsys.readouterr().out
    assert "install a later one" in said
    assert 'missing: no_such_package. Type: pip install "tflab[lab]"' in said
    write_workbook(tmp_path, Workbook(language="ko"))
    monkeypatch.chdir(tmp_path)
    environment.check_environment()
    said = capsys.readouterr().out
    assert "새 Python을 설치하고" in said
    assert "위젯과 3D" in said and '없음: no_such_package. 이렇게 설치하십시오: pip install "tflab[lab]"' in said
    assert "missing" not in said
