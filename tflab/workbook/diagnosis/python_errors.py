"""Find what one of Python's or tf2's own errors means in the code of a learner.

    map_T_base @ odom_T_base.inverse    TypeError: unsupported operand type(s) for @: 'Transform' and 'method'
                                        a method was not called: its brackets are missing

`python_errors.yaml` lists patterns of "class: text", from the special to the general, each with what it means.
"""

from __future__ import annotations

import re
from collections.abc import Mapping

from ...text import Text, Texts

__all__ = ["TIPS", "python_error_hint"]

TIPS: Mapping[str, Text] = Texts(__file__)  # by regular expression; the first that matches counts
NO_TIP = Text("", "")
LONGEST = 500  # characters of an error that are compared


def python_error_hint(error: str, text: str) -> Text:
    """Return what one of Python's errors means, or an empty text.

    Args:
        error: the name of its class.
        text: its message.
    """
    said = f"{error}: {text}"[:LONGEST]
    return next((tip for pattern, tip in TIPS.items() if re.match(pattern, said, re.DOTALL)), NO_TIP)
