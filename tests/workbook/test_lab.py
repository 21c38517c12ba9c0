"""`tflab lab` opens JupyterLab on the right folder, and JupyterLab asks the network for nothing."""

from __future__ import annotations

import ctypes
import json
import os
import subprocess
import sys
from pathlib import Path
from types import SimpleNamespace

import pytest

from tflab import text
from tflab.workbook.copy import lab
from tflab.workbook.copy.lay_out import lay_out
from tflab.workbook.paths import read_workbook


@pytest.fixture
def started(monkeypatch: pytest.MonkeyPatch, tmp_path: Path, handed_out) -> list:
    """What would have been started, in a folder that holds nothing, with an English locale."""
    calls = []
    here = tmp_path / "here"
    here.mkdir()
    monkeypatch.chdir(here)  # and back afterwards
    for name in ("LC_ALL", "LC_MESSAGES"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setenv("LANG", "en_US.UTF-8")
    monkeypatch.setattr(lab, "start_jupyterlab", lambda options: calls.append((options, Path.cwd())))
    return calls


def files(folder: Path) -> set[str]:
    return {p.relative_to(folder).as_posix() for p in folder.rglob("*") if p.is_file() and ".tflab" not in p.parts}


def test_without_a_folder_it_makes_a_copy_and_opens_its_first_page(
    started: list, tmp_path: Path, monkeypatch, capsys
) -> None:
    monkeypatch.setenv("SHELL", "/bin/bash")
    assert lab.lab(["--port", "9000", "--no-browser"]) == 0
    options, folder = started[0]
    assert folder == tmp_path / "here" / lab.COPY
    assert "--LabApp.default_url=/lab/tree/notebooks/en/00_start.ipynb" in options
    assert f"--ServerApp.root_dir={folder}" in options
    assert "--ServerApp.terminado_settings={'shell_command': ['/bin/bash']}" in options  # it keeps the path
    assert options[-2:] == ["--no-browser", "--ServerApp.port=9000"]
    assert files(folder) == {"workbook.json", "notebooks/en/00_start.ipynb", "exercises/en/E03_small.ipynb"}
    assert str(folder) in capsys.readouterr().out


def test_the_second_time_it_opens_the_same_copy_and_lays_out_only_what_was_deleted(started: list, capsys) -> None:
    lab.lab([])
    copy = started[0][1]
    page = copy / "notebooks/en/00_start.ipynb"
    page.write_text("mine")
    (copy / "exercises/en/E03_small.ipynb").unlink()
    assert "laid out again" not in capsys.readouterr().out
    for folder in (copy.parent, copy / "exercises" / "en"):
        lab.os.chdir(folder)
        assert lab.lab([]) == 0
    assert [opened for _, opened in started] == [copy] * 3
    assert page.read_text() == "mine"
    assert "  exercises/en/E03_small.ipynb: was missing, laid out again\n" in capsys.readouterr().out


def test_a_new_copy_has_the_language_of_the_locale_or_of_windows(monkeypatch) -> None:
    for environment, language in (
        ({}, "en"),
        ({"LC_ALL": "en_GB.UTF-8", "LANG": "ko_KR.UTF-8"}, "en"),
        ({"LC_ALL": "", "LC_MESSAGES": "ko_KR", "LANG": "en_GB"}, "ko"),
    ):
        assert text.language_of_locale(environment) == language
    monkeypatch.setattr(text, "os", SimpleNamespace(name="nt"))
    for of_windows, language in ((0x412, "ko"), (0x409, "en"), (0x812, "ko")):
        windows = SimpleNamespace(kernel32=SimpleNamespace(GetUserDefaultUILanguage=lambda said=of_windows: said))
        monkeypatch.setattr(ctypes, "windll", windows, raising=False)
        assert text.language_of_locale({}) == language
        assert text.language_of_locale({"LANG": "en_US.UTF-8"}) == "en"


def test_a_second_language_is_added_and_switched_to_and_stays(started: list, capsys) -> None:
    lab.lab(["mine"])
    copy = started[0][1]
    lab.os.chdir(copy.parent)
    assert lab.lab(["mine", "--lang", "ko"]) == 0
    assert "--LabApp.default_url=/lab/tree/notebooks/ko/00_start.ipynb" in started[1][0]
    assert {"notebooks/en/00_start.ipynb", "notebooks/ko/00_start.ipynb"} <= files(copy)
    assert read_workbook(copy).language == "ko"
    lab.os.chdir(copy.parent)
    lab.lab(["mine"])
    assert "--LabApp.default_url=/lab/tree/notebooks/ko/00_start.ipynb" in started[2][0]
    assert "내 워크북을 엽니다" in capsys.readouterr().out


def test_a_class_copy_in_another_language_keeps_the_exercises_that_were_handed_out(started: list, capsys) -> None:
    lay_out(Path("mine"), "en", edition="class", handed_out={"exercises/en/E03_small.ipynb": b"{}"})
    assert lab.lab(["mine", "--lang", "ko"]) == 0
    assert "나눠 준 언어 그대로" in capsys.readouterr().out
    exercises = {name for name in files(started[0][1]) if name.startswith("exercises/")}
    assert exercises == {"exercises/en/E03_small.ipynb"}


def test_a_folder_of_something_else_is_left_as_it_is_and_opened_only_as_is(
    started: list, tmp_path: Path, capsys
) -> None:
    other = tmp_path / "thesis"
    other.mkdir()
    (other / "chapter.ipynb").write_text("{}")
    assert lab.lab([str(other)]) == 2
    said = capsys.readouterr().err
    assert "nothing was written there" in said and "--as-is" in said
    assert started == []
    assert lab.lab([str(other), "--as-is", "--", "--no-browser"]) == 0
    ((options, folder),) = started
    assert folder == other
    assert options[-1] == "--no-browser"
    assert not any("default_url" in word for word in options)
    assert files(other) == {"chapter.ipynb"}


def test_what_cannot_be_opened_is_said_and_nothing_is_started_or_changed(started: list, capsys) -> None:
    with pytest.raises(SystemExit):
        lab.lab(["--ip", "0.0.0.0"])
    assert "unrecognized arguments: --ip; an option of JupyterLab stands after --" in capsys.readouterr().err
    for words in (["/no/such/folder"], ["/no/such/folder", "--as-is"]):
        assert lab.lab(words) == 2
        assert "there is no folder /no/such" in capsys.readouterr().err
    assert started == []
    lab.lab(["mine", "--copy-only"])
    mark = Path("mine", "workbook.json").resolve()
    mark.write_text('{"tflab": "0.1')
    assert lab.lab(["mine", "--update"]) == 2
    assert "workbook.json cannot be read" in capsys.readouterr().err
    assert mark.read_text() == '{"tflab": "0.1'
    assert started == []


def test_a_copy_of_another_version_opens_as_it_is_and_update_is_offered(started: list, handed_out, capsys) -> None:
    lab.lab(["mine"])
    copy = started[0][1]
    mark = json.loads((copy / "workbook.json").read_text())
    (copy / "workbook.json").write_text(json.dumps({**mark, "tflab": "0.0.1"}))
    handed_out.write("notebooks/en/00_start.ipynb", hello="print('new')")
    handed_out.write("notebooks/en/04_more.ipynb", hello="print('more')")
    lab.os.chdir(copy.parent)
    capsys.readouterr()
    assert lab.lab(["mine"]) == 0
    assert "--update" in capsys.readouterr().out
    assert "new" not in (copy / "notebooks/en/00_start.ipynb").read_text()

    lab.os.chdir(copy.parent)
    assert lab.lab(["mine", "--update"]) == 0
    said = capsys.readouterr().out
    assert "notebooks/en/00_start.ipynb: replaced by the new version" in said
    assert "notebooks/en/04_more.ipynb: new\n" in said
    assert "new" in (copy / "notebooks/en/00_start.ipynb").read_text()
    assert read_workbook(copy).tflab == lab.__version__

    lab.os.chdir(copy.parent)
    lab.lab(["mine", "--update"])
    assert "Nothing to bring in" in capsys.readouterr().out


@pytest.mark.parametrize(("tflab", "typed"), [("/usr/bin/tflab", "tflab"), (None, "'my venv/bin/tflab'")])
def test_root_is_told_what_to_type(started: list, monkeypatch, capsys, tflab: str | None, typed: str) -> None:
    def refuses(options: list) -> None:
        raise SystemExit(1)

    monkeypatch.setattr(lab, "start_jupyterlab", refuses)
    monkeypatch.setattr(lab, "which", lambda name: tflab)
    monkeypatch.setattr(sys, "argv", ["my venv/bin/tflab"])
    monkeypatch.setattr(lab, "_is_root", lambda: True)
    assert lab.lab([]) == 2
    assert capsys.readouterr().err.endswith(f"without the option --allow-root: {typed} lab -- --allow-root\n")
    assert lab.lab(["--no-browser", "a copy", "--", "--port", "9000"]) == 2
    as_typed = f"{typed} lab --no-browser 'a copy' -- --port 9000 --allow-root\n"
    assert capsys.readouterr().err.endswith(as_typed)
    monkeypatch.setattr(lab, "_is_root", lambda: False)
    with pytest.raises(SystemExit):
        lab.lab([])
    assert capsys.readouterr().err == ""


def test_its_terminals_find_tflab(monkeypatch) -> None:
    from jupyterlab import labapp

    monkeypatch.setattr(labapp, "main", lambda options: None)
    for name in ("PATH", "JUPYTER_CONFIG_PATH"):  # put back afterwards
        monkeypatch.setenv(name, "elsewhere")
    lab.start_jupyterlab([])
    assert lab.os.environ["PATH"].split(lab.os.pathsep) == [str(Path(sys.executable).parent), "elsewhere"]


def test_jupyterlab_understands_the_options_that_keep_it_quiet() -> None:
    probe = (
        "import json, sys; from jupyterlab.labapp import LabApp; from jupyter_lsp import LanguageServerManager;"
        "app = LabApp(); app.parse_command_line(sys.argv[1:]); app.update_config(app.cli_config);"
        "servers = LanguageServerManager(parent=app).autodetect;"  # whether npm is asked for them
        "print(json.dumps([app.news_url, app.check_for_updates_class.__name__, app.extension_manager, servers]))"
    )
    answer = subprocess.run([sys.executable, "-c", probe, *lab.OUR_OPTIONS], capture_output=True, text=True, check=True)
    assert json.loads(answer.stdout) == [None, "NeverCheckForUpdate", "readonly", False]


def test_a_users_own_folder_to_begin_with_is_no_hindrance(tmp_path: Path) -> None:
    own, copy = tmp_path / "own", tmp_path / "copy"
    for folder in (own, copy):
        folder.mkdir()
    settings = {key: {"preferred_dir": str(own)} for key in ("ServerApp", "FileContentsManager")}
    (own / "jupyter_server_config.json").write_text(json.dumps(settings))
    probe = (
        "import sys; from jupyterlab.labapp import LabApp;"
        "app = LabApp.initialize_server(argv=sys.argv[1:]);"
        "print(app.contents_manager.preferred_dir, app.contents_manager.root_dir)"
    )
    options = [*lab.OUR_OPTIONS, f"--ServerApp.root_dir={copy}", "--no-browser", "--allow-root", "--port=0"]
    environment = os.environ | {"JUPYTER_CONFIG_DIR": str(own)}
    answer = subprocess.run([sys.executable, "-c", probe, *options], capture_output=True, text=True, env=environment)
    assert answer.returncode == 0, answer.stderr
    assert answer.stdout.split() == [str(copy)]
    assert "Unrecognized" not in answer.stderr


def test_a_copy_is_made_without_starting_anything(started: list, capsys) -> None:
    assert lab.lab(["mine", "--copy-only"]) == 0
    assert started == []
    page = Path("mine", "notebooks", "en", "00_start.ipynb").resolve()
    assert capsys.readouterr().out.splitlines()[-1] == str(page)
    assert page.is_file()
