"""Draw the next pictures of a panel before they are requested (prefetching).

    the pointer comes near a slider   -->   its positions, the nearest first:  o o o o (o) o o o o
    the slider moves                  -->   the browser has that drawing, and shows it
                                      `->   the kernel receives the position too

A request, a drawing and a reply take longer than a hand does on a busy machine. The browser asks
for drawings while nobody waits, and they are made one at a time, between incoming messages, and
kept up to a number. JupyterLab delivers some messages in a thread of their own, so a picture is
moved, drawn and read under one lock. The browser's half is `static/follow.js`.
"""

from __future__ import annotations

import asyncio
from collections import OrderedDict
from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

from ..libraries import anywidget, traitlets
from ..libraries import ipywidgets as widgets
from ..slider_frames import STATIC, javascript
from ..style import ONE_AT_A_TIME

KEPT = 300  # drawings of one panel, some ten kilobytes each
PAUSE_S = 0.001  # between two drawings, for messages to come in
DIGITS = 6  # of a slider's place: what the browser adds up is off in the last ones


class Drawing(NamedTuple):
    """A picture, as PNG, and the same in words."""

    png: bytes
    words: str


class Controls:
    """Where the controls are, or could be: `at(slider)` is its value.

    Attributes:
        moved: the control that is moved.
    """

    def __init__(self, controls: Sequence[widgets.ValueWidget], places: Sequence[Any], moved: int) -> None:
        self._places = dict(zip(map(id, controls), places, strict=True))
        self.moved = controls[moved] if controls else None

    def __call__(self, control: widgets.ValueWidget) -> Any:
        """Return the value of a control: of a menu, that of the option chosen."""
        place = self._places[id(control)]
        if not hasattr(control, "options"):
            return type(control.value)(place)  # a browser writes 1 for 1.0
        option = control.options[place]
        return option[1] if isinstance(option, tuple) else option


def place_of(control: widgets.ValueWidget) -> Any:
    """Return where a control is: a slider's number, whether a box is ticked, the number of a menu's option."""
    return control.index if hasattr(control, "options") else control.value


class DrawnAhead(anywidget.AnyWidget):
    """A picture that follows controls.

    Attributes:
        png: what is shown.
        description: the same in words; the picture's alternative text.
        at: where the controls are in it, and the number of the one that was moved.
        anew: how often what is drawn came to depend on more than them; what the browser has of before is gone then.
    """

    _esm = javascript("near", "follow")
    _css = STATIC / "scene.css"
    controls = traitlets.List().tag(sync=True, **widgets.widget_serialization)
    png = traitlets.Bytes().tag(sync=True)
    description = traitlets.Unicode().tag(sync=True)
    at = traitlets.Dict().tag(sync=True)
    anew = traitlets.Int().tag(sync=True)
    width = traitlets.Int().tag(sync=True)
    height = traitlets.Int().tag(sync=True)

    def __init__(
        self, controls: Sequence[widgets.ValueWidget], size_px: tuple[int, int], draw: Callable[[Controls], Drawing]
    ) -> None:
        """Make it; `draw` is given where the controls are, and `show` draws for the first time."""
        self._draw = draw
        self._drawn: OrderedDict[tuple, Drawing] = OrderedDict()
        self._wanted: list[tuple[list, int]] = []
        self._is_at_work = False
        width, height = size_px
        super().__init__(controls=list(controls), width=width, height=height)
        self.on_msg(self._hear)

    def show(self, moved: widgets.ValueWidget | None = None, anew: bool = False) -> Drawing:
        """Show where the controls are, and return it; `anew` if what is drawn depends on more than them."""
        number = next((i for i, control in enumerate(self.controls) if control is moved), 0)
        with ONE_AT_A_TIME:
            if anew:
                self._drawn.clear()
            places = [place_of(control) for control in self.controls]
            drawing = self.drawing(places, number)
            with self.hold_sync():
                self.png, self.description = drawing
                self.at = {"places": places, "moved": number}
                self.anew += anew
        return drawing

    def drawing(self, places: Sequence[Any], moved: int) -> Drawing:
        """Return what is to be seen with the controls at `places`, when the one numbered `moved` was moved."""
        key = (moved, *(round(place, DIGITS) for place in places))
        with ONE_AT_A_TIME:
            if key not in self._drawn:
                self._drawn[key] = self._draw(Controls(self.controls, places, moved))
            self._drawn.move_to_end(key)
            if len(self._drawn) > KEPT:
                self._drawn.popitem(last=False)
            return self._drawn[key]

    def close(self) -> None:
        with ONE_AT_A_TIME:
            self._wanted.clear()
            self._drawn.clear()
            self._draw = _nothing
            super().close()

    def _hear(self, _widget: object, message: dict, _buffers: object) -> None:
        """Take what the browser would like to have next; what it wanted before, it wants no longer."""
        if message.get("type") != "want":
            return
        places, moved = message["places"], message["moved"]
        with ONE_AT_A_TIME:
            self._wanted = [
                ([*places[:moved], place, *places[moved + 1 :]], moved) for place in message["missing"][::-1]
            ]
            if self._wanted and not self._is_at_work:
                self._is_at_work = True
                asyncio.get_running_loop().call_soon(self._draw_next)

    def _draw_next(self) -> None:
        """Draw and send one, and come again when whatever else there is has had its turn."""
        with ONE_AT_A_TIME:
            self._is_at_work = bool(self._wanted)
            if not self._wanted:
                return
            places, moved = self._wanted.pop()
            png, words = self.drawing(places, moved)
            self.send({"type": "drawn", "places": places, "moved": moved, "words": words}, [png])
        asyncio.get_running_loop().call_later(PAUSE_S, self._draw_next)


def _nothing(at: Controls) -> Drawing:
    """Draw nothing: a closed panel has nothing to move."""
    return Drawing(b"", "")
