"""Show a picture for each step of a slider, for pages without a kernel.

A `Film` is drawn while a page is built and needs nobody to draw for it later. It is larger than
the panel that it replaces, and has one control.
"""

from __future__ import annotations

import struct
from collections.abc import Sequence
from pathlib import Path

from .libraries import anywidget, traitlets

STATIC = Path(__file__).parent / "static"


def javascript(*names: str) -> str:
    """Return files of ours one after the other: a page loads one module for each widget."""
    return "".join((STATIC / f"{name}.js").read_text(encoding="utf-8") for name in names)


class Film(anywidget.AnyWidget):
    """Pictures (PNG) to go through with a scrubber, each with the text that stands beside it.

    Args:
        pictures: one for each step, all of one size.
        texts: what the scrubber stands at, such as "speed = 0.50 m/s".
        words: each picture in words, for whoever cannot see it.
        size_px: how large a picture stands on the page: width, height.
        start: the step to begin with.
    """

    _esm = javascript("scrubber", "film")
    _css = STATIC / "scene.css"
    pictures = traitlets.Bytes().tag(sync=True)
    texts = traitlets.List(traitlets.Unicode()).tag(sync=True)
    words = traitlets.List(traitlets.Unicode()).tag(sync=True)
    width = traitlets.Int().tag(sync=True)
    position = traitlets.Float().tag(sync=True)

    def __init__(
        self,
        pictures: Sequence[bytes],
        texts: Sequence[str],
        words: Sequence[str],
        size_px: tuple[int, int],
        start: int = 0,
    ) -> None:
        if not len(pictures) == len(texts) == len(words) > start:
            raise ValueError(
                f"a film needs one text and some words for each picture, and a start among them: it has "
                f"{len(pictures)} pictures, {len(texts)} texts, {len(words)} words and start {start}"
            )
        packed = b"".join(struct.pack("<I", len(picture)) + picture for picture in pictures)
        super().__init__(pictures=packed, texts=list(texts), words=list(words), width=size_px[0], position=start)
