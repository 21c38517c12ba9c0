"""What do all panels share?  Controls above, a picture below, and the same in words on request.

    speed  ----o---  1.00 m/s   delay  --o---  0.20 s
    +-----------------------------+
    |           picture           |      [as text]
    +-----------------------------+

A page that is exported has no kernel to redraw for it.  While it is built, with
TFLAB_FILMS=1, a panel shows itself as a film: drawn for every place of its first
slider, the other controls standing still.

All controls can be reached and moved with the keyboard: Tab goes from one to the
next, the arrow keys move a slider.

Read `words.py` next.
"""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Sequence
from html import escape

import ipywidgets as widgets
import numpy as np

from ..film import Film
from ..picture import Picture
from .words import said

FILM_STEPS = 13
PANEL_WIDTH = "780px"  # of the picture, and two sliders
SLIDER_WIDTH = "376px"
STEP_RAD = math.pi / 36.0  # 5 degrees a key: a quarter turn is 18 of them


class Panel:
    """Controls, a picture that follows them, and the same in words.

    Attributes:
        picture: what is moved.
        controls: by their description.
        widget: what Jupyter shows.
    """

    def __init__(
        self,
        title: str,
        picture: Picture,
        controls: Sequence[widgets.ValueWidget],
        move: Callable[[], object],
        layout: Sequence[widgets.Widget] | None = None,
        language: str = "en",
    ) -> None:
        """Make a panel.

        Args:
            title: what it is, for whoever hears it: it names the button that shows the words.
            controls: whatever changes the picture.
            move: moves the picture to where the controls are.
            layout: the controls as they should stand, if not side by side where there is room.
            language: of the button that shows the words, "en" or "ko".
        """
        self.picture = picture
        self.controls = {control.description: control for control in controls}
        self._move = move
        width, height = picture.size_px
        self._image = widgets.Image(format="png", width=width, height=height)  # a tooltip would break it in JupyterLab
        self._image.layout.max_width = "100%"
        self._image.layout.object_fit = "contain"
        self._as_text = widgets.ToggleButton(
            description=said("as text", language), tooltip=f"{title}: {said('the same in words', language)}"
        )
        self._words = widgets.HTML()
        self._words.layout.display = "none"
        self.widget = widgets.VBox([*(layout or [side_by_side(controls)]), self._image, self._as_text, self._words])
        for control in controls:
            control.observe(self._on_change, names="value")
        self._as_text.observe(self._on_as_text, names="value")
        self.redraw()

    @property
    def text(self) -> str:
        """What the picture shows, in words."""
        return self.picture.text

    def redraw(self) -> None:
        """Move the picture to where the controls are, and show it."""
        self._move()
        self._image.value = self.picture.live_png()
        if self._as_text.value:
            self._words.value = f"<pre>{escape(self.text)}</pre>"

    def film(self, steps: int = FILM_STEPS) -> widgets.VBox | None:
        """Return the panel as it lives on without a kernel: along its slider, or its longest menu; None without one."""
        controls = self.controls.values()
        along = next((control for control in controls if isinstance(control, widgets.FloatSlider)), None)
        menus = [control for control in controls if isinstance(control, widgets.Dropdown)]
        if along is not None:
            values = np.unique([*np.linspace(along.min, along.max, steps), along.value]).tolist()
            named = [(format(value, along.readout_format), value) for value in values]
            others = [control for control in controls if control is not along]
        elif menus:
            along = max(menus, key=lambda menu: len(menu.options))
            named = [each if isinstance(each, tuple) else (each, each) for each in along.options]
            others = []  # what the other menus say goes along with it
        else:
            return None
        before = along.value
        pictures, texts, words = [], [], []
        for name, value in named:
            along.value = value
            pictures.append(self.picture.live_png())
            texts.append(f"{along.description}: {name}")
            words.append(self.text)
        along.value = before
        start = [value for _, value in named].index(before)
        return widgets.VBox([*others, Film(pictures, texts, words, self.picture.size_px, start=start)])

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

    def _on_change(self, change) -> None:
        self.redraw()

    def _on_as_text(self, change) -> None:
        self._words.layout.display = "block" if change.new else "none"
        self._words.value = f"<pre>{escape(self.text)}</pre>" if change.new else ""

    def _repr_mimebundle_(self, **kwargs):
        shown = (self.film() if os.environ.get("TFLAB_FILMS") else None) or self.widget
        data, metadata = shown._repr_mimebundle_(**kwargs), {}
        return {**data, "text/plain": self.text}, metadata


def slider(
    description: str, value: float, low: float, high: float, step: float, unit: str, language: str = "en"
) -> widgets.FloatSlider:
    """Return a slider from `low` to `high` that says what it is, in which unit, and follows while dragged."""
    description = said(description, language)
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
    description: str, options: Sequence, value: object, tooltip: str, *, label_width: str, width: str
) -> widgets.Dropdown:
    """Return a menu that says what it is, and what choosing does."""
    return widgets.Dropdown(
        options=options,
        value=value,
        description=description,
        tooltip=f"{description}: {tooltip}",
        style={"description_width": label_width},
        layout={"width": width, "max_width": "100%"},
    )


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


def _nothing() -> None:
    """Do nothing: a closed panel has nothing to move."""
