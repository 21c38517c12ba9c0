"""Files of packages, and the executables of a workspace, run as `ros2 run` runs them."""

import sys
from pathlib import Path

import pytest
import yaml

from tflab import ros
from tflab.cli import main
from tflab.ros import workspace
from tflab.ros.messages import packages
from tflab.ros.process import use_graph

CASES = yaml.safe_load(Path(__file__).with_suffix(".yaml").read_text(encoding="utf-8"))

XML = "<package format='3'><name>{}</name></package>"
NODE = CASES["node"]
FILES = {
    "src/hop/package.xml": XML.format("hop"),
    "src/hop/setup.py": CASES["setup"],
    "src/hop/hop/__init__.py": "",
    "src/hop/hop/rabbit.py": NODE,
    "src/hop/hop/gait.py": "def stride():\n    return 1.5\n",
    "src/group/limp/package.xml": XML.format("limp"),
    "src/group/limp/setup.cfg": "[options.entry_points]\nconsole_scripts =\n    fox = limp.gait:fox\n",
    "src/group/limp/CMakeLists.txt": "install(PROGRAMS\n  scripts/worm.py DESTINATION lib/${PROJECT_NAME})\n",
    "src/group/limp/scripts/worm.py": "import limp.gait\nprint('worm', __name__)\n",
    "src/group/limp/limp/__init__.py": "",
    "src/group/limp/limp/gait.py": "def stride():\n    return 0.1\n\n\ndef fox():\n    return 'the fox is lame'\n",
    "src/hop_msgs/package.xml": XML.format("hop_msgs"),
    "src/hop_msgs/msg/Hops.msg": "leg_msgs/Leg[] hops\nleg_msgs/Leg first",
    "src/leg_msgs/src/msg/Leg.msg": "float64 stride 0.5",
    "src/build/built/package.xml": XML.format("built"),
    "src/ignored/COLCON_IGNORE": "",
    "src/ignored/package.xml": XML.format("ignored"),
}


@pytest.fixture(autouse=True)
def ws(tmp_path, monkeypatch):
    for path, text in FILES.items():
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / path).write_text(text)
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(sys, "path", sys.path[:])
    for name in ("_used", "_undefined"):
        monkeypatch.setattr(workspace, name, {})
    yield tmp_path
    use_graph(None)
    ros.deactivate()
    for name in [name for name in sys.modules if name.partition(".")[0] in ("hop", "limp", "hop_msgs", "leg_msgs")]:
        packages._defined.pop(name, None)
        del sys.modules[name]


HOPPED = "/rabbit 1.5 0.1 0.5 []\n"


@pytest.mark.parametrize(
    ("words", "out"),
    [
        (["run", "src/hop/hop/rabbit.py"], HOPPED),
        (["run", ".", "hop:rabbit", "hop:hare"], HOPPED * 2),
        (["run", "src/hop", "limp:worm.py"], "worm __main__\n"),
        (["run", "hop:hare", "--", "3", "--ros-args", "-r", "__ns:=/field"],
         "/field/rabbit 1.5 0.1 0.5 ['3', '--ros-args', '-r', '__ns:=/field']\n"),
        (["ros2", "run", "hop", "rabbit", "4"], "/rabbit 1.5 0.1 0.5 ['4']\n"),
        (["ros2", "run", "limp", "worm.py"], "worm __main__\n"),
    ],
)  # fmt: skip
def test_files_of_packages_and_executables_run_with_their_own_modules_and_interfaces(words, out, capfd):
    assert main(words) == 0
    assert capfd.readouterr() == (out, "")


def test_a_repository_without_src_is_searched_as_colcon_does(ws, capfd):
    (ws / "src").rename(ws / "level_2")
    (ws / "level_2" / "hop_msgs").rename(ws / "hop_msgs")  # beside the folder of the package
    (ws / ".git").mkdir()
    assert main(["run", "level_2/hop/hop/rabbit.py"]) == 0
    assert capfd.readouterr() == (HOPPED, "")


@pytest.mark.parametrize(("words", "code", "text"), CASES["not_there"])
def test_what_a_workspace_does_not_have_is_explained(words, code, text, capfd):
    assert main(words) == code
    assert capfd.readouterr() == ("", text)


@pytest.mark.parametrize(("source", "code", "out", "err"), CASES["files"])
def test_a_file_ends_in_silence_only_where_python_does(source, code, out, err, ws, capfd):
    (ws / "node.py").write_text(source)
    assert main(["run", "node.py"]) == code
    printed = capfd.readouterr()
    assert printed.out == out
    assert err in printed.err and bool(err) == bool(printed.err)


def test_the_exit_status_of_an_executable_is_what_its_function_returns(capfd):
    assert main(["ros2", "run", "limp", "fox"]) == 1
    assert capfd.readouterr() == ("[ros2run]: Process exited with failure 1\n", "the fox is lame\n")


def test_malformed_interfaces_are_named_where_they_are_imported(ws, capfd):
    (ws / "src/hop_msgs/msg/Hops.msg").write_text("float64")
    assert main(["run", "hop:rabbit"]) == 1
    assert f'cannot read the interfaces in {ws / "src" / "hop_msgs"}: cannot read "float64"' in capfd.readouterr().err


def test_an_interface_that_cannot_be_read_leaves_the_others_of_its_package(ws, capfd):
    (ws / "src/hop_msgs/msg/Wing.msg").write_text("bird_msgs/Feather[] feathers")
    (ws / "src/hop/hop/gait.py").write_text("from hop_msgs.msg import Hops, Wing")
    assert main(["run", "hop:rabbit"]) == 1
    assert "cannot read Wing.msg: there is no bird_msgs/msg/Feather" in capfd.readouterr().err
