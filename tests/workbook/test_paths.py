"""Pages that are named, where the workbook lies, and what the first page says of the machine."""

from __future__ import annotations

from pathlib import Path

import pytest

from tflab.workbook import paths
from tflab.workbook.copy import environment
from tflab.workbook.paths import Workbook, chapters, stems_called, workbook_data, write_workbook

from .conftest import HandedOut


def test_installed_from_a_wheel_the_workbook_is_inside_the_package(monkeypatch, tmp_path: Path) -> None:

    inside = tmp_path / "tflab" / "_workbook"
    inside.mkdir(parents=True)
    monkeypatch.delenv("TFLAB_WORKBOOK", raising=False)
    assert (workbook_data() / "pyproject.toml").is_file()  # of an editable install: the repository
    monkeypatch.setattr(paths, "__file__", str(tmp_path / "tflab" / "workbook" / "paths.py"))
    assert workbook_data() == inside


def test_a_page_is_named_by_its_stem_or_its_number_and_stands_once(handed_out: HandedOut) -> None:
    assert chapters() == ["03_small"]  # those with tasks
    there = ["03_target", "08_buffer"]
    assert stems_called(["8", "03_target", "03", "E3", "E03_target"], there) == ["08_buffer", "03_target"]
    assert stems_called([], there) == []
    with pytest.raises(LookupError, match='unknown exercise "4"; available: 03, 08'):
        stems_called(["4"], there, what="exercise")
    with pytest.raises(LookupError, match='unknown page ""; available: none'):
        stems_called([""], [])


def test_what_is_missing_is_named_with_what_to_type(tmp_path: Path, monkeypatch, capsys) -> None:
    environment.check_environment()
    assert "✗" not in capsys.readouterr().out
    monkeypatch.setattr(environment, "LEAST_PYTHON", (99, 0))
    needed = environment.Requirement(environment.NEEDED[1].what, "tflab[lab]", ("no_such_package",))
    monkeypatch.setattr(environment, "NEEDED", (environment.NEEDED[0], needed))
    environment.check_environment()
    said = capsys.readouterr().out
    assert "install a later one" in said
    assert 'missing: no_such_package. Type: pip install "tflab[lab]"' in said
    write_workbook(tmp_path, Workbook(language="ko"))
    monkeypatch.chdir(tmp_path)
    environment.check_environment()
    said = capsys.readouterr().out
    assert "더 새로운 파이썬을 설치하고" in said
    assert "위젯과 3D" in said and '없음: no_such_package. 이렇게 설치하십시오: pip install "tflab[lab]"' in said
    assert "missing" not in said
