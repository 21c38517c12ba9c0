"""Show a small RViz in a page: a menu of Fixed Frames, a 3D scene and the list of statuses.

While a page is built for export (TFLAB_FILMS=1), `RViz` is drawn for every Fixed Frame, and its
scrubber goes through them. It gets plain values and a lookup function; `tflab.tools` connects it
to a graph. (https://github.com/ros2/rviz)
"""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence, Set
from html import escape
from typing import Any

from tflab.core import Transform

from .libraries import ipywidgets
from .rviz_status import (
    SIGNS,
    Ask,
    Display,
    LaserScan,
    MapCells,
    Message,
    Path,
    Shown,
    look_through,
    points_of,
    statuses_as_text,
)
from .scene import Scene
from .scene.drawing import draw_arrow, draw_frame, draw_path, draw_points, draw_robot, draw_scan, edge_path, frame_path

COLOURS = {"Ok": "#009E73", "Warn": "#D08700", "Error": "#D55E00"}
EDGE_M = 0.0056  # radius of the arrow from a frame to its parent
LASER_COLOURS = ("#B5539B", "#D08700", "#3C8DC5", "#009E73")  # one for each topic, in turn


class RViz(ipywidgets.VBox):
    """A small RViz, to be shown by a cell.

    Args:
        parents: every frame with its parent, "" for a root.
        displays: what to show besides TF.
        ask: gives `target_T_source` at a stamp [ns], or raises a TransformException.
        fixed_frame: the frame to start with; it may be one that does not exist.

    Attributes:
        scene: the 3D view.
        shown: what became of each display.
        text: its text.
    """

    def __init__(
        self,
        parents: Mapping[str, str],
        displays: Sequence[Display],
        ask: Ask,
        fixed_frame: str = "map",
    ) -> None:
        self.scene = Scene(looks_at_origin=True)
        self._drawn: set[str] = set()
        self._picker = ipywidgets.Dropdown(description="Fixed Frame", style={"description_width": "initial"})
        self._list = ipywidgets.HTML()
        super().__init__([self._picker, self.scene, self._list])
        self._picker.observe(self._on_choice, "value")
        self._offer(parents, fixed_frame)
        self.update(parents, displays, ask)

    @property
    def fixed_frame(self) -> str:
        """The frame that everything is turned into; set it to look from another."""
        return self._picker.value

    @fixed_frame.setter
    def fixed_frame(self, frame: str) -> None:
        self._offer(self._parents, frame)
        self._redraw()

    @property
    def text(self) -> str:
        return statuses_as_text(self.shown) + "\n" + self.scene.describe()

    def update(self, parents: Mapping[str, str], displays: Sequence[Display], ask: Ask) -> None:
        """Show other values, with the same Fixed Frame."""
        self._parents, self._displays, self._ask = dict(parents), tuple(displays), ask
        self._offer(parents, self.fixed_frame)
        self._redraw()

    def sweep(
        self,
        name: str,
        values: Sequence[float],
        values_at: Callable[[float], tuple[Mapping[str, str], Sequence[Display], Ask]],
        unit: str = "s",
    ) -> None:
        """Let the view's scrubber go through `values`; `values_at(value)` gives what `update` takes."""
        steps = {
            value: (dict(at[0]), look_through(self.fixed_frame, *at)) for value in values for at in [values_at(value)]
        }
        everything = set().union(*(_paths(shown) for _, shown in steps.values()))

        def draw(value: float) -> None:
            parents, shown = steps[value]
            draw_in_scene(self.scene, parents, shown, everything)

        self.scene.sweep(name, values, draw, unit)
        self._drawn |= everything

    def _offer(self, parents: Mapping[str, str], chosen: str) -> None:
        """Let the picker offer every known frame, and the chosen one even if nobody knows it."""
        self._picker.unobserve(self._on_choice, "value")  # new options choose one of themselves at first
        self._picker.options = sorted({*parents, chosen})
        self._picker.value = chosen
        self._picker.observe(self._on_choice, "value")
        self.scene.follow(self._picker, lambda i: self._draw_from(self._picker.options[i]))

    def _on_choice(self, _change: object) -> None:
        self._redraw()

    def _repr_mimebundle_(self, **kwargs: Any) -> tuple[dict, dict] | dict | None:
        if os.environ.get("TFLAB_FILMS"):
            frames = self._picker.options
            self.scene.sweep("Fixed Frame", frames, self._draw_from, start=frames.index(self.fixed_frame))
            self.children = (self.scene, self._list)  # the scrubber takes the picker's place
        bundle = super()._repr_mimebundle_(**kwargs)
        if bundle is not None:
            (bundle[0] if isinstance(bundle, tuple) else bundle)["text/plain"] = self.text
        return bundle

    def _draw_from(self, frame: str) -> None:
        """Draw what another Fixed Frame shows, whatever stood there before."""
        shown = look_through(frame, self._parents, self._displays, self._ask)
        anywhere = look_through(next(iter(self._parents), ""), self._parents, self._displays, lambda *_: Transform())
        draw_in_scene(self.scene, self._parents, shown, _paths(anywhere))

    def _redraw(self) -> None:
        self.shown = look_through(self.fixed_frame, self._parents, self._displays, self._ask)
        self._drawn = draw_in_scene(self.scene, self._parents, self.shown, self._drawn)
        self._list.value = _list_as_html(self.shown)


