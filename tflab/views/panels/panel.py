"""Share what all panels have: controls above, a picture below, and its text on request.

    speed  ----o---  1.00 m/s   delay  --o---  0.20 s
    +-----------------------------+
    |           picture           |      [as text]
    +-----------------------------+

While a page is built for export (TFLAB_FILMS=1), a panel shows itself as slider frames: drawn for
every position of its first slider. All controls can be reached and moved with the keyboard. Texts
are in the language of the learner's copy, and in English outside a copy. Names of frames, joints
and ROS 2 options are the same in both languages.
"""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Sequence
from html import escape

import numpy as np

from tflab.text import Text, Texts, language_of_workbook

from ..libraries import ipywidgets as widgets
from ..picture import Picture
from ..slider_frames import Film
from .prefetch import Controls, Drawing, DrawnAhead, place_of

TEXTS = Texts(__file__)

FILM_STEPS = 13
PANEL_WIDTH = "780px"  # of the picture, and two sliders
SLIDER_WIDTH = "376px"
STEP_RAD = math.pi / 36.0  # 5 degrees a key: a quarter turn is 18 of them


class Panel:
    """Controls, a picture that follows them, and its text.

    Attributes:
        picture: what is moved.
        shown: the picture in the page.
        controls: by their description.
        widget: what Jupyter shows.
    """

    def __init__(
        self,
        title: Text | str,
        picture: Picture,
        controls: Sequence[widgets.ValueWidget],
        move: Callable[[Controls], object],
        layout: Sequence[widgets.Widget] | None = None,
    ) -> None:
        """Make a panel.

        Args:
            title: what it is, for whoever hears it: it names the button that shows the words.
            controls: whatever changes the picture.
            move: moves the picture to where the controls are, or could be; it changes nothing else.
            layout: the controls as they should stand, if not side by side where there is room.
        """
        self.picture = picture
        self.controls = {control.description: control for control in controls}
        self._move = move
        self.shown = DrawnAhead(controls, picture.size_px, self._draw)
        same = say(TEXTS["the same in words"])
        self._as_text = widgets.ToggleButton(description=say(TEXTS["as text"]), tooltip=f"{say(title)}: {same}")
        self._words = widgets.HTML()
        self._words.layout.display = "none"
        self.widget = widgets.VBox([*(layout or [side_by_side(controls)]), self.shown, self._as_text, self._words])
        self.widget.add_class("tflab-panel")
        for control in controls:
            control.observe(self._on_change, names="value")
        self._as_text.observe(self._on_as_text, names="value")
        self.redraw()

    @property
    def text(self) -> str:
        """What the picture shows, in words."""
        return self.shown.description

    def redraw(self) -> None:
        """Draw what is to be seen where the controls are, and show it."""
        self._show(anew=True)

    def _show(self, moved: widgets.ValueWidget | None = None, anew: bool = False) -> None:
        self.shown.show(moved, anew)
        if self._as_text.value:
            self._words.value = f"<pre>{escape(self.text)}</pre>"

    def film(self, steps: int = FILM_STEPS) -> widgets.VBox | None:
        """Return the panel as it lives on without a kernel: along its slider, or its longest menu; None without one."""
        controls = list(self.controls.values())
        along = _filmed(controls)
        if along is None:
            return None
        is_menu = isinstance(along, widgets.Dropdown)
        others = [] if is_menu else [control for control in controls if control is not along]  # menus go along with it
        places, moved = [place_of(control) for control in controls], controls.index(along)
        start, stations = place_of(along), _stations(along, steps)
        drawings = [self.shown.drawing([*places[:moved], place, *places[moved + 1 :]], moved) for _, place in stations]
        film = Film(
            [drawing.png for drawing in drawings],
            [f"{along.description}: {name}" for name, _ in stations],
            [drawing.words for drawing in drawings],
            self.picture.size_px,
            start=[place for _, place in stations].index(start),
        )
        return widgets.VBox([*others, film])

    def close_with_its_cell(self) -> None:
        """Go, because the cell that showed the panel runs again and shows another."""
        self.close()

    def close(self) -> None:
        """Take the panel off the page and free its picture."""
        for control in self.controls.values():
            control.unobserve_all()
        self._as_text.unobserve_all()
        _close_all(self.widget)
        self.picture.figure.clear()
        self.picture.redraw_all()
        self._move = _nothing

    def _draw(self, at: Controls) -> Drawing:
        self._move(at)
        return Drawing(self.picture.live_png(), self.picture.text)

    def _on_change(self, change) -> None:
        self._show(change.owner)

    def _on_as_text(self, change) -> None:
        self._words.layout.display = "block" if change.new else "none"
        self._words.value = f"<pre>{escape(self.text)}</pre>" if change.new else ""

    def _repr_mimebundle_(self, **kwargs):
        shown = (self.film() if os.environ.get("TFLAB_FILMS") else None) or self.widget
        data, metadata = shown._repr_mimebundle_(**kwargs), {}
        return {**data, "text/plain": self.text}, metadata


