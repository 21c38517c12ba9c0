"""Whose numbers change?  Sliders in front of `rulers`: move the robot, turn it, move the thing.

The pure function behind it is `tflab.views.rulers.readings_of`.
"""

from __future__ import annotations

import math

import numpy as np

from tflab.core import Transform
from tflab.core.quaternions import Vector3

from ..libraries import ipywidgets as widgets
from ..rulers import RulersPicture, readings_of
from .drawn_ahead import At
from .panel import SLIDER_WIDTH, Panel, slider
from .words import said

BASE_T_LASER = Transform(translation=(0.20, 0.0, 0.15))
ON_THE_TRAY = (-0.10, 0.0, 0.20)  # in base_link [m]
IN_SIGHT = np.array([(-0.5, -2.5), (8.0, 2.5)])  # of the map's ground [m]


def placed(robot_x_m: float, yaw_rad: float) -> dict[str, Transform]:
    """Return where the three frames are in map, for a robot at (x, 0) [m] that is turned by yaw [rad]."""
    map_T_base = Transform.from_rpy(yaw=yaw_rad, translation=(robot_x_m, 0.0, 0.0))
    return {"map": Transform(), "base_link": map_T_base, "laser_frame": map_T_base @ BASE_T_LASER}


def rulers_panel(
    robot_x_m: float = 1.0, yaw_rad: float = 0.0, thing_m: tuple[float, float] = (6.5, -1.5), language: str = "en"
) -> Panel:
    """Return a panel that moves a robot and a thing, and says in which frame the thing's numbers stay the same.

    Args:
        robot_x_m: where the robot is at first, along map's x [m].
        yaw_rad: how far it is turned at first [rad].
        thing_m: where on the floor the thing lies at first, in map (x, y) [m].
        language: of the controls, "en" or "ko".

    Raises:
        ValueError: the language is unknown.
    """
    half_turn = round(math.pi, 2)
    robot_x = slider("robot x", robot_x_m, 0.0, 5.0, 0.05, "m", language)
    yaw = slider("robot yaw", yaw_rad, -half_turn, half_turn, 0.01, "rad", language)
    thing_x = slider("thing x", thing_m[0], 0.0, 7.5, 0.05, "m", language)
    thing_y = slider("thing y", thing_m[1], -2.0, 2.0, 0.05, "m", language)
    places = {"floor": "floor", "tray: it rides along": "tray"}  # what the menu says: why a slider is grey, too
    rests_on = widgets.Dropdown(
        options=[(said(words, language), place) for words, place in places.items()],
        description=said("rests on", language),
        tooltip=said("rests on", language),
        style={"description_width": "110px"},
        layout={"width": SLIDER_WIDTH, "max_width": "100%"},
    )
    picture = RulersPicture(("map", "base_link", "laser_frame"), "thing", keep=IN_SIGHT)

    def thing(poses: dict[str, Transform], on: str, on_the_floor: tuple[float, float]) -> Vector3:
        return poses["base_link"].apply(ON_THE_TRAY) if on == "tray" else (*on_the_floor, 0.0)

    def move(at: At) -> None:
        first = placed(robot_x_m, yaw_rad)
        before = readings_of(first, thing(first, at(rests_on), thing_m))
        poses = placed(at(robot_x), at(yaw))
        picture.show(poses, thing(poses, at(rests_on), (at(thing_x), at(thing_y))), before)

    def let_go(change: dict[str, object]) -> None:
        for place in (thing_x, thing_y):
            place.disabled = change["new"] == "tray"

    controls = (robot_x, yaw, thing_x, thing_y, rests_on)
    rests_on.observe(let_go, names="value")
    return Panel("A thing, measured from three frames", picture, controls, move, language=language)
