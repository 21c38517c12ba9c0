"""turtlesim without a window: poses, services, walls, and the field as a figure."""

import numpy as np
import pytest

from tflab.robots.turtlesim import TurtleSim
from tflab.tools import magic

MIDDLE = 5.544445
PUB = "ros2 topic pub --once /turtle1/cmd_vel geometry_msgs/msg/Twist"
CALL = "ros2 service call /turtle1/"


@pytest.fixture
def sim(terminal, graph):
    terminal.type("ros2 run turtlesim turtlesim_node")
    graph.run(seconds=0.05)
    return next(node for node in graph.nodes if isinstance(node, TurtleSim))


def pose_of(sim, name="turtle1"):
    turtle = sim.turtles[name]
    return [turtle.x, turtle.y, turtle.theta]


@pytest.mark.parametrize(
    ("line", "seconds", "pose"),
    [
        (f"{PUB} '{{linear: {{x: 1.0}}}}'", 1.9, [MIDDLE + 1.0, MIDDLE, 0.0]),  # it stops after one second
        (f"{PUB} '{{angular: {{z: 2.0}}}}'", 1.9, [MIDDLE, MIDDLE, 2.0]),
        (f"{PUB} '{{linear: {{x: -9.0}}}}'", 1.9, [0.0, MIDDLE, 0.0]),
        (f"{CALL}teleport_absolute turtlesim/srv/TeleportAbsolute '{{x: 2, y: 3, theta: 4}}'", 0.1,
         [2, 3, 4 - 2 * np.pi]),
        (f"{CALL}teleport_relative turtlesim/srv/TeleportRelative '{{linear: 2, angular: 1.5708}}'", 0.1,
         [MIDDLE, MIDDLE + 2, np.pi / 2]),
    ],
)  # fmt: skip
def test_a_turtle_moves_as_it_is_told(terminal, graph, sim, line, seconds, pose):
    terminal.type(line)
    graph.run(seconds=seconds)
    assert pose_of(sim) == pytest.approx(pose, abs=0.04)


def test_the_wall_and_the_pose_are_reported_as_upstream_does(terminal, graph, sim):
    assert "average rate: 62.5" in terminal.type("ros2 --for 2 topic hz /turtle1/pose")
    terminal.type(f"{PUB} '{{linear: {{x: 8.0}}}}'")
    graph.run(seconds=1.0)
    assert "Oh no! I hit the wall! (Clamping from [x=11.216889, y=5.544445])" in terminal._capsys.readouterr().err
    assert "x: 11.088889122009277\ny: 5.544444561004639\n" in terminal.type("ros2 topic echo --once /turtle1/pose")
    assert terminal.type("ros2 topic echo --once /turtle1/color_sensor") == "r: 179\ng: 184\nb: 255\n---\n"


def test_turtles_are_spawned_killed_and_reset(terminal, graph, sim):
    spawn = "ros2 service call /spawn turtlesim/srv/Spawn '{x: 1, y: 2, name: %s}'"
    assert "name='turtle2'" in terminal.type(spawn % '""')
    assert "name=''" in terminal.type(spawn % "turtle2")
    terminal.type("ros2 service call /kill turtlesim/srv/Kill '{name: turtle1}'")
    assert "name='turtle3'" in terminal.type(spawn % '""')
    assert "/turtle1/pose" not in terminal.type("ros2 topic list")
    terminal.type("ros2 service call /reset std_srvs/srv/Empty")
    assert list(sim.turtles) == ["turtle1"]
    assert not sim.canvas[..., 3].any()


def test_a_page_shows_turtles_and_their_pens(terminal, graph, sim, monkeypatch, capsys):
    shown = []
    monkeypatch.setattr(magic, "_show", shown.append)
    terminal.type(f"{CALL}set_pen turtlesim/srv/SetPen '{{r: 255, width: 5}}'")
    terminal.type(f"{CALL}teleport_relative turtlesim/srv/TeleportRelative '{{linear: 2}}'")
    magic.turtlesim_line("")
    assert shown[0].text == "turtle1 at (7.54, 5.54) m, heading 0.00 rad\n"
    (image,) = shown[0].figure.axes[0].images
    red = np.argwhere((image.get_array() == (255, 0, 0)).all(axis=-1))
    assert np.ptp(red, axis=0).tolist() == [4, 94]  # 5 pixels wide, 2 m of 45 pixels long
    graph.stop()
    magic.turtlesim_line("")
    assert "No turtlesim runs in this graph" in capsys.readouterr().out
