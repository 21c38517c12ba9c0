"""Name the misconceptions that the mistakes of several tasks have in common, by code: M1 to M15."""

from __future__ import annotations

from ...text import Texts

__all__ = ["MISCONCEPTIONS"]

MISCONCEPTIONS = Texts(__file__)