def draw_in_scene(
    scene: Scene,
    parents: Mapping[str, str],
    shown: Sequence[Shown],
    before: Set[str],
) -> set[str]:
    """Draw what can be shown, take away what was drawn before and cannot; return where things were drawn."""
    with scene.redraw():
        drawn = _paths(shown)
        for path in sorted(before - drawn):
            scene[path].delete()
        for i, entry in enumerate(shown):
            if entry.name == "TF":
                _draw_tf(scene, parents, entry.poses)
            elif entry.poses:
                draw_robot(scene, _place(entry, i, 0), entry.display.content.links, entry.poses)
            for j, (message, fixed_T_message) in enumerate(entry.placed):
                _draw_message(
                    scene, _place(entry, i, j), message, fixed_T_message, LASER_COLOURS[i % len(LASER_COLOURS)]
                )
        return drawn


def _draw_tf(scene: Scene, parents: Mapping[str, str], poses: Mapping[str, Transform]) -> None:
    for frame, fixed_T_frame in poses.items():
        parent = parents[frame]
        draw_frame(scene, frame, fixed_T_frame, parent)
        if parent in poses:  # RViz's arrows point to the parent
            start, end = fixed_T_frame.translation, poses[parent].translation
            draw_arrow(scene, edge_path(frame), start, end, radius_m=EDGE_M)


def _draw_message(scene: Scene, path: str, message: Message, fixed_T_message: Transform, colour: str) -> None:
    """Draw a message where it was measured, and move it: another Fixed Frame moves it, and sends nothing else."""
    if isinstance(message, LaserScan):
        rays = (message.ranges_m, message.angle_min_rad, message.angle_increment_rad)
        draw_scan(scene, path, fixed_T_message, *rays, colour=colour)
        return
    scene[path].set_transform(fixed_T_message.matrix())
    if isinstance(message, MapCells):
        draw_points(scene, path, points_of(message), "#808890", 1.4 * message.resolution_m, "map cells")
    elif isinstance(message, Path):
        draw_path(scene, path, points_of(message), colour)
    else:
        draw_points(scene, path, points_of(message), colour)


def _place(entry: Shown, number: int, message: int) -> str:
    """Return where a display's message is in the scene's tree; two displays may be of one kind."""
    return f"{entry.name}_{number}/{message}"


def _paths(shown: Sequence[Shown]) -> set[str]:
    """Return where `draw_in_scene` would draw."""
    paths = set()
    for i, entry in enumerate(shown):
        if entry.name == "TF":
            paths |= {frame_path(frame) for frame in entry.poses} | {edge_path(frame) for frame in entry.poses}
        elif entry.poses:
            paths.add(_place(entry, i, 0))
        paths |= {_place(entry, i, j) for j in range(len(entry.placed))}
    return paths


def _list_as_html(shown: Sequence[Shown]) -> str:
    """Return RViz's list; a sign and a word say what the colour says."""
    rows = []
    for entry in shown:
        topic = f" <code>{escape(entry.display.topic)}</code>" if entry.display and entry.display.topic else ""
        lines = "".join(
            f'<div style="margin-left:2.2em">{_sign(status.level)} {escape(status.name)}: {escape(status.text)}</div>'
            for status in entry.statuses
        )
        state = "" if entry.level == "Ok" else " open"
        head = f"{_sign(entry.level)} <b>{escape(entry.name)}</b>{topic}: {entry.level}"
        rows.append(f"<details{state}><summary>{head}</summary>{lines}</details>")
    return f'<div style="line-height:1.5">{"".join(rows)}</div>'


def _sign(level: str) -> str:
    return f'<span style="color:{COLOURS[level]};font-weight:bold">{SIGNS[level]}</span>'
