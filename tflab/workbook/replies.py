"""Texts that `check` and the cells beside it print, besides what is wrong with an answer (`diagnosis/mistake.yaml`)."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from ..text import Text, Texts

__all__ = ["PHRASES"]

PHRASES: Mapping[str, Text] = Texts(str(Path(__file__)))  # used by the modules of this package and its subpackages
