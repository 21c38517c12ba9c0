"""In which other unit might an answer be?  What one unit is in others, by its factor.

asked for [m], answered 2200      2200 / 1000 == 2.2: millimetres
"""

from __future__ import annotations

import math

from ..answers.forms import Angle, Form, Number, Vector

__all__ = ["OTHER_UNITS", "unit_of"]

OTHER_UNITS = {
    "m": {"mm": 1e3, "cm": 1e2, "km": 1e-3},
    "mm": {"m": 1e-3, "cm": 0.1},
    "rad": {"degrees": math.degrees(1.0)},
    "s": {"ns": 1e9, "ms": 1e3, "us": 1e6},
    "ms": {"s": 1e-3, "ns": 1e6},
    "ns": {"s": 1e-9, "ms": 1e-6},
    "m/s": {"mm/s": 1e3, "km/h": 3.6},
    "rad/s": {"degrees/s": math.degrees(1.0)},
}


def unit_of(form: Form) -> str:
    """Return the unit in which a form wants its numbers, or ""."""
    if isinstance(form, Angle):
        return "rad"
    return form.unit if isinstance(form, Number | Vector) else ""
