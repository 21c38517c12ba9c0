"""turtlesim without a window: poses, services, walls, and the field as a figure."""

import numpy as np
import pytest

from tflab.robots.turtlesim import TurtleSim
from tflab.tools import magic

MIDDLE = 5.544445
PUB = "topic pub --once /turtle1/cmd_vel geometry_msgs/msg/Twist"
CALL = "service call /turtle1/{0} turtlesim/srv/{1}"
ABSOLUTE, RELATIVE = (CALL.format(f"teleport_{kind.lower()}", f"Teleport{kind}") for kind in ("Absolute", "Relative"))


@pytest.fixture
def sim(terminal, graph):
    terminal.type("run turtlesim turtlesim_node")
    return next(node for node in graph.nodes if isinstance(node, TurtleSim))


@pytest.mark.parametrize(
    ("line", "pose", "seconds"),
    [
        (PUB + " '{linear: {x: 1.0}}'", [MIDDLE + 1.0, MIDDLE, 0.0], 1.9),  # it stops after one second
        (PUB + " '{angular: {z: 2.0}}'", [MIDDLE, MIDDLE, 2.0], 1.9),
        (PUB + " '{linear: {x: -9.0}}'", [0.0, MIDDLE, 0.0], 1.9),
        (ABSOLUTE + " '{x: 2, y: 3, theta: 4}'", [2.0, 3.0, 4.0 - 2 * np.pi], 0.1),
        (RELATIVE + " '{linear: 2, angular: 1.5708}'", [MIDDLE, MIDDLE + 2.0, np.pi / 2], 0.1),
    ],
)
def test_a_turtle_moves_as_it_is_told(terminal, graph, sim, line, seconds, pose):
    terminal.type(line)
    graph.run(seconds=seconds)
    turtle = sim.turtles["turtle1"]
    assert [turtle.x, turtle.y, turtle.theta] == pytest.approx(pose, abs=0.04)


def test_the_wall_and_the_pose_are_reported_as_upstream_does(terminal, graph, sim, capsys):
    assert "average rate: 62.5" in terminal.type("--for 2 topic hz /turtle1/pose")
    terminal.type(PUB + " '{linear: {x: 8.0}}'")
    graph.run(seconds=1.0)
    assert "Oh no! I hit the wall! (Clamping from [x=11.216889, y=5.544445])" in capsys.readouterr().err
    assert "x: 11.088889122009277\ny: 5.544444561004639\n" in terminal.type("topic echo --once /turtle1/pose")
    assert terminal.type("topic echo --once /turtle1/color_sensor") == "r: 179\ng: 184\nb: 255\n---\n"


def test_turtles_are_spawned_killed_and_reset(terminal, sim):
    spawn = "service call /spawn turtlesim/srv/Spawn '{x: 1, name: %s}'"
    assert "name='turtle2'" in terminal.type(spawn % '""')
    assert "name=''" in terminal.type(spawn % "turtle2")
    terminal.type("service call /kill turtlesim/srv/Kill '{name: turtle1}'")
    assert "name='turtle3'" in terminal.type(spawn % '""')
    assert "/turtle1/pose" not in terminal.type("topic list")
    terminal.type("service call /reset std_srvs/srv/Empty")
    assert list(sim.turtles) == ["turtle1"]


def test_a_page_shows_turtles_and_their_pens(terminal, graph, sim, monkeypatch, capsys):
    shown = []
    monkeypatch.setattr(magic, "_show", shown.append)
    terminal.type(CALL.format("set_pen", "SetPen") + " '{r: 255, width: 5}'")
    terminal.type(RELATIVE + " '{linear: 2}'")
    magic.turtlesim_line("")
    assert shown[0].text == "turtle1 at (7.54, 5.54) m, heading 0.00 rad\n"
    red = np.argwhere((shown[0].figure.axes[0].images[0].get_array() == (255, 0, 0)).all(axis=-1))
    assert np.ptp(red, axis=0).tolist() == [4, 94]  # 5 pixels wide, 2 m of 45 pixels long
    terminal.type("service call /clear std_srvs/srv/Empty")
    assert not sim.canvas[..., 3].any()
    graph.stop()
    magic.turtlesim_line("")
    assert "No turtlesim runs in this graph" in capsys.readouterr().out
