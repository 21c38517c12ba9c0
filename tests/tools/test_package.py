"""`tflab package` makes a package of node files that tflab runs, and writes nothing where it cannot."""

import ast
import sys
from pathlib import Path
from xml.etree import ElementTree

import pytest

from tflab import ros
from tflab.cli import main
from tflab.ros import workspace

GUARD = "if __name__ == '__main__':\n    "
MAIN = "def main():\n    print(pace())\n"
NODE = f"import numpy, nav2_msgs.msg, foo\nfrom  gait import pace  # [m]\n{MAIN}"
FRAME = f"def pace(message):\n    message.child_frame_id = 'base_link'\n{MAIN}"
URDF = "<robot name='cart'><link name='base_link'/></robot>"


@pytest.fixture(autouse=True)
def hop(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(sys, "path", sys.path[:])
    for name in ("_used", "_undefined"):
        monkeypatch.setattr(workspace, name, {})
    (tmp_path / "hop").mkdir()
    (tmp_path / "hop/gait.py").write_text(f"def pace():\n    return 1.5\n{GUARD}print(pace())\n")
    yield tmp_path / "hop"
    ros.deactivate()
    for name in [name for name in sys.modules if name.partition(".")[0] == "hop"]:
        del sys.modules[name]


def test_a_package_has_what_its_nodes_import_and_runs_as_a_workspace(hop, capfd):
    (hop / "rabbit.py").write_text(NODE.partition("\n")[2], encoding="utf-8-sig")
    assert main(["package", "hop"]) == 0
    made, before = hop.parent / "ros2_ws/src/hop", sorted(path.name for path in hop.iterdir())
    assert "tflab run ros2_ws hop:rabbit\n" in capfd.readouterr().out
    assert main(["run", "ros2_ws"]) == 0
    assert main(["ros2", "launch", str(made / "launch/hop.launch.py"), "urdf:=false"]) == 0
    assert capfd.readouterr().out == "1.5\n[INFO] [rabbit-1]: process started\n1.5\n"
    assert before == ["gait.py", "rabbit.py"]
    for path in made.rglob("*.py"):
        ast.parse(path.read_text())
    files = {path.relative_to(made).as_posix() for path in made.rglob("*") if path.is_file()}
    assert files == {
        "package.xml", "setup.py", "setup.cfg", "resource/hop", "hop/__init__.py", "hop/rabbit.py", "hop/gait.py",
        "launch/hop.launch.py", "urdf/tf_lab_robot.urdf", "test/test_hop.py",
    }  # fmt: skip


@pytest.mark.parametrize(
    ("node", "urdf", "depends", "is_published"),
    [
        (NODE, "", {"python3-numpy", "nav2_msgs"}, True),
        (f"import rclpy\nfrom std_msgs.msg import String\n{MAIN}", URDF, {"rclpy", "std_msgs"}, True),
        (FRAME, "", set(), False),  # ours mounts base_link on base_footprint
        (FRAME, URDF, set(), True),
        (
            f"import rclpy\nLOG = rclpy.logging.get_logger('a')\nasync def wait():\n    rclpy.spin()\n{MAIN}",
            "",
            {"rclpy"},
            True,
        ),
    ],
)
def test_depends_come_from_imports_and_an_edge_keeps_one_owner(hop, node, urdf, depends, is_published):
    (hop / "rabbit.py").write_text(node)
    if urdf:
        (hop / "cart.urdf").write_text(urdf)
    assert main(["package", "hop", "--name", "hop_py", "--ws", "ws"]) == 0
    made = hop.parent / "ws/src/hop_py"
    xml = (made / "package.xml").read_text()
    always = {"ament_index_python", "launch", "launch_ros", "robot_state_publisher"}
    assert {each.text for each in ElementTree.fromstring(xml.encode()).findall("exec_depend")} == depends | always
    assert ("rosdep key of foo" in xml) == ("foo" in node)
    assert [path.name for path in (made / "urdf").iterdir()] == ["cart.urdf" if urdf else "tf_lab_robot.urdf"]
    assert f'"urdf", default_value="{str(is_published).lower()}"' in (made / "launch/hop_py.launch.py").read_text()


@pytest.mark.parametrize(
    ("words", "source", "error"),
    [
        (["hop"], "x = 1", "has no node: a Python file with a function main()"),
        (["none"], MAIN, "there is no folder none"),
        (["hop", "--name", "Hop"], MAIN, 'cannot have the name "Hop"'),
        (["hop", "--name", "rclpy"], MAIN, 'cannot have the name "rclpy"'),
        (
            ["hop/rabbit.py"],
            MAIN,
            "hop/rabbit.py is a file. Name the package first: tflab package my_robot_py hop/rabbit.py",
        ),
        (["hop"], "import rclpy\nrclpy.init()\n", "rabbit.py:2: ros2 run imports this file and calls main()"),
        (["hop"], f"{GUARD}rclpy.init()\n", "rabbit.py:1: ros2 run imports this file and calls main()"),
        (["hop"], f"{MAIN}main()\n", "rabbit.py:3: ros2 run imports this file"),
        (["hop"], "def main(args):\n    pass\n", "rabbit.py:1: ros2 run gives main() no arguments"),
        (["hop"], "def main(*, args):\n    pass\n", "rabbit.py:1: ros2 run gives main() no arguments"),
        (["hop"], "def main(:", "rabbit.py:1: invalid syntax"),
        (["hop", "hop/rabbit.py"], NODE, "hop/rabbit.py imports gait from beside it: name gait.py, too"),
        (["hop"], f"import gait, sys\n{MAIN}", "rabbit.py:1: import gait in a line of its own"),
        (["hop", "--name", "rabbit"], f"import rabbit\n{MAIN}", "rabbit.py:1: rabbit is a file and the package"),
        (["hop", "hop/cart.urdf"], MAIN, "cart.urdf cannot be a module"),
        (["hop", "hop/none.py"], MAIN, "none.py: No such file or directory"),
        (["hop", "--ws", "old"], MAIN, "exists and stays as it is. Move it away, or choose another --name or --ws"),
        (["old/src/hop"], MAIN, "is a package already. Run it with: tflab run"),
    ],
)
def test_where_no_package_can_be_made_nothing_is_written(hop, capsys, words, source, error):
    (hop / "rabbit.py").write_text(source)
    old = hop.parent / "old/src/hop"
    old.mkdir(parents=True)
    (old / "package.xml").touch()
    assert main(["package", *words]) == 2
    assert error in capsys.readouterr().err
    assert not Path("ros2_ws/src/hop").exists() and [path.name for path in old.iterdir()] == ["package.xml"]
