"""`ros2 launch` starts the nodes of a launch file with their arguments, and names what it cannot do."""

import sys
from pathlib import Path

import pytest
import yaml

from tflab import ros
from tflab.ros import workspace

NODE, LAUNCH, ALL = yaml.safe_load(Path(__file__).with_suffix(".yaml").read_text(encoding="utf-8")).values()


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


@pytest.mark.parametrize(
    ("line", "expected"),
    [
        ("hop all.launch.py",
         ["1.0 /left/hops --ros-args {'pace': 2.5, 'legs.ids': [1, 2], 'text': '2.5'}",
          "3.0 /hare/leaps fast {'pace': 3.0}", "[INFO] [launch.user]: inner 9",
          "launch.py:24: rviz2 rviz2 is left out: it is a window", "launch.py:24: hop fox is left out: No exec"]),
        ("src/hop/all.launch.py late:=false pace:=4",
         ["1.0 /leaps --ros-args {}", "1.0 /left/hops --ros-args {'pace': 4"]),
        ("hop all.launch.py --show-args", ["    'pace':\n        How fast.\n        (default: '2.5')\n"]),
    ],
)  # fmt: skip
def test_nodes_start_with_their_names_parameters_and_remappings(terminal, graph, capsys, line, expected):
    printed = terminal.type(f"ros2 launch {line}")
    graph.run(seconds=3.0)
    printed += capsys.readouterr().out
    assert [text for text in expected if text not in printed] == []


@pytest.mark.parametrize(
    ("actions", "line", "error"),
    [
        ("\nExecuteProcess(cmd=['ls'])", "", "one.launch.py:17: tflab has no ExecuteProcess. A launch file can use"),
        ("rabbit(respawn=True)", "", "one.launch.py:14: tflab's Node has no respawn; it has executable, package, "),
        ("\nLogInfo(msg=late)", "", "one.launch.py:17: launch configuration 'late' does not exist"),
        ("LogInfo(msg=FindPackageShare('dog'))", "", "one.launch.py:16: package 'dog' not found, searching: ["),
        ("rabbit(condition=IfCondition('maybe'))", "", "a condition is true, false, 1 or 0, not 'maybe'"),
        ("DeclareLaunchArgument('who')", "", 'Required launch argument "who" was not provided.'),
        ("DeclareLaunchArgument('who', choices=['me'])", "who:=you", "\"you\" is not valid. Valid options are: ['me']"),
        ("LogInfo(msg=get_package_share_directory('dog'))", "", "one.launch.py:16: package 'dog' not found"),
        ("", "who=you", "malformed launch argument 'who=you', expected format '<name>:=<value>'"),
        ("IncludeLaunchDescription('two.launch.xml')", "", "two.launch.xml: tflab reads launch files in Python"),
    ],
)
def test_what_a_launch_file_cannot_do_is_named_with_its_line(terminal, package, actions, line, error):
    (package / "one.launch.py").write_text(LAUNCH.replace("{}", actions))
    terminal.type(f"ros2 launch hop one.launch.py {line}")
    assert error in terminal.error
    assert terminal.exit_code == 1
    terminal.type("ros2 launch hop two.launch.py")
    assert "file 'two.launch.py' was not found in the share directory of package 'hop'" in terminal.error
