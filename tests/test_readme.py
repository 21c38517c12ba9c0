"""What a newcomer meets first is true: the README's commands, chapters and links, and what containers run."""

from __future__ import annotations

import html
import importlib.util
import json
import os
import re
import shlex
import subprocess
import sys
from importlib.metadata import entry_points
from pathlib import Path
from types import ModuleType

import pytest
import yaml
from PIL import Image

from tflab.cli import SUBCOMMANDS
from tflab.workbook.checks import check
from tflab.workbook.course import contents
from tflab.workbook.course.course import read_course
from tflab.workbook.paths import Workbook, write_workbook

ROOT = Path(__file__).parents[1]
READMES = {"en": "README.md", "ko": "README.ko.md"}
PYPROJECT = (ROOT / "pyproject.toml").read_text(encoding="utf-8")
HERE = [sys.executable, "-m", "tflab"]
needs_make = pytest.mark.skipif(not any((Path(p) / "make").exists() for p in os.defpath.split(":")), reason="no make")


def readme(language: str) -> str:
    return (ROOT / READMES[language]).read_text(encoding="utf-8")


def typed_commands() -> set[str]:
    files = [*READMES.values(), ".devcontainer/devcontainer.json", ".binder/postBuild", "Dockerfile", "Makefile"]
    text = "\n".join((ROOT / name).read_text(encoding="utf-8") for name in files)
    return set(re.findall(r'(?:^|[`/ \n])tflab ([a-z][a-z0-9]*)(?=[ `"\n;,)])', text)) - {"needs", "shows"}


def test_every_command_that_is_named_is_there() -> None:
    assert {"lab", "build", "check", "doctor", "grade"} <= typed_commands() <= set(SUBCOMMANDS)


@pytest.mark.parametrize("language", sorted(READMES))
def test_the_table_of_chapters_is_the_course(language: str) -> None:
    assert readme(language) == contents.readme(language, ROOT), "run: python -m tflab.workbook.course.contents"
    rows = re.findall(r"^\| (\d\d) \|", readme(language), re.MULTILINE)
    assert rows == [f"{chapter.number:02}" for chapter in read_course().chapters]


@pytest.mark.parametrize("language", sorted(READMES))
def test_no_link_of_the_readme_is_dead_here_or_on_a_package_index(language: str) -> None:
    links = re.findall(r"(?<!!)\[[^\]]*\]\(([^)]+)\)", readme(language))
    assert [link for link in links if not (ROOT / link).is_file()] == []
    assert len(links) >= 17  # thirteen chapters, and four files
    assert "](" not in of_the_build().indexed(readme(language), "")
    for picture in re.findall(r"!\[[^\]]+\]\(([^)]+)\)", readme(language)):
        assert (ROOT / picture).is_file()
        assert (ROOT / picture).stat().st_size < 1_500_000


