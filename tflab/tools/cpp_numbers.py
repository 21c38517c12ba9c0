"""Read and write numbers as C++ does, for tools that are written in C++.

    stod("1abc")  ->  1.0, and three characters are left over
    stod("abc")   ->  an error

`static_transform_publisher --x 1abc` therefore publishes 1 m, and nobody says a
word.
"""

from __future__ import annotations

import re

__all__ = ["general", "stod"]

_NUMBER = re.compile(
    r"\s*[+-]?(inf(inity)?|nan|0x([0-9a-f]+\.?[0-9a-f]*|\.[0-9a-f]+)(p[+-]?\d+)?|(\d+\.?\d*|\.\d+)(e[+-]?\d+)?)", re.I
)


def stod(text: str) -> tuple[float, bool]:
    """Return the number that `text` begins with, and whether that is all of it.

    Raises:
        ValueError: it does not begin with a number.
    """
    match = _NUMBER.match(text)
    if match is None:
        raise ValueError(f"stod: no number at the beginning of {text!r}")
    digits = match.group().strip()
    value = float.fromhex(digits) if "x" in digits.lower() else float(digits)
    return value, match.end() == len(text)


def general(value: float) -> str:
    """Return a number as `std::cout` prints it: six digits, and an exponent where that is shorter."""
    return f"{value:g}"
