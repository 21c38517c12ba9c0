"""What are our report pages made of?  Texts, tables, figures; the frame around them is that of all reports.

Whatever comes from a submission or a roster passes `text`, and is a text then and
nothing else.
"""

from __future__ import annotations

import html
import re
from base64 import b64encode
from collections.abc import Iterable, Sequence
from typing import Any

from tflab.views.report_page import report_page

__all__ = ["figure", "page", "points", "prose", "rows", "text"]

STYLE = """
p { margin: .4rem 0; } .quiet { color: var(--quiet); }
table { border-collapse: collapse; width: 100%; margin: .6rem 0; table-layout: fixed; }
th, td { text-align: left; vertical-align: top; padding: .45rem .7rem .45rem 0; border-bottom: 1px solid var(--line); }
th { font-weight: 600; color: var(--quiet); font-size: .88rem; }
td.number, th.number { text-align: right; white-space: nowrap; font-variant-numeric: tabular-nums; }
td.mark { white-space: nowrap; font-weight: 600; }
code { font-size: .92em; background: var(--card); padding: 0 .2em; border-radius: .2em; }
pre { white-space: pre-wrap; font-size: .88rem; }
.total { font-size: 2rem; font-weight: 650; font-variant-numeric: tabular-nums; }
.card { background: var(--card); border-radius: .6rem; padding: .8rem 1.1rem; margin: .8rem 0; }
"""


def text(words: Any) -> str:
    """Return words as they can stand in a page, whatever is in them."""
    clean = "".join(letter if letter.isprintable() or letter == "\n" else "\ufffd" for letter in str(words))
    return html.escape(clean, quote=True)


def page(title: str, language: str, body: Iterable[str]) -> str:
    """Return a whole page; `body` is HTML already, `title` is not."""
    return report_page(title, language, body, STYLE)


def figure(png: bytes, words: str, width_px: int, in_words: str) -> str:
    """Return a picture with the same in words, for whoever cannot see it."""
    source = f"data:image/png;base64,{b64encode(png).decode()}"
    return (
        f'<figure><img src="{source}" width="{width_px}" alt="{text(words)}">'
        f"<details><summary>{text(in_words)}</summary><pre>{text(words)}</pre></details></figure>"
    )


def prose(words: str) -> str:
    """Return a text of ours, with `code` and *stress* in it, as HTML; a word it begins with has a capital."""
    if re.match(r"[a-z]+\s", words):
        words = words[0].upper() + words[1:]
    marked = re.sub(r"`([^`]+)`", r"<code>\1</code>", text(words))
    return re.sub(r"(?<![\w*])\*([^*\s][^*]*)\*(?![\w*])", r"<em>\1</em>", marked)


def rows(
    heads: Sequence[str], cells: Iterable[Sequence[str]], *, numbers: Sequence[int] = (), widths: Sequence[int] = ()
) -> str:
    """Return a table; cells are HTML already, `numbers` are the columns set right, `widths` are shares [%]."""

    def kind(column: int) -> str:
        return ' class="number"' if column in numbers else ""

    columns = "".join(f'<col style="width:{width}%">' for width in widths)
    head = "".join(f"<th{kind(column)}>{text(name)}</th>" for column, name in enumerate(heads))
    body = ("".join(f"<td{kind(column)}>{cell}</td>" for column, cell in enumerate(row)) for row in cells)
    rows_of_body = "".join(f"<tr>{row}</tr>" for row in body)
    return f"<table>{columns}<thead><tr>{head}</tr></thead><tbody>{rows_of_body}</tbody></table>"


def points(value: float) -> str:
    """Return points as people write them: 2.5, 3."""
    return f"{value:.2f}".rstrip("0").rstrip(".")
