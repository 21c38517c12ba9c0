"""Show a reply: as a card in a notebook, as text anywhere else and for screen readers.

    +-----------------------------------------------------------+
    | E3.2 ✗ 0/2 points                                         |
    | "map": You turned the point and forgot the step. Where is |      wrapped at words, code set as code,
    | the laser's own origin, (0, 0, 0), in `base_link`?        |      Korean unbroken
    | hint("E3.2") helps.                                       |
    +-----------------------------------------------------------+

What is said of several parts of an answer stands on a line for each.
The colour at its left says what the sign says: passed, not yet, or neither.
"""

from __future__ import annotations

import html
import re
import sys
from collections.abc import Sequence
from typing import Any

from ..text import capitalized

__all__ = ["as_html", "in_notebook", "shell", "show_caption", "show_page", "show_reply"]

CODE = re.compile(r"`([^`\n]+)`")
STRESSED = re.compile(r"(?<![\w*])\*([^\s*][^*\n]*)\*(?![\w*])")
CALL = re.compile(r"\b[a-z_][\w.]*\((?:[^()\n]|\([^()\n]*\))*\)")
PART = re.compile(r'(?<=[.?!)])\s(?="[^"\n]+"(?:, "[^"\n]+")*: )')  # what is said of a part begins with its name
COLOURS = {  # JupyterLab's own, so that they suit its theme
    "passed": "var(--jp-success-color1, #388e3c)",
    "wrong": "var(--jp-warn-color1, #f57c00)",
    "said": "var(--jp-border-color1, #bdbdbd)",
}
CARD = (
    "border-left: 0.3em solid {colour}; padding: 0.35em 0 0.35em 0.9em; margin: 0.3em 0; max-width: 46em; "
    "word-break: keep-all; overflow-wrap: anywhere; line-height: 1.5; "
    "font-family: var(--jp-content-font-family, sans-serif); font-size: var(--jp-content-font-size1, 14px)"
)


def show_reply(head: str, said: str = "", more: Sequence[str] = (), kind: str = "said") -> None:
    """Show a reply.

    Args:
        head: the task, and what became of the answer.
        said: the reply itself; code stands in backticks.
        more: lines that go with it, smaller.
        kind: "passed", "wrong", or "said" where nothing was judged.
    """
    parts = PART.split(said)
    text = "\n".join([f"{head}:", *parts, *more] if parts[1:] else [f"{head}: {said}" if said else head, *more])
    _show(text, as_html(head, said, more, kind))


def show_caption(text: str) -> None:
    """Show what is said of the picture above."""
    _show(text, f'<small class="tflab-caption">{html.escape(text)}</small>')


def show_page(page: Any) -> None:
    """Show a page that has both HTML and a `text`."""
    if not in_notebook():
        print(page.text)
        return
    from IPython.display import display

    display(page)


def _show(text: str, markup: str) -> None:
    if not in_notebook():
        print(text)
        return
    from IPython.display import display

    display({"text/plain": text, "text/html": markup}, raw=True)


def as_html(head: str, said: str, more: Sequence[str], kind: str) -> str:
    """Return the card; whatever an answer held is text in it, and nothing else."""
    lines = [f"<strong>{html.escape(head)}</strong>"]
    if said:
        lines += [_as_markup(capitalized(part)) for part in PART.split(said)]
    lines += [f"<small>{_as_markup(CALL.sub(_in_backticks, line))}</small>" for line in more]
    return f'<div class="tflab-reply" style="{CARD.format(colour=COLOURS[kind])}">{"<br>".join(lines)}</div>'


def _in_backticks(call: re.Match) -> str:
    return call[0] if "`" in call[0] else f"`{call[0]}`"


def _as_markup(text: str) -> str:
    pieces = CODE.split(html.escape(text, quote=False))  # text, code, text, ...
    pieces[::2] = [STRESSED.sub(r"<em>\1</em>", piece).replace("\n", "<br>") for piece in pieces[::2]]
    pieces[1::2] = [f"<code>{piece}</code>" for piece in pieces[1::2]]
    return "".join(pieces)


def in_notebook() -> bool:
    """Return whether what is displayed is shown as HTML: in a kernel, not in a terminal or a test."""
    return getattr(shell(), "kernel", None) is not None


def shell() -> Any:
    """Return the IPython shell that runs this code, or None in plain Python, where IPython need not be installed."""
    return sys.modules["IPython"].get_ipython() if sys.modules.get("IPython") else None
