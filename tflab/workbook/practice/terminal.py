"""How does a question look in a terminal?  Its Markdown as plain text, wrapped at words, Korean unbroken.

```
## E3.2 · A corner                  E3.2 · A corner
The laser is **turned** ...   -->   The laser is turned ...
- **a** Obstacles come ...          - a Obstacles come from the
                                      laser; paint them ...
```
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from unicodedata import east_asian_width

__all__ = ["as_text"]

HEADING = re.compile(r"#+ +")
LINK = re.compile(r"(?<!!)\[([^\]]+)\]\([^)]*\)")
BOLD = re.compile(r"\*\*(.+?)\*\*")
TAG = re.compile(r"</?(?:details|summary|br|b|i|small|sub|sup|span|abbr)\b[^>]*>")
ITEM = re.compile(r" *(?:[-*]|\d+\.) +")
FENCE = "```"


def as_text(markdown: str, width: int = 80) -> str:
    """Return Markdown as a terminal shows it; what stands in a fence stays as it is."""
    lines: list[str] = []
    fenced = False
    for line in markdown.splitlines():
        if line.strip().startswith(FENCE):
            fenced = not fenced
        elif fenced or line.startswith(("|", "    ")):
            lines.append(line if line.startswith(("|", "    ")) else f"    {line}")
        else:
            lines += _wrapped(_plain(line), width)
    return "\n".join(lines).strip("\n")


def _plain(line: str) -> str:
    line = TAG.sub("", HEADING.sub("", line, count=1) if line.startswith("#") else line)
    return BOLD.sub(r"\1", LINK.sub(r"\1", line))


def _wrapped(line: str, width: int) -> Iterator[str]:
    """Yield a line in pieces that fit, what follows an item's mark below its text."""
    mark = ITEM.match(line)
    indent = " " * (mark.end() if mark else 0)
    held, empty = (mark[0] if mark else ""), True
    for word in line[len(held) :].split():
        if not empty and _width(held) + 1 + _width(word) > width:
            yield held
            held, empty = indent, True
        held, empty = (held if empty else held + " ") + word, False
    yield held


def _width(text: str) -> int:
    return sum(2 if east_asian_width(letter) in "WF" else 1 for letter in text)