def of_the_build() -> ModuleType:
    pytest.importorskip("hatchling", reason="no hatchling: pip install 'tflab[dev]'")
    spec = importlib.util.spec_from_file_location("hatch_build", ROOT / "hatch_build.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_an_index_shows_no_picture_that_it_has_not() -> None:
    shown = of_the_build().indexed(readme("en"), "")
    assert "](" not in shown
    assert "docs/pictures" not in shown and "smear" not in shown
    assert shown.startswith("# tflab\n\n**Learn ROS 2 TF2 in Jupyter")
    assert "and fix them.\n\n한국어" in shown
    plain = re.sub(r"\[([^\]]*)\]\([^)]+\)", r"\1", readme("en"))
    assert shown.partition("## Try it")[2] == plain.partition("## Try it")[2]
    assert of_the_build().urls("") == {}


def test_a_release_that_says_where_it_lives_has_links_that_lead_there() -> None:
    build, address = of_the_build(), "https://git.example/someone/tflab"
    shown = build.indexed(readme("en"), address, "v1")
    links = re.findall(r"\]\(([^)]+)\)", shown)
    assert {link.partition("/v1/")[0] for link in links} == {f"{address}/raw", f"{address}/blob"}
    files = [link.partition("/v1/")[2] for link in links]
    assert {"docs/pictures/drive.webp", "README.ko.md", "docs/grading.md", "CONTRIBUTING.md"} <= set(files)
    assert [name for name in files if not (ROOT / name).is_file()] == []
    assert f"\ngit clone {address} tflab\ncd tflab" in shown
    pointing_here = shown.replace(f"{address}/raw/v1/", "").replace(f"{address}/blob/v1/", "")
    without_clone = re.compile("git clone .*")
    assert without_clone.sub("", pointing_here) == without_clone.sub("", readme("en"))
    assert build.urls(address, "v1", "https://someone.example/tflab/") == {
        "Documentation": "https://someone.example/tflab/",
        "Source": address,
        "Issues": f"{address}/issues",
        "Changelog": f"{address}/blob/v1/CHANGELOG.md",
    }


def test_the_release_says_where_it_lives_by_the_names_that_the_build_reads() -> None:
    workflow = yaml.safe_load((ROOT / ".github" / "workflows" / "release.yml").read_text(encoding="utf-8"))
    read = set(re.findall(r'environ\.get\("(TFLAB_\w+)"', (ROOT / "hatch_build.py").read_text(encoding="utf-8")))
    assert set(workflow["env"]) == read - {"TFLAB_COMPILED"}
    into_containers = workflow["jobs"]["compiled"]["env"]["CIBW_ENVIRONMENT_PASS_LINUX"].split()
    assert set(into_containers) == read


def test_the_files_that_the_readme_names_are_there() -> None:
    text = readme("en") + (ROOT / "docs" / "install.md").read_text(encoding="utf-8").replace(
        "install.ko", "docs/install.ko"
    )
    named = set(re.findall(r"(?<![\w/])((?:docs/|\.\w+/?)?[\w.]+\.(?:md|py)|\.\w+/)(?![\w/])", text))
    assert {"CONTRIBUTING.md", "docs/grading.md", "docs/install.md", "README.ko.md", ".binder/"} <= named
    missing = [name for name in named if name.endswith((".md", "/")) and not (ROOT / name).exists()]
    assert set(missing) <= {".venv/"}


def test_what_keeps_nbval_out_of_every_pytest_is_called_as_it_is_there() -> None:
    plugins = {one.name for one in entry_points(group="pytest11")}
    for name in ("install.md", "install.ko.md", "grading.md", "grading.ko.md"):
        (plugin,) = re.findall(r"`pytest -p no:(\w+)`", (ROOT / "docs" / name).read_text(encoding="utf-8"))
        assert plugin == "nbval" and plugin in plugins


def test_the_files_of_containers_can_be_read() -> None:
    settings = json.loads((ROOT / ".devcontainer" / "devcontainer.json").read_text(encoding="utf-8"))
    assert "tflab lab ./tflab_workbook --copy-only" in settings["postCreateCommand"]
    assert os.access(ROOT / ".binder" / "postBuild", os.X_OK)
    there = set(re.findall(r"^(\w+) = \[", PYPROJECT.partition("[project.optional-dependencies]")[2], re.MULTILINE))
    for name in (".devcontainer/devcontainer.json", ".binder/requirements.txt", "Dockerfile"):
        (extra,) = re.findall(r"(?:\.|/opt/tflab)\[(\w+)\]", (ROOT / name).read_text(encoding="utf-8"))
        assert extra in there
    for path in (ROOT / ".github" / "workflows").glob("*.yml"):
        for job in yaml.safe_load(path.read_text(encoding="utf-8"))["jobs"].values():
            for step in job["steps"]:
                command = step.get("run", "").split(" ")
                if command[0].startswith(".ci/"):
                    assert os.access(ROOT / command[0], os.X_OK)
                if command[0] == "make":
                    assert re.search(rf"^{command[1]}:", (ROOT / "Makefile").read_text(encoding="utf-8"), re.MULTILINE)


def test_what_containers_run_lays_out_a_copy_in_a_clean_environment(tmp_path: Path) -> None:
    settings = json.loads((ROOT / ".devcontainer" / "devcontainer.json").read_text(encoding="utf-8"))
    commands = [
        settings["postCreateCommand"].partition(" && ")[2],
        (ROOT / ".binder" / "postBuild").read_text(encoding="utf-8").strip().splitlines()[-1],
        re.search(r"^RUN (tflab .+)$", (ROOT / "Dockerfile").read_text(encoding="utf-8"), re.MULTILINE)[1],
    ]
    for number, command in enumerate(commands):
        program, *words = shlex.split(command)
        assert program == "tflab"
        folder = tmp_path / str(number)
        folder.mkdir()
        clean = {"HOME": str(folder), "PATH": os.defpath, "LANG": "C.UTF-8"}
        done = subprocess.run([*HERE, *words], cwd=folder, env=clean, capture_output=True, text=True, check=True)
        page = folder / "tflab_workbook" / "notebooks" / "en" / "00_start.ipynb"
        assert done.stdout.splitlines()[-1] == str(page)
        assert page.is_file()


def fake_python(folder: Path, name: str, answers: str) -> Path:
    path = folder / name
    path.write_text(f"#!/bin/sh\n{answers}\n", encoding="utf-8")
    path.chmod(0o755)
    return path


def make(*words: str, folder: Path) -> subprocess.CompletedProcess[str]:
    (folder / "Makefile").write_text((ROOT / "Makefile").read_text(encoding="utf-8"), encoding="utf-8")
    for name in ("pyproject.toml", "constraints.txt"):
        (folder / name).touch()
    outer = ("MAKELEVEL", "MAKEFLAGS", "MFLAGS")  # of the make that runs the tests: an inner one says where it is
    alone = {name: value for name, value in os.environ.items() if name not in outer}
    return subprocess.run(["make", *words], cwd=folder, capture_output=True, text=True, env=alone)


@needs_make
def test_an_old_python_is_named_before_anything_is_installed(tmp_path: Path) -> None:
    old = fake_python(tmp_path, "python3.8", 'case "$1" in -V) echo Python 3.8.10;; *) exit 1;; esac')
    done = make("lab", f"PYTHON={old}", folder=tmp_path)
    assert done.returncode != 0
    assert "tflab needs Python 3.10 or newer" in done.stdout
    assert "Python 3.8.10" in done.stdout
    assert "make lab PYTHON=python3.12" in done.stdout
    assert not (tmp_path / ".venv").exists()


@needs_make
@pytest.mark.parametrize(
    ("status", "last"), [(0, "  installed; what pip said is in"), (1, "Not installed. What pip said is in")]
)
def test_installing_says_a_few_lines_and_keeps_the_others(tmp_path: Path, status: int, last: str) -> None:
    collecting = 'for i in $(seq 60); do echo "Collecting p$i"; echo "  Downloading p$i"; done'
    pip = f'{collecting}; echo "ERROR: p61"; exit {status}'
    (tmp_path / ".venv" / "bin").mkdir(parents=True)
    words = f'case "$*" in\n  *print*) echo 3.12;;\n  *"pip install"*) {pip};;\nesac'
    python = fake_python(tmp_path / ".venv" / "bin", "python", words)
    done = make(".venv/learner-3.12", f"PYTHON={python}", folder=tmp_path)
    assert bool(done.returncode) == bool(status)
    said = done.stdout.splitlines()
    assert said[1:4] == ["  25 packages found", "  50 packages found", "ERROR: p61"]
    assert said[4].startswith(last) and len(said) == 5
    assert len((tmp_path / ".venv" / "install.log").read_text(encoding="utf-8").splitlines()) == 122


@needs_make
def test_an_environment_of_another_python_is_made_anew_and_options_reach_the_lab(tmp_path: Path) -> None:
    (tmp_path / ".venv" / "bin").mkdir(parents=True)
    fake_python(tmp_path / ".venv" / "bin", "python", "echo 3.9")
    (tmp_path / ".venv" / "left_over").touch()
    new = fake_python(
        tmp_path,
        "python3.12",
        'case "$*" in\n  *print*) echo 3.12;;\n  "-m venv .venv") mkdir -p .venv/bin; cp "$0" .venv/bin/python;\n'
        "    printf '#!/bin/sh\\necho opened \"$@\"\\n' > .venv/bin/tflab; chmod +x .venv/bin/tflab;;\nesac",
    )
    done = make("lab", f"PYTHON={new}", "ARGS=--no-browser --lang ko", folder=tmp_path)
    assert done.returncode == 0, done.stdout + done.stderr
    assert "made by another Python: making it anew, with 3.12" in done.stdout
    assert "opened lab --no-browser --lang ko" in done.stdout
    assert not (tmp_path / ".venv" / "left_over").exists()
    assert "made by another" not in make("lab", f"PYTHON={new}", folder=tmp_path).stdout


def backwards(a_pose_b: dict[str, float]) -> dict[str, float]:
    """Turn every sign, as the README's sample and its picture do."""
    return {"x": -a_pose_b["x"], "y": -a_pose_b["y"], "yaw": -a_pose_b["yaw"]}


@pytest.mark.parametrize("language", READMES)
def test_the_sample_and_the_picture_show_what_check_says_today(
    language: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    write_workbook(tmp_path, Workbook(language=language))
    monkeypatch.chdir(tmp_path)
    check("E3.3", backwards)
    said = capsys.readouterr().out.split()
    sample = re.search(r"^E3\.3 ✗ .*?(?=^```)", readme(language), re.DOTALL | re.MULTILINE)[0].split()
    assert sample == said[: len(sample)]
    (name,) = re.findall(r"!\[[^\]]+\]\(([^)]+)\)", readme(language))
    about = Image.open(ROOT / name).info["xmp"].decode()
    assert f'dc:language="{language}"' in about
    shown = html.unescape(re.search(r"<dc:description>(.*)</dc:description>", about, re.DOTALL)[1])
    assert shown.split() == said, "run: make pictures"


def test_the_korean_pages_name_the_same_commands_and_figures() -> None:
    named = (r"tflab\.\w+`", r"\*\*(?:VS Code|Windows)", r"TFLAB_\w+=\w+", r"`tflab [a-z]+", r"\| *\d+ \| \d+ \|$")
    for name in ("README{}.md", "docs/install{}.md", "docs/nodes{}.md", "docs/grading{}.md"):
        both = [(ROOT / name.format(language)).read_text(encoding="utf-8") for language in ("", ".ko")]
        patterns = (*named, r"(?<!\.ko)\.md") if name.startswith("README") else named
        if "grading" in name:
            patterns = (r"tflab [a-z]+", r"--[a-z][a-z-]+", r"[\w/]+\.(?:csv|json|html|zip)")
        for pattern in patterns:
            en, ko = (set(re.findall(pattern, text.replace("--lang ko", ""), re.MULTILINE)) for text in both)
            assert ko and ko <= en if "grading" in name else en == ko, pattern
