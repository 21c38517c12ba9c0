"""What of a notebook does grading never read?  Outputs, attachments, the state of widgets: dropped before all limits.

    "outputs": [{"data": {"image/png": "iVBOR... 40 MB"}}]      "outputs": []
    "attachments": {...}, "widgets": {...}                      {}, {}

They are cut out of the text, by its brackets and its strings, before any of it is
parsed (a scanner): so a large honest notebook is as small as what its author wrote.
"""

from __future__ import annotations

import re

__all__ = ["strip_outputs"]

UNREAD = {'"outputs"', '"attachments"', '"widgets"'}
# A string that nobody closed ends with the text: else each of its quotes is one more beginning, in a text without end.
TOKEN = re.compile(r'"[^"\\]*(?:\\.[^"\\]*)*(?:"|\\?\Z)|[\[\]{}]', re.DOTALL)
EMPTY = {"[": "[]", "{": "{}"}


def strip_outputs(text: str) -> str:
    """Return a notebook's JSON with what nobody reads emptied; what is no JSON comes back as it was."""
    kept: list[str] = []
    begin, depth = 0, 0  # of what is kept next; of the brackets that are being dropped
    key_end = -1
    for match in TOKEN.finditer(text):
        token = match[0]
        if depth:
            depth += (token in EMPTY) - (token in ("]", "}"))
            begin = match.end()
        elif token in EMPTY and key_end >= 0 and text[key_end : match.start()].strip() == ":":
            kept += [text[begin : match.start()], EMPTY[token]]
            depth = 1
        key_end = match.end() if token in UNREAD and not depth else -1
    return text if depth else "".join([*kept, text[begin:]])
