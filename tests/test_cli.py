"""The command `tflab` starts at once, and says in one line what the machine lacks."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from tflab import cli


@pytest.fixture
def raises(monkeypatch: pytest.MonkeyPatch) -> Callable[[Exception], None]:
    """Return what makes every subcommand raise an exception."""

    def of(error: Exception) -> None:
        def function(rest: list[str]) -> int:
            raise error

        monkeypatch.setattr(cli, "_function", lambda subcommand: function)

    return of


def test_python_m_tflab_is_the_command() -> None:
    done = subprocess.run([sys.executable, "-m", "tflab", "--version"], capture_output=True, text=True, check=True)
    assert done.stdout.startswith("tflab ")


def test_a_part_that_is_not_installed_is_named_with_what_brings_it(raises, capsys) -> None:
    for library, words, extra in (
        ("jupyterlab", ["lab", "mine"], "lab"),
        ("matplotlib", ["export", "page.ipynb"], "views"),
        ("rosbags", ["doctor", "drive.mcap"], "bags"),
        ("nbval", ["check", "--plain", "03"], "grade"),
    ):
        raises(ModuleNotFoundError(f"No module named '{library}.part'", name=f"{library}.part"))
        assert cli.main(words) == 2
        said = f'tflab {words[0]}: This needs {library}. Install it with: pip install "tflab[{extra}]"\n'
        assert capsys.readouterr().err == said
    raises(ModuleNotFoundError("No module named 'their_package'", name="their_package"))
    with pytest.raises(ModuleNotFoundError):
        cli.main(["run", "node.py"])


def test_a_user_without_a_home_is_told_so(raises, capsys) -> None:
    raises(RuntimeError("Could not determine home directory."))
    assert cli.main(["lab"]) == 2
    assert "Set HOME to a folder of yours." in capsys.readouterr().err


def test_a_release_that_is_not_known_is_one_line(raises) -> None:
    command = [sys.executable, "-m", "tflab", "run", "node.py"]
    done = subprocess.run(command, env={**os.environ, "TFLAB_ROS_DISTRO": "foxy"}, capture_output=True, text=True)
    known = "it is one of humble, jazzy, lyrical, rolling."
    assert (done.returncode, done.stderr) == (2, f"tflab run: TFLAB_ROS_DISTRO='foxy' is not known: {known}\n")
    raises(ValueError("another"))
    with pytest.raises(ValueError, match="another"):
        cli.main(["run", "node.py"])


def test_pages_run_in_this_python_even_if_the_user_has_a_kernel_of_the_same_name(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys
) -> None:
    elsewhere = {"argv": ["/elsewhere/python", "-m", "ipykernel"], "display_name": "mine", "language": "python"}
    kernel = tmp_path / "share" / "kernels" / "python3" / "kernel.json"
    kernel.parent.mkdir(parents=True)
    kernel.write_text(json.dumps(elsewhere))
    monkeypatch.setenv("JUPYTER_PATH", str(tmp_path / "share"))
    monkeypatch.setenv("JUPYTER_PREFER_ENV_PATH", "0")
    find = "from jupyter_client import KernelManager as M; print(M(kernel_name='python3').format_kernel_cmd()[0])"
    assert subprocess.check_output([sys.executable, "-c", find], text=True).strip() == "/elsewhere/python"
    for _ in range(2):
        cli.main(["--version"])
    assert os.environ["JUPYTER_PATH"].count(os.pathsep) == 1
    assert subprocess.check_output([sys.executable, "-c", find], text=True).strip() == sys.executable
