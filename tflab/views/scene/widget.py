"""Show a 3D scene in the page without a server: a meshcat window inside a widget.

    scene["robot/base"].set_object(...)          browser
        |                                          ^  turn, zoom, click, scrub
        v                                          |
    Scene --- commands, through the page's own channel ---> scene.js + meshcat's viewer
        \\--- the last word on everything (state) ---> late views, reloads, exported pages

`Scene()` takes ordinary meshcat code, and the `draw_...` functions of
`drawing.py` put frames, scans and robots into it.  No process and no port
is opened: everything travels the way a slider's value does, so it works wherever
sliders work.  All views of a page share one WebGL context.

A slider's callback may run in another thread while a cell runs, so everything
that changes the scene goes through one lock: `with scene.redraw(): ...` also
sends what is drawn inside it as one message, which the browser draws at once.

(https://github.com/meshcat-dev/meshcat-python; https://anywidget.dev)
"""

from __future__ import annotations

import gzip
import warnings
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from functools import lru_cache
from importlib.util import find_spec
from pathlib import Path
from threading import RLock
from typing import TYPE_CHECKING, Any
from weakref import WeakSet

from .. import style
from ..libraries import anywidget, ipywidgets, traitlets
from ..slider_frames import STATIC, javascript
from .shapes import grid
from .state import SceneState, describe, joined, pack, plain, with_stable_ids

if TYPE_CHECKING:
    import numpy as np
    from ipywidgets import Dropdown
    from meshcat import Visualizer
    from meshcat.animation import Animation

COMMANDS_BETWEEN_SNAPSHOTS = 500  # what a browser has to remember while a slider is dragged


class ViewerAsset(anywidget.AnyWidget):
    """meshcat's viewer on its way to the browser: once for all scenes, and never displayed itself."""

    _esm = "export default { render() {} };"
    viewer_gz = traitlets.Bytes().tag(sync=True)


