"""What do our report pages have in common?  One file each, light or dark, nothing from elsewhere.

Whatever comes from a submission or a roster passes `text`, and is a text then and
nothing else.  Read `class_figures.py` next.
"""

from __future__ import annotations

import html
import re
from base64 import b64encode
from collections.abc import Iterable, Sequence
from typing import Any

__all__ = ["figure", "page", "points", "prose", "rows", "text"]

STYLE = """
:root { color-scheme: light dark; --ink: #1f2328; --paper: #fdfdfb; --quiet: #5b6168;
  --line: #d5d8dc; --card: #f3f4f2; }
@media (prefers-color-scheme: dark) {
  :root { --ink: #e6e8ea; --paper: #17191c; --quiet: #a3a9b0; --line: #3a3f45; --card: #212428; }
}
body { font: 16px/1.55 system-ui, "Apple SD Gothic Neo", "Malgun Gothic", "Noto Sans KR", sans-serif;
  color: var(--ink); background: var(--paper); max-width: 56rem; margin: 2.5rem auto; padding: 0 1.2rem; }
h1 { font-size: 1.6rem; margin: 0 0 .3rem; } h2 { font-size: 1.2rem; margin: 2.2rem 0 .6rem; }
p { margin: .4rem 0; } .quiet { color: var(--quiet); }
table { border-collapse: collapse; width: 100%; margin: .6rem 0; table-layout: fixed;
  overflow-wrap: anywhere; }
th, td { text-align: left; vertical-align: top; padding: .45rem .7rem .45rem 0; border-bottom: 1px solid var(--line); }
th { font-weight: 600; color: var(--quiet); font-size: .88rem; }
td.number, th.number { text-align: right; white-space: nowrap; font-variant-numeric: tabular-nums; }
td.mark { white-space: nowrap; font-weight: 600; }
figure { margin: .8rem 0; } img { max-width: 100%; height: auto; }
details { color: var(--quiet); } summary { cursor: pointer; }
code { font-size: .92em; background: var(--card); padding: 0 .2em; border-radius: .2em; }
pre { white-space: pre-wrap; font-size: .88rem; }
.total { font-size: 2rem; font-weight: 650; font-variant-numeric: tabular-nums; }
.card { background: var(--card); border-radius: .6rem; padding: .8rem 1.1rem; margin: .8rem 0; }
@media print { body { margin: 0; max-width: none; } details { display: none; } }
"""


def text(words: Any) -> str:
    """Return words as they can stand in a page, whatever is in them."""
    clean = "".join(letter if letter.isprintable() or letter == "\n" else "\ufffd" for letter in str(words))
    return html.escape(clean, quote=True)


def page(title: str, language: str, body: Iterable[str]) -> str:
    """Return a whole page; `body` is HTML already, `title` is not."""
    policy = "default-src 'none'; img-src data:; style-src 'unsafe-inline'"
    return "\n".join(
        [
            "<!DOCTYPE html>",
            f'<html lang="{text(language)}"><head><meta charset="utf-8">',
            f'<meta http-equiv="Content-Security-Policy" content="{policy}">',
            '<meta name="viewport" content="width=device-width, initial-scale=1">',
            f"<title>{text(title)}</title><style>{STYLE}</style></head><body>",
            *body,
            "</body></html>\n",
        ]
    )


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