def _filmed(controls: Sequence[widgets.ValueWidget]) -> widgets.FloatSlider | widgets.Dropdown | None:
    """Return the first slider; where there is none, the longest menu."""
    sliders = [control for control in controls if isinstance(control, widgets.FloatSlider)]
    menus = [control for control in controls if isinstance(control, widgets.Dropdown)]
    return sliders[0] if sliders else max(menus, key=lambda menu: len(menu.options), default=None)


def _stations(control: widgets.FloatSlider | widgets.Dropdown, steps: int) -> list[tuple[str, float]]:
    """Return names and places along a slider, where it stands among them, or those of a menu's options."""
    if isinstance(control, widgets.Dropdown):
        return [(each[0] if isinstance(each, tuple) else each, i) for i, each in enumerate(control.options)]
    values = np.unique([*np.linspace(control.min, control.max, steps), control.value]).tolist()
    return [(format(value, control.readout_format), value) for value in values]


def slider(
    description: Text | str, value: float, low: float, high: float, step: float, unit: str
) -> widgets.FloatSlider:
    """Return a slider from `low` to `high` that says what it is, in which unit, and follows while dragged."""
    description = say(description)
    digits = 2 if step >= 0.01 else 3
    return widgets.FloatSlider(
        value=value,
        min=low,
        max=high,
        step=step,
        description=f"{description} [{unit}]",
        tooltip=f"{description}, {low:g} … {high:g} {unit}",
        readout_format=f".{digits}f",
        continuous_update=True,
        style={"description_width": "110px"},
        layout={"width": SLIDER_WIDTH, "max_width": "100%"},
    )


def menu(
    description: Text | str,
    options: Sequence,
    value: object = None,
    hint: Text | str = "",
    label_width: str = "110px",
    width: str = SLIDER_WIDTH,
) -> widgets.Dropdown:
    """Return a menu that names what is chosen; its tooltip adds the `hint`. Without a `value`, the first is chosen."""
    name = say(description)
    control = widgets.Dropdown(
        options=options,
        description=name,
        tooltip=f"{name}: {say(hint)}" if hint else name,
        style={"description_width": label_width},
        layout={"width": width, "max_width": "100%"},
    )
    if value is not None:
        control.value = value
    return control


def say(text: Text | str) -> str:
    """Return a text in the reader's language; a name, which is the same in all, stays as it is."""
    return text.say(language_of_workbook()) if isinstance(text, Text) else text


def side_by_side(controls: Sequence[widgets.Widget]) -> widgets.Box:
    """Return controls in rows, so that they and the picture below them fit a laptop's window."""
    return widgets.Box(list(controls), layout={"flex_flow": "row wrap", "max_width": PANEL_WIDTH})


def _close_all(widget: widgets.DOMWidget) -> None:
    """Close a widget, its children, and its layout and style, which are widgets too."""
    for child in getattr(widget, "children", ()):
        _close_all(child)
    for name in ("style", "layout"):
        if hasattr(widget, name):
            getattr(widget, name).close()
    widget.close()


def _nothing(at: Controls) -> None:
    """Do nothing: a closed panel has nothing to move."""
