"""Installed from a wheel, in an empty folder, a learner gets the same workbook as from the repository."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import zipfile
from email import message_from_string
from pathlib import Path

import pytest

from tflab.workbook.copy.lab import SETTINGS
from tflab.workbook.copy.lay_out import lay_out
from tflab.workbook.paths import chapters, workbook_data

KOREAN = {"LANG": "ko_KR.UTF-8", "LC_ALL": ""}


@pytest.fixture(scope="module")
def installed(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with what the wheel installs."""
    pytest.importorskip("hatchling", reason="no hatchling: pip install 'tflab[dev]'")
    folder = tmp_path_factory.mktemp("wheel")
    build = ["-m", "hatchling", "build", "--target", "wheel", "--directory", str(folder)]
    subprocess.run([sys.executable, *build], cwd=workbook_data(), check=True, capture_output=True)
    (wheel,) = folder.glob("*.whl")
    zipfile.ZipFile(wheel).extractall(folder / "installed")
    return folder / "installed"


def run(installed: Path, folder: Path, *words: str) -> str:
    """Run `tflab` as installed, in an empty folder; JupyterLab itself is not started."""
    program = (
        "import sys, tflab; from tflab.workbook.copy import lab; from tflab.cli import main;"
        "lab.start_jupyterlab = lambda options: print('opens', *options);"
        "assert tflab.__file__.startswith(sys.argv[1]); sys.exit(main(sys.argv[2:]))"
    )
    answer = subprocess.run(
        [sys.executable, "-c", program, str(installed), *words],
        cwd=folder, env=os.environ | {"PYTHONDONTWRITEBYTECODE": "1", "PYTHONPATH": str(installed), **KOREAN},
        capture_output=True, text=True, check=True,
    )  # fmt: skip
    return answer.stdout


def contents(folder: Path) -> dict[str, bytes]:
    return {p.relative_to(folder).as_posix(): p.read_bytes() for p in sorted(folder.rglob("*")) if p.is_file()}


def test_a_copy_from_the_wheel_is_the_copy_from_the_repository(installed: Path, tmp_path: Path) -> None:
    (tmp_path / "empty").mkdir()
    said = run(installed, tmp_path / "empty", "lab", "--", "--no-browser")
    assert "/lab/tree/notebooks/ko/00_start.ipynb" in said
    from_the_wheel = contents(tmp_path / "empty" / "tflab_workbook")
    assert from_the_wheel == contents(lay_out(tmp_path / "from_the_repository", "ko"))
    assert {f"exercises/ko/E{stem}.ipynb" for stem in chapters()} <= set(from_the_wheel)
    assert "다음 과제: E1.1" in run(installed, tmp_path / "empty", "progress")


def test_the_wheel_has_the_solutions_that_a_pass_opens_and_no_page_sources(installed: Path) -> None:
    inside = installed / "tflab" / "_workbook"
    for stem in chapters():
        assert (inside / "solutions" / "en" / f"{stem}.ipynb").is_file()  # its code serves every language
        tasks = sorted((inside / "solutions" / "tasks" / stem).glob("e*_*.py"))
        assert len(tasks) >= (1 if stem == "00_start" else 5)
        assert all(path.with_suffix(".yaml").is_file() for path in tasks)
    assert not any((inside / folder / "src").exists() for folder in ("notebooks", "solutions"))
    assert not list(installed.rglob("__pycache__"))


def test_the_wheel_has_the_kernel_that_pages_run_in_and_all_that_jupyterlab_is_told(installed: Path) -> None:
    ours = installed / "tflab" / "workbook" / "copy" / "jupyter"
    assert contents(ours) == contents(SETTINGS)
    assert json.loads(contents(ours)["kernels/python3/kernel.json"])["argv"][0] == "python"  # of whoever starts it
    (data,) = installed.glob("tflab-*.data/data/share/jupyter/labextensions/tflab")  # where a JupyterLab looks
    assert contents(data) == contents(SETTINGS / "labextensions" / "tflab")
    assert {"package.json", "static/remoteEntry.js", "static/tflab.css"} <= set(contents(data))
    (metadata,) = installed.glob("tflab-*.dist-info/METADATA")
    assert message_from_string(metadata.read_text(encoding="utf-8"))["Author"] == "the authors of tflab"


def test_an_editable_install_is_the_repository(tmp_path: Path) -> None:
    pytest.importorskip("hatchling", reason="no hatchling: pip install 'tflab[dev]'")
    program = "import sys; from hatchling.build import build_editable; print(build_editable(sys.argv[1]))"
    subprocess.run([sys.executable, "-c", program, str(tmp_path)], cwd=workbook_data(), check=True, capture_output=True)
    (wheel,) = tmp_path.glob("*.whl")
    with zipfile.ZipFile(wheel) as found:
        (path,) = [name for name in found.namelist() if name.endswith(".pth")]
        assert found.read(path).decode().strip() == str(workbook_data())
