"""`ros2 launch` starts the nodes of a launch file with their arguments, and names what it cannot do."""

import sys
from pathlib import Path

import pytest
import yaml

from tflab import ros
from tflab.ros import workspace

CASES = yaml.safe_load(Path(__file__).with_suffix(".yaml").read_text(encoding="utf-8"))
NODE, LAUNCH, ALL = (CASES[name] for name in ("node", "launch", "all"))


@pytest.fixture(autouse=True)
def package(tmp_path, monkeypatch):
    folder = tmp_path / "src" / "hop"
    (folder / "hop").mkdir(parents=True)
    (folder / "package.xml").write_text("<package><name>hop</name></package>")
    (folder / "setup.py").write_text('setup(entry_points={"console_scripts": ["rabbit = hop.rabbit:main"]})')
    (folder / "hop" / "rabbit.py").write_text(NODE)
    (folder / "pace.yaml").write_text("/**:\n  ros__parameters:\n    pace: 3.0\n")
    (folder / "inner.launch.py").write_text(LAUNCH.replace("{}", 'LogInfo(msg=["inner ", LaunchConfiguration("who")])'))
    (folder / "all.launch.py").write_text(LAUNCH.replace("{}", ALL))
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(sys, "path", sys.path[:])
    monkeypatch.setattr(workspace, "_used", {})
    ros.activate("in-process")
    yield folder
    ros.deactivate()
    sys.modules.pop("hop.rabbit", None)


@pytest.mark.parametrize(("line", "expected"), CASES["starts"])
def test_nodes_start_with_their_names_parameters_and_remappings(terminal, graph, capsys, line, expected):
    printed = terminal.type(f"ros2 launch {line}")
    graph.run(seconds=3.0)
    printed += capsys.readouterr().out
    assert [text for text in expected if text not in printed] == []


@pytest.mark.parametrize(("actions", "line", "error"), CASES["refused"])
def test_what_a_launch_file_cannot_do_is_named_with_its_line(terminal, package, actions, line, error):
    (package / "one.launch.py").write_text(LAUNCH.replace("{}", actions))
    terminal.type(f"ros2 launch hop one.launch.py {line}")
    assert error in terminal.error
    assert terminal.exit_code == 1
    terminal.type("ros2 launch hop two.launch.py")
    assert "file 'two.launch.py' was not found in the share directory of package 'hop'" in terminal.error