class Scene(anywidget.AnyWidget):
    """A 3D view that a cell can show: `scene["robot/base"].set_object(...)`.

    Args:
        height_px: how tall it stands on the page; it is as wide as the page.
        grid_m: the side of the ground grid's cells [m]; 0 for no grid.
        grid_cells: how many of them the ground is long and wide, as in RViz.
        looks_at_origin: whether the origin stays in the middle of the picture, as in RViz; else it is what is there.

    Attributes:
        picked: the name of the frame that was clicked on, "" for none.
        position: where the scrubber stands: seconds of an animation, or a step of a sweep.
        controls: the menu that is followed, if one is.
    """

    _esm = javascript("near", "renderer", "labels", "camera", "scrubber", "ahead", "pointer", "scene")
    _css = STATIC / "scene.css"
    asset = traitlets.Instance(ViewerAsset).tag(sync=True, **ipywidgets.widget_serialization)
    scene = traitlets.Bytes(b"").tag(sync=True)
    description = traitlets.Unicode("").tag(sync=True)
    height_px = traitlets.Int(420).tag(sync=True)
    picked = traitlets.Unicode("").tag(sync=True)
    position = traitlets.Float(0.0).tag(sync=True)
    looks_at_origin = traitlets.Bool(False).tag(sync=True)
    controls = traitlets.List().tag(sync=True, **ipywidgets.widget_serialization)

    def __init__(
        self, height_px: int = 420, grid_m: float = 1.0, grid_cells: int = 10, looks_at_origin: bool = False
    ) -> None:
        self._lock = RLock()
        self._state = SceneState()
        self._pending: list[bytes] = []  # drawn, but not yet sent
        self._depth = 0  # of nested redraws
        self._flushed = 0  # how many commands the `scene` trait knows of
        self._recording: list[dict] | None = None
        self._draw_choice: Callable[[int], object] | None = None
        super().__init__(asset=_asset(), height_px=height_px, looks_at_origin=looks_at_origin)
        self.visualizer = _visualizer(_Window(self._hear))
        if grid_m > 0.0:
            self["/Grid"].set_object(grid(grid_m, grid_cells))
        self.on_msg(self._answer)
        _flush_after_cells(self)

    # -- ordinary meshcat -------------------------------------------------

    def __getitem__(self, path: str) -> Visualizer:
        """Return the part of the scene at `path`, as meshcat does."""
        return self.visualizer[path]

    @property
    def path(self) -> Any:
        """Where the scene begins in meshcat's tree, for `Animation.at_frame`."""
        return self.visualizer.path

    def set_object(self, geometry: Any, material: Any = None) -> None:
        self.visualizer.set_object(geometry, material)

    def set_transform(self, matrix: np.ndarray) -> None:
        self.visualizer.set_transform(matrix)

    def set_property(self, key: str, value: Any) -> None:
        self.visualizer.set_property(key, value)

    def set_animation(self, animation: Animation, play: bool = True, repetitions: int = 1) -> None:
        """Give the scene an animation, and its views a scrubber; `play` starts it in views that are open by now."""
        self.visualizer.set_animation(animation, play=play, repetitions=repetitions)

    def delete(self) -> None:
        """Take everything out of the scene but the grid and the lights."""
        self.visualizer.delete()

    # -- ours -------------------------------------------------------------

    @contextmanager
    def redraw(self) -> Iterator[Scene]:
        """Hold the scene for one thread, and send what it draws as one message."""
        with self._lock:
            self._depth += 1
            try:
                yield self
            finally:
                self._depth -= 1
                if self._depth == 0:
                    self._send_pending()

    def look(self, eye: Sequence[float], target: Sequence[float] = (0.0, 0.0, 0.0)) -> None:
        """Look from `eye` (x, y, z) [m] at `target` (x, y, z) [m]; without it the view looks at everything."""
        self._tell({"type": "look", "path": "", "eye": eye, "target": target})

    def sweep(
        self,
        name: str,
        values: Sequence[float] | Sequence[str],
        draw: Callable[[Any], object],
        unit: str = "",
        start: int = 0,
    ) -> None:
        """Draw the scene for each of `values` now, and give its view a scrubber to go through them.

        `draw(value)` draws into this scene.  Its steps are stored in the page, so the
        scrubber answers at once and still works where there is no kernel.
        """
        with self.redraw():
            steps = _without_repeats([self._recorded(draw, value) for value in values])
            draw(values[start])
            texts = [f"{name} = {_in_words(value)} {unit}".strip() for value in values]
            self._tell({"type": "sweep", "path": "", "texts": texts, "steps": steps, "start": start})

    def follow(self, menu: Dropdown, draw: Callable[[int], object]) -> None:
        """Let what is chosen from `menu` be seen before the kernel has drawn it.

        `draw(i)` draws the i-th choice into this scene.  When a hand comes near the menu, all
        choices are drawn and sent, and the browser shows the one that is then made.  It stays
        the caller's to draw it, too: that is what counts.  Call it again when a choice has come
        to look otherwise.
        """
        with self._lock:
            self.controls, self._draw_choice = [menu], draw
            self.send({"type": "ahead"}, [])  # what the browser may have is of before

    def describe(self) -> str:
        """Return the scene in words: what a screen reader or a terminal gets."""
        return describe(self._state)

    def flush(self) -> None:
        """Write down the whole scene for views that open later."""
        with self._lock:
            if self._flushed != self._state.count:
                self._flushed = self._state.count
                self.description = self.describe()
                self.scene = self._state.packed()

    def get_state(self, key: Any = None, drop_defaults: bool = False) -> dict:
        if hasattr(self, "visualizer"):  # not while the widget is being made
            self.flush()
        return super().get_state(key=key, drop_defaults=drop_defaults)

    def _repr_mimebundle_(self, **kwargs: Any) -> tuple[dict, dict] | None:
        bundle = super()._repr_mimebundle_(**kwargs)
        if bundle is not None:
            bundle[0]["text/plain"] = self.describe()
        return bundle

    # -- inside -----------------------------------------------------------

    def _hear(self, command: Any) -> None:
        """Take a command of meshcat's."""
        self._tell(command.lower())

    def _tell(self, command: dict) -> None:
        command = plain(command)
        if command["type"] == "set_object":
            command = with_stable_ids(command, command["path"])
        with self.redraw():
            if self._recording is not None:
                self._recording.append(command)
                return
            if self._state.is_redundant(command):
                return
            packed = pack(command)
            self._state.apply(command, packed)
            self._pending.append(packed)

    def _recorded(self, draw: Callable[[Any], object], value: float | str) -> list[dict]:
        self._recording = []
        try:
            draw(value)
            return self._recording
        finally:
            self._recording = None

    def _answer(self, _widget: Scene, message: dict, _buffers: object) -> None:
        """Send what each choice looks like: a hand is near."""
        if message.get("type") != "hand" or self._draw_choice is None:
            return
        with self.redraw():
            (menu,) = self.controls
            steps = _without_repeats([self._recorded(self._draw_choice, i) for i in range(len(menu.options))])
            self.send({"type": "ahead"}, [joined(len(step), map(pack, step)) for step in steps])

    def _send_pending(self) -> None:
        pending, self._pending = self._pending, []
        if not pending:
            return
        at = [menu.index for menu in self.controls]
        self.send({"type": "commands", "last": self._state.count, "at": at}, pending)
        if self._state.count - self._flushed > COMMANDS_BETWEEN_SNAPSHOTS:
            self.flush()


