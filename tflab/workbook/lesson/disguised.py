"""Three robots that look healthy to RViz, and are not; and one whose room is shown with it.

    start_robot()              our robot, with a map server: what RViz has to show
    start_robot("mount")       the drawing has the laser 0.20 m behind the middle, and it is bolted on 0.20 m before
    start_robot("header")      the driver writes base_link into the scan's header
    start_robot("clock")       the laser's computer is 0.3 s slow
    draw_rviz()                what RViz shows of it, on paper

Nothing that a list says gives them away: every transform can be computed.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import replace

from tflab.core import Transform, seconds
from tflab.robots.motion import Drive
from tflab.robots.nodes import USUAL_NODES, launch
from tflab.robots.sensors import ROOM
from tflab.robots.teaching import TeachingRobot, teaching_urdf
from tflab.ros.graph import Graph, current_graph, new_graph
from tflab.tools.rviz import look
from tflab.views.picture import Picture
from tflab.views.rviz_figure import draw_shown
from tflab.views.rviz_status import look_through

__all__ = ["ROBOTS", "draw_rviz", "start_robot", "stop_node"]

BUILT = Transform((0.20, 0.0, 0.15))  # where the laser is bolted on
DRAWN, WRONG = 'xyz="0.20 0.0 0.15"', 'xyz="-0.20 0.0 0.15"'


def _healthy(drive: Drive) -> TeachingRobot:
    return TeachingRobot(drive)


def _mount(drive: Drive) -> TeachingRobot:
    return TeachingRobot(drive, urdf=teaching_urdf().replace(DRAWN, WRONG), screws={"laser_frame": BUILT})


def _header(drive: Drive) -> TeachingRobot:
    robot = TeachingRobot(drive)
    robot.laser = replace(robot.laser, frame_id="base_link")
    return robot


ROBOTS: dict[str, Callable[[Drive], TeachingRobot]] = {
    "healthy": _healthy,
    "mount": _mount,
    "header": _header,
    "clock": _healthy,
}


def start_robot(name: str = "healthy", also: Iterable[str] = ()) -> Graph:
    """Start a robot in a new graph, a map server beside it; its clock stands at 1 s.

    Args:
        name: which, by the keys of ROBOTS.
        also: further nodes, by the keys of NODES.

    Raises:
        ValueError: there is no such robot.
    """
    if name not in ROBOTS:
        raise ValueError(f"there is no robot {name!r}; there is {', '.join(ROBOTS)}")
    graph = new_graph()
    launch(graph, ROBOTS[name](Drive(start_ns=graph.now_ns)), only=(*USUAL_NODES, "map_server", *also))
    if name == "clock":
        graph.set_clock_offset("laser_driver", -0.3)
    return graph


def stop_node(name: str) -> None:
    """Stop one node of the current graph, as Ctrl-C in its terminal does; one that was stopped stays so.

    Raises:
        ValueError: no such node has been started.
    """
    graph = current_graph()
    running = {each.name: each for each in graph.participants if each.is_running}
    if name not in running and any(each.name == name for each in graph.participants):
        return  # a cell that runs again
    if name not in running:
        raise ValueError(f"no node {name!r} runs; there is {', '.join(sorted(running))}")
    graph.stop(running[name])


def draw_rviz(until_s: float | None = None, fixed_frame: str = "map", decay_s: float = 1.0) -> Picture:
    """Return what RViz shows of the current graph after a look of 4 s, on paper, the room's walls beneath.

    Args:
        until_s: when the look is over [s of the graph's time]; 4 s from now if None.
        decay_s: how long scans stay on the screen, RViz's Decay Time [s].
    """
    graph = current_graph()
    if until_s is not None:
        graph.run(seconds=max(0.0, (seconds(until_s - 4.0) - graph.now_ns) / 1e9))
    shown = look_through(fixed_frame, *look(graph, seconds=4.0, decay_s=decay_s))
    return draw_shown(shown, ROOM.walls if fixed_frame == "map" else ())
