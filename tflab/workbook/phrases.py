"""Keep the texts that `check` and the cells beside it print; what is wrong with an answer is in `diagnosis`."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from ..text import Text, Texts

__all__ = ["PHRASES", "points", "show_points"]

PHRASES: Mapping[str, Text] = Texts(str(Path(__file__)))  # used by the modules of this package and its subpackages


def points(value: float) -> str:
    """Return points as people write them: 2.5, 3."""
    return f"{value:.2f}".rstrip("0").rstrip(".")


def show_points(earned: float, of: float) -> Text:
    """Return the points that were earned, and all that can be: "1.57/3 points"."""
    return PHRASES["point" if of == 1 else "points"].filled(points=f"{points(earned)}/{points(of)}")