class _Window:
    """What meshcat talks to instead of its server."""

    web_url = None

    def __init__(self, hear: Callable[[Any], None]) -> None:
        self.send = hear

    def open(self) -> None:
        """Do nothing: a scene opens where a cell shows it."""

    def wait(self) -> str:
        """Wait for nothing: what is drawn is kept until somebody looks."""
        return "ok"


def _in_words(value: float | str) -> str:
    return value if isinstance(value, str) else style.fmt(value, "", 2)


def _without_repeats(steps: list[list[dict]]) -> list[list[dict]]:
    """Return the steps of a sweep without the commands that all of them share."""
    shared = set.intersection(*[{pack(command) for command in step} for step in steps])
    return [[command for command in step if pack(command) not in shared] for step in steps]


def viewer_file() -> Path:
    """Return meshcat's viewer, one file of JavaScript that brings its own three.js.

    Raises:
        ImportError: meshcat is not installed.
    """
    spec = find_spec("meshcat")
    if spec is None or spec.origin is None:
        raise ImportError("3D scenes need meshcat: pip install meshcat")
    return Path(spec.origin).parent / "viewer" / "dist" / "main.min.js"


def _visualizer(window: _Window) -> Visualizer:
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # meshcat's import speaks of pyzmq, which is not used here
        import meshcat
    return meshcat.Visualizer(window=window)


@lru_cache(1)
def _viewer_gz() -> bytes:
    return gzip.compress(viewer_file().read_bytes(), 9, mtime=0)


_assets: list[ViewerAsset] = []


def _asset() -> ViewerAsset:
    """Return the one asset of this kernel; another if somebody has closed it."""
    if not _assets or _assets[-1].comm is None:
        _assets[:] = [ViewerAsset(viewer_gz=_viewer_gz())]
    return _assets[-1]


_scenes: WeakSet[Scene] = WeakSet()


def _flush_after_cells(scene: Scene) -> None:
    """Have the scene written down whenever a cell has run."""
    from IPython import get_ipython

    shell = get_ipython()
    if shell is not None:
        shell.events.register("post_run_cell", _flush_all)  # IPython keeps each function once
    _scenes.add(scene)


def _flush_all(_result: object) -> None:
    for scene in list(_scenes):
        if scene.comm is not None:
            scene.flush()
